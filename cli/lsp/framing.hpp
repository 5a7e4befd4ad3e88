// Messages between an editor and the server: JSON after a header with its length.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace loadpath::cli::lsp {

/// The editor's messages on standard input.
class Input {
 public:
  /// The body of the next message: empty if the length in its header is missing or too large; nothing at the end.
  std::optional<std::string> next();
  /// Whether something can be read without waiting for it.
  [[nodiscard]] bool has_more() const;

 private:
  bool read_more();
  bool has_line(std::size_t& end) const;

  std::string bytes_;
  std::size_t at_ = 0;
};

/// Writes a message to standard output; false if the reader is gone.
bool send(std::string_view body);

}  // namespace loadpath::cli::lsp
