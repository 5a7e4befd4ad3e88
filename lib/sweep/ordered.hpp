// Work on many parts by several threads, passed on in the order of the parts, so that output and sums are the same
// for any number of threads.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace loadpath::sweep {

/// The parts first ... last - 1. `make_worker` is called once by each of `jobs` threads and gives a function from
/// part to Done; `take` is called by the caller's thread, part after part, and ends the work early with false. An
/// exception of a worker ends it too, and is rethrown here.
template <class Done>
class Ordered {
 public:
  using Worker = std::function<Done(std::uint64_t part)>;
  using MakeWorker = std::function<Worker()>;
  using Take = std::function<bool(std::uint64_t part, Done&& done)>;

  Ordered(std::uint64_t first, std::uint64_t last, unsigned jobs) : next_(first), taken_(first), last_(last) {
    window_ = 4 * static_cast<std::uint64_t>(jobs);
    jobs_ = jobs;
  }

  void run(const MakeWorker& make_worker, const Take& take) {
    {
      std::vector<std::jthread> threads;
      for (unsigned i = 0; i < jobs_; ++i) threads.emplace_back([this, &make_worker] { work(make_worker); });
      collect(take);
    }
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void work(const MakeWorker& make_worker) {
    try {
      const Worker worker = make_worker();
      for (std::uint64_t part = claim(); part < last_; part = claim()) hand_on(part, worker(part));
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      stopped_ = true;
      changed_.notify_all();
    }
  }
  /// The next part; past the last if there is none. Waits while too many finished parts have not been taken.
  std::uint64_t claim() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopped_ || next_ >= last_ || next_ < taken_ + window_; });
    return stopped_ || next_ >= last_ ? last_ : next_++;
  }
  void hand_on(std::uint64_t part, Done done) {
    const std::scoped_lock lock(mutex_);
    done_.emplace(part, std::move(done));
    changed_.notify_all();
  }
  void collect(const Take& take) {
    std::unique_lock lock(mutex_);
    while (taken_ < last_) {
      changed_.wait(lock, [this] { return stopped_ || done_.contains(taken_); });
      if (stopped_) return;
      auto node = done_.extract(taken_);
      lock.unlock();
      const bool goes_on = take(node.key(), std::move(node.mapped()));
      lock.lock();
      ++taken_;
      stopped_ = stopped_ || !goes_on;
      changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::uint64_t, Done> done_;
  std::uint64_t next_, taken_, last_, window_ = 0;
  unsigned jobs_ = 1;
  bool stopped_ = false;
  std::exception_ptr failure_;
};

}  // namespace loadpath::sweep
