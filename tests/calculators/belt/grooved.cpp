#include "calculators/belt/grooved.hpp"

#include "tests/calculators/belt/steps.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath;
using test::BeltStep;
using test::rel;
using test::with;

constexpr auto solve = test::evaluated<belt::Grooved>;
using Kind = belt::Grooved::Kind;

belt::Grooved::Input rollers() {
  belt::Grooved::Input in;
  in.P = 150.0 * W, in.K_A = 1.2;
  in.n_1 = 1400.0 * rpm;
  in.d_1 = 80.0 * mm, in.d_2 = 160.0 * mm, in.a = 300.0 * mm;
  in.mu = 0.4, in.phi = pi * 2.0 / 9.0;
  in.d_b = 6.0 * mm, in.rho = 1200.0 * kg_per_m3;
  in.sigma_adm = 4.0 * MPa, in.E_b = 15.0 * MPa;
  return in;
}

belt::Grooved::Input ribs() {
  belt::Grooved::Input in;
  in.kind = Kind::ribbed;
  in.P = 5.0 * kW, in.K_A = 1.2;
  in.n_1 = 1450.0 * rpm;
  in.d_1 = 100.0 * mm, in.d_2 = 200.0 * mm, in.a = 400.0 * mm;
  in.mu = 0.4;
  in.p_r = 3.56 * mm, in.q = 0.02 * kg_per_m, in.d_min = 45.0 * mm;
  in.P_R = 0.9 * kW;
  return in;
}

const std::string text = R"(calculator = "belt.grooved"
P = "150 W"
n_1 = "1400 rpm"
d_1 = "80 mm"
d_2 = "160 mm"
a = "300 mm"
mu = 0.4
phi = "40 deg"
d_b = "6 mm"
rho = "1200 kg/m^3"
sigma_adm = "4 MPa"
E_b = "15 MPa"
)";
const std::string ribbed = R"(calculator = "belt.grooved"
ribbed_belt = "PK"
P = "5 kW"
n_1 = "1450 rpm"
d_1 = "100 mm"
d_2 = "200 mm"
a = "400 mm"
mu = 0.4
P_R = "0.9 kW"
)";

}  // namespace

