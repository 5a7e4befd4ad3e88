// A straight beam on any number of supports, in one plane: what it carries, how it bends, how it hums. By the elements
// of Timoshenko, which are exact at their ends for forces, couples and even loads.
//
// SI throughout. v is positive like the forces F, slopes and couples M like the slope of v; V is the sum of all forces
// to the left, and M bends a beam hollow on the side that v points to: M' = V.
#pragma once

#include "lib/numerics/band_matrix.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace loadpath::beam {

inline constexpr double rigid = std::numeric_limits<double>::infinity();

/// A uniform stretch between two neighbouring nodes. GA: shear stiffness over the shear factor; rigid: no shear.
struct Span {
  double l = 0.0, EI = 0.0, GA = rigid;
};

/// What holds a node: stiffness against v, N/m, or rigid.
struct Support {
  std::size_t node = 0;
  double k = rigid;
};

struct Load {
  std::size_t node = 0;
  double F = 0.0, M = 0.0;
};

struct Node {
  double v = 0.0;
  double slope = 0.0;  // of the cross section
};

struct End {
  double V = 0.0, M = 0.0;
};
struct Ends {
  End left, right;
};

/// A loaded beam: nodes, the ends of every span, and the force of every support on the beam.
struct Bent {
  std::vector<Node> nodes;
  std::vector<Ends> spans;
  std::vector<double> reactions;
};

class Beam {
 public:
  /// Nothing where the supports do not hold it: fewer than two of them, or both at one place.
  static std::optional<Beam> of(std::vector<Span> spans, std::vector<Support> supports);

  [[nodiscard]] std::size_t nodes() const { return spans_.size() + 1; }
  [[nodiscard]] const std::vector<Span>& spans() const { return spans_; }

  /// Under forces and couples at nodes, and an even load q on each span, N/m; no q: none.
  [[nodiscard]] Bent bend(std::span<const Load> loads, std::span<const double> q = {}) const;

  /// The displacement of each node where a unit force acts on it alone: its own flexibility.
  [[nodiscard]] std::vector<double> flexibilities() const;

 private:
  Beam(std::vector<Span> spans, std::vector<Support> supports);
  [[nodiscard]] Ends ends_of(std::size_t span, std::span<const double> u, double q) const;

  std::vector<Span> spans_;
  std::vector<Support> supports_;
  numerics::BandMatrix<3> factors_;  // unknowns: v and slope of each node in turn
  bool holds_ = false;
};

/// The lowest angular frequency of bending, rad/s, of masses at the nodes on a beam without mass; zero where there are
/// none, or nothing moves.
struct Frequencies {
  double lowest = 0.0;     // by inverse iteration
  double rayleigh = 0.0;   // of the shape under the weights: never below
  double dunkerley = 0.0;  // of the flexibilities: never above
};
Frequencies frequencies(const Beam& beam, std::span<const double> masses);

}  // namespace loadpath::beam
