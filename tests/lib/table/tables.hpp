// Helpers for the tests of tables.
#pragma once

#include "lib/table/library.hpp"
#include "lib/table/reader.hpp"
#include "lib/table/table.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace loadpath::table {

constexpr double mm = 1e-3;
constexpr double MPa = 1e6;

/// A library with a file read into it.
inline Library with_file(Library base, std::string_view text, const std::string& file, std::vector<Issue>& issues) {
  Reader reader(base, issues);
  reader.read(text, file);
  reader.check_citations();
  return base;
}

inline Entry material(std::string_view name) {
  const auto found = find_row(built_in(), "material", name);
  REQUIRE_MESSAGE(found, name);
  return *found;
}

/// A property that may be missing: NaN then.
inline double value_of(const Entry& entry, std::string_view key, double size = no_size) {
  const auto found = property(entry, key, size);
  return found ? found->si : std::nan("");
}

}  // namespace loadpath::table
