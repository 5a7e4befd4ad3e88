// A shaft under loads over a revolution: fixed in space and turning with the shaft, by closed forms; a slider-crank
// by another way.
#include "calculators/shaft/design/design.hpp"
#include "tests/lib/project/solved.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using doctest::Approx;
using shaft::Design;
using shaft::Holds;
using shaft::Seat;
using test::Solved;

constexpr std::size_t positions = 90;
double turned(std::size_t i) { return 2.0 * pi * static_cast<double>(i) / positions; }

/// Over one turn, all of one axis.
class Cycle {
 public:
  Cycle() {
    axis_.step = "press", axis_.quantity = "crank angle", axis_.period = 2.0 * pi;
    for (std::size_t i = 0; i < positions; ++i) axis_.at.add(turned(i));
  }
  template <class Quantity>
  [[nodiscard]] Varying<Quantity> of(const std::function<double(double)>& law) const {
    Value value{{dimension_of<Quantity>, &axis_}, {}};
    for (std::size_t i = 0; i < positions; ++i) value.si.push_back(law(turned(i)));
    return Varying<Quantity>(std::move(value));
  }

 private:
  Axis axis_;
};

/// One seat in the middle between two bearings, 200 mm apart: M = F l/4.
Design::Input simple() {
  Design::Input in;
  in.E = 210.0 * GPa, in.G = 81.0 * GPa, in.R_m = 700.0 * MPa, in.R_e = 500.0 * MPa;
  in.S_F = 1.5, in.S_D = 1.5, in.r_T = 1.0, in.n = 100.0 * rpm;
  in.pieces.push_back({{}, 200.0 * mm, 40.0 * mm});
  in.supports.push_back({{}, 0.0 * mm, Holds::both});
  in.supports.push_back({{}, 200.0 * mm});
  Seat seat;
  seat.x = 100.0 * mm;
  in.seats.push_back(seat);
  return in;
}
constexpr std::size_t middle = 1;  // index of the sections
constexpr double F = 2e3, M_0 = F * 0.2 / 4.0;
const double W_b = pi / 32.0 * std::pow(0.04, 3);

Design::Result solve(const Design::Input& in) {
  NoTrace trace;
  return Design::evaluate(in, trace);
}

const std::string crank_press =
    "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"40 mm\"\nl = \"300 mm\"\n"
    "crank = { speed = \"60 rpm\", positions = 360 }\n"
    "loads = [{ name = \"F\", link = \"slider\", at = \"B\", F_x = \"-20 kN\", F_y = \"0 N\" }]\n"
    "[shaft]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\nS_F = 1.5\nS_D = 1.5\n"
    "pieces = [{ l = \"400 mm\", d = \"70 mm\" }]\n"
    "supports = [{ name = \"left\", x = \"50 mm\", holds = \"both\" }, { name = \"right\", x = \"350 mm\" }]\n";
const std::string flywheel = "{ name = \"flywheel\", x = \"0 mm\", way = \"balances\" }";

std::string seats(const std::string& crank) { return "seats = [" + crank + ", " + flywheel + "]\n"; }
const std::string eccentric = "{ name = \"eccentric\", x = \"200 mm\", load = \"=press.shafts.O\" }";

}  // namespace

