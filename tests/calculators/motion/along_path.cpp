// Motion along known paths: published, closed forms, the same motion by its coordinates, and what is refused.
#include "tests/calculators/motion/solved.hpp"

using namespace loadpath::test;

namespace {

SolvedStep along(const std::string& lines) { return {"motion.along_path", lines}; }

}  // namespace

TEST_SUITE("motion along path") {
  TEST_CASE("on a circle by s = 1 - 3 t + 2 t^2, [WriterBay-38872]") {
    const auto p = along("x = \"5 m*cos(q)\"\ny = \"5 m*sin(q)\"\nS = \"1 m - 3 m/s*t + 2 m/s^2*t^2\"\nt = \"2 s\"\n");
    CHECK(near(p("v"), 5.0));
    CHECK(near(p("a_tau"), 4.0));
    CHECK(near(p("a_n"), 5.0));
    CHECK(near(p("a"), std::sqrt(41.0)));
    CHECK(near(p("q_t"), 0.6));
    CHECK(near(std::hypot(p("a_x"), p("a_y")), p("a")));
  }

  TEST_CASE("a helix backwards: the closed form along every axis") {
    const auto p = along("x = \"3 m*cos(q)\"\ny = \"3 m*sin(q)\"\nz = \"4 m*q\"\nS = \"-10 m/s^2*t^2\"\nt = \"1 s\"\n");
    const double q = -2.0, q_1 = -4.0, q_2 = -4.0;  // q = S/5 and its derivatives
    CHECK(near(p("q_t"), q));
    CHECK(near(p("v_tau"), -20.0));
    CHECK(near(p("v_x"), -3 * std::sin(q) * q_1));
    CHECK(near(p("v_z"), 4 * q_1));
    CHECK(near(p("a_x"), -3 * std::cos(q) * q_1 * q_1 - 3 * std::sin(q) * q_2));
    CHECK(near(p("a_y"), -3 * std::sin(q) * q_1 * q_1 + 3 * std::cos(q) * q_2));
    CHECK(near(p("a_z"), 4 * q_2));
    CHECK(near(p("rho"), 25.0 / 3));
  }

  TEST_CASE("a point whose distance follows from its coordinates has the same motion as from them") {
    // x = 1 m sinh(q), y = 1 m cosh(q) - a catenary turned: arc length of y = cosh(x) is sinh(x)
    const auto p = along(
        "x = \"1 m*q\"\ny = \"0.5 m*(exp(q) + exp(-q))\"\nS = \"0.5 m*(exp(t/(1 s)) - exp(-t/(1 s)))\"\n"
        "t = \"0.8 s\"\n");
    const SolvedStep c("motion.point",
                       "x = \"1 m*t/(1 s)\"\ny = \"0.5 m*(exp(t/(1 s)) + exp(-t/(1 s)))\"\nt = \"0.8 s\"\n");
    CHECK(near(p("q_t"), 0.8));
    for (const char* const result : {"x_M", "y_M", "v_x", "v_y", "v", "a_y", "a_tau", "a_n", "a", "kappa"}) {
      CAPTURE(result);
      CHECK(near(p(result), c(result), 1e-8));
    }
    CHECK(std::abs(p("a_x")) < 1e-8);
  }

  TEST_CASE("the position does not depend on the parameter of the path, and S counts from q_0") {
    const std::string law = "S = \"7 m\"\nt = \"0 s\"\n";
    const auto plain = along("x = \"2 m*q\"\ny = \"1 m*q^2\"\n" + law);
    const auto faster = along("x = \"2 m*exp(q) - 2 m\"\ny = \"1 m*(exp(q) - 1)^2\"\n" + law);
    CHECK(near(plain("x_M"), faster("x_M")));
    CHECK(near(plain("kappa"), faster("kappa")));
    const auto later = along("x = \"2 m*q\"\ny = \"1 m*q^2\"\nq_0 = " + std::to_string(plain("q_t")) +
                             "\nS = \"-7 m\"\nt = \"0 s\"\n");
    CHECK(std::abs(later("q_t")) < 1e-6);
    CHECK(near(along("x = \"5 m*cos(q)\"\ny = \"5 m*sin(q)\"\nS = \"500 m\"\nt = \"0 s\"\n")("q_t"), 100.0));
  }

  TEST_CASE("paths that end, turn back or have no value, and other laws, are refused") {
    const Refused rows[] = {{"x = \"1 m*exp(q)\"\nS = \"-3 m\"\nt = \"1 s\"\n", "the path ends"},
                            {"x = \"1 m*q^2\"\nS = \"3 m\"\nt = \"1 s\"\n", "the path ends, or turns back"},
                            {"x = \"1 m*q^2\"\nq_0 = 1\nS = \"-3 m\"\nt = \"1 s\"\n", "turns back at q = "},
                            {"x = \"1 m*log(q)\"\nS = \"3 m\"\nt = \"1 s\"\n", "x: "},
                            {"x = \"1 m*q\"\nS = \"1 m*sqrt(t/(1 s))\"\nt = \"0 s\"\n", "no value"},
                            {"x = \"1 m*t\"\nS = \"1 m\"\nt = \"0 s\"\n", "length"},
                            {"x = \"1 m*q\"\nS = \"1 s\"\nt = \"0 s\"\n", "length"}};
    check_refusals("motion.along_path", rows);
  }
}
