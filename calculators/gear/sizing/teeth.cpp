#include "calculators/gear/sizing/teeth.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::gear::sizing {

PairResult laid_out(const RatingTypes::Input& teeth) {
  NoTrace quiet;
  PairResult g;
  lay_out(rating::pair_of(teeth), g, quiet);
  return g;
}

namespace {

using Input = PairSizingTypes::Input;
using TeethInput = RatingTypes::Input;

constexpr double steps_of_x = 100.0;   // profile shifts are given to two decimals
constexpr double most_teeth = 2000.0;  // of gear.rating and gear.pair

/// Excess of the sliding at the root of gear 1 over that at the root of gear 2: falls with x_1.
double imbalance(const TeethInput& teeth) {
  const PairResult g = laid_out(teeth);
  const double T = in_si(g.a_w) * std::sin(g.alpha_wt);
  const auto tip = [](Length d_a, Length d_b) { return std::sqrt(in_si(d_a * d_a - d_b * d_b)) / 2.0; };
  const double rho_a1 = tip(g.d_a1, g.d_b1), rho_a2 = tip(g.d_a2, g.d_b2);
  // Contact beyond a base circle counts as endless sliding.
  if (rho_a2 >= T) return HUGE_VAL;
  if (rho_a1 >= T) return -HUGE_VAL;
  return rho_a2 / (g.u * (T - rho_a2)) - g.u * rho_a1 / (T - rho_a1);
}

TeethInput with_shift(TeethInput teeth, double x_1, double x_sum) {
  teeth.x_1 = x_1;
  if (!is_set(teeth.a_w)) teeth.x_2 = std::round((x_sum - x_1) * 1e9) / 1e9;
  return teeth;
}

/// Shift of gear 1 with the most even sliding, by bisection in steps of 0.01.
double balanced_shift(const TeethInput& teeth, double x_sum) {
  int low = static_cast<int>(std::ceil(std::max(least_x, x_sum - most_x) * steps_of_x - 1e-6));
  int high = static_cast<int>(std::floor(std::min(most_x, x_sum - least_x) * steps_of_x + 1e-6));
  if (low > high) return unset<double>;
  const auto at = [&](int hundredths) { return imbalance(with_shift(teeth, hundredths / steps_of_x, x_sum)); };
  double at_low = unset<double>, at_high = unset<double>;
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    const double excess = at(middle);
    (excess > 0.0 ? low : high) = middle;
    (excess > 0.0 ? at_low : at_high) = excess;
  }
  if (!is_set(at_low)) at_low = at(low);
  if (!is_set(at_high)) at_high = at(high);
  return (std::abs(at_low) <= std::abs(at_high) ? low : high) / steps_of_x;
}

/// Sum of the profile shifts: as given, or that of the centre distance.
double sum_of_shifts(const Input& in, const TeethInput& teeth) {
  if (!is_set(in.a_set)) return is_set(in.x_sum) ? in.x_sum : 0.0;
  return laid_out(teeth).x_0;
}

/// Whether profile shifts in use give a tooth form.
bool is_in_use(double x_sum) { return x_sum >= 2.0 * least_x && x_sum <= 2.0 * most_x; }

/// The option of a module with these shifts. Its teeth need not mesh: `Rating::is_laid_out`.
TeethInput shifted(const Input& in, const TeethInput& teeth, double x_1) {
  const double x_sum = sum_of_shifts(in, teeth);
  if (!is_in_use(x_sum)) return with_shift(teeth, unset<double>, x_sum);
  const bool balances = in.shift == PairSizingTypes::Shift::balanced && !is_set(x_1);
  return with_shift(teeth, balances ? balanced_shift(teeth, x_sum) : x_1, x_sum);
}

bool is_option(const TeethInput& teeth) { return is_set(teeth.x_1) && Rating::is_laid_out(teeth); }

TeethInput of_module(TeethInput teeth, double m) {
  teeth.m_n = m * mm;
  return teeth;
}

/// All modules of one pair of tooth numbers. Without a centre distance the shifts are those of any module.
void add_numbers(const Input& in, const TeethInput& teeth, Range& range) {
  const double x_1 = in.shift == PairSizingTypes::Shift::none ? 0.0 : unset<double>;
  const std::size_t before = range.options.size();
  const bool is_scaled = !is_set(in.a_set);
  const TeethInput any = is_scaled ? shifted(in, of_module(teeth, 1.0), x_1) : teeth;
  if (is_scaled && !is_option(any)) return;
  for (const double m : module_series) {
    if (m * mm < in.m_min || m * mm > in.m_max) continue;
    const TeethInput one = is_scaled ? any : shifted(in, of_module(teeth, m), x_1);
    if (is_scaled || is_option(one)) range.options.push_back({range.numbers.size(), m, one.x_1, one.x_2});
  }
  if (range.options.size() > before) range.numbers.push_back(teeth);
}

/// The integers next to i z_1, as far as the ratio tolerates them.
void add_mates(const Input& in, TeethInput teeth, Range& range) {
  const double z_1 = teeth.z_1, exact = in.i_set * z_1;
  for (double z_2 = std::floor(exact + 1e-9); z_2 <= std::ceil(exact - 1e-9); z_2 += 1.0) {
    if (std::abs(z_2 / exact - 1.0) > in.tol_i || z_2 < z_1 || z_2 > most_teeth) continue;
    teeth.z_2 = Whole(z_2);
    add_numbers(in, teeth, range);
  }
}

}  // namespace

TeethInput Range::teeth(std::size_t option) const {
  const Option& of = options[option];
  TeethInput teeth = numbers[of.numbers];
  teeth.m_n = of.m * mm, teeth.x_1 = of.x_1, teeth.x_2 = of.x_2;
  return teeth;
}

Range range_of(const Input& in) {
  Range range;
  TeethInput teeth = in;
  teeth.a_w = in.a_set, teeth.b = unset<Length>;
  PairSizingTypes::Helices helices = in.betas;
  if (helices.empty()) helices.push_back({0.0});
  for (auto helix = helices.begin(); helix != helices.end(); ++helix) {
    const auto is_same = [&](const auto& earlier) { return earlier.beta == helix->beta; };
    if (std::any_of(helices.begin(), helix, is_same)) continue;
    teeth.beta = helix->beta;
    for (int z_1 = static_cast<int>(in.z_min); z_1 <= static_cast<int>(in.z_max); ++z_1) {
      teeth.z_1 = z_1;
      add_mates(in, teeth, range);
    }
  }
  return range;
}

std::vector<double> widths_of(const Input& in, double m_n, double d_1) {
  const double least = std::max(in.psi_min * d_1, least_psi_m * m_n);
  const double most = std::min(in.psi_max * d_1, most_psi_m * m_n);
  std::vector<double> widths;
  for (const double decade : {1.0, 10.0, 100.0, 1000.0}) {
    for (const double number : r20) {
      const double b = std::round(100.0 * decade * number) / 100.0;  // 22.4, not 22.400000000000002
      if (b >= least * (1.0 - 1e-9) && b <= most * (1.0 + 1e-9)) widths.push_back(b);
    }
  }
  return widths;
}

}  // namespace loadpath::gear::sizing
