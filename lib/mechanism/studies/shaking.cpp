#include "lib/mechanism/studies/shaking.hpp"

#include "lib/mechanism/model/point_motion.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::mechanism {
namespace {

/// The forces of counterweights over a cycle: as they are without, and per unit of each mass moment.
struct BalanceEquations {
  Eigen::MatrixXd per_unit;  // two rows for each position; columns of each site, in order: one for each of its axes
  Eigen::VectorXd force;
};

/// Along which its mass moment is free, link frame: of a stated direction only the first.
struct Axes {
  std::array<Vec, 2> along;
  Eigen::Index count;
};
Axes axes_of(const CounterweightSite& site) {
  if (site.direction) return {{turn(*site.direction)({1.0, 0.0}), {}}, 1};
  return {{Vec{1.0, 0.0}, Vec{0.0, 1.0}}, 2};
}

void write_site(const CounterweightSite& site, const Position& at, Eigen::Index row, Eigen::Index column,
                BalanceEquations& equations) {
  const Pose &velocity = at.velocity[site.link], &acceleration = at.acceleration[site.link];
  const Turn turned = turn(at.pose[site.link].phi);
  const Vec of_pivot = point_acceleration(acceleration, velocity.phi, turned(site.pivot));
  equations.force[row] -= site.mass * of_pivot.x;
  equations.force[row + 1] -= site.mass * of_pivot.y;
  const Axes axes = axes_of(site);
  for (Eigen::Index k = 0; k < axes.count; ++k) {
    const Vec arm = turned(axes.along[static_cast<std::size_t>(k)]);
    const Vec a = point_acceleration({0.0, 0.0, acceleration.phi}, velocity.phi, arm);
    equations.per_unit(row, column + k) = -a.x;
    equations.per_unit(row + 1, column + k) = -a.y;
  }
}

BalanceEquations equations_of(const Model& model, std::span<const Position> cycle,
                              std::span<const CounterweightSite> sites) {
  const auto rows = static_cast<Eigen::Index>(2 * cycle.size());
  Eigen::Index columns = 0;
  for (const CounterweightSite& site : sites) columns += axes_of(site).count;
  BalanceEquations equations{Eigen::MatrixXd::Zero(rows, columns), Eigen::VectorXd::Zero(rows)};
  for (Eigen::Index row = 0; row < rows; row += 2) {
    const Position& at = cycle[static_cast<std::size_t>(row / 2)];
    const Vec force = shaking(model, at, {}).force;
    equations.force[row] += force.x;
    equations.force[row + 1] += force.y;
    Eigen::Index column = 0;
    for (const CounterweightSite& site : sites) {
      write_site(site, at, row, column, equations);
      column += axes_of(site).count;
    }
  }
  return equations;
}

Eigen::VectorXd least_squares(const BalanceEquations& equations) {
  return equations.per_unit.completeOrthogonalDecomposition().solve(-equations.force);
}

Eigen::VectorXd magnitudes(const Eigen::VectorXd& forces) {
  Eigen::VectorXd result(forces.size() / 2);
  for (Eigen::Index k = 0; k < result.size(); ++k) result[k] = std::hypot(forces[2 * k], forces[2 * k + 1]);
  return result;
}

// Lawson: weighted least squares, whose weights grow where the residual is large, converge to the smallest peak.
Eigen::VectorXd least_peak(const BalanceEquations& equations) {
  constexpr int most_steps = 2000;
  constexpr double close = 1e-6;
  const Eigen::Index positions = equations.force.size() / 2;
  Eigen::VectorXd weight = Eigen::VectorXd::Constant(positions, 1.0 / static_cast<double>(positions));
  Eigen::VectorXd best = least_squares(equations);
  double least = magnitudes(equations.force + equations.per_unit * best).maxCoeff();
  const double scale = equations.force.norm() / std::sqrt(static_cast<double>(positions));
  BalanceEquations weighted = equations;
  for (int step = 0; step < most_steps; ++step) {
    for (Eigen::Index row = 0; row < equations.force.size(); ++row) {
      const double root = std::sqrt(weight[row / 2]);
      weighted.per_unit.row(row) = root * equations.per_unit.row(row);
      weighted.force[row] = root * equations.force[row];
    }
    const Eigen::VectorXd x = least_squares(weighted);
    const Eigen::VectorXd rest = magnitudes(equations.force + equations.per_unit * x);
    if (rest.maxCoeff() < least) {
      least = rest.maxCoeff();
      best = x;
    }
    // The residual of the weighted rms is a lower bound of any peak.
    if (least - std::sqrt(weight.dot(rest.cwiseAbs2())) <= close * scale) break;
    weight = weight.cwiseProduct(rest);
    const double sum = weight.sum();
    if (!(sum > 0.0)) break;
    weight /= sum;
  }
  return best;
}

}  // namespace

Shaking shaking(const Model& model, const Position& at, Vec about) {
  Shaking sum;
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    const Link& link = model.links[k];
    const Vec arm = turn(at.pose[k].phi)(link.centre);
    const Vec force = -link.mass * point_acceleration(at.acceleration[k], at.velocity[k].phi, arm);
    const Vec centre = Vec{at.pose[k].x, at.pose[k].y} + arm;
    sum.force = sum.force + force;
    sum.moment += cross(centre - about, force) - link.inertia * at.acceleration[k].phi;
  }
  return sum;
}

ShakingCycle shaking_over(const Model& model, std::span<const Position> cycle, Vec about) {
  ShakingCycle over;
  if (cycle.empty()) return over;
  for (const Position& at : cycle) {
    const Shaking s = shaking(model, at, about);
    over.rms_force += dot(s.force, s.force);
    over.rms_moment += s.moment * s.moment;
    over.peak_force = std::max(over.peak_force, length(s.force));
    over.peak_moment = std::max(over.peak_moment, std::abs(s.moment));
  }
  const auto count = static_cast<double>(cycle.size());
  over.rms_force = std::sqrt(over.rms_force / count);
  over.rms_moment = std::sqrt(over.rms_moment / count);
  return over;
}

std::vector<Counterweight> find_counterweights(const Model& model, std::span<const Position> cycle,
                                               std::span<const CounterweightSite> sites, BalanceAim aim) {
  std::vector<Counterweight> weights;
  if (cycle.empty() || sites.empty()) return weights;
  const BalanceEquations equations = equations_of(model, cycle, sites);
  const Eigen::VectorXd moments = aim == BalanceAim::rms ? least_squares(equations) : least_peak(equations);
  Eigen::Index column = 0;
  for (const CounterweightSite& site : sites) {
    const Axes axes = axes_of(site);
    Vec moment;
    for (Eigen::Index k = 0; k < axes.count; ++k) {
      moment = moment + moments[column + k] * axes.along[static_cast<std::size_t>(k)];
    }
    weights.push_back({site, moment});
    column += axes.count;
  }
  return weights;
}

Link with_counterweight(const Link& link, const Counterweight& weight, double radius) {
  const double mass = weight.site.mass > 0.0 ? weight.site.mass : weight.mass_at(radius);
  if (mass == 0.0) return link;
  return with_point_mass(link, weight.site.pivot + (1.0 / mass) * weight.mass_moment, mass);
}

Link with_point_mass(const Link& link, Vec at, double mass) {
  Link with = link;
  with.mass = link.mass + mass;
  if (with.mass == 0.0) return with;
  const Vec apart = at - link.centre;
  with.centre = link.centre + (mass / with.mass) * apart;
  with.inertia = link.inertia + link.mass * mass / with.mass * dot(apart, apart);
  return with;
}

}  // namespace loadpath::mechanism
