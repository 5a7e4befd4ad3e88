// The groups that a mechanism is built of, and how well the equations determine it.
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/mechanism/structure/assur.hpp"
#include "lib/mechanism/studies/group_jacobian.hpp"
#include "lib/numerics/magnitude.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace loadpath::planar {

namespace {

using account::Quantity;
using account::Table;

/// "2 · 3 + 0 = 6": what the joints take away from the links of a group.
std::string count_of(const mechanism::Group& group) {
  const auto drives = group.drivers.size();
  return std::to_string(3 * group.links.size()) + " = 2 · " + std::to_string(group.p5) + " + " +
         std::to_string(group.p4) + (drives == 0 ? "" : " + " + std::to_string(drives));
}

template <class Parts>
std::string listed(const Parts& parts, const std::vector<std::size_t>& chosen) {
  std::string names;
  for (const std::size_t k : chosen) names += (names.empty() ? "" : ", ") + parts[k].name;
  return names;
}

/// "two-link group", as [D3] names the groups.
Message size_of(const mechanism::Group& group) {
  static constexpr std::array counts{"",      "one",   "two",  "three", "four",   "five",  "six",
                                     "seven", "eight", "nine", "ten",   "eleven", "twelve"};
  const std::size_t links = group.links.size();
  return say("{1}-link group", links < counts.size() ? counts[links] : std::to_string(links));
}

Message kind_of(const mechanism::Group& group) {
  static constexpr std::array roman{"", "I", "II", "III", "IV", "V", "VI", "VII", "VIII"};
  if (group.contour_class == 1) return say("initial link");
  const auto k = static_cast<std::size_t>(group.contour_class);
  const std::string number = k < roman.size() ? roman[k] : std::to_string(k);
  const Message named = say("{1}, class {2}, order {3}", size_of(group), number, std::to_string(group.order));
  return group.kind.empty() ? named : say("{1}, {2}", named, group.kind);
}

Table structure_table(const mechanism::Model& model, bool released) {
  Table table{released ? say("Structure without redundant constraints: groups in order of attachment, 3 n = 2 p5 + "
                             "p4 + drives")
                       : say("Structural (Assur) groups in order of assembly, 3 n = 2 p5 + p4 + drives"),
              {say("links"), say("joints"), say("kind"), say("count")},
              {}};
  for (const mechanism::Group& group : mechanism::groups(model)) {
    table.rows.push_back(
        {listed(model.links, group.links), listed(model.joints, group.joints), kind_of(group), count_of(group)});
  }
  return table;
}

/// The joints whose roller turns freely: no force depends on that freedom, and mobility does not count it.
std::vector<std::string> passive_freedoms(const mechanism::Model& model) {
  std::vector<std::string> names;
  for (const mechanism::Joint& joint : model.joints) {
    const bool rolls = joint.kind == mechanism::JointKind::cam && joint.contact == mechanism::CamContact::round &&
                       joint.radius_i > 0.0;
    if (rolls) names.push_back(joint.name);
  }
  return names;
}

/// The smallest magnitude of a Jacobian, the first position that has it, and the largest.
struct Range {
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  std::size_t at = 0;
};

/// Of each group over the positions that close.
std::vector<Range> ranges_of(mechanism::GroupJacobians& jacobians, const Cycle& cycle) {
  std::vector<Range> ranges(jacobians.plan().groups.size());
  for (std::size_t k = 0; k < cycle.positions.size(); ++k) {
    if (!cycle.closed[k]) continue;
    jacobians.take(cycle.positions[k].pose);
    for (std::size_t g = 0; g < ranges.size(); ++g) {
      const double size = jacobians.magnitude(g);
      if (numerics::exceeds(ranges[g].least, size)) ranges[g] = {size, ranges[g].most, k};
      if (numerics::exceeds(size, ranges[g].most)) ranges[g].most = size;
    }
  }
  return ranges;
}

std::string metres_text(int metres) {
  if (metres == 0) return "-";
  return metres == 1 ? "m" : "m^" + std::to_string(metres);
}

/// A reaction of the group is large where its Jacobian is small, in proportion.
void add_jacobians(const mechanism::Model& model, const Cycle& cycle, const Axis* axis, Table& table) {
  mechanism::GroupJacobians jacobians(model);
  const std::vector<Range> ranges = ranges_of(jacobians, cycle);
  const std::vector<mechanism::Group> groups = mechanism::groups(model);
  for (std::size_t g = 0; g < ranges.size(); ++g) {
    const Range& range = ranges[g];
    if (jacobians.plan().groups[g].unknowns.empty() || !std::isfinite(range.least)) continue;
    const std::string links = listed(model.links, groups[g].links);
    const bool varies = axis != nullptr && numerics::exceeds(range.most, range.least);
    table.rows.push_back({varies ? say("minimum Jacobian determinant of the group {1}, magnitude, at {2}", links,
                                       format_quantity(axis->at[range.at], axis->unit, 5))
                                 : say("Jacobian determinant of the group {1}, magnitude", links),
                          Quantity{range.least, metres_text(jacobians.metres(g)), 6}});
  }
}

Table determinacy_table(const mechanism::Model& model, const mechanism::Structure& structure, const Cycle& cycle,
                        const Axis* axis) {
  Table table{say("Mobility and conditioning"), {}, {}};
  table.rows.push_back(
      {say("mobility by count, 3 n − 2 p5 − p4; drives not counted"), std::to_string(structure.mobility_by_count)});
  table.rows.push_back({say("mobility by rank of the constraints"), std::to_string(structure.mobility)});
  for (const std::string& name : passive_freedoms(model)) {
    table.rows.push_back(
        {say("passive freedom, not counted: the roller of '{1}' turns freely", name), std::string("1")});
  }
  const auto steps = std::count(cycle.in_steps.begin(), cycle.in_steps.end(), true);
  if (steps > 0 && axis != nullptr) {
    const auto first = std::find(cycle.in_steps.begin(), cycle.in_steps.end(), true) - cycle.in_steps.begin();
    table.rows.push_back({say("positions that were followed in small steps; first at {1}",
                              format_quantity(axis->at[static_cast<std::size_t>(first)], axis->unit, 5)),
                          std::to_string(steps)});
  }
  if (cycle.worst_condition == 0.0) return table;
  const Message largest = say("maximum condition number of constraints and drives, 1-norm");
  table.rows.push_back({axis == nullptr
                            ? largest
                            : say("{1}, at {2}", largest, format_quantity(axis->at[cycle.worst_at], axis->unit, 5)),
                        Quantity{cycle.worst_condition, "-", 2}});
  add_jacobians(model, cycle, axis, table);
  return table;
}

void show_structure(const Solved& solved, const Results&, std::vector<account::Block>& blocks) {
  blocks.emplace_back(structure_table(solved.model, !solved.cycle.unique.empty()));
  blocks.emplace_back(determinacy_table(solved.model, solved.structure, solved.cycle, solved.axis));
}

}  // namespace

constinit const Aspect aspects::structure{.show = &show_structure};

}  // namespace loadpath::planar
