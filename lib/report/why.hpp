// Why a value of a solved step is what it is: the lines of its calculation that it follows from, the inputs that these
// start from, and what was chosen on the way.
#pragma once

#include "lib/account/account.hpp"

#include <optional>
#include <string>
#include <vector>

namespace loadpath::report {

struct Reasons {
  std::vector<account::Derived> lines;        // in the order of the calculation
  std::vector<const account::Entry*> inputs;  // in the order of the account
};

/// What the value at a path follows from: "u_tau", "segments.journal.tau". Empty where no formula gives it.
Reasons reasons_of(const account::Account& account, const std::string& path);

/// The lines of a calculation as a report writes it out: all but those of elements of lists that checks judge. Of these
/// the lines stay that checks, or results of the whole part, follow from, for what other methods find stands in the
/// tables; where a calculator writes out a few elements only, what decides most, for the rest is as far as `why`.
std::vector<account::Derived> deciding_lines(const account::Account& account);

/// Inputs that were searched for, with what the search says of them: rows, sizes, loads.
std::vector<const account::Entry*> chosen(const account::Account& account);

/// The mode of failure that decides over a part: the worst, among like ones the most utilised; one that is open only
/// where there is no other. Nothing where there is none.
std::optional<account::Mode> deciding(const account::Modes& modes);

/// The mode whose formulas tell most of a part: that which fails, else the most utilised; nothing where none has a
/// value.
std::optional<account::Mode> telling(const account::Modes& modes);

}  // namespace loadpath::report
