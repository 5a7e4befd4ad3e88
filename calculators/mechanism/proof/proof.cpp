#include "calculators/mechanism/proof/proof.hpp"

#include "calculators/mechanism/cycle/either_way.hpp"
#include "calculators/mechanism/cycle/ranges.hpp"
#include "calculators/mechanism/cycle/rounding.hpp"
#include "calculators/mechanism/results/cams.hpp"
#include "calculators/mechanism/results/missing.hpp"
#include "calculators/mechanism/words/profiles.hpp"
#include "lib/mechanism/model/frames.hpp"
#include "lib/mechanism/model/vec.hpp"
#include "lib/mechanism/studies/cam_state.hpp"
#include "lib/numerics/magnitude.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace loadpath::planar {

namespace {

using account::Quantity;

// What is left of nothing is noise: its size says no more than that.
constexpr double rounding = 1e-12;

account::Verdict limit(const std::string& step, const char* symbol, Message meaning, double value, double bound) {
  account::Verdict v;
  v.step = step;
  v.symbol = symbol;
  v.meaning = std::move(meaning);
  v.bound = say("at most {1}", format_number(bound));
  if (value <= rounding) {
    v.value = say("at most {1}", format_number(rounding));
  } else {
    v.value = Quantity{value, "-", 2};
  }
  v.state = std::isnan(value) ? account::State::not_available
            : value <= bound  ? account::State::pass
                              : account::State::fail;
  return v;
}

Message why_open(const Mechanism::Input& in, const Cycle& cycle) {
  if (cycle.first_failure == mechanism::Status::singular) return say("the drive cannot hold the mechanism there");
  if (cycle.gap.joint < 0) return say("the drive could not be followed to its place");
  const auto type = in.joints[static_cast<std::size_t>(cycle.gap.joint)].type;
  if (type == planar::Type::belt || type == planar::Type::crossed_belt) {
    return say("the belt '{1}' keeps its length, and its centres would have to move apart or together",
               std::string(in.joints[static_cast<std::size_t>(cycle.gap.joint)].name.view()));
  }
  return say("the parts of joint '{1}' come no closer than {2}",
             std::string(in.joints[static_cast<std::size_t>(cycle.gap.joint)].name.view()),
             format_quantity(cycle.gap.size, "mm", 4));
}

/// Where the drives do not hold the mechanism, and nothing else is wrong.
Message change_points(const Cycle& cycle, const Axis& axis) {
  std::string places;
  for (std::size_t k = 0; k < cycle.at_change_point.size(); ++k) {
    if (cycle.at_change_point[k]) places += (places.empty() ? "" : ", ") + place_of(k, axis);
  }
  if (!axis.cyclic())
    return say("a change point at {1}: the drive does not hold it there; choose places beside it", places);
  const double half = 0.5 * (axis.at[1] - axis.at[0]);
  return say(
      "a change point at {1}: the drive does not hold it there; choose places beside it, crank = { start = \"{2}\" }",
      places, format_quantity(axis.at[0] + half, axis.unit, 5));
}

account::Verdict closing(const std::string& step, const Mechanism::Input& in, const Cycle& cycle, const Axis* axis) {
  account::Verdict v;
  v.step = step;
  v.symbol = "closes";
  v.meaning = say("the mechanism closes at every position");
  v.bound = say("every position");
  const auto closed = static_cast<std::size_t>(std::count(cycle.closed.begin(), cycle.closed.end(), true));
  v.value = say("{1} of {2}", std::to_string(closed), std::to_string(cycle.closed.size()));
  v.state = closed == cycle.closed.size() ? account::State::pass : account::State::fail;
  if (v.state == account::State::pass) return v;
  if (axis != nullptr && cycle.closes_but_at_change_points()) {
    v.note = change_points(cycle, *axis);
    return v;
  }
  v.note = why_open(in, cycle);
  if (axis == nullptr) return v;
  v.note = say("{1}: {2}", range_of(cycle.closed, false, *axis), v.note);
  if (is_whole_turn(in) && cycle.first_failure == mechanism::Status::does_not_close) {
    v.note =
        say("{1}; the crank does not turn round: change the lengths, or give it angles where the mechanism closes, "
            "crank = { at = [...] }",
            v.note);
  }
  return v;
}

/// Means over the turn are those of a cycle only if the mechanism is back then where it began.
account::Verdict no_return(const std::string& step, const Mechanism::Input& in) {
  account::Verdict v;
  v.step = step;
  v.symbol = "returns";
  v.meaning = say("after the cycle the mechanism is where it began");
  v.bound = say("after {1} turns", std::to_string(static_cast<int>(in.crank.turns)));
  v.value = say("elsewhere");
  v.state = account::State::fail;
  v.note =
      say("give the turns of the crank that make a cycle, crank = { turns = ... }; where these are too many, "
          "give crank angles in place of a cycle, crank = { at = [...] }, and there are no means");
  return v;
}

/// Whether no drive moves nor says which way it is about to: then friction could act either way.
bool is_at_rest(const Mechanism::Input& in) {
  const auto rests = [](const auto& drive) {
    return in_si(drive.speed) == 0.0 && drive.impending == planar::Impending::either;
  };
  return !has_law(in) && rests(in.crank) && std::all_of(in.cylinders.begin(), in.cylinders.end(), rests);
}

/// Whether there is a position where no effort of the only drive starts it this way.
bool holds_against(const Cycle& cycle, double sense) {
  for (std::size_t k = 0; k < cycle.standing.size(); ++k) {
    const StandingEffort& effort = cycle.standing[k];
    if (effort.known && std::isnan(sense > 0.0 ? effort.forward : effort.backward)) return true;
  }
  return false;
}

/// The positions where friction holds what rests against any effort one way or another.
std::vector<bool> held_one_way(const Cycle& cycle) {
  std::vector<bool> held(cycle.positions.size());
  for (std::size_t k = 0; k < cycle.either_way.size(); ++k) {
    const auto& ways = cycle.either_way[k];
    held[k] = std::any_of(ways.begin(), ways.end(), [](const auto& way) { return way.pose.empty(); });
  }
  return held;
}

/// A turning spring whose angle does not come back is wound up further with every cycle.
account::Verdict wound_up(const std::string& step, const Mechanism::Input& in, const Cycle::Winding& winding) {
  const std::string name(in.springs[winding.spring].name.view());
  account::Verdict v;
  v.step = step;
  v.symbol = "returns_" + name;
  v.meaning = say("after the cycle the spring '{1}' is as it was", name);
  v.bound = say("the same angle");
  v.value = Quantity{winding.by, "deg", 4};
  v.state = account::State::fail;
  v.note = say("it is wound up further with every cycle; these results are of the first");
  return v;
}

/// Whether a joint only pushes: nothing pulls a wheel back on what it rolls on, or a follower on its cam.
bool only_pushes(const planar::Joint& joint) {
  using Type = planar::Type;
  if (is_cam(joint.type)) return joint.holding == planar::Holding::one_side;
  return joint.type == Type::rolling || joint.type == Type::rolling_inside || joint.type == Type::rolling_on_line;
}

/// The force that presses a rolling wheel against what it rolls on, or a follower against its cam, N.
double pressing(const mechanism::Model& model, const mechanism::Position& at, std::size_t k) {
  const mechanism::Joint& joint = model.joints[k];
  if (joint.kind == mechanism::JointKind::cam) return mechanism::cam_state(model, k, at).pressing;
  mechanism::PairPlace place;
  mechanism::place(mechanism::shape_of(joint), mechanism::placed_at(at, joint.i), mechanism::placed_at(at, joint.j),
                   place);
  const bool line = joint.kind == mechanism::JointKind::rolling_on_line;
  const double side = line ? std::copysign(1.0, joint.radius_i) : -1.0;
  return side * mechanism::dot(at.reactions[k].force, place.rows[1].e);
}

std::vector<account::Verdict> contacts(const std::string& step, const Mechanism::Input& in,
                                       const mechanism::Model& model, const Cycle& cycle, const Axis* axis) {
  std::vector<account::Verdict> verdicts;
  for (std::size_t n = 0; n < model.joints.size(); ++n) {
    const mechanism::Joint& joint = model.joints[n];
    if (!only_pushes(in.joints[n])) continue;
    const bool cam = joint.kind == mechanism::JointKind::cam;
    std::vector<bool> lost(cycle.positions.size());
    for (std::size_t k = 0; k < lost.size(); ++k)
      lost[k] = cycle.has_forces(k) && pressing(model, cycle.positions[k], n) < -rounding_at(cycle.positions[k]).force;
    const auto count = static_cast<std::size_t>(std::count(lost.begin(), lost.end(), true));
    account::Verdict v;
    v.step = step;
    v.symbol = "contact_" + joint.name;
    v.meaning = cam ? say("the follower of joint '{1}' stays on its cam", joint.name)
                    : say("the wheel of joint '{1}' stays on what it rolls on", joint.name);
    v.bound = say("every position");
    if (!cycle.unique.empty() && !cycle.unique[n].force) {
      v.value = say("not unique");
      v.state = account::State::not_covered;
      verdicts.push_back(std::move(v));
      continue;
    }
    v.value = say("{1} of {2}", std::to_string(lost.size() - count), std::to_string(lost.size()));
    v.state = count == 0 ? account::State::pass : account::State::fail;
    if (count > 0 && axis != nullptr) v.note = say("lifts off {1}", range_of(lost, true, *axis));
    verdicts.push_back(std::move(v));
  }
  return verdicts;
}

/// Said only of a mechanism with friction.
void add_jamming(const std::string& step, const Mechanism::Input& in, const mechanism::Model& model, const Cycle& cycle,
                 const Axis* axis, std::vector<account::Verdict>& verdicts) {
  const auto jams = static_cast<std::size_t>(std::count(cycle.jams.begin(), cycle.jams.end(), true));
  if (!has_dry_friction(model) && jams == 0) return;
  account::Verdict v;
  v.step = step;
  v.symbol = "moves";
  v.meaning = say("friction does not jam the mechanism");
  v.bound = say("every position");
  v.value = say("{1} of {2}", std::to_string(cycle.jams.size() - jams), std::to_string(cycle.jams.size()));
  v.state = jams == 0 ? account::State::pass : account::State::fail;
  if (jams > 0 && axis != nullptr) v.note = say("jams {1}", range_of(cycle.jams, true, *axis));
  if (is_at_rest(in)) {
    const std::vector<bool> held = held_one_way(cycle);
    const bool none = std::find(held.begin(), held.end(), true) == held.end();
    v.state = account::State::not_covered;
    const bool one_drive = !cycle.standing.empty();
    v.note =
        none ? say("at rest friction acts either way: the results are without it, and the effort lies between "
                   "M_min and M_max, F_min and F_max; state 'impending' for one way")
        : one_drive && holds_against(cycle, 1.0)
            ? say("at rest friction acts either way, and no effort of the drive starts it forward; state 'impending'")
        : one_drive && holds_against(cycle, -1.0)
            ? say("at rest friction acts either way, and no effort of the drive starts it backward; state 'impending'")
            : say("at rest friction acts either way, and one way no effort starts it; state 'impending'");
  }
  verdicts.push_back(std::move(v));
}

/// A residual as a part of what it is a residual of; of nothing it is zero. What cannot be told is no number.
double part_of(double residual, double scale) {
  if (!std::isfinite(residual) || !std::isfinite(scale)) return std::numeric_limits<double>::quiet_NaN();
  if (scale > 0.0) return residual / scale;
  return residual == 0.0 ? 0.0 : std::numeric_limits<double>::quiet_NaN();
}

/// The largest of what is left over, and of what it is left over from, over the positions that close.
struct Leftovers {
  double force = 0.0, largest_force = 0.0;    // N
  double moment = 0.0, largest_moment = 0.0;  // N m
  double power = 0.0, largest_power = 0.0;    // W
  bool any = false;

