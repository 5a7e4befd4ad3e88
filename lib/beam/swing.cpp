#include "lib/beam/swing.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace loadpath::beam {

namespace {

/// The dynamic stiffness in torsion (moment per rotation) at the left end of a rod and, through the rod, at its right
/// end, including all to the left. Written without the stiffness of a rod with fixed ends, which has poles at the
/// natural frequencies of such a rod.
struct Passed {
  double carried;
  std::size_t count;  // number of natural frequencies below, with the right end fixed
  double share;       // remainder that is 0 at each of them
};

Passed pass(const Rod& rod, double omega, double left) {
  constexpr double slow = 1e-4;  // below it the series is exact to rounding
  const double k = rod.GI / rod.l, b = omega * rod.l * std::sqrt(rod.j / rod.GI);
  const double c = std::cos(b), s = b < slow ? 1.0 - b * b / 6.0 : std::sin(b) / b;
  const auto held = static_cast<std::size_t>(b / std::numbers::pi);  // number for the rod with both ends fixed
  double together = left * s + k * c;
  if (together == 0.0) together = std::numeric_limits<double>::min();
  const bool turns_back = (together < 0.0) == (held % 2 == 0);
  return {k * (left * c - k * b * b * s) / together, held + (turns_back ? 1 : 0), together / k};
}

}  // namespace

numerics::Counted Swing::walk(double omega) const {
  boost::container::static_vector<double, most_rods + 1> own(rods_.size() + 1);  // by the discs of each node
  numerics::Counted walked{0, 1.0};
  for (const Disc& disc : discs_) {
    const double inertia = omega * omega * disc.J;
    const double softened = 1.0 - inertia / disc.k;  // 0 at its own resonance: there is no smaller number
    own[disc.node] -= inertia / (softened == 0.0 ? std::numeric_limits<double>::epsilon() : softened);
    if (inertia > disc.k) ++walked.below;
    walked.rest *= softened;
  }
  double left = own[0];
  for (std::size_t i = 0; i < rods_.size(); ++i) {
    const Passed passed = pass(rods_[i], omega, left);
    walked.below += passed.count;
    walked.rest *= passed.share;
    left = own[i + 1] + passed.carried;
  }
  if (left < 0.0) ++walked.below;
  walked.rest *= left;
  return walked;
}

double Swing::natural(std::size_t i) const {
  constexpr double first = 256.0;
  return i == 0 ? 0.0
                : numerics::counted_root(
                      i, [&](double omega) { return walk(omega); }, first);
}

}  // namespace loadpath::beam
