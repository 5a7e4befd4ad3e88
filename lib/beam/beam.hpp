// A straight beam on any number of supports, in one plane: internal forces, deflection, natural frequency. By
// Timoshenko elements, which are exact at their ends for any section and load, because they use the flexibility of a
// span, not its stiffness. varying.hpp integrates it for varying sections.
//
// SI throughout. v is positive like the forces F, slopes and couples M like the slope of v; V is the sum of all forces
// to the left, and M bends a beam hollow on the side that v points to: M' = V.
#pragma once

#include "lib/numerics/band_matrix.hpp"

#include <boost/container/static_vector.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

namespace loadpath::beam {

/// Nothing is allocated: these are the capacities of a beam.
inline constexpr std::size_t most_nodes = 320, most_supports = 16;
template <class Element>
using Row = boost::container::static_vector<Element, most_nodes>;
template <class Element>
using OfSupports = boost::container::static_vector<Element, most_supports>;

inline constexpr double rigid = std::numeric_limits<double>::infinity();

/// A span between two neighbouring nodes by its flexibility, split so that a transverse force at its centre causes no
/// relative rotation of its ends, and a couple no relative displacement.
struct Span {
  double l = 0.0;
  double bending = 0.0;   // the integral of 1/EI, rad/(N m): turns by a couple
  double centre = 0.0;    // the integral of x/EI over it, from the left
  double shifting = 0.0;  // the integrals of (x - centre)^2/EI and of 1/GA, m/N: shifts by a force
};
/// GA: shear stiffness, with the shear factor; rigid: no shear.
inline Span uniform(double l, double EI, double GA = rigid) {
  const double bending = l / EI;
  return {l, bending, l / 2.0, bending * l * l / 12.0 + l / GA};
}

/// Forces and couples at the two ends of a span: those of the left first.
using OfEnds = std::array<double, 4>;
/// End forces and couples of a uniform span under a uniform load q, N/m.
inline OfEnds even(const Span& span, double q) {
  return {q * span.l / 2.0, q * span.l * span.l / 12.0, q * span.l / 2.0, -q * span.l * span.l / 12.0};
}

/// A support of a node: stiffness against v, N/m, or rigid.
struct Support {
  std::size_t node = 0;
  double k = rigid;
};

struct Load {
  std::size_t node = 0;
  double F = 0.0, M = 0.0;
};

/// The loads at nodes, and the end forces of the load along each span; empty: there is none.
struct Loading {
  std::span<const Load> loads;
  std::span<const OfEnds> along = {};
};

struct Node {
  double v = 0.0;
  double slope = 0.0;  // rotation of the cross section
};

struct End {
  double V = 0.0, M = 0.0;
};
struct Ends {
  End left, right;
};

/// A loaded beam: nodes, the ends of every span, and the force of every support on the beam.
struct LoadedBeam {
  Row<Node> nodes;
  Row<Ends> spans;
  OfSupports<double> reactions;
};

class Beam {
 public:
  /// Each support at a separate node. Nothing if the beam is not supported: fewer than two supports.
  static std::optional<Beam> of(const Row<Span>& spans, const OfSupports<Support>& supports);

  [[nodiscard]] std::size_t nodes() const { return spans_.size() + 1; }

  /// Deflection under forces and couples at nodes, and end forces of the load along each span; `along` empty: there
  /// is none.
  [[nodiscard]] LoadedBeam bend(std::span<const Load> loads, std::span<const OfEnds> along = {}) const;
  /// The same in two planes at once.
  void bend(const Loading& in_x, const Loading& in_y, LoadedBeam& x, LoadedBeam& y) const;

  /// Replaces forces and couples at each node by its displacement and slope.
  void displace(std::span<double> unknowns) const;

  /// For each node, its displacement under a unit force there.
  [[nodiscard]] Row<double> flexibilities() const;

  /// Whether masses at the nodes have no frequency below that of this square, rad^2/s^2.
  [[nodiscard]] bool has_no_frequency_below(std::span<const double> masses, double square) const;

  /// Whether a node cannot move.
  [[nodiscard]] bool is_held(std::size_t node) const;

  /// Unknowns: v and slope of each node in turn.
  using Matrix = numerics::BandMatrix<2 * most_nodes>;
  [[nodiscard]] Matrix stiffness() const { return assembled(); }

 private:
  Beam(const Row<Span>& spans, const OfSupports<Support>& supports);
  /// The stiffness, less the masses times the square of a frequency.
  [[nodiscard]] Matrix assembled(std::span<const double> masses = {}, double square = 0.0) const;
  [[nodiscard]] Ends ends_of(std::size_t span, std::span<const double> u, const OfEnds& along) const;
  using Unknowns = boost::container::static_vector<double, 2 * most_nodes>;
  /// Nothing acts where a node cannot move.
  void hold(std::span<double> unknowns) const;
  [[nodiscard]] Unknowns pushed_by(const Loading& loading) const;
  /// The beam with these displacements and slopes.
  void fill(const Loading& loading, const Unknowns& u, LoadedBeam& bent) const;

  Row<Span> spans_;
  OfSupports<Support> supports_;
  Matrix factors_;
  bool holds_ = false;
};

/// The lowest angular frequency of bending, rad/s, of masses at the nodes on a massless beam; zero if there are no
/// masses, or none moves. NaN without convergence.
struct Frequencies {
  double lowest = 0.0;     // by Lanczos, and none is below
  double rayleigh = 0.0;   // from the deflection under the weights: never below
  double dunkerley = 0.0;  // from the flexibilities: never above
};
Frequencies frequencies(const Beam& beam, std::span<const double> masses);

}  // namespace loadpath::beam
