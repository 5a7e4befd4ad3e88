#include "calculators/mechanism/results/output.hpp"

namespace loadpath::planar {

bool is_drive_effort(std::string_view path) {
  return path == "drive.M" || (path.starts_with("cylinders.") && path.ends_with(".F"));
}

}  // namespace loadpath::planar
