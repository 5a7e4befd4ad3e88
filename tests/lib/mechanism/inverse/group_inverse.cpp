#include "lib/mechanism/inverse/group_inverse.hpp"

#include "lib/mechanism/proof/virtual_motions.hpp"
#include "lib/numerics/dense_inverse.hpp"
#include "tests/lib/mechanism/proof/methods.hpp"
#include "tests/lib/mechanism/worked_models.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

struct Case {
  const char* name;
  Model model;
  std::vector<Drive> drives;
};

std::vector<Case> cases() {
  return {{"four-bar", four_bar(), {{1.3, 20.0, -35.0}}},
          {"six-bar", six_bar(), {{1.3, 20.0, -35.0}}},
          {"class III", class_three(), {{-1.2, 20.0, 0.0}}},
          {"slot on a moving link", slot_on_a_moving_link(false), {{0.5, 12.0, -40.0}}},
          {"two drives, the second on the first", telescope(), {{0.8, 0.5, -1.0}, {0.6, 0.3, 0.4}}},
          {"five-bar", five_bar(), {{2.1, 3.0, 10.0}, {0.9, -4.0, 6.0}}},
          {"chain of 12", chain(12), {{1.3, 20.0, -35.0}}}};
}

/// Column after column.
std::vector<double> jacobian_of(const Constraints& constraints) {
  const std::size_t size = constraints.rows();
  std::vector<double> jacobian(size * size);
  for (std::size_t n = 0; n < constraints.pattern().size(); ++n) {
    const auto [row, column] = constraints.pattern()[n];
    jacobian[static_cast<std::size_t>(column) * size + static_cast<std::size_t>(row)] += constraints.jacobian()[n];
  }
  return jacobian;
}

/// Column after column, that is motion after motion.
std::vector<double> inverse_of(std::vector<double> jacobian, std::size_t size) {
  loadpath::numerics::DenseInverse(size).invert(jacobian);
  return jacobian;
}

double largest(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0,
                         [](double a, double x) { return std::max(a, std::abs(x)); });
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("the inverse by groups is that of the full Jacobian") {
    for (const Case& c : cases()) {
      CAPTURE(c.name);
      const Solved solved = solve(c.model, c.drives);
      REQUIRE(solved.status == Status::closed);
      Instant instant(c.model);
      instant.take(solved.at, false);
      VirtualMotions motions(instant);
      motions.find(instant);
      const std::size_t size = instant.constraints().rows();
      const std::vector<double> inverse = inverse_of(jacobian_of(instant.constraints()), size);
      const double tolerance = 1e-13 * instant.condition() * largest(inverse);
      for (std::size_t row = 0; row < size; ++row) {
        for (std::size_t k = 0; k < size; ++k) {
          CHECK(std::abs(motions.of(row)[k] - inverse[row * size + k]) <= tolerance);
        }
      }
    }
  }

  TEST_CASE("the products of the constraints by groups are those of the full system") {
    for (const Case& c : cases()) {
      CAPTURE(c.name);
      const Solved solved = solve(c.model, c.drives);
      Instant instant(c.model);
      instant.take(solved.at, false);
      const std::size_t size = instant.constraints().rows();
      const std::vector<double> jacobian = jacobian_of(instant.constraints());
      std::vector<double> acting(size), supply(size);
      std::iota(acting.begin(), acting.end(), -3.0);
      std::vector<double> left = acting;
      instant.inverse().find_supply(acting, supply);
      const double tolerance = 1e-12 * largest(supply) * largest(jacobian);
      for (std::size_t k = 0; k < size; ++k) {
        for (std::size_t row = 0; row < size; ++row) left[k] -= jacobian[k * size + row] * supply[row];
        CHECK(std::abs(left[k]) <= tolerance);
      }
    }
  }

  TEST_CASE("the condition number is estimated from below, and not far from it") {
    for (const Case& c : cases()) {
      CAPTURE(c.name);
      Instant instant(c.model);
      const Solved solved = solve(c.model, c.drives);
      instant.take(solved.at, false);
      const std::size_t size = instant.constraints().rows();
      const std::vector<double> jacobian = jacobian_of(instant.constraints());
      const double condition = loadpath::numerics::largest_row_sum(jacobian, size) *
                               loadpath::numerics::largest_row_sum(inverse_of(jacobian, size), size);
      CHECK(instant.condition() <= condition * (1.0 + 1e-9));
      CHECK(instant.condition() >= condition / 3.0);
    }
  }

  TEST_CASE("a chain of two hundred dyads is proved like one of two") {
    for (const int dyads : {2, 50, 200}) {
      const Model model = chain(dyads);
      const std::vector<Drive> drives{{1.3, 20.0, -35.0}};
      const Solved solved = solve(model, drives);
      REQUIRE(solved.status == Status::closed);
      check_trustworthy(Prover(model).prove(drives, false, solved.at));
    }
  }
}
