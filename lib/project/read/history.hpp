// A quantity over time in a file next to the project, sigma = { file = "gauge.csv", column = "S2",
// unit = "MPa" }, along a line of it, row = "S2", or in the project itself: { values = [0, 3, -1], unit = "MPa" }. The
// file is of any length; where the quantity turns is kept of it, which all counting of cycles rests on; where several
// are taken in step, every sample.
#pragma once

#include "lib/calculator/record.hpp"
#include "lib/text/issue.hpp"
#include "lib/toml/tree.hpp"

#include <memory>

namespace loadpath::project {

/// Whether a value of a project names such a file.
bool names_history_file(const toml::Tree& tree);
/// Whether it is a history, of a file or typed.
bool is_history(const toml::Tree& tree);

struct History {
  std::shared_ptr<const Axis> axis;  // samples, counted from 0
  Value series;  // the first and the last sample and where it turns between, over that axis; in step all of them
};

/// What of the samples is kept.
enum class Kept { turns, all };

struct HistoryFault {
  const char* key = "file";  // that it is about
  Place place = {};          // the line of the file; none where it is about the key
  Fault fault;
};
/// False, and a fault, where the file or a key of the table is wrong. The path of the file is taken from the folder of
/// the project; "-" is the standard input.
bool read_history(const toml::Tree& table, const FieldInfo& field, Kept kept, History& history, HistoryFault& fault);

}  // namespace loadpath::project
