// The progress of the sweep in a folder, read from its manifest, because a killed sweep cannot report it.
#pragma once

#include "lib/text/issue.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace loadpath::exports {

struct FolderStatus {
  std::string project;       // the name of its file
  std::uint64_t points = 0;  // points of the entire sweep
  std::uint64_t first = 0;   // first point of this folder
  std::uint64_t end = 0;     // one past its last point
  std::uint64_t solved = 0;  // points on the disk, from the first
  Message at_work;           // process that is writing to it; empty: none

  [[nodiscard]] bool is_done() const { return first + solved == end; }
  [[nodiscard]] bool is_share() const { return first != 0 || end != points; }
};

/// A Fault if no sweep is in the folder, or its manifest cannot be read.
Outcome<FolderStatus> status_of(const std::filesystem::path& folder);

std::string json_of(const FolderStatus& status);

}  // namespace loadpath::exports
