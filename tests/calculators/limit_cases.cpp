// Cases at the edge of what a calculator is for, where the answer is known without it: nothing turns, all are equal, a
// shape becomes a simpler one.
#include "tests/calculators/step_text.hpp"

#include <cmath>
#include <numbers>
#include <set>
#include <span>

namespace {

using namespace loadpath;
using namespace loadpath::test;

constexpr double pi = std::numbers::pi, g = 9.81;

/// The example of a calculator with these lines has this result, in SI units.
struct Case {
  const char* calculator;
  const char* lines;
  const char* result;
  double si;
};

const Case shapes[] = {
    {"section.circle", R"(d = "2 m")", "I_t", pi / 2},
    {"section.ring", "d = \"2 m\"\nt = \"1 m\"", "I_y", pi / 4},                   // no bore
    {"section.ring", "d = \"2 m\"\nt = \"1 um\"", "A", pi * 2e-6 * (1 - 0.5e-6)},  // a line
    {"section.rectangle", "b = \"1 mm\"\nh = \"10 m\"", "I_t",
     10e-9 / 3 * (1 - 0.630249e-4)},  // a strip: 1 - 0.630249 b/h
    {"section.rectangle", "b = \"1 m\"\nh = \"1 m\"", "I_min", 1.0 / 12},
    {"section.polygon", "holes = \npoints = [[\"0 m\", \"0 m\"], [\"1 m\", \"0 m\"], [\"0 m\", \"1 m\"]]", "I_min",
     1.0 / 72},
    {"section.built_up", R"(parts = [{ shape = "rectangle", b = "1 m", h = "1 m", z = "5 m" }])", "I_y", 1.0 / 12},
    {"section.I", "h = \"1 m\"\nb = \"1 m\"\nt_f = \"499.999999 mm\"\nt_w = \"300 mm\"\nr = \"0 mm\"", "I_y", 1.0 / 12},
    {"section.channel", "h = \"1 m\"\nb = \"1 m\"\nt_f = \"499.999999 mm\"\nt_w = \"300 mm\"\nr = \"0 mm\"", "I_y",
     1.0 / 12},
    {"section.T", "h = \"1 m\"\nb = \"1 m\"\nt_f = \"999.999999 mm\"\nt_w = \"300 mm\"\nr = \"0 mm\"", "I_y", 1.0 / 12},
    {"section.angle", "h = \"1 m\"\nb = \"1 m\"\nt = \"999.999999 mm\"\nr = \"0 mm\"\nr_2 = \"0 mm\"", "I_min",
     1.0 / 12},
    {"section.hollow", "h = \"1 m\"\nb = \"1 m\"\nt = \"499.999999 mm\"\nr_o = \"0 mm\"\nr_i = \"0 mm\"", "I_y",
     1.0 / 12},
};

const Case bars[] = {
    {"shaft.torsion", "d = \"2 m\"\ntorques = [{ x = \"0 m\", T = \"1 MN*m\" }, { x = \"1 m\", T = \"-1 MN*m\" }]",
     "tau_max", 1e6 / (pi / 2)},
    {"shaft.overhung", "a = \"0 mm\"\nd = \"40 mm\"", "sigma_b", 0.0},
    {"column.buckling", R"(ends = "pinned_pinned")", "N_cr",
     pi* pi * 210e9 * (pi / 64 * 0.045 * 0.045 * 0.045 * 0.045) / (0.9 * 0.9)},
    {"column.lightest", "families = [\"HEA\"]\nh_max = \"100 mm\"\nP = \"1 kN\"", "q", 16.7},  // the only one
    {"column.effective_length", R"(c_1 = "0 N*m/rad")", "beta", 1.0},                          // a pin
    {"column.effective_length", R"(c_1 = "1e9 kN*m/rad")", "beta",
     0.699155659780},  // built in: pi over the root of tan x = x
};

const Case vessels[] = {
    {"vessel.cylinder", "delta = \"10 mm\"\nmeasured = \"mean\"\nc = \"0 mm\"\nends = \"open\"", "sigma_M", 0.0},
    {"vessel.sphere", "delta = \"50 mm\"\nmeasured = \"mean\"\nc = \"0 mm\"", "sigma_o", 0.8e6 * 5 / 0.1},
    {"vessel.cone", "delta = \"10 mm\"\nrho = \nh_l = \nalpha = \"1 deg\"", "sigma_o",
     0.1e6 * 1.2 / 0.01 / std::cos(pi / 180)},
    {"vessel.torus", "delta = \"5 mm\"\nR_0 = \"100 km\"", "sigma_M", 2.5e6 * 0.2 / 0.005 * (2 - 2e-6) / (2 - 4e-6)},
    {"vessel.ellipsoid", "delta = \"10 mm\"\nmeasured = \"mean\"\nb = \"600 mm\"", "sigma_pole", 0.6e6 * 0.6 / 0.02},
    {"vessel.shell", "delta = \"10 mm\"\npoints = [[\"1 m\", \"0 m\"], [\"1 m\", \"1 m\"], [\"1 m\", \"2 m\"]]",
     "sigma_o", 0.6e6 / 0.01},
};

const Case fatigue[] = {
    {"fatigue.cycle", "sigma_max = \"100 MPa\"\nsigma_min = \"100 MPa\"", "sigma_a", 0.0},
    {"fatigue.endurance", "sigma_W = \"300 MPa\"\nK_t = 1\nd = \"7.5 mm\"\nR_z = \"1 um\"", "sigma_D", 300e6},
    {"fatigue.wohler", "P_s = 0.5", "A_P", 29.9426882630},  // the mean line, by the normal equations
};

const Case drives[] = {
    {"gear.pair", "beta = \"0 deg\"\na_w = \nx_1 = 0", "a_w", 0.5 * 77 * 0.0025},
    {"gear.pair", "beta = \"0 deg\"\na_w = \nx_1 = 0", "F_a", 0.0},
    {"gear.planetary", "fixed = \"carrier\"", "n_r", -1450 * pi / 30 * 24 / 84},
    {"gear.planetary", "eta_0 = 1", "P_loss", 0.0},
    {"chain.roller", "z_1 = 19\nz_2 = 19\na = \"1270 mm\"", "X_0", 2.0 * 1270 / 25.4 + 19},
    {"chain.roller", "z_1 = 19\nz_2 = 19", "alpha_1", pi},
    {"drive.train", R"(stages = [{ kind = "gear", z_1 = 20, z_2 = 20, eta = 1 }])", "P_loss", 0.0},
    {"belt.course", R"(n_1 = "12.5 rad/s")", "v", 1.0},  // of a radius of 80 mm
    {"belt.flat", "b = \"100 mm\"\nd_1 = \"300 mm\"\nd_2 = \"300 mm\"", "L", 2.4 + 0.3 * pi},
    {"belt.flat", "b = \"100 mm\"\nd_1 = \"300 mm\"\nd_2 = \"300 mm\"\narrangement = \"crossed\"", "gamma",
     0.2526802551420786},  // arcsin 0.25
    {"belt.v", "d_1 = \"200 mm\"\nd_2 = \"200 mm\"\nL = \nepsilon = 0\na = \"800 mm\"", "i", 1.0},
    {"belt.v_sizing", "n_2_set = \"1460 rpm\"\nepsilon = 0", "dev_n", 0.0},
};

const Case motion[] = {
    {"motion.point", "x = \"3 m/s*t\"\ny = \"4 m/s*t\"", "kappa", 0.0},
    {"motion.rotation", R"(phi = "1 rad/s*t")", "a_tau", 0.0},
    {"motion.plane", "v_A = \"1 m/s\"\nalpha_A = \"0 deg\"\nalpha_B = \"0 deg\"", "omega", 0.0},
    {"motion.compound", "omega = \"0 rad/s\"\nepsilon = \"0 rad/s^2\"", "a", 3.0},
    {"dynamics.force", "x = \"3 m/s*t\"\ny = \"4 m/s*t\"", "P", 0.0},
    {"dynamics.throw", "theta = \"90 deg\"", "H", 400 / (2 * g)},
    {"dynamics.impulse", "F_x = \"0 N\"", "v_2x", -1.0},
    {"dynamics.momentum", R"(bodies = [{ m = "5 kg", v_1 = "4 m/s", v_2 = "4 m/s" }, { m = "1 kg", v_1 = "4 m/s" }])",
     "Delta_E", 0.0},
    {"dynamics.mass_centre", R"(bodies = [{ m = "1 kg" }, { m = "1 kg", s = "2 m" }])", "Delta_x", -1.0},
    {"dynamics.angular_momentum", R"(parts = [{ m = "1 kg", R_1 = "1 m", omega_1 = "3 rad/s" }])", "omega_2", 3.0},
    {"dynamics.work", "mu = 0\nalpha = \"-90 deg\"", "v_2", std::sqrt(2 * g * 2)},
    {"dynamics.lift", "weights = [{ m = \"1 kg\" }]\nwheels = ", "a", g},
    {"machine.flywheel", R"(M_of_phi = "20 kN*m")", "J_F", 0.0},
    {"machine.run_up",
     "parts = [{ J = \"1 kg*m^2\" }]\nmotor = [[\"0 rpm\", \"10 N*m\"], [\"1400 rpm\", \"10 N*m\"]]\nload = ", "t",
     1400 * pi / 30 / 10},
};

const std::span<const Case> groups[] = {shapes, bars, vessels, fatigue, drives, motion};

}  // namespace

TEST_SUITE("limit cases") {
  TEST_CASE("what is known without the calculator") {
    for (const auto& group : groups) {
      for (const Case& row : group) {
        const std::string what = std::string(row.calculator) + "." + row.result + " with " + row.lines;
        INFO(what);
        const ExampleStep step(row.calculator, row.lines);
        CHECK_MESSAGE(step.fault().empty(), step.fault());
        if (step.fault().empty()) CHECK(step(row.result) == doctest::Approx(row.si).epsilon(2e-6));
      }
    }
  }

  TEST_CASE("every plain calculator has one") {
    std::set<std::string_view> tried;
    for (const auto& group : groups) {
      for (const Case& row : group) tried.insert(row.calculator);
    }
    for (const Calculator* c : calculators()) {
      if (c->evaluate != nullptr) CHECK_MESSAGE(tried.count(c->id) == 1, c->id);
    }
  }
}
