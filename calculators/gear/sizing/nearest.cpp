#include "calculators/gear/sizing/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <tuple>
#include <utility>

namespace loadpath::gear::sizing {

namespace {

struct Rated {
  Found found;
  Point point;

  /// In the order of the ranking if they are equally near.
  bool operator<(const Rated& other) const {
    if (found.shortfall.less_than(other.found.shortfall)) return true;
    return !other.found.shortfall.less_than(found.shortfall) && point < other.point;
  }
};

/// An option with the least shortfall that its pairs can have.
struct ShortfallBound {
  std::size_t option;
  int limits;
  double check;

  bool operator>(const ShortfallBound& other) const {
    return std::tie(limits, check, option) > std::tie(other.limits, other.check, other.option);
  }
};

/// The search, from the least bound up.
class Search {
 public:
  Search(const Input& in, const Range& range, const Bounds& bounds) : in_(in), range_(range), bounds_(bounds) {}

  /// Whether pairs with at least this shortfall may be among the nearest. A bound that is not a number excludes none.
  [[nodiscard]] bool wants(int limits, double check) const {
    if (nearest_.size() < most_rows) return true;
    const Shortfall& worst = nearest_.back().found.shortfall;
    return limits != worst.limits ? limits < worst.limits : !(check > worst.check);
  }
  [[nodiscard]] bool passes() const { return passes_; }

  /// The widths of an option, the widest first: narrower ones have larger bounds. Only the first width counts where no
  /// width helps.
  void rate(const ShortfallBound& hope) {
    RatingTypes::Input teeth = range_.teeth(hope.option);
    const PairResult g = laid_out(teeth);
    const Option& option = range_.options[hope.option];
    const std::vector<double> widths = widths_of(in_, option.m, g.d_1 / mm);
    std::size_t i = hope.limits > 0 ? std::min<std::size_t>(widths.size(), 1) : widths.size();
    while (i-- > 0 && wants(hope.limits, bounds_.at(option, widths[i]))) {
      teeth.b = widths[i] * mm;
      if (!is_admissible(teeth)) continue;
      Found one = rated(in_, teeth);
      passes_ = one.shortfall.none();
      if (passes_) return;
      const bool no_width_helps = !is_of_load(one.shortfall.failure);
      if (no_width_helps && i > 0) {
        i = 1;
        continue;
      }
      keep({std::move(one), point_of(in_, hope.option, g, widths[i])});
    }
  }

  std::vector<Found> taken() {
    std::vector<Found> all;
    for (Rated& one : nearest_) all.push_back(std::move(one.found));
    return all;
  }

 private:
  void keep(Rated one) {
    nearest_.insert(std::upper_bound(nearest_.begin(), nearest_.end(), one), std::move(one));
    if (nearest_.size() > most_rows) nearest_.pop_back();
  }

  const Input& in_;
  const Range& range_;
  const Bounds& bounds_;
  std::vector<Rated> nearest_;
  bool passes_ = false;
};

}  // namespace

Bounds::Bounds(const Range& range) {
  bounds_.resize(range.numbers.size());
  for (std::size_t i = 0; i < range.options.size(); ++i) {
    const std::size_t numbers = range.options[i].numbers;
    if (i + 1 < range.options.size() && range.options[i + 1].numbers == numbers) continue;
    RatingTypes::Input largest = range.teeth(i);
    const double m = range.options[i].m;
    largest.b = most_psi_m * m * mm;
    bounds_[numbers] = {bound_of(largest), laid_out(largest).d_1 / mm / m};
  }
}

double Bounds::at(const Option& option, double b) const {
  return empty() ? 0.0 : bounds_[option.numbers].load.at(option.m, b);
}

bool Bounds::reject(const Option& option) const { return !empty() && option.m > bounds_[option.numbers].load.most_m; }

double Bounds::least(const Input& in, const Option& option) const {
  constexpr double step = 1.15;  // more than that of R20
  const double d_1 = bounds_[option.numbers].d_1;
  const double widest = std::min(in.psi_max * d_1, most_psi_m) * (1.0 + 1e-6);
  const double first = std::max(in.psi_min * d_1, least_psi_m) * step;
  return at(option, option.m * (reject(option) ? std::min(first, widest) : widest));
}

Nearest nearest_of(const Input& in, const Range& range, const Bounds& bounds) {
  std::vector<ShortfallBound> hopes;
  for (std::size_t i = 0; i < range.options.size(); ++i) {
    const double bound = bounds.least(in, range.options[i]);
    hopes.push_back({i, bounds.reject(range.options[i]) ? 1 : 0, std::isnan(bound) ? 0.0 : bound});
  }
  // A heap, as few are taken.
  std::make_heap(hopes.begin(), hopes.end(), std::greater<>());
  Search search(in, range, bounds);
  while (!hopes.empty() && !search.passes() && search.wants(hopes.front().limits, hopes.front().check)) {
    search.rate(hopes.front());
    std::pop_heap(hopes.begin(), hopes.end(), std::greater<>());
    hopes.pop_back();
  }
  return {search.passes(), search.taken()};
}

}  // namespace loadpath::gear::sizing
