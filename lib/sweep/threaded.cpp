#include "lib/sweep/threaded.hpp"

#include <algorithm>
#include <atomic>
#include <future>

namespace loadpath::sweep {

namespace {

constexpr std::size_t least_rows = 8;  // of a piece: starting a thread takes as long as some points

/// Most searches are over before further threads have read the project.
constexpr std::chrono::milliseconds worth_threads{20};

}  // namespace

struct Threaded::Batch {
  std::span<const double* const> in;
  std::span<double* const> out;
  std::size_t n;

  void evaluate(Function& function, std::size_t start, std::size_t count) const {
    std::vector<const double*> from(in.begin(), in.end());
    std::vector<double*> to(out.begin(), out.end());
    for (const double*& column : from) column += start;
    for (double*& column : to) column += start;
    function.evaluate(from, to, count);
  }
};

Threaded::Threaded(Function& first, Make make, unsigned jobs, Show show)
    : first_(first), make_(std::move(make)), show_(std::move(show)), others_(std::max(1U, jobs) - 1) {}

void Threaded::evaluate(std::span<const double* const> in, std::span<double* const> out, std::size_t n) {
  const Batch batch{in, out, n};
  if (others_.empty() || n < 2 * least_rows) {
    first_.evaluate(in, out, n);
  } else if (const std::size_t start = evaluate_alone(batch); start < n) {
    evaluate_together(batch, start);
  }
  evaluated_ += n;
  if (show_) show_(evaluated_);
}

/// The number of points that the caller's thread has evaluated when the rest is worth more threads.
std::size_t Threaded::evaluate_alone(const Batch& batch) {
  std::size_t start = 0;
  while (start < batch.n && spent_ < worth_threads) {
    const auto begun = std::chrono::steady_clock::now();
    const std::size_t count = std::min(least_rows, batch.n - start);
    batch.evaluate(first_, start, count);
    start += count;
    spent_ += std::chrono::steady_clock::now() - begun;
  }
  return start;
}

void Threaded::evaluate_together(const Batch& batch, std::size_t start) {
  const std::size_t piece = std::max(least_rows, (batch.n - start) / (4 * (others_.size() + 1)));
  std::atomic<std::size_t> next{start};
  const auto work = [&](Function& function) {
    for (std::size_t at = next.fetch_add(piece); at < batch.n; at = next.fetch_add(piece))
      batch.evaluate(function, at, std::min(piece, batch.n - at));
  };
  std::vector<std::future<void>> threads;
  for (std::unique_ptr<Function>& other : others_) {
    threads.push_back(std::async(std::launch::async, [&] {
      if (next >= batch.n) return;
      if (!other) other = make_();
      work(*other);
    }));
  }
  work(first_);
  for (std::future<void>& thread : threads) thread.get();
}

}  // namespace loadpath::sweep
