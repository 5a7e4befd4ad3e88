#include "lib/project/references/stated/stated.hpp"

#include "lib/project/references/stated/conditions.hpp"
#include "lib/project/references/stated/moving_bodies.hpp"
#include "lib/project/references/stated/own_inputs.hpp"

namespace loadpath::project {

std::vector<ReducedLoad> values_not_taken(const Step& step, const Project& project) {
  if (step.input().calculator == nullptr || step.input().reading.record.data == nullptr) return {};
  std::vector<ReducedLoad> all = inputs_stated_otherwise(step, project);
  const std::vector<ReducedLoad> conditions = conditions_stated_only(step, project);
  all.insert(all.end(), conditions.begin(), conditions.end());
  const std::vector<ReducedLoad> bodies = bodies_stated_only(step, project);
  all.insert(all.end(), bodies.begin(), bodies.end());
  return all;
}

}  // namespace loadpath::project
