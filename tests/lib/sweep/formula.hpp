// A function of a point from a lambda, which counts its points.
#pragma once

#include "lib/sweep/function.hpp"

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace loadpath::sweep::testing {

class Formula : public Function {
 public:
  using Body = std::function<void(const double* x, double* y)>;
  Formula(std::size_t inputs, std::size_t outputs, Body formula) : x(inputs), y(outputs), body(std::move(formula)) {}

  [[nodiscard]] std::size_t inputs() const override { return x.size(); }
  [[nodiscard]] std::size_t outputs() const override { return y.size(); }
  void evaluate(std::span<const double* const> in, std::span<double* const> out, std::size_t n) override {
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t i = 0; i < x.size(); ++i) x[i] = in[i][k];
      body(x.data(), y.data());
      for (std::size_t i = 0; i < y.size(); ++i) out[i][k] = y[i];
    }
    points += n;
  }

  std::uint64_t points = 0;

 private:
  std::vector<double> x, y;
  Body body;
};

}  // namespace loadpath::sweep::testing
