// Many designs, column by column. Numbers are SI; missing values are NaN, with the reason in the column `state`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <loadpath/error.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::api {

struct Column {
  std::string name;                // "rod.mass", "state"
  std::string si_unit;             // SI unit of the values: "Pa"
  std::string unit;                // display unit: "MPa"
  std::vector<std::string> words;  // words of a choice: the values are their indices, from 0
  std::vector<double> values;
};

/// Points that were refused for one reason.
struct Refused {
  std::uint64_t count = 0, first = 0;
  std::string key, message;  // path and message of the first point
};

struct Sweep {
  std::uint64_t points = 0;
  std::vector<Column> columns;   // inputs of the project, requested results, `state`, `utilisation`
  std::vector<Refused> refused;  // in the order of their first points
  std::string summary;           // projects only: the output of `loadpath sweep --json`

  /// Null if there is none of the name.
  [[nodiscard]] const Column* find(std::string_view name) const;
  /// An Error with the nearest name if there is none.
  const Column& operator[](std::string_view name) const;
};

struct SweepOptions {
  /// Expressions over results, "m = rod.mass", "rod.utilisation", "rod.modes.buckling", in addition to those of the
  /// file. For a calculator, names of its results; default: all numeric ones.
  std::vector<std::string> results = {};
  unsigned jobs = 0;    // number of threads; 0: one per processor core. The values do not depend on it.
  bool strict = false;  // modes not considered count as not assessed

  // Projects only: replaces the values in the file.
  std::optional<std::uint64_t> samples = {}, seed = {};
  bool latin = false;
  std::vector<std::vector<std::string>> zip = {};
  bool rows = true;  // false: only the summary, in constant memory

  /// Called now and then, in the caller's thread; false ends the sweep with an Error.
  std::function<bool(std::uint64_t done, std::uint64_t all)> goes_on = {};
};

}  // namespace loadpath::api
