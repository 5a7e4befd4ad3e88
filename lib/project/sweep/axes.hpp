// The inputs of a project that take many values, each once: a value of [values] that many fields name is one.
#pragma once

#include "lib/project/project.hpp"

#include <set>
#include <string>
#include <vector>

namespace loadpath::project {

struct SweptInput {
  std::string name;  // "crankshaft.T", "values.n"
  std::string unit;  // unit of its field
  Dimension dimension;
  sweep::Axis axis;                                 // SI; of words 0, 1, 2...
  std::optional<sweep::Distribution> distribution;  // instead of the axis
  std::vector<std::string> words;                   // instead of numbers
  Place place;

  /// The destination of a value: fields of steps, and a literal of [values].
  struct Target {
    Step* step;
    std::size_t varied;  // index in its reading
  };
  std::vector<Target> targets;
  bool is_literal = false;
};

/// In the order of the file, those of [values] first.
std::vector<SweptInput> swept_inputs(Project& project);

/// The names of the steps that the inputs affect, directly or through other steps.
std::set<std::string> affected_steps(const Project& project, const std::vector<SweptInput>& inputs);
/// Adds the steps that take values of those.
void add_takers(const Project& project, std::set<std::string>& affected);

/// Gives the input a value in SI, or the number of a word. False, and an issue, where a field does not allow it: of a
/// range all values have been checked, of a sample none.
bool set_input(Project& project, const SweptInput& input, double value, std::vector<Issue>& issues);

/// "C45E", "200 N*m": a value as it would be typed.
std::string written(const SweptInput& input, double value);

}  // namespace loadpath::project
