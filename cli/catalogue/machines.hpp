// Machines by the names that designers type, with the calculators of their parts.
#pragma once

#include <span>

namespace loadpath::cli {

struct MachineWords {
  const char* words;  // names of the machine, separated by ", "
  const char* parts;  // ids of calculators, separated by ", "; the first leads into the design
};

/// The complete list.
std::span<const MachineWords> machines();

}  // namespace loadpath::cli
