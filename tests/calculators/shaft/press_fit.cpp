#include "calculators/shaft/press_fit.hpp"

#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"
#include "tests/lib/project/says.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

namespace {

using namespace loadpath;
using shaft::PressFit;

constexpr auto solve = test::evaluated<PressFit>;

using test::rel;

/// 50 mm in 80 mm, 40 um, of one material.
PressFit::Input gear() {
  PressFit::Input in;
  in.T = 500.0 * N_m;
  in.d = 50.0 * mm, in.D = 80.0 * mm, in.l = 40.0 * mm;
  in.U_min = in.U_max = 40.0 * um;
  in.Rz_1 = in.Rz_2 = 0.0 * um;
  in.mu = 0.12;
  in.E_1 = in.E_2 = 210.0 * GPa, in.nu_1 = in.nu_2 = 0.3;
  return in;
}

/// Radial stress and displacement of a ring from equilibrium and Hooke's law, in small steps from one radius to
/// another (Runge-Kutta); in N, mm.
struct State {
  double s, u;
};
State across(State at, double r, double end, double E, double nu) {
  const int steps = 4000;
  const double h = (end - r) / steps;
  const auto slope = [&](double x, State y) {
    const double hoop = E * y.u / x + nu * y.s;
    return State{(hoop - y.s) / x, (y.s - nu * hoop) / E};
  };
  for (int i = 0; i < steps; ++i, r += h) {
    const State a = slope(r, at), b = slope(r + h / 2, {at.s + h / 2 * a.s, at.u + h / 2 * a.u});
    const State c = slope(r + h / 2, {at.s + h / 2 * b.s, at.u + h / 2 * b.u});
    const State e = slope(r + h, {at.s + h * c.s, at.u + h * c.u});
    at.s += h / 6 * (a.s + 2 * b.s + 2 * c.s + e.s), at.u += h / 6 * (a.u + 2 * b.u + 2 * c.u + e.u);
  }
  return at;
}

/// How far the loaded radius of a ring, free at the other one, moves under 1 MPa.
double moves(double loaded, double free, double E, double nu) {
  const State at = across({0.0, 1e-3}, free, loaded, E, nu);
  return std::abs(at.u / at.s);
}

/// Errors of a user are reported in these words.
void check_says(const std::string& lines, const std::string& words) {
  CHECK(
      test::says("[f]\ncalculator = \"shaft.press_fit\"\nT = \"100 N*m\"\nmu = 0.15\nl = \"40 mm\"\n" + lines, words));
}

const std::string sizes = "d = \"50 mm\"\nD = \"80 mm\"\nRz_1 = \"4 um\"\nRz_2 = \"6 um\"\n";
const std::string fit = "U_min = \"20 um\"\nU_max = \"60 um\"\n";
const std::string steel = "E_1 = \"210 GPa\"\nE_2 = \"210 GPa\"\nnu_1 = 0.3\nnu_2 = 0.3\n";

}  // namespace

