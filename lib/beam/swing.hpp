// A round shaft with discs in torsional vibration: its natural frequencies. Segments have distributed inertia, so
// that dividing them loses nothing. After Holzer, the shaft is traversed from one end to the other; the number of
// frequencies below a trial value is counted after Wittrick and Williams, so that none is missed.
//
// SI throughout. Both ends are free; a fixed end is a disc of a relatively large inertia.
#pragma once

#include "lib/beam/beam.hpp"
#include "lib/numerics/counted_root.hpp"

#include <boost/container/static_vector.hpp>

#include <cstddef>

namespace loadpath::beam {

/// A uniform stretch between two neighbouring nodes: its stiffness G I_t, and its moment of inertia per length.
struct Rod {
  double l = 0.0, GI = 0.0, j = 0.0;
};

/// An inertia at a node, rigid on the shaft or behind a spring, N m/rad.
struct Disc {
  std::size_t node = 0;
  double J = 0.0, k = rigid;
};

class Swing {
 public:
  static constexpr std::size_t most_rods = 2112, most_discs = 32;
  using Rods = boost::container::static_vector<Rod, most_rods>;
  using Discs = boost::container::static_vector<Disc, most_discs>;

  Swing(const Rods& rods, const Discs& discs) : rods_(rods), discs_(discs) {}

  /// The number of natural frequencies below omega, rad/s; rigid-body rotation is the first of them, at 0.
  [[nodiscard]] std::size_t below(double omega) const { return walk(omega).below; }
  /// The natural frequency number i, rad/s, where number 0 is rigid-body rotation; NaN if there is none.
  [[nodiscard]] double natural(std::size_t i) const;

 private:
  [[nodiscard]] numerics::Counted walk(double omega) const;

  Rods rods_;
  Discs discs_;
};

}  // namespace loadpath::beam
