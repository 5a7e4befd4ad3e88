#include "tests/calculators/motion/solved.hpp"

using namespace loadpath::test;

namespace {

const std::string ellipse = "x = \"3 m*sin(pi*t/(1 s))\"\ny = \"5 m*cos(pi*t/(1 s))\"\n";

SolvedStep point(const std::string& lines) { return {"motion.point", lines}; }

}  // namespace

TEST_SUITE("motion point") {
  TEST_CASE("the components of the acceleration add up to the total, at any time") {
    for (const std::string t : {"0.03 s", "0.2 s", "0.41 s", "0.77 s", "1.9 s"}) {
      CAPTURE(t);
      const auto p = point(ellipse + "t = \"" + t + "\"\n");
      CHECK(near(std::hypot(p("a_tau"), p("a_n")), p("a")));
      CHECK(near(p("kappa") * p("rho"), 1.0));
    }
  }

  TEST_CASE("a motion twice as fast has twice the speed, four times the acceleration and the same curvature") {
    const auto slow = point(ellipse + "t = \"0.2 s\"\n");
    const auto fast = point("x = \"3 m*sin(2*pi*t/(1 s))\"\ny = \"5 m*cos(2*pi*t/(1 s))\"\nt = \"0.1 s\"\n");
    CHECK(near(fast("v"), 2.0 * slow("v")));
    CHECK(near(fast("a"), 4.0 * slow("a")));
    CHECK(near(fast("rho"), slow("rho")));
  }

  TEST_CASE("the direction cosines of the velocity: published, their squares add up to one, none at rest") {
    const auto p = point("x = \"2 m/s*t\"\ny = \"1 m/s^2*t^2\"\nz = \"2 m/s^2*t^2\"\nt = \"1 s\"\n");
    CHECK(near(p("cos_x"), 1 / std::sqrt(6.0)));  // [AssignmentExpert-122826]
    CHECK(near(p("cos_y"), 1 / std::sqrt(6.0)));
    CHECK(near(p("cos_z"), 2 / std::sqrt(6.0)));
    CHECK(near(p("cos_x") * p("cos_x") + p("cos_y") * p("cos_y") + p("cos_z") * p("cos_z"), 1.0));
    const auto plane = point(ellipse + "t = \"0.2 s\"\n");
    CHECK(near(plane("cos_x"), std::cos(plane("gamma"))));
    CHECK(near(plane("cos_y"), std::sin(plane("gamma"))));
    CHECK(plane("cos_z") == 0.0);
    CHECK(std::isnan(point("x = \"1 m/s^2*t^2\"\nt = \"0 s\"\n")("cos_x")));
  }

  TEST_CASE("a straight path has no radius of curvature, and its distance counts both ways of a return") {
    const auto p = point("x = \"2 m*sin(pi*t/(1 s))\"\nt = \"0.1 s\"\nt_1 = \"0 s\"\nt_2 = \"1 s\"\n");
    CHECK(std::isnan(p("rho")));
    CHECK(p("a_n") == 0.0);
    CHECK(near(p("L"), 4.0, 1e-8));
    CHECK(p("Delta_r") < 1e-12);
    CHECK(p.word("change") == "slower");
  }

  TEST_CASE("where the point is at rest there is no tangent, hence no component of the acceleration") {
    const auto p = point("x = \"2 m*sin(pi*t/(1 s))\"\nt = \"0.5 s\"\n");
    CHECK(p("v") == 0.0);
    CHECK(std::isnan(p("a_tau")));
    CHECK(std::isnan(p("rho")));
    CHECK(p.word("change") == "at_rest");
  }

  TEST_CASE("a circle at constant speed is steady, and its acceleration points to the centre") {
    const auto p = point("x = \"2 m*cos(3*t/(1 s))\"\ny = \"2 m*sin(3*t/(1 s))\"\nt = \"0.4 s\"\n");
    CHECK(p.word("change") == "steady");
    CHECK(near(p("a_n"), 18.0));
    CHECK(near(p("rho"), 2.0));
    CHECK(near(p("a_x") / p("x_M"), -9.0));
  }

  TEST_CASE("the choice of units does not matter") {
    const auto a = point("x = \"40 mm*t^2/(1 s^2)\"\nt = \"1500 ms\"\n");
    const auto b = point("x = \"0.04 m*t^2/(1 s^2)\"\nt = \"1.5 s\"\n");
    CHECK(near(a("v"), b("v"), 1e-14));
  }

  TEST_CASE("states at given times are listed in the given order") {
    const auto p = point(ellipse + "t = \"0 s\"\ntimes = [[\"1 s\"], [\"0.5 s\"]]\n");
    CHECK(near(p("states[1].y"), -5.0));
    CHECK(near(p("states[2].x"), 3.0));
  }

  TEST_CASE("an impossible motion is refused with the reason") {
    const Refused rows[] = {
        {"x = \"3*t\"\nt = \"0 s\"\n", "length"},
        {"x = \"3 m*q\"\nt = \"0 s\"\n", "q"},
        {"x = \"3 m*abs(t/(1 s))\"\nt = \"0 s\"\n", "kinks"},
        {"x = \"3 m*sqrt(t/(1 s))\"\nt = \"0 s\"\n", "no value, speed or acceleration at t = 0 s"},
        {"x = \"3 m/(t/(1 s) - 1)\"\nt = \"0 s\"\nt_1 = \"0 s\"\nt_2 = \"2 s\"\n", "no value, speed or acceleration"},
        {"x = \"1 m/(t/(1 s) - 0.300001)\"\nt = \"0.5 s\"\nt_1 = \"0.1 s\"\nt_2 = \"0.9 s\"\n", "the law jumps"},
        {"x = \"1 m/(t/(1 s) - 0.300001)^2\"\nt = \"0.5 s\"\nt_1 = \"0.1 s\"\nt_2 = \"0.9 s\"\n", "the law jumps"},
        {"x = \"1 m*sin(2*pi*t/(1 s))\"\nt = \"0 s\"\nt_1 = \"0 s\"\nt_2 = \"256 s\"\n", "the law jumps"},
        {"x = \"1 m*tan(pi*t/(1 s))\"\nt = \"0.5 s\"\n", "no value, speed or acceleration"},
        {"x = \"3 m\"\nt = \"0 s\"\nt_1 = \"0 s\"\n", "give both t_1 and t_2, or neither"},
        {"x = \"3 m\"\nt = \"0 s\"\nt_1 = \"2 s\"\nt_2 = \"1 s\"\n", "end after its start"},
        {"x = \"3 m*t/(1 s)\"\n", "t"},
        {"x = \"3 m\"\nt = \"2 m\"\n", "time"}};
    check_refusals("motion.point", rows);
  }
}
