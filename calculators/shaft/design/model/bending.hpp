// The shaft as a beam in two planes: its nodes, its bearing reactions, and the internal forces of every section.
#pragma once

#include "calculators/shaft/design/model/stretches.hpp"

#include <optional>

namespace loadpath::shaft {

Stations stations_of(const DesignInput& in, const CriticalPlaces& weakest = {});

/// Internal forces at a section, the larger of both sides: planes X and Y, along the shaft and around it.
struct InternalForces {
  double M_x = 0.0, M_y = 0.0, V = 0.0, N = 0.0, T = 0.0;
};

/// The shaft without its loads.
struct Elastic {
  Stations stations;
  beam::Row<Stretch> stretches;
  beam::Beam beam;
};
/// None if the bearings are so soft compared with the shaft that they give no support.
std::optional<Elastic> elastic_shaft(const DesignInput& in, const CriticalPlaces& weakest = {});

/// The shaft under all of its loads at a position of its turn, with the service factor.
struct Loaded {
  Stations stations;
  beam::LoadedBeam x, y;
  beam::Row<double> T, N;  // values of every span
  beam::Row<double> phi;   // twist of every node against the first
  double thrust = 0.0;     // that the fixed bearing takes, signed
  double twist = 0.0;      // the largest per length, rad/m
  double twisting = 0.0;   // the torque that it is of, N m; unsigned
  double flexible = 0.0;   // 1/(G I_p) there, rad/(N m^2)
  /// Internal forces of a span at its left or right end.
  [[nodiscard]] InternalForces side(std::size_t span, bool right_end) const;
  [[nodiscard]] InternalForces internal_forces(std::size_t node) const;
  [[nodiscard]] double deflection(std::size_t node) const;
  [[nodiscard]] double slope(std::size_t node) const;
  [[nodiscard]] double largest_moment() const;
  [[nodiscard]] double largest_deflection() const;
};
Loaded loaded_at(const DesignInput& in, const Elastic& elastic, std::size_t position);
/// The position at which the shaft is bent most.
std::size_t most_bent(const DesignInput& in, const Elastic& elastic);
/// At that one; nothing as above.
std::optional<Loaded> loaded_shaft(const DesignInput& in);
bool bears(const DesignInput& in);

/// Masses of the shaft and its mounted components, at the nodes.
beam::Row<double> masses_of(const DesignInput& in, const Elastic& elastic);
beam::Frequencies critical_speeds(const DesignInput& in, const Elastic& elastic);

}  // namespace loadpath::shaft
