#include "calculators/column/stepped/critical.hpp"

#include "calculators/column/member/stiffness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace loadpath::column {

namespace {

constexpr std::size_t elements = 8;  // of a piece
using ColumnStiffness = BandStiffness<most_pieces * elements + 1>;

/// Slope, its derivative and its integral at the upper end of an element of length 1.
struct ElementEnd {
  double slope, bend, rise;
};

/// The solution of phi'' + (p_0 + p_1 s) phi = c from these values at s = 0, by its power series.
ElementEnd series(double p_0, double p_1, double slope, double bend, double c) {
  constexpr int terms = 60;
  double before = 0.0, a = slope, next = bend;  // coefficients k - 1, k, k + 1
  ElementEnd sum{a + next, next, a + 0.5 * next};
  for (int k = 0; k < terms; ++k) {
    const double constant = k == 0 ? c : 0.0;
    const double a_2 = (constant - p_0 * a - p_1 * before) / ((k + 1.0) * (k + 2.0));
    sum.slope += a_2, sum.bend += (k + 2.0) * a_2, sum.rise += a_2 / (k + 3.0);
    before = a, a = next, next = a_2;
  }
  return sum;
}

/// Forces and moments at the ends of an element of length l and stiffness EI by its deflections and angles.
using Element = std::array<std::array<double, 4>, 4>;

/// p: alpha N l^2/(E I) at the lower and the upper end.
Element element_of(double EI, double l, double p_l, double p_u) {
  const double p_1 = p_u - p_l;
  const ElementEnd turned = series(p_l, p_1, 1.0, 0.0, 0.0), bent = series(p_l, p_1, 0.0, 1.0, 0.0),
                   sheared = series(p_l, p_1, 0.0, 0.0, 1.0);
  const double determinant = bent.rise * sheared.slope - sheared.rise * bent.slope;
  Element k{};
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<double, 4> at{};  // lower deflection and angle, upper ones
    at[i] = 1.0;
    const double rise = (at[2] - at[0]) / l - turned.rise * at[1], slope = at[3] - turned.slope * at[1];
    const double m = (rise * sheared.slope - sheared.rise * slope) / determinant;
    const double c = (bent.rise * slope - bent.slope * rise) / determinant;
    const double F = EI * c / (l * l), bend = at[1] * turned.bend + m * bent.bend + c * sheared.bend;
    k[0][i] = F, k[1][i] = -EI * m / l, k[2][i] = -F, k[3][i] = EI * bend / l;
  }
  return k;
}

/// The stiffness of the column under alpha times its loads, in the length of the column and the largest stiffness.
ColumnStiffness stiffness_at(const Pieces& pieces, const End& foot, const End& top, double alpha) {
  double length = 0.0, largest = 0.0;
  for (const Piece& piece : pieces) length += piece.l, largest = std::max(largest, piece.EI);
  ColumnStiffness stiffness;
  std::size_t node = 0;
  for (const Piece& piece : pieces) {
    const double l = piece.l / elements, to_p = alpha * l * l / piece.EI;
    for (std::size_t i = 0; i < elements; ++i, ++node) {
      const auto force_at = [&](std::size_t n) {
        return piece.N_l + (piece.N_u - piece.N_l) * static_cast<double>(n) / elements;
      };
      const Element k = element_of(piece.EI / largest, l / length, to_p * force_at(i), to_p * force_at(i + 1));
      for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = row; column < 4; ++column)
          stiffness.add(2 * node + row, 2 * node + column, 0.5 * (k[row][column] + k[column][row]));
      }
    }
  }
  stiffness.size = 2 * (node + 1);
  add_ends(stiffness, foot, top, node);
  return stiffness;
}

int criticals_within(const Pieces& pieces, const End& foot, const End& top, double alpha) {
  return stiffness_at(pieces, foot, top, alpha).factor();
}

}  // namespace

double critical_factor(const Pieces& pieces, const End& foot, const End& top) {
  // A piece that is held at both of its ends buckles at N l^2/(E I) = 74.6 at its lower end or less, and the column
  // before; there an element of it has 400/64, which is below the 39 of its own.
  constexpr double beyond = 400.0, least = 1e-15;
  double high = std::numeric_limits<double>::infinity();
  for (const Piece& piece : pieces) {
    if (piece.N_l > 0.0) high = std::min(high, beyond * piece.EI / (piece.N_l * piece.l * piece.l));
  }
  if (std::isinf(high)) return high;
  double low = high;
  while (low > least * high && criticals_within(pieces, foot, top, low) > 0) low *= 0.25;
  if (!(low > least * high)) return std::numeric_limits<double>::quiet_NaN();
  high = std::min(high, 4.0 * low);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (criticals_within(pieces, foot, top, middle) == 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

Shape critical_shape(const Pieces& pieces, const End& foot, const End& top, double alpha) {
  ColumnStiffness stiffness = stiffness_at(pieces, foot, top, alpha * (1.0 - 1e-7));
  stiffness.factor();
  const std::vector<double> mode = mode_of(stiffness);
  Shape shape{{0.0}, {mode[0]}};
  double from = 0.0;
  for (const Piece& piece : pieces) {
    for (std::size_t i = 1; i <= elements; ++i) {
      shape.x.push_back(from + piece.l * static_cast<double>(i) / elements);
      shape.w.push_back(mode[2 * (shape.x.size() - 1)]);
    }
    from += piece.l;
  }
  const double largest =
      *std::max_element(shape.w.begin(), shape.w.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  for (double& w : shape.w) w /= largest;
  return shape;
}

}  // namespace loadpath::column
