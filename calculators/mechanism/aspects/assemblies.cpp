#include "calculators/mechanism/aspects/assemblies.hpp"

#include "lib/mechanism/groups/assemblies.hpp"

#include <algorithm>
#include <string_view>

namespace loadpath::planar {

namespace {

using mechanism::Assembly;

bool has(const Assembly& assembly, std::string_view side) {
  return std::find(assembly.sides.begin(), assembly.sides.end(), side) != assembly.sides.end();
}

std::vector<std::string> all_sides(const std::vector<Assembly>& list) {
  std::vector<std::string> sides;
  for (const Assembly& a : list) {
    for (const std::string& side : a.sides) {
      if (std::find(sides.begin(), sides.end(), side) == sides.end()) sides.push_back(side);
    }
  }
  return sides;
}

std::string listed(const std::vector<Assembly>& list) {
  std::string names;
  for (const Assembly& a : list) names += (names.empty() ? "" : "; ") + a.name();
  return names;
}

/// The assembly with all the named sides that keeps most of the stated ones.
const Assembly* best(const std::vector<Assembly>& list, const Mechanism::Input& in) {
  const Assembly* chosen = nullptr;
  std::ptrdiff_t most = -1;
  for (const Assembly& a : list) {
    const bool fits =
        std::all_of(in.sides.begin(), in.sides.end(), [&](const auto& s) { return has(a, s.side.view()); });
    const auto kept =
        std::count_if(list[0].sides.begin(), list[0].sides.end(), [&](const auto& s) { return has(a, s); });
    if (!fits || kept <= most) continue;
    chosen = &a;
    most = kept;
  }
  return chosen;
}

}  // namespace

std::vector<FieldFault> choose_assembly(const Mechanism::Input& in, const mechanism::Structure& structure,
                                        mechanism::Model& model) {
  if (in.sides.empty()) return {};
  if (!structure.redundant.empty())
    return {{"sides",
             say("assembly modes do not apply with redundant constraints: {1}",
                 names_of(model.joints, structure.redundant[0])),
             say("state the approximate position and angle of the links, or draw them")}};
  const auto list = mechanism::assemblies(model).list;
  const auto sides = all_sides(list);
  std::vector<FieldFault> faults;
  for (const auto& s : in.sides) {
    if (std::find(sides.begin(), sides.end(), s.side.view()) != sides.end()) continue;
    faults.push_back({"sides", say("no group has the side '{1}'", s.side.view()),
                      did_you_mean(s.side.view(), sides, there_is(sides))});
  }
  if (!faults.empty()) return faults;
  const Assembly* chosen = best(list, in);
  if (chosen == nullptr)
    return {{"sides", say("no assembly has all these sides"), say("available: {1}", listed(list))}};
  for (std::size_t k = 0; k < model.links.size(); ++k) model.links[k].pose = chosen->poses[k];
  return {};
}

}  // namespace loadpath::planar
