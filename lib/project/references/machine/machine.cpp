#include "lib/project/references/machine/machine.hpp"

#include "lib/project/references/actions/partial_factors.hpp"
#include "lib/project/references/agreement/agreement.hpp"
#include "lib/project/references/drives/drives.hpp"
#include "lib/project/references/drives/lives.hpp"
#include "lib/project/references/machine/chained_drives.hpp"
#include "lib/project/references/machine/idle_steps.hpp"
#include "lib/project/references/machine/left_out.hpp"
#include "lib/project/references/machine/middles.hpp"
#include "lib/project/references/machine/of_mechanism.hpp"
#include "lib/project/references/machine/other_steps.hpp"
#include "lib/project/references/machine/ratings.hpp"
#include "lib/project/references/machine/repetitions.hpp"
#include "lib/project/references/machine/same_part.hpp"
#include "lib/project/references/machine/seats.hpp"
#include "lib/project/references/machine/unlinked.hpp"
#include "lib/project/references/machine/vessels.hpp"
#include "lib/project/references/reasons.hpp"
#include "lib/project/references/space/clearances.hpp"
#include "lib/project/references/space/lubrication.hpp"
#include "lib/project/references/space/seat_notches.hpp"
#include "lib/project/references/stated/stated.hpp"
#include "lib/project/references/titles/titles.hpp"

namespace loadpath::project {

std::vector<ReducedLoad> stated_and_not_taken(const Step& step, const Project& project) {
  std::vector<ReducedLoad> all;
  for (const auto& found :
       {loads_left_out(step, project), loads_of_mechanism(step, project), repetitions_of_others(step, project),
        values_of_idle_steps(step, project), values_of_drives(step, project), values_not_taken(step, project),
        partial_factors_of_loads(step, project)})
    all.insert(all.end(), found.begin(), found.end());
  return all;
}

std::vector<ReducedLoad> contradictions(const Step& step, const Project& project) {
  std::vector<ReducedLoad> all;
  for (const auto& found :
       {values_of_runs(step, project), factors_of_takers(step, project), lives_on_shaft(step, project),
        values_of_ratings(step, project), values_at_middle(step), values_of_same_part(step, project),
        powers_of_chained(step, project), values_of_seats(step, project), values_of_unlinked(step, project),
        values_of_vessels(step, project), values_in_disagreement(step, project), values_in_collision(step, project),
        lubrication_of_others(step, project), strengths_out_of_proportion(step, project),
        notches_of_seats(step, project), titles_of_other_loads(step, project), titles_of_other_choices(step, project),
        stated_and_not_taken(step, project)})
    all.insert(all.end(), found.begin(), found.end());
  return all;
}

void check_machine(Step& step, const Project& project) {
  if (!step.contradictions()) step.set_contradictions(contradictions(step, project));
  hold_unless_justified(step, *step.contradictions());
}

bool hand_out_contradictions(Project& project) {
  bool changed = false;
  for (const auto& step : project.steps) {
    std::vector<ReducedLoad> now = contradictions(*step, project);
    if (step->contradictions() == now) continue;
    step->set_contradictions(std::move(now));
    changed = true;
  }
  return changed;
}

}  // namespace loadpath::project
