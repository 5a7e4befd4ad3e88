// A small project for the tests of expressions: a lever over a crank turn, a column over its height, single values.
#pragma once

#include "lib/quantity/expression/expression.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>

namespace loadpath::expression_test {

inline const Axis& crank() {
  static const Axis axis = [] {
    Axis a{"lever", "crank angle", "deg", {}, std::vector<double>(360, 1.0 / 360.0), 2.0 * std::numbers::pi};
    for (int i = 0; i < 360; ++i) a.at.add(i * std::numbers::pi / 180.0);
    return a;
  }();
  return axis;
}

inline const Axis& height() {
  static const Axis axis{"column", "height", "m", {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}, {}, 0.0};
  return axis;
}

template <class Function>
Value over(const Axis& axis, Dimension dimension, Function f) {
  Value value{{dimension, &axis}, {}};
  for (const double at : axis.at.numbers()) value.si.push_back(f(at));
  return value;
}

inline const std::map<std::string, Value>& world() {
  constexpr Dimension moment = Dimension::of(2, 1, -2), force = Dimension::of(1, 1, -2);
  static const std::map<std::string, Value> values{
      {"lever.drive.M", over(crank(), moment, [](double x) { return 20.0 + 60.0 * std::cos(x - 0.3); })},
      {"lever.joints.A.F", over(crank(), force, [](double x) { return 500.0 * std::sin(x); })},
      {"lever.omega", {{Dimension::of(0, 0, -1, 0, 1), nullptr}, {45.0}}},
      {"lever.mass", {{Dimension::of(0, 1, 0), nullptr}, {80.0}}},
      {"shaft.d", {{Dimension::of(1, 0, 0), nullptr}, {0.04}}},
      {"shaft.segments[2].tau", {{Dimension::of(-1, 1, -2), nullptr}, {30e6}}},
      {"shaft.missing", {{Dimension::of(1, 0, 0), nullptr}, {std::nan("")}}},
      {"column.N", over(height(), force, [](double x) { return -100.0 - x * x; })},
  };
  return values;
}

inline Outcome<Signature> declared(const std::string& path) {
  const auto found = world().find(path);
  if (found == world().end()) return Fault{7, 1, say("'{1}' has no result", path), say("did you mean 'lever.mass'?")};
  return found->second.signature;
}

inline const Value& known(const std::string& path) { return world().at(path); }

/// The fault of parsing, or else of checking; a message "none" where there is neither.
inline Fault fault_of(std::string_view text) {
  const auto parsed = Expression::parse(text);
  if (!parsed) return parsed.fault();
  const auto checked = parsed->check(declared);
  return checked ? Fault{0, 0, say("none"), {}} : checked.fault();
}

/// The value of a text that is right.
inline Value value_of(std::string_view text) {
  const auto parsed = Expression::parse(text);
  if (!parsed) throw std::runtime_error(parsed.fault().message.text());
  const auto checked = parsed->check(declared);
  if (!checked) throw std::runtime_error(checked.fault().message.text());
  return parsed->evaluate(known);
}

}  // namespace loadpath::expression_test
