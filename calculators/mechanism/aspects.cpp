#include "calculators/mechanism/aspects.hpp"

#include <algorithm>
#include <array>

namespace loadpath::planar {

// One line per aspect, in the order of reports.
// clang-format off
static constexpr std::array list{
    &aspects::drawn,
    &aspects::masses,
    &aspects::details,
    &aspects::closing,
    &aspects::equilibrium,
    &aspects::contact,
    &aspects::courses,
    &aspects::drives,
    &aspects::drive_wheels,
    &aspects::reactions,
    &aspects::pins,
    &aspects::shafts,
    &aspects::places,
    &aspects::members,
    &aspects::contacts,
    &aspects::cams,
    &aspects::machine,
    &aspects::springs,
    &aspects::cylinders,
    &aspects::kinematics,
    &aspects::transmission,
    &aspects::equations,
    &aspects::extremes,
    &aspects::power,
    &aspects::rest,
    &aspects::efficiency,
    &aspects::flanks,
    &aspects::structure,
    &aspects::redundancy,
    &aspects::resolution,
    &aspects::changes_of_assembly,
    &aspects::motion,
    &aspects::influence,
    &aspects::accuracy,
    &aspects::balance,
    &aspects::figures,
    &aspects::hodographs,
};
// clang-format on

std::span<const Aspect* const> all_aspects() { return list; }

std::vector<Output> outputs_of(const Mechanism::Input& in, const mechanism::Model& model) {
  std::vector<Output> out;
  ask_all(&Aspect::add_outputs, in, model, out);
  std::stable_partition(out.begin(), out.end(), [](const Output& o) { return o.read_results == nullptr; });
  return out;
}

std::vector<ResultPattern> result_patterns() {
  std::vector<ResultPattern> patterns;
  ask_all(&Aspect::list, patterns);
  return patterns;
}

std::vector<std::string> occasional_sources() {
  std::vector<std::string> keys;
  for (const Aspect* aspect : all_aspects()) {
    for (const Citation& citation : aspect->citations) keys.emplace_back(citation.key);
  }
  return keys;
}

std::vector<std::string> sources_used(const Mechanism::Input& in, const mechanism::Structure& structure) {
  std::vector<std::string> keys;
  for (const Aspect* aspect : all_aspects()) {
    for (const Citation& citation : aspect->citations) {
      if (citation.used(in, structure)) keys.emplace_back(citation.key);
    }
  }
  return keys;
}

}  // namespace loadpath::planar
