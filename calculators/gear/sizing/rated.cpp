#include "calculators/gear/sizing/rated.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

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
void take(const F& field, const RatingTypes::Result& r, Shortfall& shortfall) {
  if constexpr (requires { field.asked_by; }) {
    const double value = in_si(r.*field.at) / in_si(field.unit.one);
    if (field.role == Role::check) {
      const bool fails = !(value <= 1.0) && !(value <= shortfall.check) && shortfall.limits == 0;
      if (fails) shortfall.failure = failure_of(field.key);
      if (std::isnan(value)) ++shortfall.limits;
      shortfall.check = std::max(shortfall.check, value);
    }
    if (field.role == Role::limit && is_outside(field, r) && shortfall.limits++ == 0)
      shortfall.failure = failure_of(field.key);
  }
}

Shortfall shortfall_of(const RatingTypes::Result& r) {
  Shortfall shortfall;
  loadpath::apply([&](const auto&... field) { (take(field, r, shortfall), ...); }, Rating::results_of_pair);
  return shortfall;
}

Mass mass_of(const Input& in, const PairResult& g, double b) {
  return pi / 4.0 * in.rho * (g.d_1 * g.d_1 + g.d_2 * g.d_2) * (b * mm);
}

/// In m, to a nanometre: pairs of one centre distance must not differ by rounding errors.
double rounded(Length a) { return std::round(in_si(a) * 1e9) / 1e9; }

Candidate row_of(const Input& in, const TeethInput& teeth, const RatingTypes::Result& r, const Shortfall& shortfall) {
  const PairResult g = laid_out(teeth);
  Candidate c;
  c.m_n = teeth.m_n, c.z_1 = teeth.z_1, c.z_2 = teeth.z_2, c.beta = teeth.beta, c.b = teeth.b;
  c.x_1 = teeth.x_1, c.x_2 = g.x_2, c.a_w = g.a_w;
  c.mass = mass_of(in, g, teeth.b / mm);
  c.S_H = std::min(r.S_H1, r.S_H2), c.S_F = std::min(r.S_F1, r.S_F2);
  c.u = shortfall.check, c.failure = shortfall.failure;
  return c;
}

}  // namespace

Point point_of(const Input& in, std::size_t option, const PairResult& g, double b) {
  const double mass = in_si(mass_of(in, g, b)), a = rounded(g.a_w);
  return in.by == By::mass ? Point{option, b, mass, a} : Point{option, b, a, mass};
}

bool is_of_load(Failure failure) { return failure <= Failure::root_2; }

bool is_admissible(const TeethInput& teeth) {
  return std::all_of(Rating::rules_of_teeth.begin(), Rating::rules_of_teeth.end(),
                     [&](const auto& rule) { return rule.holds(teeth); });
}

Found rated(const Input& in, const TeethInput& teeth) {
  NoTrace quiet;
  const RatingTypes::Result r = Rating::evaluate(teeth, quiet);
  const Shortfall shortfall = shortfall_of(r);
  return {teeth, row_of(in, teeth, r, shortfall), shortfall};
}

Found unrated(const Input& in, const TeethInput& teeth) {
  Shortfall shortfall;
  shortfall.check = unset<double>, shortfall.failure = Failure::fit;
  return {teeth, row_of(in, teeth, {}, shortfall), shortfall};
}

}  // namespace loadpath::gear::sizing
