// Helpers for the tests of sections.
#pragma once

#include "calculators/section/properties/properties.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace loadpath::section {

using test::rel;

template <class C>
constexpr auto solve = test::evaluated<C>;

/// The text of the first rule that an input breaks; empty if it breaks none.
template <class C>
std::string broken(const typename C::Input& in) {
  for (const auto& rule : C::rules) {
    if (!rule.holds(in)) return rule.text;
  }
  return {};
}

}  // namespace loadpath::section
