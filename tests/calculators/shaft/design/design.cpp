// Shafts on their bearings: statics of random shafts, charts and schools, and designs that must not pass.
#include "calculators/shaft/design/design.hpp"

#include "calculators/fatigue/peterson.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>

namespace {

using namespace loadpath;
using account::State;
using doctest::Approx;
using shaft::Design;
using shaft::Holds;
using shaft::Seat;
using test::contains;
using test::mode_with;
using test::Solved;

constexpr auto solve = test::evaluated<Design>;

/// Three pieces, two or three bearings, forces and thrusts anywhere.
Design::Input random_shaft(std::mt19937& random) {
  std::uniform_real_distribution<double> part(0.0, 1.0), force(-5e3, 5e3);
  Design::Input in;
  in.E = 210.0 * GPa, in.G = 81.0 * GPa;
  for (int k = 0; k < 3; ++k)
    in.pieces.push_back({{}, (50.0 + 200.0 * part(random)) * mm, (20.0 + 40.0 * part(random)) * mm});
  Length l = 0.0 * mm;
  for (const auto& piece : in.pieces) l += piece.l;
  in.supports.push_back({{}, 0.1 * part(random) * l, Holds::both});
  in.supports.push_back({{}, (0.8 + 0.2 * part(random)) * l});
  if (part(random) < 0.5) in.supports.push_back({{}, (0.4 + 0.2 * part(random)) * l, Holds::radial, 1e5 * N_per_mm});
  for (int k = 0; k < 4; ++k) {
    Seat seat;
    seat.x = part(random) * l, seat.angle = 6.0 * part(random);
    seat.F_x = force(random) * N, seat.F_y = force(random) * N, seat.F_z = force(random) * N;
    seat.x_w = 60.0 * part(random) * mm;
    in.seats.push_back(seat);
  }
  return in;
}

/// The sum over all forces, and over their moments about the left end, in the plane that is turned by `turned` from X.
struct Sum {
  double force = 0.0, moment = 0.0, size = 0.0;
};
Sum balance(const Design::Input& in, const Design::Result& r, double turned) {
  Sum sum;
  const auto add = [&](double F, double x, double M) {
    sum.force += F, sum.moment += F * x + M;
    sum.size += std::abs(F);
  };
  for (const Seat& s : in.seats) {
    const double a = s.angle - turned;
    add(in_si(s.F_x.one) * std::cos(a) - in_si(s.F_y.one) * std::sin(a), in_si(s.x),
        -in_si(s.F_z.one) * in_si(s.x_w) * std::cos(a));
  }
  for (const auto& b : r.bearings)
    add(in_si(b.R_x) * std::cos(turned) + in_si(b.R_y) * std::sin(turned), in_si(b.x), 0.0);
  return sum;
}

const std::string bare =
    "[axle]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\nd_h = \"40 mm\"\n"
    "pieces = [{ l = \"200 mm\", d = \"40 mm\" }]\nS_F = 1.5\n";
const std::string two_bearings = "supports = [{ x = \"10 mm\", holds = \"both\" }, { x = \"190 mm\" }]\n";

std::string messages(const std::string& lines) { return Solved(bare + lines).errors(); }

}  // namespace

