#include "calculators/motion/laws.hpp"

#include "lib/quantity/format.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace loadpath::motion {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

bool reads(const Written& written) { return written.text->fault() == nullptr; }

FieldFault reading_fault(std::span<const Written> laws) {
  for (const Written& law : laws) {
    if (const Fault* const fault = law.text->fault()) return {law.key, fault->message, fault->hint};
  }
  return {};
}

numerics::Jet at(const Written& written, double t) {
  if (written.text->empty()) return {};
  const Law* const law = written.text->law();
  return law == nullptr ? numerics::Jet{nan, nan, nan} : law->at(t);
}

double without_rounding(double value, double scale) {
  constexpr double rounding = 1e-14;
  return std::abs(value) <= rounding * std::abs(scale) ? 0.0 : value;
}

bool is_finite(const numerics::Jet& jet) {
  constexpr double largest = 1e30;  // beyond all machines, and products of such numbers leave the range of numbers
  return std::abs(jet.value) <= largest && std::abs(jet.first) <= largest && std::abs(jet.second) <= largest;
}

namespace {

/// Whether a function goes against its slopes at two places: between them it leaps or turns unseen.
bool goes_against(double value_1, double slope_1, double value_2, double slope_2, double step) {
  constexpr double rounding = 1e-9, nothing = 1e-6;
  const double least = step * std::min(std::abs(slope_1), std::abs(slope_2));
  const double rise = std::copysign(1.0, slope_1) * (value_2 - value_1);
  return slope_1 * slope_2 > 0.0 && rise <= nothing * least &&
         least - rise > rounding * std::max(std::abs(value_1), std::abs(value_2));
}

/// Whether a law has a pole between two places, or turns there and back; not whether it has a kink.
bool leaps(const numerics::Jet& a, const numerics::Jet& b, double step) {
  if (goes_against(a.value, a.first, b.value, b.first, step)) return true;
  const double turn = step * std::max(std::abs(a.second), std::abs(b.second));
  return std::abs(b.first - a.first) <= turn && goes_against(a.first, a.second, b.first, b.second, step);
}

}  // namespace

Gap first_gap(const std::function<numerics::Jet(double)>& law, double t_1, double t_2, int count) {
  numerics::Jet before;
  double last = t_1;
  for (int i = 0; i < count; ++i) {
    const double t = i + 1 == count ? t_2 : t_1 + (t_2 - t_1) * i / (count - 1);
    const numerics::Jet here = law(t);
    if (!is_finite(here)) return {t, t};
    if (i > 0 && leaps(before, here, t - last)) return {last, t};
    before = here, last = t;
  }
  return {};
}

Gap first_gap(const Written& written, double t_1, double t_2) {
  return reads(written) ? first_gap([&](double t) { return at(written, t); }, t_1, t_2) : Gap{};
}

FieldFault gap_fault(std::span<const Written> laws, double t_1, double t_2) {
  const auto time = [](double t) { return format_quantity(t, "s", 4); };
  for (const Written& law : laws) {
    const Gap gap = first_gap(law, t_1, t_2);
    if (!gap) continue;
    if (gap.from < gap.to)
      return {
          law.key,
          say("between t = {1} and {2} the law jumps, or varies too fast to be followed", time(gap.from), time(gap.to)),
          say("it has a pole there, or too many oscillations in the range: give a shorter one")};
    return {law.key, say("the law has no value, speed or acceleration at t = {1}", time(gap.from)),
            say("it divides by zero there, or takes a root or an arc function outside its range")};
  }
  return {};
}

double integral(double (*function)(const void* data, double t), const void* data, double t_1, double t_2) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 15>;
  constexpr unsigned most_halvings = 12;
  return Rule::integrate([&](double t) { return function(data, t); }, t_1, t_2, most_halvings, 1e-10);
}

}  // namespace loadpath::motion
