// A span whose section varies along it, with end forces of a load along it: integrals of its flexibility, by Gauss's
// rule of eight points in each of its parts. The caller defines the parts: so short that 1/EI is nearly straight
// along each of them.
#pragma once

#include "lib/beam/beam.hpp"
#include "lib/numerics/quadrature.hpp"

#include <array>
#include <span>

namespace loadpath::beam {

struct Varying {
  Span span;
  OfEnds along{};
};

/// A load along a span, N/m: the sum of its coefficients times powers of the place, from the left.
class Spread {
 public:
  explicit Spread(const std::array<double, 3>& q) : q_(q) {}
  /// The resultant of the load to the left of a place, and its moment about the place.
  [[nodiscard]] double force(double x) const { return x * (q_[0] + x * (q_[1] / 2.0 + x * q_[2] / 3.0)); }
  [[nodiscard]] double moment(double x) const { return x * x * (q_[0] / 2.0 + x * (q_[1] / 6.0 + x * q_[2] / 12.0)); }

 private:
  std::array<double, 3> q_;
};

/// `section(x)` gives EI and GA there, as an array; `cuts` are the ends of the parts, from 0 to the length.
template <class Section>
Varying varying(std::span<const double> cuts, const Section& section, const Spread& load) {
  double bending = 0.0, first = 0.0, second = 0.0, shear = 0.0;  // integrals of 1/EI with powers of x, and of 1/GA
  double turned = 0.0, lifted = 0.0;                             // by the load on a cantilever fixed at the left
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    numerics::for_each_gauss_8(cuts[k], cuts[k + 1], [&](double x, double weight) {
      const auto [EI, GA] = section(x);
      const double soft = weight / EI;
      bending += soft, first += x * soft, second += x * x * soft, shear += weight / GA;
      turned += soft * load.moment(x), lifted += x * soft * load.moment(x) + weight / GA * load.force(x);
    });
  }
  const double l = cuts.back(), centre = first / bending, shifting = second - centre * first + shear;
  const double V = -(lifted - centre * turned) / shifting,
               M = -turned / bending - V * centre;  // at the left end, fixed
  return {{l, bending, centre, shifting}, {-V, M, V + load.force(l), -(M + V * l + load.moment(l))}};
}

}  // namespace loadpath::beam
