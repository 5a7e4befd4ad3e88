// Errors of outputs by tolerances of dimensions and masses and by the play of pins, over the cycle
// (lib/mechanism/accuracy/tolerance.hpp).
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/results/output.hpp"
#include "calculators/mechanism/words/names.hpp"
#include "lib/account/block.hpp"
#include "lib/mechanism/accuracy/tolerance.hpp"

#include <string>
#include <vector>

namespace loadpath::planar {

/// Of all outputs that a project asks for, in its order.
struct Errors {
  std::vector<std::vector<mechanism::OutputError>> at;  // of each output, at every position; `shares` in the order of
                                                        // `names`
  std::vector<Message> names;                           // of the tolerances, then of the pins with play
};

/// Tolerances and outputs that do not say what they are of, or of what is not there. Needs no values.
void check_accuracy(NameFaults& faults);

/// Tolerances as wide as what they are of: lengths, radii, masses. Needs values, and names that are right.
std::vector<FieldFault> check_half_widths(const Mechanism::Input& in);

/// Empty where nothing is asked for. Positions without forces have no error of forces.
Errors errors_of(const Mechanism::Input& in, const mechanism::Model& model, const Cycle& cycle);

void add_error_outputs(const Mechanism::Input& in, std::vector<Output>& out);
void list_error_patterns(std::vector<ResultPattern>& patterns);

/// What has which tolerance; nothing where nothing has.
std::vector<account::Table> tolerance_tables(const Mechanism::Input& in);
/// The largest errors, where they are and what contributes to them.
std::vector<account::Table> error_tables(const Mechanism::Input& in, const Errors& errors, const Axis* axis);

}  // namespace loadpath::planar
