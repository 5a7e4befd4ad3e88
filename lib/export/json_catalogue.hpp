// The contents of the program in machine-readable form: calculators with their fields, tables with their rows.
// Numbers in SI.
#pragma once

#include "lib/calculator/calculator.hpp"
#include "lib/table/table.hpp"

#include <string>
#include <vector>

namespace loadpath::exports {

/// Every calculator with its title.
std::string json_of(Calculators calculators);
/// One with its inputs, results, rules, failure modes, sources and example.
std::string json_of(const Calculator& calculator);

/// The tables and series that there are.
std::string json_index(const table::Library& library);
/// Rows with their values, those that depend on the size with the size up to which they hold.
std::string json_of(const std::vector<table::Entry>& rows);
std::string json_of(const table::Series& series);
/// The values whose source was not seen.
std::string json_of(const std::vector<table::Recalled>& values);

}  // namespace loadpath::exports
