// The smallest ball around a set of points: the circle of a path in a plane, the ball of one in space.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace loadpath::numerics {

template <std::size_t dim>
struct Ball {
  std::array<double, dim> centre{};
  double radius = 0.0;
};

namespace detail {

template <std::size_t dim>
using Place = std::array<double, dim>;

template <std::size_t dim>
double squared_distance(const Place<dim>& a, const Place<dim>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < dim; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

/// Up to dim + 2 points, which is as many as are ever looked at together.
template <std::size_t dim>
struct PointSet {
  std::array<Place<dim>, dim + 2> at{};
  std::size_t count = 0;
};

/// Solves the symmetric system of `n` rows; false if it is singular.
template <std::size_t dim>
bool solve(std::array<std::array<double, dim + 1>, dim>& rows, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t i = k + 1; i < n; ++i) best = std::abs(rows[i][k]) > std::abs(rows[best][k]) ? i : best;
    std::swap(rows[k], rows[best]);
    if (!(std::abs(rows[k][k]) > 1e-14)) return false;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  for (std::size_t k = 0; k < n; ++k) rows[k][n] /= rows[k][k];
  return true;
}

/// The smallest ball with all these points on its surface; radius below 0 if they are not corners of one. Lengths
/// are made free of their size first.
template <std::size_t dim>
Ball<dim> through(const PointSet<dim>& corners) {
  Ball<dim> ball{corners.at[0], 0.0};
  const std::size_t n = corners.count - 1;
  double size = 0.0;
  for (std::size_t i = 1; i <= n; ++i) size = std::max(size, squared_distance<dim>(corners.at[i], corners.at[0]));
  if (n == 0) return ball;
  if (n > dim || !(size > 0.0)) return {corners.at[0], -1.0};
  std::array<Place<dim>, dim> edge{};
  std::array<std::array<double, dim + 1>, dim> rows{};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t c = 0; c < dim; ++c) edge[i][c] = (corners.at[i + 1][c] - corners.at[0][c]) / std::sqrt(size);
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t c = 0; c < dim; ++c) rows[i][j] += 2.0 * edge[i][c] * edge[j][c];
    }
    rows[i][n] = rows[i][i] / 2.0;
  }
  if (!solve<dim>(rows, n)) return {corners.at[0], -1.0};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t c = 0; c < dim; ++c) ball.centre[c] += rows[i][n] * edge[i][c] * std::sqrt(size);
  }
  ball.radius = std::sqrt(squared_distance<dim>(ball.centre, corners.at[0]));
  return ball;
}

template <std::size_t dim>
bool holds(const Ball<dim>& ball, const PointSet<dim>& points) {
  for (std::size_t i = 0; i < points.count; ++i) {
    if (std::sqrt(squared_distance<dim>(points.at[i], ball.centre)) > ball.radius * (1.0 + 1e-10)) return false;
  }
  return true;
}

/// The smallest ball of a few points, by trying every choice of corners; the corners stay, the others go.
template <std::size_t dim>
Ball<dim> ball_of(PointSet<dim>& points) {
  Ball<dim> best{{}, -1.0};
  PointSet<dim> kept;
  for (unsigned choice = 1; choice < (1U << points.count); ++choice) {
    PointSet<dim> corners;
    for (std::size_t i = 0; i < points.count; ++i) {
      if ((choice >> i & 1U) != 0U) corners.at[corners.count++] = points.at[i];
    }
    if (corners.count > dim + 1) continue;
    const Ball<dim> ball = through<dim>(corners);
    if (ball.radius < 0.0 || (best.radius >= 0.0 && ball.radius >= best.radius) || !holds<dim>(ball, points)) continue;
    best = ball, kept = corners;
  }
  if (best.radius >= 0.0) points = kept;
  return best;
}

}  // namespace detail

/// The smallest ball around `point(0)` to `point(count - 1)`, count > 0. From ball to ball, each through at most dim
/// + 1 corners and the point farthest outside the previous one, so that the radius grows until no point is outside.
/// Does not allocate. The radius is the distance of the farthest point from the centre: never too small.
template <std::size_t dim, class PointAt>
Ball<dim> smallest_ball(std::size_t count, const PointAt& point) {
  constexpr int most_steps = 100;
  detail::PointSet<dim> corners;
  corners.at[0] = point(std::size_t{0}), corners.count = 1;
  Ball<dim> ball{corners.at[0], 0.0};
  for (int step = 0; step < most_steps; ++step) {
    double farthest = -1.0;
    detail::Place<dim> outside{};
    for (std::size_t i = 0; i < count; ++i) {
      const detail::Place<dim> at = point(i);
      const double distance = detail::squared_distance<dim>(at, ball.centre);
      if (distance > farthest) farthest = distance, outside = at;
    }
    const double reach = std::sqrt(farthest);
    const bool settled = !(reach > ball.radius * (1.0 + 1e-12)) || step + 1 == most_steps;
    if (settled) return {ball.centre, reach};
    corners.at[corners.count++] = outside;
    const Ball<dim> next = detail::ball_of<dim>(corners);
    if (!(next.radius > ball.radius)) return {ball.centre, reach};
    ball = next;
  }
  return ball;
}

}  // namespace loadpath::numerics
