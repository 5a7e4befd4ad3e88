// Helpers for tests of calculators: the results of an input, and the distance of values.
#pragma once

#include "lib/calculator/trace.hpp"
#include "lib/quantity/unit.hpp"

#include <cmath>

namespace loadpath::test {

inline double rel(double value, double expected) { return std::abs(value - expected) / std::abs(expected); }
template <class Quantity>
double rel(const Quantity& value, const Quantity& expected) {
  return rel(in_si(value), in_si(expected));
}

template <class C>
typename C::Result evaluated(const typename C::Input& in) {
  NoTrace trace;
  return C::evaluate(in, trace);
}

}  // namespace loadpath::test
