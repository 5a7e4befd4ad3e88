// The progress of a long command, on standard error, if that is a terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace loadpath::cli {

class Progress {
 public:
  /// For so many points; 0: of a search, which ends when it has found its point. `wanted` false, or no terminal:
  /// nothing is shown.
  Progress(std::uint64_t total, bool wanted);

  /// At most a few times a second.
  void show(std::uint64_t done);
  /// Shows what the end of the sweep waits for. Without a terminal too: a job that is stuck is diagnosed from its
  /// output.
  void wait_for(const std::string& late);
  /// Takes the line away.
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  std::uint64_t total_;
  bool wanted_, shown_;
  Clock::time_point begun_, last_;
};

}  // namespace loadpath::cli
