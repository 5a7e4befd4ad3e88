#include "cli/sweep/point_files.hpp"

#include "lib/export/sweep/csv.hpp"

#include <iostream>

namespace loadpath::cli {

static bool unwritten(const std::string& path) {
  std::cerr << "loadpath: cannot write '" << path << "'\n";
  return false;
}

bool PointFiles::write(const std::string& lines) {
  return std::fwrite(lines.data(), 1, lines.size(), csv_.get()) == lines.size() || unwritten(options_.csv);
}

bool PointFiles::open(const exports::StoredSweep& sweep) {
  if (!options_.hdf5.empty()) {
    auto file = exports::Hdf5File::create(staged_.aside(options_.hdf5), plan_, sweep);
    if (!file) return unwritten(options_.hdf5);
    hdf5_ = std::move(*file);
  }
  if (options_.csv.empty()) return true;
  csv_.reset(staged_.open(options_.csv));
  return csv_ ? write(exports::csv_head(plan_)) : unwritten(options_.csv);
}

bool PointFiles::take(const project::SweptPart& part) {
  std::string lines;
  for (const project::SolvedBlock& block : part.rows) {
    if (csv_) exports::append_csv(plan_, block, lines);
    if (!options_.hdf5.empty() && !hdf5_.append(block).empty()) return unwritten(options_.hdf5);
  }
  return !csv_ || write(lines);
}

bool PointFiles::finish() {
  if (!any()) return true;
  if (csv_ && std::fclose(csv_.release()) != 0) return unwritten(options_.csv);
  if (!options_.hdf5.empty() && !hdf5_.close().empty()) return unwritten(options_.hdf5);
  return staged_.finish();
}

}  // namespace loadpath::cli
