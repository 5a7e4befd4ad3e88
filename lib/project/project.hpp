// A project file: its steps, the order in which they follow from one another, and its expectations.
#pragma once

#include "lib/project/catalogue.hpp"
#include "lib/project/own_tables.hpp"
#include "lib/project/read/expectations.hpp"
#include "lib/project/read/shared.hpp"
#include "lib/project/read/sweep_settings.hpp"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace loadpath::project {

/// One solving of a step.
struct Pass {
  std::size_t step;
  /// Inputs that wait for a step which needs other results of this one: they are left open, and the step is solved
  /// again with them. Empty: solved whole.
  std::set<std::string> without;
};

struct Project {
  std::string file;
  std::string title;
  std::vector<std::pair<std::string, std::string>> meta;  // number, revision, author, checker, date, note: as typed
  std::string paper = "A4";                               // that reports are printed on; or "letter"
  std::string report;                                     // file that a run writes, next to the project; or none
  Values values;
  std::vector<std::unique_ptr<Step>> steps;     // in the order of the file
  std::set<std::string> unread;                 // names of steps that have an error instead of a calculator
  std::vector<std::size_t> order;               // of evaluation
  std::vector<Pass> passes;                     // of solving: in that order, but for steps that are solved twice
  std::vector<std::string> references;          // order of solving: like `order`, but some steps are solved twice
  std::shared_ptr<const table::Tables> tables;  // the project's own before the built-in ones
  Catalogue catalogue;                          // of which calculators its steps may be
  std::vector<NamedFile> files;                 // that were read beside its own
  std::map<std::string, Value> table_values;    // that expressions name: "tables.materials.S355.E"
  std::map<std::string, Value> beforehand;      // inputs that others take before their steps are solved
  std::vector<Expectation> expectations;
  SweepSettings sweep;
  bool strict = false;  // what is open counts as not judged

  [[nodiscard]] const Step* find(std::string_view name) const;
  /// That there is no step of a path's name, and which there may be.
  [[nodiscard]] Fault unknown_step(const std::string& path) const;
  /// Dimension and axis of "step.path", "values.n", "tables.materials.S355.E"; a Fault where there is none.
  [[nodiscard]] Outcome<Signature> signature(const std::string& path);
  /// The value at "step.path" after solving, or nothing.
  [[nodiscard]] const Value* value(const std::string& path) const;
};

/// "lever.drive.M" -> "lever", "drive.M".
std::pair<std::string, std::string> split_step(const std::string& path);
/// Whether a path names a value of a table: "tables.materials.S355.E".
bool is_of_tables(const std::string& path);

/// The checks and limits of all steps.
std::vector<account::Verdict> verdicts(const Project& project);
/// How the modes of failure of all parts came out, as strictly as the project is judged: the verdict.
account::Modes modes(const Project& project);

}  // namespace loadpath::project
