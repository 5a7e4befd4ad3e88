// The derivation of a value of a solved step: the lines of its calculation that it follows from, their inputs, and
// the choices involved.
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

/// The derivation of the value at a path: "u_tau", "segments.journal.tau". Empty if no formula gives it.
Reasons reasons_of(const account::Account& account, const std::string& path);

/// The inputs that the verdicts of a step follow from; none if no formula is written out.
std::vector<const account::Entry*> deciding_inputs(const account::Account& account);

/// The lines of a calculation as a report writes it out: all but those of elements of lists that checks assess. From
/// these, lines remain that checks or results of the part follow from, because results of other methods are in the
/// tables; if a calculator writes out only a few elements, only the governing ones, because `why` shows the rest.
std::vector<account::Derived> deciding_lines(const account::Account& account);

/// Searched inputs, with the search's remarks: rows, sizes, loads.
std::vector<const account::Entry*> chosen(const account::Account& account);

/// The failure mode that decides over a part: the worst, among like ones the most utilised; one that is open only
/// if there is no other. Nothing if there is none.
std::optional<account::Mode> deciding(const account::Modes& modes);

/// The mode whose formulas explain the verdict of a part: a failing one, else the most utilised; nothing if none has
/// a value.
std::optional<account::Mode> explaining(const account::Modes& modes);

}  // namespace loadpath::report
