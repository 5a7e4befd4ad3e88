#include "cli/mpi/pool.hpp"

#include <chrono>

namespace loadpath::cli {

Pool::Pool(const project::SweepWork& work, unsigned threads) {
  for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this, &work] { run(work); });
}

Pool::~Pool() {
  const std::scoped_lock lock(mutex_);
  left_.clear();
  over_ = true;
  given_.notify_all();
}

void Pool::give(project::BlockRange blocks) {
  const std::scoped_lock lock(mutex_);
  left_.push_back(blocks);
  given_.notify_one();
}

std::optional<Solved> Pool::take() {
  const std::scoped_lock lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
  if (done_.empty()) return std::nullopt;
  std::optional<Solved> first = std::move(done_.front());
  done_.pop_front();
  return first;
}

std::optional<project::BlockRange> Pool::next() {
  std::unique_lock lock(mutex_);
  given_.wait(lock, [this] { return over_ || !left_.empty(); });
  if (over_) return std::nullopt;
  const project::BlockRange blocks = left_.front();
  left_.pop_front();
  return blocks;
}

void Pool::run(const project::SweepWork& work) {
  try {
    solve(work);
  } catch (...) {
    const std::scoped_lock lock(mutex_);
    failure_ = std::current_exception();
  }
}

void Pool::solve(const project::SweepWork& work) {
  using Clock = std::chrono::steady_clock;
  project::PartSolver solver(work);
  while (const auto blocks = next()) {
    const auto begun = Clock::now();
    project::SweptPart part = solver.solve(*blocks);
    const std::chrono::duration<double> time = Clock::now() - begun;
    const std::scoped_lock lock(mutex_);
    done_.push_back({std::move(part), time.count()});
  }
}

}  // namespace loadpath::cli
