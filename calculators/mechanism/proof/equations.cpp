// The proof of motion and forces: equilibrium of every link, power, and the reactions and drives found again by other
// methods.
#include "calculators/mechanism/cycle/ranges.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/mechanism/model/vec.hpp"
#include "lib/numerics/magnitude.hpp"
#include "lib/quantity/format.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace loadpath::planar {

namespace {

using account::Quantity;

// The remainder of zero terms is noise: its size has no further meaning.
constexpr double rounding = 1e-12;

account::Verdict limit(const std::string& step, const char* symbol, Message meaning, double value, double bound) {
  using account::Cell;
  return {
      .step = step,
      .symbol = symbol,
      .meaning = std::move(meaning),
      .value = value <= rounding ? Cell(say("at most {1}", format_number(rounding))) : Cell(Quantity{value, "-", 2}),
      .bound = say("at most {1}", format_number(bound)),
      .state = std::isnan(value) ? account::State::not_available : account::pass_if(value <= bound)};
}

/// A residual as a share of its terms; zero for zero terms. Undefined shares are NaN.
double part_of(double residual, double scale) {
  if (!std::isfinite(residual) || !std::isfinite(scale)) return none;
  if (scale > 0.0) return residual / scale;
  return residual == 0.0 ? 0.0 : none;
}

/// The largest of what is left over, and of what it is left over from, over the positions that close.
struct Leftovers {
  double force = 0.0, largest_force = 0.0;    // N
  double moment = 0.0, largest_moment = 0.0;  // N m
  double power = 0.0, largest_power = 0.0;    // W
  bool any = false;

