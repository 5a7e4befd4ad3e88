// Points of a search on several threads: each once, with the values of one thread, and the exceptions of any.
#include "lib/sweep/threaded.hpp"

#include "lib/sweep/column_block.hpp"
#include "tests/lib/sweep/formula.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <stdexcept>
#include <thread>

using namespace loadpath::sweep;

namespace {

using testing::Formula;

void slow_sine(const double* x, double* y) {
  std::this_thread::sleep_for(std::chrono::microseconds(200));
  y[0] = std::sin(x[0]);
}

/// Slow, and from its 200th point on it waits for the other threads: without them no test would end.
Formula waiting(std::atomic<bool>& helped) {
  return {1, 1, [&helped, point = 0](const double* x, double* y) mutable {
            if (++point >= 200) helped.wait(false);
            slow_sine(x, y);
          }};
}

Columns evaluated(Function& function, std::size_t n) {
  Columns in(1, n), out(1, n);
  for (std::size_t k = 0; k < n; ++k) in[0][k] = static_cast<double>(k);
  function.evaluate(in.read(), out.write(), n);
  return out;
}

void help(std::atomic<bool>& helped) {
  helped = true;
  helped.notify_all();
}

}  // namespace

TEST_SUITE("threads of a search") {
  TEST_CASE("every number of threads evaluates every point once") {
    constexpr std::size_t n = 500;
    for (const unsigned jobs : {0U, 1U, 2U, 3U, 16U}) {
      CAPTURE(jobs);
      std::atomic<bool> helped{jobs < 2};
      std::atomic<std::uint64_t> points{0}, shown{0};
      Formula first = waiting(helped);
      const auto make = [&] {
        return std::make_unique<Formula>(1, 1, [&](const double* x, double* y) {
          slow_sine(x, y);
          ++points;
          help(helped);
        });
      };
      Threaded all(first, make, jobs, [&](std::uint64_t done) { shown = done; });
      const Columns out = evaluated(all, n);
      for (std::size_t k = 0; k < n; ++k) CHECK(out[0][k] == std::sin(static_cast<double>(k)));
      CHECK(first.points + points == n);
      CHECK(shown == n);
      CHECK(evaluated(all, 3)[0][2] == std::sin(2.0));
      CHECK(shown == n + 3);
    }
  }

  TEST_CASE("a few points are evaluated by one thread") {
    Formula first(1, 1, slow_sine);
    Threaded all(
        first, []() -> std::unique_ptr<Function> { throw std::logic_error("needed"); }, 4);
    for (int i = 0; i < 20; ++i) CHECK(evaluated(all, 15)[0][14] == std::sin(14.0));
  }

  TEST_CASE("an exception of a thread reaches the caller") {
    std::atomic<bool> helped{false};
    Formula first = waiting(helped);
    const auto make = [&]() -> std::unique_ptr<Function> {
      help(helped);
      throw std::runtime_error("no memory");
    };
    Threaded all(first, make, 2);
    CHECK_THROWS_WITH_AS(evaluated(all, 500), "no memory", std::runtime_error);
  }
}
