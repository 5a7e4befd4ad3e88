// A beam rotating about its axis with discs on it, in whirling: its elastic line rotates forwards or backwards. Beam,
// discs and supports are alike in all planes, so that v and slope of one plane determine those of the other. With K,
// M, G of stiffness, inertia and I_p, whirling at w of a beam with spin W satisfies K + w W G - w^2 M = 0, w < 0 for
// backward whirl. Since K is positive definite, the number of negative pivots of this is that of frequencies below w.
//
// SI throughout; frequencies are magnitudes. Masses and moments of inertia act at the nodes.
#pragma once

#include "lib/beam/beam.hpp"
#include "lib/numerics/counted_root.hpp"

#include <cstddef>

namespace loadpath::beam {

/// A body at a node, about its own centre: mass, moments of inertia about a diameter and about the axis.
struct Inertia {
  double m = 0.0, I_d = 0.0, I_p = 0.0;
};

enum class Sense { forward, backward };

class Whirl {
 public:
  Whirl(const Beam& beam, const Row<Inertia>& inertias);

  /// Number i, from 0 on, of the frequencies of a beam that turns at `spin`, rad/s; `near`: about where it is;
  /// `finest`: its relative precision. NaN if there is none, or it does not settle.
  [[nodiscard]] double natural(std::size_t i, Sense sense, double spin, double near = 256.0,
                               double finest = 1e-11) const;
  /// The same for the speeds of synchronous whirling. A disc of I_p > I_d has no such speed forwards.
  [[nodiscard]] double critical(std::size_t i, Sense sense, double near = 256.0) const;

  /// The number of frequencies below w of a beam that rotates at `spin`.
  [[nodiscard]] std::size_t below(double w, Sense sense, double spin) const;
  /// The number of critical speeds below w.
  [[nodiscard]] std::size_t below(double w, Sense sense) const;

 private:
  /// Less `square` of masses and of I_d, and with `gyro` of I_p.
  [[nodiscard]] numerics::Counted walk(double square, double gyro) const;

  Beam::Matrix stiffness_;
  Row<Inertia> inertias_;
  Row<Node> standing_;  // the pivots of both unknowns of each node without inertia
};

}  // namespace loadpath::beam