TEST_SUITE("shaft over a turn") {
  TEST_CASE("a force fixed in space alternates in the shaft, as a single value does") {
    const Cycle cycle;
    Design::Input constant = simple(), series = simple();
    constant.seats[0].F_x = F * N;
    series.seats[0].F_x = cycle.of<Force>([](double) { return F; });
    series.seats[0].psi = cycle.of<double>([](double phi) { return phi; });
    const Design::Result a = solve(constant), b = solve(series);
    CHECK(in_si(b.safeties[middle].sigma_a) == Approx(M_0 / W_b));
    CHECK(in_si(b.safeties[middle].sigma_m) == Approx(0.0).scale(M_0 / W_b).epsilon(1e-12));
    CHECK(b.safeties[middle].n_Goodman == Approx(a.safeties[middle].n_Goodman));
    CHECK(b.safeties[middle].n_elliptic == Approx(a.safeties[middle].n_elliptic));
    CHECK(in_si(b.sections[middle].sigma_v) == Approx(in_si(a.sections[middle].sigma_v)));
    CHECK(in_si(b.bearings[0].F_r) == Approx(in_si(a.bearings[0].F_r)));
    CHECK(in_si(b.v_max) == Approx(in_si(a.v_max)));
  }

  TEST_CASE("a force that rotates with the shaft bends it statically") {
    const Cycle cycle;
    Design::Input in = simple();
    in.seats[0].F_x = cycle.of<Force>([](double phi) { return F * std::cos(phi); });
    in.seats[0].F_y = cycle.of<Force>([](double phi) { return F * std::sin(phi); });
    in.seats[0].psi = cycle.of<double>([](double phi) { return phi; });
    const Design::Result r = solve(in);
    CHECK(in_si(r.safeties[middle].sigma_a) == Approx(0.0).scale(M_0 / W_b).epsilon(1e-12));
    CHECK(in_si(r.safeties[middle].sigma_m) == Approx(M_0 / W_b));
    CHECK(r.safeties[middle].theta == Approx(0.0));
  }

  TEST_CASE("a force along the shaft adds to bending: amplitude to amplitude, mean to mean, pressure like tension") {
    const Cycle cycle;
    const double A = pi / 4.0 * 0.04 * 0.04, along = 20e3;
    Design::Input in = simple();
    in.seats[0].F_x = cycle.of<Force>([](double) { return F; });
    in.seats[0].F_z = cycle.of<Force>([&](double phi) { return along * (0.5 + std::cos(phi)); });
    in.seats[0].psi = cycle.of<double>([](double phi) { return phi; });
    const shaft::Safety swings = solve(in).safeties[middle];
    CHECK(in_si(swings.sigma_a) == Approx(M_0 / W_b + along / A));
    CHECK(in_si(swings.sigma_m) == Approx(0.5 * along / A));
    in.seats[0].F_x = cycle.of<Force>([](double phi) { return F * std::cos(phi); });
    in.seats[0].F_y = cycle.of<Force>([](double phi) { return F * std::sin(phi); });
    in.seats[0].F_z = cycle.of<Force>([&](double) { return -along; });
    const shaft::Safety stays = solve(in).safeties[middle];
    CHECK(in_si(stays.sigma_a) == Approx(0.0).scale(M_0 / W_b).epsilon(1e-12));
    CHECK(in_si(stays.sigma_m) == Approx(M_0 / W_b + along / A));
  }

  TEST_CASE("a force rotating backwards alternates twice per revolution; a shaft at rest has its amplitude only") {
    const Cycle cycle;
    Design::Input in = simple();
    in.seats[0].F_x = cycle.of<Force>([](double phi) { return F * std::cos(phi); });
    in.seats[0].F_y = cycle.of<Force>([](double phi) { return F * std::sin(phi); });
    in.seats[0].psi = cycle.of<double>([](double phi) { return -phi; });
    CHECK(in_si(solve(in).safeties[middle].sigma_a) == Approx(M_0 / W_b).epsilon(1e-3));

    Design::Input axle = simple();
    axle.n = unset<AngularSpeed>;
    axle.seats[0].F_x = cycle.of<Force>([](double phi) { return F * (3.0 + std::cos(phi)); });
    axle.seats[0].psi = 0.0;
    CHECK(in_si(solve(axle).safeties[middle].sigma_a) == Approx(M_0 / W_b));
    CHECK(in_si(solve(axle).safeties[middle].sigma_m) == Approx(3.0 * M_0 / W_b));
  }

  TEST_CASE("fixed and rotating forces together: amplitude of the one, mean of the other") {
    const Cycle cycle;
    Design::Input in = simple();
    in.seats[0].F_x = cycle.of<Force>([](double phi) { return F + 3.0 * F * std::cos(phi); });
    in.seats[0].F_y = cycle.of<Force>([](double phi) { return 3.0 * F * std::sin(phi); });
    in.seats[0].psi = cycle.of<double>([](double phi) { return phi; });
    const Design::Result r = solve(in);
    CHECK(in_si(r.safeties[middle].sigma_a) == Approx(M_0 / W_b));
    CHECK(in_si(r.safeties[middle].sigma_m) == Approx(3.0 * M_0 / W_b));
    CHECK(in_si(r.M_max) == Approx(4.0 * M_0));
  }

  TEST_CASE("the torque varies between its extremes, and to those of starts and stops") {
    const Cycle cycle;
    Design::Input in = simple();
    in.n = unset<AngularSpeed>;
    in.seats[0].T = cycle.of<Moment>([](double phi) { return 300.0 + 100.0 * std::cos(phi); });
    in.seats[0].psi = cycle.of<double>([](double phi) { return phi; });
    Seat wheel;
    wheel.x = 0.0 * mm, wheel.way = shaft::Way::balances;
    in.seats.push_back(wheel);
    const double W_t = 2.0 * W_b;
    const auto torsion = [&](double r_T) {
      in.r_T = r_T;
      const auto s = solve(in).safeties[0];
      return std::pair{in_si(s.sigma_a) / std::sqrt(3.0) * W_t, in_si(s.sigma_m) / std::sqrt(3.0) * W_t};
    };
    CHECK(torsion(unset<double>).first == Approx(100.0));
    CHECK(torsion(unset<double>).second == Approx(300.0));
    CHECK(torsion(0.0).first == Approx(200.0));
    CHECK(torsion(0.0).second == Approx(200.0));
    CHECK(torsion(-1.0).first == Approx(400.0));
    CHECK(torsion(-1.0).second == Approx(0.0));
  }

  TEST_CASE("the harmonics of the torque can excite vibration, and are assessed") {
    const Cycle cycle;
    Design::Input in = simple();
    in.rho = 7850.0 * kg_per_m3;
    in.seats[0].T =
        cycle.of<Moment>([](double phi) { return 300.0 + 100.0 * std::cos(2.0 * phi) + std::sin(3.0 * phi); });
    in.seats[0].psi = cycle.of<double>([](double phi) { return phi; });
    Seat wheel;
    wheel.x = 0.0 * mm, wheel.way = shaft::Way::balances;
    wheel.J = in.seats[0].J = 0.1 * kg_m2;
    in.seats.push_back(wheel);
    const auto& all = solve(in).harmonics;
    REQUIRE(all.size() == 2);  // the third is 1/300 of the torque
    CHECK(all[1].h == Approx(2.0));
    CHECK(all[1].u_h == Approx(2.0 * all[0].u_h));
    in.seats[0].psi = cycle.of<double>([](double phi) { return 2.0 * phi; });
    CHECK(solve(in).harmonics.size() == 1);  // two cycles in two turns
  }

  TEST_CASE("bearings: over the revolution the mean with 10/3, and the largest load") {
    const Cycle cycle;
    Design::Input in = simple();
    in.k_max = 2.0;
    in.seats[0].F_x = cycle.of<Force>([](double phi) { return phi < pi - 1e-9 ? F : 0.0; });
    in.seats[0].psi = cycle.of<double>([](double phi) { return phi; });
    const auto bearing = solve(in).bearings[0];
    CHECK(in_si(bearing.F_r) == Approx(F / 2.0 * std::pow(0.5, 0.3)));  // half of the turn
    CHECK(in_si(bearing.F_r0) == Approx(2.0 * F / 2.0));
    CHECK(in_si(bearing.R_x) == Approx(-F / 2.0));
  }

  TEST_CASE("a random load: no point around the shaft is worse than the one that governs") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    const Cycle cycle;
    for (int k = 0; k < 10; ++k) {
      std::vector<double> a(8);
      for (double& one : a) one = F * part(random);
      const auto law = [](double a_0, double a_1, double b_1, double a_2) {
        return [=](double phi) { return a_0 + a_1 * std::cos(phi) + b_1 * std::sin(phi) + a_2 * std::cos(2.0 * phi); };
      };
      const auto F_x = law(a[0], a[1], a[2], a[3]), F_y = law(a[4], a[5], a[6], a[7]);
      Design::Input in = simple();
      in.seats[0].F_x = cycle.of<Force>(F_x), in.seats[0].F_y = cycle.of<Force>(F_y);
      in.seats[0].psi = cycle.of<double>([](double phi) { return phi; });
      const auto safety = solve(in).safeties[middle];
      double worst = 1e300;
      for (int d = 0; d < 720; ++d) {
        const double theta = 2.0 * pi * d / 720.0;
        double least = 1e300, most = -1e300;
        for (std::size_t i = 0; i < positions; ++i) {
          const double phi = turned(i), at = theta + phi;
          const double sigma = (F_x(phi) * std::cos(at) + F_y(phi) * std::sin(at)) * 0.05 / W_b;
          least = std::min(least, sigma), most = std::max(most, sigma);
        }
        const double sigma_a = (most - least) / 2.0, sigma_m = std::abs(most + least) / 2.0;
        worst = std::min(worst, 1.0 / (sigma_a / in_si(safety.S_e) + sigma_m / 700e6));
      }
      CHECK(safety.n_Goodman == Approx(worst).epsilon(1e-3));
    }
  }

  TEST_CASE("a slider-crank loads its shaft: forces and torque by its closed form") {
    const Solved project(crank_press + seats(eccentric));
    REQUIRE(project.errors().empty());
    double M_max = 0.0, T_max = 0.0;  // the rod: F / cos(beta); the torque: F r sin(phi + beta) / cos(beta)
    for (int i = 0; i < 360; ++i) {
      const double phi = i * pi / 180.0, beta = std::asin(0.04 / 0.3 * std::sin(phi));
      M_max = std::max(M_max, 20e3 / std::cos(beta) * 0.3 / 4.0);
      T_max = std::max(T_max, std::abs(20e3 * 0.04 * std::sin(phi + beta) / std::cos(beta)));
    }
    CHECK(project.value("shaft.M_max") == Approx(M_max).epsilon(1e-9));
    CHECK(project.value("shaft.T_max") == Approx(T_max).epsilon(1e-9));
    CHECK(project.value("shaft.n") == Approx(2.0 * pi));
  }

  TEST_CASE("missing input over a revolution is reported") {
    const auto errors = [](const std::string& crank) { return Solved(crank_press + seats(crank)).errors(); };
    const std::string forces = "{ x = \"200 mm\", F_x = \"=press.shafts.O.F_x\", F_y = \"=press.shafts.O.F_y\", ";
    CHECK(errors(forces + "T = \"=press.shafts.O.T\" }").find("the angle of the shaft is missing") !=
          std::string::npos);
    CHECK(errors(forces + "T = \"=press.shafts.O.T\", psi = \"0 deg\", n = \"60 rpm\" }")
              .find("a single angle means a shaft at rest") != std::string::npos);
    CHECK(errors(forces + "T = \"=press.shafts.O.T\", psi = \"=2.5*press.shafts.O.psi\" }")
              .find("is not at its initial angle") != std::string::npos);
    CHECK(errors(forces + "T = \"=press.shafts.O.T\", psi = \"=2*press.shafts.O.psi\" }").empty());
    CHECK(errors(forces + "T = \"-5 N*m\", psi = \"=press.shafts.O.psi\" }").find("no sign of its own") !=
          std::string::npos);
    CHECK(errors(forces + "T = \"800 N*m\", psi = \"=press.shafts.O.psi\" }")
              .find("fatigue needs the torque ratio r_T, or torques over a revolution") != std::string::npos);
    CHECK(errors("{ x = \"200 mm\", F_x = { values = [1, 2, 1], unit = \"N\" }, F_y = \"=press.shafts.O.F_y\", psi = "
                 "\"=press.shafts.O.psi\", T = \"=press.shafts.O.T\" }")
              .find("same positions") != std::string::npos);
  }
}
