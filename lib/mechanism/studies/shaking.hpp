// The forces of the moving masses on the frame, and counterweights against them. The shaking force is -sum m a,
// without weights and loads, which do not shake by themselves.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace loadpath::mechanism {

struct Shaking {
  Vec force;            // N, on the frame
  double moment = 0.0;  // N m, on the frame, about the stated point
};
/// At a position with velocities and accelerations; `about`: global.
Shaking shaking(const Model& model, const Position& at, Vec about);

/// Over a cycle: of positions that are equally spaced in time, the end of the cycle not repeated.
struct ShakingCycle {
  double rms_force = 0.0;    // N
  double peak_force = 0.0;   // N
  double rms_moment = 0.0;   // N m
  double peak_moment = 0.0;  // N m, magnitude
};
ShakingCycle shaking_over(const Model& model, std::span<const Position> cycle, Vec about);

/// The site of a counterweight: on a link, about this point of it. If the point moves, the counterweight's mass
/// counts in addition to its moment and must be given; about a fixed pivot it does not.
struct CounterweightSite {
  std::size_t link = 0;
  Vec pivot;                             // link frame, m
  double mass = 0.0;                     // kg
  std::optional<double> direction = {};  // direction of its arm, rad, link frame; nothing: the best one
};
/// Its mass times its arm from the pivot, link frame, kg m. In a given direction it may come out opposite to it.
struct Counterweight {
  CounterweightSite site;
  Vec mass_moment;
  /// kg, of a point mass at this distance from the pivot, m, > 0.
  [[nodiscard]] double mass_at(double radius) const { return length(mass_moment) / radius; }
};

enum class BalanceAim { rms, peak };
/// Counterweights that minimise the shaking force over the cycle: its rms by least squares (among several equal
/// solutions the smallest counterweights), its peak at these positions by Lawson's weighting, to 1e-6 of the rms of
/// the cycle or better.
std::vector<Counterweight> find_counterweights(const Model& model, std::span<const Position> cycle,
                                               std::span<const CounterweightSite> sites,
                                               BalanceAim aim = BalanceAim::rms);

/// A link with a point mass for its counterweight at this distance from the pivot, m, > 0; a site with a given mass
/// has that mass at the arm that it needs. The motion is unchanged; forces and shaking moment must be computed again.
Link with_counterweight(const Link& link, const Counterweight& weight, double radius);

/// Mass, mass centre and moment of inertia with a point mass at this place of the link's frame.
Link with_point_mass(const Link& link, Vec at, double mass);

}  // namespace loadpath::mechanism
