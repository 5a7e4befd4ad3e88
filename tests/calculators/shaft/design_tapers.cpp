// Tapers of a shaft: against closed forms and integrals of another program, between their limits, and what is refused.
#include "calculators/shaft/design/design.hpp"
#include "calculators/shaft/held/held.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

using namespace loadpath;
using account::State;
using doctest::Approx;
using shaft::Design;
using shaft::Holds;
using shaft::Piece;
using shaft::Seat;
using test::contains;
using test::Solved;

constexpr auto solve = test::evaluated<Design>;

Piece piece(double l, double d, double d_2, double d_bore = 0.0) {
  Piece p{{}, l * mm, d * mm, d_bore * mm};
  if (d_2 != d) p.d_2 = d_2 * mm;
  return p;
}

Seat seat(double x, double F_x) {
  Seat s;
  s.x = x * mm, s.F_x = F_x * N, s.J = 0.0 * kg_m2;
  return s;
}

/// On bearings at two places, mm.
Design::Input shaft_on(double left, double right) {
  Design::Input in;
  in.E = 210.0 * GPa, in.G = 81.0 * GPa, in.rho = 7850.0 * kg_per_m3, in.R_e = 370.0 * MPa, in.R_m = 630.0 * MPa;
  in.supports.push_back({{}, left * mm, Holds::both});
  in.supports.push_back({{}, right * mm});
  return in;
}

/// A taper from 80 to 30 mm with a bore of 20 mm, 1 m between its bearings, that bends by its weight.
Design::Input heavy() {
  Design::Input in = shaft_on(0.0, 1000.0);
  in.pieces = {piece(1000.0, 80.0, 30.0, 20.0)};
  in.pieces.front().name = "cone";
  in.seats = {seat(500.0, 0.0), seat(700.0, 0.0)};
  for (Seat& s : in.seats) s.mass = 0.0 * kg;
  in.g_angle = 0.0;
  return in;
}

const shaft::Section& weakest(const Design::Result& r) {
  return *std::max_element(r.sections.begin(), r.sections.end(),
                           [](const auto& a, const auto& b) { return a.sigma_v < b.sigma_v; });
}

const std::string shell = "[axle]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\n";
/// A cone on the end of a shaft, for a coupling, and what else is given.
std::string cone_end(const std::string& lines, const std::string& taper = "d = \"30 mm\", d_2 = \"40 mm\"") {
  return shell + "pieces = [{ name = \"cone\", l = \"100 mm\", " + taper +
         " }, { l = \"200 mm\", d = \"40 mm\" }]\nsupports = [{ name = \"A\", x = \"120 mm\", holds = \"both\" }, { x "
         "= "
         "\"280 mm\" }]\nseats = [{ x = \"20 mm\", F_x = \"2 kN\", T = \"50 N*m\" }, { x = \"200 mm\", way = "
         "\"balances\" }]\n" +
         lines;
}
const std::string tired = "S_F = 1.5\nS_D = 1.5\nr_T = 0\n";

std::string messages(const std::string& lines) { return Solved(lines).messages(); }

}  // namespace

