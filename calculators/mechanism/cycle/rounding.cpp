#include "calculators/mechanism/cycle/rounding.hpp"

#include "lib/mechanism/equations/kinematics.hpp"
#include "lib/quantity/decimal.hpp"
#include "lib/quantity/units.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar {

namespace {

constexpr double rounding = 1e-13;  // share of the largest term: some hundred times the spacing of doubles

void take(double magnitude, double& most) { most = magnitude > most ? magnitude : most; }
void take_square(double x, double y, double& most) { take(x * x + y * y, most); }

/// Inertia of all links, with their masses at this distance.
double inertia_within(const mechanism::Model& model, double distance) {
  double sum = 0.0;
  for (const mechanism::Link& link : model.links) sum += link.mass * distance * distance + link.inertia;
  return sum;
}

}  // namespace

Rounding rounding_at(const mechanism::Position& p) {
  constexpr double part = 1e-12;  // a reaction comes out of a chain of equations
  Rounding least;
  for (const mechanism::Reaction& r : p.reactions) {
    const double force = part * mechanism::length(r.force);
    least.force = std::max(least.force, force);
    least.moment = std::max(least.moment, force * mechanism::length(r.at));
  }
  return least;
}

double direction_of(mechanism::Vec v) {
  constexpr double part = 1e-9;
  if (std::abs(v.y) <= part * std::abs(v.x)) return v.x < 0.0 ? pi : 0.0;
  return std::atan2(v.y, v.x);
}

void Magnitudes::see(const mechanism::Position& p, const std::vector<mechanism::Driver>& drivers) {
  const auto see_force = [this](mechanism::Vec acting, double turning_moment) {
    take_square(acting.x, acting.y, force);
    take(std::abs(turning_moment), couple);
  };
  for (std::size_t k = 0; k < p.pose.size(); ++k) {
    take_square(p.pose[k].x, p.pose[k].y, length);
    take_square(p.velocity[k].x, p.velocity[k].y, speed);
    take_square(p.acceleration[k].x, p.acceleration[k].y, acceleration);
    take(std::abs(p.velocity[k].phi), turning);
    take(std::abs(p.acceleration[k].phi), angular_acceleration);
  }
  for (const mechanism::Reaction& r : p.reactions) see_force(r.force, r.couple);
  for (const mechanism::LoadNow& load : p.loads) see_force(load.force, load.moment);
  for (std::size_t d = 0; d < drivers.size(); ++d) {
    const bool turns = drivers[d].kind == mechanism::Driver::Kind::rotary;
    turns ? take(std::abs(p.effort[d]), couple) : take_square(p.effort[d], 0.0, force);
  }
}

Magnitudes magnitudes_of(const mechanism::Model& model, const Cycle& cycle) {
  Magnitudes of;
  for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
    if (cycle.closed[k]) of.see(cycle.positions[k], model.drivers);
  }
  return of;
}

ResultRounding::ResultRounding(const mechanism::Model& model, const Magnitudes& of) {
  const double force = std::sqrt(of.force);
  const double reach = mechanism::characteristic_length(model), length = std::sqrt(of.length) + reach;
  const double speed = std::sqrt(of.speed) + of.turning * reach,
               turned = of.turning * of.turning + of.angular_acceleration;
  const double moment = std::max(of.couple, force * length);
  scales_ = {{mm.dimension(), length},
             {deg.dimension(), 1.0},
             {m_per_s.dimension(), speed},
             {rad_per_s.dimension(), of.turning},
             {m_per_s2.dimension(), std::sqrt(of.acceleration) + turned * reach},
             {rad_per_s2.dimension(), turned},
             {N.dimension(), std::max(force, of.couple / length)},
             {N_m.dimension(), moment},
             {kg_m2.dimension(), inertia_within(model, length)},
             {W.dimension(), std::max(force * speed, moment * of.turning)}};
}

void ResultRounding::clear(Value& value, bool direction) const {
  const auto scale = std::find_if(scales_.begin(), scales_.end(),
                                  [&](const Scale& s) { return s.dimension == value.signature.dimension; });
  if (scale == scales_.end()) return;
  value.rounding = rounding * scale->largest;
  const Decimals decimals = Decimals::within(value.rounding);
  if (!direction) return decimals.round(value.si, value.rounding);
  for (std::size_t i = 0; i < value.si.size(); ++i) {
    double& x = value.si[i];
    const double adjacent = i > 0                 ? value.si[i - 1]
                            : value.si.size() > 1 ? value.si[1]
                                                  : pi;  // the turn goes on from it
    if (std::abs(x + pi) <= value.rounding && adjacent > 0.0) x = pi;
    x = std::abs(x) <= value.rounding ? 0.0 : decimals.nearest(x);
  }
}

}  // namespace loadpath::planar
