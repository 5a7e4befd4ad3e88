#include "lib/draw/canvas/thin.hpp"

#include <doctest/doctest.h>

#include <numbers>

using namespace loadpath::draw;
using namespace loadpath::figure;

namespace {

double distance_to_segment(Point p, Point a, Point b) {
  const Point d = b - a;
  const double t = length(d) > 0.0 ? std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0) : 0.0;
  return length(p - (a + t * d));
}

double distance_to_polyline(Point p, const std::vector<Point>& line) {
  double least = 1e300;
  for (std::size_t i = 1; i < line.size(); ++i) least = std::min(least, distance_to_segment(p, line[i - 1], line[i]));
  return least;
}

std::vector<Point> wave(int n) {
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) points.push_back({420.0 * i / n, 100.0 * std::sin(6.0 * std::numbers::pi * i / n)});
  return points;
}

}  // namespace

TEST_SUITE("draw") {
  TEST_CASE("a straight line keeps its two ends") {
    CHECK(thin({{0, 0}, {1, 1}, {2, 2}, {5, 5}, {9, 9}}).size() == 2);
    CHECK(thin({{0, 0}, {1, 1}}).size() == 2);
    CHECK(thin({{3, 3}}).size() == 1);
    CHECK(thin({}).empty());
  }

  TEST_CASE("no point of the full curve is farther from the thinned one than the tolerance") {
    const auto full = wave(3600);
    const auto kept = thin(full, 0.08);
    CHECK(kept.size() < 250);
    double most = 0.0;
    for (const Point p : full) most = std::max(most, distance_to_polyline(p, kept));
    CHECK(most <= 0.08 + 1e-9);
  }

  TEST_CASE("a spike that returns along its own line keeps its tip") {
    const auto kept = thin({{0, 0}, {10, 0}, {20, 0}, {5, 0}, {5, 50}, {5, 100}, {5, 0}});
    const auto is = [](Point a, Point b) { return a.x == b.x && a.y == b.y; };
    CHECK(std::any_of(kept.begin(), kept.end(), [&](Point p) { return is(p, {20, 0}); }));
    CHECK(std::any_of(kept.begin(), kept.end(), [&](Point p) { return is(p, {5, 100}); }));
  }

  TEST_CASE("noise keeps the extremes of its columns and few points") {
    std::vector<Point> noise;
    unsigned seed = 1;
    for (int i = 0; i < 3600; ++i) {
      seed = seed * 1664525U + 1013904223U;
      noise.push_back({420.0 * i / 3600.0, static_cast<double>(seed >> 8U) / 65536.0});
    }
    noise[1777].y = 1000.0;
    const auto kept = thin(noise);
    CHECK(kept.size() <= 800);
    CHECK(std::any_of(kept.begin(), kept.end(), [](Point p) { return p.y == 1000.0; }));
    CHECK(kept.back().x == noise.back().x);
  }
}
