// Sobol's sequence: published points, and how evenly it fills after scrambling.
#include "lib/sweep/point/sobol.hpp"

#include "lib/sweep/point/space.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace {

using namespace loadpath::sweep;

std::vector<double> variable_of(const Sobol& sobol, std::size_t variable, std::size_t n, std::uint64_t shift = 0) {
  std::vector<double> column(n);
  sobol.fill(variable, 0, shift, column);
  return column;
}

/// The error of the mean of (1 + (x - 1/2)/k) over variables k = 1, 2, ..., whose integral is 1.
double error_of_mean(Sampling sampling, std::uint64_t seed) {
  constexpr std::size_t n = 4096, variables = 6;
  Space::Random random;
  random.variables.assign(variables, Distribution(Uniform{}));
  random.samples = n;
  random.seed = seed;
  random.sampling = sampling;
  std::vector<std::vector<double>> columns(variables, std::vector<double>(n));
  std::vector<double*> places;
  for (auto& column : columns) places.push_back(column.data());
  Space::of({}, random)->fill(0, n, places);
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    double product = 1.0;
    for (std::size_t k = 0; k < variables; ++k) product *= 1.0 + (columns[k][i] - 0.5) / static_cast<double>(k + 1);
    sum += product;
  }
  return std::abs(sum / n - 1.0);
}

}  // namespace

TEST_SUITE("points of sweeps: Sobol") {
  TEST_CASE("direction numbers give the points that Joe and Kuo print") {
    const double printed[][3] = {{0.5, 0.5, 0.5},       {0.75, 0.25, 0.25},    {0.25, 0.75, 0.75},
                                 {0.375, 0.375, 0.625}, {0.875, 0.875, 0.125}, {0.625, 0.125, 0.875},
                                 {0.125, 0.625, 0.375}};
    const auto directions = sobol_directions(3);
    for (std::size_t k = 0; k < 3; ++k) {
      for (unsigned i = 1; i <= 7; ++i) {
        const unsigned gray = i ^ (i >> 1);
        std::uint64_t x = 0;
        for (unsigned bit = 0; bit < 3; ++bit) x ^= (gray >> bit & 1) != 0 ? directions[k][bit] : 0;
        CHECK(static_cast<double>(x) * 0x1p-64 == printed[i - 1][k]);
      }
    }
  }

  TEST_CASE("scrambled, each variable is once in each part, the first two once in each box") {
    const Sobol sobol(20, 5);
    for (std::size_t variable = 0; variable < 20; ++variable) {
      std::set<int> parts;
      for (const double u : variable_of(sobol, variable, 1024)) parts.insert(static_cast<int>(u * 1024.0));
      CHECK(parts.size() == 1024);
    }
    const auto a = variable_of(sobol, 0, 1024), b = variable_of(sobol, 1, 1024);
    for (const int across : {1, 4, 32, 256, 1024}) {
      std::set<std::pair<int, int>> boxes;
      for (std::size_t i = 0; i < a.size(); ++i)
        boxes.emplace(static_cast<int>(a[i] * across), static_cast<int>(b[i] * (1024.0 / across)));
      CHECK(boxes.size() == 1024);
    }
  }

  TEST_CASE("other seeds and shifts give other samples, and a sample depends on its index alone") {
    const Sobol sobol(3, 5);
    const auto column = variable_of(sobol, 2, 100);
    CHECK(column != variable_of(sobol, 2, 100, 1));
    CHECK(column != variable_of(Sobol(3, 6), 2, 100));
    for (const std::size_t first : {1UL, 31UL, 64UL, 99UL}) {
      double u = 0.0;
      sobol.fill(2, first, 0, {&u, 1});
      CHECK(u == column[first]);
    }
  }

  TEST_CASE("a mean over a Sobol sequence is closer to its integral, and free of bias") {
    double plain = 0.0, even = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      plain += error_of_mean(Sampling::random, seed);
      even += error_of_mean(Sampling::sobol, seed);
    }
    CHECK(even < 0.02 * plain);
  }
}
