// The stiffness of a straight bar in bending: a deflection and an angle at each node along it.
//
// What its elements bring is added by the calculators; from the factors follow the number of negative pivots, which
// counts critical loads (Wittrick and Williams), and the mode shape at a load where it is nearly singular.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace loadpath::column {

/// The symmetric stiffness of all nodes, deflection and angle in turn; a band of four next to the diagonal.
template <std::size_t nodes>
struct BandStiffness {
  static constexpr std::size_t most = 2 * nodes, band = 4;
  std::array<std::array<double, band>, most> rows{};  // rows[i][k] = K(i, i + k)
  std::size_t size = 0;

  void add(std::size_t i, std::size_t j, double k) { rows[std::min(i, j)][std::max(i, j) - std::min(i, j)] += k; }

  /// Fixed degrees of freedom are removed: row and column are cleared, the pivot is 1.
  void hold(std::size_t i) {
    for (std::size_t k = 0; k < band; ++k) {
      rows[i][k] = 0.0;
      if (k <= i) rows[i - k][k] = 0.0;
    }
    rows[i][0] = 1.0;
  }

  void support(std::size_t i, double spring) {
    if (std::isinf(spring)) {
      hold(i);
    } else {
      rows[i][0] += spring;
    }
  }

  /// Triangular factors in place; how many pivots are negative.
  int factor() {
    int negative = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const double pivot = rows[i][0] == 0.0 ? 1e-300 : rows[i][0];
      negative += pivot < 0.0 ? 1 : 0;
      for (std::size_t j = 1; j < band && i + j < size; ++j) {
        const double ratio = rows[i][j] / pivot;
        for (std::size_t k = j; k < band && i + k < size; ++k) rows[i + j][k - j] -= ratio * rows[i][k];
        rows[i][j] = ratio;
      }
      rows[i][0] = pivot;
    }
    return negative;
  }

  void solve(std::vector<double>& b) const {
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t k = 1; k < band && i + k < size; ++k) b[i + k] -= rows[i][k] * b[i];
    }
    for (std::size_t i = size; i-- > 0;) {
      b[i] /= rows[i][0];
      for (std::size_t k = 1; k < band && i + k < size; ++k) b[i] -= rows[i][k] * b[i + k];
    }
  }
};

/// The springs of both ends, `across` and `turning`.
void add_ends(auto& stiffness, const auto& start, const auto& end, std::size_t last) {
  stiffness.support(0, start.across);
  stiffness.support(1, start.turning);
  stiffness.support(2 * last, end.across);
  stiffness.support(2 * last + 1, end.turning);
}

/// By inverse iteration from the factors just below a critical load.
std::vector<double> mode_of(const auto& stiffness) {
  std::vector<double> mode(stiffness.size);
  for (std::size_t i = 0; i < mode.size(); ++i)
    mode[i] = 1.0 + 0.01 * static_cast<double>(i);  // no mode is at right angles
  for (int round = 0; round < 3; ++round) {
    stiffness.solve(mode);
    const double size = std::abs(
        *std::max_element(mode.begin(), mode.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
    for (double& w : mode) w /= size;
  }
  return mode;
}

}  // namespace loadpath::column
