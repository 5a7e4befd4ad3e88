// The limit of the transmission angle: below it, a dyad moves its output with large forces, or jams.
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/mechanism/groups/closing.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace loadpath::planar {

namespace {

using mechanism::DyadClosing;

/// That of the joint, else that of the mechanism; unset if there is none.
double required_of(const Mechanism::Input& in, std::size_t joint) {
  const double own = in.joints[joint].gamma_min;
  return is_set(own) ? own : in.gamma_min;
}

bool is_limited(const Mechanism::Input& in) {
  return is_set(in.gamma_min) || std::any_of(in.joints.begin(), in.joints.end(),
                                             [](const planar::Joint& joint) { return is_set(joint.gamma_min); });
}

std::vector<DyadClosing> dyads_of(const mechanism::Model& model) { return dyad_closings(model, plan_of(model)); }

struct Least {
  double gamma = std::numeric_limits<double>::infinity();
  std::size_t at = 0;
};

/// None if no position closes.
std::optional<Least> least_of(const Solved& solved, const DyadClosing& dyad) {
  Least least;
  const Cycle& cycle = solved.proved;
  for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
    if (!cycle.closed[k]) continue;
    const double gamma = transmission_angle(closing_angle(solved.given, dyad, cycle.positions[k].pose));
    if (gamma < least.gamma) least = {gamma, k};
  }
  return least.gamma <= 0.5 * pi ? std::optional(least) : std::nullopt;
}

void judge_transmission(const Solved& solved, std::vector<account::Verdict>& verdicts) {
  if (!is_limited(solved.in)) return;
  for (const DyadClosing& dyad : dyads_of(solved.given)) {
    const double required = required_of(solved.in, dyad.joint);
    const auto least = is_set(required) ? least_of(solved, dyad) : std::nullopt;
    if (!least) continue;
    const std::string& joint = solved.given.joints[dyad.joint].name;
    const std::string gamma = format_quantity(least->gamma, "deg", 4);
    const Axis* const axis = solved.axis;
    verdicts.push_back({.step = solved.step,
                        .symbol = "transmission_" + joint,
                        .meaning = say("minimum transmission angle, joint '{1}'", joint),
                        .value = account::Quantity{least->gamma, "deg"},
                        .bound = say("at least {1}", format_quantity(required, "deg")),
                        .state = account::pass_if(least->gamma >= required * (1.0 - 1e-9)),
                        .note = axis == nullptr
                                    ? say("{1}", gamma)
                                    : say("{1} at {2} ({3})", gamma,
                                          format_quantity(axis->at[least->at], axis->unit, 5), axis->name())});
  }
}

/// The joints that have a transmission angle: "'B', 'D'".
std::string inner_joints(const mechanism::Model& model, const std::vector<DyadClosing>& dyads) {
  std::vector<std::size_t> joints;
  joints.reserve(dyads.size());
  for (const DyadClosing& dyad : dyads) joints.push_back(dyad.joint);
  return mechanism::names_of(model.joints, joints);
}

/// A limit of what has no transmission angle would judge nothing.
void check_limits(const Mechanism::Input& in, const mechanism::Model& model, const mechanism::Structure& structure,
                  std::vector<FieldFault>& faults) {
  if (!is_limited(in) || !structure.closes) return;
  const bool redundant = !structure.redundant.empty();
  const auto dyads = redundant ? std::vector<DyadClosing>{} : dyads_of(model);
  const auto check = [&](const std::string& path, const Message& none) {
    if (redundant) {
      faults.push_back({path, say("transmission angles do not apply with redundant constraints"),
                        say("leave out 'gamma_min' or one of the redundant joints: {1}",
                            names_of(model.joints, structure.redundant[0]))});
    } else {
      faults.push_back({path, none,
                        dyads.empty() ? say("leave it out")
                                      : say("joints with a transmission angle: {1}", inner_joints(model, dyads))});
    }
  };
  if (is_set(in.gamma_min) && dyads.empty())
    check("gamma_min", say("no joint of the mechanism has a transmission angle"));
  for (std::size_t n = 0; n < in.joints.size(); ++n) {
    const bool has = std::any_of(dyads.begin(), dyads.end(), [&](const auto& dyad) { return dyad.joint == n; });
    if (!is_set(in.joints[n].gamma_min) || has) continue;
    check(path_of("joints", in.joints[n].name, "gamma_min"),
          say("joint '{1}' has no transmission angle: it is not the inner joint of a dyad", model.joints[n].name));
  }
}

}  // namespace

constinit const Aspect aspects::transmission{.check_structure = &check_limits, .judge = &judge_transmission};

}  // namespace loadpath::planar
