#include "lib/project/references/drives/drives.hpp"

#include "lib/project/references/drives/stages.hpp"

namespace loadpath::project {

std::vector<ReducedLoad> values_of_drives(const Step& step, const Project& project) {
  if (step.input().calculator == nullptr || step.input().reading.record.data == nullptr) return {};
  return ratios_of_stages(step, project);
}

}  // namespace loadpath::project
