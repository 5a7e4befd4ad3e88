#include "calculators/gear/sizing/search.hpp"

#include "calculators/gear/sizing/teeth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <tuple>
#include <vector>

namespace loadpath::gear::sizing {

namespace {

using TeethInput = RatingTypes::Input;

/// The mode of each check and limit of gear.rating.
struct Judge {
  std::string_view key;
  Failure failure;
};
constexpr std::array judges{
    Judge{"u_H1", Failure::pitting_1},     Judge{"u_H2", Failure::pitting_2},  Judge{"u_F1", Failure::root_1},
    Judge{"u_F2", Failure::root_2},        Judge{"x_v", Failure::dynamic},     Judge{"x_c", Failure::stiffness},
    Judge{"x_eps", Failure::contact},      Judge{"x_free", Failure::undercut}, Judge{"s_a", Failure::pointed},
    Judge{"f_int", Failure::interference}, Judge{"c_n", Failure::clearance},   Judge{"j_bn", Failure::clearance}};

Failure failure_of(std::string_view key) {
  return std::find_if(judges.begin(), judges.end(), [&](const Judge& j) { return j.key == key; })->failure;
}

/// Contribution of one result of gear.rating. A limit outweighs every check; the first one names the mode.
template <class F>
void take(const F& field, const RatingTypes::Result& r, Lack& lack) {
  if constexpr (requires { field.asked_by; }) {
    const double value = in_si(r.*field.at) / in_si(field.unit.one);
    if (field.role == Role::check) {
      const bool fails = !(value <= 1.0) && !(value <= lack.check) && lack.limits == 0;
      if (fails) lack.failure = failure_of(field.key);
      if (std::isnan(value)) ++lack.limits;
      lack.check = std::max(lack.check, value);
    }
    if (field.role == Role::limit && !field.bounds.holds(value) && !(field.where_set && std::isnan(value))) {
      if (lack.limits++ == 0) lack.failure = failure_of(field.key);
    }
  }
}

Lack lack_of(const RatingTypes::Result& r) {
  Lack lack;
  loadpath::apply([&](const auto&... field) { (take(field, r, lack), ...); }, Rating::results_of_pair);
  return lack;
}

/// Whether only the load rejects the pair, so that a wider one may pass.
bool is_of_load(Failure failure) { return failure <= Failure::root_2; }

/// One width of a pair of teeth, with what it is ranked by.
struct Point {
  std::size_t teeth = 0;
  double b = 0.0, first = 0.0, second = 0.0;

