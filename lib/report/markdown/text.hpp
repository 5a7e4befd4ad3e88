// The parts of Markdown (GitHub's flavour) that the writer puts together.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::report::md {

/// Words on one line, escaped from markup.
std::string text(std::string_view words);
std::string code(std::string_view words);
std::string inline_math(std::string_view tex);

/// The address of a file in the same folder.
std::string address(std::string_view file_name);

/// Cells that are Markdown already; columns are padded, so that the source reads as a table too.
struct Grid {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::vector<bool> flush_right;
};
std::string table(const Grid& grid);

}  // namespace loadpath::report::md
