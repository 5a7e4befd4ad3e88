#include "lib/text/utf8.hpp"
#include "lib/toml/ascii.hpp"
#include "lib/toml/gate.hpp"
#include "lib/toml/hints.hpp"
#include "lib/toml/tree.hpp"

// toml++ 3.3 asserts conditions that a text may violate, e.g. that a name follows the bracket of a table, and checks
// them in the next line. So its assertions are disabled: they neither stop a debug build, nor does clang optimise a
// release by them.
#undef NDEBUG
#define TOML_ASSERT(claim) static_cast<void>(0)
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>

namespace loadpath::toml {

namespace {

/// Results of the parser, with the letters and places of the file.
class Conversion {
 public:
  Conversion(const Ascii& ascii, const std::string& file) : ascii_(ascii), file_(file) {}

  [[nodiscard]] Place place_of(const ::toml::source_region& source) const {
    const int begin = column_of(source.begin);
    const int length = source.end.line == source.begin.line ? column_of(source.end) - begin : 1;
    return {file_, static_cast<int>(source.begin.line), begin, std::max(1, length)};
  }

  [[nodiscard]] Tree table(const ::toml::table& table) const {
    Tree tree;
    for (const auto& [key, value] : table)
      tree.entries.push_back({ascii_.original(key.str()), place_of(key.source()), node(value)});
    std::stable_sort(tree.entries.begin(), tree.entries.end(), [](const Tree::Entry& a, const Tree::Entry& b) {
      return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
    return tree;
  }

 private:
  [[nodiscard]] int column_of(const ::toml::source_position& position) const {
    return ascii_.column(static_cast<int>(position.line), static_cast<int>(position.column));
  }

  [[nodiscard]] Tree array(const ::toml::array& array) const {
    Tree tree;
    tree.type = Tree::Type::array;
    for (const ::toml::node& item : array) tree.items.push_back(node(item));
    return tree;
  }

  [[nodiscard]] Tree value(const ::toml::node& node) const {
    Tree tree;
    if (const auto* text = node.as_string()) {
      tree.type = Tree::Type::text;
      tree.text = ascii_.original(text->get());
    } else if (const auto* flag = node.as_boolean()) {
      tree.type = Tree::Type::boolean;
      tree.text = flag->get() ? "true" : "false";
    } else if (const std::optional<double> number = node.value<double>()) {
      tree.type = Tree::Type::number;
      tree.number = *number;
    } else {  // a date or a time: no field takes one
      tree.type = Tree::Type::boolean;
      tree.text = "a date";
    }
    return tree;
  }

  [[nodiscard]] Tree node(const ::toml::node& node) const {
    Tree tree;
    if (const auto* inner = node.as_table()) {
      tree = table(*inner);
    } else if (const auto* items = node.as_array()) {
      tree = array(*items);
    } else {
      tree = value(node);
    }
    tree.place = place_of(node.source());
    if (tree.type == Tree::Type::text) {  // the caret points inside the quotes
      ++tree.place.column;
      tree.place.length = std::max(1, tree.place.length - 2);
    }
    return tree;
  }

  const Ascii& ascii_;
  const std::string& file_;
};

/// The quote of a text that is still open where the line ends; nothing if none is, or the text may have several
/// lines.
std::optional<char> open_quote(std::string_view line) {
  if (line.find("\"\"\"") != std::string_view::npos || line.find("'''") != std::string_view::npos) return {};
  std::optional<char> open;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (open == '"' && line[i] == '\\') {
      ++i;
    } else if (open) {
      if (line[i] == *open) open.reset();
    } else if (line[i] == '#') {
      break;
    } else if (line[i] == '"' || line[i] == '\'') {
      open = line[i];
    }
  }
  return open;
}

/// Whether a backslash is at a column, or before it, and a letter outside ASCII after the backslash.
bool is_escaped_foreign(std::string_view line, int column) {
  const std::u32string letters = code_points(line);
  constexpr char32_t first_foreign = 0x80;
  for (const int at : {column - 1, column - 2}) {  // from 0
    const auto i = static_cast<std::size_t>(at);
    if (at >= 0 && i + 1 < letters.size() && letters[i] == U'\\' && letters[i + 1] >= first_foreign) return true;
  }
  return false;
}

/// "Error while parsing key-value pair: expected ..." without the part that the place shows already.
std::string_view what_of(std::string_view description) {
  const std::size_t colon = description.find(": ");
  return description.starts_with("Error while parsing") && colon != std::string_view::npos
             ? description.substr(colon + 2)
             : description;
}

/// The key or the table that is given twice: "left" of "cannot redefine existing table 'left'"; empty for other faults.
std::string redefined(std::string_view what) {
  const std::size_t from = what.find('\'') + 1, to = what.rfind('\'');
  return what.starts_with("cannot redefine existing ") && from < to ? std::string(what.substr(from, to - from)) : "";
}

std::string_view line_of(std::string_view text, int line) {
  for (int i = 1; i < line; ++i) text.remove_prefix(std::min(text.find('\n') + 1, text.size()));
  text = text.substr(0, text.find('\n'));
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

/// A text or a key with control characters written as escapes would reach terminals and reports.
void refuse_controls(const Tree& tree, std::vector<Issue>& issues) {
  const auto refuse = [&](std::string_view text, const Place& place) {
    if (first_control(text, "\t\n") != std::string_view::npos)
      issues.push_back({place, "", say("a control character in a text"), say("remove it"), Severity::error});
  };
  if (tree.type == Tree::Type::text) refuse(tree.text, tree.place);
  for (const Tree& item : tree.items) refuse_controls(item, issues);
  for (const Tree::Entry& entry : tree.entries) {
    refuse(entry.key, entry.place);
    refuse_controls(entry.value, issues);
  }
}

}  // namespace

Tree read_toml(std::string_view text, const std::string& file, std::vector<Issue>& issues) {
  if (const auto refused = refuse_text(text, file)) {
    issues.push_back(*refused);
    return {};
  }
  if (auto refused = refuse_bare(text, file)) {
    if (refused->hint.empty()) refused->hint = hint_for(line_of(text, refused->place.line), 0);
    issues.push_back(std::move(*refused));
    return {};
  }
  const Ascii ascii(text);
  const Conversion conversion(ascii, file);
  try {
    Tree tree = conversion.table(::toml::parse(ascii.text(), file));
    tree.place = {file, 1, 1, 1};
    const std::size_t before = issues.size();
    refuse_controls(tree, issues);
    return issues.size() == before ? tree : Tree{};
  } catch (const ::toml::parse_error& error) {
    const Place place = conversion.place_of(error.source());
    const std::string_view line = line_of(text, place.line);
    const auto open = open_quote(line);
    if (open && static_cast<std::size_t>(place.column) > code_points(line).size()) {
      issues.push_back({place, "", say("the text is not closed"), say("add {1} where it ends", std::string(1, *open)),
                        Severity::error});
      return {};
    }
    if (is_escaped_foreign(line, place.column)) {
      issues.push_back({place, "", say("not valid TOML: a backslash before a letter outside ASCII"),
                        say("write a backslash twice"), Severity::error});
      return {};
    }
    const std::string what = ascii.original(what_of(error.description()));
    if (const std::string twice = redefined(what); !twice.empty()) {
      issues.push_back(
          {place, "", say("'{1}' is given twice", twice), say("rename or remove one of them"), Severity::error});
      return {};
    }
    const bool is_word = what.find("determine value type") != std::string::npos;
    Message hint = hint_for_brackets(what, line);
    if (hint.empty()) hint = hint_for(line, is_word ? place.column : 0);
    issues.push_back({place, "", say("not valid TOML: {1}", what), std::move(hint), Severity::error});
    return {};
  }
}

std::string_view word_for(Tree::Type type) {
  switch (type) {
    case Tree::Type::table:
      return "a table";
    case Tree::Type::array:
      return "an array";
    case Tree::Type::text:
      return "a text";
    case Tree::Type::number:
      return "a number";
    case Tree::Type::boolean:
      return "true, false or a date";
  }
  return "";
}

const Tree::Entry* Tree::find(std::string_view key) const {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

/// Reads an endless stream only up to the size that is refused.
static void read_whole(std::istream& stream, std::string& text) {
  std::array<char, 1U << 14U> part{};
  while (stream && text.size() <= largest_file) {
    stream.read(part.data(), part.size());
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  }
}

bool read_file(const std::string& path, std::string& text) {
  if (path == "-") {
    read_whole(std::cin, text);
    return true;
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path)) return false;
  read_whole(stream, text);
  return !stream.bad();
}

}  // namespace loadpath::toml
