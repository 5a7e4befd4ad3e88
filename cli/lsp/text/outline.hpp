// The outline of a project file, also while it is being typed: headers, keys, values with their places. The reader of
// TOML (lib/toml) returns nothing for a text with a fault; this one continues after it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::cli::lsp {

/// "shaft", "seats", "[0]", "load": names of tables and keys, and numbers of elements from 0.
using Path = std::vector<std::string>;

/// [shaft], [press.links.rod], [[expect]].
struct Header {
  Path path;
  std::size_t begin = 0, end = 0;  // with its brackets
  bool closed = false;
};

/// A value other than a table or a list, with its key.
struct Item {
  Path path;
  std::size_t key_begin = 0, key_end = 0;  // the same: an element of a list
  std::size_t begin = 0, end = 0;          // texts: inside the quotes
  bool is_text = false;

  [[nodiscard]] std::string_view in(std::string_view text) const { return text.substr(begin, end - begin); }
};

struct Outline {
  std::vector<Header> headers;
  std::vector<Item> items;

  /// The value whose key, text or quotes are at the offset; null if none is.
  [[nodiscard]] const Item* at(std::size_t offset) const;
  [[nodiscard]] const Item* find(const Path& path) const;
  [[nodiscard]] const Header* header_at(std::size_t offset) const;
  /// The header of a step: the first one that begins with its name.
  [[nodiscard]] const Header* find_header(std::string_view name) const;
};

Outline outline_of(std::string_view text);

/// The position of a cursor at the end of a text.
struct Spot {
  enum class In { key, header, text, value, comment, nothing };
  In in = In::nothing;
  Path path;              // for a key its table's path; for a value its own; none for a header
  std::size_t begin = 0;  // the word being typed: last part of a key, text after its quote, bare value
};
Spot spot_at(std::string_view text, std::size_t offset);

/// The keys that a table has: of a step, of a table within one.
std::vector<std::string> keys_in(const Outline& outline, const Path& table);

}  // namespace loadpath::cli::lsp
