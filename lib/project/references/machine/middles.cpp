#include "lib/project/references/machine/middles.hpp"

namespace loadpath::project {

std::vector<ReducedLoad> values_at_middle(const Step& step) {
  std::vector<ReducedLoad> middles;
  for (const auto& [path, typed] : step.input().reading.typed) {
    if (!typed.mean_of_uncertain) continue;
    middles.push_back({path, say("{1} is uncertain, and a run takes its middle value: use `loadpath sweep`, or "
                                 "because.{1} = \"...\"",
                                 path)});
  }
  return middles;
}

}  // namespace loadpath::project
