// Universal joints: derivatives by differences, energy, and the geometry of the cross in space.
#include "calculators/motion/universal_joint.hpp"

#include "tests/calculators/motion/solved.hpp"

#include <numbers>
#include <sstream>

using namespace loadpath::test;

namespace {

constexpr double pi = std::numbers::pi, speed = 100.0;

std::string text(double value) {
  std::ostringstream out;
  out.precision(17);
  out << value;
  return out.str();
}

SolvedStep joint(double beta, double phi, const std::string& more = "") {
  return {"motion.universal_joint", "n_1 = \"" + text(speed) + " rad/s\"\nbeta = \"" + text(beta) +
                                        " deg\"\nphi_1 = \"" + text(phi) + " rad\"\n" + more};
}

}  // namespace

TEST_SUITE("motion universal joint") {
  TEST_CASE("the arms of the cross stay at right angles") {
    for (const double beta : {5.0, 20.0, 45.0, 70.0}) {
      for (const double phi : {-2.0, 0.0, 0.3, 1.0, pi / 2.0, 2.2, 4.0, 7.0}) {
        CAPTURE(beta);
        CAPTURE(phi);
        const double b = beta * pi / 180.0, driven = joint(beta, phi)("phi_2");
        // the driving shaft along x, its fork from y in the plane of the shafts; the driven one in the plane xy, its
        // fork from z
        const double first[] = {0.0, std::cos(phi), std::sin(phi)};
        const double second[] = {std::sin(driven) * std::sin(b), -std::sin(driven) * std::cos(b), std::cos(driven)};
        CHECK(std::abs(first[0] * second[0] + first[1] * second[1] + first[2] * second[2]) < 1e-12);
        CHECK(std::abs(driven - phi) < pi / 2.0);  // in the same turn
      }
    }
  }

  TEST_CASE("speed and acceleration are derivatives of the angle, with two joints too") {
    const double h = 1e-4;
    for (const std::string more : {"", "beta_2 = \"35 deg\"\n", "beta_2 = \"35 deg\"\nforks = \"crossed\"\n"}) {
      for (double phi = 0.05; phi < 6.3; phi += 0.37) {
        const double before = joint(25.0, phi - h, more)("phi_2"), after = joint(25.0, phi + h, more)("phi_2");
        const SolvedStep s = joint(25.0, phi, more);
        CHECK(near(s("i"), (after - before) / (2.0 * h), 1e-7));
        CHECK(near(s("n_2"), speed * s("i")));
        const double slope = (joint(25.0, phi + h, more)("i") - joint(25.0, phi - h, more)("i")) / (2.0 * h);
        CHECK(std::abs(s("epsilon_2") - speed * speed * slope) < 1e-5 * speed * speed);
        CHECK(s("epsilon_2") <= s("epsilon_max") * (1.0 + 1e-12));
        CHECK(s("n_2") <= s("n_2max") * (1.0 + 1e-12));
        CHECK(s("n_2") >= s("n_2min") * (1.0 - 1e-12));
      }
      const SolvedStep s = joint(25.0, 0.0, more);
      CHECK(near(std::abs(joint(25.0, s("phi_max"), more)("epsilon_2")), s("epsilon_max")));
      CHECK(near(joint(25.0, s("phi_equal"), more)("i"), 1.0));
    }
  }

  TEST_CASE("both shafts have the same power, and equal joints compensate") {
    const SolvedStep s = joint(30.0, 0.4, "M_2 = \"200 N*m\"\nJ_2 = \"0.5 kg*m^2\"\n");
    CHECK(near(s("M_1") * speed, (200.0 + 0.5 * s("epsilon_2")) * s("n_2")));
    CHECK(near(s("M_1max"), 200.0 / std::cos(pi / 6.0)));
    const SolvedStep even = joint(30.0, 0.4, "beta_2 = \"30 deg\"\nJ_2 = \"0.5 kg*m^2\"\n");
    CHECK(near(even("i"), 1.0));
    CHECK(even("U") == 0.0);
    CHECK(even("M_J") == 0.0);
  }

  TEST_CASE("shafts at right angles are refused") {
    const Refused rows[] = {{"n_1 = \"100 rpm\"\nbeta = \"90 deg\"\n", "must be"},
                            {"n_1 = \"0 rpm\"\nbeta = \"20 deg\"\n", "must be"}};
    check_refusals("motion.universal_joint", rows);
  }
}
