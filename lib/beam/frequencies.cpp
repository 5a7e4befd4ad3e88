// The lowest frequency of masses on a beam by the method of Lanczos, proved by the definiteness of the stiffness less
// the masses times its square, and its bounds.
#include "lib/beam/beam.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace loadpath::beam {

namespace {

using Unknowns = boost::container::static_vector<double, 2 * most_nodes>;

/// The displacements of the nodes under forces.
Row<double> pushed(const Beam& beam, std::span<const double> forces) {
  Unknowns u(2 * forces.size());
  for (std::size_t n = 0; n < forces.size(); ++n) u[2 * n] = forces[n];
  beam.displace(u);
  Row<double> v;
  for (std::size_t n = 0; n < forces.size(); ++n) v.push_back(u[2 * n]);
  return v;
}

/// In four sums, which are independent of one another.
double product(const Row<double>& a, const Row<double>& b) {
  std::array<double, 4> sums{};
  std::size_t n = 0;
  for (; n + 4 <= a.size(); n += 4) {
    for (std::size_t k = 0; k < 4; ++k) sums[k] += a[n + k] * b[n + k];
  }
  for (; n < a.size(); ++n) sums[0] += a[n] * b[n];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

constexpr std::size_t most_steps = 40;

/// A symmetric matrix with a diagonal and its neighbour.
struct Tridiagonal {
  boost::container::static_vector<double, most_steps> diagonal, off_diagonal;

  /// Whether an eigenvalue is above x.
  [[nodiscard]] bool reaches(double x) const {
    double pivot = 1.0;
    for (std::size_t i = 0; i < diagonal.size(); ++i) {
      pivot = diagonal[i] - x - (i == 0 ? 0.0 : off_diagonal[i - 1] * off_diagonal[i - 1] / pivot);
      if (pivot > 0.0) return true;
      if (pivot == 0.0) pivot = -std::numeric_limits<double>::min();
    }
    return false;
  }
  [[nodiscard]] double largest() const {
    double low = *std::max_element(diagonal.begin(), diagonal.end()), high = 2.0 * low;
    while (reaches(high)) high *= 2.0;
    for (int halving = 0; halving < 60 && high - low > 1e-16 * high; ++halving) {
      const double middle = 0.5 * (low + high);
      (reaches(middle) ? low : high) = middle;
    }
    return high;
  }
};

/// The flexibility between the masses, each force and displacement times the root of its mass.
struct ScaledFlexibility {
  const Beam& beam;
  Row<double> roots;  // square roots of the masses

  [[nodiscard]] Row<double> operator()(Row<double> x) const {
    for (std::size_t n = 0; n < x.size(); ++n) x[n] *= roots[n];
    Row<double> v = pushed(beam, x);
    for (std::size_t n = 0; n < v.size(); ++n) v[n] *= roots[n];
    return v;
  }
  /// The deflection under the weights, slightly disturbed: its symmetry would hide a lower mode without that
  /// symmetry.
  [[nodiscard]] Row<double> first(const Row<double>& bent) const {
    Row<double> x;
    for (std::size_t n = 0; n < roots.size(); ++n)
      x.push_back(roots[n] * bent[n] * (1.0 + 0.01 * std::sin(1.0 + 2.3 * static_cast<double>(n))));
    return x;
  }
};

/// Converged when another step changes nothing, and no eigenvalue is below.
double lowest_of(const Beam& beam, std::span<const double> masses, const Row<double>& bent) {
  constexpr double settled = 1e-12, margin = 1e-5;
  ScaledFlexibility flexibility{beam, {}};
  for (const double mass : masses) flexibility.roots.push_back(std::sqrt(mass));
  std::array<Row<double>, most_steps> basis;
  Tridiagonal matrix;
  Row<double> next = flexibility.first(bent);
  double found = 0.0;
  for (std::size_t step = 0; step < most_steps; ++step) {
    const double size = std::sqrt(product(next, next));
    if (step > 0) {
      if (!(size > settled * found)) break;  // there are no more modes than that
      matrix.off_diagonal.push_back(size);
    }
    for (double& x : next) x /= size;
    basis[step] = next;
    next = flexibility(next);
    matrix.diagonal.push_back(product(next, basis[step]));
    for (int twice = 0; twice < 2; ++twice) {  // at right angles to all before it, to rounding
      for (std::size_t k = 0; k <= step; ++k) {
        const double part = product(next, basis[k]);
        for (std::size_t n = 0; n < next.size(); ++n) next[n] -= part * basis[k][n];
      }
    }
    const double before = found;
    found = matrix.largest();
    const bool still = step > 0 && found - before <= settled * found;
    if (still && beam.has_no_frequency_below(masses, (1.0 - margin) / found)) return 1.0 / std::sqrt(found);
  }
  return beam.has_no_frequency_below(masses, (1.0 - margin) / found) ? 1.0 / std::sqrt(found)
                                                                     : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Frequencies frequencies(const Beam& beam, std::span<const double> masses) {
  Frequencies found;
  const Row<double> weights(masses.begin(), masses.end()), bent = pushed(beam, weights);
  double of_weights = 0.0, of_squares = 0.0, alone = 0.0;
  const Row<double> each = beam.flexibilities();
  for (std::size_t n = 0; n < masses.size(); ++n) {
    of_weights += masses[n] * bent[n];
    of_squares += masses[n] * bent[n] * bent[n];
    alone += masses[n] * each[n];
  }
  if (!(of_squares > 0.0)) return found;
  found.rayleigh = std::sqrt(of_weights / of_squares);
  found.dunkerley = 1.0 / std::sqrt(alone);
  found.lowest = lowest_of(beam, masses, bent);
  return found;
}

}  // namespace loadpath::beam
