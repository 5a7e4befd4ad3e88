#include "calculators/mechanism/results/modes.hpp"

#include "calculators/mechanism/input/names.hpp"
#include "lib/project/modes.hpp"

#include <algorithm>
#include <initializer_list>
#include <set>
#include <string>

namespace loadpath::planar {

namespace {

/// Whether another step takes one of these results, all that begin so: "press.links.rod.N".
bool is_taken(const std::set<std::string>& taken, const std::string& of, std::initializer_list<const char*> loads) {
  return std::any_of(loads.begin(), loads.end(), [&](const char* load) {
    const auto next = taken.lower_bound(of + "." + load);
    return next != taken.end() && next->starts_with(of + "." + load);
  });
}

/// The links, joints and cylinders whose loads go nowhere: "rod, A, B".
std::string left_alone(const std::string& step, const Mechanism::Input& in, const std::set<std::string>& taken) {
  std::string names;
  const auto add = [&](const char* kind, std::string_view name, std::initializer_list<const char*> loads) {
    if (!is_taken(taken, step + "." + kind + "." + std::string(name), loads))
      names += (names.empty() ? "" : ", ") + std::string(name);
  };
  std::set<std::string_view> parts;  // parts of cylinders, which are designed for their force
  for (const Mechanism::Actuator& actuator : in.actuators) {
    if (!actuator.between_points) continue;
    add("cylinders", actuator.name.view(), {"F"});
    const Joint& bore = *find_named(in.joints, actuator.joint);
    parts.insert({bore.links.first.view(), bore.links.second.view(), bore.name.view()});
  }
  for (const Link& link : in.links) {
    if (!parts.contains(link.name.view())) add("links", link.name.view(), {"N", "V", "M_b"});
  }
  for (const Joint& joint : in.joints) {
    if (!parts.contains(joint.name.view())) add("joints", joint.name.view(), {"F", "x", "y", "N", "M"});
  }
  return names;
}

}  // namespace

account::Modes modes_of(const project::Step& step, const Mechanism::Input& in, const project::Wanted& wanted) {
  account::Modes modes;
  for (const auto& mode : Mechanism::modes) {
    const auto rows = project::rows_of(mode, step.account().verdicts);
    if (rows.empty() && *mode.checks != '\0') continue;
    auto judged = project::judged(step, mode, mode.applies(in), rows);
    if (!judged) continue;
    if (judged->id == "strength") {
      const std::string left = left_alone(step.name(), in, wanted.taken);
      if (left.empty()) continue;
      if (judged->state == account::State::open) judged->note = say("taken by no step: {1}", left);
    }
    modes.push_back(std::move(*judged));
  }
  return modes;
}

}  // namespace loadpath::planar
