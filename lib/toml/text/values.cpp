#include "lib/toml/text/values.hpp"

#include "lib/toml/text/pieces.hpp"

#include <algorithm>

namespace loadpath::toml {

namespace {

struct Token {
  enum class Kind { open, close, comma, equals, text, bare, comment, line, end };
  Kind kind = Kind::end;
  std::string text;
  bool glued = false;  // to the token before
};
using Kind = Token::Kind;

Kind kind_of(char c) {
  switch (c) {
    case '[':
    case '{':
      return Kind::open;
    case ']':
    case '}':
      return Kind::close;
    case ',':
      return Kind::comma;
    case '=':
      return Kind::equals;
    case '"':
    case '\'':
      return Kind::text;
    case '#':
      return Kind::comment;
    case '\n':
      return Kind::line;
    default:
      return Kind::bare;
  }
}

std::size_t behind(std::string_view value, std::size_t at, Kind kind) {
  if (kind == Kind::text) return behind_text(value, at);
  if (kind == Kind::comment) return std::min(value.find('\n', at), value.size());
  if (kind == Kind::bare) return std::min(value.find_first_of("[]{},=\"'#\n \t\r", at), value.size());
  return at + 1;
}

std::vector<Token> tokens_of(std::string_view value) {
  std::vector<Token> tokens;
  bool glued = false;
  for (std::size_t at = 0; at < value.size();) {
    if (value[at] == ' ' || value[at] == '\t' || value[at] == '\r') {
      glued = false;
      ++at;
      continue;
    }
    const Kind kind = kind_of(value[at]);
    const std::size_t end = behind(value, at, kind);
    std::string text(value.substr(at, end - at));
    while (kind == Kind::comment && (text.back() == ' ' || text.back() == '\r' || text.back() == '\t')) text.pop_back();
    tokens.push_back({kind, std::move(text), glued});
    glued = true;
    at = end;
  }
  tokens.push_back({});
  return tokens;
}

bool is_plain(const std::string& text) {
  return text.size() >= 2 && text.find_first_of("\\\n") == std::string::npos && !text.starts_with("\"\"\"") &&
         !text.starts_with("'''") && text.find(text[0], 1) == text.size() - 1;
}

/// Writes the tokens of one value.
class Printer {
 public:
  Printer(std::string_view value, const Rewrite& rewrite) : tokens_(tokens_of(value)), rewrite_(rewrite) {}

  std::string print() {
    for (at_ = 0; tokens_[at_].kind != Kind::end; ++at_) put(tokens_[at_]);
    return std::move(out_);
  }

 private:
  [[nodiscard]] const Token& next() const { return tokens_[at_ + 1]; }
  [[nodiscard]] Kind before() const { return at_ == 0 ? Kind::open : tokens_[at_ - 1].kind; }
  [[nodiscard]] bool starts_line() const { return at_ > 0 && before() == Kind::line; }

  void put(const Token& token) {
    switch (token.kind) {
      case Kind::line:
        return put_line();
      case Kind::open:
        space();
        levels_.push_back({token.text[0], keys_.size()});
        out_ += token.text;
        return;
      case Kind::close:
        if (token.text == "}" && !starts_line() && before() != Kind::open) out_ += ' ';
        keys_.resize(levels_.back().keys);
        levels_.pop_back();
        out_ += token.text;
        return;
      case Kind::comma:
        if (!levels_.empty()) keys_.resize(levels_.back().keys);
        out_ += ',';
        return;
      case Kind::equals:
        out_ += " =";
        return;
      case Kind::comment:
        if (!starts_line()) out_ += "  ";
        out_ += token.text;
        return;
      default:
        space();
        out_ += is_key() ? key(token.text) : token.kind == Kind::text ? text(token.text) : token.text;
    }
  }

  /// Before a value or a key: none at the start of a line or a list, nor within a key.
  void space() {
    if (at_ == 0 || starts_line()) return;
    if (before() == Kind::open) {
      if (tokens_[at_ - 1].text == "{") out_ += ' ';
      return;
    }
    const bool within_key = (before() == Kind::bare || before() == Kind::text);
    if (!within_key || !(tokens_[at_].glued || out_.ends_with('.') || tokens_[at_].text.starts_with('.'))) out_ += ' ';
    if (within_key && out_.ends_with(". ")) out_.pop_back();
  }

  /// The next line, indented; a second blank one is left out.
  void put_line() {
    const bool third = at_ > 1 && starts_line() && tokens_[at_ - 2].kind == Kind::line;
    if (!third) out_ += '\n';
    if (next().kind == Kind::line) return;
    const std::size_t depth = levels_.size() - (next().kind == Kind::close ? 1 : 0);
    out_ += std::string(2 * depth, ' ');
  }

  [[nodiscard]] bool is_key() const {
    if (levels_.empty() || levels_.back().bracket != '{') return false;
    for (std::size_t i = at_ + 1; i < tokens_.size(); ++i) {
      if (tokens_[i].kind != Kind::bare && tokens_[i].kind != Kind::text) return tokens_[i].kind == Kind::equals;
    }
    return false;
  }

  std::string key(const std::string& text) {
    for (std::size_t from = 0; from <= text.size();) {
      const std::size_t to =
          text[0] == '"' || text[0] == '\'' ? text.size() : std::min(text.find('.', from), text.size());
      if (to > from) keys_.push_back(text.substr(from, to - from));
      from = to + 1;
    }
    return text;
  }

  [[nodiscard]] std::string text(const std::string& written) const {
    if (!is_plain(written)) return written;
    const std::string inner = written.substr(1, written.size() - 2);
    if (inner.find('"') != std::string::npos) return written;
    return "\"" + rewrite_(keys_, inner) + "\"";
  }

  struct Level {
    char bracket;
    std::size_t keys;  // keys that lead to it
  };
  std::vector<Token> tokens_;
  const Rewrite& rewrite_;
  std::size_t at_ = 0;
  std::vector<Level> levels_;
  std::vector<std::string> keys_;
  std::string out_;
};

}  // namespace

std::string laid_out(std::string_view value, const Rewrite& rewrite) { return Printer(value, rewrite).print(); }

}  // namespace loadpath::toml