  void add_force(mechanism::Vec force_there, mechanism::Vec at) {
    largest_force = larger_magnitude(largest_force, mechanism::length(force_there));
    largest_moment = larger_magnitude(largest_moment, mechanism::length(force_there) * mechanism::length(at));
  }
  /// The effort of a crank is a moment, that of a cylinder a force.
  void add(const mechanism::Position& p, const mechanism::Residuals& r, bool crank) {
    any = true;
    force = larger_magnitude(force, r.force);
    moment = larger_magnitude(moment, r.moment);
    power = larger_magnitude(power, r.power);
    largest_power = larger_magnitude(largest_power, r.power_scale);
    for (const auto& reaction : p.reactions) {
      add_force(reaction.force, reaction.at);
      largest_moment = larger_magnitude(largest_moment, reaction.couple);
    }
    for (std::size_t d = 0; d < p.effort.size(); ++d) {
      double& largest = d == 0 && crank ? largest_moment : largest_force;
      largest = larger_magnitude(largest, p.effort[d]);
    }
  }
};

/// What a method of the proof finds again, and from what.
struct MethodText {
  mechanism::Proof::Method method;
  const char* symbol;
  Message meaning;
  bool of_drives;  // finds efforts only
};

std::array<MethodText, mechanism::Proof::methods> method_texts() {
  using mechanism::Proof;
  return {{{Proof::whole_system, "whole_system",
            say("forces found again from the equilibrium of all links at once: largest difference"), false},
           {Proof::opened_chain, "opened_chain",
            say("forces found again from moments about the joints of the opened chain: largest difference"), false},
           {Proof::released_constraints, "released_constraints",
            say("each reaction found again from the work when its constraint alone is released: largest difference"),
            false},
           {Proof::virtual_power, "virtual_power",
            say("driving effort found again from the powers of all that acts: largest difference"), true},
           {Proof::zhukovsky, "zhukovsky_lever",
            say("driving effort found again with Zhukovsky's lever: largest difference"), true}}};
}

/// The position where this is largest; what is not a number counts as largest of all.
template <class Measure>
std::optional<std::size_t> worst_position(const Cycle& cycle, Measure measure) {
  std::optional<std::size_t> worst;
  for (std::size_t k = 0; k < cycle.proofs.size(); ++k) {
    if (!cycle.has_forces(k)) continue;
    const double here = measure(cycle.proofs[k]);
    if (std::isnan(here)) return k;
    if (!worst || here > measure(cycle.proofs[*worst])) worst = k;
  }
  return worst;
}

/// The largest of a measure over the positions, and where, when that is too large.
template <class Measure>
account::Verdict at_worst(const std::string& step, const char* symbol, Message meaning, const Cycle& cycle,
                          const Axis* axis, Measure measure) {
  const auto worst = worst_position(cycle, measure);
  const double off = worst ? measure(cycle.proofs[*worst]) : std::numeric_limits<double>::quiet_NaN();
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
  account::Verdict v;
  v.step = step;
  v.symbol = "trustworthy";
  v.meaning = say("motion and forces are proved: differences over the largest force times the condition number");
  v.bound = say("every position");
  v.value = say("{1} of {2}", std::to_string(closed - doubtful.size()), std::to_string(closed));
  v.state = closed == 0        ? account::State::not_available
            : doubtful.empty() ? account::State::pass
                               : account::State::fail;
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
      step, "motion", say("joints closed, velocities and accelerations as joints and drives allow: largest error"),
      cycle, axis, [](const mechanism::Proof& p) { return p.motion; }));
  for (const MethodText& text : method_texts()) {
    if (!driven && text.of_drives) continue;
    verdicts.push_back(at_worst(step, text.symbol, text.meaning, cycle, axis,
                                [&](const mechanism::Proof& p) { return p.part(text.method); }));
  }
  verdicts.push_back(trust(step, cycle, axis));
  return verdicts;
}

}  // namespace

