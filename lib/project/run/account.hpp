// Conversion of the findings of an evaluation to an account.
#pragma once

#include "lib/project/run/governing.hpp"
#include "lib/project/run/typed_values.hpp"

namespace loadpath::project {

/// Findings of a solution.
struct Findings {
  Results results;
  WeighedValues weighed = {};
  Governing governing = {};
};
void fill_account(const Evaluation& evaluation, const Findings& found, const Wanted& wanted, Account& account);

}  // namespace loadpath::project
