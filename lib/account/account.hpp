// What a solved step has to say. Reports, JSON, the terminal and `verify` are written from it.
#pragma once

#include "lib/account/block.hpp"
#include "lib/account/mode.hpp"
#include "lib/account/verdict.hpp"
#include "lib/calculator/field.hpp"
#include "lib/quantity/series.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace loadpath::account {

/// The candidate before the one that a search has found, and what it fails.
struct NextSize {
  std::string name;                   // "95 mm", a row of a table
  std::optional<double> si = {};      // none of a row
  std::string fails = {};             // a check or a limit, "u_theta", "seats.coupling.x_c"; empty: a rule
  std::string mode = {};              // that it decides: "twist"; may be empty
  Message title = {};                 // of that mode
  std::optional<double> number = {};  // the utilisation, or the value of the limit
  std::string unit = {};              // of that value; "-" of a utilisation
  Message reason = {};                // "u_theta = 1.055"
};

/// Where a value comes from, for the report: typed, an expression, a row of a table, a default.
struct Origin {
  Message text;
  std::vector<std::string> sources;   // keys of tables/sources.toml
  bool recalled = false;              // the row's source was not seen: flagged in the report
  bool searched = false;              // found by a search
  bool assumed = false;               // the default: nobody gave it
  std::optional<NextSize> next = {};  // of what a search has found
};

/// A named quantity of a step.
struct Entry {
  std::string path;  // within the step: "segments[2].tau"
  std::string doc;   // a message id
  std::string unit;  // display unit
  Role role = Role::result;
  Value value;
  Origin origin;             // inputs only
  std::string word;          // a choice or a name instead of a number
  bool is_factor = false;    // inputs only: see Field::factor
  Message missing = {};      // why there is no value, or none at some positions; empty: "not available"
  bool brief = true;         // results only: worth a line where there is little room
  bool handed_over = false;  // results only: of a record for other steps, shown where they take it
};

/// Whether nothing is known of it, at no position.
bool is_open(const Entry& entry);

/// A line of the calculation; the scope names the element of a list that it belongs to ("segments[2]").
struct Derived {
  std::string scope;
  Step step;
  std::string element = {};  // the scope by the element's name, where it has one: "methods.johnson"
};

struct Account {
  std::vector<Entry> inputs;
  std::vector<Entry> results;
  std::vector<Verdict> verdicts;    // of checks and limits
  Modes modes;                      // what they amount to: the verdict on the part
  std::vector<Message> warnings;    // customs that the input breaks
  Message governing;                // which position the derivation is for; empty where there is one value
  std::vector<Derived> derivation;  // where formulas are wanted
  std::set<std::string> scopes;     // what its lines are about: "", "methods[2]"; known without it
  std::vector<Block> input_blocks;  // where the step shows its inputs itself, not in a list; where pictures are wanted
  std::vector<Block> blocks;        // what only this kind of step has: tables, notes; where pictures are wanted
  std::vector<draw::Figure> figures;  // where pictures are wanted
  std::vector<std::string> sources;   // keys of tables/sources.toml, beside those that the calculator always cites
};

}  // namespace loadpath::account