TEST_SUITE("shaft tapers") {
  // The unit load through M/E I and V/kappa G A, integrated with 20 digits.
  TEST_CASE("deflection: a beam that widens to its middle, and a hollow shaft with an overhang") {
    Design::Input in = shaft_on(0.0, 1000.0);
    in.pieces = {piece(500.0, 40.0, 60.0), piece(500.0, 60.0, 40.0)};
    in.seats = {seat(500.0, 10000.0)};
    CHECK(in_si(solve(in).v_max) == Approx(2.35761709497827e-3).epsilon(1e-10));
    // Without shear F l^3/(48 E I) d_middle/d_end: the cone that is held at its large end.
    Design::Input slender = in;
    for (Piece& p : slender.pieces) p.l *= 100.0;
    slender.supports[1].x *= 100.0, slender.seats[0].x *= 100.0;
    const double I = pi / 64.0 * std::pow(0.06, 4.0);
    CHECK(in_si(solve(slender).v_max) == Approx(1e4 * 1e6 / (48.0 * 210e9 * I) * 1.5).epsilon(1e-6));

    Design::Input hollow = shaft_on(20.0, 430.0);
    hollow.pieces = {piece(100.0, 30.0, 30.0, 10.0), piece(200.0, 30.0, 50.0, 10.0), piece(150.0, 50.0, 50.0, 10.0)};
    hollow.seats = {seat(0.0, 2000.0), seat(180.0, -5000.0)};
    for (Seat& s : hollow.seats) s.T = 100.0 * N_m.one;
    hollow.seats[0].way = shaft::Way::drives;
    const Design::Result r = solve(hollow);
    CHECK(in_si(r.seats[0].v) == Approx(7.6100627968763e-5).epsilon(1e-10));
    CHECK(in_si(r.seats[1].v) == Approx(3.40085626454000e-4).epsilon(1e-10));
    CHECK(r.phi * 180.0 / pi == Approx(0.135629889131056).epsilon(1e-12));
    CHECK(in_si(r.theta_max) * 180.0 / pi == Approx(0.900632743487447).epsilon(1e-12));
  }

  // The same way; the frequency from the integral equation of the masses, 20 to 160 places, and their limit.
  TEST_CASE("its own weight: mass, bearings, deflection, the weakest section within it, the critical speed") {
    const Design::Result r = solve(heavy());
    CHECK(in_si(r.mass) == Approx(17.4685641508982).epsilon(1e-12));
    CHECK(-in_si(r.bearings[0].R_x) == Approx(113.365650858357).epsilon(1e-10));
    CHECK(-in_si(r.bearings[1].R_x) == Approx(57.9424437720492).epsilon(1e-10));
    CHECK(in_si(r.seats[0].v) == Approx(2.91757560592901e-5).epsilon(1e-9));
    CHECK(in_si(r.seats[1].v) == Approx(2.87903740070033e-5).epsilon(1e-9));
    CHECK(in_si(weakest(r).sigma_b) == Approx(1.82738785843101e6).epsilon(1e-9));
    CHECK(in_si(weakest(r).x) == Approx(0.778519886670).epsilon(1e-5));
    CHECK(weakest(r).name == Name("cone"));
    CHECK(in_si(r.n_c) == Approx(655.23407).epsilon(1e-5));
  }

  // Gere: a force on the small end of a cone stresses it most where it is half as thick again, 128 F l/(27 pi d^3).
  TEST_CASE("a force on the end of a cone: the weakest section is at 1.5 times its diameter, or at the large end") {
    for (const double F_y : {0.0, 7000.0}) {
      Design::Input in = shaft_on(400.0, 700.0);
      in.pieces = {piece(400.0, 40.0, 80.0), piece(300.0, 80.0, 80.0)};
      in.seats = {seat(0.0, 10000.0)};
      in.seats[0].F_y = F_y * N;
      const shaft::Section worst = weakest(solve(in));
      CHECK(in_si(worst.d) == Approx(0.06).epsilon(1e-6));
      CHECK(in_si(worst.x) == Approx(0.2).epsilon(1e-6));
      CHECK(in_si(worst.sigma_b) ==
            Approx(128.0 * std::hypot(1e4, F_y) * 0.4 / (27.0 * pi * std::pow(0.04, 3.0))).epsilon(1e-11));
      in.pieces[0].d_2 = in.pieces[1].d = 55.0 * mm;  // no longer 1.5 times
      CHECK(in_si(weakest(solve(in)).x) == Approx(0.4).epsilon(1e-9));
    }
  }

  TEST_CASE("fatigue and yield govern at different sections, where the torque starts and stops") {
    const std::string lines = test::with(cone_end(tired), "seats",
                                         "[{ x = \"0 mm\", F_x = \"2 kN\", T = \"400 N*m\" }, { x = \"200 mm\", way = "
                                         "\"balances\" }]");
    Solved solved(test::with(lines, "r_T", "1"));
    REQUIRE_MESSAGE(!has_errors(solved.issues), solved.messages());
    const double yields = solved.value("axle.sections.cone.x"), tires = solved.value("axle.sections.cone_tires.x");
    CHECK(yields < tires);  // towards the small end, which steady torque stresses
    for (const double x : {20.0, 40.0, 60.0, 80.0, 90.0}) {
      const double moment = 2.0 * x, d = 30.0 + 0.1 * x, sigma = 32e3 * moment / (pi * d * d * d),
                   tau = 16e3 * 400.0 / (pi * d * d * d);
      CHECK(solved.value("axle.sections.cone.sigma_v") >= 1e6 * std::sqrt(sigma * sigma + 3.0 * tau * tau));
    }
    const double least = solved.value("axle.safeties.cone_tires.n_Goodman");
    CHECK(least < solved.value("axle.safeties.cone.n_Goodman"));
  }

  TEST_CASE("no taper is a cylinder, to the bit; a slight one hardly differs; many small steps come close") {
    Design::Input plain = shaft_on(0.0, 500.0), same = plain, hardly = plain;
    plain.pieces = same.pieces = hardly.pieces = {piece(300.0, 40.0, 40.0, 12.0), piece(200.0, 50.0, 50.0)};
    same.pieces[0].d_2 = 40.0 * mm;
    hardly.pieces[0].d_2 = 40.0 * (1.0 + 1e-9) * mm;
    for (Design::Input* const in : {&plain, &same, &hardly}) in->seats = {seat(150.0, 3000.0)}, in->g_angle = 1.0;
    const Design::Result a = solve(plain), b = solve(same), c = solve(hardly);
    CHECK(in_si(a.v_max) == in_si(b.v_max));
    CHECK(a.sections.size() == b.sections.size());
    CHECK_FALSE(is_set(b.s_max));
    CHECK(in_si(c.v_max) == Approx(in_si(a.v_max)).epsilon(1e-8));
    CHECK(in_si(c.n_T) == Approx(in_si(a.n_T)).epsilon(1e-8));
    CHECK(in_si(c.mass) == Approx(in_si(a.mass)).epsilon(1e-8));

    Design::Input cone = shaft_on(0.0, 400.0), steps = cone;
    cone.pieces = {piece(400.0, 60.0, 40.0)};
    for (int k = 0; k < 32; ++k)
      steps.pieces.push_back(piece(12.5, 60.0 - 20.0 * (k + 0.5) / 32.0, 60.0 - 20.0 * (k + 0.5) / 32.0));
    cone.seats = steps.seats = {seat(150.0, 3000.0)};
    const Design::Result exact = solve(cone), close = solve(steps);
    CHECK(in_si(close.v_max) == Approx(in_si(exact.v_max)).epsilon(1e-3));
    CHECK(in_si(close.mass) == Approx(in_si(exact.mass)).epsilon(1e-4));
    CHECK(in_si(close.n_T) == Approx(in_si(exact.n_T)).epsilon(1e-3));
  }

  TEST_CASE("under torque alone it twists like the cone of shaft.held, and has the highest stress at its small end") {
    Design::Input in = shaft_on(0.0, 400.0);
    in.pieces = {piece(300.0, 60.0, 40.0, 20.0), piece(100.0, 40.0, 40.0, 20.0)};
    in.seats = {seat(0.0, 0.0), seat(400.0, 0.0)};
    in.seats[0].way = shaft::Way::drives, in.seats[0].T = in.seats[1].T = 500.0 * N_m.one;
    shaft::Held::Input held;
    held.G = in.G, held.tau_adm = 100.0 * MPa, held.end_1 = shaft::End::held;
    held.segments.push_back({{}, 300.0 * mm, 60.0 * mm, 40.0 * mm, 20.0 * mm});
    held.segments.push_back({{}, 100.0 * mm, 40.0 * mm, unset<Length>, 20.0 * mm});
    held.torques.push_back({{}, 400.0 * mm, 500.0 * N_m});
    const Design::Result r = solve(in);
    const shaft::Held::Result other = test::evaluated<shaft::Held>(held);
    CHECK(r.phi == Approx(other.phi_max).epsilon(1e-12));
    CHECK(in_si(weakest(r).tau) == Approx(in_si(other.tau_max)).epsilon(1e-12));
    CHECK(in_si(r.theta_max) == Approx(in_si(other.theta_max)).epsilon(1e-12));
  }

  TEST_CASE("a re-entrant edge needs a notch, an outward one does not; a steep taper is not covered") {
    CHECK(contains(messages(cone_end(tired, "d = \"50 mm\", d_2 = \"40 mm\"")), "a taper begins in a re-entrant edge"));
    const std::string round = "notches = [{ x = \"100 mm\", kind = \"given\", K_t = 1, K_ts = 1 }]\n";
    CHECK_MESSAGE(Solved(cone_end(tired + round, "d = \"50 mm\", d_2 = \"40 mm\"")).errors().empty(),
                  messages(cone_end(tired + round, "d = \"50 mm\", d_2 = \"40 mm\"")));
    CHECK_MESSAGE(Solved(cone_end(tired)).errors().empty(), messages(cone_end(tired)));
    CHECK(Solved(cone_end(tired)).mode("axle.yield").state == State::pass);
    CHECK(contains(messages(cone_end(tired, "d = \"30 mm\", d_2 = \"36 mm\"")), "changes from 36 mm to 40 mm"));
    const std::string shoulder = "notches = [{ name = \"step\", x = \"100 mm\", kind = \"shoulder\", r = \"1 mm\" }]\n";
    Solved stepped(cone_end(tired + shoulder, "d = \"30 mm\", d_2 = \"36 mm\""));
    REQUIRE_MESSAGE(!has_errors(stepped.issues), stepped.messages());
    const std::string plain = "pieces = [{ l = \"100 mm\", d = \"36 mm\" }, { l = \"200 mm\", d = \"40 mm\" }]";
    Solved cylinder(test::with(cone_end(tired + shoulder), "pieces", plain.substr(9)));
    CHECK(stepped.value("axle.safeties.step.K_t") == Approx(cylinder.value("axle.safeties.step.K_t")));
    Solved steep(test::with(cone_end(tired), "pieces",
                            "[{ l = \"20 mm\", d = \"30 mm\", d_2 = \"40 mm\" }, { l = \"280 mm\", d = \"40 mm\" }]"));
    for (const char* mode : {"axle.yield", "axle.fatigue"}) CHECK(steep.mode(mode).state == State::not_covered);
  }

  TEST_CASE("bearings and pressed hubs sit on cylinders; a key on a taper is made for one of its diameters") {
    const auto with_bearing = [](const std::string& more) {
      return test::with(cone_end(""), "supports", "[{ name = \"A\", x = \"50 mm\"" + more + " }, { x = \"280 mm\" }]");
    };
    CHECK(contains(messages(with_bearing("")), "axle.supports.A.x: at 50 mm the shaft tapers from 30 mm to 40 mm"));
    CHECK_MESSAGE(Solved(with_bearing(", on = \"taper\"")).errors().empty(),
                  messages(with_bearing(", on = \"taper\"")));
    const auto notched = [](const std::string& notch) {
      return messages(cone_end(tired + "notches = [{ " + notch + " }]\n"));
    };
    CHECK(contains(notched("x = \"60 mm\", kind = \"press-fit\""), "pressed on a cylinder"));
    CHECK_FALSE(contains(notched("x = \"60 mm\", kind = \"keyway\", d = \"35 mm\""), "made for"));
    CHECK(contains(notched("x = \"60 mm\", kind = \"keyway\", d = \"42 mm\""), "tapers from 30 mm to 40 mm"));
    CHECK(
        contains(notched("x = \"60 mm\", kind = \"groove\", r = \"1 mm\", t = \"18.5 mm\""), "deeper than the shaft"));
    Solved groove(cone_end(
        tired + "notches = [{ name = \"g\", x = \"60 mm\", kind = \"groove\", r = \"1 mm\", t = \"2 mm\" }]\n"));
    CHECK(groove.value("axle.sections.g.d") == Approx(0.032));  // 36 mm less twice its depth
  }

  TEST_CASE("an impossible taper is refused") {
    CHECK_FALSE(Solved(cone_end("", "d = \"30 mm\", d_2 = \"0 mm\"")).errors().empty());
    CHECK_FALSE(Solved(cone_end("", "d = \"30 mm\", d_2 = \"-40 mm\"")).errors().empty());
    CHECK(contains(messages(cone_end("", "d = \"30 mm\", d_2 = \"40 mm\", d_bore = \"35 mm\"")),
                   "a bore must be smaller than the diameters of its segment and the neighbours"));
    CHECK(contains(messages(cone_end("", "d = \"60 mm\", d_2 = \"40 mm\", d_bore = \"45 mm\"")),
                   "a bore must be smaller than the diameters of its segment and the neighbours"));
    CHECK_FALSE(Solved(cone_end("", "d = \"30 mm\", d_2 = \"inf mm\"")).errors().empty());
    CHECK_FALSE(Solved(cone_end("", "d = \"30 mm\", d_2 = \"?\"")).errors().empty());
    CHECK(contains(messages(cone_end("S_F = 1.5\n", "d = \"?\", d_2 = \"40 mm\"")), "no combination of sizes"));
    CHECK(contains(messages(cone_end("d_h = \"50 mm\"\n", "d = \"60 mm\", d_2 = \"40 mm\"")), "heat treatment"));
    CHECK(contains(messages(cone_end("", "d = \"30 mm\", d_2 = \"30 mm\"")), "'pieces.cone.d_2' has no effect") ==
          false);
  }

  TEST_CASE("a cylinder searched for next to a taper may be thicker than its end, or equal to it") {
    const std::string sought = test::with(
        cone_end("S_F = 1.5\n"), "pieces",
        "[{ name = \"cone\", l = \"100 mm\", d = \"30 mm\", d_2 = \"40 mm\" }, { l = \"200 mm\", d = \"?\" }]");
    Solved found(sought);
    REQUIRE_MESSAGE(!has_errors(found.issues), found.messages());
    CHECK(found.value("axle.pieces[2].d") >= 0.04 - 1e-9);
    Solved tied(sought + "S_D = 1.5\nr_T = 0\n");
    REQUIRE_MESSAGE(!has_errors(tied.issues), tied.messages());
    CHECK(tied.value("axle.pieces[2].d") == Approx(0.04));
  }
}
