#include "calculators/dynamics/free_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::dynamics {

namespace {

enum Unknown : std::size_t { x, y, z, v_x, v_y, v_z, length, work, unknowns };

MotionState state_of(double t, const Unknowns& u) {
  return {t, {u[x], u[y], u[z]}, {u[v_x], u[v_y], u[v_z]}, u[length], u[work]};
}

std::array<double, motion_variables.size()> variables_of(const MotionState& s) {
  return {s.r[0], s.r[1], s.r[2], s.v[0], s.v[1], s.v[2], s.speed(), s.t};
}

double value_of(const RelationText& text, const MotionState& state) {
  if (text.empty()) return 0.0;
  const Relation* const relation = text.read();
  return relation == nullptr ? std::nan("") : relation->at(variables_of(state));
}

}  // namespace

double magnitude_of(const std::array<double, 3>& vector) { return std::hypot(vector[0], vector[1], vector[2]); }

double MotionState::speed() const { return magnitude_of(v); }

Extremes::Extremes() {
  least.fill(std::numeric_limits<double>::infinity());
  most.fill(-std::numeric_limits<double>::infinity());
}

void Extremes::take(const MotionState& state, double F) {
  for (std::size_t i = 0; i < 3; ++i) {
    least[i] = std::min(least[i], state.r[i]);
    most[i] = std::max(most[i], state.r[i]);
  }
  speed = std::max(speed, state.speed());
  force = std::max(force, F);
}

double Extremes::reach() const {
  double largest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) largest = std::max({largest, std::abs(least[i]), std::abs(most[i])});
  return largest;
}

FreeMotion::FreeMotion(const GivenMotion& given) : given_(given) {}

std::array<double, 3> FreeMotion::force(const MotionState& state) const {
  return {value_of(*given_.F[0], state), value_of(*given_.F[1], state), value_of(*given_.F[2], state)};
}

InitialValue FreeMotion::problem() const {
  InitialValue problem;
  problem.t_2 = given_.t_2;
  problem.y = {given_.r[0], given_.r[1], given_.r[2], given_.v[0], given_.v[1], given_.v[2], 0.0, 0.0};
  problem.slopes = [this](double t, const Unknowns& u, Unknowns& slopes) {
    const MotionState state = state_of(t, u);
    const std::array<double, 3> F = force(state);
    for (std::size_t i = 0; i < 3; ++i) {
      slopes[x + i] = state.v[i];
      slopes[v_x + i] = F[i] / given_.mass;
    }
    slopes[length] = state.speed();
    slopes[work] = F[0] * state.v[0] + F[1] * state.v[1] + F[2] * state.v[2];
  };
  for (std::size_t i = 0; i < 3; ++i) problem.turns.emplace_back([i](double, const Unknowns& u) { return u[v_x + i]; });
  problem.turns.emplace_back([this](double t, const Unknowns& u) {  // power: extremes of the speed
    const MotionState state = state_of(t, u);
    const std::array<double, 3> F = force(state);
    return F[0] * state.v[0] + F[1] * state.v[1] + F[2] * state.v[2];
  });
  return problem;
}

FreeMotion::Ended FreeMotion::follow(double tolerance, const Visit& visit) const {
  InitialValue whole = problem();
  if (!given_.until->empty())
    whole.until = [this](double t, const Unknowns& u) { return value_of(*given_.until, state_of(t, u)); };
  const Solved solved = solve(whole, tolerance, [&](double t, const Unknowns& u) { visit(state_of(t, u)); });
  return {solved.end, state_of(solved.t, solved.y)};
}

std::vector<MotionState> FreeMotion::at(const std::vector<double>& times) const {
  InitialValue piece = problem();
  piece.turns.clear();
  std::vector<MotionState> states;
  double from = 0.0;
  for (const double t : times) {
    if (t > from) {
      piece.t_1 = from, piece.t_2 = t;
      piece.y = solve(piece, usual_tolerance, [](double, const Unknowns&) {}).y;
      from = t;
    }
    states.push_back(state_of(t, piece.y));
  }
  return states;
}

}  // namespace loadpath::dynamics
