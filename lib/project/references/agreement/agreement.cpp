#include "lib/project/references/agreement/agreement.hpp"

#include "lib/project/references/agreement/column_lengths.hpp"
#include "lib/project/references/agreement/drive_lines.hpp"
#include "lib/project/references/agreement/ends.hpp"
#include "lib/project/references/agreement/excitations.hpp"
#include "lib/project/references/agreement/lugs.hpp"
#include "lib/project/references/agreement/sizes.hpp"
#include "lib/project/references/agreement/stated_motors.hpp"
#include "lib/project/references/agreement/stated_values.hpp"
#include "lib/project/references/agreement/surfaces.hpp"
#include "lib/project/references/agreement/torques.hpp"
#include "lib/project/references/agreement/trains.hpp"

namespace loadpath::project {

std::vector<ReducedLoad> statements_in_disagreement(const Step& step, const Project& project) {
  std::vector<ReducedLoad> all;
  for (const auto& found :
       {values_stated_only(step, project), motors_stated_only(step, project), lengths_of_columns(step, project),
        stages_of_trains(step, project), forces_across_lugs(step, project), factors_of_torque(step, project)})
    all.insert(all.end(), found.begin(), found.end());
  return all;
}

std::vector<ReducedLoad> values_in_disagreement(const Step& step, const Project& project) {
  std::vector<ReducedLoad> all;
  for (const auto& found :
       {torques_of_line(step, project), ends_of_vessel(step, project), surfaces_of(step, project),
        excitations_of(step, project), sizes_in_disagreement(step, project), statements_in_disagreement(step, project)})
    all.insert(all.end(), found.begin(), found.end());
  return all;
}

}  // namespace loadpath::project
