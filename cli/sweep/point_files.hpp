// Every point of a sweep in separate files: as a line, or column by column. They are renamed into place once
// complete.
#pragma once

#include "cli/commands.hpp"
#include "cli/staged.hpp"
#include "lib/export/sweep/hdf5.hpp"
#include "lib/export/sweep/store.hpp"
#include "lib/project/sweep/sweep.hpp"

#include <cstdio>
#include <memory>
#include <string>

namespace loadpath::cli {

class PointFiles {
 public:
  PointFiles(const SweepOptions& options, const project::SweepPlan& plan, Scratch& scratch)
      : options_(options), plan_(plan), staged_(scratch) {}

  [[nodiscard]] bool any() const { return !options_.csv.empty() || !options_.hdf5.empty(); }
  // Each is false, with a word on standard error, where a file cannot be written.
  bool open(const exports::StoredSweep& sweep);
  bool take(const project::SweptPart& part);
  bool finish();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  bool write(const std::string& lines);

  const SweepOptions& options_;
  const project::SweepPlan& plan_;
  Staged staged_;
  std::unique_ptr<std::FILE, Close> csv_;
  exports::Hdf5File hdf5_;
};

}  // namespace loadpath::cli
