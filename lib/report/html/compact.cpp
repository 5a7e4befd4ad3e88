#include "lib/report/html/compact.hpp"

#include "lib/report/html/used_rules.hpp"

#include <algorithm>
#include <array>

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
  constexpr std::array<View, 8> always{"/td", "/th", "/tr", "/thead", "/tbody", "/li", "/dt", "/dd"};
  constexpr std::array<View, 14> end_a_paragraph{"p",   "div",      "/div",    "section", "/section", "figure", "h2",
                                                 "pre", "/details", "details", "h3",      "ul",       "li",     "/li"};
  const View next = name_of_tag(following);
  if (next.empty()) return false;
  return tag == "/p" ? is_one_of(next, end_a_paragraph) : is_one_of(tag, always);
}

/// Whether such a tag may be left out at all: most end formulas, subscripts and the like.
bool may_be_implied(View tag) {
  return tag.size() > 1 && (tag[1] == 't' || tag[1] == 'p' || tag[1] == 'l' || tag[1] == 'd');
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

/// A start tag; classes without a name and the name space of SVG, which a page has anyway, are left out.
void append_start(std::string& out, View tag) {
  while (tag.find('=') != View::npos) {
    const std::size_t equal = tag.find("=\"");
    const std::size_t end = equal == View::npos ? View::npos : tag.find('"', equal + 2);
    if (end == View::npos) break;
    const View before = tag.substr(0, equal), value = tag.substr(equal + 2, end - equal - 2);
    const View name = before.substr(before.rfind(' ') + 1);
    tag.remove_prefix(end + 1);
    if ((name == "class" && value.empty()) || name == "xmlns") {
      out += before.substr(0, before.size() - name.size() - 1);
    } else {
      const View mark = needs_no_quotes(value, tag) ? "" : "\"";
      out.append(before).append("=").append(mark).append(value).append(mark);
    }
  }
  out += tag;
}

/// The end of an element whose content is not markup; 0 for other elements.
std::size_t end_of_verbatim(View page, View name) {
  constexpr std::array<View, 3> verbatim{"script", "style", "pre"};
  if (name.size() < 3 || !is_one_of(name, verbatim)) return 0;
  const std::size_t end = page.find("</" + std::string(name) + ">");
  return end == View::npos ? page.size() : end;
}

}  // namespace

std::string compact(std::string_view page) {
  const View whole = page;
  std::string out;
  out.reserve(page.size());
  while (!page.empty()) {
    const std::size_t begin = std::min(page.find('<'), page.size());
    out += page.substr(0, begin);
    page.remove_prefix(begin);
    const std::size_t size = page.find('>');
    if (size == View::npos) return out.append(page);
    const View name = name_of_tag(page), tag = page.substr(0, size + 1);
    if (name.starts_with('/')) {
      page.remove_prefix(size + 1);
      const View following = may_be_implied(name) ? without_blanks(page) : View();
      if (is_implied(name, following))
        page = following;
      else
        out += tag;
      continue;
    }
    const std::size_t verbatim = end_of_verbatim(page, name);
    append_start(out, tag);
    if (verbatim > 0) {
      const View content = page.substr(size + 1, verbatim - size - 1);
      out += name == "style" ? used_rules(content, whole) : std::string(content);
    }
    page.remove_prefix(verbatim > 0 ? verbatim : size + 1);
  }
  return out;
}

}  // namespace loadpath::report