TEST_SUITE("shaft design") {
  TEST_CASE("bearings and loads balance in every plane, and along the shaft") {
    std::mt19937 random(12);
    for (int k = 0; k < 60; ++k) {
      const Design::Input in = random_shaft(random);
      const Design::Result r = solve(in);
      for (const double turned : {0.0, 1.0, 2.5}) {
        const Sum sum = balance(in, r, turned);
        CHECK(std::abs(sum.force) < 1e-9 * sum.size);
        CHECK(std::abs(sum.moment) < 1e-9 * sum.size);
      }
      double thrust = 0.0;
      for (const Seat& s : in.seats) thrust += in_si(s.F_z.one);
      CHECK(in_si(r.bearings[0].F_a) == Approx(thrust));
      CHECK(in_si(r.sections.front().M) == Approx(0.0).epsilon(1e-9));
    }
  }

  TEST_CASE("loads superpose, and a shaft rotated about its axis has the same results") {
    std::mt19937 random(21);
    for (int k = 0; k < 30; ++k) {
      const Design::Input in = random_shaft(random);
      Design::Input first = in, rest = in, turned = in;
      for (std::size_t i = 0; i < in.seats.size(); ++i) {
        Seat& away = i == 0 ? rest.seats[i] : first.seats[i];
        away.F_x = away.F_y = away.F_z = 0.0 * N;
        turned.seats[i].angle += 0.7;
      }
      const Design::Result all = solve(in), a = solve(first), b = solve(rest), c = solve(turned);
      for (std::size_t i = 0; i < all.bearings.size(); ++i) {
        CHECK(in_si(a.bearings[i].R_x + b.bearings[i].R_x - all.bearings[i].R_x) == Approx(0.0).epsilon(1e-9));
        CHECK(in_si(c.bearings[i].F_r) == Approx(in_si(all.bearings[i].F_r)));
      }
      CHECK(in_si(c.M_max) == Approx(in_si(all.M_max)));
      CHECK(in_si(c.v_max) == Approx(in_si(all.v_max)));
    }
  }

  TEST_CASE("two bearings share a load by the lever arms, whatever the diameters") {
    std::mt19937 random(3);
    for (int k = 0; k < 20; ++k) {
      Design::Input in = random_shaft(random);
      if (in.supports.size() > 2) in.supports.pop_back();
      const Design::Result r = solve(in);
      for (auto& piece : in.pieces) piece.d *= 1.7;
      const Design::Result stiff = solve(in);
      for (std::size_t i = 0; i < 2; ++i) CHECK(in_si(stiff.bearings[i].F_r) == Approx(in_si(r.bearings[i].F_r)));
      CHECK(stiff.v_max < r.v_max);
    }
  }

  TEST_CASE("Peterson's fits: no step, no stress concentration; where two of them meet they agree") {
    using namespace fatigue;
    const Length D = 100.0 * mm;
    CHECK(concentration(shoulder_in_bending, 1e-4 * mm, 1e-4 * mm, D).K >= 1.0);
    for (const double h : {2.0, 5.0, 10.0, 20.0}) {
      for (const std::span<const Fit> fits :
           {std::span<const Fit>(shoulder_in_bending), std::span<const Fit>(groove_in_bending),
            std::span<const Fit>(groove_in_torsion)}) {
        const double below = concentration(fits, h * mm, h / 1.9999 * mm, D).K;
        const double above = concentration(fits, h * mm, h / 2.0001 * mm, D).K;
        CHECK(below == Approx(above).epsilon(0.03));
      }
    }
    // Charts: D/d = 2, r/d = 0.1; bending 1.74, torsion 1.44 (read by eye).
    CHECK(concentration(shoulder_in_bending, 25.0 * mm, 5.0 * mm, D).K == Approx(1.74).epsilon(0.03));
    CHECK(concentration(shoulder_in_bending, 25.0 * mm, 1.0 * mm, D).place > 1.0);
  }

  TEST_CASE("seats lie on the shaft, are located axially, and their torques balance") {
    CHECK(contains(messages("supports = [{ x = \"10 mm\" }]\n"),
                   "a shaft needs at least two bearings, at different positions"));
    CHECK(contains(messages("supports = [{ x = \"10 mm\" }, { x = \"10 mm\" }]\n"),
                   "a shaft needs at least two bearings, at different positions"));
    CHECK(contains(messages(two_bearings + "seats = [{ name = \"wheel\", x = \"210 mm\" }]\n"),
                   "axle.seats.wheel.x: 210 mm is beyond the end of the shaft at 200 mm"));
    CHECK(contains(messages(two_bearings + "seats = [{ x = \"50 mm\", T = \"9 N*m\" }]\n"), "9 N·m remains"));
    CHECK(contains(messages(two_bearings + "seats = [{ x = \"50 mm\", way = \"balances\", T = \"9 N*m\" }]\n"),
                   "must not have a given torque"));
    CHECK(contains(messages("supports = [{ x = \"10 mm\" }, { x = \"190 mm\" }]\nseats = [{ x = \"50 mm\", F_z = \"9 "
                            "N\" }]\n"),
                   "exactly one bearing must take axial forces: holds = \"both\""));
    CHECK(contains(
        messages("supports = [{ x = \"10 mm\", holds = \"both\" }, { x = \"190 mm\", holds = \"both\" }]\n"),
        "only one bearing can be the locating bearing: holds = \"both\" is given for 'supports[1]' and 'supports[2]'"));
    CHECK(contains(messages(two_bearings + "seats = [{ x = \"50 mm\", way = \"drives\", T = \"9 N*m\" }]\n"),
                   "write way = \"takes\" for what is driven"));
    const std::string wheel =
        "seats = [{ x = \"50 mm\", T = \"9 N*m\", way = \"drives\", n = \"500 rpm\" }, { x = \"90 "
        "mm\", T = \"9 N*m\", way = \"takes\" }]\n";
    CHECK(Solved(bare + two_bearings + wheel).mode("axle.critical_torsion").wants ==
          "seats[].J");  // the material gives rho
    std::string negative = bare + two_bearings;
    negative.replace(negative.find("200 mm"), 6, "-30 mm");
    CHECK(contains(Solved(negative).errors(), "must be > 0 mm"));
    CHECK_FALSE(contains(Solved(negative).errors(), "at least two bearings"));
    CHECK(
        contains(messages("supports = [{ x = \"10 mm\", k = \"1e-9 N/mm\" }, { x = \"190 mm\", k = \"1e-9 N/mm\" }]\n"),
                 "the bearings are too compliant to support the shaft"));
    CHECK(contains(messages(two_bearings + "n = \"500 rpm\"\nseats = [{ x = \"50 mm\", n = \"300 rpm\" }]\n"),
                   "all components of a shaft must have the same speed, not zero"));
    CHECK(contains(messages(two_bearings + "n = \"0 rpm\"\n"),
                   "all components of a shaft must have the same speed, not zero"));
  }

  TEST_CASE("notches fit the shaft, and every step has one where fatigue is assessed") {
    const std::string stepped =
        "pieces = [{ l = \"90 mm\", d = \"30 mm\" }, { l = \"110 mm\", d = \"40 mm\" }]\n" + two_bearings;
    const std::string shell =
        "[axle]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\nS_F = 1.5\n";
    const auto says = [&](const std::string& lines) { return Solved(shell + stepped + lines).errors(); };
    const std::string tired = "S_D = 1.5\nr_T = 0\n";
    CHECK(says("").empty());
    CHECK(contains(says(tired), "at 90 mm the diameter changes from 30 mm to 40 mm"));
    CHECK(says(tired + "notches = [{ x = \"90 mm\", kind = \"shoulder\", r = \"2 mm\" }]\n").empty());
    CHECK(contains(says("notches = [{ x = \"90 mm\", kind = \"shoulder\" }]\n"), "needs the radius r"));
    CHECK(contains(says("notches = [{ x = \"50 mm\", kind = \"shoulder\", r = \"2 mm\" }]\n"),
                   "does not change at 50 mm"));
    CHECK(contains(says("notches = [{ x = \"90 mm\", kind = \"keyway\" }]\n"), "a notch of both"));
    CHECK(contains(says("notches = [{ x = \"50 mm\", kind = \"groove\", r = \"1 mm\", t = \"20 mm\" }]\n"), "deeper"));
    CHECK(contains(says("notches = [{ x = \"50 mm\", kind = \"given\", K_t = 2 }]\n"),
                   "K_t and K_ts are given together"));
    CHECK(contains(says("S_D = 1.5\n"), "fatigue needs the torque ratio r_T, or torques over a revolution"));
    CHECK(
        contains(says("d_h = \"35 mm\"\n"), "the heat treatment diameter must not be below that of the finished part"));
  }

  TEST_CASE("designs that break do not pass") {
    CHECK(mode_with("shaft.design", "K_A = 25", "fatigue") == "fail");
    CHECK(mode_with("shaft.design", "K_A = 25", "yield") == "fail");
    CHECK(mode_with("shaft.design", "k_max = 30", "yield") == "fail");
    CHECK(mode_with("shaft.design", "S_D = \nr_T = ", "fatigue") == "not-judged");  // it turns
    CHECK(mode_with("shaft.design", "S_D = \nr_T = \nn = ", "fatigue") == "open");
    CHECK(mode_with("shaft.design", "S_F = ", "yield") == "not-judged");
    CHECK(mode_with("shaft.design", "n = \"200000 rpm\"", "critical_bending") == "fail");  // above it, too
    CHECK(mode_with("shaft.design", "", "bearings") == "not-judged");
    CHECK(mode_with("shaft.design",
                    "pieces = [{ l = \"60 mm\", d = \"30 mm\" }, { l = \"80 mm\", d = \"30.2 mm\" }, "
                    "{ l = \"60 mm\", d = \"30 mm\" }]\nd_h = \"30.2 mm\"",
                    "fatigue") == "not-covered");  // h/r = 0.05 is beyond the charts
    CHECK(mode_with("shaft.design", "v_adm = \"0.001 mm\"", "deflection") == "fail");
    CHECK(mode_with("shaft.design",
                    "supports = [{ x = \"15 mm\", holds = \"both\", beta_adm = \"0.001 deg\" }, { x = \"185 mm\", "
                    "beta_adm = \"1 deg\" }]",
                    "slope_bearings") == "fail");
  }

  TEST_CASE("a reversing torque causes more fatigue than one that starts and stops") {
    const test::ExampleStep pulsating("shaft.design", "r_T = 0"), reversing("shaft.design", "r_T = -1");
    for (const char* school : {"n_Goodman", "n_Soderberg", "n_Gerber", "n_elliptic"}) {
      const std::string n = std::string("safeties.left_shoulder.") + school;
      CHECK(reversing(n) < pulsating(n));
    }
    CHECK(pulsating("safeties.left_shoulder.n_Soderberg") < pulsating("safeties.left_shoulder.n_Goodman"));
    CHECK(pulsating("safeties.left_shoulder.n_Goodman") < pulsating("safeties.left_shoulder.n_Gerber"));
  }

  TEST_CASE("the weight of the shaft bends it, and the weight of every seat acts at its own position") {
    const std::string lying =
        "[axle]\ncalculator = \"shaft.design\"\nE = \"210 GPa\"\nG = \"81 GPa\"\ngroup = \"carbon-steel\"\nrho = "
        "\"7850 "
        "kg/m^3\"\ng_angle = \"-90 deg\"\npieces = [{ l = \"1 m\", d = \"50 mm\" }]\nsupports = "
        "[{ x = \"0 m\" }, { x = \"1 m\" }]\n";
    Solved own(lying), carried(lying + "seats = [{ x = \"500 mm\", mass = \"10 kg\" }]\n");
    const double weight = 7850.0 * 9.80665 * 3.14159265358979 / 4.0 * 0.05 * 0.05;
    CHECK(own.value("axle.bearings[1].R_y") == Approx(weight / 2.0));
    CHECK(own.value("axle.M_max") == Approx(weight / 8.0));
    CHECK(carried.value("axle.bearings[2].R_y") == Approx(weight / 2.0 + 5.0 * 9.80665));
  }

  TEST_CASE("its bearings are assessed by the steps that take each of them, with unchanged loads") {
    const std::string shaft =
        bare +
        "n = \"1000 rpm\"\nsupports = [{ name = \"left\", x = \"10 mm\", holds = \"both\" }, { name = "
        "\"right\", x = \"190 mm\" }]\nseats = [{ x = \"90 mm\", F_x = \"2 kN\", F_z = \"300 N\" }]\n";
    const auto bearing = [](const std::string& name, const std::string& more) {
      return "[" + name + "]\ncalculator = \"bearing.rolling\"\nload = \"=axle.bearings." + name +
             "\"\nkind = \"deep_groove_ball\"\nC = \"29.1 kN\"\nC_0 = \"17.9 kN\"\nf_0 = 14\nn_max = \"8500 "
             "rpm\"\nL_h = \"10000 h\"\ns_0 = 1.5\n" +
             more;
    };
    Solved one(shaft + bearing("left", "")), both(shaft + bearing("left", "") + bearing("right", ""));
    REQUIRE_MESSAGE(!has_errors(both.issues), both.messages());
    CHECK(one.mode("axle.bearings").state != State::pass);
    CHECK(both.mode("axle.bearings").state == State::pass);
    CHECK(both.value("left.F_a") == Approx(300.0));
    CHECK(both.value("right.F_r") == both.value("axle.bearings[2].F_r"));
    Solved weaker(shaft + bearing("left", "") + bearing("right", "F_r = \"10 N\"\n"));
    CHECK(weaker.mode("axle.bearings").state != State::pass);
  }

  TEST_CASE("the keyway of a key is assessed by the shaft that takes its notch, if it is made for that shaft") {
    const std::string key =
        "[key]\ncalculator = \"shaft.key\"\nT = \"100 N*m\"\ntorque = \"one_way\"\nK_A = 1.25\nkey = \"12x8\"\nl = "
        "\"50 mm\"\nl_n = \"60 mm\"\nR_e_1 = \"430 MPa\"\nR_e_2 = \"250 MPa\"\nR_e_k = \"420 MPa\"\n";
    const std::string shaft =
        bare + two_bearings +
        "n = \"1000 rpm\"\nS_D = 1.5\nr_T = 0\nseats = [{ x = \"40 mm\", F_x = \"1 kN\", T = \"100 "
        "N*m\" }, { x = \"200 mm\", way = \"balances\" }]\n";
    const std::string notched = "notches = [{ x = \"60 mm\", part = \"=key.notch\" }]\n";
    Solved apart(shaft + key + "d = \"40 mm\"\n"), taken(shaft + notched + key + "d = \"40 mm\"\n");
    REQUIRE_MESSAGE(!has_errors(taken.issues), taken.messages());
    CHECK(apart.mode("key.fatigue").state == State::not_judged);
    CHECK(taken.mode("key.fatigue").state == taken.mode("axle.fatigue").state);
    CHECK(contains(Solved(shaft + notched + key + "d = \"42 mm\"\n").errors(),
                   "the notch is for a shaft of 42 mm, but the shaft has 40 mm"));
    const std::string reversing = test::with(key, "torque", "\"reversing\"");
    CHECK(contains(Solved(shaft + notched + reversing + "d = \"40 mm\"\n").errors(), "its torque falls to -1"));
  }

  // Each of these passed once.
  TEST_CASE("designs of earlier findings do not pass") {
    const std::string shell = "[axle]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\n";
    const auto says = [&](const std::string& lines) { return Solved(shell + lines).messages(); };
    const std::string pieces = "pieces = [{ l = \"200 mm\", d = \"40 mm\" }]\n" + two_bearings;
    // the lowest mode of a symmetric shaft on three bearings is not symmetric
    const std::string three =
        "pieces = [{ l = \"2 m\", d = \"40 mm\" }]\nsupports = [{ x = \"0 m\" }, { x = \"1 m\" }, { x = \"2 m\" }]\n"
        "seats = [{ x = \"0.5 m\", mass = \"5 kg\" }, { x = \"1.5 m\", mass = \"5 kg\" }]\n";
    CHECK(Solved(shell + three + "n = \"4200 rpm\"\n").mode("axle.critical_bending").state == State::fail);
    CHECK(contains(says("pieces = [{ l = \"100 mm\", d = \"30 mm\" }, { l = \"100 mm\", d = \"60 mm\", d_bore = \"40 "
                        "mm\" }]\n" +
                        two_bearings),
                   "diameters of its segment and the neighbours"));
    const std::string long_bar =
        "pieces = [{ l = \"12 m\", d = \"40 mm\" }]\nsupports = [{ x = \"0 m\" }, { x = \"12 "
        "m\" }]\nd_h = \"40 mm\"\ng_angle = \"-90 deg\"\nS_F = 1.5\n";
    CHECK(Solved(shell + long_bar).mode("axle.yield").utilisation.value_or(0.0) > 0.9);  // by its weight, in the middle
    const std::string stepped =
        "pieces = [{ l = \"100 mm\", d = \"30 mm\" }, { l = \"200 mm\", d = \"40 mm\" }]\nsupports = [{ x "
        "= \"10 mm\" }, { x = \"290 mm\" }]\nseats = [{ x = \"100 mm\", F_x = \"3 kN\" }]\nS_D = 1.5\nr_T "
        "= 0\n";
    const auto with_notch_at = [&](const char* x) {
      return Solved(shell + stepped + "notches = [{ x = \"" + x +
                    "\", kind = \"given\", K_t = 3, K_ts = 2, r = \"1 mm\" }]\n")
          .mode("axle.fatigue")
          .utilisation.value_or(0.0);
    };
    CHECK(with_notch_at("100.0001 mm") == Approx(with_notch_at("100 mm")).epsilon(1e-4));
    CHECK(contains(says(pieces + "notches = [{ x = \"50 mm\", kind = \"keyway\", r = \"0.1 mm\" }]\n"), "leave out r"));
    CHECK(contains(says(pieces + "seats = [{ x = \"50 mm\", F_y = \"10 kN\", x_w = \"200 mm\" }]\n"),
                   "F_y x_w = 2000 N·m, but the torque is T = 0 N·m"));
    CHECK(contains(says(pieces + "seats = [{ x = \"50 mm\", x_w = \"20 mm\", n = \"100 rpm\" }, { x = \"60 mm\", x_w = "
                                 "\"20 mm\", n = \"-100 rpm\" }]\n"),
                   "rotate in opposite directions in two steps"));
    CHECK(Solved(shell + pieces + "n = \"100 rpm\"\nseats = [{ x = \"50 mm\", F_x = \"1 N\" }]\n")
              .mode("axle.critical_bending")
              .state == State::not_judged);  // it is unknown what sits there
    CHECK(Solved(shell + pieces + "seats = [{ x = \"50 mm\", mass = \"5000 kg\" }]\n").mode("axle.weight").state ==
          State::not_judged);
    CHECK(Solved(shell + "pieces = [{ l = \"200 mm\", d = \"40 mm\", d_bore = \"39 mm\" }]\n" + two_bearings)
              .mode("axle.wall")
              .state == State::not_judged);
    CHECK(contains(says(pieces + "R_e = \"900 MPa\"\nR_m = \"500 MPa\"\n"),
                   "the yield strength R_e must not exceed the tensile strength R_m"));
    CHECK(contains(says(pieces + "E = \"210 GPa\"\nG = \"8 GPa\"\n"),
                   "E must be between 2 G and 3 G: moduli of the same material"));
  }

  TEST_CASE("the largest force that is found passes every section") {
    Solved found(
        "[axle]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\npieces = [{ l = "
        "\"200 mm\", d = \"40 mm\" }]\n" +
        two_bearings + "seats = [{ name = \"wheel\", x = \"100 mm\", F_x = \"?\" }]\nS_F = 1.5\n");
    REQUIRE_MESSAGE(!has_errors(found.issues), found.messages());
    CHECK(found.mode("axle.yield").state == State::pass);
    CHECK(found.mode("axle.yield").utilisation.value_or(0.0) > 0.99);
  }

  TEST_CASE("the smallest diameter of a segment that passes every section is found, and why the next smaller fails") {
    const std::string text =
        "[axle]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\nd_h = \"60 "
        "mm\"\nsupports = "
        "[{ x = \"0 mm\" }, { x = \"200 mm\" }]\nseats = [{ x = \"100 mm\", F_x = \"20 kN\" }]\nS_F = 1.5\npieces = [{ "
        "l "
        "= \"200 mm\", d = \"";
    Solved found(text + "?\" }]\n");
    REQUIRE_MESSAGE(!has_errors(found.issues), found.messages());
    const double d = found.value("axle.sections[2].d");  // 1 kN m, 1.5 sigma <= 370 MPa: at least 34.6 mm
    CHECK(d == Approx(0.035));                           // bearings sit on it
    CHECK(found.mode("axle.yield").state == State::pass);
    CHECK(Solved(text + "33.5 mm\" }]\n").mode("axle.yield").state == State::fail);
  }

  TEST_CASE("a position after summed lengths is at their end") {
    const std::string text =
        "[axle]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\npieces = [{ l = \"100 "
        "mm\", d = "
        "\"30 mm\" }, { l = \"200 mm\", d = \"40 mm\" }, { l = \"50 mm\", d = \"30 mm\" }]\nsupports = [{ x = \"10 "
        "mm\" }, { x "
        "= \"340 mm\" }]\nnotches = [{ x = \"100 mm\", kind = \"shoulder\", r = \"2 mm\" }, { x = \"300 mm\", kind = "
        "\"shoulder\", r = \"2 mm\" }]\n";
    CHECK_MESSAGE(Solved(text).errors().empty(), Solved(text).errors());
  }

  TEST_CASE("gears that drive their shaft against each other are refused") {
    const auto says = [](const std::string& F_y) {
      return Solved(bare + two_bearings +
                    "seats = [{ x = \"50 mm\", way = \"drives\", T = \"10 N*m\", F_y = \"-1 kN\", x_w = \"10 mm\" "
                    "}, { x = \"150 mm\", T = \"10 N*m\", F_y = \"" +
                    F_y + "\", x_w = \"5 mm\" }]\n")
          .errors();
    };
    CHECK_MESSAGE(says("2 kN").empty(), says("2 kN"));
    CHECK(contains(says("-2 kN"), "give opposite torques"));
  }

  TEST_CASE("the torque of a seat includes the service factor of the shaft") {
    const std::string key =
        "[key]\ncalculator = \"shaft.key\"\nT = \"=axle.seats.a.T\"\nK_A = 1.5\ntorque = \"one_way\"\nd = "
        "\"40 mm\"\nkey = \"12x8\"\nl = \"50 mm\"\nl_n = \"60 mm\"\nR_e_1 = \"430 MPa\"\nR_e_2 = \"250 MPa\"\nR_e_k = "
        "\"420 MPa\"\n";
    const std::string shaft =
        bare + two_bearings +
        "K_A = 1.5\nseats = [{ name = \"a\", x = \"50 mm\", way = \"drives\", T = \"10 N*m\" }, { x = "
        "\"150 mm\", T = \"10 N*m\" }]\n";
    CHECK(contains(Solved(shaft + key).errors(), "K_A"));
  }
}
