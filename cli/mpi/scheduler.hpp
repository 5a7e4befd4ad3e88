// The first rank of a sweep: hands out blocks as the others request them, and passes on their results in the order of
// the points, so that the output is the same for any number of ranks. It solves none itself and sleeps in between.
//
// Parts take some tenths of a second: their size does not affect the results. Helpers are given no more while
// finished parts wait for earlier ones, so that memory is bounded.
#pragma once

#include "cli/mpi/messages.hpp"
#include "cli/mpi/ranks.hpp"

#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace loadpath::cli {

class Scheduler {
 public:
  Scheduler(const Ranks& ranks, const project::SweepWork& work, const Listener& listener);
  /// Empty, or why the ranks cannot help.
  std::string run(const SharedSweep& shared);

 private:
  struct Helper {
    bool heard = false;  // has sent its greeting
    std::uint64_t room = 0;
    std::string name;
    std::vector<project::BlockRange> parts;  // parts in progress
  };
  using Clock = std::chrono::steady_clock;

  void receive(const RankMessage& message);
  void hear(Helper& helper, const Handshake& handshake);
  void receive_part(Helper& helper, const std::string& bytes);
  void hand_out();
  bool hand_on();
  void report_late_ranks();
  [[nodiscard]] std::string points_of(const project::BlockRange& part) const;
  [[nodiscard]] bool can_give() const;
  [[nodiscard]] bool is_over() const;
  [[nodiscard]] std::uint64_t size_of_part() const;

  const Ranks& ranks_;
  const project::SweepWork& work_;
  const Listener& listener_;
  project::SweepStatistics none_;
  std::vector<Helper> helpers_;
  std::map<std::uint64_t, project::SweptPart> done_;  // by first block
  std::uint64_t next_, taken_;                        // blocks: to hand out, to hand on
  std::uint64_t room_ = 0;                            // parts of all helpers
  double seconds_of_block_ = 0.0;
  bool stopped_ = false;
  std::string wrong_;
  Clock::time_point last_message_ = Clock::now();
  std::string told_late_;
};

}  // namespace loadpath::cli
