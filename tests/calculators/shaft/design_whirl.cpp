// Shafts that whirl: against exact transfer matrices, which have neither nodes nor elements, and designs that must not
// pass.
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace {

using namespace loadpath;
using account::State;
using doctest::Approx;
using test::contains;
using test::mode_with;
using test::Solved;

constexpr double rpm = std::numbers::pi / 30.0;

std::string shaft(const std::string& pieces, const std::string& supports, const std::string& seats,
                  const std::string& lines) {
  return "[axle]\ncalculator = \"shaft.design\"\nE = \"210 GPa\"\nG = \"81 GPa\"\nrho = \"7850 kg/m^3\"\ngroup = "
         "\"carbon-steel\"\npieces = [" +
         pieces + "]\nsupports = [" + supports + "]\nseats = [" + seats + "]\n" + lines;
}

/// 300 mm between bearings, and 20 kg on an overhang of 200 mm.
std::string overhung(const std::string& body, const std::string& lines) {
  return shaft("{ l = \"500 mm\", d = \"50 mm\" }", "{ x = \"0 mm\" }, { x = \"300 mm\" }",
               "{ name = \"hub\", x = \"500 mm\", mass = \"20 kg\"" + body + " }", lines);
}
const std::string long_hub = ", I_d = \"0.6 kg*m^2\", I_p = \"0.1 kg*m^2\"";

std::string refused(const std::string& body) { return Solved(overhung(body, "")).errors(); }

std::size_t figures(const std::string& text) {
  std::size_t count = 0;
  const Solved solved(text);
  for (const auto& figure : solved.project.find("axle")->account().figures) count += figure.id == "whirl" ? 1 : 0;
  return count;
}

}  // namespace

