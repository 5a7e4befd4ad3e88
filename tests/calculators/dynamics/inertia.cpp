// Moments of inertia of composed bodies: published ones, bodies cut in parts, and what is refused.
#include "tests/calculators/motion/solved.hpp"

#include <numbers>

using namespace loadpath::test;

namespace {

constexpr double pi = std::numbers::pi;

SolvedStep body(const std::string& parts, const std::string& more = "") {
  return SolvedStep("dynamics.inertia", more + "parts = [" + parts + "]\n");
}

}  // namespace

TEST_SUITE("dynamics inertia") {
  TEST_CASE("a pendulum of a rod and a disc, and a bicycle wheel, as published") {
    const SolvedStep pendulum = body(
        "{ name = \"rod\", shape = \"rod\", h = \"500 mm\", m = \"270 g\", beta = \"90 deg\", x = \"250 mm\" }, "
        "{ name = \"disc\", shape = \"cylinder\", D = \"200 mm\", m = \"500 g\", x = \"600 mm\" }");
    CHECK(std::abs(pendulum("J") - 0.205) < 0.0005);  // [PhysicsForums-212051]
    CHECK(std::abs(pendulum("x_S") - 0.477) < 0.0005);
    CHECK(near(pendulum("J_S"), 0.205 - 0.77 * std::pow(pendulum("x_S"), 2)));
    const SolvedStep wheel = body(
        "{ shape = \"cylinder\", D = \"600 mm\", d_i = \"600 mm\", m = \"1 kg\" }, "
        "{ shape = \"rod\", h = \"300 mm\", m = \"10 g\", beta = \"90 deg\", x = \"150 mm\", n = 50 }");
    CHECK(near(wheel("J"), 0.105));  // [Byjus-wheel]
    CHECK(near(wheel("m"), 1.5));
    CHECK(wheel("e_S") == 0.0);
  }

  TEST_CASE("n identical parts, equally spaced, are that many parts at their positions") {
    const std::string bolt = "shape = \"cylinder\", D = \"20 mm\", h = \"50 mm\", m = \"120 g\"";
    const std::string eccentric = ", { shape = \"point\", m = \"1 kg\", x = \"30 mm\", y = \"-20 mm\", z = \"7 mm\" }";
    const SolvedStep one = body("{ " + bolt + ", x = \"80 mm\", z = \"5 mm\", n = 4 }" + eccentric);
    std::string apart;
    for (const char* const place : {"x = \"80 mm\"", "x = \"-80 mm\"", "y = \"80 mm\"", "y = \"-80 mm\""})
      apart += "{ " + bolt + ", z = \"5 mm\", " + place + " }, ";
    const SolvedStep four = body(apart + eccentric.substr(2));
    for (const char* const result : {"m", "x_S", "y_S", "z_S", "e_S", "J", "J_S", "i", "i_S"}) {
      CAPTURE(result);
      CHECK(near(one(result), four(result)));
    }
  }

  TEST_CASE("a body equals the sum of the parts that it is cut into") {
    const std::string rho = "rho = \"7850 kg/m^3\"\n";
    const SolvedStep tube = body("{ shape = \"cylinder\", D = \"80 mm\", d_i = \"30 mm\", h = \"90 mm\" }", rho);
    const SolvedStep bored = body(
        "{ shape = \"cylinder\", D = \"80 mm\", h = \"90 mm\" }, "
        "{ shape = \"cylinder\", D = \"30 mm\", h = \"90 mm\", as = \"hole\" }",
        rho);
    CHECK(near(tube("J"), bored("J")));
    CHECK(near(tube("m"), 7850 * pi / 4 * (0.08 * 0.08 - 0.03 * 0.03) * 0.09));
    const SolvedStep shell = body("{ shape = \"sphere\", D = \"80 mm\", d_i = \"30 mm\" }", rho);
    const SolvedStep hollow =
        body("{ shape = \"sphere\", D = \"80 mm\" }, { shape = \"sphere\", D = \"30 mm\", as = \"hole\" }", rho);
    CHECK(near(shell("J"), hollow("J")));
    const SolvedStep block = body("{ shape = \"cuboid\", a = \"60 mm\", b = \"20 mm\", h = \"10 mm\" }", rho);
    const SolvedStep halves = body(
        "{ shape = \"cuboid\", a = \"30 mm\", b = \"20 mm\", h = \"10 mm\", x = \"15 mm\" }, "
        "{ shape = \"cuboid\", a = \"30 mm\", b = \"20 mm\", h = \"10 mm\", x = \"-15 mm\" }",
        rho);
    CHECK(near(block("J"), halves("J")));
    CHECK(near(block("J_S"), halves("J_S")));
  }

  TEST_CASE("the parallel-axis theorem holds far from the axis to all digits") {
    const SolvedStep far = body("{ shape = \"cylinder\", D = \"10 mm\", m = \"1 kg\", x = \"300 m\", y = \"400 m\" }");
    CHECK(near(far("J_S"), 0.01 * 0.01 / 8));
    CHECK(near(far("J"), 250000 + 0.01 * 0.01 / 8, 1e-14));
    CHECK(near(far("i"), 500.0));
  }

  TEST_CASE("inclined bodies lie between their principal axes") {
    // a cone about its base diameter, m (3 R^2 + 2 h^2)/20, from its centre h/4 above it
    const SolvedStep cone =
        body("{ shape = \"cone\", D = \"200 mm\", h = \"400 mm\", m = \"2 kg\", beta = \"90 deg\", x = \"100 mm\" }");
    CHECK(near(cone("J"), 2.0 * (3 * 0.01 + 2 * 0.16) / 20));
    const std::string roller = "{ shape = \"cylinder\", D = \"100 mm\", h = \"300 mm\", m = \"3 kg\", beta = ";
    const double along = body(roller + "\"0 deg\" }")("J"), across = body(roller + "\"90 deg\" }")("J");
    CHECK(near(along, 3 * 0.01 / 8));
    CHECK(near(across, 3 * (3 * 0.0025 + 0.09) / 12));
    CHECK(near(body(roller + "\"30 deg\" }")("J"), 0.75 * along + 0.25 * across));
    CHECK(near(body("{ shape = \"cylinder\", D = \"100 mm\", m = \"3 kg\", beta = \"90 deg\" }")("J"), 3 * 0.01 / 16));
  }

  TEST_CASE("a cone from the density, and a body of known moment of inertia") {
    const SolvedStep cone = body("{ shape = \"cone\", D = \"1 m\", h = \"3 m\", rho = \"1000 kg/m^3\" }");
    CHECK(near(cone("m"), 250 * pi));
    CHECK(near(cone("J"), 250 * pi * 0.075));
    CHECK(near(body("{ shape = \"other\", m = \"2 kg\", J_c = \"5 kg*m^2\", y = \"-3 m\" }")("J"), 23.0));
    CHECK(near(body("{ shape = \"cylinder\", D = \"100 mm\", h = \"10 mm\" }", "material = \"S235JR\"\n")("m"),
               7850 * pi / 4 * 1e-4));
  }

  TEST_CASE("parts without the sizes of their shape, or with extra sizes, are refused") {
    const Refused rows[] = {
        {"parts = [{ shape = \"sphere\", D = \"1 m\", h = \"1 m\", m = \"1 kg\" }]\n", "has no size h"},
        {"parts = [{ shape = \"point\", m = \"1 kg\", D = \"1 m\" }]\n", "has no size D"},
        {"parts = [{ shape = \"cone\", h = \"1 m\", m = \"1 kg\" }]\n", "needs D"},
        {"parts = [{ shape = \"cuboid\", a = \"1 m\", m = \"1 kg\" }]\n", "needs b"},
        {"parts = [{ shape = \"cylinder\", D = \"1 m\" }]\n", "neither a mass nor a density"},
        {"parts = [{ shape = \"cylinder\", D = \"1 m\", rho = \"7850 kg/m^3\" }]\n", "from the density needs h"},
        {"parts = [{ shape = \"cylinder\", D = \"1 m\", d_i = \"1 m\", h = \"1 m\", rho = \"7850 kg/m^3\" }]\n",
         "must be smaller"},
        {"parts = [{ shape = \"cylinder\", D = \"1 m\", d_i = \"2 m\", m = \"1 kg\" }]\n", "must be smaller"},
        {"parts = [{ shape = \"point\", m = \"1 kg\", rho = \"7850 kg/m^3\" }]\n", "both given"},
        {"rho = \"7850 kg/m^3\"\nparts = [{ shape = \"point\" }]\n", "needs its mass"},
        {"parts = [{ shape = \"rod\", h = \"1 m\", m = \"1 kg\" }]\n", "angle of its axis"},
        {"parts = [{ shape = \"cone\", D = \"1 m\", m = \"1 kg\", beta = \"20 deg\" }]\n", "needs its height"},
        {"parts = [{ shape = \"cuboid\", a = \"1 m\", b = \"1 m\", m = \"1 kg\", beta = \"20 deg\" }]\n", "no angle"},
        {"parts = [{ shape = \"other\", m = \"1 kg\" }]\n", "needs its moment"},
        {"parts = [{ shape = \"point\", m = \"1 kg\", J_c = \"1 kg*m^2\" }]\n", "determine J_c"},
        {"parts = [{ shape = \"point\", m = \"1 kg\", as = \"hole\" }]\n", "remove more"},
        {"parts = [{ shape = \"cylinder\", D = \"1 m\", m = \"5 kg\" }, "
         "{ shape = \"point\", m = \"1 kg\", as = \"hole\", x = \"3 m\" }]\n",
         "remove more"},
        {"parts = []\n", "is empty"}};
    check_refusals("dynamics.inertia", rows);
  }

  TEST_CASE("holes outside the material, too long or overlapping are refused with their numbers") {
    const std::string wheel =
        "rho = \"7200 kg/m^3\"\nparts = [{ shape = \"cylinder\", D = \"700 mm\", d_i = \"100 mm\", h = \"10 mm\" }, "
        "{ shape = \"cylinder\", D = \"100 mm\", d_i = \"40 mm\", h = \"60 mm\" }, "
        "{ name = \"bore\", shape = \"cylinder\", as = \"hole\", ";
    const auto fault = [&](const std::string& hole) {
      return SolvedStep("dynamics.inertia", wheel + hole + " }]\n").fault();
    };
    const std::string deep = fault("D = \"20 mm\", h = \"30 mm\", x = \"240 mm\", n = 6");
    CHECK(contains(deep, "the hole 'bore' is 30 mm long along the axis, the solid parts there only 10 mm"));
    CHECK(contains(fault("D = \"20 mm\", h = \"10 mm\", x = \"900 mm\""), "reaches 910 mm from the axis"));
    CHECK(contains(fault("D = \"20 mm\", h = \"10 mm\", x = \"345 mm\""), "the solid parts only 350 mm"));
    CHECK(contains(fault("D = \"10 mm\", h = \"10 mm\""), "meets no solid part at 0 mm from the axis"));
    // 480 mm sin(pi/20) = 75.0885 mm
    const std::string crowded = fault("D = \"120 mm\", h = \"10 mm\", x = \"240 mm\", n = 20");
    CHECK(contains(crowded, "20 holes 'bore' of 120 mm overlap: at 240 mm from the axis each has 75.0885"));
    CHECK(fault("D = \"25.1 mm\", h = \"10 mm\", x = \"240 mm\", n = 60").empty());
    CHECK(fault("D = \"220 mm\", h = \"10 mm\", x = \"240 mm\", n = 2").empty());
    CHECK(fault("D = \"20 mm\", h = \"60 mm\", x = \"35 mm\"").empty());
    CHECK(contains(fault("D = \"120 mm\", h = \"10 mm\", n = 2"), "overlap"));
  }

  TEST_CASE("a hole through parts one behind another, and one in a body of unknown size") {
    const std::string hole = "{ shape = \"cylinder\", as = \"hole\", D = \"20 mm\", h = \"50 mm\", m = \"10 g\" }";
    const std::string disc = "{ shape = \"cylinder\", D = \"90 mm\", h = \"30 mm\", m = \"1 kg\" }, ";
    const std::string next = "{ shape = \"cylinder\", D = \"60 mm\", h = \"20 mm\", m = \"1 kg\", z = \"25 mm\" }, ";
    CHECK(body(disc + next + hole).fault().empty());
    CHECK(contains(body(disc + hole).fault(), "parts[2]"));
    CHECK(body("{ shape = \"other\", m = \"1 kg\", J_c = \"1 kg*m^2\" }, " + hole).fault().empty());
    CHECK(body("{ shape = \"cylinder\", D = \"90 mm\", m = \"1 kg\" }, " + hole).fault().empty());
  }
}
