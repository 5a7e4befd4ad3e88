// Checks that no sizes of one part satisfy: those of an element whose size is given depend on that size and on those of
// its neighbours alone. One that fails whatever size the neighbours have makes every further trial pointless.
#include "lib/account/rows.hpp"
#include "lib/project/run/search/joint_search.hpp"
#include "lib/project/run/search/shortfall.hpp"

#include <set>
#include <utility>
#include <vector>

namespace loadpath::project {

/// The checks and criteria of elements with given sizes that fail with the current sizes; of a part without a value
/// they fail, too.
std::set<Row> JointSearch::failed_at_given_places() {
  std::set<Row> failed;
  void* const result = evaluation_.result().data.get();
  for (std::size_t i = 0; i < evaluation_.positions(); ++i) {
    if (!evaluation_.evaluate_at(i)) continue;
    for (const FieldInfo& list : evaluation_.calculator().result->fields) {
      if (list.type != FieldInfo::Type::list) continue;
      for (std::size_t k = 0; k < list.size(result); ++k) {
        if (!sizes_.is_given_place(list, list.element(result, k))) continue;
        for (const FieldInfo& row : list.fields) {
          const bool decides = is_failure(row) && passing_.counts({&row, k});
          if (decides && !account::is_kept(row, row.get(list.element(result, k)))) failed.insert({&row, k});
        }
      }
    }
  }
  return failed;
}

/// Whether one of them fails with all sizes, from the smallest to the largest, in this arrangement: coarsely first, for
/// most pass with some. Sizes outside the rules count as well, because other sizes of distant elements may be within.
bool JointSearch::find_barred() {
  std::vector<SizeIndices> within, outside;
  last_.reset();
  for (const double level : sizes_.levels()) {
    if (!sizes_.set(sizes_.alike(level))) continue;
    (passing_.breaks_rule_without_table() ? outside : within).push_back(sizes_.now());
  }
  if (within.empty()) return false;
  within.insert(within.end(), outside.begin(), outside.end());
  const auto failed_with = [&](const SizeIndices& sizes) {
    sizes_.set(sizes);
    settle();
    return failed_at_given_places();
  };
  std::set<Row> barred = failed_with(within.front());
  for (const std::size_t step : {std::size_t{16}, std::size_t{4}, std::size_t{1}}) {
    for (std::size_t i = 0; i < within.size() && !barred.empty(); i += step) {
      const std::set<Row> failed = failed_with(within[i]);
      std::erase_if(barred, [&](const Row& row) { return !failed.contains(row); });
    }
  }
  if (barred.empty()) return false;
  barred_.merge(std::move(barred));
  return true;
}

/// None has a value. Reports what bars them, and the sizes that pass all other checks.
void JointSearch::leave_barred(std::vector<Issue>& issues) {
  SizeIndices largest(sizes_.count(), 0), others = largest;
  if (!set_largest(largest)) return issues.push_back(no_sizes());
  if (!in_words_) return leave_open(largest);  // a point of a sweep
  for (const Row& row : barred_) passing_.excuse(row);
  forget();
  if (find_cheapest(others)) return leave_unfit(others);
  leave_open(largest);
}

}  // namespace loadpath::project
