// The results of a solved step. Reports, JSON, the terminal and `verify` are written from it.
#pragma once

#include "lib/account/block.hpp"
#include "lib/account/mode.hpp"
#include "lib/account/verdict.hpp"
#include "lib/calculator/field.hpp"
#include "lib/quantity/series.hpp"

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace loadpath::account {

/// A candidate that a search did not take, and what it fails.
struct TriedSize {
  std::string name;                   // "95 mm", a row of a table
  std::optional<double> si = {};      // none of a row
  std::string fails = {};             // a check or a limit, "u_theta", "seats.coupling.x_c"; empty: a rule
  std::string mode = {};              // that it decides: "twist"; may be empty
  Message title = {};                 // title of that mode
  std::optional<double> number = {};  // the utilisation, or the value of the limit
  std::string unit = {};              // unit of that value; "-" for a utilisation
  Message reason = {};                // "u_theta = 1.055"
};

/// The origin of a value, for the report: typed, an expression, a row of a table, a default.
struct Origin {
  Message text;
  std::vector<std::string> sources;    // keys of tables/sources.toml
  bool recalled = false;               // the row's source was not seen: flagged in the report
  bool searched = false;               // found by a search
  bool assumed = false;                // default value, not given by the user
  std::optional<TriedSize> next = {};  // for a result of a search: the candidate before it
  std::vector<TriedSize> tried = {};   // for a search without a result: the candidates nearest to passing
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
  Message missing = {};      // reason for a missing value, or for missing positions; empty: "not available"
  bool brief = true;         // results only: worth a line where there is little room
  bool handed_over = false;  // results only: of a record for other steps, shown where they take it
  std::shared_ptr<const Value> series = {};  // inputs only: an entire series, then `value` has no numbers

  [[nodiscard]] const Value& values() const { return series == nullptr ? value : *series; }
};

/// Whether it is unknown at all positions.
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
  std::vector<Verdict> verdicts;        // states of checks and limits
  Modes modes;                          // the verdict on the part that follows from them
  std::vector<Message> warnings;        // customs that the input breaks
  Message governing;                    // position of the derivation; empty if there is one value
  std::vector<Derived> derivation;      // if formulas are requested
  std::set<std::string> scopes;         // subjects of its lines: "", "methods[2]"; known without it
  std::vector<Block> input_blocks;      // if the step shows its inputs itself, not in a list; if pictures are requested
  std::vector<Block> blocks;            // output specific to this kind of step: tables, notes; pictures on request
  std::vector<figure::Figure> figures;  // if pictures are requested
  std::vector<std::string> sources;     // keys of tables/sources.toml, besides those that the calculator always cites
};

}  // namespace loadpath::account
