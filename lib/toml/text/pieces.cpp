#include "lib/toml/text/pieces.hpp"

#include <algorithm>

namespace loadpath::toml {

namespace {

std::string trimmed(std::string_view text) {
  const std::size_t from = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  return std::string(text.substr(from, last == std::string_view::npos ? 0 : last + 1 - from));
}

/// Cuts a text from its beginning to its end.
class Cutter {
 public:
  explicit Cutter(std::string_view text) : text_(text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
  }

  Pieces cut() {
    while (skip_spaces(), at_ < text_.size()) {
      if (text_[at_] == '\n') {
        ++at_;
        if (!pending_.empty() || !pieces_.sections.empty()) pending_.emplace_back();
      } else if (text_[at_] == '#') {
        pending_.push_back(comment());
      } else if (text_[at_] == '[') {
        add_header();
      } else {
        add_pair();
      }
    }
    strip(pending_);
    auto& rest = pieces_.sections.empty() ? pieces_.preamble : pieces_.sections.back().tail;
    rest.insert(rest.end(), pending_.begin(), pending_.end());
    return std::move(pieces_);
  }

 private:
  using Lines = std::vector<std::string>;

  void skip_spaces() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r')) ++at_;
  }

  /// To the end of the line.
  std::string comment() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string text = trimmed(text_.substr(at_, end - at_));
    at_ = std::min(end + 1, text_.size());
    return text;
  }
  /// The rest of the line after a value or a header.
  std::string rest_of_line() {
    skip_spaces();
    return comment();
  }

  /// Without blank lines at both ends, and with at most one between comments.
  static void strip(Lines& lines) {
    while (!lines.empty() && lines.front().empty()) lines.erase(lines.begin());
    while (!lines.empty() && lines.back().empty()) lines.pop_back();
    lines.erase(std::unique(lines.begin(), lines.end(),
                            [](const std::string& a, const std::string& b) { return a.empty() && b.empty(); }),
                lines.end());
  }

  /// Takes the comments right above the next piece off the pending lines.
  Lines take_adjoining() {
    const auto apart = std::find_if(pending_.rbegin(), pending_.rend(), [](const auto& line) { return line.empty(); });
    Lines adjoining(apart.base(), pending_.end());
    pending_.erase(apart.base(), pending_.end());
    return adjoining;
  }

  /// The comments at the top of the file; those right above the first table belong to it if others precede them.
  Lines take_preamble() {
    Lines adjoining = take_adjoining();
    const bool others = std::any_of(pending_.begin(), pending_.end(), [](const auto& line) { return !line.empty(); });
    pieces_.apart = others || (adjoining.empty() && !pending_.empty());
    if (!others) std::swap(adjoining, pieces_.preamble);
    if (others) pieces_.preamble = pending_;
    strip(pieces_.preamble);
    pending_.clear();
    return others ? adjoining : Lines{};
  }

  void add_header() {
    Section section;
    if (pieces_.sections.empty()) {
      section.before = take_preamble();
    } else {
      section.before = take_adjoining();
      strip(pending_);
      pieces_.sections.back().tail = std::move(pending_);
    }
    pending_.clear();
    const std::size_t brackets = text_.substr(at_).starts_with("[[") ? 2 : 1;
    at_ += brackets;
    section.name = key_until(']');
    at_ += brackets;
    section.header = std::string(brackets, '[') + section.name + std::string(brackets, ']');
    section.comment = rest_of_line();
    pieces_.sections.push_back(std::move(section));
  }

  void add_pair() {
    Pair pair;
    if (pieces_.sections.empty()) {
      pair.before = take_preamble();
      pieces_.sections.emplace_back();
    } else {
      pair.before = take_adjoining();
    }
    auto& groups = pieces_.sections.back().groups;
    if (groups.empty() || !pending_.empty()) groups.emplace_back();
    strip(pending_);
    if (!pending_.empty()) groups.back().lead = pending_;
    pending_.clear();
    pair.key = key_until('=');
    ++at_;
    pair.value = value();
    pair.comment = rest_of_line();
    groups.back().pairs.push_back(std::move(pair));
  }

  /// A key without spaces around its dots, up to a character that ends it.
  std::string key_until(char end) {
    std::string key;
    while (at_ < text_.size() && text_[at_] != end) {
      if (text_[at_] == '"' || text_[at_] == '\'') {
        const std::size_t behind = behind_text(text_, at_);
        key += text_.substr(at_, behind - at_);
        at_ = behind;
      } else if (const char c = text_[at_++]; c != ' ' && c != '\t') {
        key += c;
      }
    }
    return key;
  }

  /// Up to the end of its line or its comment, outside of quotes and brackets.
  std::string value() {
    const std::size_t from = at_;
    int depth = 0;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (depth == 0 && (c == '\n' || c == '#')) break;
      if (c == '"' || c == '\'') {
        at_ = behind_text(text_, at_);
        continue;
      }
      if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
        continue;
      }
      depth += (c == '[' || c == '{') - (c == ']' || c == '}');
      ++at_;
    }
    return trimmed(text_.substr(from, at_ - from));
  }

  std::string_view text_;
  std::size_t at_ = 0;
  Lines pending_;  // comments and blank lines above the next piece
  Pieces pieces_;
};

}  // namespace

std::size_t behind_text(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool is_long = text.substr(at, 3) == std::string(3, quote);
  const std::string_view closing = text.substr(at, is_long ? 3 : 1);
  std::size_t i = at + closing.size();
  while (i < text.size() && text.substr(i, closing.size()) != closing) i += quote == '"' && text[i] == '\\' ? 2 : 1;
  i = std::min(i + closing.size(), text.size());
  for (int more = 0; is_long && more < 2 && i < text.size() && text[i] == quote; ++more) ++i;
  return i;
}

std::string first_part(std::string_view key) {
  if (!key.empty() && (key[0] == '"' || key[0] == '\'')) {
    const std::size_t end = behind_text(key, 0);
    return std::string(key.substr(1, end - 2));
  }
  return std::string(key.substr(0, key.find('.')));
}

Pieces pieces_of(std::string_view text) { return Cutter(text).cut(); }

}  // namespace loadpath::toml
