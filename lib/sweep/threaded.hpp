// A function whose points several threads evaluate, for searches: each thread has a function of its own.
#pragma once

#include "lib/sweep/function.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace loadpath::sweep {

class Threaded final : public Function {
 public:
  using Make = std::function<std::unique_ptr<Function>()>;
  using Show = std::function<void(std::uint64_t points)>;

  /// `first` works in the caller's thread. `make` is called in each of the further threads when a batch is worth them:
  /// it gives a function with the values of `first` at every point. `show` takes the number of points evaluated so far.
  Threaded(Function& first, Make make, unsigned jobs, Show show = {});

  [[nodiscard]] std::size_t inputs() const override { return first_.inputs(); }
  [[nodiscard]] std::size_t outputs() const override { return first_.outputs(); }
  void evaluate(std::span<const double* const> in, std::span<double* const> out, std::size_t n) override;

 private:
  struct Batch;
  [[nodiscard]] std::size_t evaluate_alone(const Batch& batch);
  void evaluate_together(const Batch& batch, std::size_t start);

  Function& first_;
  Make make_;
  Show show_;
  std::vector<std::unique_ptr<Function>> others_;  // null until they are needed
  std::chrono::steady_clock::duration spent_{};    // by the caller's thread only
  std::uint64_t evaluated_ = 0;
};

}  // namespace loadpath::sweep
