#include "calculators/gear/sizing/load_bound.hpp"

#include "calculators/gear/rating/root.hpp"
#include "calculators/gear/sizing/rated.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace loadpath::gear::sizing {

namespace {

using TeethInput = RatingTypes::Input;

constexpr double rounding = 1.0 - 1e-9;
constexpr double most_velocity = 10.0;  // the limit of x_v in gear.rating

/// Of Z_eps squared at the overlap ratio that makes it smallest, to the value of this width.
double least_contact_ratio_factor(const TeethInput& teeth, const RatingTypes::Result& r) {
  if (teeth.beta == 0.0) return 1.0;
  return std::min(1.0 / r.x_eps, (4.0 - r.x_eps) / 3.0) / (r.Z_eps * r.Z_eps);
}

/// Of Y_beta, and of Y_F by [ISO6336-3-2019], at the overlap ratio that makes them smallest.
double least_root_factors(const TeethInput& teeth, const RatingTypes::Result& r) {
  if (teeth.beta == 0.0) return 1.0;
  const double slope = std::min(teeth.beta, pi / 6.0) / (2.0 * pi / 3.0);
  if (teeth.root_edition == RootEdition::of_2006) return (1.0 - slope) / r.Y_beta;
  const double one_over_eps_an = (r.Y_eps - 0.25) / 0.75;
  const double least_f = std::sqrt(std::min(1.0, one_over_eps_an));
  return (1.0 - slope) / std::pow(std::cos(teeth.beta), 3) / r.Y_beta * least_f / r.f_eps;
}

/// Size factors of this module; those of a smaller module reach 1.
double flank_size(const TeethInput& teeth, GearMaterial material) {
  return rating::is_iso(teeth) ? 1.0 : rating::size_factor_of_flank(material, teeth.m_n / mm);
}
double root_size(const TeethInput& teeth, GearMaterial material) {
  return rating::size_factor_of_root(material, teeth.m_n / mm, rating::is_iso(teeth) ? 0.7 : 0.85);
}

/// Whether a limit of the tooth form, which is the same at every module and face width, rejects the teeth.
bool is_rejected(const RatingTypes::Result& r) {
  constexpr std::array<std::string_view, 5> of_form{"x_c", "x_eps", "x_free", "s_a", "f_int"};
  bool rejected = false;
  const auto take_limit = [&](const auto& field) {
    if constexpr (requires { field.asked_by; }) {
      if (std::find(of_form.begin(), of_form.end(), std::string_view(field.key)) == of_form.end()) return;
      rejected = rejected || is_outside(field, r);
    }
  };
  loadpath::apply([&](const auto&... field) { (take_limit(field), ...); }, Rating::results_of_pair);
  return rejected;
}

/// The velocity in x_v is proportional to the module.
double most_module(const RatingTypes::Result& r, double m) {
  if (is_rejected(r)) return 0.0;
  return r.x_v > most_velocity ? m * most_velocity / r.x_v / rounding : HUGE_VAL;
}

}  // namespace

double LoadBound::at(double m, double b) const { return std::max(flank / (m * std::sqrt(b)), root / (m * m * b)); }

bool has_one_shape(const PairSizingTypes::Input& in) {
  return !is_set(in.a_set) && !is_set(in.s_R1) && !is_set(in.s_R2) && in.blocks.empty();
}

LoadBound bound_of(const TeethInput& largest) {
  NoTrace quiet;
  const RatingTypes::Result r = Rating::evaluate(largest, quiet);
  const double m = largest.m_n / mm, b = largest.b / mm;
  const double to_flank = m * std::sqrt(b) * std::sqrt(largest.K_A * least_contact_ratio_factor(largest, r));
  const double to_root = m * m * b * largest.K_A * least_root_factors(largest, r);
  const auto flank = [&](Stress limit, GearMaterial material) {
    return rounding * largest.S_Hmin * (r.sigma_H0 / limit) * flank_size(largest, material) * to_flank;
  };
  const auto root = [&](Stress stress, Stress limit, GearMaterial material) {
    return rounding * largest.S_Fmin * (stress / limit) * root_size(largest, material) * to_root;
  };
  return {
      std::max(flank(r.sigma_HG1, largest.material_1), flank(r.sigma_HG2, largest.material_2)),
      std::max(root(r.sigma_F01, r.sigma_FG1, largest.material_1), root(r.sigma_F02, r.sigma_FG2, largest.material_2)),
      most_module(r, m)};
}

}  // namespace loadpath::gear::sizing
