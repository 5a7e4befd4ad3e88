// Two steps that each search for a row, and take values of the row of the other one: the two tapered roller bearings of
// a shaft, whose axial loads depend on the factor Y of both.
#pragma once

#include "lib/project/project.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace loadpath::project {

struct RowPair {
  std::size_t a, b;                     // steps
  std::vector<std::string> of_a, of_b;  // inputs filled by its row that the other one takes, within the step: "Y"
};

/// The pairs of a project; a step is in one of them at most.
std::vector<RowPair> row_pairs(const Project& project);

}  // namespace loadpath::project
