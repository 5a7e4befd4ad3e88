// Counterweights that a project asks for, and what they leave of the shaking force (lib/mechanism/studies/shaking.hpp).
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/results/output.hpp"
#include "calculators/mechanism/words/names.hpp"
#include "lib/account/block.hpp"
#include "lib/mechanism/studies/shaking.hpp"

#include <optional>
#include <vector>

namespace loadpath::planar {

/// Empty where no counterweights are asked for or not every position closes.
struct Balanced {
  std::vector<mechanism::Counterweight> weights;  // in the order of the project
  mechanism::ShakingCycle before, after;          // moments about the global origin
  std::vector<mechanism::Shaking> left;           // with the counterweights, at every position
  bool knows_moment = false;                      // afterwards: every counterweight has a mass or a radius
};

/// Counterweights that say too little, or where there is nothing to balance. Needs no values.
void check_balance(NameFaults& faults);

Balanced balance_of(const Mechanism::Input& in, const mechanism::Model& model, const Cycle& cycle);

void add_balance_outputs(const Mechanism::Input& in, std::vector<Output>& out);
void list_balance_patterns(std::vector<ResultPattern>& patterns);

std::vector<account::Table> balance_tables(const Mechanism::Input& in, const Balanced& balanced);

}  // namespace loadpath::planar
