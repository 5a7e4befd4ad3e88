#include "lib/report/html/compact.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace loadpath::report {
namespace {

using View = std::string_view;

template <std::size_t n>
bool is_one_of(View word, const std::array<View, n>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// "td" of "<td class=...", "/td" of "</td>"; empty if the text does not begin with a tag.
View name_of_tag(View text) {
  if (!text.starts_with('<')) return {};
  std::size_t end = 1;
  while (end < text.size() && text[end] != '>' && text[end] != ' ' && text[end] != '\n') ++end;
  return text.substr(1, end - 1);
}

/// Whether the parser ends the element without this tag, since what follows cannot be in it. Cells, rows and items are
/// followed only by their like or the end of their parent.
bool is_implied(View tag, View following) {
  constexpr std::array<View, 14> end_a_paragraph{"p",   "div",      "/div",    "section", "/section", "figure", "h2",
                                                 "pre", "/details", "details", "h3",      "ul",       "li",     "/li"};
  return tag == "/p" ? is_one_of(name_of_tag(following), end_a_paragraph) : following.starts_with('<');
}

/// Whether such a tag may be left out at all: most end formulas, subscripts and the like.
bool may_be_implied(View tag) {
  constexpr std::array<View, 9> all{"/td", "/p", "/li", "/tr", "/th", "/dt", "/dd", "/thead", "/tbody"};
  const bool may_be = tag.size() > 1 && (tag[1] == 't' || tag[1] == 'p' || tag[1] == 'l' || tag[1] == 'd');
  return may_be && is_one_of(tag, all);
}

View without_blanks(View text) {
  std::size_t at = 0;
  while (at < text.size() && (text[at] == ' ' || ('\t' <= text[at] && text[at] <= '\r'))) ++at;
  return text.substr(at);
}

/// A value that needs no quotation marks before `next`: a solidus would become a part of it.
bool needs_no_quotes(View value, View next) {
  return !value.empty() && value.find_first_of(" \t\n\r\f\"'`=<>") == View::npos && !next.starts_with('/');
}

/// The end of an element whose content is not markup; 0 for other elements.
std::size_t end_of_verbatim(View page, View name) {
  constexpr std::array<View, 3> verbatim{"script", "style", "pre"};
  if (name.size() < 3 || (name[0] != 's' && name[0] != 'p') || !is_one_of(name, verbatim)) return 0;
  const std::size_t end = page.find("</" + std::string(name) + ">");
  return end == View::npos ? page.size() : end;
}

/// Copies a page but for what is left out; what is kept in between is copied in one piece.
class Shortening {
 public:
  explicit Shortening(View page) : page_(page) { out_.reserve(page.size()); }

  std::string whole() {
    for (std::size_t at = page_.find('<'); at != View::npos; at = page_.find('<', at)) {
      const std::size_t end = page_.find('>', at);
      if (end == View::npos) break;
      at = page_[at + 1] == '/' ? end_tag(at, end + 1) : start_tag(at, end + 1);
    }
    leave_out(page_.size(), page_.size());
    return std::move(out_);
  }

 private:
  void leave_out(std::size_t begin, std::size_t end) {
    out_.append(page_, copied_, begin - copied_);
    copied_ = end;
  }
  std::size_t end_tag(std::size_t begin, std::size_t end) {
    const View name = page_.substr(begin + 1, end - begin - 2);
    if (!may_be_implied(name)) return end;
    const View following = without_blanks(page_.substr(end));
    if (!is_implied(name, following)) return end;
    leave_out(begin, page_.size() - following.size());
    return copied_;
  }
  /// The place behind a start tag, of verbatim content behind that.
  std::size_t start_tag(std::size_t begin, std::size_t end) {
    const View tag = page_.substr(begin, end - begin), name = name_of_tag(tag);
    if (begin + 1 + name.size() + 1 < end) attributes(begin, end);
    const std::size_t verbatim = end_of_verbatim(page_.substr(begin), name);
    return verbatim == 0 ? end : begin + verbatim;
  }
  /// Classes without a name and the name space of SVG, which a page has anyway, are left out, and quotation marks.
  void attributes(std::size_t begin, std::size_t end) {
    const View tag = page_.substr(0, end);
    while (true) {
      const std::size_t equal = tag.find("=\"", begin);
      const std::size_t close = equal == View::npos ? View::npos : tag.find('"', equal + 2);
      if (close == View::npos) return;
      const std::size_t space = tag.rfind(' ', equal);
      const View name = tag.substr(space + 1, equal - space - 1), value = tag.substr(equal + 2, close - equal - 2);
      begin = close + 1;
      if ((name == "class" && value.empty()) || name == "xmlns") {
        leave_out(space, begin);
      } else if (needs_no_quotes(value, tag.substr(begin))) {
        leave_out(equal + 1, equal + 2);
        leave_out(close, begin);
      }
    }
  }

  View page_;
  std::string out_;
  std::size_t copied_ = 0;
};

}  // namespace

std::string compact(std::string_view page) { return Shortening(page).whole(); }

}  // namespace loadpath::report
