#include "lib/quantity/expression/expression.hpp"
#include "lib/quantity/expression/interval_functions.hpp"
#include "lib/quantity/expression/tree.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::expression {
namespace {

double amplitude(const Value& series) { return 0.5 * (maximum(series).value - minimum(series).value); }
double midrange(const Value& series) { return 0.5 * (maximum(series).value + minimum(series).value); }
double range(const Value& series) { return maximum(series).value - minimum(series).value; }
double peak(const Value& series) { return std::abs(largest(series).value); }
double highest(const Value& series) { return maximum(series).value; }
double lowest(const Value& series) { return minimum(series).value; }

// A missing argument makes the result missing, on either side: std::fmax would drop it.
double greater(double a, double b) { return a > b || std::isnan(a) ? a : b; }
double smaller(double a, double b) { return a < b || std::isnan(a) ? a : b; }

constexpr std::size_t any_number = 1024;

constexpr Function reduction(std::string_view name, std::string_view form, double (*f)(const Value&),
                             Rule rule = Rule::reduction) {
  return {.name = name, .form = form, .rule = rule, .least = 1, .most = 1, .reduce = f};
}

// The functions at a point, next to those over an interval.
using expression::acos, expression::asin, expression::atan, expression::atan2, expression::cbrt, expression::cos;
using expression::exp, expression::log, expression::sin, expression::sqrt, expression::tan;
using numerics::acos, numerics::asin, numerics::atan, numerics::atan2, numerics::cbrt, numerics::cos, numerics::exp;
using numerics::log, numerics::sin, numerics::sqrt, numerics::tan;

using JetOf = numerics::Jet (*)(const numerics::Jet&);
using BoundsOf = IntervalJet (*)(const IntervalJet&);

constexpr Function map(std::string_view name, std::string_view form, Rule rule, double (*f)(double), JetOf jet,
                       BoundsOf bounds, int degree = 1) {
  return {.name = name,
          .form = form,
          .rule = rule,
          .least = 1,
          .most = 1,
          .map = f,
          .degree = degree,
          .jet = jet,
          .bounds = bounds};
}

constexpr Function magnitude(Function f) {
  f.is_magnitude = true;
  return f;
}

constexpr Function functions[] = {
    magnitude(reduction("peak", "peak(series)", peak)),
    magnitude(reduction("amplitude", "amplitude(series)", amplitude)),
    reduction("midrange", "midrange(series)", midrange),
    magnitude(reduction("range", "range(series)", range)),
    reduction("mean", "mean(series)", mean, Rule::cycle_reduction),
    magnitude(reduction("rms", "rms(series)", root_mean_square, Rule::cycle_reduction)),
    {.name = "at", .form = "at(series, place)", .rule = Rule::place, .least = 2, .most = 2},
    {"max", "max(series) or max(a, b)", Rule::selection, 1, any_number, highest, nullptr, greater},
    {"min", "min(series) or min(a, b)", Rule::selection, 1, any_number, lowest, nullptr, smaller},
    magnitude(map(
        "abs", "abs(x)", Rule::same, [](double x) { return std::abs(x); }, nullptr, nullptr)),
    magnitude(map(
        "sqrt", "sqrt(x)", Rule::root, [](double x) { return std::sqrt(x); }, sqrt, sqrt, 2)),
    map(
        "cbrt", "cbrt(x)", Rule::root, [](double x) { return std::cbrt(x); }, cbrt, cbrt, 3),
    map(
        "exp", "exp(x)", Rule::number, [](double x) { return std::exp(x); }, exp, exp),
    map(
        "ln", "ln(x)", Rule::number, [](double x) { return std::log(x); }, log, log),
    map(
        "sin", "sin(angle)", Rule::trigonometric, [](double x) { return std::sin(x); }, sin, sin),
    map(
        "cos", "cos(angle)", Rule::trigonometric, [](double x) { return std::cos(x); }, cos, cos),
    map(
        "tan", "tan(angle)", Rule::trigonometric, [](double x) { return std::tan(x); }, tan, tan),
    map(
        "asin", "asin(x)", Rule::inverse, [](double x) { return std::asin(x); }, asin, asin),
    map(
        "acos", "acos(x)", Rule::inverse, [](double x) { return std::acos(x); }, acos, acos),
    map(
        "atan", "atan(x)", Rule::inverse, [](double x) { return std::atan(x); }, atan, atan),
    {.name = "atan2",
     .form = "atan2(y, x)",
     .rule = Rule::ratio,
     .least = 2,
     .most = 2,
     .join = [](double y, double x) { return std::atan2(y, x); },
     .jet_of_two = atan2,
     .bounds_of_two = atan2},
    {.name = "hypot",
     .form = "hypot(x, y)",
     .rule = Rule::root,
     .least = 2,
     .most = 3,
     .degree = 2,
     .is_magnitude = true,
     .is_resultant = true},
    {.name = "mises",
     .form = "mises(sigma, tau)",
     .rule = Rule::stresses,
     .least = 2,
     .most = 2,
     .join = [](double sigma, double tau) { return std::sqrt(sigma * sigma + 3.0 * tau * tau); },
     .is_magnitude = true},
};

}  // namespace

const Function* find_function(std::string_view name) {
  const auto* found =
      std::find_if(std::begin(functions), std::end(functions), [name](const Function& f) { return f.name == name; });
  return found == std::end(functions) ? nullptr : found;
}

std::vector<std::string> function_names() {
  std::vector<std::string> names;
  for (const Function& f : functions) names.emplace_back(f.name);
  return names;
}

}  // namespace loadpath::expression
