// What the tests of sections share.
#pragma once

#include "calculators/section/properties/properties.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace loadpath::section {

inline double rel(double value, double expected) { return std::abs(value - expected) / std::abs(expected); }
template <class Quantity>
double rel(const Quantity& value, const Quantity& expected) {
  return rel(in_si(value), in_si(expected));
}

template <class C>
typename C::Result solve(const typename C::Input& in) {
  NoTrace trace;
  return C::evaluate(in, trace);
}

/// The text of the first rule that an input breaks; empty where it breaks none.
template <class C>
std::string broken(const typename C::Input& in) {
  for (const auto& rule : C::rules) {
    if (!rule.holds(in)) return rule.text;
  }
  return {};
}

}  // namespace loadpath::section
