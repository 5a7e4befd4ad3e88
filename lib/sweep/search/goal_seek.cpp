#include "lib/sweep/search/goal_seek.hpp"

#include "lib/sweep/column_block.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace loadpath::sweep {

namespace {

/// A place and by how much the output exceeds the target there.
struct Look {
  double x, rest;
};

bool is_there(const Look& look) { return std::isfinite(look.rest); }

class Seeker {
 public:
  Seeker(Function& searched, const std::vector<double>& point, const Goal& wanted)
      : function(searched), base(point), goal(wanted) {
    sought.nearest = sought.value = std::numeric_limits<double>::quiet_NaN();
  }

  SeekResult run();

 private:
  [[nodiscard]] std::vector<Look> look_at(const std::vector<double>& places);
  [[nodiscard]] Look look_at(double x) { return look_at(std::vector<double>{x}).front(); }
  [[nodiscard]] std::vector<Look> over_the_range();
  [[nodiscard]] Look edge(Look there, double not_there);
  [[nodiscard]] Look lowest(Look left, Look middle, Look right);

  void add(Solution::Kind kind, const Look& look, double within);
  void add_stretch(const Look& first, const Look& last);
  void add_between(const Look& left, const Look& right);
  void add_touching(const Look& left, const Look& middle, const Look& right);

