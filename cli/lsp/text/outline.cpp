#include "cli/lsp/text/outline.hpp"

#include <algorithm>
#include <cctype>
#include <map>

namespace loadpath::cli::lsp {

namespace {

bool is_bare(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' ||
         static_cast<unsigned char>(c) >= 0x80;
}
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  void run() {
    while (at_ < text_.size()) {
      if (at_ == 0 || text_[at_ - 1] == '\n') recover();
      step();
    }
  }

  Outline outline;
  Spot spot;

 private:
  enum class Expect { key, equals, value, comma };
  struct Frame {
    char open = '\0';  // bracket of an inline table or a list; neither for the table of a header
    Path path;
    std::size_t count = 0;
  };

  void step() {
    const char c = text_[at_];
    if (c == '\n') return end_line();
    if (is_blank(c)) return blank();
    if (c == '#') return comment();
    if (expect_ == Expect::key) return key();
    if (expect_ == Expect::equals) return equals();
    if (expect_ == Expect::value) return value();
    comma();
  }

  void blank() {
    ++at_;
    if (expect_ == Expect::key) spot = {Spot::In::key, frame().path, at_};
    if (expect_ == Expect::value) spot = {Spot::In::value, value_path(), at_};
    if (expect_ == Expect::equals || expect_ == Expect::comma) spot = {};
  }

  void comment() {
    at_ = std::min(text_.find('\n', at_), text_.size());
    spot = {Spot::In::comment, {}, at_};
  }

  /// An inline table ends with its line.
  void end_line() {
    ++at_;
    while (frames_.back().open == '{') frames_.pop_back();
    if (frames_.back().open == '\0') {
      expect_ = Expect::key;
    } else if (expect_ != Expect::comma) {
      expect_ = Expect::value;
    }
    spot = expect_ == Expect::key ? Spot{Spot::In::key, frame().path, at_} : Spot{Spot::In::value, value_path(), at_};
  }

  /// An unclosed list ends where the next header or key begins.
  void recover() {
    if (frames_.size() > 1 && starts_anew()) {
      frames_.resize(1);
      expect_ = Expect::key;
    }
    if (frames_.size() == 1 && text_[at_] == '[') header();
  }

  [[nodiscard]] bool starts_anew() const {
    std::size_t i = at_;
    const bool bracket = text_[i] == '[';
    while (i < text_.size() && text_[i] == '[') ++i;
    if (i == text_.size() || (std::isalpha(static_cast<unsigned char>(text_[i])) == 0 && text_[i] != '_')) return false;
    while (i < text_.size() && (is_bare(text_[i]) || text_[i] == '.')) ++i;
    while (i < text_.size() && is_blank(text_[i])) ++i;
    return i < text_.size() && text_[i] == (bracket ? ']' : '=');
  }

  void header() {
    Header found;
    found.begin = at_;
    const bool of_list = text_.substr(at_).starts_with("[[");
    at_ += of_list ? 2 : 1;
    found.path = names();
    spot = {Spot::In::header, {}, found.begin};
    found.closed = at_ < text_.size() && text_[at_] == ']';
    while (at_ < text_.size() && text_[at_] == ']') ++at_;
    if (found.closed) spot = {};
    found.end = at_;
    if (of_list) found.path.push_back("[" + std::to_string(counts_[found.path]++) + "]");
    frames_.assign(1, Frame{'\0', found.path});
    outline.headers.push_back(std::move(found));
    rest_of_line();
  }

  void rest_of_line() {
    while (at_ < text_.size() && text_[at_] != '\n') {
      if (text_[at_] == '#') return comment();
      ++at_;
    }
  }

