// Whether sizes, area and second moments belong to one section: typed values, and rows of a project, in wrong units
// or of two sections, are inconsistent.
#pragma once

#include "lib/text/issue.hpp"

#include <limits>
#include <optional>
#include <string>

namespace loadpath::table {

/// SI; unknown values are NaN. The kind is a word of column.buckling, "rolled_I", "solid"; empty if it is not given.
struct SectionShape {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  double h = unknown, b = unknown, d = unknown, t_f = unknown, t_w = unknown;
  double A = unknown, I_y = unknown, I_z = unknown;
  std::string kind = {};
  double I_min = unknown, I_t = unknown, I_w = unknown, W_pl_y = unknown, W_pl_z = unknown;
};

struct Inconsistency {
  std::string key;  // key of the inconsistent value
  Message message;
};

/// The first value that no section of these sizes has.
std::optional<Inconsistency> inconsistency_of(const SectionShape& shape);

/// Whether a section of this area and these second moments has its area about its centre as full ones have: no walls
/// that could buckle, and hardly a twist.
bool is_full(double A, double I_y, double I_z);

}  // namespace loadpath::table
