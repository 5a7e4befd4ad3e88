// Checks that no sizes of one part satisfy. Those of an element with a given size depend on this size and on those of
// its neighbours, and on more than two supports on all other sizes, through the reactions. One that fails with all
// sizes alike and with neighbours of all other sizes makes every further trial pointless.
#include "lib/account/rows.hpp"
#include "lib/project/run/search/joint_search.hpp"
#include "lib/project/run/search/shortfall.hpp"

#include <array>
#include <set>
#include <utility>
#include <vector>

namespace loadpath::project {

/// The checks and criteria of elements with given sizes that fail with the current sizes; a check without a value also
/// fails.
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

/// Sizes of which each second one is at a level and the others at another one: neighbours of a given size that differ.
std::vector<SizeIndices> JointSearch::alternating() {
  std::vector<SizeIndices> all;
  const std::vector<double> levels = sizes_.levels();
  if (sizes_.count() < 2 || levels.empty()) return all;
  const std::size_t last = levels.size() - 1;
  const std::array chosen{std::size_t{0}, last / 4, last / 2, last - last / 4, last};
  for (const std::size_t one : chosen) {
    for (const std::size_t other : chosen) {
      SizeIndices sizes = sizes_.alike(levels[one]);
      const SizeIndices others = sizes_.alike(levels[other]);
      for (std::size_t k = 1; k < sizes.size(); k += 2) sizes[k] = others[k];
      if (one != other && sizes_.set(sizes)) all.push_back(sizes_.now());
    }
  }
  return all;
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
  for (const SizeIndices& sizes : alternating()) {
    const std::set<Row> failed = failed_with(sizes);
    std::erase_if(barred, [&](const Row& row) { return !failed.contains(row); });
  }
  if (barred.empty()) return false;
  barred_.merge(std::move(barred));
  return true;
}

/// No size has a value: reports the checks that bar them, and the sizes that pass all others.
void JointSearch::leave_barred(std::vector<Issue>& issues) {
  SizeIndices largest(sizes_.count(), 0), others = largest;
  if (!set_largest(largest)) return issues.push_back(no_sizes());
  if (!in_words_) return leave_open(largest);  // a point of a sweep
  const std::set<Row> barred = barred_;
  for (const Row& row : barred) passing_.excuse(row);
  forget();
  if (find_cheapest(others) || (excuse_unmoved() && find_cheapest(others))) return leave_unfit(others);
  for (const Row& row : barred) passing_.count_again(row);
  leave_open(largest);
}

}  // namespace loadpath::project
