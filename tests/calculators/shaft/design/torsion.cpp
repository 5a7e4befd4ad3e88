// Shafts in torsional vibration: against closed forms, and designs that must not pass.
#include "calculators/shaft/design/design.hpp"
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace {

using namespace loadpath;
using account::State;
using doctest::Approx;
using test::contains;
using test::Solved;

/// A bar of 1 m and 40 mm between two discs; its speed, and what else is given.
std::string between_discs(const std::string& discs, const std::string& lines) {
  return "[axle]\ncalculator = \"shaft.design\"\nE = \"210 GPa\"\nG = \"80 GPa\"\nrho = \"7850 kg/m^3\"\ngroup = "
         "\"carbon-steel\"\npieces = [{ l = \"1 m\", d = \"40 mm\" }]\nsupports = [{ x = \"0 m\" }, { x = \"1 m\" "
         "}]\nseats = [" +
         discs + "]\n" + lines;
}
const std::string two =
    "{ name = \"a\", x = \"0 m\", mass = \"9 kg\", J = \"0.4 kg*m^2\" }, "
    "{ name = \"b\", x = \"1 m\", mass = \"9 kg\", J = \"0.6 kg*m^2\" }";

State torsion_at(const std::string& lines, const std::string& discs = two) {
  Solved solved(between_discs(discs, lines));
  REQUIRE_MESSAGE(!has_errors(solved.issues), solved.messages());
  return solved.mode("axle.critical_torsion").state;
}

const double stiffness = 80e9 * std::numbers::pi / 32.0 * std::pow(0.04, 4.0);
const double to_rpm = 60.0 / (2.0 * std::numbers::pi);

}  // namespace

TEST_SUITE("shaft design torsion") {
  TEST_CASE("two discs, and the inertia of the shaft between them slightly lowers the frequency of the spring alone") {
    const double own = 7850.0 * std::numbers::pi / 32.0 * std::pow(0.04, 4.0);  // kg m^2, compared with 0.4 and 0.6
    const double bare = std::sqrt(stiffness * (1.0 / 0.4 + 1.0 / 0.6));
    const double omega = Solved(between_discs(two, "")).value("axle.n_T");
    CHECK(omega < bare);
    CHECK(omega == Approx(bare).epsilon(own));
  }

  TEST_CASE("each order keeps its distance from every natural frequency, above and below") {
    Solved solved(between_discs(two, "n = \"600 rpm\"\norders = [{ name = \"teeth\", h = 17 }]\n"));
    const double omega = solved.value("axle.n_T");
    CHECK(solved.value("axle.harmonics.turning.n_above") == Approx(omega));
    CHECK(solved.value("axle.harmonics.turning.u_h") == Approx(1.25 * 600.0 / to_rpm / omega));
    CHECK(solved.value("axle.harmonics.teeth.n_below") == Approx(omega / 17.0));
    CHECK(solved.value("axle.harmonics.teeth.u_h") == Approx(1.25 * omega / 17.0 / (600.0 / to_rpm)));
    const double n = omega * to_rpm;
    const auto at = [&](double speed) { return "n = \"" + std::to_string(speed) + " rpm\"\n"; };
    CHECK(torsion_at(at(0.79 * n)) == State::pass);
    CHECK(torsion_at(at(0.81 * n)) == State::fail);
    CHECK(torsion_at(at(n)) == State::fail);
    CHECK(torsion_at(at(1.24 * n)) == State::fail);
    CHECK(torsion_at(at(1.26 * n)) == State::pass);  // between this one and the next
    CHECK(torsion_at(at(0.26 * n) + "orders = [{ h = 4 }]\n") == State::fail);
  }

  TEST_CASE("unknown data are not assessed, and running through a resonance is reported") {
    CHECK(torsion_at("n = \"600 rpm\"\n") == State::pass);
    CHECK(torsion_at("n = \"600 rpm\"\n", "{ x = \"0 m\", J = \"0.4 kg*m^2\" }, { x = \"1 m\", mass = \"9 kg\" }") ==
          State::not_judged);
    Solved below(between_discs(two, "n = \"600 rpm\"\n")), above(between_discs(two, "n = \"6000 rpm\"\n"));
    CHECK(above.mode("axle.critical_torsion").state == State::pass);
    CHECK(above.mode("axle.resonance").state == State::not_judged);
    CHECK(contains(below.messages(), "resonance") == false);
  }

  TEST_CASE("a soft coupling lowers the frequency, a disc without inertia changes nothing") {
    const auto n_T = [](const std::string& more) { return Solved(between_discs(two + more, "")).value("axle.n_T"); };
    const double plain = n_T("");
    CHECK(n_T(", { x = \"0.3 m\", J = \"0 kg*m^2\" }") == Approx(plain));
    CHECK(n_T(", { x = \"1 m\", J = \"5 kg*m^2\", k_T = \"100 N*m/rad\" }") < 0.7 * plain);
    CHECK(n_T(", { x = \"1 m\", J = \"5 kg*m^2\" }") < plain);
  }
}
