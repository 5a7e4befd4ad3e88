#include "lib/project/references/drives/drives.hpp"

#include "lib/project/references/drives/efficiencies.hpp"
#include "lib/project/references/drives/elements.hpp"
#include "lib/project/references/drives/formulas.hpp"
#include "lib/project/references/drives/one_drive.hpp"
#include "lib/project/references/drives/own_names.hpp"
#include "lib/project/references/drives/stages.hpp"
#include "lib/project/references/drives/stated_loads.hpp"
#include "lib/project/references/drives/taken_powers.hpp"

namespace loadpath::project {

std::vector<ReducedLoad> values_of_drives(const Step& step, const Project& project) {
  std::vector<ReducedLoad> all;
  for (const auto& found :
       {ratios_of_stages(step, project), loads_stated_otherwise(step, project), factors_cancelled(step, project),
        loads_of_unloaded_gears(step, project), powers_of_torques(step, project), values_in_part(step, project),
        parts_of_formulas(step, project), torques_at_other_speeds(step, project), hands_in_disagreement(step, project),
        speeds_of_taken_powers(step, project), torques_of_faster_shafts(step, project),
        efficiencies_of_outputs(step, project), torques_of_other_elements(step, project)})
    all.insert(all.end(), found.begin(), found.end());
  return all;
}

}  // namespace loadpath::project
