#include "lib/project/references/stated/stated.hpp"

#include "lib/project/references/stated/columns.hpp"
#include "lib/project/references/stated/combinations.hpp"
#include "lib/project/references/stated/conditions.hpp"
#include "lib/project/references/stated/mates.hpp"
#include "lib/project/references/stated/moving_bodies.hpp"
#include "lib/project/references/stated/own_inputs.hpp"
#include "lib/project/references/stated/qualified.hpp"
#include "lib/project/references/stated/requirements.hpp"
#include "lib/project/references/stated/results.hpp"
#include "lib/project/references/stated/rows.hpp"
#include "lib/project/references/stated/sizes_of_parts.hpp"

namespace loadpath::project {

std::vector<ReducedLoad> values_not_taken(const Step& step, const Project& project) {
  std::vector<ReducedLoad> all;
  for (const auto& found :
       {inputs_stated_otherwise(step, project), conditions_stated_only(step, project),
        bodies_stated_only(step, project), columns_stated_otherwise(step, project), bars_in_tension(step, project),
        eccentric_links(step, project), results_stated_otherwise(step, project), mates_stated_otherwise(step, project),
        requirements_stated_otherwise(step, project), rows_stated_otherwise(step, project),
        symbols_stated_otherwise(step, project), sizes_of_parts_stated(step, project),
        values_left_out_of_loads(step, project)})
    all.insert(all.end(), found.begin(), found.end());
  return all;
}

}  // namespace loadpath::project