  bool operator<(const Point& other) const {
    return std::tie(first, second, teeth, b) < std::tie(other.first, other.second, other.teeth, other.b);
  }
};

Mass mass_of(const Input& in, const PairResult& g, double b) {
  return pi / 4.0 * in.rho * (g.d_1 * g.d_1 + g.d_2 * g.d_2) * (b * mm);
}

/// In m, to a nanometre: pairs of one centre distance must not differ by rounding errors.
double rounded(Length a) { return std::round(in_si(a) * 1e9) / 1e9; }

/// The points of the range in the order of the ranking.
std::vector<Point> points_of(const Input& in, const std::vector<TeethInput>& all) {
  std::vector<Point> points;
  NoTrace quiet;
  for (std::size_t i = 0; i < all.size(); ++i) {
    PairResult g;
    lay_out(rating::pair_of(all[i]), g, quiet);
    for (const double b : widths_of(in, all[i].m_n / mm, g.d_1 / mm)) {
      const double mass = in_si(mass_of(in, g, b)), a = rounded(g.a_w);
      points.push_back(in.by == By::mass ? Point{i, b, mass, a} : Point{i, b, a, mass});
    }
  }
  std::sort(points.begin(), points.end());
  return points;
}

bool is_admissible(const TeethInput& teeth) {
  return std::all_of(Rating::rules_of_teeth.begin(), Rating::rules_of_teeth.end(),
                     [&](const auto& rule) { return rule.holds(teeth); });
}

Candidate row_of(const Input& in, const TeethInput& teeth, const RatingTypes::Result& r, const Lack& lack) {
  NoTrace quiet;
  PairResult g;
  lay_out(rating::pair_of(teeth), g, quiet);
  Candidate c;
  c.m_n = teeth.m_n, c.z_1 = teeth.z_1, c.z_2 = teeth.z_2, c.beta = teeth.beta, c.b = teeth.b;
  c.x_1 = teeth.x_1, c.x_2 = g.x_2, c.a_w = g.a_w;
  c.mass = mass_of(in, g, teeth.b / mm);
  c.S_H = std::min(r.S_H1, r.S_H2), c.S_F = std::min(r.S_F1, r.S_F2);
  c.u = lack.check, c.failure = lack.failure;
  return c;
}

constexpr std::size_t most_rows = capacity_of<PairSizingTypes::Candidates>;

/// What the walk over the points keeps.
struct Walk {
  Found best;  // the first that passes, else the one that lacks least
  std::vector<bool> settled;
  std::vector<Found> nearest;  // to passing, until a pair passes
};

void keep_rejected(const Candidate& c, Result& r) {
  if (r.found > 0.0) return;
  if (r.rejected.size() == most_rows) r.rejected.pop_back();
  r.rejected.insert(r.rejected.begin(), c);
}

void keep_nearest(const Found& one, std::vector<Found>& nearest) {
  const auto place =
      std::find_if(nearest.begin(), nearest.end(), [&](const Found& other) { return one.lack.less_than(other.lack); });
  nearest.insert(place, one);
  if (nearest.size() > most_rows) nearest.pop_back();
}

/// A pair that breaks a rule of gear.rating is not rated; a wider one does not fit either.
void reject_unrated(const Input& in, const TeethInput& teeth, std::size_t index, Walk& walk, Result& r) {
  Lack lack;
  lack.check = unset<double>, lack.failure = Failure::fit;
  keep_rejected(row_of(in, teeth, {}, lack), r);
  walk.settled[index] = true;
}

/// Rates one point; a pair of teeth is settled once it passes, or where no width helps.
void rate(const Input& in, const TeethInput& teeth, std::size_t index, Walk& walk, Result& r) {
  NoTrace quiet;
  const RatingTypes::Result rated = Rating::evaluate(teeth, quiet);
  const Lack lack = lack_of(rated);
  const Candidate row = row_of(in, teeth, rated, lack);
  if (lack.none()) {
    if (r.found == 0.0) walk.best = {teeth, row, lack};
    r.found += 1.0;
    r.candidates.push_back(row);
  } else {
    keep_rejected(row, r);
    if (r.found == 0.0) keep_nearest({teeth, row, lack}, walk.nearest);
  }
  walk.settled[index] = !is_of_load(lack.failure) || lack.none();
}

/// Where none passes, the pairs nearest to passing are shown instead of those that rank last.
void show_nearest(Walk& walk, Result& r) {
  if (r.found > 0.0 || walk.nearest.empty()) return;
  walk.best = walk.nearest.front();
  r.rejected.clear();
  for (const Found& one : walk.nearest) r.rejected.push_back(one.row);
}

}  // namespace

double measure_of(const Candidate& c, By by) { return by == By::mass ? in_si(c.mass) : in_si(c.a_w); }

Found search_for(const Input& in, Result& r) {
  Input loaded = in;
  NoTrace quiet;
  loaded.T_1 = torque_of(in, quiet);
  const std::vector<TeethInput> all = teeth_of(loaded);
  Walk walk{{}, std::vector<bool>(all.size(), false), {}};
  r.tried = static_cast<double>(all.size());
  for (const Point& point : points_of(in, all)) {
    if (walk.settled[point.teeth]) continue;
    TeethInput teeth = all[point.teeth];
    teeth.b = point.b * mm;
    is_admissible(teeth) ? rate(in, teeth, point.teeth, walk, r) : reject_unrated(in, teeth, point.teeth, walk, r);
    if (r.candidates.size() == most_rows) break;
  }
  show_nearest(walk, r);
  return walk.best;
}

}  // namespace loadpath::gear::sizing
