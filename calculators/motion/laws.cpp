#include "calculators/motion/laws.hpp"

#include "lib/quantity/format.hpp"
#include "lib/units.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <cmath>
#include <limits>
#include <string>

namespace loadpath::motion {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Outcome<Law> parsed(const Formula& formula, const Dimension& dimension) {
  return Law::parse(formula.view(), time_variable(), dimension);
}

/// A formula and what it was read as.
struct Kept {
  Formula formula;
  Dimension dimension, variable;
  bool is_law = false;
  Law law;
};

}  // namespace

Law::Variable time_variable() { return {"t", sec.dimension()}; }

const Law* law_of(const Formula& formula, const Dimension& dimension, const Law::Variable& variable) {
  thread_local std::array<Kept, 16> kept;
  thread_local std::size_t next = 0;
  if (formula.empty()) return nullptr;
  for (const Kept& k : kept) {
    if (k.formula == formula && k.dimension == dimension && k.variable == variable.dimension)
      return k.is_law ? &k.law : nullptr;
  }
  Kept& slot = kept[next];
  next = (next + 1) % kept.size();
  auto law = Law::parse(formula.view(), variable, dimension);
  slot.formula = formula;
  slot.dimension = dimension;
  slot.variable = variable.dimension;
  slot.is_law = static_cast<bool>(law);
  if (slot.is_law) slot.law = std::move(*law);
  return slot.is_law ? &slot.law : nullptr;
}

bool reads(const Written& written) {
  return written.formula->empty() || law_of(*written.formula, written.dimension) != nullptr;
}

FieldFault reading_fault(const Written& written) {
  if (written.formula->empty()) return {};
  const auto law = parsed(*written.formula, written.dimension);
  if (law) return {};
  return {written.key, law.fault().message, law.fault().hint};
}

Jet at(const Written& written, double t) {
  if (written.formula->empty()) return {};
  const Law* const law = law_of(*written.formula, written.dimension);
  return law == nullptr ? Jet{nan, nan, nan} : law->at(t);
}

double without_rounding(double value, double scale) {
  constexpr double rounding = 1e-14;
  return std::abs(value) <= rounding * std::abs(scale) ? 0.0 : value;
}

bool is_finite(const Jet& jet) {
  return std::isfinite(jet.value) && std::isfinite(jet.first) && std::isfinite(jet.second);
}

double first_gap(const Written& written, double t_1, double t_2, int count) {
  if (!reads(written)) return nan;
  for (int i = 0; i < count; ++i) {
    const double t = i + 1 == count ? t_2 : t_1 + (t_2 - t_1) * i / (count - 1);
    if (!is_finite(at(written, t))) return t;
  }
  return nan;
}

FieldFault gap_fault(const Written& written, double t_1, double t_2) {
  const double t = first_gap(written, t_1, t_2);
  if (std::isnan(t)) return {};
  return {written.key, say("the law has no value, speed or acceleration at t = {1}", format_quantity(t, "s", 4)),
          say("it divides by zero there, or takes a root or an arc of what has none")};
}

double integral(double (*function)(const void* data, double t), const void* data, double t_1, double t_2) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 15>;
  constexpr unsigned most_halvings = 12;
  return Rule::integrate([&](double t) { return function(data, t); }, t_1, t_2, most_halvings, 1e-10);
}

}  // namespace loadpath::motion
