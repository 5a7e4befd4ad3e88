// Suites that ctest runs in parts, so that all processors share them. tests/CMakeLists.txt reads the marks:
//   TEST_SUITE("laws" * by_element)   a ctest for each folder of calculators: "laws of shaft"
//   TEST_SUITE("golden" * by_example) a ctest for each folder of examples: "golden of lift"
//   TEST_SUITE("lsp" * by_case)       a ctest for each TEST_CASE: "lsp 3"
//   TEST_SUITE("kills" * takes_share) a ctest with the label "share": it calls tries(), see tests/tries.hpp
// Without LOADPATH_PART in the environment a suite runs all its parts.
#pragma once

#include "lib/calculator/calculator.hpp"

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::test {

/// A mark of a suite; doctest ignores it.
struct Mark {
  void fill(doctest::detail::TestSuite&) const {}
};
inline constexpr Mark by_element{}, by_example{}, by_case{}, takes_share{};

/// Whether this run covers an element ("shaft") or an example ("gear-stage"): all, or the one that LOADPATH_PART names.
bool takes(std::string_view part);
/// Whether LOADPATH_PART names one.
bool is_part();

/// The element "gear" of "gear.pair teeth".
std::string_view element_of(std::string_view id);
/// Whether a calculator or a row of a table, "gear.pair", belongs to an element that this run covers.
inline bool takes_id(std::string_view id) { return takes(element_of(id)); }

/// The elements of the calculators that a project names, in its order. Where a suite is split by element, the project
/// belongs to the first; where it names none, to the first of all.
std::vector<std::string> elements_of_project(const std::string& text);

/// The calculators of the catalogue that this run covers.
std::vector<const Calculator*> calculators_taken();

}  // namespace loadpath::test
