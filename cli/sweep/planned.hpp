// A sweep as given by the options of `loadpath sweep`: the project that they change, the points, and what is kept of
// them.
#pragma once

#include "cli/commands.hpp"
#include "lib/project/sweep/sweep.hpp"
#include "lib/text/issue.hpp"

#include <string>
#include <utility>
#include <vector>

namespace loadpath::cli {

/// Prints why nothing is solved. The exit code.
int refuse(const std::string& message, const std::string& hint = {});

/// Stays where it is: others read the project again by it.
class PlannedSweep {
 public:
  PlannedSweep(const SweepOptions& asked, std::string file_text) : options(asked), text(std::move(file_text)) {}
  PlannedSweep(const PlannedSweep&) = delete;
  PlannedSweep& operator=(const PlannedSweep&) = delete;

  /// Sets project, points and what is kept.
  void plan(std::vector<Issue>& issues);
  /// The same, with its issues shown, and the share of the points; false if there is an error.
  bool prepare();
  /// Everything that the numbers follow from, line by line, so that a difference can be located.
  [[nodiscard]] std::string identity() const;
  [[nodiscard]] project::ReadAgain reading() const;
  [[nodiscard]] unsigned jobs() const;
  /// Prints errors of the options that name results. The exit code.
  [[nodiscard]] int refuse_all(const std::vector<Issue>& issues) const;

  const SweepOptions& options;
  const std::string text;
  project::Project project;
  project::SweepPlan points;
  project::Keep keep;
  project::BlockRange blocks;

 private:
  [[nodiscard]] project::Project read(std::vector<Issue>& issues) const;
  bool read_aims(std::vector<Issue>& issues);
  std::vector<project::Demand> ask_demands(std::vector<Issue>& issues);
  void read_demands(const std::vector<project::Demand>& demands);
  bool read_shard();
};

}  // namespace loadpath::cli
