// A TOML text in pieces that keep the parts that a tree loses: comments, blank lines, and the form of values.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::toml {

/// A key with its value.
struct Pair {
  std::vector<std::string> before;  // comments in the lines above it
  std::string key;                  // "links.rod.mass", without spaces around its dots
  std::string value;                // as written, over several lines perhaps
  std::string comment;              // behind it, with its #; empty if there is none
};

/// Pairs without a blank line between them.
struct Group {
  std::vector<std::string> lead;  // detached comments above, with "" for a blank line between them
  std::vector<Pair> pairs;
};

/// A table: its header and its content.
struct Section {
  std::vector<std::string> before;  // comments right above the header
  std::string header;               // "[shaft]", "[[shaft.loads]]"; empty for content before the first
  std::string name;                 // "shaft.loads"
  std::string comment;
  std::vector<Group> groups;
  std::vector<std::string> tail;  // detached comments at its end
};

struct Pieces {
  std::vector<std::string> preamble;  // comments at the top of the file
  bool apart = false;                 // a blank line follows them
  std::vector<Section> sections;
};

/// The pieces of a valid TOML text.
Pieces pieces_of(std::string_view text);

/// The first part of a key or of a table's name: "links" of "links.rod.mass".
std::string first_part(std::string_view key);

/// The position after the text in quotes that starts at `at`, in valid TOML.
std::size_t behind_text(std::string_view text, std::size_t at);

}  // namespace loadpath::toml
