// Initial value problems against closed forms, and the places of zeros.
#include "calculators/dynamics/initial_value.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace loadpath::dynamics;

namespace {

InitialValue swing(double t_2) {
  InitialValue problem;
  problem.slopes = [](double, const Unknowns& y, Unknowns& slopes) { slopes = {y[1], -y[0]}; };
  problem.t_2 = t_2;
  problem.y = {1.0, 0.0};
  return problem;
}

}  // namespace

TEST_SUITE("initial value") {
  TEST_CASE("an oscillation keeps its tolerance") {
    for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
      const Solved end = solve(swing(20.0), tolerance, [](double, const Unknowns&) {});
      CHECK(end.end == Solved::End::time);
      CHECK(end.t == 20.0);
      CHECK(std::abs(end.y[0] - std::cos(20.0)) < std::max(1e3 * tolerance, 1e-12));
    }
  }

  TEST_CASE("it ends at the first zero after the start, and turning points are visited") {
    InitialValue problem = swing(20.0);
    problem.until = [](double, const Unknowns& y) { return y[1]; };  // zero at the start too
    problem.turns = {[](double, const Unknowns& y) { return y[0]; }};
    double before = -1.0, nearest = 1.0;
    const Solved end = solve(problem, 1e-12, [&](double t, const Unknowns& y) {
      CHECK(t >= before);
      before = t;
      nearest = std::min(nearest, std::abs(y[0]));
    });
    CHECK(end.end == Solved::End::zero);
    CHECK(end.t == doctest::Approx(std::numbers::pi).epsilon(1e-11));
    CHECK(nearest < 1e-11);
    CHECK(before == end.t);
  }

  TEST_CASE("no derivatives beyond a boundary, and a growth that no step size can follow") {
    InitialValue root;
    root.slopes = [](double t, const Unknowns&, Unknowns& slopes) { slopes = {std::sqrt(1.0 - t)}; };
    root.t_2 = 3.0;
    root.y = {0.0};
    const Solved stopped = solve(root, 1e-9, [](double, const Unknowns&) {});
    CHECK(stopped.end == Solved::End::no_slopes);
    CHECK(stopped.t == doctest::Approx(1.0).epsilon(1e-6));
    CHECK(stopped.y[0] == doctest::Approx(2.0 / 3.0).epsilon(1e-6));
    InitialValue pole;
    pole.slopes = [](double, const Unknowns& y, Unknowns& slopes) { slopes = {y[0] * y[0]}; };
    pole.t_2 = 3.0;
    pole.y = {1.0};
    const Solved blown = solve(pole, 1e-9, [](double, const Unknowns&) {});
    CHECK(blown.end != Solved::End::time);
    CHECK(blown.t == doctest::Approx(1.0).epsilon(1e-3));
  }
}
