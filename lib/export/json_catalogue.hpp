// The contents of the program in machine-readable form: calculators with their fields, tables with their rows.
// Numbers in SI.
#pragma once

#include "lib/calculator/calculator.hpp"
#include "lib/table/table.hpp"

#include <string>
#include <vector>

namespace loadpath::exports {

/// A calculator or a template in a list.
struct Listed {
  const Calculator* calculator = nullptr;
  std::string id;
  std::string title;
  std::string found_by;  // "title", "synonym"; the list is an answer to a search
  std::string found_in;  // the synonym or failure mode; empty where there is none
};
/// A search word without any calculator.
struct Beyond {
  std::string what;
  std::vector<std::string> nearest;  // ids
};
/// Titles, scopes and synonyms.
std::string json_of(const std::vector<Listed>& list, const std::vector<Beyond>& beyond);
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
