// Inputs of a sweep and their units in JSON.
#pragma once

#include "lib/export/json_writer.hpp"
#include "lib/project/sweep/axes.hpp"

#include <string>

namespace loadpath::exports {

/// "1" of a number.
inline std::string si_of(const Dimension& dimension) {
  const std::string unit = si_unit(dimension);
  return unit.empty() ? "1" : unit;
}

/// A number in SI, or the word of that number.
inline void write_value(JsonWriter& json, const project::SweptInput& input, double value) {
  if (input.words.empty())
    json.write(value);
  else
    json.write(input.words[static_cast<std::size_t>(value)]);
}

}  // namespace loadpath::exports
