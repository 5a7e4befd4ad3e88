#include "lib/report/conclusion.hpp"

#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::report {

Message tally(const Verdicts& verdicts) {
  const auto& rows = verdicts.rows;
  const State state = worst(rows);
  const auto such = std::count_if(rows.begin(), rows.end(), [&](const Verdict& row) { return row.state == state; });
  const std::string all = std::to_string(rows.size()), some = std::to_string(such);
  switch (state) {
    case State::pass:
      return rows.size() == 1 ? say("The one check passes.") : say("All {1} checks pass.", all);
    case State::fail:
      return say("{1} of {2} checks not met.", some, all);
    case State::not_covered:
      return say("{1} of {2} checks outside of what the method covers.", some, all);
    case State::not_available:
      return say("{1} of {2} checks without a result.", some, all);
  }
  return {};
}

const Verdict* most_utilised(const Verdicts& verdicts) {
  const auto highest = std::max_element(
      verdicts.rows.begin(), verdicts.rows.end(),
      [](const Verdict& a, const Verdict& b) { return a.utilisation.value_or(-1.0) < b.utilisation.value_or(-1.0); });
  return highest != verdicts.rows.end() && highest->utilisation ? &*highest : nullptr;
}

Message utilisation(const Verdict& row) {
  return say("The highest utilisation is {1}:", format_number(row.utilisation.value_or(NAN), 3));
}

std::string Numbering::heading(int level) {
  if (level <= 2) {
    parts_ = 0;
    return std::to_string(++sections_);
  }
  return std::to_string(sections_) + "." + std::to_string(++parts_);
}

}  // namespace loadpath::report
