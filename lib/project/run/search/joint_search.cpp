#include "lib/project/run/search/joint_search.hpp"

#include "lib/numerics/magnitude.hpp"
#include "lib/project/run/search/remarks.hpp"
#include "lib/project/run/search/shortfall.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace loadpath::project {

bool JointSearch::passes() {
  if (!sizes_.is_sound()) return false;
  SizeIndices sizes = sizes_.now();
  if (last_ && last_->sizes == sizes) return last_->pass;
  if (failed_.contains(sizes)) return false;
  const bool pass = passing_.passes_again();
  last_.reset();
  if (!evaluation_.is_settled()) return pass;
  if (!pass) failed_.insert(sizes);
  last_ = Evaluated{std::move(sizes), pass};
  return pass;
}

/// All alike, or where given diameters limit some of them, these as large as they may be.
bool JointSearch::find_start(SizeIndices& least) { return find_alike(least) || (sizes_.cap() && find_alike(least)); }

/// From the middle of the stocks in wide steps, down while they pass or up until they do; then one by one.
bool JointSearch::find_alike(SizeIndices& least) {
  const std::vector<double> levels = sizes_.levels();
  const auto fits = [&](std::size_t level) {
    least = sizes_.first_from(levels[level]);
    return passes_with(least);
  };
  constexpr std::size_t stride = 8;
  std::size_t level = levels.size() / 2;
  if (fits(level)) {
    while (level >= stride && fits(level - stride)) level -= stride;
  } else {
    do level += stride;
    while (level < levels.size() && !fits(level));
  }
  if (level >= levels.size()) {  // perhaps there are too large ones among them
    level = 0;
    while (level < levels.size() && !fits(level)) ++level;
    return level < levels.size();
  }
  for (std::size_t step = stride / 2; step > 0; step /= 2) {
    if (level >= step && fits(level - step)) level -= step;
  }
  return fits(level);
}

/// Lowers one as far as everything holds, in steps of four sizes and then of one; whether it went down.
bool JointSearch::lower_one(SizeIndices& least, std::size_t which) {
  const std::size_t before = least[which];
  sizes_.set(least);
  const SizeIndices laid = sizes_.now();
  const auto lowers_to = [&](std::size_t lower) {
    SizeIndices lowered = least;
    lowered[which] = lower;
    if (!sizes_.set(lowered) || (sizes_.now() != laid && (lower == 0 || !passes()))) return false;
    least = std::move(lowered);
    return true;
  };
  if (lowers_to(0)) return before > 0;  // its neighbours hold it up
  for (const std::size_t step : {std::size_t{4}, std::size_t{1}}) {
    while (least[which] >= step && lowers_to(least[which] - step)) {
    }
  }
  return least[which] < before;
}

void JointSearch::lower(SizeIndices& least) {
  for (bool lowered = true; lowered;) {
    sizes_.set(least);
    lowered = false;
    for (const std::size_t which : sizes_.largest_first()) lowered = lower_one(least, which) || lowered;
  }
  lower_alone(least);
  sizes_.set(least);
  settle();
}

/// Each with the others unchanged: a size lowered together with it may be the one that failed.
void JointSearch::lower_alone(SizeIndices& least) {
  for (bool lowered = true; lowered;) {
    sizes_.set(least);
    least = sizes_.now();
    lowered = false;
    for (const std::size_t which : sizes_.largest_first()) {
      while (sizes_.is_first(which) && sizes_.set_smaller(least, which) && passes()) {
        least = sizes_.now();
        lowered = true;
      }
    }
  }
}

/// Whether the checks at the places of one of them, and of those of equal size, pass with the others unchanged.
bool JointSearch::places_pass(std::size_t first) {
  SizeIndices key = sizes_.now();
  key.push_back(first);
  const auto known = places_.find(key);
  if (known != places_.end()) return known->second;
  const bool pass = places_pass_now(first);
  if (evaluation_.is_settled()) places_.emplace(std::move(key), pass);
  return pass;
}

bool JointSearch::places_pass_now(std::size_t first) {
  last_.reset();
  if (!passing_.settles_within_rules()) return true;  // rules of the others, as far as known
  for (std::size_t i = 0; i < evaluation_.positions(); ++i) {
    if (evaluation_.evaluate_at(i) && !elements_pass(first)) return false;
  }
  return true;
}

