// Files that are built into the program, so that it runs from anywhere.
#pragma once

#include <span>
#include <string_view>

namespace loadpath::embedded {

struct File {
  std::string_view name;  // relative to its folder: "materials/steel.toml"
  std::string_view text;
};

std::span<const File> tables();     // tables/
std::span<const File> assets();     // lib/report/assets/
std::span<const File> reference();  // reference/ and examples/: the verification manual
std::span<const File> shells();     // cli/shell: scripts of completion
std::span<const File> schema();     // of project files, one: cli/written writes it
std::span<const File> live();       // cli/watch: the script of a page that is kept up to date

/// The text of an existing file of assets().
std::string_view asset(std::string_view name);

}  // namespace loadpath::embedded
