// A law as the corners of a polyline close to it: between two corners it deviates beyond their values by no more than
// the tolerance. No peak between them is missed, because intervals bound the law there
// (lib/quantity/expression/interval.hpp).
#pragma once

#include "lib/quantity/expression/law.hpp"

#include <utility>
#include <vector>

namespace loadpath {

struct Resolved {
  std::vector<std::pair<double, double>> corners;  // places, rising, the first and the last of them the ends; values
  bool complete = true;  // false: a pole, a place outside of its domain, or more waves than can be followed
};

/// The quantity to be resolved.
enum class Followed { value, second };

/// `tolerance`: by how much it may go beyond, of its largest magnitude.
Resolved resolve(const Law& law, double from, double to, double tolerance, Followed what = Followed::value);

}  // namespace loadpath