TEST_SUITE("shaft design whirl") {
  // The equations of Timoshenko for a shaft that turns, piece by piece as exponentials of matrices, with jumps at discs
  // and bearings; a rigid bearing has 1e12 N/m there.
  TEST_CASE("a bored, stepped shaft with a flat disc, a long hub and an overhung wheel, at 3000 rpm") {
    const Solved solved(shaft(
        "{ l = \"200 mm\", d = \"40 mm\", d_bore = \"10 mm\" }, { l = \"300 mm\", d = \"60 mm\", d_bore = \"10 mm\" }, "
        "{ l = \"250 mm\", d = \"50 mm\" }",
        "{ x = \"120 mm\" }, { x = \"600 mm\", k = \"50 MN/m\" }",
        "{ x = \"50 mm\", mass = \"8 kg\", I_d = \"0.02 kg*m^2\", I_p = \"0.035 kg*m^2\" }, "
        "{ x = \"350 mm\", mass = \"15 kg\", I_d = \"0.12 kg*m^2\", I_p = \"0.09 kg*m^2\" }, "
        "{ x = \"750 mm\", mass = \"20 kg\", I_d = \"0.15 kg*m^2\", I_p = \"0.28 kg*m^2\" }",
        "n = \"3000 rpm\"\nwhirl_modes = 3\n"));
    const auto check = [&](const std::string& which, std::array<double, 5> expected) {
      const std::array<const char*, 5> symbols{"f_0", "f_F", "f_B", "n_F", "n_B"};
      for (std::size_t k = 0; k < 5; ++k) {
        CAPTURE(symbols[k]);
        const double si = k < 3 ? expected[k] : expected[k] * rpm;
        CHECK(solved.value("axle.whirls." + which + "." + symbols[k]) == Approx(si).epsilon(2e-4));
      }
    };
    check("first", {101.042646, 110.246351, 91.557552, 7328.77458, 5101.32776});
    check("second", {196.927527, 201.982978, 191.974481, 13109.1263, 10783.0835});
    check("third", {331.464210, 354.771021, 309.176365, 32013.7009, 14748.3231});
    CHECK(solved.value("axle.n_F") == solved.value("axle.whirls.first.n_F"));
    CHECK(solved.value("axle.u_n") == Approx(1.25 * 3000.0 * rpm / solved.value("axle.n_F")));
  }

  TEST_CASE("a typed width is equivalent to the diametral moment of inertia that it gives") {
    const double I_d = 0.4 / 2.0 + 20.0 * 0.12 * 0.12 / 12.0;
    const Solved typed(overhung(", I_p = \"0.4 kg*m^2\", I_d = \"" + std::to_string(I_d) + " kg*m^2\"", ""));
    const Solved wide(overhung(", I_p = \"0.4 kg*m^2\", b = \"120 mm\"", ""));
    CHECK(typed.value("axle.n_F") == Approx(wide.value("axle.n_F")).epsilon(1e-12));
  }

  TEST_CASE("a long hub lowers the critical speed, and a shaft that passes with a point mass fails") {
    const Solved point(overhung("", "n = \"4300 rpm\"\n")), hub(overhung(long_hub, "n = \"4300 rpm\"\n"));
    CHECK(point.mode("axle.critical_bending").state == State::pass);
    CHECK(point.mode("axle.discs").state == State::not_judged);
    CHECK(hub.mode("axle.critical_bending").state == State::fail);
    CHECK(!hub.has("axle.discs"));
    CHECK(point.value("axle.n_c") == hub.value("axle.n_c"));
    CHECK(hub.value("axle.n_F") == Approx(4605.76524 * rpm).epsilon(1e-4));  // transfer matrices
    const Solved flat(overhung(", I_p = \"0.4 kg*m^2\", b = \"0 mm\"", "n = \"4300 rpm\"\n"));
    CHECK(flat.value("axle.n_F") > flat.value("axle.n_c"));
    CHECK(flat.mode("axle.critical_bending").state == State::pass);
  }

  TEST_CASE("without moments of inertia point masses decide: between bearings open, beyond not assessed") {
    CHECK(mode_with("shaft.design", "", "discs") == "none");
    const std::string between = "{ x = \"150 mm\", mass = \"20 kg\" }", beyond = "{ x = \"450 mm\", mass = \"1 kg\" }";
    const auto discs = [&](const std::string& seats, const std::string& lines) {
      const Solved solved(
          shaft("{ l = \"500 mm\", d = \"50 mm\" }", "{ x = \"0 mm\" }, { x = \"300 mm\" }", seats, lines));
      return solved.has("axle.discs") ? account::slug(solved.mode("axle.discs").state) : "none";
    };
    const std::string known = ", { x = \"100 mm\", mass = \"3 kg\", I_p = \"0 kg*m^2\", I_d = \"0 kg*m^2\" }";
    CHECK(std::string(discs(between, "n = \"300 rpm\"\n")) == "open");
    CHECK(std::string(discs(between, "")) == "none");
    CHECK(std::string(discs(beyond, "n = \"300 rpm\"\n")) == "not-judged");
    CHECK(std::string(discs(between + known, "n = \"300 rpm\"\n")) == "not-judged");
  }

  TEST_CASE("no moments of inertia at all: the point masses, with the gyroscopic effect of the shaft segments") {
    const Solved solved(overhung(", I_p = \"0 kg*m^2\", I_d = \"0 kg*m^2\"", ""));
    CHECK(solved.value("axle.n_F") > solved.value("axle.n_c"));
    CHECK(solved.value("axle.n_F") == Approx(solved.value("axle.n_c")).epsilon(0.003));
    CHECK(solved.value("axle.n_D") < solved.value("axle.n_c"));
    CHECK(solved.value("axle.n_c") < solved.value("axle.n_R"));
  }

  TEST_CASE("an impossible body is refused") {
    CHECK(contains(refused(", I_p = \"0.1 kg*m^2\""), "axle.seats.hub.I_p: it turns about a diameter too"));
    CHECK(contains(refused(", I_d = \"0.1 kg*m^2\""),
                   "axle.seats.hub.I_p: the moment of inertia about its axis is missing"));
    CHECK(contains(refused(", b = \"100 mm\""), "give I_p"));
    CHECK(contains(refused(", I_p = \"0.3 kg*m^2\", I_d = \"0.14 kg*m^2\""), "below half of that about the axis"));
    CHECK(contains(refused(", I_p = \"0.3 kg*m^2\", I_d = \"0.2 kg*m^2\", b = \"1 mm\""), "replaces I_d"));
    CHECK(contains(refused(", J = \"0.2 kg*m^2\", I_p = \"0.3 kg*m^2\", b = \"1 mm\""),
                   "everything that rotates with it"));
    CHECK(refused(", J = \"0.2 kg*m^2\", k_T = \"9 N*m/rad\", I_p = \"0.3 kg*m^2\", b = \"1 mm\"").empty());
    CHECK(contains(Solved(shaft("{ l = \"1 m\", d = \"50 mm\" }", "{ x = \"0 m\" }, { x = \"1 m\" }",
                                "{ x = \"0.5 m\", mass = \"0 kg\", I_p = \"1 kg*m^2\", b = \"0 mm\" }", ""))
                       .errors(),
                   "needs a mass"));
  }

  TEST_CASE("implausible moments of inertia still give a number or no result") {
    for (const char* body : {", I_p = \"1e12 kg*m^2\", b = \"0 mm\"", ", I_p = \"1 kg*m^2\", I_d = \"1e12 kg*m^2\"",
                             ", I_p = \"1e-30 kg*m^2\", b = \"1e6 m\""}) {
      const Solved solved(overhung(body, "n = \"4300 rpm\"\n"));
      CHECK(solved.errors().empty());
      const auto* const n_F = solved.project.value("axle.n_F");
      CHECK((n_F == nullptr || n_F->si[0] > 0.0));
    }
    const Solved stiff(overhung(", I_p = \"1e12 kg*m^2\", b = \"0 mm\"", "n = \"4300 rpm\"\n"));
    const Solved long_one(overhung(", I_p = \"1 kg*m^2\", I_d = \"1e12 kg*m^2\"", "n = \"4300 rpm\"\n"));
    CHECK(stiff.value("axle.n_F") > stiff.value("axle.n_c"));
    CHECK(long_one.mode("axle.critical_bending").state == State::fail);
  }

  TEST_CASE("a Campbell diagram where a speed and the discs are known") {
    CHECK(figures(overhung(long_hub, "n = \"4300 rpm\"\n")) == 1);
    CHECK(figures(overhung(long_hub, "")) == 0);
    CHECK(figures(overhung("", "n = \"4300 rpm\"\n")) == 0);
  }

  TEST_CASE("no Campbell diagram far below the first critical speed, unless several modes are listed") {
    CHECK(figures(overhung(long_hub, "n = \"100 rpm\"\n")) == 0);
    CHECK(figures(overhung(long_hub, "n = \"100 rpm\"\nwhirl_modes = 2\n")) == 1);
  }
}
