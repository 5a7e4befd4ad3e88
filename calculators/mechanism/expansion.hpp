// From a template and its parameters to the links, joints and points of a mechanism.
#pragma once

#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/account/block.hpp"
#include "lib/calculator/calculator.hpp"
#include "lib/project/read/reading.hpp"

#include <string>
#include <vector>

namespace loadpath::planar {

/// Layout by the template, before any value is known.
Record laid_out(const Template& from);
/// Whether that has the value at this path, so that the user may not give it.
bool is_given_in(const Record& laid, const std::string& path);
/// Typed fields that the template gives. Needs no values.
std::vector<FieldFault> check_overrides(const Template& from, const project::Reading& reading);

/// Puts pins, angles and directions into the input that the template laid out, for the assembly at the first
/// position, and the moment of inertia of a slender bar where a bar has a mass and none is typed. Faults of the
/// geometry, or of a crank without its required full revolution, are returned; then the input is left unchanged.
/// `in_words`: the hint for a stopped crank gives the angles between which it can turn.
std::vector<FieldFault> expand(const Template& from, const project::Reading& reading, Mechanism::Input& in,
                               bool in_words);

/// The template and its parameters as a table of the report.
account::Table template_table(const Template& from, const Record& parameters);

}  // namespace loadpath::planar
