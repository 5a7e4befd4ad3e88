#include "tests/calculators/motion/solved.hpp"

using namespace loadpath::test;

namespace {

SolvedStep point(const std::string& lines) { return {"motion.compound", lines}; }

}  // namespace

TEST_SUITE("motion compound") {
  TEST_CASE("without a rotation there is no Coriolis acceleration") {
    const auto p = point("xi = \"1 m\"\nv_xi = \"2 m/s\"\na_xi = \"3 m/s^2\"\nomega = \"0 rad/s\"\nv_Ax = \"4 m/s\"\n");
    CHECK(p("a_c") == 0.0);
    CHECK(near(p("v"), 6.0));
    CHECK(near(p("a"), 3.0));
    CHECK(p.word("sense") == "none");
  }

  TEST_CASE("motion along the axis of rotation has no Coriolis acceleration") {
    CHECK(point("xi = \"1 m\"\nv_zeta = \"2 m/s\"\nomega = \"5 rad/s\"\n")("a_c") == 0.0);
  }

  TEST_CASE("on a circle the Coriolis acceleration is along the normal one with the rotation, against it otherwise") {
    const auto with = point("xi = \"1 m\"\nv_eta = \"2 m/s\"\na_xi = \"-4 m/s^2\"\nomega = \"5 rad/s\"\n");
    const auto against = point("xi = \"1 m\"\nv_eta = \"-2 m/s\"\na_xi = \"-4 m/s^2\"\nomega = \"5 rad/s\"\n");
    // the same circle about the same axis, its point at (0.6, 0.8) m
    const std::string turned = "xi = \"0.6 m\"\neta = \"0.8 m\"\nomega = \"5 rad/s\"\n";
    CHECK(point(turned + "v_xi = \"-1.6 m/s\"\nv_eta = \"1.2 m/s\"\n").word("sense") == "along");
    CHECK(point(turned + "v_xi = \"1.6 m/s\"\nv_eta = \"-1.2 m/s\"\n").word("sense") == "against");
    CHECK(point(turned + "v_xi = \"1.2 m/s\"\nv_eta = \"1.6 m/s\"\n").word("sense") == "across");
    CHECK(point(turned + "v_xi = \"1.2 m/s\"\n").word("sense") == "oblique");
    CHECK(with.word("sense") == "along");
    CHECK(against.word("sense") == "against");
    // absolute motion on the same circle with v = omega r +- v_r: its normal acceleration is v^2/r
    CHECK(near(with("a"), 49.0));
    CHECK(near(against("a"), 9.0));
  }

  TEST_CASE("rotating the frame rotates the vectors and keeps their magnitudes") {
    const std::string motion =
        "xi = \"0.2 m\"\neta = \"0.1 m\"\nv_xi = \"2 m/s\"\nv_eta = \"-1 m/s\"\n"
        "a_xi = \"3 m/s^2\"\nomega = \"3 rad/s\"\nepsilon = \"2 rad/s^2\"\nphi = ";
    const auto a = point(motion + "\"0 deg\"\n"), b = point(motion + "\"90 deg\"\n");
    CHECK(near(a("a"), b("a")));
    CHECK(near(b("a_y"), a("a_x")));
    CHECK(near(b("a_x"), -a("a_y")));
  }

  TEST_CASE("the magnitude of a vector is that of its components, along the frame as in the fixed axes") {
    const auto p = point(
        "xi = \"0.2 m\"\neta = \"0.1 m\"\nv_xi = \"2 m/s\"\nv_eta = \"-1 m/s\"\nv_zeta = \"0.5 m/s\"\n"
        "a_xi = \"3 m/s^2\"\na_eta = \"1 m/s^2\"\na_zeta = \"-2 m/s^2\"\nomega = \"3 rad/s\"\n"
        "epsilon = \"2 rad/s^2\"\nphi = \"40 deg\"\nv_Ax = \"1 m/s\"\na_Ay = \"2 m/s^2\"\n");
    CHECK(near(p("v_r"), std::hypot(2.0, 1.0, 0.5)));
    CHECK(near(p("a_r"), std::hypot(3.0, 1.0, 2.0)));
    CHECK(near(p("v_e"), std::hypot(p("v_exi"), p("v_eeta"))));
    CHECK(near(p("a_e"), std::hypot(p("a_exi"), p("a_eeta"))));
    CHECK(near(p("a_c"), 2.0 * 3.0 * std::hypot(2.0, 1.0)));
    CHECK(near(p("v"), std::hypot(p("v_x"), p("v_y"), 0.5)));
    CHECK(near(p("a"), std::hypot(p("a_x"), p("a_y"), 2.0)));
  }

  TEST_CASE("the derivatives of the absolute path agree: an independent way by laws of time") {
    // xi = 0.1 m + 2 m/s t on a rod that turns by 3 rad/s: x = xi cos(3 t), y = xi sin(3 t), at t = 0.2 s
    const SolvedStep law("motion.point",
                         "x = \"(0.1 m + 2 m/s*t)*cos(3*t/(1 s))\"\n"
                         "y = \"(0.1 m + 2 m/s*t)*sin(3*t/(1 s))\"\nt = \"0.2 s\"\n");
    const auto p = point("xi = \"0.5 m\"\nv_xi = \"2 m/s\"\nomega = \"3 rad/s\"\nphi = \"0.6 rad\"\n");
    for (const std::string of : {"v_x", "v_y", "a_x", "a_y"}) CHECK(near(p(of), law(of), 1e-12));
  }

  TEST_CASE("the same on a plate that moves along, transversely and upwards, with every term of every law") {
    // at t = 0.2 s on A = (t + t^2, 2 t - t^2/2), turned by 3 t + t^2/2, with xi = 0.1 + 2 t, eta = 0.3 - t + t^2/2
    const std::string xi = "(0.1 m + 2 m/s*t)", eta = "(0.3 m - 1 m/s*t + 0.5 m/s^2*t^2)";
    const std::string phi = "(3*t/(1 s) + 0.5*(t/(1 s))^2)";
    const SolvedStep law("motion.point", "x = \"1 m/s*t + 1 m/s^2*t^2 + " + xi + "*cos" + phi + " - " + eta + "*sin" +
                                             phi + "\"\n" + "y = \"2 m/s*t - 0.5 m/s^2*t^2 + " + xi + "*sin" + phi +
                                             " + " + eta + "*cos" + phi +
                                             "\"\nz = \"0.7 m/s*t + 0.4 m/s^2*t^2\"\nt = \"0.2 s\"\n");
    const auto p = point(
        "xi = \"0.5 m\"\nv_xi = \"2 m/s\"\neta = \"0.12 m\"\nv_eta = \"-0.8 m/s\"\na_eta = \"1 m/s^2\"\n"
        "v_zeta = \"0.86 m/s\"\na_zeta = \"0.8 m/s^2\"\nomega = \"3.2 rad/s\"\nepsilon = \"1 rad/s^2\"\n"
        "phi = \"0.62 rad\"\nv_Ax = \"1.4 m/s\"\nv_Ay = \"1.8 m/s\"\na_Ax = \"2 m/s^2\"\na_Ay = \"-1 m/s^2\"\n");
    for (const std::string of : {"v_x", "v_y", "v", "a_x", "a_y", "a"}) {
      CAPTURE(of);
      CHECK(near(p(of), law(of), 1e-12));
    }
  }
}
