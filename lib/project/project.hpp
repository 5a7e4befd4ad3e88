// A project file: its steps, the order in which they follow from one another, and its expectations.
#pragma once

#include "lib/project/catalogue.hpp"
#include "lib/project/own_tables.hpp"
#include "lib/project/read/expectations.hpp"
#include "lib/project/read/shared.hpp"
#include "lib/project/read/sweep_settings.hpp"
#include "lib/project/takers/takers.hpp"

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
  /// again with them. Empty: a complete solution.
  std::set<std::string> without;
};

struct Project {
  std::string file;
  std::string title;
  std::vector<std::pair<std::string, std::string>> meta;  // number, revision, prepared, date, note: as typed
  std::string paper = "A4";                               // paper of reports; or "letter"
  std::string report;                                     // file that a run writes, next to the project; or none
  Values values;
  std::vector<std::unique_ptr<Step>> steps;     // in the order of the file
  std::set<std::string> unread;                 // names of steps that have an error instead of a calculator
  std::vector<std::size_t> order;               // order of evaluation
  std::vector<Pass> passes;                     // order of solving: like `order`, but some steps are solved twice
  std::vector<std::string> references;          // references between the steps: full paths, each once, sorted
  std::shared_ptr<const table::Tables> tables;  // the project's own before the built-in ones
  Catalogue catalogue;                          // calculators that its steps may use
  std::vector<NamedFile> files;                 // further files that were read
  std::map<std::string, Value> table_values;    // values named in expressions: "tables.materials.S355.E"
  std::map<std::string, Value> beforehand;      // inputs that others take before their steps are solved
  std::vector<Expectation> expectations;
  SweepSettings sweep;
  bool strict = false;  // modes not considered count as not assessed
  Takers takers;        // of all steps, once they are read

  [[nodiscard]] const Step* find(std::string_view name) const;
  /// The fault that no step has a path's name, with the possible names.
  [[nodiscard]] Fault unknown_step(const std::string& path) const;
  /// Dimension and axis of "step.path", "values.n", "tables.materials.S355.E"; a Fault if there is none.
  [[nodiscard]] Outcome<Signature> signature(const std::string& path);
  /// The value at "step.path" after solving, or nothing.
  [[nodiscard]] const Value* value(const std::string& path) const;
  /// Whether a step refers to this path: "limit.sigma_D".
  [[nodiscard]] bool is_referred_to(const std::string& path) const;
  /// The same, to one that begins with it: "press.".
  [[nodiscard]] bool is_referred_into(const std::string& beginning) const;
};

/// "lever.drive.M" -> "lever", "drive.M".
std::pair<std::string, std::string> split_step(const std::string& path);
/// Whether a path names a value of a table: "tables.materials.S355.E".
bool is_of_tables(const std::string& path);

/// The checks and limits of all steps.
std::vector<account::Verdict> verdicts(const Project& project);
/// How the failure modes of all parts came out, as strictly as the project is assessed: the verdict.
account::Modes modes(const Project& project);

}  // namespace loadpath::project
