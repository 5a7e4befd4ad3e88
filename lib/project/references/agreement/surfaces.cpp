#include "lib/project/references/agreement/surfaces.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

/// The roughness R_z that a process leaves, coarse and fine work included: DIN 4766-1 (withdrawn), from memory.
struct Roughness {
  std::string_view finish;
  double least, most;  // m
};
constexpr std::array roughness_of_finish{Roughness{"ground", 0.0, 25e-6}, Roughness{"machined", 0.0, 250e-6},
                                         Roughness{"hot-rolled", 10e-6, 1e-3}, Roughness{"forged", 10e-6, 1e-3}};

/// The same of tooth flanks, from memory: shaved ones lie with the ground ones, and ground ones are not as rough as cut
/// ones.
constexpr std::array roughness_of_flanks{Roughness{"ground", 0.5e-6, 16e-6}, Roughness{"hobbed", 2.5e-6, 250e-6}};

void compare_roughness(const Step& step, const Project& project, const Roughness& process,
                       std::vector<ReducedLoad>& found) {
  for (const char* const key : {"R_z", "R_z1", "R_z2"}) {
    const double R_z = own_value(step, project, key);
    if (std::isnan(R_z) || (R_z >= process.least && R_z <= process.most)) continue;
    found.push_back(
        {key, say("{1} = {2} contradicts finish = \"{3}\", R_z = {4} to {5}: correct one of them, or because.{1} = "
                  "\"...\"",
                  key, format_quantity(R_z, "um", 4), std::string(process.finish),
                  format_quantity(process.least, "um", 3), format_quantity(process.most, "um", 3))});
  }
}

}  // namespace

std::vector<ReducedLoad> surfaces_of(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  if (!step.input().reading.typed.contains("finish")) return found;
  const Leaf finish = find_leaf(step.input().reading.record, "finish");
  if (!finish || finish.field->type != FieldInfo::Type::choice) return found;
  const std::span<const Roughness> processes = step.input().calculator->has_flanks
                                                   ? std::span<const Roughness>(roughness_of_flanks)
                                                   : std::span<const Roughness>(roughness_of_finish);
  for (const Roughness& process : processes) {
    if (word_of(finish) == process.finish) compare_roughness(step, project, process, found);
  }
  return found;
}

}  // namespace loadpath::project
