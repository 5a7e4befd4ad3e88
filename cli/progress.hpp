// How far a long command is, on standard error, where someone looks.
#pragma once

#include <chrono>
#include <cstdint>

namespace loadpath::cli {

class Progress {
 public:
  /// Of so many points. `wanted` false, or no terminal: nothing is shown.
  Progress(std::uint64_t total, bool wanted);

  /// At most a few times a second.
  void show(std::uint64_t done);
  /// Takes the line away.
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  std::uint64_t total_;
  bool shown_;
  Clock::time_point begun_, last_;
};

}  // namespace loadpath::cli
