// The search for several sizes of one part at once: from sizes that pass, all alike but for what their neighbours ask,
// each is lowered as far as everything holds, the largest first, until none can be; at first with those that go down
// with it, at last alone, so that in the end no single one can be a size smaller.
//
// Then sizes are traded as long as the part gets cheaper: some go down while others go up. The calculator may know
// several ways in which the sizes go together; each is searched, and the cheapest is taken.
//
// What is lowered is the least that a size may be; the calculator raises it as its neighbours ask (a shoulder, one
// diameter without a step). For any least sizes there is so one part, the lightest of those that keep to them.
#include "lib/numerics/magnitude.hpp"
#include "lib/project/run/run.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace loadpath::project {

struct Run::Together {
  std::vector<const Search*> searches;
  std::vector<std::string> stocks;
  std::vector<std::vector<double>> sizes;
  std::vector<Sought> sought;
  [[nodiscard]] std::size_t count() const { return sought.size(); }
  [[nodiscard]] std::vector<std::size_t> largest_first() const {
    std::vector<std::size_t> order(count());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return sought[a].size() > sought[b].size(); });
    return order;
  }
  [[nodiscard]] std::vector<std::size_t> now() const {
    std::vector<std::size_t> at;
    for (const Sought& s : sought) at.push_back(s.at);
    return at;
  }
};

Run::Together Run::sought_together() {
  Together all;
  for (const Search& search : step_.searches()) {
    all.searches.push_back(&search);
    all.sought.push_back({map_leaf(search.path).owner});
    all.sought.back().like = all.count() - 1;
  }
  calculator_.sizing.arrange(record_.data.get(), all.sought, 0);
  for (std::size_t i = 0; i < all.count(); ++i) {
    const Search& search = *all.searches[i];
    const std::string_view own = all.sought[i].stock;
    all.stocks.push_back(search.names_stock || own.empty() ? search.stock : std::string(own));
    const auto before = std::find(all.stocks.begin(), all.stocks.end() - 1, all.stocks.back()) - all.stocks.begin();
    all.sizes.push_back(before < static_cast<std::ptrdiff_t>(i)
                            ? all.sizes[static_cast<std::size_t>(before)]
                            : stock_values(*step_.input().tables, all.stocks.back()));
    std::erase_if(all.sizes.back(), [&](double size) { return !search.leaf.field->bounds.holds(size); });
  }
  for (std::size_t i = 0; i < all.count(); ++i) all.sought[i].sizes = all.sizes[i];
  return all;
}

/// The sizes that none of which is below its least, and that go together.
bool Run::lay(Together& all, const std::vector<std::size_t>& least) {
  for (std::size_t i = 0; i < all.count(); ++i) {
    if (least[i] >= all.sizes[i].size()) return false;
    all.sought[i].at = least[i];
  }
  if (!calculator_.sizing.raise(record_.data.get(), all.sought)) return false;
  for (std::size_t i = 0; i < all.count(); ++i) map_leaf(all.searches[i]->path).set(all.sought[i].size());
  return true;
}

/// Whether the calculator finds no fault with the sizes as they are.
bool Run::is_sound(const Together& all) const {
  for (std::size_t i = 0; i < all.count(); ++i) {
    if (!calculator_.sizing.fault(record_.data.get(), all.sought, i).empty()) return false;
  }
  return true;
}

bool Run::fits_together(Together& all, const std::vector<std::size_t>& least) {
  return lay(all, least) && is_sound(all) && passes_covered();
}

namespace {

constexpr double same = 1e-9;  // of a size, in two stocks

/// Of each the first size that is not below.
std::vector<std::size_t> first_from(const std::vector<std::vector<double>>& sizes, double size) {
  std::vector<std::size_t> first;
  first.reserve(sizes.size());
  for (const std::vector<double>& all : sizes)
    first.push_back(static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), size) - all.begin()));
  return first;
}

/// All sizes of all stocks, each once.
std::vector<double> levels_of(const std::vector<std::vector<double>>& sizes) {
  std::vector<double> levels;
  for (const std::vector<double>& all : sizes) levels.insert(levels.end(), all.begin(), all.end());
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

}  // namespace

