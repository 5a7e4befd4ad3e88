#include "calculators/fatigue/multiaxial/planes.hpp"

#include "lib/quantity/units.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::fatigue {

namespace {

constexpr double step = pi / 36.0;  // step of the grid: 5 deg
constexpr double finest = 1e-4 * pi / 180.0;
constexpr int rows = 19, columns = 36;  // theta from 0 to 90 deg, phi from 0 to 180 deg
constexpr std::size_t followed = 6;     // number of the highest places of a grid

double value_of(const OnPlane& plane, double k) { return plane.tau_a + k * plane.sigma_n; }

struct Grid {
  double start;  // start of theta and of phi
  std::array<std::array<double, columns>, rows> value{};

  [[nodiscard]] Normal at(int row, int column) const { return {start + row * step, start + column * step}; }
};

Grid grid_of(const StressPath& path, double k, double start) {
  Grid grid{start};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      grid.value[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
          value_of(on_plane(path, grid.at(row, column)), k);
    }
  }
  return grid;
}

/// No neighbour is higher. A plane half a turn of phi away is its mirror image in the surface, where stresses are the
/// same.
bool is_top(const Grid& grid, int row, int column) {
  const auto value = [&](int r, int c) {
    return grid.value[static_cast<std::size_t>(r)][static_cast<std::size_t>((c + columns) % columns)];
  };
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, rows - 1); ++r) {
    for (int c = column - 1; c <= column + 1; ++c) {
      if (value(r, c) > value(row, column)) return false;
    }
  }
  return true;
}

/// The highest tops of a grid, the first of those that are as high.
struct Maxima {
  struct Top {
    Normal normal;
    double value = -1.0;
  };
  std::array<Top, followed> best{};

  void take(Top top) {
    for (Top& other : best) {
      if (top.value > other.value) std::swap(top, other);
    }
  }
};

Maxima tops_of(const Grid& grid) {
  Maxima tops;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      if (is_top(grid, row, column))
        tops.take({grid.at(row, column), grid.value[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]});
    }
  }
  return tops;
}

/// Uphill among eight neighbours, which draw nearer where none is higher and apart where one is; each time they are
/// turned, for an amplitude has ridges.
OnPlane followed_from(const StressPath& path, double k, const Normal& start) {
  constexpr int most_rounds = 150;
  constexpr double turn = 0.618 * pi / 4.0;
  OnPlane best = on_plane(path, start);
  double reach = step / 2.0;
  for (int round = 0; round < most_rounds && reach > finest; ++round) {
    const OnPlane centre = best;
    bool higher = false;
    for (int i = 0; i < 8; ++i) {
      const double angle = i * pi / 4.0 + round * turn;
      const OnPlane there =
          on_plane(path, {centre.normal.theta + reach * std::cos(angle), centre.normal.phi + reach * std::sin(angle)});
      if (value_of(there, k) > value_of(best, k) * (1.0 + 1e-13)) best = there, higher = true;
    }
    reach = higher ? std::min(1.5 * reach, step) : reach / 2.0;
  }
  return best;
}

/// theta from 0 to 90 deg, phi from 0 to 180 deg.
Normal in_upper_half(Normal normal) {
  normal.theta = std::fmod(normal.theta, pi);
  if (normal.theta < 0.0) normal.theta += pi;
  if (normal.theta > pi / 2.0) normal.theta = pi - normal.theta;
  normal.phi = std::fmod(normal.phi, pi);
  if (normal.phi < -finest / 2.0) normal.phi += pi;
  if (normal.phi > pi - finest / 2.0) normal.phi -= pi;
  normal.phi = std::max(normal.phi, 0.0);
  return normal;
}

/// The least, with the mirror image in the surface.
double angle_between(const Normal& a, const Normal& b) {
  const double flat = std::sin(a.theta) * std::sin(b.theta) * std::cos(a.phi - b.phi);
  const double deep = std::cos(a.theta) * std::cos(b.theta);
  return std::acos(std::min(std::abs(flat) + std::abs(deep), 1.0));
}

/// Break ties between planes equal by symmetry towards smaller angles, so that rounding does not decide.
bool is_worse(const OnPlane& one, const OnPlane& other, double k) {
  const double a = value_of(one, k), b = value_of(other, k);
  if (std::abs(a - b) > 1e-9 * std::max(a, b)) return a > b;
  if (std::abs(one.normal.phi - other.normal.phi) > finest) return one.normal.phi < other.normal.phi;
  return one.normal.theta < other.normal.theta;
}

OnPlane searched(const StressPath& path, double k, double start) {
  OnPlane worst;
  for (const Maxima::Top& top : tops_of(grid_of(path, k, start)).best) {
    if (top.value < 0.0) continue;
    OnPlane found = followed_from(path, k, top.normal);
    found.normal = in_upper_half(found.normal);
    if (is_worse(found, worst, k)) worst = found;
  }
  return worst;
}

}  // namespace

PlaneView::PlaneView(const Normal& normal) {
  const double sin_theta = std::sin(normal.theta), cos_theta = std::cos(normal.theta);
  const double sin_phi = std::sin(normal.phi), cos_phi = std::cos(normal.phi);
  const double n_x = sin_theta * cos_phi, n_y = sin_theta * sin_phi;
  const auto row = [&](double e_x, double e_y) { return Row{n_x * e_x, n_y * e_y, n_x * e_y + n_y * e_x}; };
  sigma_ = row(n_x, n_y);
  down_ = row(cos_theta * cos_phi, cos_theta * sin_phi);
  along_ = row(-sin_phi, cos_phi);
}

numerics::Ball<2> shear_circle(const StressPath& path, const PlaneView& view) {
  return numerics::smallest_ball<2>(path.size(), [&](std::size_t i) { return view.shear(path.at(i)); });
}

OnPlane on_plane(const StressPath& path, const Normal& normal) {
  const PlaneView view(normal);
  OnPlane on{normal, shear_circle(path, view).radius, 0.0};
  for (std::size_t i = 0; i < path.size(); ++i) on.sigma_n = std::max(on.sigma_n, view.sigma(path.at(i)));
  return on;
}

WorstPlane worst_plane(const StressPath& path, double k) {
  const OnPlane first = searched(path, k, 0.0), second = searched(path, k, step / 2.0);
  constexpr double rounding = 1e-11;
  const double a = value_of(first, k), b = value_of(second, k), most = std::max(a, b), apart = std::abs(a - b);
  return {is_worse(second, first, k) ? second : first, apart > rounding * most ? apart / most : 0.0};
}

WorstPlane plane_of_most_shear(const StressPath& path, double mu) {
  constexpr double hardly = 1e-4, somewhat = 0.02;  // shares of mu: keeps the plane, chooses between several
  constexpr double alike = 2e-3, apart = 5.0 * pi / 180.0;
  const WorstPlane first = worst_plane(path, hardly * mu), other = worst_plane(path, somewhat * mu);
  if (angle_between(first.plane.normal, other.plane.normal) < apart) return first;
  OnPlane settled = followed_from(path, hardly * mu, other.plane.normal);
  settled.normal = in_upper_half(settled.normal);
  const bool as_much = settled.tau_a > (1.0 - alike) * first.plane.tau_a;
  return as_much && is_worse(settled, first.plane, mu) ? WorstPlane{settled, other.apart} : first;
}

}  // namespace loadpath::fatigue
