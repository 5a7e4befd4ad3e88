// Spherical and general motion: derivatives against differences of the position, rolling cones, a crane's boom.
#include "calculators/motion/spatial.hpp"

#include "tests/calculators/motion/solved.hpp"

#include <cmath>
#include <numbers>
#include <string>

using namespace loadpath::test;

namespace {

constexpr double pi = std::numbers::pi;

/// A body that turns about all axes at once, and its pole moves.
SolvedStep body(double t, const std::string& pole) {
  return {"motion.spatial",
          "psi = \"0.7*t/(1 s) + 0.3*(t/(1 s))^2\"\ntheta = \"0.4 + 0.5*sin(2*t/(1 s))\"\nphi = \"3*t/(1 s) - "
          "0.2*(t/(1 s))^3\"\n" +
              pole + "xi = \"0.3 m\"\neta = \"-0.7 m\"\nzeta = \"1.1 m\"\nt = \"" + std::to_string(t) + " s\"\n"};
}

const std::string moving = "x = \"2 m*sin(t/(1 s))\"\ny = \"1 m*(t/(1 s))^2\"\nz = \"0.5 m - 3 m*t/(1 s)\"\n";

double length(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

}  // namespace

TEST_SUITE("motion spatial") {
  TEST_CASE("velocity and acceleration are derivatives of the position, with and without a fixed point") {
    const double h = 1e-3;
    for (const std::string& pole : {std::string(), moving}) {
      for (const double t : {0.2, 0.9, 1.7, 3.1}) {
        CAPTURE(t);
        const SolvedStep before = body(t - h, pole), now = body(t, pole), after = body(t + h, pole);
        for (const std::string axis : {"x", "y", "z"}) {
          const double a = before(axis + "_M"), b = now(axis + "_M"), c = after(axis + "_M");
          CHECK(std::abs(now("v_" + axis) - (c - a) / (2.0 * h)) < 2e-5);
          CHECK(std::abs(now("a_" + axis) - (c - 2.0 * b + a) / (h * h)) < 2e-4);
          CHECK(std::abs(now("epsilon_" + axis) - (after("omega_" + axis) - before("omega_" + axis)) / (2.0 * h)) <
                5e-5);
        }
      }
    }
  }

  TEST_CASE("a point keeps its distance from the pole, and speed is omega times the distance from the axis") {
    for (const double t : {0.1, 0.8, 2.4}) {
      const SolvedStep s = body(t, "");
      CHECK(near(length(s("x_M"), s("y_M"), s("z_M")), length(0.3, 0.7, 1.1)));
      CHECK(near(s("h") * s("omega"), s("v")));
      CHECK(std::abs(s("v_k")) < 1e-14);
      const double a = std::cos(s("alpha")), b = std::cos(s("beta")), c = std::cos(s("gamma"));
      CHECK(near(a * a + b * b + c * c, 1.0));
      const double along = (s("x_M") * a + s("y_M") * b + s("z_M") * c);
      CHECK(near(s("h") * s("h") + along * along, 0.09 + 0.49 + 1.21));
      const SolvedStep g = body(t, moving);
      CHECK(near(g("omega"), s("omega")));
      CHECK(near(g("v_k"), (g("v_x") * a + g("v_y") * b + g("v_z") * c)));
    }
  }

  TEST_CASE("a cone that rolls on a plane: Irodov, problem 1.57") {
    // Half-angle 30 deg, base of 5 cm, its axis horizontal, the centre of the base at 10 cm/s.
    const double d = 0.05 / std::tan(pi / 6.0), turn = 0.10 / d, spin = 0.10 / 0.05;
    const SolvedStep s("motion.spatial", "psi = \"" + std::to_string(turn) +
                                             "*t/(1 s)\"\ntheta = \"90 deg\"\nphi = \"-" + std::to_string(spin) +
                                             "*t/(1 s)\"\nzeta = \"" + std::to_string(d) + " m\"\nt = \"0 s\"\n");
    CHECK(std::abs(s("omega") - 2.3) < 0.05);    // printed
    CHECK(std::abs(s("epsilon") - 2.3) < 0.05);  // printed
    CHECK(std::abs(s("gamma") - pi / 3.0) < 1e-5);
    CHECK(std::abs(s("v") - 0.10) < 1e-6);
    // R_phi/R_psi = omega_psi/omega_phi on the instantaneous axis
    CHECK(std::abs(std::sin(s("delta")) / std::sin(s("gamma")) - turn / spin) < 1e-5);
  }

  TEST_CASE("a boom that is raised while its crane slews, by hand") {
    const SolvedStep s("motion.spatial",
                       "psi = \"0.3*t/(1 s)\"\ntheta = \"60 deg - 0.5*t/(1 s)\"\nt = \"0 s\"\nzeta = \"12 m\"\n");
    // Up 12 m sin 30 deg; the tip rises by 0.5 rad/s 12 m cos 30 deg, moves inwards by 3 m/s, sideways by 0.3 rad/s.
    CHECK(near(s("z_M"), 6.0));
    CHECK(near(s("v_z"), 0.5 * 12.0 * std::cos(pi / 6.0)));
    CHECK(near(s("v_x"), 0.3 * 12.0 * std::cos(pi / 6.0)));
    CHECK(near(s("v_y"), 3.0));
    CHECK(near(s("epsilon"), 0.15));
    CHECK(near(s("a_z"), -0.25 * 6.0));
    CHECK(near(s("a_y"), (0.25 + 0.09) * 12.0 * std::cos(pi / 6.0)));
    CHECK(near(s("a_x"), -2.0 * 0.3 * 3.0));
  }

  TEST_CASE("expressions that are not laws, and no law at all") {
    const Refused rows[] = {{"t = \"1 s\"\n", "the law of one angle"},
                            {"psi = \"3 m*t/(1 s)\"\nt = \"1 s\"\n", "psi"},
                            {"phi = \"1/t*(1 s)\"\nt = \"0 s\"\n", "no value"}};
    check_refusals("motion.spatial", rows);
  }
}
