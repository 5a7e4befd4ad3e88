#include "lib/project/verify.hpp"

#include "lib/quantity/literal.hpp"

#include <cmath>

namespace loadpath::project {

namespace {

Comparison compare(const Expectation& e, const Expression::Known& known) {
  Comparison c;
  c.expectation = &e;
  c.ours = e.value.evaluate(known).si[0];
  if (std::isinf(e.is.si)) {  // the value itself: in an expression an infinite number has no value
    c.ours = known(e.text).si[0];
    c.holds = c.ours == e.is.si;
    c.deviation = c.holds ? 0.0 : std::nan("");
    return c;
  }
  const double scale =
      e.is.si == 0.0 ? parse_unit(e.unit)->factor : std::abs(e.is.si);  // zero: relative to its own unit
  c.deviation = (c.ours - e.is.si) / scale;
  c.allowed = e.within      ? *e.within
              : e.within_si ? *e.within_si / scale
                            : half_unit(e.number, *e.digits) / (e.number == 0.0 ? 1.0 : std::abs(e.number));
  c.holds = std::abs(c.deviation) <= c.allowed * (1.0 + 1e-9);  // NaN does not hold
  return c;
}

}  // namespace

double half_unit(double value, int digits) {
  if (value == 0.0) return 0.5 * std::pow(10.0, -digits);
  return 0.5 * std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1.0 - digits);
}

std::vector<Comparison> compare(const Project& project) {
  static const Value none{{}, {std::nan("")}};
  const Expression::Known known = [&](const std::string& path) -> const Value& {
    const Value* value = project.value(path);
    return value == nullptr ? none : *value;
  };
  std::vector<Comparison> all;
  for (const Expectation& e : project.expectations) all.push_back(compare(e, known));
  return all;
}

}  // namespace loadpath::project