  Function& function;
  const std::vector<double>& base;
  const Goal& goal;
  SeekResult sought;
  double best = std::numeric_limits<double>::infinity();
};

std::vector<Look> Seeker::look_at(const std::vector<double>& places) {
  const std::size_t n = places.size();
  Columns in(function.inputs(), n), out(function.outputs(), n);
  for (std::size_t i = 0; i < base.size(); ++i) std::fill_n(in[i], n, base[i]);
  std::copy(places.begin(), places.end(), in[goal.input]);
  function.evaluate(in.read(), out.write(), n);
  sought.evaluations += n;
  std::vector<Look> looks;
  for (std::size_t k = 0; k < n; ++k) {
    const double value = out[goal.output][k], rest = value - goal.target;
    looks.push_back({places[k], rest});
    if (std::abs(rest) < best) best = std::abs(rest), sought.nearest = places[k], sought.value = value;
  }
  return looks;
}

/// The last place with an output, to rounding.
Look Seeker::edge(Look there, double not_there) {
  for (int i = 0; i < 60; ++i) {
    const double middle = std::midpoint(there.x, not_there);
    if (middle == there.x || middle == not_there) break;
    const Look look = look_at(middle);
    if (is_there(look)) {
      there = look;
    } else {
      not_there = middle;
    }
  }
  return there;
}

/// The points of the range with the edges of missing values between them.
std::vector<Look> Seeker::over_the_range() {
  std::vector<double> places;
  const std::size_t points = std::max<std::size_t>(goal.points, 2);
  const auto last = static_cast<double>(points - 1);
  for (std::size_t k = 0; k < points; ++k)
    places.push_back(std::lerp(goal.from, goal.to, static_cast<double>(k) / last));
  const auto looks = look_at(places);
  std::vector<Look> all{looks.front()};
  for (std::size_t k = 1; k < looks.size(); ++k) {
    if (is_there(looks[k - 1]) && !is_there(looks[k])) all.push_back(edge(looks[k - 1], looks[k].x));
    if (!is_there(looks[k - 1]) && is_there(looks[k])) all.push_back(edge(looks[k], looks[k - 1].x));
    all.push_back(looks[k]);
  }
  return all;
}

void Seeker::add(Solution::Kind kind, const Look& look, double within) {
  sought.solutions.push_back({kind, look.x, look.x, goal.target + look.rest, within});
}

void Seeker::add_stretch(const Look& first, const Look& last) {
  add(first.x == last.x ? Solution::Kind::crossing : Solution::Kind::stretch, first, 0.0);
  sought.solutions.back().to = last.x;
}

/// A root or a leap between two places where the signs differ.
void Seeker::add_between(const Look& left, const Look& right) {
  constexpr double negligible = 1e-6;  // relative to the deviation of the output from the target at the ends
  std::uintmax_t most = 200;
  std::vector<Look> seen;
  const auto rest = [&](double x) {
    seen.push_back(look_at(x));
    return seen.back().rest;
  };
  const auto [low, high] = boost::math::tools::toms748_solve(rest, left.x, right.x, left.rest, right.rest,
                                                             boost::math::tools::eps_tolerance<double>(52), most);
  Look nearest{left.x, std::numeric_limits<double>::infinity()};
  for (const Look& look : seen) {
    if (look.x >= low && look.x <= high && std::abs(look.rest) < std::abs(nearest.rest)) nearest = look;
  }
  if (!is_there(nearest)) return;
  const bool is_root = std::abs(nearest.rest) <= negligible * std::abs(left.rest - right.rest);
  add(is_root ? Solution::Kind::crossing : Solution::Kind::leap, nearest, high - low);
}

/// The lowest place of the sections between left and right, by the golden section: it needs no smoothness.
Look Seeker::lowest(Look left, Look middle, Look right) {
  constexpr double share = 0.3819660112501051;  // (3 - sqrt 5) / 2
  for (int i = 0; i < 100 && right.x - left.x > 4e-16 * std::abs(middle.x); ++i) {
    const bool upper = right.x - middle.x > middle.x - left.x;
    const Look next = look_at(middle.x + share * (upper ? right.x - middle.x : left.x - middle.x));
    if (!is_there(next)) break;
    const bool lower = std::abs(next.rest) < std::abs(middle.rest) || (next.rest < 0.0) != (middle.rest < 0.0);
    (upper == lower ? left : right) = lower ? middle : next;
    if (lower) middle = next;
    if ((middle.rest < 0.0) != (left.rest < 0.0)) break;
  }
  return middle;
}

/// Two roots between neighbours of one sign, or one that touches.
void Seeker::add_touching(const Look& left, const Look& middle, const Look& right) {
  constexpr double negligible = 1e-6;
  const Look bottom = lowest(left, middle, right);
  if ((bottom.rest < 0.0) != (left.rest < 0.0) && bottom.rest != 0.0) {
    add_between(left, bottom);
    add_between(bottom, right);
  } else if (std::abs(bottom.rest) <= negligible * (std::abs(left.rest) + std::abs(right.rest))) {
    add(Solution::Kind::touching, bottom, std::sqrt(std::numeric_limits<double>::epsilon()) * (right.x - left.x));
  }
}

SeekResult Seeker::run() {
  const auto looks = over_the_range();
  for (std::size_t k = 0; k < looks.size(); ++k) {
    if (!is_there(looks[k])) continue;
    if (looks[k].rest == 0.0) {
      const std::size_t first = k;
      while (k + 1 < looks.size() && looks[k + 1].rest == 0.0) ++k;
      add_stretch(looks[first], looks[k]);
      continue;
    }
    const bool is_inner = k > 0 && k + 1 < looks.size() && is_there(looks[k - 1]) && is_there(looks[k + 1]);
    const auto on_this_side = [&](const Look& other) {
      return other.rest != 0.0 && (other.rest < 0.0) == (looks[k].rest < 0.0);
    };
    if (is_inner && on_this_side(looks[k - 1]) && on_this_side(looks[k + 1]) &&
        std::abs(looks[k].rest) <= std::abs(looks[k - 1].rest) && std::abs(looks[k].rest) < std::abs(looks[k + 1].rest))
      add_touching(looks[k - 1], looks[k], looks[k + 1]);
    const bool has_next = k + 1 < looks.size() && is_there(looks[k + 1]) && looks[k + 1].rest != 0.0;
    if (has_next && !on_this_side(looks[k + 1])) add_between(looks[k], looks[k + 1]);
  }
  return std::move(sought);
}

}  // namespace

SeekResult seek(Function& function, const std::vector<double>& base, const Goal& goal) {
  return Seeker(function, base, goal).run();
}

}  // namespace loadpath::sweep