TEST_SUITE("press fit") {
  TEST_CASE("[AICalculator-pressfit]: 51.2 MPa, 38.6 kN, 965 N m, 117 MPa") {
    const auto r = solve(gear());
    CHECK(rel(in_si(r.p_min), 51.19e6) < 1e-4);
    CHECK(rel(in_si(r.F_slip), 38.6e3) < 1e-3);
    CHECK(rel(in_si(r.T_slip), 965.0) < 1e-3);
    CHECK(rel(in_si(r.sigma_t2), 117e6) < 2e-3);
  }

  TEST_CASE("[MachineCalcs-pressfit]: 48.75 MPa, 45.95 kN, 1149 N m, 111.3 MPa") {
    PressFit::Input in = gear();
    in.E_1 = in.E_2 = 200.0 * GPa, in.mu = in.mu_e = 0.15;
    const auto r = solve(in);
    CHECK(rel(in_si(r.p_max), 48.75e6) < 1e-5);
    CHECK(rel(in_si(r.F_e), 45.95e3) < 1e-4);
    CHECK(rel(in_si(r.T_slip), 1149.0) < 1e-3);
    CHECK(rel(in_si(r.sigma_t2), 111.3e6) < 1e-3);
  }

  TEST_CASE("a hollow shaft of steel in a hub of bronze, against the rings integrated from the bore outwards") {
    PressFit::Input in = gear();
    in.d_i = 20.0 * mm, in.E_2 = 105.0 * GPa, in.nu_2 = 0.35;
    const double c = 2.0 * (moves(25.0, 10.0, 210e3, 0.3) + moves(25.0, 40.0, 105e3, 0.35));
    CHECK(rel(in_si(solve(in).p_min), 0.040 / c * 1e6) < 1e-9);
    const State bore = across({-1.0, moves(25.0, 40.0, 105e3, 0.35)}, 25.0, 40.0, 105e3, 0.35);
    CHECK(std::abs(bore.s) < 1e-9);  // free outside
    const double hoop_2 = 105e3 * moves(25.0, 40.0, 105e3, 0.35) / 25.0 + 0.35 * -1.0;
    CHECK(rel(in_si(solve(in).sigma_2 / solve(in).p_max), hoop_2 + 1.0) < 1e-9);
    const State inside = across({-1.0, -moves(25.0, 10.0, 210e3, 0.3)}, 25.0, 10.0, 210e3, 0.3);
    CHECK(rel(in_si(solve(in).sigma_1 / solve(in).p_max), std::abs(210e3 * inside.u / 10.0)) < 1e-9);
  }

  TEST_CASE("torque and axial force add as vectors, and the service factor counts once") {
    PressFit::Input in = gear();
    in.F_z = -15.0 * kN, in.K_A = 1.5, in.S_r = 2.0;
    const auto r = solve(in);
    CHECK(rel(in_si(r.F_res), 1.5 * 25e3) < 1e-12);  // 20 and 15
    CHECK(rel(r.u_s, 2.0 * 37.5e3 / in_si(r.F_slip)) < 1e-12);
  }

  TEST_CASE("smoothing takes 0.8 of both roughness heights, a warmer hub its expansion; a cooler one presses more") {
    PressFit::Input in = gear();
    in.Rz_1 = 4.0 * um, in.Rz_2 = 6.0 * um;
    CHECK(rel(in_si(solve(in).U_w_min), 32e-6) < 1e-12);
    in.alpha_1 = in.alpha_2 = 12e-6 * per_kelvin;
    in.dT_1 = 20.0 * kelvin, in.dT_2 = 40.0 * kelvin;
    CHECK(rel(in_si(solve(in).U_T), 12e-6) < 1e-12);
    CHECK(rel(in_si(solve(in).U_w_min), 20e-6) < 1e-12);
    CHECK(rel(in_si(solve(in).U_w_max), 32e-6) < 1e-12);  // cold
    std::swap(in.dT_1, in.dT_2);
    CHECK(rel(in_si(solve(in).U_w_min), 32e-6) < 1e-12);  // cold
    CHECK(rel(in_si(solve(in).U_w_max), 44e-6) < 1e-12);
  }

  TEST_CASE("the hub is heated until it is wider by interference and clearance") {
    PressFit::Input in = gear();
    in.alpha_2 = 12e-6 * per_kelvin, in.U_c = 50.0 * um, in.dT_adm = 300.0 * kelvin;
    CHECK(rel(in_si(solve(in).dT_A), 150.0) < 1e-12);
    CHECK(rel(solve(in).u_A, 0.5) < 1e-12);
  }

  TEST_CASE("a hollow steel shaft in an aluminium hub at 12000 rpm, against finite elements of both discs") {
    PressFit::Input in = gear();
    in.d = 60.0 * mm, in.d_i = 20.0 * mm, in.D = 110.0 * mm;
    in.U_min = 41.0 * um, in.U_max = 90.0 * um, in.Rz_1 = 4.0 * um, in.Rz_2 = 6.3 * um;
    in.E_2 = 71.0 * GPa, in.nu_2 = 0.34;
    in.rho_1 = 7850.0 * kg_per_m3, in.rho_2 = 2700.0 * kg_per_m3, in.n = -12000.0 * rpm;
    const auto r = solve(in);
    CHECK(rel(in_si(r.p_min), 11.3104e6) < 1e-5);
    CHECK(rel(in_si(r.p_n), 34.4274e6) < 1e-5);
    CHECK(rel(in_si(r.sigma_2), (71.2456e6 + 38.5725e6)) < 1e-5);  // at rest; 75.0 and 34.4 at speed
    CHECK(rel(in_si(r.sigma_1), 86.788e6) < 1e-5);                 // at rest; 68.0 at speed
    CHECK(rel(in_si(r.connection.n_c), in_si(12000.0 * rpm)) < 1e-12);
    in.E_2 = in.E_1, in.nu_2 = in.nu_1, in.rho_2 = in.rho_1;
    const auto steel_hub = solve(in);
    CHECK(rel(in_si(steel_hub.p_min), 27.3635e6) < 1e-5);
    CHECK(rel(in_si(steel_hub.sigma_2), (185.7118e6 + 82.7386e6)) < 1e-5);  // at speed
    CHECK(rel(in_si(steel_hub.sigma_1), 207.894e6) < 1e-5);
  }

  TEST_CASE("without a speed a fit is assessed up to the speed that takes a hundredth of its interference") {
    PressFit::Input in = gear();
    CHECK(in_si(solve(in).connection.n_c) == 0.0);
    in.rho_1 = in.rho_2 = 7850.0 * kg_per_m3;
    const auto n_c = solve(in).connection.n_c;
    const auto at_rest = solve(in);
    in.n = n_c;
    CHECK(rel(in_si(solve(in).p_min), 0.99 * in_si(at_rest.p_min)) < 1e-9);
    in.n = 1e6 * rpm;
    CHECK(solve(in).p_min == 0.0 * MPa);
    CHECK(solve(in).u_n > 1.0);
  }

  TEST_CASE("missing and contradictory inputs are reported") {
    check_says(sizes + fit, "give E and nu of shaft and hub, or a material of both");
    check_says(sizes + "U_min = \"70 um\"\nU_max = \"60 um\"\n" + steel, "U_min must not exceed U_max");
    check_says("d = \"50 mm\"\nD = \"45 mm\"\nRz_1 = \"0 um\"\nRz_2 = \"0 um\"\n" + fit + steel,
               "the diameter of the fit must be between the bore of the shaft and the outer diameter of the hub");
    check_says(sizes + fit + steel + "d_i = \"50 mm\"\n",
               "the diameter of the fit must be between the bore of the shaft and the outer diameter of the hub");
    check_says(sizes + "U_min = \"8 um\"\nU_max = \"60 um\"\n" + steel, "no usable interference remains");
    check_says(
        sizes + fit + steel + "alpha_1 = \"12e-6 1/K\"\nalpha_2 = \"17e-6 1/K\"\ndT_1 = \"50 K\"\ndT_2 = \"60 K\"\n",
        "no usable interference remains");
    check_says(sizes + fit + steel + "dT_2 = \"60 K\"\n",
               "a heating needs the thermal expansion alpha of its part, or a material");
    check_says(sizes + fit + steel + "S_F = 1.2\n", "needs the yield strengths R_e_1 and R_e_2");
    check_says(sizes + fit + steel + "F_adm = \"100 kN\"\n",
               "the press-in force needs the coefficient of friction mu_e");
  }
}
