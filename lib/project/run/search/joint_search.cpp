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
  const bool pass = passing_.passes_again();
  last_.reset();
  if (evaluation_.is_settled()) last_ = Evaluated{std::move(sizes), pass};
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
  last_.reset();
  evaluation_.settle_sizes_again();
  if (!passing_.keeps_rules()) return true;  // rules of the others, as far as known
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

/// From the result of a first search, if any; true if there is a cheaper part.
bool JointSearch::find_cheaper(double lowest, SizeIndices& least) {
  constexpr int most_trials = 20000, most_without_bound = 400;  // without a first part nothing limits the cost
  Branching b{sizes_.firsts(), std::isinf(lowest) ? SizeIndices(sizes_.count(), 0) : floors_below(least),
              least,           {},
              lowest,          std::isinf(lowest) ? most_without_bound : most_trials};
  branch(b, 0);
  if (b.best.empty()) return false;
  least = b.best;
  sizes_.set(least);
  return true;
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
  for (std::size_t way = 0; sizes_.arrange(way); ++way) {
    least.assign(sizes_.count(), 0);
    if (find_cheaper(lowest, least)) keep(way);
  }
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
    if (!sizes_.set(least)) continue;
    settle();
    if (passing_.keeps_rules()) return true;
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
  if (!found && excuse_unmoved()) found = find_cheapest(least);
  if (!found && !set_largest(least)) return issues.push_back(no_sizes());
  if (!found) return leave_open(least);
  if (in_words_) return tell(least);
  sizes_.set(least);
  settle();
}

/// No sizes satisfy the input rules: the rule that is broken at all of them, if there is one. Where the arrangement
/// takes no sizes at all, the rules are those of the sizes alone.
Issue JointSearch::no_sizes() {
  const Message none = say("no combination of sizes satisfies the input rules");
  const std::string& first = sizes_.search(0).path;
  std::optional<std::set<std::size_t>> always;
  bool is_arranged = false;
  for (const double level : sizes_.levels()) {
    const SizeIndices sizes = sizes_.first_from(level);
    const bool are_set = sizes_.set(sizes);
    if (!are_set) sizes_.set_alone(sizes);
    is_arranged = is_arranged || are_set;
    settle();
    const std::set<std::size_t> broken = passing_.broken_rules();
    if (!always) always = broken;
    std::erase_if(*always, [&](std::size_t rule) { return !broken.contains(rule); });
  }
  if (always && !always->empty()) {
    Issue issue = evaluation_.broken_rule(*always->begin());
    if (!is_arranged) issue.message = say("{1}: {2}", none, issue.message);
    return issue;
  }
  return issue_at(evaluation_.step().input(), first, none, say("give '{1}' a value, or search for more sizes", first));
}

/// The check that fails if one of them is a size smaller, with the others unchanged; nothing if no smaller one is
/// possible with them.
std::optional<account::TriedSize> JointSearch::next_of(const SizeIndices& laid, std::size_t which) {
  if (!sizes_.shrink(laid, which)) return std::nullopt;
  const double size = sizes_.at(which).size();
  const std::string less = format_quantity(size, sizes_.search(which).leaf.field->unit);
  for (std::size_t i = 0; i < sizes_.count(); ++i) {
    if (sizes_.at(i).like != sizes_.at(which).like) continue;
    const Message unsound = sizes_.fault(i);
    if (!unsound.empty()) return tried_size(evaluation_.calculator(), less, size, {unsound});
  }
  if (!sizes_.set_smaller(laid, which)) return std::nullopt;
  last_.reset();
  return tried_size(evaluation_.calculator(), less, size, fault_of_candidate(evaluation_, passing_));
}

/// Ignores checks that no size satisfies: those that fail with both the smallest and the largest sizes within the
/// rules, all alike, and do not improve with the largest. Returns whether there are any.
bool JointSearch::excuse_unmoved() {
  sizes_.cap();
  const auto keeps_rules_at = [&](double level) {
    if (!sizes_.set(sizes_.first_from(level))) return false;
    settle();
    return passing_.keeps_rules();
  };
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
  return !unmoved.empty();
}

/// No sizes pass together: none has a value. Reports the failures of the nearest ones, all alike unless their
/// neighbours require otherwise.
void JointSearch::leave_open(SizeIndices nearest) {
  sizes_.cap();
  Shortfall least;
  bool is_first = true;
  for (const double level : sizes_.levels()) {
    const SizeIndices all = sizes_.first_from(level);
    if (!sizes_.set(all)) continue;
    settle();
    if (!passing_.keeps_rules()) continue;
    const Shortfall here = shortfall_of_candidate(evaluation_, passing_);
    if (!is_first && !here.is_less_than(least)) continue;
    is_first = false;
    least = here;
    nearest = sizes_.now();
  }
  sizes_.set(nearest);
  settle();
  std::string sizes;
  for (std::size_t i = 0; i < sizes_.count(); ++i) {
    const std::string size = format_quantity(sizes_.at(i).size(), sizes_.search(i).leaf.field->unit);
    sizes += (i == 0 ? "" : ", ") + sizes_.search(i).path + " = " + size;
  }
  Message fault;  // of the part as a whole, before that of a check
  for (std::size_t i = 0; i < sizes_.count() && fault.empty(); ++i) fault = sizes_.fault(i);
  if (fault.empty()) fault = fault_of_candidate(evaluation_, passing_).text;
  const Message why = say("no sizes pass together, nearest are {1}: {2}", sizes, fault);
  for (std::size_t i = 0; i < sizes_.count(); ++i) {
    const std::string& path = sizes_.search(i).path;
    evaluation_.inputs().leaf(path).set(std::nan(""));
    evaluation_.inputs().set_origin(path, {.text = why, .sources = {}, .searched = true});
  }
  evaluation_.inputs().set_unavailable(why, account::Subject::search);
}

/// Reports for each the result, and the reason why it is not smaller.
void JointSearch::tell(const SizeIndices& least) {
  for (std::size_t i = 0; i < sizes_.count(); ++i) {
    Message text =
        say("smallest of {1} with which no assessed mode fails, in combination with the other sizes", sizes_.stock(i));
    std::optional<account::TriedSize> next;
    if (sizes_.at(i).at > 0) {
      next = next_of(least, i);
      text = next ? say("{1}; {2}: {3}", text, next->name, next->reason)
                  : say("{1}; no smaller one goes with the others", text);
    }
    sizes_.set(least);
    Origin origin = stock_origin(*evaluation_.step().input().tables, sizes_.stock(i), std::move(text));
    origin.searched = true;
    origin.next = std::move(next);
    evaluation_.inputs().set_origin(sizes_.search(i).path, std::move(origin));
  }
  settle();
}

}  // namespace loadpath::project
