// The content of a project file before interpretation: tables, arrays and values with their places.
#pragma once

#include "lib/text/issue.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::toml {

struct Tree {
  enum class Type { table, array, text, number, boolean };
  struct Entry;

  Type type = Type::table;
  Place place;       // place of the value; for text: of its first character inside the quotes
  std::string text;  // the text; number and boolean as written
  double number = 0.0;
  std::string shared;          // "values.n", if its text was inserted here
  std::vector<Tree> items;     // array
  std::vector<Entry> entries;  // table, in the order of the file

  [[nodiscard]] const Entry* find(std::string_view key) const;
};

struct Tree::Entry {
  std::string key;
  Place place;  // place of the key
  Tree value;
};

/// The type of a value, in words: "a table", "a text".
std::string_view word_for(Tree::Type type);

/// The tree of a TOML text. Violations of the format become issues, and the tree is empty then.
Tree read_toml(std::string_view text, const std::string& file, std::vector<Issue>& issues);

/// The entire content of a file, or nothing; "-" is standard input.
bool read_file(const std::string& path, std::string& text);

}  // namespace loadpath::toml