/// All alike, from the middle of the stocks in wide steps, down while they pass or up until they do; then one by one.
bool Run::find_start(Together& all, std::vector<std::size_t>& least) {
  const std::vector<double> levels = levels_of(all.sizes);
  const auto fits = [&](std::size_t level) {
    least = first_from(all.sizes, levels[level]);
    return fits_together(all, least);
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
bool Run::lower_one(Together& all, std::vector<std::size_t>& least, std::size_t which) {
  const std::size_t before = least[which];
  lay(all, least);
  const std::vector<std::size_t> laid = all.now();
  const auto lowers_to = [&](std::size_t lower) {
    std::vector<std::size_t> lowered = least;
    lowered[which] = lower;
    if (!lay(all, lowered) || (all.now() != laid && (lower == 0 || !is_sound(all) || !passes_covered()))) return false;
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

void Run::lower(Together& all, std::vector<std::size_t>& least) {
  for (bool lowered = true; lowered;) {
    lay(all, least);
    lowered = false;
    for (const std::size_t which : all.largest_first()) lowered = lower_one(all, least, which) || lowered;
  }
  lower_alone(all, least);
  lay(all, least);
  settle_sizes();
}

/// Makes one of them, with those that are of one size with it, a size smaller than `laid`; false where there is none.
bool Run::shrink(Together& all, const std::vector<std::size_t>& laid, std::size_t which) {
  for (std::size_t i = 0; i < all.count(); ++i) all.sought[i].at = laid[i];
  const auto is_like = [&](std::size_t i) { return all.sought[i].like == all.sought[which].like; };
  for (std::size_t less = laid[which]; less-- > 0;) {
    const double size = all.sizes[which][less];
    bool in_all = true;
    for (std::size_t i = 0; i < all.count() && in_all; ++i) {
      if (!is_like(i)) continue;
      const auto found = std::lower_bound(all.sizes[i].begin(), all.sizes[i].end(), size * (1.0 - same));
      in_all = found != all.sizes[i].end() && *found <= size * (1.0 + same);
      all.sought[i].at = static_cast<std::size_t>(found - all.sizes[i].begin());
    }
    if (in_all) return true;
  }
  return false;
}

/// Lays it so beside the others as they are; false where they hold it up.
bool Run::lay_smaller(Together& all, const std::vector<std::size_t>& laid, std::size_t which) {
  return shrink(all, laid, which) && lay(all, all.now()) && all.sought[which].at < laid[which];
}

/// Each beside the others as they are: what went down with one may be what failed.
void Run::lower_alone(Together& all, std::vector<std::size_t>& least) {
  for (bool lowered = true; lowered;) {
    lay(all, least);
    least = all.now();
    lowered = false;
    for (const std::size_t which : all.largest_first()) {
      if (all.sought[which].like != which) continue;
      while (lay_smaller(all, least, which) && is_sound(all) && passes_covered()) {
        least = all.now();
        lowered = true;
      }
    }
  }
}

/// Whether what is judged at the places of one of them, and of those of one size with it, passes beside the others.
bool Run::places_hold(const Together& all, std::size_t first) {
  settle_sizes(settled_);
  if (first_broken_rule() < calculator_.rules.size()) return true;  // of the others, as far as they are known
  const auto is_its = [&](const FieldInfo& list, const void* element) {
    const void* const owner = calculator_.sizing.place(record_.data.get(), list.key, element);
    return std::any_of(all.sought.begin(), all.sought.end(),
                       [&](const Sought& s) { return s.like == first && s.owner == owner; });
  };
  for (std::size_t i = 0; i < positions(); ++i) {
    if (!set_position(i)) continue;
    calculator_.evaluate(record_.data.get(), result_.data.get());
    for (const FieldInfo& list : calculator_.result->fields) {
      if (list.type != FieldInfo::Type::list) continue;
      for (std::size_t k = 0; k < list.size(result_.data.get()); ++k) {
        void* const element = list.element(result_.data.get(), k);
        if (!is_its(list, element)) continue;
        if (!element_passes(list, element, true) || !element_passes(list, element, false)) return false;
      }
    }
  }
  return true;
}

/// The sizes one after the other, ascending: the least of the rest bound the cost, and what is judged at places whose
/// sizes are all set excludes most of what follows.
struct Run::Branching {
  Together& all;
  std::vector<std::size_t> firsts;  // of those of one size
  std::vector<std::size_t> least, best;
  double lowest;
  int trials;  // that are left
};

void Run::branch(Branching& b, std::size_t depth) {
  const std::size_t first = b.firsts[depth];
  const auto is_set_before = [&](std::size_t i) { return b.all.sought[i].like <= first; };
  const auto set = [&](std::size_t at) {
    for (std::size_t i = 0; i < b.all.count(); ++i) {
      if (b.all.sought[i].like >= first) b.least[i] = b.all.sought[i].like == first ? at : 0;
    }
  };
  const auto keeps_what_is_set = [&] {
    for (std::size_t i = 0; i < b.all.count(); ++i) {
      if (is_set_before(i) && b.all.sought[i].at != b.least[i]) return false;
    }
    return true;
  };
  for (std::size_t at = 0; at < b.all.sizes[first].size() && b.trials > 0; ++at) {
    set(at);
    if (!lay(b.all, b.least) || !keeps_what_is_set()) continue;
    const double cost = calculator_.sizing.cost(record_.data.get());
    if (!numerics::exceeds(b.lowest, cost)) break;
    --b.trials;
    if (depth + 1 == b.firsts.size()) {
      if (!is_sound(b.all) || !passes_covered()) continue;
      b.lowest = cost;
      b.best = b.least;
      break;
    }
    if (depth == 0 || places_hold(b.all, b.firsts[depth - 1])) branch(b, depth + 1);
  }
}

/// From what a first search has found, if anything; true where there is a cheaper part.
bool Run::find_cheaper(Together& all, double lowest, std::vector<std::size_t>& least) {
  constexpr int most_trials = 20000;
  Branching b{all, {}, least, {}, lowest, most_trials};
  for (std::size_t i = 0; i < all.count(); ++i) {
    if (all.sought[i].like == i) b.firsts.push_back(i);
  }
  branch(b, 0);
  if (b.best.empty()) return false;
  least = b.best;
  lay(all, least);
  return true;
}

/// The cheapest part that passes, of all ways in which the sizes go together; where none does, the first way.
bool Run::find_cheapest(Together& all, std::vector<std::size_t>& least) {
  const auto arrange = [&](std::size_t way) { return calculator_.sizing.arrange(record_.data.get(), all.sought, way); };
  double lowest = std::numeric_limits<double>::infinity();
  std::size_t best_way = 0;
  std::vector<std::size_t> best;
  const auto keep = [&](std::size_t way) {
    lowest = calculator_.sizing.cost(record_.data.get());
    best_way = way;
    best = least;
  };
  for (std::size_t way = 0; arrange(way); ++way) {  // a good one first: it bounds the rest
    if (!find_start(all, least)) continue;
    lower(all, least);
    if (numerics::exceeds(lowest, calculator_.sizing.cost(record_.data.get()))) keep(way);
  }
  for (std::size_t way = 0; arrange(way); ++way) {
    least.assign(all.count(), 0);
    if (find_cheaper(all, lowest, least)) keep(way);
  }
  arrange(best_way);
  if (best.empty()) return false;
  least = best;
  return lay(all, least);
}

/// Where none pass: the largest with which every rule about them holds.
bool Run::lay_largest(Together& all, std::vector<std::size_t>& least) {
  const std::vector<double> levels = levels_of(all.sizes);
  for (std::size_t level = levels.size(); level-- > 0;) {
    least = first_from(all.sizes, levels[level]);
    if (!lay(all, least)) continue;
    settle_sizes();
    if (first_broken_rule() == calculator_.rules.size()) return true;
  }
  return false;
}

/// Whether a check has a value now.
bool Run::has_check() {
  bool has = false;
  for_each_leaf(result_, [&](const std::string&, const Leaf& leaf) {
    const FieldInfo& f = *leaf.field;
    has = has || (f.role == Role::check && is_held_against(f, true) && !std::isnan(leaf.get()));
  });
  return has;
}

void Run::search_together(std::vector<Issue>& issues) {
  Together all = sought_together();
  std::vector<std::size_t> least(all.count(), 0);
  const bool smallest = fits_together(all, least);
  if (smallest && !has_check()) return issues.push_back(aimless(*all.searches.front()));
  const bool found = find_cheapest(all, least);
  if (!found && !lay_largest(all, least)) {
    const std::string& path = all.searches.front()->path;
    return issues.push_back(issue_at(step_.input(), path, say("no sizes go together with what is given"),
                                     say("give '{1}' a value, or let more of them be searched for", path)));
  }
  if (in_words_) return tell_together(all, least, found);
  lay(all, least);
  settle_sizes();
}

/// What one of them fails where it is a size smaller beside the others as they are.
Message Run::fault_of_less(Together& all, const std::vector<std::size_t>& laid, std::size_t which) {
  const Message held = say("no smaller one goes with the others");
  if (!shrink(all, laid, which)) return held;
  const Leaf leaf = map_leaf(all.searches[which]->path);
  const std::string less = format_quantity(all.sought[which].size(), leaf.field->unit);
  for (std::size_t i = 0; i < all.count(); ++i) {
    if (all.sought[i].like != all.sought[which].like) continue;
    const Message unsound = calculator_.sizing.fault(record_.data.get(), all.sought, i);
    if (!unsound.empty()) return say("{1}: {2}", less, unsound);
  }
  return lay_smaller(all, laid, which) ? say("{1}: {2}", less, fault_of_candidate()) : held;
}

/// Of each what was found, and why it is no less.
void Run::tell_together(Together& all, const std::vector<std::size_t>& least, bool found) {
  for (std::size_t i = 0; i < all.count(); ++i) {
    Message text = found ? say("smallest of {1} that passes every check, with the others", all.stocks[i])
                         : say("largest of {1}; none passes", all.stocks[i]);
    if (found && all.sought[i].at > 0) text = say("{1}; {2}", text, fault_of_less(all, least, i));
    lay(all, least);
    Origin origin = stock_origin(*step_.input().tables, all.stocks[i], std::move(text));
    origin.searched = true;
    origins_[all.searches[i]->path] = std::move(origin);
  }
  settle_sizes();
}

}  // namespace loadpath::project
