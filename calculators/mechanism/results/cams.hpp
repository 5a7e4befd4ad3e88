// What a mechanism with cams gives beside what every joint gives: results, verdicts, rows of tables.
#pragma once

#include "calculators/mechanism/results/output.hpp"
#include "calculators/mechanism/words/mechanism.hpp"
#include "lib/account/block.hpp"

#include <string>
#include <vector>

namespace loadpath::planar {

void add_cam_outputs(const mechanism::Model& model, std::vector<Output>& out);
void list_cam_patterns(std::vector<ResultPattern>& patterns);

/// That the profile can be made, and the roller reaches all of it.
std::vector<account::Verdict> profile_verdicts(const std::string& step, const mechanism::Model& model);

/// The joints whose roller turns freely: no force depends on that freedom, and mobility does not count it.
std::vector<std::string> passive_freedoms(const mechanism::Model& model);

}  // namespace loadpath::planar
