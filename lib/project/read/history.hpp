// A quantity over time from a file next to the project, sigma = { file = "gauge.csv", column = "S2", unit = "MPa" },
// or in the project itself: { values = [0, 3, -1], unit = "MPa" }. The file may have any length; only reversals are
// kept, which suffice for all cycle counting; for synchronous series, every sample.
#pragma once

#include "lib/calculator/record.hpp"
#include "lib/text/issue.hpp"
#include "lib/toml/tree.hpp"

#include <memory>

namespace loadpath::project {

/// Whether a value of a project refers to such a file.
bool names_history_file(const toml::Tree& tree);
/// Whether it is a history, of a file or typed.
bool is_history(const toml::Tree& tree);

struct History {
  std::shared_ptr<const Axis> axis;  // samples, counted from 0
  Value series;  // first and last sample and the reversals between, over that axis; all if synchronous
};

/// The samples to keep.
enum class Kept { turns, all };

struct HistoryFault {
  const char* key = "file";  // key that it is about
  Fault fault;
};
/// False, and a fault, where the file or a key of the table is wrong. The path of the file is taken from the folder of
/// the project; "-" is the standard input.
bool read_history(const toml::Tree& table, const FieldInfo& field, Kept kept, History& history, HistoryFault& fault);

}  // namespace loadpath::project