bool JointSearch::elements_pass(std::size_t first) const {
  void* const result = evaluation_.result().data.get();
  for (const FieldInfo& list : evaluation_.calculator().result->fields) {
    if (list.type != FieldInfo::Type::list) continue;
    for (std::size_t k = 0; k < list.size(result); ++k) {
      const bool is_of_size = sizes_.is_place_of(first, list, list.element(result, k));
      if (is_of_size && !passing_.element_passes(list, k)) return false;
    }
  }
  return true;
}

/// Whether the checks at the places of a size may pass with it, with the others as small as they can be: with less no
/// part passes.
bool JointSearch::may_be(std::size_t first, std::size_t at) {
  if (!sizes_.set(with_group(SizeIndices(sizes_.count(), 0), first, at))) return true;
  return sizes_.at(first).at == at && places_pass(first);
}

/// The smallest index of each size that may be, from what was found downwards: where strength governs, the next smaller
/// one fails, and that is all that is tried.
SizeIndices JointSearch::floors_below(const SizeIndices& found) {
  SizeIndices floors = found;
  for (const std::size_t first : sizes_.firsts()) {
    std::size_t at = found[first];
    while (at > 0 && may_be(first, at - 1)) --at;
    floors = with_group(std::move(floors), first, at);
  }
  return floors;
}

/// The sizes one after the other, ascending: the minimum of the rest bounds the cost, and the checks at places whose
/// sizes are all set exclude most of the following candidates.
struct JointSearch::Branching {
  SizeIndices firsts;  // first candidates of equal sizes
  SizeIndices floors, least, best;
  double lowest;
  int trials;  // remaining ones
};

void JointSearch::branch(Branching& b, std::size_t depth) {
  const std::size_t first = b.firsts[depth];
  const auto set_least = [&](std::size_t at) {
    for (std::size_t i = 0; i < sizes_.count(); ++i) {
      if (sizes_.at(i).like >= first) b.least[i] = sizes_.at(i).like == first ? at : b.floors[i];
    }
  };
  const auto keeps_what_is_set = [&] {
    for (std::size_t i = 0; i < sizes_.count(); ++i) {
      if (sizes_.at(i).like <= first && sizes_.at(i).at != b.least[i]) return false;
    }
    return true;
  };
  for (std::size_t at = b.floors[first]; at < sizes_.sizes(first).size() && b.trials > 0; ++at) {
    set_least(at);
    if (!sizes_.set(b.least) || !keeps_what_is_set()) continue;
    const double cost = sizes_.cost();
    if (!numerics::exceeds(b.lowest, cost)) break;
    --b.trials;
    if (depth + 1 == b.firsts.size()) {
      if (!passes()) continue;
      b.lowest = cost;
      b.best = b.least;
      break;
    }
    if (depth == 0 || places_pass(b.firsts[depth - 1])) branch(b, depth + 1);
  }
}

/// The smallest index of each size that may be, from the smallest upwards; empty if a size may have none.
SizeIndices JointSearch::floors_from_least() {
  SizeIndices floors(sizes_.count(), 0);
  for (const std::size_t first : sizes_.firsts()) {
    std::size_t at = 0;
    while (at < sizes_.sizes(first).size() && !may_be(first, at)) ++at;
    if (at == sizes_.sizes(first).size()) return {};
    floors = with_group(std::move(floors), first, at);
  }
  return floors;
}

/// From the smallest sizes `floors` on, those that pass with less than `lowest`; true if there are any.
bool JointSearch::find_from(SizeIndices floors, double lowest, int trials, SizeIndices& least) {
  Branching b{sizes_.firsts(), std::move(floors), least, {}, lowest, trials};
  branch(b, 0);
  if (b.best.empty()) return false;
  least = b.best;
  sizes_.set(least);
  return true;
}

/// From the result of a first search, if any; true if there is a cheaper part. Without a first part nothing limits the
/// cost: a few are tried from the smallest sizes on, then from those below which a place of its own fails.
bool JointSearch::find_cheaper(double lowest, SizeIndices& least) {
  constexpr int most_trials = 20000, most_without_bound = 400;
  if (std::isfinite(lowest)) return find_from(floors_below(least), lowest, most_trials, least);
  if (!find_from(SizeIndices(sizes_.count(), 0), lowest, most_without_bound, least)) {
    SizeIndices floors = floors_from_least();
    if (floors.empty() || !find_from(std::move(floors), lowest, most_trials, least)) return false;
  }
  find_cheaper(sizes_.cost(), least);
  return sizes_.set(least);
}

