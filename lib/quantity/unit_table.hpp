// Every unit that is read, with its names in Latin, Cyrillic and in words, and the prefixes that it takes.
#pragma once

#include "lib/quantity/dimension.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath {

/// A prefix joins only names of its script: kN, кН, kilonewton.
enum class Script : std::uint8_t { latin, cyrillic, word };

struct Prefix {
  std::string_view name;
  Script script;
  char letter;  // the same prefix in another script or spelling has the same letter
  int ten;
};

/// Properties of a unit beyond its dimension.
enum class Mark : std::uint8_t {
  none = 0,
  minute = 1,        // 1/min counts revolutions where an angular velocity is expected
  hertz = 2,         // cycles, never revolutions
  work = 4,          // never a moment
  scale = 8,         // a point on a scale (°C), not a step
  run_together = 16  // Nm: a power of it is ambiguous
};

struct Prefixes {
  std::string_view usual;  // letters, the commonest first
  bool every = false;      // all of the table are read, not only the usual ones
};

struct UnitRow {
  std::string_view latin, cyrillic, words;  // names separated by '|'
  double factor;                            // with `ten`: SI value of one unit is factor * 10^ten
  int ten;
  Dimension dimension;
  Prefixes prefixes;
  Mark mark = Mark::none;
  double offset = 0.0;  // SI value of zero
};

struct FoundUnit {
  const UnitRow* row = nullptr;  // null: unknown unit
  int ten = 0;                   // power of ten of the prefix
  Script script = Script::latin;
};

/// A name with or without a prefix, in exactly this case.
FoundUnit find_unit(std::string_view name);

/// A name of the table with one of the prefixes that it takes (or none).
struct UnitName {
  std::string text;
  Script script;
  const UnitRow* row;
  int ten;
};
/// All names with the usual prefixes, or with every prefix that is read.
std::vector<UnitName> all_unit_names(bool usual_only);

}  // namespace loadpath