  /// Names with points between them; the last may be empty.
  Path names() {
    Path all(1);
    part_ = at_;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        const std::size_t begin = at_ + 1;
        quoted();
        all.back() = text_.substr(begin, content_end_ - begin);
      } else if (c == '.') {
        all.emplace_back();
        part_ = ++at_;
      } else if (is_bare(c)) {
        all.back() += c;
        ++at_;
      } else if (is_blank(c) && at_ + 1 < text_.size() && is_joined(c)) {
        ++at_;
      } else {
        break;
      }
    }
    return all;
  }

  /// Whether blanks are followed, or led, by a point.
  [[nodiscard]] bool is_joined(char) const {
    const std::size_t next = text_.find_first_not_of(" \t", at_);
    return next != std::string_view::npos && text_[next] == '.';
  }

  void key() {
    const char c = text_[at_];
    if (c == '}' || c == ',' || c == ']') return comma();
    key_begin_ = at_;
    if (!is_bare(c) && c != '"' && c != '\'') return skip();
    key_ = names();
    key_end_ = at_;
    Path path = frame().path;
    path.insert(path.end(), key_.begin(), key_.end() - 1);
    spot = {Spot::In::key, std::move(path), part_};
    expect_ = Expect::equals;
  }

  void skip() {
    ++at_;
    spot = {};
  }

  void equals() {
    const char c = text_[at_];
    if (c == '}' || c == ',' || c == ']') return comma();
    if (c != '=') return skip();
    ++at_;
    expect_ = Expect::value;
    spot = {Spot::In::value, value_path(), at_};
  }

  void value() {
    const char c = text_[at_];
    if (c == '{' || c == '[') return open(c);
    if (c == ']' || c == '}' || c == ',') return comma();
    const bool is_text = c == '"' || c == '\'';
    Item item{value_path(), key_begin_, key_end_, at_, at_, is_text};
    if (frame().open == '[') item.key_begin = item.key_end = at_;
    if (is_text) {
      quoted();
      item.begin = content_begin_;
      item.end = content_end_;
      spot = closed_ ? Spot{} : Spot{Spot::In::text, item.path, item.begin};
    } else {
      while (at_ < text_.size() && std::string_view(",]}#\n\r").find(text_[at_]) == std::string_view::npos) ++at_;
      item.end = at_;
      while (item.end > item.begin && is_blank(text_[item.end - 1])) --item.end;
      spot = {Spot::In::value, item.path, item.begin};
    }
    outline.items.push_back(std::move(item));
    expect_ = Expect::comma;
  }

  void open(char bracket) {
    constexpr std::size_t deepest = 256;  // unclosed brackets
    ++at_;
    if (frames_.size() > deepest) return;
    frames_.push_back({bracket, value_path()});
    expect_ = bracket == '{' ? Expect::key : Expect::value;
    spot = bracket == '{' ? Spot{Spot::In::key, frame().path, at_} : Spot{Spot::In::value, value_path(), at_};
  }

  /// Skips the comma after a value.
  void comma() {
    const char c = text_[at_++];
    spot = {};
    if (c == ',' && frame().open == '{') {
      expect_ = Expect::key;
      spot = {Spot::In::key, frame().path, at_};
    } else if (c == ',' && frame().open == '[') {
      ++frame().count;
      expect_ = Expect::value;
      spot = {Spot::In::value, value_path(), at_};
    } else if ((c == '}' && frame().open == '{') || (c == ']' && frame().open == '[')) {
      frames_.pop_back();
      expect_ = Expect::comma;
    }
  }

  /// A text in quotes, with them; one that is not closed ends with its line.
  void quoted() {
    const char quote = text_[at_];
    const bool is_long = text_.substr(at_, 3) == std::string(3, quote);
    const std::string closing(is_long ? 3 : 1, quote);
    content_begin_ = at_ += closing.size();
    while (at_ < text_.size()) {
      if (!is_long && text_[at_] == '\n') break;
      if (text_.substr(at_, closing.size()) == closing) {
        content_end_ = at_;
        at_ += closing.size();
        closed_ = true;
        return;
      }
      at_ += quote == '"' && text_[at_] == '\\' && at_ + 1 < text_.size() && text_[at_ + 1] != '\n' ? 2 : 1;
    }
    content_end_ = at_ = std::min(at_, text_.size());
    closed_ = false;
  }

  [[nodiscard]] Frame& frame() { return frames_.back(); }

  [[nodiscard]] Path value_path() {
    Path path = frame().path;
    if (frame().open == '[')
      path.push_back("[" + std::to_string(frame().count) + "]");
    else
      path.insert(path.end(), key_.begin(), key_.end());
    return path;
  }

  std::string_view text_;
  std::size_t at_ = 0, part_ = 0, key_begin_ = 0, key_end_ = 0, content_begin_ = 0, content_end_ = 0;
  bool closed_ = false;
  Expect expect_ = Expect::key;
  Path key_;
  std::vector<Frame> frames_{Frame{}};
  std::map<Path, std::size_t> counts_;  // elements of [[lists]]
};

}  // namespace

const Item* Outline::at(std::size_t offset) const {
  for (const Item& item : items) {
    const std::size_t margin = item.is_text ? 1 : 0;  // its quotes
    const bool on_key = item.key_begin <= offset && offset <= item.key_end && item.key_begin != item.key_end;
    if (on_key || (item.begin - margin <= offset && offset <= item.end)) return &item;
  }
  return nullptr;
}

const Item* Outline::find(const Path& path) const {
  const auto found = std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.path == path; });
  return found == items.end() ? nullptr : &*found;
}

const Header* Outline::header_at(std::size_t offset) const {
  const auto found = std::find_if(headers.begin(), headers.end(),
                                  [&](const Header& h) { return h.begin <= offset && offset < h.end; });
  return found == headers.end() ? nullptr : &*found;
}

const Header* Outline::find_header(std::string_view name) const {
  const auto found = std::find_if(headers.begin(), headers.end(), [&](const Header& h) { return h.path[0] == name; });
  return found == headers.end() ? nullptr : &*found;
}

Outline outline_of(std::string_view text) {
  Scanner scanner(text);
  scanner.run();
  return std::move(scanner.outline);
}

Spot spot_at(std::string_view text, std::size_t offset) {
  Scanner scanner(text.substr(0, offset));
  scanner.spot = {Spot::In::key, {}, 0};
  scanner.run();
  return std::move(scanner.spot);
}

std::vector<std::string> keys_in(const Outline& outline, const Path& table) {
  std::vector<std::string> keys;
  const auto add = [&](const Path& path) {
    if (path.size() > table.size() && std::equal(table.begin(), table.end(), path.begin()) &&
        std::find(keys.begin(), keys.end(), path[table.size()]) == keys.end())
      keys.push_back(path[table.size()]);
  };
  for (const Item& item : outline.items) add(item.path);
  for (const Header& header : outline.headers) add(header.path);
  return keys;
}

}  // namespace loadpath::cli::lsp