/// The cheapest passing part among all arrangements of the sizes; if none passes, the first arrangement.
bool JointSearch::find_cheapest(SizeIndices& least) {
  double lowest = std::numeric_limits<double>::infinity();
  std::size_t best_way = 0;
  SizeIndices best;
  const auto keep = [&](std::size_t way) {
    lowest = sizes_.cost();
    best_way = way;
    best = least;
  };
  for (std::size_t way = 0; sizes_.arrange(way); ++way) {  // a good one first: it bounds the rest
    if (!find_start(least)) continue;
    lower(least);
    exchange(least);
    if (numerics::exceeds(lowest, sizes_.cost())) keep(way);
  }
  bool are_barred = true;
  for (std::size_t way = 0; sizes_.arrange(way); ++way) {
    least.assign(sizes_.count(), 0);
    const bool is_barred = std::isinf(lowest) && find_barred();
    are_barred = are_barred && is_barred;
    if (!is_barred && find_cheaper(lowest, least)) keep(way);
  }
  if (!are_barred) barred_.clear();
  sizes_.arrange(best_way);
  if (best.empty()) return false;
  least = best;
  return sizes_.set(least);
}

/// If none pass: the largest that satisfy every rule about them.
bool JointSearch::set_largest(SizeIndices& least) {
  sizes_.cap();
  const std::vector<double> levels = sizes_.levels();
  for (std::size_t level = levels.size(); level-- > 0;) {
    least = sizes_.first_from(levels[level]);
    if (sizes_.set(least) && keeps_rules()) return true;
  }
  return false;
}

/// Whether a check has a value now.
bool JointSearch::has_check() const {
  bool has = false;
  for_each_leaf(evaluation_.result(), [&](const std::string&, const Leaf& leaf) {
    const bool is_check = leaf.field->role == Role::check && evaluation_.is_judged(*leaf.field);
    has = has || (is_check && !std::isnan(leaf.get()));
  });
  return has;
}

void JointSearch::run(std::vector<Issue>& issues) {
  SizeIndices least(sizes_.count(), 0);
  const Search& first = sizes_.search(0);
  passing_.excuse_sizeless();
  const bool smallest = passes_with(least);
  if (smallest && !has_check()) return issues.push_back(aimless_search(evaluation_.step(), first));
  bool found = find_cheapest(least);
  if (!found && !barred_.empty()) return leave_barred(issues);
  if (!found && excuse_unmoved()) {
    found = find_cheapest(least);
    if (found && fails_unmoved(least)) return leave_unfit(least);
  }
  if (!found && !set_largest(least)) return issues.push_back(no_sizes());
  if (!found) return leave_open(least);
  if (in_words_) return report(least);
  sizes_.set(least);
  settle();
}

/// Ignores checks that no size satisfies: those that fail with both the smallest and the largest sizes within the
/// rules, all alike, and do not improve with the largest. Returns whether there are any.
bool JointSearch::excuse_unmoved() {
  sizes_.cap();
  const auto keeps_rules_at = [&](double level) { return sizes_.set(sizes_.first_from(level)) && keeps_rules(); };
  const std::vector<double> levels = sizes_.levels();
  std::size_t first = 0, last = levels.size();
  while (first < last && !keeps_rules_at(levels[first])) ++first;
  if (first == last) return false;
  const FailedValues smallest = failed_values(evaluation_, passing_);
  do --last;
  while (last > first && !keeps_rules_at(levels[last]));
  if (last == first) return false;
  const FailedValues unmoved = unmoved_values(smallest, failed_values(evaluation_, passing_));
  for (const auto& [row, value] : unmoved) passing_.excuse(row);
  forget();
  return !unmoved.empty();
}

/// Whether a check or a requirement fails that the search has left out: a part that breaks is not a result. Only the
/// ranges of methods remain, which no size reaches.
bool JointSearch::fails_unmoved(const SizeIndices& least) {
  sizes_.set(least);
  settle();
  Passing whole(evaluation_);
  whole.excuse_sizeless();
  const FailedValues failed = failed_values(evaluation_, whole);
  return std::any_of(failed.begin(), failed.end(), [](const auto& row) { return is_failure(*row.first.field); });
}

}  // namespace loadpath::project