  void add_force(mechanism::Vec force_there, mechanism::Vec at) {
    largest_force = numerics::larger_magnitude(largest_force, mechanism::length(force_there));
    largest_moment = numerics::larger_magnitude(largest_moment, mechanism::length(force_there) * mechanism::length(at));
  }
  /// The effort of a crank is a moment, that of a cylinder a force.
  void add(const mechanism::Position& p, const mechanism::Residuals& r, bool crank) {
    any = true;
    force = numerics::larger_magnitude(force, r.force);
    moment = numerics::larger_magnitude(moment, r.moment);
    power = numerics::larger_magnitude(power, r.power);
    largest_power = numerics::larger_magnitude(largest_power, r.power_scale);
    for (const auto& reaction : p.reactions) {
      add_force(reaction.force, reaction.at);
      largest_moment = numerics::larger_magnitude(largest_moment, reaction.couple);
    }
    for (std::size_t d = 0; d < p.effort.size(); ++d) {
      double& largest = d == 0 && crank ? largest_moment : largest_force;
      largest = numerics::larger_magnitude(largest, p.effort[d]);
    }
  }
};

/// Quantity that a method of the proof recovers, and its basis.
struct MethodText {
  mechanism::Proof::Method method;
  const char* symbol;
  Message meaning;
  bool of_drives;  // finds efforts only
};

std::array<MethodText, mechanism::Proof::methods> method_texts() {
  using mechanism::Proof;
  return {{{Proof::whole_system, "whole_system",
            say("forces recalculated from the simultaneous equilibrium of all links: maximum difference"), false},
           {Proof::opened_chain, "opened_chain",
            say("forces recalculated from moments about the joints of the opened chain: maximum difference"), false},
           {Proof::released_constraints, "released_constraints",
            say("each reaction recomputed by virtual work with its constraint released: largest difference"), false},
           {Proof::virtual_power, "virtual_power",
            say("driving torque or force recalculated from the power balance: maximum difference"), true},
           {Proof::zhukovsky, "zhukovsky_lever",
            say("driving torque or force recalculated with the Zhukovsky lever: maximum difference"), true}}};
}

/// The position where this is largest; what is not a number counts as largest of all.
template <class Measure>
std::optional<std::size_t> worst_position(const Cycle& cycle, Measure measure) {
  std::optional<std::size_t> worst;
  for (std::size_t k = 0; k < cycle.proofs.size(); ++k) {
    if (!cycle.has_forces(k)) continue;
    const double here = measure(cycle.proofs[k]);
    if (std::isnan(here)) return k;
    if (!worst || numerics::exceeds(here, measure(cycle.proofs[*worst]))) worst = k;
  }
  return worst;
}

/// The largest of a measure over the positions, and where, when that is too large.
template <class Measure>
account::Verdict at_worst(const std::string& step, const char* symbol, Message meaning, const Cycle& cycle,
                          const Axis* axis, Measure measure) {
  const auto worst = worst_position(cycle, measure);
  const double off = worst ? measure(cycle.proofs[*worst]) : none;
  account::Verdict v = limit(step, symbol, std::move(meaning), off, mechanism::Proof::tolerance);
  if (worst && v.state != account::State::pass && axis != nullptr) v.note = say("at {1}", place_of(*worst, *axis));
  return v;
}

/// Says how many positions the proofs hold at, and where they do not first and last.
account::Verdict trust(const std::string& step, const Cycle& cycle, const Axis* axis) {
  std::vector<std::size_t> doubtful;
  std::size_t closed = 0;
  for (std::size_t k = 0; k < cycle.proofs.size(); ++k) {
    if (!cycle.has_forces(k)) continue;
    ++closed;
    if (!cycle.proofs[k].trustworthy()) doubtful.push_back(k);
  }
  account::Verdict v{
      .step = step,
      .symbol = "trustworthy",
      .meaning = say("verification of motion and forces: differences / (maximum force x condition number)"),
      .value = say("{1} of {2}", std::to_string(closed - doubtful.size()), std::to_string(closed)),
      .bound = say("every position"),
      .state = closed == 0 ? account::State::not_available : account::pass_if(doubtful.empty())};
  if (doubtful.empty() || axis == nullptr) return v;
  const std::string first = place_of(doubtful.front(), *axis), last = place_of(doubtful.back(), *axis);
  v.note = doubtful.size() == 1 ? say("not trustworthy at {1}", first)
                                : say("not trustworthy at {1} positions, first at {2}, last at {3}",
                                      std::to_string(doubtful.size()), first, last);
  return v;
}

std::vector<account::Verdict> methods(const std::string& step, const Mechanism::Input& in, const Cycle& cycle,
                                      const Axis* axis) {
  const bool driven = !in.crank.joint.empty() || !in.cylinders.empty();
  std::vector<account::Verdict> verdicts;
  verdicts.push_back(at_worst(
      step, "motion", say("joints closed, velocities and accelerations as joints and drives allow: maximum error"),
      cycle, axis, [](const mechanism::Proof& p) { return p.motion; }));
  for (const MethodText& text : method_texts()) {
    if (!driven && text.of_drives) continue;
    verdicts.push_back(at_worst(step, text.symbol, text.meaning, cycle, axis,
                                [&](const mechanism::Proof& p) { return p.part(text.method); }));
  }
  verdicts.push_back(trust(step, cycle, axis));
  return verdicts;
}

void judge_equations(const Solved& solved, std::vector<account::Verdict>& verdicts) {
  const Mechanism::Input& in = solved.in;
  const Cycle& cycle = solved.proved;
  Leftovers left;
  for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
    if (cycle.has_forces(k)) left.add(cycle.positions[k], cycle.proofs[k].residuals, !in.crank.joint.empty());
  }
  const auto part = [&](double residual, double scale) { return left.any ? part_of(residual, scale) : none; };
  verdicts.push_back(limit(solved.step, "force_balance",
                           say("equilibrium of every link: unbalanced force / maximum reaction"),
                           part(left.force, left.largest_force), 1e-9));
  verdicts.push_back(limit(solved.step, "moment_balance",
                           say("equilibrium of every link: unbalanced moment / maximum moment"),
                           part(left.moment, left.largest_moment), 1e-9));
  if (!in.crank.joint.empty() || !in.cylinders.empty()) {
    verdicts.push_back(limit(solved.step, "power_balance",
                             say("power of drive, loads and weights against the change of kinetic energy"),
                             part(left.power, left.largest_power), 1e-9));
  }
  for (account::Verdict& v : methods(solved.step, in, cycle, solved.axis)) verdicts.push_back(std::move(v));
}

}  // namespace

constinit const Aspect aspects::equations{.judge = &judge_equations};

}  // namespace loadpath::planar
