// Many machines, column by column. Numbers are SI; what has no value is NaN, with the reason in the column `state`.
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
  std::string si_unit;             // of the values: "Pa"
  std::string unit;                // that people read it in: "MPa"
  std::vector<std::string> words;  // of an input that takes words: the values are their numbers, from 0
  std::vector<double> values;
};

/// Points that were refused for one reason.
struct Refused {
  std::uint64_t count = 0, first = 0;
  std::string key, message;  // of the first
};

struct Sweep {
  std::uint64_t points = 0;
  std::vector<Column> columns;   // inputs of the project, results as asked for, `state`, `utilisation`
  std::vector<Refused> refused;  // in the order of their first points
  std::string summary;           // of a project: what `loadpath sweep --json` says

  /// Null where there is none of the name.
  [[nodiscard]] const Column* find(std::string_view name) const;
  /// An Error with the nearest name where there is none.
  const Column& operator[](std::string_view name) const;
};

struct SweepOptions {
  /// Expressions over results, "m = rod.mass", "rod.utilisation", "rod.modes.buckling", beside those of the file. Of a
  /// calculator names of its results; none: all that are numbers.
  std::vector<std::string> results = {};
  unsigned jobs = 0;    // threads; 0: as many as the machine has. The values do not hang on it.
  bool strict = false;  // what is open counts as not judged

  // Of a project alone: in place of what the file says.
  std::optional<std::uint64_t> samples = {}, seed = {};
  bool latin = false;
  std::vector<std::vector<std::string>> zip = {};
  bool rows = true;  // false: the summary alone, in constant memory

  /// Asked now and then, by the caller's thread; false ends the sweep with an Error.
  std::function<bool(std::uint64_t done, std::uint64_t all)> goes_on = {};
};

}  // namespace loadpath::api
