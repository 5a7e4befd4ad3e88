#include "lib/beam/whirl.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::beam {

namespace {

/// A root found with a change of the count next to it; otherwise there is no convergence.
template <class Count>
double settled(std::size_t i, const Count& count, double near, double finest) {
  const double apart = std::max(1e-6, 10.0 * finest);
  const double found = numerics::counted_root(i, count, near, finest);
  const bool is_there = count((1.0 - apart) * found).below <= i && count((1.0 + apart) * found).below > i;
  return is_there ? found : std::numeric_limits<double>::quiet_NaN();
}

double sign(Sense sense) { return sense == Sense::forward ? 1.0 : -1.0; }

}  // namespace

Whirl::Whirl(const Beam& beam, const Row<Inertia>& inertias) : stiffness_(beam.stiffness()), inertias_(inertias) {
  for (std::size_t n = 0; n < inertias_.size(); ++n) {
    if (beam.is_held(n)) inertias_[n].m = 0.0;
  }
  standing_.resize(inertias_.size());
  stiffness_.for_each_pivot([](std::size_t) { return 0.0; },
                            [&](std::size_t i, double pivot) {
                              Node& node = standing_[i / 2];
                              (i % 2 == 0 ? node.v : node.slope) = pivot;
                            });
}

numerics::Counted Whirl::walk(double square, double gyro) const {
  numerics::Counted counted{0, 1.0};
  const auto less = [&](std::size_t i) {
    const Inertia& at = inertias_[i / 2];
    return i % 2 == 0 ? square * at.m : square * at.I_d - gyro * at.I_p;
  };
  stiffness_.for_each_pivot(less, [&](std::size_t i, double pivot) {
    const Node& node = standing_[i / 2];
    if (pivot < 0.0) ++counted.below;
    counted.rest *= pivot / (i % 2 == 0 ? node.v : node.slope);
  });
  return counted;
}

double Whirl::natural(std::size_t i, Sense sense, double spin, double near, double finest) const {
  return settled(
      i, [&](double w) { return walk(w * w, sign(sense) * w * spin); }, near, finest);
}

double Whirl::critical(std::size_t i, Sense sense, double near) const {
  constexpr double finest = 1e-11;
  return settled(
      i, [&](double w) { return walk(w * w, sign(sense) * w * w); }, near, finest);
}

std::size_t Whirl::below(double w, Sense sense, double spin) const { return walk(w * w, sign(sense) * w * spin).below; }

std::size_t Whirl::below(double w, Sense sense) const { return walk(w * w, sign(sense) * w * w).below; }

}  // namespace loadpath::beam
