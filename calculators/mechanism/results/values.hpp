// The results of a solved mechanism, as values of its account.
#pragma once

#include "calculators/mechanism/cycle/rounding.hpp"
#include "calculators/mechanism/results/output.hpp"
#include "calculators/mechanism/results/solved.hpp"
#include "lib/account/account.hpp"

#include <functional>
#include <string>
#include <vector>

namespace loadpath::planar {

/// Whether the series of a path is wanted.
using Wants = std::function<bool(const std::string& path)>;

/// The results of an account, in the order of `outputs`, cleared of rounding errors; series that are not wanted have no
/// values. `read`: outputs of the solved mechanism, which is smaller than the given one if joints were
/// overconstrained.
void fill_results(const std::vector<Output>& outputs, const std::vector<Output>& read, const Solved& solved,
                  const Magnitudes& magnitudes, const Wants& wants, account::Account& account);

}  // namespace loadpath::planar