std::vector<account::Verdict> proof(const std::string& step, const Mechanism::Input& in, const mechanism::Model& model,
                                    const Cycle& cycle, const Axis* axis) {
  Leftovers left;
  for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
    if (cycle.has_forces(k)) left.add(cycle.positions[k], cycle.proofs[k].residuals, !in.crank.joint.empty());
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto part = [&](double residual, double scale) { return left.any ? part_of(residual, scale) : none; };
  std::vector<account::Verdict> verdicts{closing(step, in, cycle, axis)};
  add_jamming(step, in, model, cycle, axis, verdicts);
  if (auto directed = direction_of_springs(step, in, cycle, axis)) verdicts.push_back(std::move(*directed));
  if (!cycle.returns) verdicts.push_back(no_return(step, in));
  for (const Cycle::Winding& winding : cycle.windings) verdicts.push_back(wound_up(step, in, winding));
  if (std::any_of(in.joints.begin(), in.joints.end(), [](const auto& j) { return only_pushes(j) || is_cam(j.type); })) {
    for (account::Verdict& v : contacts(step, in, model, cycle, axis)) verdicts.push_back(std::move(v));
    for (account::Verdict& v : profile_verdicts(step, model)) verdicts.push_back(std::move(v));
  }
  verdicts.push_back(limit(step, "force_balance",
                           say("equilibrium of every link: unbalanced force over the largest reaction"),
                           part(left.force, left.largest_force), 1e-9));
  verdicts.push_back(limit(step, "moment_balance", say("equilibrium of every link: unbalanced moment over the largest"),
                           part(left.moment, left.largest_moment), 1e-9));
  if (!in.crank.joint.empty() || !in.cylinders.empty()) {
    verdicts.push_back(limit(step, "power_balance",
                             say("power of drive, loads and weights against the change of kinetic energy"),
                             part(left.power, left.largest_power), 1e-9));
  }
  for (account::Verdict& v : methods(step, in, cycle, axis)) verdicts.push_back(std::move(v));
  return verdicts;
}

}  // namespace loadpath::planar
