#include "calculators/section/torsion/cells.hpp"

#include <cmath>

namespace loadpath::section {

namespace {

using Corners = ThinWalledTypes::Corners;
using Matrix = std::array<std::array<double, most_cells + 1>, most_cells>;

Length distance(const ThinWalledTypes::Corner& a, const ThinWalledTypes::Corner& b) {
  return from_si<Length>(std::hypot(in_si(b.y - a.y), in_si(b.z - a.z)));
}

/// Adds a wall to the equations of the cells on both of its sides.
void add(Matrix& a, const ThinWalledTypes::Input& in, const ThinWalledTypes::Wall& wall) {
  const std::size_t outside = in.cells.size();
  const std::size_t cell = cell_of(in, wall.cell), other = cell_of(in, wall.beside);
  const double delta = length_of(wall) / wall.t / modulus_ratio(in, wall);
  if (cell == outside) return;
  a[cell][cell] += delta;
  if (other == outside) return;
  a[other][other] += delta;
  a[cell][other] -= delta;
  a[other][cell] -= delta;
}

/// By elimination; the matrix is diagonally dominant, so the order of the cells will do.
void solve(Matrix& a, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = i + 1; k < n; ++k) {
      const double factor = a[k][i] / a[i][i];
      for (std::size_t j = i; j <= n; ++j) a[k][j] -= factor * a[i][j];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j) a[i][n] -= a[i][j] * a[j][n];
    a[i][n] /= a[i][i];
  }
}

}  // namespace

std::size_t cell_of(const ThinWalledTypes::Input& in, const Name& name) {
  std::size_t i = 0;
  while (i < in.cells.size() && (name.empty() || !(in.cells[i].name == name))) ++i;
  return i;
}

Length length_of(const ThinWalledTypes::Wall& wall) {
  if (is_set(wall.l)) return wall.l;
  Length sum = 0.0 * mm;
  for (std::size_t i = 0; i + 1 < wall.points.size(); ++i) sum += distance(wall.points[i], wall.points[i + 1]);
  return sum;
}

Length longest_side(const ThinWalledTypes::Wall& wall) {
  if (is_set(wall.l)) return wall.l;
  Length longest = 0.0 * mm;
  for (std::size_t i = 0; i + 1 < wall.points.size(); ++i)
    longest = max(longest, distance(wall.points[i], wall.points[i + 1]));
  return longest;
}

Area area_of(const ThinWalledTypes::Cell& cell) {
  if (is_set(cell.A)) return cell.A;
  Area twice = 0.0 * mm2;
  const auto& first = cell.points.front();
  for (std::size_t i = 1; i + 1 < cell.points.size(); ++i) {
    const auto &a = cell.points[i], &b = cell.points[i + 1];
    twice += (a.y - first.y) * (b.z - first.z) - (b.y - first.y) * (a.z - first.z);
  }
  return abs(twice) / 2.0;
}

double modulus_ratio(const ThinWalledTypes::Input& in, const ThinWalledTypes::Wall& wall) {
  return is_set(wall.G) ? reduced(wall.G / in.G) : 1.0;
}

bool is_free(const ThinWalledTypes::Wall& wall) { return wall.cell.empty(); }

Length perimeter_of(const ThinWalledTypes::Input& in, std::size_t cell) {
  Length sum = 0.0 * mm;
  for (const auto& wall : in.walls) {
    if (cell_of(in, wall.cell) == cell || cell_of(in, wall.beside) == cell) sum += length_of(wall);
  }
  return sum;
}

Flows flows_of(const ThinWalledTypes::Input& in) {
  const std::size_t n = in.cells.size();
  Matrix a{};
  for (const auto& wall : in.walls) add(a, in, wall);
  for (std::size_t i = 0; i < n; ++i) a[i][n] = 2.0 * in_si(area_of(in.cells[i]));
  solve(a, n);
  Flows flows;
  for (std::size_t i = 0; i < n; ++i) flows.push_back(from_si<Area>(a[i][n]));
  return flows;
}

}  // namespace loadpath::section