TEST_SUITE("belt grooved") {
  TEST_CASE("a drive of round belts computed by an independent program") {
    const auto r = solve(rollers());
    CHECK(rel(r.m_e, 28.82828323436041) < 1e-12);
    CHECK(rel(in_si(r.S_N), 80.12188170760285) < 1e-12);
    CHECK(rel(r.z_0, 0.39685977799608235) < 1e-12);
    CHECK(r.z == 1);
    CHECK(rel(in_si(r.S_0_min), 17.616896592993626) < 1e-12);
    CHECK(rel(in_si(r.S_1), 32.96398039114068) < 1e-12);
    CHECK(rel(in_si(r.S_2), 2.269812794846776) < 1e-12);
    CHECK(rel(r.u_T, 0.572715579068575) < 1e-12);
    CHECK(rel(in_si(r.R_0), 34.91919944877925) < 1e-12);
    CHECK(rel(in_si(r.R), 32.862212456729495) < 1e-12);
    CHECK(rel(in_si(r.L), 0.9823323954763108) < 1e-12);
    CHECK(rel(r.mu_req, 0.4) < 1e-12);
  }

  TEST_CASE("ropes of a published drive: initial tension of each of ten ropes, 24 kW") {
    belt::Grooved::Input in;
    in.P = 24.0 * kW, in.n_1 = 110.0 * rpm;
    in.d_1 = 400.0 * mm, in.d_2 = 800.0 * mm, in.a = 200.0 / std::sin(pi / 18.0) * mm;  // wrap of 160 deg
    in.mu = 0.28, in.phi = pi / 4.0;
    in.z = 10, in.q = 0.52 * kg_per_m, in.S_adm = 1208.0 * N;
    in.tensioning = belt::Grooved::Tensioning::constant_force;  // the book leaves the centrifugal tension out of it
    CHECK(rel(solve(in).alpha_1, pi * 160.0 / 180.0) < 1e-12);
    CHECK(rel(in_si(solve(in).S_0_min), 675.55) < 1e-3);
  }

  TEST_CASE("a groove of 180 deg, and no groove, leave the friction unchanged; narrower grooves grip more") {
    auto in = rollers();
    in.phi = pi;
    CHECK(rel(solve(in).mu_w, 0.4) < 1e-12);
    const auto flat = solve(in);
    in.phi = unset<double>;
    CHECK(rel(solve(in).S_0, flat.S_0) < 1e-12);
    CHECK(solve(rollers()).S_0 < flat.S_0);
  }

  TEST_CASE("V-ribbed belts have grooves of 40 deg unless another angle is given") {
    auto in = ribs();
    CHECK(rel(solve(in).mu_w, 0.4 / std::sin(pi / 9.0)) < 1e-12);
    in.phi = pi / 4.0;
    CHECK(rel(solve(in).mu_w, 0.4 / std::sin(pi / 8.0)) < 1e-12);
  }

  TEST_CASE("the number of ribs is that of the rating, or of the allowable tension if more are needed") {
    auto in = ribs();
    CHECK(rel(solve(in).z_0, 6.0 / 0.9) < 1e-12);
    CHECK(solve(in).z == 7);
    CHECK(rel(solve(in).u_P, 6.0 / 6.3) < 1e-12);
    CHECK(rel(in_si(solve(in).b), 7 * 3.56e-3) < 1e-12);
    in.S_adm = 60.0 * N;
    CHECK(solve(in).z > 7);
    CHECK(solve(in).u_T <= 1.0 + 1e-12);
    in.z = static_cast<int>(solve(in).z) - 1;
    CHECK(solve(in).u_T > 1.0);
  }

  TEST_CASE("with the required number, not rounded, tension and friction are both at their limit") {
    auto in = rollers();
    in.P = 376.0 * W, in.z = 1;
    const double z_0 = solve(in).z_0;
    in.P = in.P / z_0;
    CHECK(rel(solve(in).z_0, 1.0) < 1e-12);
    CHECK(rel(solve(in).u_T, 1.0) < 1e-12);
    CHECK(solve(in).u_S == 1.0);
  }

  TEST_CASE("shafts carry all belts: two belts with half the tension load them like one") {
    auto in = rollers();
    in.rho = 1e-6 * kg_per_m3;
    const auto one = solve(in);
    in.z = 2;
    CHECK(rel(solve(in).R, one.R) < 1e-9);
    CHECK(rel(solve(in).S_1, 0.5 * one.S_1) < 1e-9);
  }

  TEST_CASE("rows of V-ribbed belts give their pitch and their minimum diameter") {
    const BeltStep step(ribbed);
    CHECK(step.value("b") == doctest::Approx(6 * 3.56e-3));
    CHECK(step.value("x_d") == doctest::Approx(0.45));
    CHECK(step.worst() == account::State::pass);
    CHECK(BeltStep(with(with(ribbed, "d_1", "\"40 mm\""), "d_2", "\"80 mm\"")).worst() == account::State::fail);
    CHECK(BeltStep(with(ribbed, "P_R", "\"0.21 kW\"")).value("u_P") < 1.0);
  }

  TEST_CASE("contradictory or missing input is named with its remedy") {
    CHECK(BeltStep(with(text, "rho", "")).says("give the mass per length q, or d_b and rho of a round belt"));
    CHECK(BeltStep(with(text, "S_adm", "\"90 N\"")).says("give either S_adm or sigma_adm"));
    CHECK(BeltStep(with(with(text, "sigma_adm", ""), "E_b", "")).says("give the allowable tension S_adm"));
    CHECK(BeltStep(with(ribbed, "d_b", "\"6 mm\"")).says("a V-ribbed belt has no diameter d_b"));
    CHECK(BeltStep(with(text, "d_b", "\"45 mm\"")).says("thinner than half of the smaller pulley"));
    CHECK(BeltStep(with(text, "a", "\"110 mm\"")).says("the pulleys would touch"));
    CHECK(BeltStep(with(text, "a", "")).says("give either the centre distance a or the belt length L"));
  }
}
