// Work along prescribed curves: published and closed forms, forces with a potential, and what is refused.
#include "tests/calculators/motion/solved.hpp"

#include <numbers>

using namespace loadpath::test;

namespace {

constexpr double pi = std::numbers::pi;
const std::string id = "dynamics.path_work";
const std::string ellipse = "x = \"3 m*cos(2*pi*t/(4 s))\"\ny = \"2 m*sin(2*pi*t/(4 s))\"\n";

}  // namespace

TEST_SUITE("dynamics path work") {
  TEST_CASE("the work depends on the path unless the force has a potential, [Edshare-5659]") {
    const std::string F = "F_x = \"3 N/m^2*x^2\"\nF_y = \"2 N/m^2*x*z - 1 N/m*y\"\nF_z = \"1 N/m*z\"\nt_2 = \"1 s\"\n";
    const std::string line = "x = \"2 m/s*t\"\ny = \"1 m/s*t\"\nz = \"3 m/s*t\"\n";
    const std::string curve = "x = \"2 m*(t/(1 s))^2\"\ny = \"1 m/s*t\"\nz = \"4 m*(t/(1 s))^2 - 1 m/s*t\"\n";
    CHECK(near(SolvedStep(id, line + F)("A"), 16.0));
    CHECK(near(SolvedStep(id, curve + F)("A"), 14.2));
    // -grad(2 x^2 y + 3 z^2): the value at the end, (2, 1, 3), with the sign changed
    const std::string gradient = "F_x = \"-4 N/m^2*x*y\"\nF_y = \"-2 N/m^2*x^2\"\nF_z = \"-6 N/m*z\"\nt_2 = \"1 s\"\n";
    CHECK(near(SolvedStep(id, line + gradient)("A"), -35.0));
    CHECK(near(SolvedStep(id, curve + gradient)("A"), -35.0));
  }

  TEST_CASE("around a closed curve a potential does no work, a swirl twice its area") {
    const SolvedStep spring(id, ellipse + "t_2 = \"4 s\"\nF_x = \"-20 N/m*x\"\nF_y = \"-20 N/m*y\"\n");
    CHECK(spring("A") == 0.0);
    const SolvedStep swirl(id, ellipse + "t_2 = \"4 s\"\nF_x = \"-5 N/m*y\"\nF_y = \"5 N/m*x\"\n");
    CHECK(near(swirl("A"), 2 * 5 * pi * 3 * 2));
    CHECK(near(swirl("P_m"), swirl("A") / 4));
    CHECK(swirl("delta") < 1e-13);
  }

  TEST_CASE("the work of the weight depends on the height alone, that of friction on the length") {
    const SolvedStep weight(
        id,
        "x = \"2 m*sin(t/(1 s))\"\ny = \"0.5 m/s^2*t^2\"\nt_1 = \"1 s\"\nt_2 = \"3 s\"\nF_x = \"0 N\"\n"
        "F_y = \"-20 N\"\n");
    CHECK(near(weight("A"), -20.0 * 4));
    const SolvedStep friction(id, ellipse + "t_2 = \"3 s\"\nF_x = \"-7 N*v_x/v\"\nF_y = \"-7 N*v_y/v\"\n");
    CHECK(near(friction("A"), -7 * friction("L")));
    CHECK(near(friction("F_m"), -7.0));
    CHECK(friction("P_max") < 0.0);
  }

  TEST_CASE("drag on a point that oscillates on a line") {
    // k v^3 over sin^3: the integral of |cos|^3 over a period is 8/3 of its radian
    const SolvedStep drag(id,
                          "x = \"3 m*sin(t/(1 s))\"\nt_2 = \"6.283185307179586 s\"\nF_x = \"-2 N*s^2/m^2*v*v_x\"\n");
    CHECK(near(drag("A"), -2 * 27 * 8.0 / 3));
    CHECK(near(drag("P_min"), -54.0));
    CHECK(drag("P_max") == doctest::Approx(0.0));
  }

  TEST_CASE("a force with a kink on the path is integrated to eleven digits") {
    const SolvedStep stop(id, "x = \"3 m/s*t\"\nt_2 = \"1 s\"\nF_x = \"-10 N/m*max(x - 1.2345 m, 0 m)\"\n");
    CHECK(near(stop("A"), -5 * std::pow(3 - 1.2345, 2), 1e-11));
    const SolvedStep root(id, "x = \"4 m/s*t\"\nt_2 = \"1 s\"\nF_x = \"3 N*sqrt(x/(1 m))\"\n");
    CHECK(near(root("A"), 16.0, 1e-12));
  }

  TEST_CASE("a body that rests has no path") {
    const SolvedStep rest(id, "x = \"3 m\"\nt_2 = \"1 s\"\nF_x = \"-10 N\"\n");
    CHECK(rest("A") == 0.0);
    CHECK(std::isnan(rest("F_m")));
  }

  TEST_CASE("curves and forces without values are refused") {
    const Refused rows[] = {
        {"x = \"3 m/s*t\"\nt_2 = \"1 s\"\nF_x = \"1 N*m/(x - 1.2345 m)\"\n", "F_x: the force has a pole"},
        {"x = \"3 m/s*t\"\nt_2 = \"1 s\"\nF_x = \"1 N\"\nF_y = \"1 N*m/x\"\n",
         "F_y: the force has no value at t = 0 s"},
        {"x = \"3 m/s*t\"\nt_2 = \"1 s\"\nF_x = \"1 N*sin(1e9*t/(1 s))\"\n", "too fast"},
        {"x = \"3 m/s*t\"\nt_2 = \"1 s\"\nF_x = \"1 m\"\n", "force"},
        {"x = \"3 m/s*abs(t)\"\nt_2 = \"1 s\"\nF_x = \"1 N\"\n", "kinks"},
        {"x = \"1 m*tan(t/(1 s))\"\nt_2 = \"2 s\"\nF_x = \"1 N\"\n", "jumps"},
        {"x = \"3 m/s*t\"\nt_1 = \"1 s\"\nt_2 = \"1 s\"\nF_x = \"1 N\"\n", "must end after its start"}};
    check_refusals(id, rows);
  }
}
