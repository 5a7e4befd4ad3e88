// The threads of a rank that solve parts; the main thread, the only one to communicate with other ranks, gives and
// takes them.
#pragma once

#include "cli/mpi/messages.hpp"

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace loadpath::cli {

class Pool {
 public:
  Pool(const project::SweepWork& work, unsigned threads);
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  void give(project::BlockRange blocks);
  /// A finished part, if there is one. Rethrows the exception of a thread.
  std::optional<Solved> take();

 private:
  void run(const project::SweepWork& work);
  void solve(const project::SweepWork& work);
  /// None once there are no more.
  std::optional<project::BlockRange> next();

  std::mutex mutex_;
  std::condition_variable given_;
  std::deque<project::BlockRange> left_;
  std::deque<Solved> done_;
  std::exception_ptr failure_;
  bool over_ = false;
  std::vector<std::jthread> threads_;
};

}  // namespace loadpath::cli
