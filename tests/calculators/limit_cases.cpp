// Cases at the edge of what a calculator is for, where the answer is known without it: nothing turns, all are equal, a
// shape becomes a simpler one.
#include "tests/calculators/rows.hpp"
#include "tests/calculators/step_text.hpp"
#include "tests/parts.hpp"

#include <cmath>
#include <numbers>
#include <set>
#include <span>

namespace {

using namespace loadpath;
using namespace loadpath::test;

constexpr double pi = std::numbers::pi, g = 9.81, g_n = 9.80665;

#define MEMBRANE_IN_STEEL "measured = \"mean\"\nc = \"0 mm\"\nE = \"200 GPa\"\n"

/// The example of a calculator with these lines has this result, in SI units.
struct Case {
  const char* calculator;
  const char* lines;
  const char* result;
  double si;
};

const char* const right_triangle =
    "holes = \npoints = [[\"0 m\", \"0 m\"], [\"1 m\", \"0 m\"], [\"0 m\", \"1 m\"]]";  // sides of 1 m from the origin

// 100 N in the middle of 1 m of 10 mm, at rest
const char* const middle_load =
    "pieces = [{ l = \"1 m\", d = \"10 mm\" }]\nsupports = [{ name = \"left\", x = \"0 m\" }, { x = \"1 m\" }]\n"
    "seats = [{ x = \"0.5 m\", F_x = \"100 N\" }]\nnotches = \ng_angle = ";

// The same force on the small end of a cone of 400 mm, 40 mm thick there and 80 mm where a bearing holds it.
const char* const overhung_cone =
    "pieces = [{ name = \"cone\", l = \"400 mm\", d = \"40 mm\", d_2 = \"80 mm\" }, { l = \"300 mm\", d = \"80 mm\" "
    "}]\nsupports = [{ x = \"400 mm\", holds = \"both\" }, { x = \"700 mm\" }]\nseats = [{ x = \"0 m\", F_x = \"100 "
    "N\" }]\n"
    "notches = \ng_angle = ";

const char* const bare_bar =
    "pieces = [{ l = \"1.5 m\", d = \"10 mm\" }]\nsupports = [{ x = \"0 m\" }, { x = \"1.5 m\" }]\nseats = \nnotches = "
    "\ng_angle = \nS_D = \nr_T = \nmaterial = \nE = \"210 GPa\"\nG = \"81 GPa\"\nR_e = \"400 MPa\"\nrho = \"7850 "
    "kg/m^3\"";

// One bar of 200 mm under 1 kN in its middle: 50 N m where the hole is; a step with its shoulder there.
const char* const holed_bar =
    "pieces = [{ l = \"200 mm\", d = \"40 mm\" }]\nsupports = [{ x = \"0 mm\" }, { x = \"200 mm\" }]\n"
    "seats = [{ x = \"100 mm\", F_x = \"1 kN\" }]\n"
    "notches = [{ name = \"hole\", x = \"100 mm\", kind = \"cross-hole\", r = \"4 mm\" }]\ng_angle = ";
const char* const stepped_bar =
    "pieces = [{ l = \"100 mm\", d = \"40 mm\" }, { l = \"100 mm\", d = \"50 mm\" }]\n"
    "supports = [{ x = \"0 mm\" }, { x = \"200 mm\" }]\nseats = [{ x = \"100 mm\", F_x = \"1 kN\" }]\n"
    "notches = [{ name = \"step\", x = \"100 mm\", kind = \"shoulder\", r = \"2 mm\", h = \"4 mm\" }]\ng_angle = ";

/// motion.spherical_four_bar with the arcs of a universal joint at 60 deg.
const char* const universal =
    "alpha_1 = \"90 deg\"\nalpha_2 = \"90 deg\"\nalpha_3 = \"90 deg\"\nalpha_4 = \"60 deg\"\nmu_req = ";

const Case shapes[] = {
    {"section.circle", R"(d = "2 m")", "I_t", pi / 2},
    {"section.circle", "d = \"2 m\"", "A", pi},
    {"section.ellipse", "b = \"2 m\"\nh = \"2 m\"", "I_t", pi / 2},
    {"section.ellipse", "b = \"2 m\"\nh = \"2 m\"", "W_t", pi / 2},
    {"section.ellipse", "b = \"2 m\"\nh = \"4 m\"", "I_y", 2 * pi},
    {"section.ellipse", "b = \"2 m\"\nh = \"4 m\"", "W_max", pi},
    {"shaft.torsion", "torques = \nT = \"1 kN*m\"\ntau_adm = \nsigma_adm = \"100 MPa\"\nbehaviour = \"ductile\"",
     "tau_all", 60e6},
    {"shaft.torsion", "torques = \nT = \"1 kN*m\"\ntau_adm = \nsigma_adm = \"100 MPa\"\nbehaviour = \"brittle\"",
     "tau_all", 75e6},
    {"section.ring", "d = \"2 m\"\nt = \"1 m\"", "I_y", pi / 4},                   // no bore
    {"section.ring", "d = \"2 m\"\nt = \"1 um\"", "A", pi * 2e-6 * (1 - 0.5e-6)},  // a line
    {"section.rectangle", "b = \"1 mm\"\nh = \"10 m\"", "I_t",
     10e-9 / 3 * (1 - 0.630249e-4)},  // a strip: 1 - 0.630249 b/h
    {"section.rectangle", "b = \"1 m\"\nh = \"1 m\"", "I_min", 1.0 / 12},
    {"section.polygon", right_triangle, "W_z_left", 1.0 / 12.0},
    {"section.polygon", right_triangle, "W_z_right", 1.0 / 24.0},
    {"section.polygon", right_triangle, "W_y_bottom", 1.0 / 12.0},
    {"section.polygon", right_triangle, "W_y_top", 1.0 / 24.0},
    {"section.polygon", right_triangle, "I_min", 1.0 / 72},
    {"section.built_up", R"(parts = [{ shape = "rectangle", b = "1 m", h = "1 m", z = "5 m" }])", "I_y", 1.0 / 12},
    {"section.I", "h = \"1 m\"\nb = \"1 m\"\nt_f = \"499.999999 mm\"\nt_w = \"300 mm\"\nr = \"0 mm\"", "I_y", 1.0 / 12},
    {"section.channel", "h = \"1 m\"\nb = \"1 m\"\nt_f = \"499.999999 mm\"\nt_w = \"300 mm\"\nr = \"0 mm\"", "I_y",
     1.0 / 12},
    {"section.T", "h = \"1 m\"\nb = \"1 m\"\nt_f = \"999.999999 mm\"\nt_w = \"300 mm\"\nr = \"0 mm\"", "I_y", 1.0 / 12},
    {"section.angle", "h = \"1 m\"\nb = \"1 m\"\nt = \"999.999999 mm\"\nr = \"0 mm\"\nr_2 = \"0 mm\"", "I_min",
     1.0 / 12},
    {"section.hollow", "h = \"1 m\"\nb = \"1 m\"\nt = \"499.999999 mm\"\nr_o = \"0 mm\"\nr_i = \"0 mm\"", "I_y",
     1.0 / 12},
    // open walls twist like the strip that they are when straightened: its length by t^3/3
    {"section.angle", "h = \"1 m\"\nb = \"0.5 m\"\nt = \"1e-6 mm\"\nr = \"0 mm\"\nr_2 = \"0 mm\"", "I_t",
     1.499999999e-27 / 3},
    {"section.T", "h = \"1 m\"\nb = \"0.5 m\"\nt_w = \"1 mm\"\nt_f = \"1 mm\"\nr = \"0 mm\"", "I_t", 1.499e-9 / 3},
    {"section.channel", "h = \"1 m\"\nb = \"0.5 m\"\nt_w = \"1 mm\"\nt_f = \"1 mm\"\nr = \"0 mm\"", "I_t",
     1.998e-9 / 3},
};

const char* const pressed_hub =
    R"(seats = [{ name = "coupling", x = "0 mm", way = "balances", integral = true }, { name = "gear", x = "100 mm", T = "50 N*m", T_c = "60 N*m", n_c = "2900 rpm" }])";

const Case bars[] = {
    {"shaft.torsion", "d = \"2 m\"\nG = \"80 GPa\"", "segments[2].GI_t", 80e9 * pi / 2},
    {"shaft.torsion", "d = \"2 m\"\nG = \"80 GPa\"", "k_t", 80e9 * pi / 2},  // over 1 m
    {"shaft.torsion", "torques = \nT = \"1 kN*m\"\nsegments = [{ l = \"1 m\", d = \"100 mm\", rho = \"0 mm\" }]",
     "segments[1].tau_rho", 0.0},
    {"shaft.torsion", "torques = \nP = \"1 kW\"\nn = \"1 rad/s\"\nK_A = 1", "M_max", 1000.0},
    {"shaft.torsion", "d = \"2 m\"\ntorques = [{ x = \"0 m\", T = \"1 MN*m\" }, { x = \"1 m\", T = \"-1 MN*m\" }]",
     "tau_max", 1e6 / (pi / 2)},
    {"shaft.overhung", "F = \"0 N\"\nd = \"40 mm\"", "sigma_b", 0.0},
    {"shaft.design", middle_load, "M_max", 25.0},                 // F l/4
    {"shaft.design", middle_load, "bearings.left.R_x", -50},      // half of it
    {"shaft.design", middle_load, "mass", 7840 * pi / 4 * 1e-4},  // of C45E
    {"shaft.design", overhung_cone, "mass", 7840 * pi / 4 * (112e-4 / 3 * 0.4 + 64e-4 * 0.3)},
    {"shaft.design", overhung_cone, "sections.cone.d", 0.06},  // half as thick again
    {"shaft.design", overhung_cone, "sections.cone.sigma_b", 128 * 100 * 0.4 / (27 * pi * 64e-6)},
    {"shaft.design", overhung_cone, "s_max", 0.05},
    {"shaft.design", bare_bar, "n_T", pi* std::sqrt(81e9 / 7850) / 1.5},  // a standing wave
    {"shaft.design", "orders = [{ name = \"high\", h = 1000 }]", "harmonics.high.h", 1000},
    {"shaft.design", holed_bar, "sections.hole.sigma_b", 50 / (pi * 64e-6 / 32 - 0.004 * 16e-4 / 3)},
    {"shaft.design", stepped_bar, "sections.step.u_h", 0.8},
    {"shaft.design", pressed_hub, "seats.gear.x_n", 0.5},
    {"column.buckling",  // lambda = 142.9 is 4.78 sqrt(E/R_e): a little beyond 4.71, where the bar buckles elastically
     R"(method = "aisc"
n_st = 1.67
sigma_P =
ends = "pinned_pinned"
d = "40 mm"
l = "1429 mm"
R_e = "235 MPa")",
     "methods.aisc.sigma_cr", 0.877 * pi* pi * 210e9 / (142.9 * 142.9)},
    {"column.buckling", R"(ends = "pinned_pinned")", "N_cr",
     pi* pi * 210e9 * (pi / 64 * 0.045 * 0.045 * 0.045 * 0.045) / (0.9 * 0.9)},
    {"column.beam_column", "P = \"0 kN\"\nl = \"1 mm\"\nR_e = \"1000 MPa\"", "k_zy",
     0.8 * (0.6 - 0.4 / 3.0)},  // elastic
    {"column.beam_column", "P = \"0 kN\"\nl = \"1 mm\"\nsection = \"SHS 200x200x8\"", "k_zz", 1.0},
    {"column.beam_column", "M_y_1 = \nM_y_2 = \nM_z = \nl = \"1 mm\"", "u_z", 600e3 / (7808e-6 * 235e6)},  // yields
    {"column.lightest", "families = [\"HEA\"]\nh_max = \"100 mm\"\nP = \"1 kN\"", "q", 16.7},  // the only one
    {"column.stepped",  // equal parts without weight are Euler's column
     "rho = \nparts = [{ l = \"3 m\", d = \"100 mm\" }, { l = \"2 m\", d = \"100 mm\", P = \"1 kN\" }]", "F_cr",
     pi* pi * 210e9 * (pi / 64 * 1e-4) / (10.0 * 10.0)},
    {"column.effective_length", R"(c_1 = "0 N*m/rad")", "beta", 1.0},                                     // a pin
    {"column.effective_length", "end_1 = \"fixed\"\nc_1 = \nend_2 = \"free\"\nmode = 3", "beta_n", 0.4},  // 5/4 waves
    {"column.effective_length", "end_1 = \"pinned\"\nc_1 = \nl = \"1 m\"\nE = \"200 GPa\"\nI = \"1 cm^4\"\nmode = 2",
     "N_cr_n", 4 * pi* pi * 2000},
    {"column.effective_length", R"(c_1 = "1e9 kN*m/rad")", "beta",
     0.699155659780},  // built in: pi over the root of tan x = x
    {"column.buckling", "d_bore = \"30 mm\"", "N_cr",
     pi* pi * 210e9 * (pi / 64 * (0.045 * 0.045 * 0.045 * 0.045 - 0.03 * 0.03 * 0.03 * 0.03)) / (1.8 * 1.8)},
    {"column.buckling", "d = \nh = \"60 mm\"\nb = \"40 mm\"\nt_w = \"4 mm\"\nt_f = \"6 mm\"", "N_cr",
     pi* pi * 210e9 * 188928e-12 / (1.8 * 1.8)},  // the rectangle less its hollow
    {"column.buckling",
     "d = \nh = \"60 mm\"\nb = \"40 mm\"\nt_w = \"4 mm\"\nt_f = \"6 mm\"\nkind = \"cold_hollow\"\nE = \"70 GPa\"\n"
     "R_e = \"240 MPa\"\nsigma_P = \"170 MPa\"",
     "r_class", 12.0 / (15.0 * std::sqrt(250.0 / 240.0))},  // the web is 48 mm wide between the corners
    {"column.buckling", "method = \"secant\"\ne_y = \"5 mm\"", "axes[1].sigma_edge",
     340e6},             // the extreme fibre yields
    {"column.buckling",  // of an angle, the weak principal axis
     "d = \nA = \"100 cm^2\"\nI_y = \"2000 cm^4\"\nI_z = \"1000 cm^4\"\nI_min = \"200 cm^4\"\nl = \"5 m\"", "N_cr",
     pi* pi * 210e9 * 200e-8 / (10.0 * 10.0)},
};

const double fourth_of_bore = 0.8 * 0.8 * 0.8 * 0.8;

// A tube whose bore is 0.8 of its diameter, strained and twisted as far as it may be.
const Case tubes[] = {
    {"shaft.torsion", "torques = \nT = \"1 kN*m\"\nchi = 0.8\nG = \ntheta_adm = ", "d_strength",
     std::cbrt(16e3 / (pi * 30e6 * (1 - fourth_of_bore)))},
    {"shaft.torsion", "torques = \nT = \"1 kN*m\"\nchi = 0.8\ntau_adm = \"1 GPa\"", "d_stiffness",
     std::sqrt(std::sqrt(32e3 / (pi * 80e9 * 0.004 * (1 - fourth_of_bore))))},
    {"shaft.torsion", "torques = \nT = \"1 kN*m\"\ntau_adm = ", "d_min",  // only stiffness is required
     std::sqrt(std::sqrt(32e3 / (pi * 80e9 * 0.004)))},
    {"shaft.torsion", "torques = \nT = \"1 kN*m\"\ntau_adm = \nR_e = \"300 MPa\"\nS = 2", "tau_all",
     150e6 / std::sqrt(3.0)},
};

const Case vessels[] = {
    {"vessel.cylinder", "delta = \"10 mm\"\nmeasured = \"mean\"\nc = \"0 mm\"\nends = \"open\"", "sigma_M", 0.0},
    {"vessel.cylinder", MEMBRANE_IN_STEEL "delta = \"10 mm\"", "Delta_R", 0.6 * (96e6 - 0.3 * 48e6) / 200e9},
    {"vessel.cylinder", MEMBRANE_IN_STEEL "delta = \"10 mm\"", "eps_l", (48e6 - 0.3 * 96e6) / 200e9},
    {"vessel.cylinder", MEMBRANE_IN_STEEL "delta = \"10 mm\"", "eps_V", 2 * 4.08e-4 + 9.6e-5},
    {"vessel.sphere", MEMBRANE_IN_STEEL "delta = \"50 mm\"", "Delta_R", 5 * 0.7 * 40e6 / 200e9},
    {"vessel.sphere", MEMBRANE_IN_STEEL "delta = \"50 mm\"", "eps_V", 3 * 0.7 * 40e6 / 200e9},
    {"vessel.sphere", "delta = \"50 mm\"\nmeasured = \"mean\"\nc = \"0 mm\"", "sigma_o", 0.8e6 * 5 / 0.1},
    {"vessel.cone", "delta = \"10 mm\"\nrho = \nh_l = \nalpha = \"1 deg\"", "sigma_o",
     0.1e6 * 1.2 / 0.01 / std::cos(pi / 180)},
    {"vessel.torus", "delta = \"5 mm\"\nR_0 = \"100 km\"", "sigma_M", 2.5e6 * 0.2 / 0.005 * (2 - 2e-6) / (2 - 4e-6)},
    {"vessel.ellipsoid", "delta = \"10 mm\"\nmeasured = \"mean\"\nb = \"600 mm\"", "sigma_pole", 0.6e6 * 0.6 / 0.02},
    {"vessel.shell", "delta = \"10 mm\"\npoints = [[\"1 m\", \"0 m\"], [\"1 m\", \"1 m\"], [\"1 m\", \"2 m\"]]",
     "sigma_o", 0.6e6 / 0.01},
    {"vessel.cone", "delta = \"10 mm\"\nrho = \nh_l = ", "sigma_M", 0.1e6 * 1.2 / (2 * 0.01 * std::cos(pi / 6))},
    {"vessel.torus", "delta = \"10 mm\"", "sigma_M", 2.5e6 * 0.2 / 0.01 * 1.8 / 1.6},  // inside of the ring
    {"vessel.torus", "delta = \"10 mm\"", "sigma_o", 2.5e6 * 0.2 / 0.02},
    {"vessel.torus", "delta = \"10 mm\"\nmeasured = \"inner\"", "sigma_o", 2.5e6 * 0.205 / 0.02},
    {"vessel.cone", "delta = \"10 mm\"\nmeasured = \"inner\"", "R_m", 1.2 + 0.005 * std::cos(pi / 6)},
    {"vessel.sphere", "delta = \"1 m\"\nc = \"0 mm\"\nz_l = 1\nz_c = 1", "sigma_L",  // radii 5 and 6 m
     0.8e6 * (1 + (216.0 + 2 * 125) / (2 * (216 - 125)))},
    {"vessel.cylinder", "rho = \"1000 kg/m^3\"\nh_l = \"3 m\"", "p_i", 1.6e6 + 3000 * g_n},
    // where the middle of what carries lies: a wall of 10 mm of which 1 mm corrodes inside
    {"vessel.cylinder", "delta = \"10 mm\"", "R_m", 0.600 + 0.001 + 0.0045},
    {"vessel.cylinder", "delta = \"10 mm\"\nmeasured = \"outer\"", "R_m", 0.600 - 0.0045},
    {"vessel.cylinder", "delta = \"10 mm\"\nmeasured = \"mean\"", "R_m", 0.600 + 0.0005},
    // rings of half the wall's section take a third of the hoop force
    {"vessel.cylinder",
     "delta = \"10 mm\"\nmeasured = \"mean\"\nc = \"0 mm\"\nends = \"ringed\"\nA_r = \"600 mm^2\"\nl_r = \"120 mm\"",
     "sigma_o", 1.6e6 * 0.6 / 0.015},
    // flat ends of 101 mm of which 1 mm corrodes: the radius is six times what is left
    {"vessel.cylinder", "delta = \"11 mm\"\nmeasured = \"mean\"\ndelta_e = \"101 mm\"", "sigma_e",
     1.24 * 1.6e6 * 6.005 * 6.005},
    {"vessel.cylinder", "delta = \"11 mm\"\nmeasured = \"mean\"\ndelta_e = \"101 mm\"", "u_e",
     1.24 * 1.6 * 6.005 * 6.005 / 140},
    {"vessel.cylinder",
     "delta = \"10 mm\"\nends = \"ringed\"\nmeasured = \"mean\"\nrho = \"1000 kg/m^3\"\nh_l = \"10 m\"", "a_r",
     (1.6e6 + 1e4 * g_n) * 0.6 / 140e6},
    {"vessel.sphere", "sigma_adm = \nR_e = \"300 MPa\"\nS = 1.5", "sigma_all", 200e6},
    {"vessel.cylinder",  // hung up with 10 m of water in it: the weight over the circumference
     "support = \"top\"\nrho = \"1000 kg/m^3\"\nh_l = \"10 m\"\ndelta = \"10 mm\"\np = \"0 MPa\"\nmeasured = \"mean\"\n"
     "c = \"0 mm\"",
     "sigma_M", 1000 * g_n * 10 * 0.6 / (2 * 0.01)},
    // dished ends; stress factors of the knuckle computed independently
    {"vessel.end", "form = \"hemispherical\"\ndelta = \"6 mm\"", "p_s",  // a sphere on its mean radius
     2 * 410e6 / 2.4 * 0.005 / (0.991 + 0.0025)},
    {"vessel.end", "D_i = \"1960 mm\"\ndelta = \"20 mm\"\nc = \"0 mm\"", "beta", 0.7983117214332597},
    {"vessel.end", "D_i = \"1960 mm\"\ndelta = \"20 mm\"\nc = \"0 mm\"\nform = \"korbbogen\"", "beta",
     0.6133547066903113},
    {"vessel.end",
     "D_i = \"2000 mm\"\ndelta = \"20 mm\"\nc = \"0 mm\"\nform = \"torispherical\"\nR = \"2000 mm\"\nr = \"140 mm\"",
     "beta", 1.0020038135755032},
    {"vessel.end", "delta = \"10 mm\"\nc = \"0 mm\"\nform = \"ellipsoidal\"", "R_c", 0.9 * 1.98},
    {"vessel.end", "delta = \"10 mm\"\nc = \"0 mm\"\nform = \"ellipsoidal\"", "r_c", 0.17 * 1.98},
    {"vessel.end", "delta = \"12 mm\"\nR_e = \nR_m = \nsigma_adm = \"150 MPa\"", "f", 150e6},
    {"vessel.end", "delta = \"12 mm\"\nsigma_adm = \"150 MPa\"", "f", 150e6},
    {"vessel.end", "delta = \"12 mm\"\nl_f = \"20 mm\"", "u_f", 0.0},
    {"vessel.end", "delta = \"12 mm\"", "u_f", 1e6 * 1.993 / (2 * 0.011 * 410e6 / 2.4)},
    // tests: 1.25 times the pressure at the strength in the cold, at least 1.43 times the pressure
    {"vessel.end", "delta = \"12 mm\"\np_t = \"1.5 MPa\"\nh_t = \"0 mm\"", "p_tr", 1.43e6},
    {"vessel.end", "delta = \"12 mm\"\np_t = \"1.5 MPa\"\nh_t = \"0 mm\"\nR_e = \"200 MPa\"\nR_e_t = \"265 MPa\"",
     "p_tr", 1.25e6 * 1.325},
    {"vessel.end", "delta = \"12 mm\"\np_t = \"1.5 MPa\"\nh_t = \"0 mm\"", "f_test", 265e6 / 1.05},
    {"vessel.end", "form = \"hemispherical\"\ndelta = \"6 mm\"\nl_f = \np_t = \"1.5 MPa\"\nh_t = \"0 mm\"", "u_t",
     1.5e6 * (0.99 + 0.003) / (2 * 265e6 / 1.05 * 0.006)},
    {"vessel.cylinder", "delta = \"10 mm\"\np_t = \"2.3 MPa\"\nh_t = \"0 mm\"\nR_e_t = \"235 MPa\"", "u_t",
     2.3 * (60.5 / 0.85 + 1) / (235 / 1.05)},
    {"vessel.cylinder",
     "delta = \"10 mm\"\nsigma_adm = \nR_e = \"210 MPa\"\nS = 1.5\np_t = \"2.3 MPa\"\nh_t = \"0 mm\"\nR_e_t = \"315 "
     "MPa\"",
     "p_tr", 1.25 * 1.5 * 1.6e6},
    {"vessel.flat_end", "delta = \"31 mm\"\np_t = \"1.5 MPa\"\nh_t = \"10 m\"", "p_w", 1.5e6 + 1e4 * g_n},
    {"vessel.flat_end", "delta = \"31 mm\"", "p_max", 410e6 / 3.5 / 0.33 * 9 / (602 * 602 / 100.0)},
    {"vessel.flat_end", "", "delta_min", 0.001 + 0.602 * std::sqrt(0.33 * 3.5 / 410)},
    {"vessel.flat_end", "attachment = \"integral\"", "C_e", 0.17},
    {"vessel.flat_end", "attachment = \"bolted\"", "C_e", 0.25},
    {"vessel.flat_end", "m_r = 0.8", "C_e", 0.264},
    {"vessel.flat_end", "m_r = 0.4", "C_e", 0.2},
    {"vessel.flat_end", "C = 0.3", "C_e", 0.3},
    {"vessel.flat_end", "R_e = \nR_m = \nsigma_adm = \"120 MPa\"", "f", 120e6},
    {"vessel.flat_end", "sigma_adm = \"120 MPa\"", "f", 410e6 / 3.5},
    {"vessel.flat_end", "delta = \"31 mm\"\np_t = \"1.5 MPa\"\nh_t = \"0 mm\"", "u_t",
     1.5e6 * 0.33 * 36 / (0.0961 * 265e6 / 1.05)},
    // the same pressure on both sides: no more than that pressure, in all directions
    {"vessel.thick", "delta = \"40 mm\"\np_e = \"40 MPa\"", "sigma_ti", -40e6},
    {"vessel.thick", "delta = \"40 mm\"\np_e = \"40 MPa\"", "w_a", -40e6 * 0.12 * (1 - 2 * 0.3) / 210e9},
    // no axial strain: 2 nu A, with A = 40 MPa of radii 80 and 120 mm over 1.25; the middle of the wall by hand
    {"vessel.thick", "delta = \"40 mm\"\nends = \"restrained\"", "sigma_z", 2 * 0.3 * 32e6},
    {"vessel.thick", "delta = \"40 mm\"\nr = \"96 mm\"", "sigma_tr", 32e6 * (1 + 1.25 * 1.25)},
    {"vessel.thick", "delta = \"40 mm\"\nr = \"96 mm\"", "sigma_rr", 32e6 * (1 - 1.25 * 1.25)},
    {"vessel.thick", "delta = \"40 mm\"\nhypothesis = \"mises\"", "p_pl", 2 * 355e6 * std::log(1.5) / std::sqrt(3.0)},
    // a small bore in a large block under external pressure: twice the pressure
    {"vessel.thick", "delta = \"80 m\"\np = \"0 MPa\"\np_e = \"40 MPa\"", "sigma_ti",
     -80e6 / (1 - 1 / (1001.0 * 1001.0))},
    // thick to thin: the boiler formula on the mean radius
    {"vessel.thick", "delta = \"0.08 mm\"\np = \"0.04 MPa\"\nmeasured = \"mean\"", "sigma_ti",
     0.04e6 * (1000 + 0.25 / 1000)},
    {"vessel.thick", "delta = \"40 mm\"\nends = \"open\"\nhypothesis = \"mises\"", "p_pl", 355e6 * std::log(1.5)},
    // radii of 100 and 150 mm: p = 19/8 of the sum of the cubes
    {"vessel.thick_sphere", "delta = \"50 mm\"", "sigma_ti", 90e6 * (8 + 13.5) / 19},
    {"vessel.thick_sphere", "delta = \"50 mm\"", "sigma_ta", 90e6 * 12 / 19},
    {"vessel.thick_sphere", "delta = \"50 mm\"\nr = \"150 mm\"", "sigma_tr", 90e6 * 12 / 19},
    {"vessel.thick_sphere", "delta = \"50 mm\"\nr = \"120 mm\"", "sigma_rr", 90e6 * 8 / 19 * (1 - 3.375 / 1.728)},
    {"vessel.thick_sphere", "delta = \"50 mm\"\np_e = \"90 MPa\"", "sigma_ti", -90e6},
    {"vessel.thick_sphere", "delta = \"50 mm\"\np_e = \"90 MPa\"", "w_a", -90e6 * 0.15 * (1 - 2 * 0.3) / 210e9},
    {"vessel.thick_sphere", "delta = \"50 mm\"", "p_pl", 2 * 355e6 * std::log(1.5)},
    {"vessel.thick_sphere", "delta = \"0.1 mm\"\np = \"0.1 MPa\"\nmeasured = \"mean\"", "sigma_ti",
     0.1e6 * (500 - 0.25 + 1e-3 / 3)},
    // tubes of 100, 200, 400 mm: K_1 + K_2 = 10/3; bore pressed by 88.2 MPa
    {"vessel.compound", "", "p_max", 210e9 * 280e-6 / 0.2 * 0.3},
    {"vessel.compound", "", "states.rest.sigma_1i", -2 * 88.2e6 / 0.75},
    {"vessel.compound", "", "states.pressure_loose.sigma_1i", (250e6 * 1.25 - 2 * 125.6e6) / 0.75},
    {"vessel.compound", "", "states.pressure.sigma_2a", 2 * 138.2e6 * 0.25 / 0.75},
    {"vessel.compound", "", "q_p", 0.2},
    {"vessel.compound", "ends = \"closed\"", "q_p", 0.2},  // one tube of one material
    {"vessel.compound", "ends = \"closed\"", "states.pressure.sigma_z1", 250e6 / 15},
    {"vessel.compound", "ends = \"closed\"", "states.pressure.sigma_z2", 250e6 / 15},
    {"vessel.compound", "", "p_opt", 75e6},
    {"vessel.compound", "", "U_opt", 75e6 / 210e9 / 0.3 * 0.2},
    {"vessel.compound", "", "p_F", 0.75 * 650e6},
    {"vessel.compound", "", "d_opt", 0.2},
    {"vessel.compound", "U_min = \nU_max = \np_c = \"75 MPa\"", "U_w_max", 75e6 / 210e9 / 0.3 * 0.2},
    {"vessel.compound", "dT_1 = \"0 K\"\ndT_2 = \"20 K\"", "U_w_min", 192e-6},
    {"vessel.compound", "dT_1 = \"0 K\"\ndT_2 = \"-20 K\"", "U_w_max", 328e-6},
    {"vessel.autofrettage", "", "p_A", 850e6 * (0.255 + std::log(1.4))},
    {"vessel.autofrettage", "r_p = \nw = 0.4", "p_A", 850e6 * (0.255 + std::log(1.4))},
    {"vessel.autofrettage", "r_p = \np_A = \"502.751368 MPa\"", "r_p", 0.07},
    {"vessel.autofrettage", "r_p = \"100 mm\"", "p_A", 850e6 * std::log(2.0)},  // plastic throughout
    {"vessel.autofrettage", "hypothesis = \"mises\"", "p_y", 850e6 * 0.75 / std::sqrt(3.0)},
    {"vessel.autofrettage", "", "r_opt", 0.05 * std::exp(300.0 / 850)},
    {"vessel.autofrettage", "", "w", 0.4},
    // shells: limits of the hoop stress computed independently
    {"vessel.external", "delta = \"8 mm\"", "p_a", 0.28043116028638315e6},
    {"vessel.external", "delta = \"8 mm\"\nL = \"30 mm\"", "p_a", 1.854629074185163e6},
    {"vessel.external", "delta = \"8 mm\"\nL = \"200 mm\"", "F_he", 719.2468332698351e6},
    {"vessel.external", "delta = \"8 mm\"\nL = \"60 m\"", "p_a", 0.036681944444444455e6},
    {"vessel.external", "delta = \"8 mm\"\nL = \"1e6 m\"", "p_cr",  // an endless tube
     210e9 / 4 / 0.91 * std::pow(7.0 / 596.5, 3)},
    {"vessel.external", "delta = \"8 mm\"\nL = \"1e6 m\"", "n", 2.0},
    {"vessel.external", "delta = \"21 mm\"", "F_ic", 174033927.942618},
    {"vessel.external", "shape = \"sphere\"\nL = \ndelta = \"3 mm\"", "p_a", 0.175e6},
    {"vessel.external", "shape = \"sphere\"\nL = \ndelta = \"8 mm\"", "p_a", 1.7941109143372342e6},
    {"vessel.external", "shape = \"sphere\"\nL = \ndelta = \"21 mm\"", "p_a", 7.507279012269579e6},
    {"vessel.external",
     "shape = \"sphere\"\nL = \ndelta = \"60 mm\"\nc = \"0 mm\"\nR_e = \"215 MPa\"\nmaterial = \nE = \"210 GPa\"",
     "F_ic", 215e6},
    {"vessel.external", "shape = \"sphere\"\nL = \ndelta = \"8 mm\"", "p_cr",
     2 * 210e9 / std::sqrt(3 * 0.91) * std::pow(7.0 / 596.5, 2)},
};

// One cycle, from -40 to 120 MPa, given by any two of its numbers.
const Case cycles[] = {
    {"fatigue.cycle", "sigma_min = \nsigma_m = \"40 MPa\"", "sigma_min", -40e6},
    {"fatigue.cycle", "sigma_min = \nsigma_a = \"80 MPa\"", "sigma_min", -40e6},
    {"fatigue.cycle", "sigma_min = \nr = -0.3333333333333333", "sigma_min", -40e6},
    {"fatigue.cycle", "sigma_max = \nsigma_m = \"40 MPa\"", "sigma_max", 120e6},
    {"fatigue.cycle", "sigma_max = \nsigma_a = \"80 MPa\"", "sigma_max", 120e6},
    {"fatigue.cycle", "sigma_max = \nr = -0.3333333333333333", "sigma_max", 120e6},
    {"fatigue.cycle", "sigma_max = \nsigma_min = \nsigma_m = \"40 MPa\"\nsigma_a = \"80 MPa\"", "sigma_max", 120e6},
    {"fatigue.cycle", "sigma_max = \nsigma_min = \nsigma_m = \"40 MPa\"\nsigma_a = \"80 MPa\"", "sigma_min", -40e6},
    {"fatigue.cycle", "sigma_max = \nsigma_min = \nsigma_m = \"40 MPa\"\nr = -0.3333333333333333", "sigma_max", 120e6},
    {"fatigue.cycle", "sigma_max = \nsigma_min = \nsigma_a = \"80 MPa\"\nr = -0.3333333333333333", "sigma_max", 120e6},
    // from -80 MPa to nothing: its ratio is infinite
    {"fatigue.cycle", "sigma_max = \nsigma_min = \nsigma_m = \"-40 MPa\"\nr = inf", "sigma_min", -80e6},
    {"fatigue.cycle", "sigma_max = \nsigma_min = \nsigma_a = \"40 MPa\"\nr = inf", "sigma_min", -80e6},
};

const char* const polished_bar =
    "notch = \"smooth\"\nD = \nr = \nd = \"7.5 mm\"\nd_h = \"16 mm\"\nR_z = \"1 um\"\nM_ba = \nM_tm = \nM_ta = \n"
    "sigma_ba = \"275 MPa\"";

const char* const reversed_cycle = "sigma_max = \"100 MPa\"\nsigma_min = \"-100 MPa\"";

const Case fatigue[] = {
    {"fatigue.cycle", "sigma_max = \"100 MPa\"\nsigma_min = \"100 MPa\"", "sigma_a", 0.0},
    {"fatigue.endurance", "sigma_W = \"300 MPa\"\nK_t = 1\nr_n = \nd = \"7.5 mm\"\nR_z = \"1 um\"", "sigma_D", 300e6},
    {"fatigue.endurance", "d = \"151 mm\"", "epsilon", 0.8},  // the scale of sizes ends at 150 mm
    {"fatigue.endurance", "K_t = \nr_n = \nK_f = 2", "K_f", 2.0},
    {"fatigue.endurance", "loading = \"torsion\"\nR_z = \"1 um\"", "beta_F", 1.0},
    {"fatigue.endurance", "school = \"marin\"\nR_z = \nfinish = \"machined\"\nloading = \"tension\"", "k_b", 1.0},
    {"fatigue.endurance",  // of so weak a steel no surface is better than polished
     "school = \"marin\"\nR_z = \nfinish = \"ground\"\nR_m = \"100 MPa\"\nr_n = \nq = 1", "k_a", 1.0},
    // Neuber's constant by the polynomials of [Shigley6] at 100 and 200 kpsi, a notch of 3 mm
    {"fatigue.endurance", "R_m = \"689.4757293 MPa\"", "K_f", 1 + 0.65 / (1 + 0.0623 / std::sqrt(3 / 25.4))},
    {"fatigue.endurance", "R_m = \"1378.951459 MPa\"", "K_f", 1 + 0.65 / (1 + 0.0204 / std::sqrt(3 / 25.4))},
    {"fatigue.endurance", "loading = \"torsion\"\nR_m = \"689.4757293 MPa\"", "K_f",
     1 + 0.65 / (1 + 0.0473 / std::sqrt(3 / 25.4))},
    {"fatigue.endurance", "loading = \"torsion\"\nR_m = \"1378.951459 MPa\"", "K_f",
     1 + 0.65 / (1 + 0.0144 / std::sqrt(3 / 25.4))},
    {"fatigue.endurance", "school = \"marin\"\nR_z = \nfinish = \"ground\"\nT = \"20 degC\"\nP_s = 0.5", "k_d", 1.0},
    {"fatigue.endurance", "school = \"marin\"\nR_z = \nfinish = \"ground\"\nturning = \"standing\"", "d_e",
     0.370 * 0.032},
    {"fatigue.endurance",
     "school = \"marin\"\nR_z = \nfinish = \"forged\"\nedition = \"11th\"\nd = \nturning = \"standing\"\nh = \"20 "
     "mm\"\nb = \"20 mm\"",
     "d_e", 0.808 * 0.020},
    {"fatigue.endurance", "K_t = 1\nr_n = \ngroup = \"grey-iron\"\nrule = \"textbook\"\nsensitivity = \"cast-iron\"",
     "K_f", 1.0},
    {"fatigue.endurance", "sensitivity = \"peterson\"\nR_m = \"2070 MPa\"", "K_f", 1 + 0.65 / (1 + 0.0254 / 3)},
    {"fatigue.endurance", "sensitivity = \"peterson\"\nR_m = \"2070 MPa\"\nloading = \"torsion\"", "K_f",
     1 + 0.65 / (1 + 0.6 * 0.0254 / 3)},
    // without a mean stress every rule has the plain ratio
    {"fatigue.life", reversed_cycle, "n", 1.9},
    {"fatigue.life", "mean = \"constant\"\nsigma_max = \"100 MPa\"\nsigma_min = \"-100 MPa\"", "u_D", 1.5 / 1.9},
    {"fatigue.life", "sigma_max = \"0 MPa\"\nsigma_min = \"-200 MPa\"", "n", 1.9},  // compression has no benefit
    {"fatigue.life",
     "sigma_max = \"-1 MPa\"\nsigma_min = \"-201 MPa\"\nrule = \"fkm\"\ncompression = \"counted\"\nM = 0.2", "n",
     1.9 / 0.8},
    {"fatigue.life", "sigma_max = \"180 MPa\"\nsigma_min = \"20 MPa\"\nrule = \"fkm\"\nM = 0.3", "sigma_ar",
     1.3 * (80e6 + 0.1 * 100e6) / 1.1},
    {"fatigue.life", "sigma_max = \"180 MPa\"\nsigma_min = \"120 MPa\"\nrule = \"fkm\"\nM = 0.3", "sigma_ar",
     3 * 30e6 * 1.69 / 3.3},
    {"fatigue.life", "sigma_max = \"180 MPa\"\nsigma_min = \"180 MPa\"", "u_y", 180.0 / 490},  // it is static
    {"fatigue.life", "stress = \"shear\"\nsigma_max = \"0 MPa\"\nsigma_min = \"-200 MPa\"", "n",
     1 / (100 / 190.0 + 100 / (0.67 * 690))},
    {"fatigue.life", "stress = \"shear\"\nN = 1000\nf = 0.8", "S_e", 0.8 * 0.67 * 690e6},
    {"fatigue.life", "N = 1000\nR_m = \"450 MPa\"\nR_e = \"300 MPa\"", "S_e", 0.9 * 450e6},  // below 70 kpsi
    {"fatigue.life", "N = 1000000", "S_e", 190e6},
    {"fatigue.life", "rule = \"swt\"\nsigma_max = \"200 MPa\"\nsigma_min = \"0 MPa\"", "sigma_ar",
     200e6 / std::sqrt(2.0)},
    {"fatigue.life", "rule = \"walker\"\ngamma = 1", "sigma_ar", 100e6},
    {"fatigue.life", "rule = \"elliptic\"\nsigma_max = \"0 MPa\"\nsigma_min = \"-20 MPa\"", "n", 19.0},
    {"fatigue.life", "rule = \"modified-goodman\"\nsigma_max = \"480 MPa\"\nsigma_min = \"460 MPa\"", "n", 490 / 480.0},
    {"fatigue.life", "rule = \"morrow\"\nsigma_fB = \"800 MPa\"", "sigma_ar", 100e6 / 0.9},
    {"fatigue.life", "rule = \"serensen\"\npsi = 0.25\nK_D = 2", "sigma_ar", 110e6},
    {"fatigue.life", "rule = \"soderberg\"\nmean = \"constant\"", "sigma_adm", 190e6 * (1 - 80 / 490.0) / 1.5},
    {"fatigue.life", "group = \"grey-iron\"\nR_e = \nK_m = 1", "u_y", 180.0 / 690},
    {"fatigue.life", "line = \"basquin\"\nsigma_D = \nsigma_f = \"1000 MPa\"\nb = -0.1\nK_D = 2\nN = 50000", "S_e",
     500e6 * std::pow(1e5, -0.1)},
    {"fatigue.combined", "sigma_m = \"0 MPa\"\nsigma_a = \"0 MPa\"\ntau_m = \"0 MPa\"\ntau_a = \"11 MPa\"",
     "n_Serensen", 10.0},
    {"fatigue.combined", "sigma_m = \"0 MPa\"\nsigma_a = \"18 MPa\"\ntau_m = \"0 MPa\"\ntau_a = \"0 MPa\"", "n_Gough",
     10.0},
    {"fatigue.combined", "sigma_m = \"0 MPa\"\ntau_m = \"0 MPa\"\ntau_a = \"0 MPa\"\nrule = \"elliptic\"", "n", 3.0},
    {"fatigue.combined", "sigma_m = \"0 MPa\"\nsigma_a = \"0 MPa\"\ntau_m = \"49 MPa\"\ntau_a = \"0 MPa\"", "u_y",
     std::sqrt(3.0) / 10},
    {"fatigue.din743", "d_h = \"160 mm\"", "K_1B", 0.74},
    {"fatigue.din743", "d_h = \"300 mm\"", "K_1S", 0.57},
    {"fatigue.din743", polished_bar, "S_D", 2.0},  // of the size of the tests: 550 MPa over 275 MPa
    {"fatigue.din743", "M_ba = \"0 N*m\"\nM_ta = \"0 N*m\"", "u_D", 0.0},
    {"fatigue.din743", "sigma_zdm = \"-100 MPa\"\nsigma_zda = \"0 MPa\"\nM_tm = \"0 N*m\"", "sigma_mv", -100e6},
    {"fatigue.din743", "notch = \"cross-hole\"\nD = \nd = \"40 mm\"\nr = \"5 mm\"", "stresses.bending.alpha", 1.95},
    {"fatigue.fkm", "d_Nm = \"60 mm\"", "K_dm", 1.0},
    {"fatigue.fkm", "a_dp = 0", "K_dp", 1.0},
    {"fatigue.fkm", "fibre = \"across\"", "K_an", 0.83},  // 942 MPa
    {"fatigue.fkm", "M_ba = \"0 N*m\"\nM_ta = \"0 N*m\"", "u_D", 0.0},
    {"fatigue.fkm", "R_pmax = \"11000 MPa\"", "stresses.torsion.n_pl", 4.0 / 3},
    {"fatigue.fkm", "sigma_zdm = \"-100 MPa\"\nsigma_zda = \"0 MPa\"\nM_tm = \"0 N*m\"", "sigma_mv", -100e6},
    {"fatigue.fkm", "layer = \"hard\"", "q", 1.0},
    {"fatigue.history", "blocks = [{ sigma_a = \"120 MPa\", n = 1 }]", "Z", 1e6},  // at the knee
    {"fatigue.history", "blocks = [{ sigma_a = \"100 MPa\", sigma_m = \"50 MPa\", n = 1 }]\nmean = \"fkm\"\nM = 0.2",
     "S_1", 110e6},
    {"fatigue.history", "blocks = [{ sigma_a = \"100 MPa\", sigma_m = \"200 MPa\", n = 1 }]\nmean = \"fkm\"\nM = 0.2",
     "S_1", 1.2 * (100e6 + 0.2 / 3 * 200e6) / (1 + 0.2 / 3)},
    {"fatigue.history", "blocks = [{ sigma_a = \"100 MPa\", sigma_m = \"400 MPa\", n = 1 }]\nmean = \"fkm\"\nM = 0.2",
     "S_1", 135e6},
    {"fatigue.history", "blocks = [{ sigma_a = \"100 MPa\", sigma_m = \"-150 MPa\", n = 1 }]\nmean = \"fkm\"\nM = 0.2",
     "S_1", 80e6},
    {"fatigue.history", "blocks = [{ sigma_a = \"100 MPa\", sigma_m = \"-150 MPa\", n = 1 }]\nmean = \"swt\"", "S_1",
     100e6},
    {"fatigue.history", "blocks = [{ sigma_a = \"100 MPa\", sigma_m = \"300 MPa\", n = 1 }]\nmean = \"swt\"", "S_1",
     200e6},
    {"fatigue.history",
     "blocks = [{ sigma_a = \"100 MPa\", sigma_m = \"-150 MPa\", n = 1 }]\nmean = \"walker\"\ngamma = 0.5", "S_1",
     100e6},
    {"fatigue.history",
     "blocks = [{ sigma_a = \"100 MPa\", sigma_m = \"300 MPa\", n = 1 }]\nmean = \"walker\"\ngamma = 0.5", "S_1",
     200e6},
    {"fatigue.history", "blocks = [{ sigma_a = \"100 MPa\", sigma_m = \"345 MPa\", n = 1 }]\nmean = \"gerber\"", "S_1",
     100e6 / 0.75},
    {"fatigue.history", "blocks = [{ sigma_a = \"100 MPa\", sigma_m = \"345 MPa\", n = 1 }]\nmean = \"none\"", "S_1",
     100e6},
    {"fatigue.history",
     "R_e = \nS_F = \ncurve = \"en1993\"\nsigma_C = \"71 MPa\"\nsigma_D = \nN_D = \nk = \nmean = \"none\"\nblocks = [{ "
     "sigma_a = \"35.5 MPa\", n = 1 }]",
     "Z", 2e6},
    {"fatigue.history", "blocks = [{ sigma_a = \"119 MPa\", n = 1 }]\nminer = \"original\"", "D", 0.0},
    {"fatigue.staircase", "tests = [[\"300 MPa\", \"failure\"], [\"290 MPa\", \"runout\"]]", "S_50", 295e6},
    {"fatigue.staircase",  // failures at 110, 121, 121 and 133.1 MPa, half a step above the mean
     "steps = \"log\"\ntests = [[\"121 MPa\", \"failure\"], [\"110 MPa\", \"failure\"], [\"100 MPa\", \"runout\"], "
     "[\"110 MPa\", \"runout\"], [\"121 MPa\", \"runout\"], [\"133.1 MPa\", \"failure\"], [\"121 MPa\", \"failure\"], "
     "[\"110 MPa\", \"runout\"], [\"121 MPa\", \"runout\"]]",
     "S_50", 110e6 * std::sqrt(1.1)},
    {"fatigue.survival", "P = 0.5", "sigma_P", 288e6},
    {"fatigue.survival", "P = 0.9", "sigma_P", 288e6 / std::sqrt(1.25)},
    {"fatigue.multiaxial", "sigma_x = { values = [240, -240], unit = \"MPa\" }\ntau_xy = ", "n_F", 1.0},
    {"fatigue.multiaxial", "sigma_x = \ntau_xy = { values = [150, -150], unit = \"MPa\" }", "n_DV", 1.0},
    {"fatigue.multiaxial", "tau_D = \"138.5640646055102 MPa\"\ntau_xy = ", "n_C", 240 / 86.6},
    {"fatigue.multiaxial", "tau_D = \"210 MPa\"\nsigma_x = \ntau_xy = { values = [210, -210], unit = \"MPa\" }", "n_F",
     1.0},
    {"fatigue.wohler", "P_s = 0.5", "A_P", 29.9426882630},  // the mean line, by the normal equations
};

// gear.rating by ISO 6336, hardly turning: no dynamic load.
#define ISO_AT_REST "standard = \"iso6336\"\nnu_40 = \"134 mm^2/s\"\nn_1 = \"0.0001 rpm\"\n"

const char* const rack = "mesh = \"rack\"\nz_2 = \nsigma_adm_2 = \nbeta = \"0 deg\"\na_w = ";

// A wheel of 20 teeth of 2.5 mm, shifted by 0.3, on a rack.
const Case racks[] = {
    {"gear.bevel", "z_2 = 20", "delta_1", pi / 4},                 // alike, at right angles
    {"gear.bevel", "z_2 = 20\nSigma = \"60 deg\"", "R_e", 0.080},  // 40 mm / sin 30 deg
    {"gear.bevel", "N = 1e10\nL_h = \nT_G = \"249 degF\"", "K_T", 1},
    {"gear.bevel", "N = 500\nL_h = ", "K_L1", 2.7},
    {"gear.bevel", "service = \"general\"\nN = 1e10\nL_h = ", "K_L1", 1.3558 * std::pow(1e10, -0.0178)},
    {"gear.bevel", "b = \"12.7 mm\"", "C_s", 0.5},
    {"gear.worm", "z_1 = 10", "gamma", pi / 4},  // 10 threads of 4 mm on 40 mm
    {"gear.worm", "mu = 0.005\nz_1 = 10", "eta", (std::cos(pi / 9) - 0.005) / (std::cos(pi / 9) + 0.005)},
    {"gear.worm", "mu = 0.05\nz_1 = 10\nz_2 = 200", "C_m", 0.02 * 18 + 0.46},
    {"gear.worm", "b_2 = \"35 mm\"", "F_e", 0.0268},
    {"gear.worm", "P = \nT_2 = \"80 N*m\"", "F_t2", 1000},
    {"gear.worm", "P = \nT_1 = \"4 N*m\"", "F_t1", 200},
    {"gear.worm", "P = \nT_1 = \"4 N*m\"", "tau_f1", 16 * 1.25 * 4 / (pi * 2.7e-5)},  // 30 mm at the root
    {"gear.worm", "y = 0.125", "y", 0.125},
    {"gear.worm", "A_h = \ndT_adm = \nP_cool = \"1 kW\"", "P_K", 1000},
    {"gear.worm", "cooling = \"fan\"", "P_K", 63.05 * (1400.0 / 3939.0 + 0.13) * 0.25 * 60},
    {"gear.crossed", "mu = 0", "eta", 1},
    {"gear.crossed", "mu = 0\nbeta_1 = \"-45 deg\"\nbeta_2 = \"-45 deg\"", "eta_b", 1},
    {"gear.crossed", "beta_1 = \"-45 deg\"\nbeta_2 = \"-45 deg\"", "eta",
     (std::cos(pi / 9) - 0.06) / (std::cos(pi / 9) + 0.06)},
    {"gear.crossed", "beta_1 = \"0 deg\"", "x_b1", 0},  // a spur gear: the contact stays in its plane
    {"gear.crossed", "beta_1 = \"0 deg\"\nmu = 0", "F_a1", 0},
    {"gear.crossed", "P = \nT_2 = \"50 N*m\"", "F_t2", 50 / (0.040 * std::numbers::sqrt2)},
    {"gear.crossed", "P = \nT_1 = \"5 N*m\"", "F_t1", 5 / (0.020 * std::numbers::sqrt2)},
    {"gear.crossed", "turns = \"cw\"\nP = \nT_1 = \"5 N*m\"", "F_y1", 5 / (0.020 * std::numbers::sqrt2)},
    {"gear.crossed", "b_1 = \"30 mm\"\nb_2 = \"40 mm\"", "b_e", 0.020},
    {"gear.crossed", "beta_1 = \"75 deg\"\nbeta_2 = \"15 deg\"\nlocking = \"required\"\nmu = 0.26", "x_L",
     0.26 * std::tan(75 * pi / 180) / std::cos(pi / 9)},
    {"gear.crossed", "bore_1 = \"40 mm\"", "m_R1", (40 * std::numbers::sqrt2 - 45) / 9},
    {"gear.crossed", "bore_2 = \"90 mm\"", "m_R2", (80 * std::numbers::sqrt2 - 95) / 9},
    {"gear.sizing", "i_set = 1", "x_1", 0},  // two equal gears slide alike
    {"gear.sizing", "a_set = \"125 mm\"", "a_w", 0.125},
    {"gear.rating", "beta = \"8 deg\"", "Z_beta", std::sqrt(std::cos(8 * pi / 180))},
    {"gear.rating", "beta = \"8 deg\"\nstandard = \"iso6336\"\nnu_40 = \"134 mm^2/s\"", "Z_beta",
     1 / std::sqrt(std::cos(8 * pi / 180))},
    {"gear.rating", "standard = \"iso6336\"\nnu_40 = \"134 mm^2/s\"", "Z_L", 0.91 + 0.36 / (2.2 * 2.2)},
    {"gear.rating", "standard = \"iso6336\"\nnu_40 = \"134 mm^2/s\"", "Z_NT1", 0.85},
    // Half of the time at half of the torque: the mean with the exponent of the chart, ln(3e6/1e3)/ln(2.5).
    {"gear.rating",
     "standard = \"iso6336\"\nnu_40 = \"134 mm^2/s\"\nL_h = \"9000 h\"\nblocks = [{ q = 0.5 }, { q = 0.5, k = 0.5 }]",
     "K_AF", std::pow(0.5 * (1 + std::pow(0.5, 8.7378026309)), 1 / 8.7378026309)},
    {"gear.rating", "standard = \"iso6336\"\nnu_40 = \"134 mm^2/s\"\ns_R2 = \"20 mm\"", "Y_B2", 1},
    {"gear.rating", "standard = \"iso6336\"\nnu_40 = \"134 mm^2/s\"\nshortening = \"none\"\ns_R1 = \"6 mm\"", "Y_B1",
     1.6 * std::log(2.242 * 1.5)},
    // Far from the middle, on a shaft that the pinion stiffens: 0.48 instead of 0.8; overhung it makes no difference.
    {"gear.rating",
     "place = \"a\"\nl = \"200 mm\"\ns = \"50 mm\"\nd_sh = \"60 mm\"\nstiffening = \"pinion\"\nT_1 = \"1.4592 "
     "N*m\"\nn_1 "
     "= \"0.001 rpm\"",
     "f_sh", 1e-6 * 0.023 * 48 * 48 / (76 * 76) * (1 + 0.48 * 200 * 50 / (76 * 76) * std::pow(76.0 / 60, 4))},
    {"gear.rating", "z_2 = 104\nx_1 = 0.5\nrho_fP = 0.39\nh_fP = 1.4\nshortening = \"none\"\ns_pr = 0.02", "Y_Fa1",
     2.355210454},  // the fillet drawn as the envelope of the tool
    {"gear.rating", ISO_AT_REST, "K_V", 1},
    {"gear.rating", ISO_AT_REST "root_edition = \"2019\"", "f_eps", 1},
    {"gear.rating", ISO_AT_REST "root_edition = \"2019\"\nbeta = \"8 deg\"", "Y_beta",
     (1 - 48 * std::sin(8 * pi / 180) / (4 * pi) * 8 / 120) / std::pow(std::cos(8 * pi / 180), 3)},
    // Deviations of grade 6: 11 um of the pitch and of the helix of the wheel, 0.075 of the base pitch runs in.
    {"gear.rating", ISO_AT_REST, "f_pbeff", 0.925 * 11e-6 * std::cos(pi / 9)},
    {"gear.rating", ISO_AT_REST "grade = 5\nC_a = \"0 um\"", "B_k", 1},
    {"gear.rating", ISO_AT_REST "f_ma = \"96 um\"\nT_1 = \"0.000001 N*m\"", "F_betax", 96e-6},
    {"gear.rating", ISO_AT_REST "f_ma = \"96 um\"\nT_1 = \"0.000001 N*m\"\ncrowning = \"crowned\"", "F_betax", 48e-6},
    {"gear.rating", ISO_AT_REST "f_ma = \"0 um\"\nT_1 = \"0.000001 N*m\"", "F_betax", 5.5e-6},
    {"gear.rating", ISO_AT_REST "pattern = \"favourable\"\nT_1 = \"0.000001 N*m\"", "F_betax", 8e-6},
    {"gear.rating", ISO_AT_REST "f_ma = \"0 um\"\nb = \"1 mm\"", "F_betax", 0.005e-6 * 2 * 400e3 * 1.25 / 76},
    {"gear.rating",
     ISO_AT_REST
     "place = \"a\"\nl = \"200 mm\"\ns = \"50 mm\"\nd_sh = \"60 mm\"\nstiffening = \"pinion\"\nT_1 = \"1.4592 N*m\"",
     "f_sh", 1e-6 * 0.023 * 48 * 48 / (76 * 76) * (1 + 0.48 * 200 * 50 / (76 * 76) * std::pow(76.0 / 60, 4))},
    // Shafts that do not deflect leave the manufacturing deviations.
    {"gear.rating", "place = \nf_sh_1 = \"0 um\"\nf_ma = \"20 um\"", "F_betax", 20e-6},
    {"gear.rating", ISO_AT_REST "place = \nf_sh_1 = \"0 um\"\nf_ma = \"96 um\"", "F_betax", 96e-6},
    {"gear.rating", "f_ma = \"0 um\"\nb = \"1 um\"\nT_1 = \"1 N*m\"", "K_Hbeta", 1},
    // Far from the middle, and a torque that enters there, but no load: nothing bends.
    {"gear.rating",
     "place = \"a\"\nl = \"200 mm\"\ns = \"50 mm\"\nd_sh = \"60 mm\"\nf_ma = \"20 um\"\nT_1 = \"0.000001 N*m\"",
     "F_betax", 20e-6},
    // 1 N/mm on 76 mm and 48 mm, so slow that K_V is 1, out of line by 96 um, of which 6 um run in.
    {"gear.rating", "T_1 = \"1.4592 N*m\"\nn_1 = \"0.001 rpm\"\nf_ma = \"96 um\"", "K_Hbeta",
     std::sqrt(40 * (90 + 1.33 * 0.023 * 48 * 48 / (76 * 76)))},
    {"gear.rating", "h_aP = 0.67\nT_1 = \"1 N*m\"", "K_Halpha", 1.2},
    {"gear.rating", "h_aP = 0.67\nT_1 = \"1 N*m\"", "K_Falpha", 1.2},
    {"gear.rating", "h_aP = 0.7\nbeta = \"8 deg\"\nT_1 = \"1 N*m\"", "K_Halpha", 1.4},
    {"gear.rating", "h_aP = 0.7\nbeta = \"8 deg\"\nT_1 = \"1 N*m\"", "K_Falpha", 1.4},
    {"gear.cycloidal", "pinion = \"leaves\"\nd_p = \nz_1 = 40\nz_2 = 200", "phi_e", 0.0},  // many leaves need no lead
    {"gear.cycloidal", "pinion = \"leaves\"\nd_p = \nz_1 = 10\nz_2 = 30", "a", 0.04},
    {"gear.pair", rack, "a_w", 25e-3 + 0.3 * 2.5e-3},
    {"gear.pair", "mesh = \"rack\"\nz_2 = \nsigma_adm_2 = \nbeta = \"0 deg\"\na_w = \"25.75 mm\"", "x_0", 0.3},
    {"gear.pair", rack, "alpha_wt", pi / 9},
    {"gear.pair", rack, "d_w1", 50e-3},
    {"gear.pair", rack, "d_a1", 2 * (25e-3 + 1.3 * 2.5e-3)},
    {"gear.pair", rack, "d_f1", 2 * (25e-3 - 0.95 * 2.5e-3)},
    {"gear.pair", rack, "c_1", 0.25 * 2.5e-3},  // clearance of the basic rack
    {"gear.pair", rack, "c_2", 0.25 * 2.5e-3},
    {"gear.pair", rack, "g_f", 0.7 * 2.5e-3 / std::sin(pi / 9)},
    {"gear.pair", rack, "q_a", 56.5 / (50 * std::cos(pi / 9))},
    {"gear.pair", rack, "s_an2", 2.5e-3 * (pi / 2 - 2 * std::tan(pi / 9))},
};

// Willis on a set of 24, 30 and 84 teeth, whose basic ratio is -3.5: sun, carrier and ring at -600, 100 and 300 rad/s.
const Case sets[] = {
    {"gear.planetary", "z_r = ", "z_r", 84.0},  // sun, planets and ring come to one axis
    {"gear.planetary", "fixed = \"none\"\nn_s = \nn_c = \"100 rad/s\"\nn_r = \"300 rad/s\"", "n_s", -600.0},
    {"gear.planetary", "fixed = \"none\"\nn_s = \"-600 rad/s\"\nn_r = \"300 rad/s\"", "n_c", 100.0},
    {"gear.planetary", "fixed = \"none\"\nn_s = \"-600 rad/s\"\nn_c = \"100 rad/s\"", "n_r", 300.0},
    {"gear.planetary", "fixed = \"none\"\nn_s = \"-600 rad/s\"\nn_c = \"100 rad/s\"", "n_pc", 560.0},
    {"gear.planetary", "fixed = \"none\"\nn_s = \"-600 rad/s\"\nn_c = \"100 rad/s\"", "n_p", 660.0},
    {"gear.planetary", "", "i", 4.5},
    {"gear.planetary", "eta_0 = 1", "P_in", 50 * 1450 * pi / 30},
    {"gear.planetary", "eta_0 = 1", "P_w", 50 * 1450 * pi / 30 * 3.5 / 4.5},
    {"gear.planetary", "T_s = \"-50 N*m\"\neta_0 = 1", "P_in", 50 * 1450 * pi / 30},  // the carrier drives
    {"gear.planetary", "fixed = \"sun\"\nn_s = \nn_c = \"100 rad/s\"\neta_0 = 1", "P_in", 22500.0},  // the ring drives
    {"gear.planetary", "fixed = \"sun\"\nn_s = \nn_c = \"100 rad/s\"\neta_0 = 1", "P_loss", 0.0},
    {"gear.planetary", "fixed = \"sun\"\nn_s = \nn_c = \"100 rad/s\"\neta_0 = 1", "i", 9.0 / 7},
    {"gear.planetary", "", "q", 36.0},
    {"gear.planetary", "x_p = 0.5", "u_N", 33 / (54 * std::sin(pi / 3))},
    {"gear.planetary", "", "phi_2", 2 * pi / 3},
    {"gear.planetary", "", "u_N", 32 / (54 * std::sin(pi / 3))},
};

// Speeds at which the velocity factors of [Shigley14] are 2, or the root of it, on a pitch circle of 50 mm.
const Case velocities[] = {
    {"gear.pair", "beta = \"0 deg\"\na_w = \nx_1 = 0\ncutting = \"cast\"\nn_1 = \"122 rad/s\"", "K_v", 2.0},
    {"gear.pair", "beta = \"0 deg\"\na_w = \nx_1 = 0\ncutting = \"milled\"\nn_1 = \"244 rad/s\"", "K_v", 2.0},
    {"gear.pair", "beta = \"0 deg\"\na_w = \nx_1 = 0\ncutting = \"hobbed\"\nn_1 = \"506.944 rad/s\"", "K_v", 2.0},
    {"gear.pair", "beta = \"0 deg\"\na_w = \nx_1 = 0\ncutting = \"ground\"\nn_1 = \"1236.544 rad/s\"", "K_v",
     std::numbers::sqrt2},
};

const Case drives[] = {
    {"gear.pair", "beta = \"0 deg\"\na_w = \nx_1 = 0", "a_w", 0.5 * 77 * 0.0025},
    {"gear.pair", "beta = \"0 deg\"\na_w = \"96.25 mm\"\nx_1 = 0\nx_2 = 0\nA_s1 = \"-0.1 mm\"\nA_s2 = \"-0.05 mm\"",
     "j_bn", 0.15e-3 * std::cos(pi / 9)},
    {"gear.pair", "beta = \"0 deg\"\na_w = \nx_1 = 0", "F_a", 0.0},
    // root circles of 43.75 and 136.25 mm, teeth of 5.625 mm
    {"gear.pair", "beta = \"0 deg\"\na_w = \nx_1 = 0\nbore_1 = \"20 mm\"\nt_k1 = \"2.5 mm\"", "s_R1", 9.375e-3},
    {"gear.pair", "beta = \"0 deg\"\na_w = \nx_1 = 0\nbore_1 = \"20 mm\"\nt_k1 = \"2.5 mm\"", "m_R1", 5.0 / 3},
    {"gear.pair", "beta = \"0 deg\"\na_w = \nx_1 = 0\nbore_2 = \"100 mm\"\nt_k2 = \"3 mm\"", "s_R2", 15.125e-3},
    {"gear.pair", "beta = \"0 deg\"\na_w = \nx_1 = 0\nbore_2 = \"100 mm\"\nt_k2 = \"3 mm\"", "m_R2", 15.125 / 5.625},
    // gear 1 turns back: its speed and its torque without their signs
    {"gear.pair", "n_1 = \"-1450 rpm\"", "v", 1450 * pi / 30 * 2.0 / 77},
    {"gear.pair", "beta = \"0 deg\"\na_w = \nx_1 = 0\nn_1 = \"-1450 rpm\"\nT_1 = \"-60 N*m\"", "F_t", 2400.0},
    {"gear.pair", "beta = \"0 deg\"\na_w = \nx_1 = 0\nT_1 = \nP = \"10 kW\"\nn_1 = \"-1000 rad/s\"", "F_t", 400.0},
    {"gear.planetary", "fixed = \"carrier\"", "n_r", -1450 * pi / 30 * 24 / 84},
    {"gear.planetary", "eta_0 = 1", "P_loss", 0.0},
    {"gear.planetary", "T_s = \nT_c = \"-225 N*m\"\neta_0 = 1", "T_s", 50.0},  // 1 + 84/24 = 4.5
    {"gear.planetary", "m_n = \"2 mm\"\nbeta = \"45 deg\"\nK_gamma = 1.2", "F_t",
     1.2 * 50 / (3 * 24e-3 * std::numbers::sqrt2)},
    {"chain.roller", "z_1 = 19\nz_2 = 19\na = \"1270 mm\"", "X_0", 2.0 * 1270 / 25.4 + 19},
    {"chain.roller", "z_1 = 19\nz_2 = 19", "alpha_1", pi},
    {"drive.train", R"(stages = [{ kind = "gear", z_1 = 20, z_2 = 20, eta = 1 }])", "P_loss", 0.0},
    {"drive.train", R"(stages = [{ kind = "worm", z_1 = 2, z_2 = 40, eta = 0.72 }])", "stages[1].x_eta",
     0.8},  // usual up to 0.9
    {"chain.inverted_tooth", "z_1 = 25\nz_2 = 25\na = \"508 mm\"", "X_0", 80 + 25},
    {"chain.inverted_tooth", "a = \nX = 131", "b_min", 0.042 * 1.25},  // a hunting link
    {"chain.inverted_tooth", "P_b = \"10 kW\"\nb_R = \"25.4 mm\"", "b_min", 2.1 * 0.0254},
    {"chain.roller", "z_1 = 20\nz_2 = 20\na = \"1270 mm\"\ntheta = \"0 deg\"", "f_s", 1.27 / 48},  // about 2 %
    {"chain.roller", "z_1 = 38", "f_2", std::pow(0.5, 1.08)},
    {"drive.friction_wheels", "shape = \"bevel\"\nd_2 = \"200 mm\"", "delta_2", pi / 4},  // alike, at right angles
    {"drive.friction_wheels", "shape = \"bevel\"\nSigma = \"60 deg\"\nd_2 = \"200 mm\"", "delta_1", pi / 6},
    {"drive.friction_wheels",  // flanks of 30 deg curve half as much as cylinders
     "shape = \"grooved\"\nalpha = \"30 deg\"\nc_r = 0\nF_p = \"2 kN\"\nd_1 = \"2.5 m\"\nd_2 = \"2.5 m\"\nb = \"1 m\"\n"
     "E_1 = \"100 GPa\"\nE_2 = \"100 GPa\"\nnu_1 = 0\nnu_2 = 0",
     "p_H", std::sqrt(2000 * 0.8 * 50e9 / pi)},
    {"drive.friction_wheels",  // cones of 45 deg curve less than cylinders, by its cosine
     "shape = \"bevel\"\nF_p = \"2 kN\"\nd_1 = \"2 m\"\nd_2 = \"2 m\"\nb = \"1 m\"\nE_1 = \"100 GPa\"\n"
     "E_2 = \"100 GPa\"\nnu_1 = 0\nnu_2 = 0",
     "p_H", std::sqrt(2000 * std::numbers::sqrt2 * std::numbers::sqrt2 * 50e9 / pi)},
    {"drive.friction_wheels", "P = \nT_1 = \"100 N*m\"\nK_A = 1\npair = \nmu = 0.5\nS_min = 2", "F_p", 4000.0},
    {"drive.friction_wheels", "shape = \"grooved\"\nalpha = \"30 deg\"\nc_r = 0\nF_p = \"2 kN\"", "F_n",
     4000.0},                                            // a wedge without friction
    {"belt.course", R"(n_1 = "12.5 rad/s")", "v", 1.0},  // with a radius of 80 mm
    {"belt.flat", "b = \"100 mm\"\nd_1 = \"300 mm\"\nd_2 = \"300 mm\"", "L", 2.4 + 0.3 * pi},
    {"belt.flat", "b = \"100 mm\"\nd_1 = \"300 mm\"\nd_2 = \"300 mm\"\narrangement = \"crossed\"", "gamma",
     0.2526802551420786},  // arcsin 0.25
    {"belt.flat", "b = \"100 mm\"\nd_1 = \"300 mm\"\nd_2 = \"300 mm\"\na = \"1500 mm\"\narrangement = \"quarter_turn\"",
     "beta_1", 2 * std::atan(0.1)},
    {"belt.flat", "b = \"100 mm\"\nd_2 = \"200 mm\"\nS_0 = \"900 N\"", "R_0", 1800.0},
    {"belt.flat",  // both spans at 300 mm from the pivot, but for the radius of 100 mm
     "b = \"100 mm\"\nd_2 = \"200 mm\"\ntensioning = \"pivoted_base\"\nm_m = \"400 kg\"\na_G = \"300 mm\"\n"
     "h_P = \"300 mm\"",
     "S_0", 400 * 9.81 / 2},
    {"belt.flat",
     "b = \"100 mm\"\nd_2 = \"200 mm\"\ntensioning = \"pivoted_base\"\nm_m = \"400 kg\"\na_G = \"300 mm\"\n"
     "h_P = \"-300 mm\"",
     "k_S", -1.0 / 3},
    {"belt.flat", "b = \"100 mm\"\nd_2 = \ni_set = 2", "i_w", 2.0},
    {"belt.flat", "b = \"100 mm\"\nd_2 = \nn_1 = \"1000 rpm\"\nn_2_set = \"500 rpm\"", "i_w", 2.0},
    {"belt.flat", "b = \"100 mm\"\nE_b = \"80 MPa\"", "sigma_b", 80e6 * 2.5 / 200},  // strain of the outer fibre
    {"belt.grooved", "phi = ", "mu_w", 0.4},
    {"belt.grooved", "P = \nT_1 = \"2 N*m\"", "F_t", 60.0},
    {"belt.grooved",
     "kind = \"ribbed\"\nphi = \nd_b = \nrho = \nsigma_adm = \nE_b = \nq = \"0.02 kg/m\"\nP_R = \"0.1 kW\"\np_r = "
     "\"3.56 mm\"",
     "b", 2 * 3.56e-3},  // 180 W
    {"belt.grooved", "d_2 = \"80 mm\"", "alpha_1", pi},
    {"belt.grooved", "sigma_adm = \nS_adm = \"100 N\"", "S_b", 15e6 * 6 / 80 * pi / 4 * 36e-6},
    {"belt.grooved", "", "g_x", 0.3 - 0.12 - 0.006},
    {"belt.grooved", "d_b = \nrho = \nsigma_adm = \nE_b = \nq = \"0.03 kg/m\"\nS_adm = \"100 N\"", "g_x", 0.18},
    {"belt.grooved",
     "d_b = \nrho = \nsigma_adm = \nE_b = \nphi = \nd_min = \nribbed_belt = \"PK\"\nP_R = \"0.1 kW\"\nz = 10", "x_b",
     35.6 / 80},
    {"belt.grooved", "d_b = \nrho = \nsigma_adm = \nE_b = \nphi = \nd_min = \nribbed_belt = \"PK\"\nP_R = \"0.1 kW\"",
     "g_x", 0.3 - 0.12 - 0.00356},
    {"belt.synchronous", "z_2 = 20", "z_0", 1000 / 12.7 + 20},
    {"belt.synchronous", "z_2 = 20", "z_m", 10.0},
    {"belt.synchronous", "P = \nT_1 = \"100 N*m\"\nn_1 = \"10 rad/s\"", "P_B", 1500.0},
    {"belt.synchronous", "b = \"76.2 mm\"", "k_w", 1.0},
    {"belt.synchronous", "a = \nz_B = 110\nz_2 = 20", "a", 0.0127 * 45},
    {"belt.synchronous", "a = \nz_B = 110\nz_2 = 20", "g_f", 0.0127 * (45 - 20 / pi - 0.5)},
    {"belt.synchronous", "b = \"38.2 mm\"", "x_w", 0.5},
    {"belt.v", "d_1 = \"200 mm\"\nd_2 = \"200 mm\"\nL = \nepsilon = 0\na = \"800 mm\"", "i", 1.0},
    {"belt.v",  // the mean life of GOST 1284.2, annex 3, under a medium load
     "basis = \"iso\"\nsection = \"B\"\nbelt_class = \"IV\"\nmotor = \nh_day = \nK_A = 1\nP = \"7.5 kW\"\nd_1 = \"140 "
     "mm\"\n"
     "d_2 = \"140 mm\"\nL = \"1800 mm\"",
     "L_h", 3700.0 * 3600},
    {"belt.v_sizing", "n_2_set = \"1460 rpm\"\nepsilon = 0", "dev_n", 0.0},
};

const char* const twisted = "x = \"1 m/s*t + 1 m/s^2*t^2\"\ny = \"1 m/s^2*t^2\"\nz = \"1 m/s^3*t^3\"\nt = \"1 s\"";
// 2 kg at (1, 2) m/s under (10, -20) N for 2 s
const char* const blow =
    "m = \"2 kg\"\nF_x = \"10 N\"\nF_y = \"-20 N\"\nt_1 = \"1 s\"\nt_2 = \"3 s\"\nv_1x = \"1 m/s\"\nv_1y = \"2 m/s\"";

const Case motion[] = {
    {"motion.point", "x = \"3 m/s*t\"\ny = \"4 m/s*t\"", "kappa", 0.0},
    // from 0 to 2 s the vertex of a parabola, and points exactly on it
    {"motion.point", "x = \"3 m/s*t\"\ny = \"4 m/s*t - 2 m/s^2*t^2\"", "y_max", 2.0},
    {"motion.point", "x = \"3 m/s*t\"\ny = \"4 m/s*t - 2 m/s^2*t^2\"", "x_min", 0.0},
    {"motion.point", "x = \"2 m/s*t\"\ny = \"1 m/s^2*t^2\"", "e_path", 0.0},
    // a screw line of 3 m radius that rises by 4 m per radian: 20 m/s, 3/25 of its square
    {"motion.along_path", "x = \"3 m*cos(q)\"\ny = \"3 m*sin(q)\"\nz = \"4 m*q\"\nS = \"-10 m/s^2*t^2\"\nt = \"1 s\"",
     "a_n", 48.0},
    {"motion.along_path", "x = \"3 m*q\"\ny = \"4 m*q\"\nS = \"10 m\"\n", "x_M", 6.0},
    {"motion.along_path", "x = \"3 m*q\"\ny = \"4 m*q\"\nS = \"10 m\"\n", "a", 0.0},
    {"motion.point", "x = \"2 m/s*t\"\ny = \"-3 m/s*t\"\nz = \"6 m/s*t\"", "cos_z", 6.0 / 7},
    // a screw line of 2 m radius, turned through by 3 rad/s
    {"motion.point", "x = \"2 m*cos(3*t/(1 s))\"\ny = \"2 m*sin(3*t/(1 s))\"\nz = \"1.5 m/s*t\"\nt = \"0.4 s\"", "a_n",
     18.0},
    {"motion.point", "x = \"2 m*cos(3*t/(1 s))\"\ny = \"2 m*sin(3*t/(1 s))\"\nz = \"1.5 m/s*t\"\nt = \"0.4 s\"",
     "kappa", 18 / (36 + 1.5 * 1.5)},
    {"motion.rotation", "phi = \"90 deg*(t/(1 s))^2\"\nt_1 = \"1 s\"\nt_2 = \"3 s\"", "turns", 2.0},
    {"motion.rotation", "phi = \"90 deg*(t/(1 s))^2\"\nt_1 = \"1 s\"\nt_2 = \"3 s\"", "omega_m", 2 * pi},
    // (t + t^2, t^2, t^3) at 1: v = (3, 2, 3), a = (2, 2, 6), v x a = (6, -12, 2)
    {"motion.point", twisted, "a", std::sqrt(44.0)},
    {"motion.point", twisted, "a_tau", 28 / std::sqrt(22.0)},
    {"motion.point", twisted, "a_n", std::sqrt(184.0 / 22)},
    {"motion.rotation", R"(phi = "1 rad/s*t")", "a_tau", 0.0},
    {"motion.plane", "v_A = \"1 m/s\"\nalpha_A = \"0 deg\"\nalpha_B = \"0 deg\"", "omega", 0.0},
    {"motion.plane", "", "omega", 0.2},  // a ladder of 3, 4 and 5 m whose foot slides away
    {"motion.plane", "", "x_P", 3.0},
    {"motion.plane", "", "y_P", 4.0},
    {"motion.plane", "a_A = \"0 m/s^2\"\nalpha_aA = \"-90 deg\"\nalpha_aB = \"0 deg\"", "a_B", -1.0 / 3},
    {"motion.plane", "a_A = \"0 m/s^2\"\nalpha_aA = \"-90 deg\"\nalpha_aB = \"0 deg\"", "epsilon",
     -(1.0 / 3 - 0.12) / 4},
    {"motion.plane", "a_A = \"0.5 m/s^2\"\nalpha_aA = \"-90 deg\"\nalpha_aB = \"0 deg\"", "a_B", 1.0 / 3},
    {"motion.plane", "a_A = \"0.5 m/s^2\"\nalpha_aA = \"-90 deg\"\nalpha_aB = \"0 deg\"", "epsilon",
     (1.0 / 3 + 0.12) / 4},
    {"motion.compound", "omega = \"0 rad/s\"\nepsilon = \"0 rad/s^2\"", "a", 3.0},
    {"motion.spatial", "theta = ", "a", 0.0},
    {"motion.spatial", "theta = \"90 deg\"", "a", 12.0 * 0.3 * 0.3},
    {"motion.universal_joint", "beta = \"0 deg\"", "U", 0.0},
    {"motion.universal_joint", "beta = \"30 deg\"\nbeta_2 = \"30 deg\"\nphi_1 = \"50 deg\"", "i", 1.0},
    {"motion.universal_joint", "beta = \"60 deg\"", "U", 1.5},
    // three arcs of 90 deg: a universal joint at 60 deg
    {"motion.spherical_four_bar", universal, "i_max", 2.0},
    {"motion.spherical_four_bar", universal, "i_min", 0.5},
    {"motion.spherical_four_bar", universal, "M_1max", 20.0},
    {"motion.spherical_four_bar", universal, "mu_min", pi / 6},
    // on shafts at right angles coupler and output of 90 deg swing by the arc of the input to either side
    {"motion.spherical_four_bar", "alpha_2 = \"90 deg\"\nalpha_3 = \"90 deg\"\nalpha_4 = \"90 deg\"", "theta_4",
     pi / 3},
    {"motion.spherical_four_bar", "alpha_2 = \"90 deg\"\nalpha_3 = \"90 deg\"\nalpha_4 = \"90 deg\"", "Q", 1.0},
    {"dynamics.force", "x = \"3 m/s*t\"\ny = \"4 m/s*t\"", "P", 0.0},
    // a fall that has reached its terminal velocity
    {"dynamics.motion",
     "m = \"2 kg\"\nv_x0 = \"0 m/s\"\nv_y0 = \"0 m/s\"\nF_x = \"50 N - 2 N*s^2/m^2*v_x*v\"\nF_y = \nuntil = ", "v_E",
     5.0},
    {"dynamics.throw", "theta = \"90 deg\"", "H", 400 / (2 * g)},
    {"dynamics.throw", "", "theta_L", pi / 6},  // it lands as steep as it was thrown
    // thrown level from as high as its speed would bring it up: it lands at 45 degrees
    {"dynamics.throw", "theta = \"0 deg\"\nh = \"20.387359836901 m\"", "theta_L", pi / 4},
    {"dynamics.throw", "theta = \"0 deg\"\nh = \"20.387359836901 m\"", "V_L", 20 * std::numbers::sqrt2},
    {"dynamics.throw", "theta = \"0 deg\"\nh = \"20.387359836901 m\"", "L", 400 / g},
    // as high as the landing is deep, and as far as a throw at 45 degrees gets on level ground
    {"dynamics.throw", "h = \"20.387359836901 m\"\nL_req = \"40.774719673802 m\"", "L_max",
     400 / g* std::numbers::sqrt2},
    {"dynamics.throw", "h = \"20.387359836901 m\"\nL_req = \"40.774719673802 m\"", "theta_R",
     std::atan(std::sqrt(0.5))},
    {"dynamics.throw", "h = \"20.387359836901 m\"\nL_req = \"40.774719673802 m\"", "theta_flat", 0.0},
    {"dynamics.throw", "h = \"20.387359836901 m\"\nL_req = \"40.774719673802 m\"", "theta_steep", std::atan(2.0)},
    {"dynamics.throw", "", "V_L", 20.0},
    {"dynamics.throw", "latitude = \"0 deg\"", "g", 9.7803253359},
    {"dynamics.lift", "latitude = \"0 deg\"\naltitude = \"0 m\"", "g", 9.7803253359},
    {"dynamics.impulse", blow, "F_mx", 10.0},
    {"dynamics.impulse", blow, "F_my", -20.0},
    {"dynamics.impulse", blow, "F_m", std::sqrt(500.0)},
    {"dynamics.impulse", blow, "q_2y", -36.0},
    {"dynamics.impulse", blow, "v_2", std::hypot(11.0, 18.0)},
    {"dynamics.impulse", blow, "A", 10.0 * 12 + 20 * 16},  // forces by their paths
    {"dynamics.impulse", "F_x = \"0 N\"", "v_2x", -1.0},
    {"dynamics.impulse", "F_x = \"0 N\"\nF_z = \"30 N\"\nv_1z = \"4 m/s\"", "v_2z", 4.2},
    {"dynamics.momentum", R"(bodies = [{ m = "5 kg", v_1 = "4 m/s", v_2 = "4 m/s" }, { m = "1 kg", v_1 = "4 m/s" }])",
     "Delta_E", 0.0},
    {"dynamics.momentum", "bodies = [{ m = \"2 kg\", v_1 = \"3 m/s\" }, { m = \"1 kg\" }]\ne = 0.5", "Delta_E", -2.25},
    {"dynamics.momentum", "bodies = [{ m = \"2 kg\", v_1 = \"3 m/s\" }]\nS = \"4 N*s\"", "V_k", 5.0},
    {"dynamics.mass_centre", R"(bodies = [{ m = "1 kg" }, { m = "1 kg", s = "2 m" }])", "Delta_x", -1.0},
    // a rod of 12 kg and 1 m hinged at its end, a point mass, a thin shell
    {"dynamics.inertia", R"(parts = [{ shape = "rod", m = "12 kg", h = "1 m", beta = "90 deg", x = "0.5 m" }])", "J",
     4.0},
    {"dynamics.inertia", R"(parts = [{ shape = "rod", m = "12 kg", h = "1 m", beta = "90 deg", x = "0.5 m" }])", "J_S",
     1.0},
    {"dynamics.inertia", R"(parts = [{ shape = "point", m = "2 kg", x = "3 m", y = "4 m" }])", "i", 5.0},
    {"dynamics.inertia", R"(parts = [{ shape = "sphere", m = "3 kg", D = "2 m", d_i = "2 m" }])", "J", 2.0},
    // a cone of 2400 pi kg, about a diameter of the base: m (3 R^2 + 2 h^2)/20
    {"dynamics.inertia", R"(parts = [{ shape = "cone", D = "2 m", h = "1 m", beta = "90 deg", x = "0.25 m" }])", "J",
     600 * pi},
    {"dynamics.angular_momentum", R"(parts = [{ m = "1 kg", R_1 = "1 m", omega_1 = "3 rad/s" }])", "omega_2", 3.0},
    {"dynamics.angular_momentum",
     "parts = [{ m = \"1 kg\", R_1 = \"1 m\", omega_1 = \"3 rad/s\" }]\nM = \"2 N*m\"\nt = \"4 s\"", "omega_2", 11.0},
    {"dynamics.angular_momentum",
     "parts = [{ m = \"1 kg\", R_1 = \"1 m\", omega_1 = \"3 rad/s\", omega_2 = \"11 rad/s\" }]\nM = \"2 N*m\"", "t_M",
     4.0},
    {"dynamics.angular_momentum",  // two like parts, one of them slowed down
     "parts = [{ m = \"1 kg\", R_1 = \"1 m\", omega_1 = \"3 rad/s\" }, "
     "{ m = \"1 kg\", R_1 = \"1 m\", omega_1 = \"3 rad/s\", omega_2 = \"1 rad/s\" }]",
     "omega_2", 5.0},
    // 2 m along: 20 J of the force, -10 J of friction, 5 J of a spring that relaxes
    {"dynamics.work", "alpha = \"0 deg\"\nmu = 0.5\nF = \"10 N\"\ng = \"10 m/s^2\"", "A", 10.0},
    {"dynamics.work",
     "alpha = \"0 deg\"\nmu = 0.5\nF = \"10 N\"\ng = \"10 m/s^2\"\nc = \"1 N/mm\"\nz_1 = \"100 mm\"\nz_2 = \"0 mm\"",
     "A", 15.0},
    {"dynamics.work", "mu = 0\nalpha = \"-90 deg\"\nv_1 = \"3 m/s\"", "v_2", std::sqrt(9 + 4 * g)},
    {"dynamics.work", "mu = 0\nalpha = \"-90 deg\"\nv_1 = \"3 m/s\"", "t", (std::sqrt(9 + 4 * g) - 3) / g},
    {"dynamics.work", "mu = 0\nalpha = \"-90 deg\"\nv_1 = \"3 m/s\"", "E_1", 4.5},
    {"dynamics.work", "mu = 0\nalpha = \"-90 deg\"", "v_2", std::sqrt(2 * g * 2)},
    // a circle: no work of a central force or on a way back, and that of a constant force along it
    {"dynamics.path_work", "z = \nt_2 = \"6.283185307179586 s\"", "A", 0.0},
    {"dynamics.path_work", "z = \nF_z = \nF_x = \"5 N*v_x/v\"\nF_y = \"5 N*v_y/v\"\nt_2 = \"2 s\"", "A", 10.0},
    {"dynamics.path_work", "z = \nF_z = \nF_x = \"5 N*v_x/v\"\nF_y = \"5 N*v_y/v\"\nt_2 = \"2 s\"", "F_m", 5.0},
    {"dynamics.lift", "weights = [{ m = \"1 kg\" }]\nwheels = ", "a", g},
    {"dynamics.lift",  // on a slope less steep than its angle of friction a body stays
     "weights = [{ m = \"8 kg\", alpha = \"30 deg\", mu = 0.6 }]\nwheels = ", "F", 0.0},
    {"machine.flywheel", "M_of_phi = \"20 kN*m + 10 kN*m*sin(phi)\"\nJ_0 = \"100 kg*m^2\"", "J_add",
     20e3 / (0.01 * 36 * pi * pi) - 100},
    {"machine.flywheel", "D = \"2 m\"", "v_rim", 6 * pi},
    {"machine.flywheel", "", "n_max", 6 * pi * 1.005},
    {"machine.flywheel", "", "n_min", 6 * pi * 0.995},
    {"machine.flywheel", R"(M_of_phi = "20 kN*m")", "J_F", 0.0},
    // 7850 kg/m^3 at 200 pi rad/s
    {"machine.disc", R"(d_i = "0 mm")", "sigma_ti", 7850 * std::pow(200 * pi, 2) * 3.3 / 8 * 0.0625},
    {"machine.disc", R"(d_i = "0.001 mm")", "sigma_ti", 7850 * std::pow(200 * pi, 2) * 3.3 / 4 * 0.0625},
    {"machine.disc", R"(d_i = "499.9999 mm")", "sigma_ti", 7850 * std::pow(200 * pi * 0.25, 2)},
    {"machine.disc", "d_i = \"0 mm\"\nr = \"250 mm\"", "sigma_tr", 7850 * std::pow(200 * pi * 0.25, 2) * 1.4 / 8},
    {"machine.disc", "d_i = \"0 mm\"\nr = \"125 mm\"", "sigma_rr",
     7850 * std::pow(200 * pi * 0.25, 2) * 3.3 / 8 * 0.75},
    {"machine.disc", "r = \"111.80339887498948 mm\"", "sigma_rr", 7850 * std::pow(200 * pi * 0.2, 2) * 3.3 / 8},
    {"machine.disc", "r = \"250 mm\"", "sigma_tr", 7850 * std::pow(200 * pi, 2) * (0.0625 * 1.4 + 0.0025 * 6.6) / 8},
    {"machine.disc", R"(form = "cylinder")", "sigma_zm", 7850 * std::pow(200 * pi, 2) * 0.3 / 2.8 * 0.06},
    {"machine.disc", "", "m", 7850 * 0.04 * pi * 0.06},
    {"machine.disc", "", "J_z", 7850 * 0.04 * pi * 0.06 * (0.0625 + 0.0025) / 2},
    {"machine.disc", "", "v_a", 50 * pi},
    // a straight motor of 120 N m and 100 rpm at the crank carries a constant load of 60 N m at half of its speed
    {"machine.motion",
     "points = \nJ_of_phi = \nM_K = \ns_K = \nM_A = \"10 N*m\"\nn_0 = \"1200 rpm\"\neta = 1\nM = \"60 N*m\"", "n_m",
     50 * pi / 30},
    {"machine.motion",
     "points = \nJ_of_phi = \nM_K = \ns_K = \nM_A = \"10 N*m\"\nn_0 = \"1200 rpm\"\neta = 1\nM = \"60 N*m\"", "P_L",
     60 * 50 * pi / 30},
    {"machine.run_up",
     "parts = [{ J = \"1 kg*m^2\" }]\nmotor = [[\"0 rpm\", \"10 N*m\"], [\"1400 rpm\", \"10 N*m\"]]\nload = ", "t",
     1400 * pi / 30 / 10},
};

const Case bearings[] = {
    {"bearing.rolling", "f_0 = \nF_a = \nF_r = \"29.1 kN\"", "L_10", 1.0},  // that is what C is
    {"bearing.rolling", "f_0 = \nF_a = \nF_r = \"29.1 kN\"\nn = \"100 rpm\"", "L_10h", 6e5},
    {"bearing.rolling", "f_0 = \nF_a = \nF_r = \"29.1 kN\"\nn = \"100 rpm\"\nR = 0.95", "L_nh",
     6e5 * (0.05 + 0.95 * std::pow(std::log(1 / 0.95) / std::log(1 / 0.9), 2.0 / 3))},
    {"bearing.rolling", "f_0 = \nF_a = \nblocks = [{ q = 0.25 }, { q = 0.75 }]", "P_m", 2500.0},
    {"bearing.rolling", "f_0 = \nF_a = \nblocks = [{ q = 0.5 }, { q = 0.5, n = \"0 rpm\" }]", "n_m", 15 * pi},
    {"bearing.rolling", "kind = \"thrust_roller\"\nf_0 = \nF_r = \"0 N\"", "P_0", 1000.0},
    // without radial load on the mate, and with the external force away from it, the bearing has its own induced force
    {"bearing.rolling",
     "kind = \"tapered_roller\"\nf_0 = \ne = 0.37\nY = 1.6\nY_0 = 0.9\nF_a = \"-9 kN\"\ncarries = \"right\"\n"
     "mate = { F_r = \"0 N\", Y = 1.6 }",
     "F_ax", 0.5 * 2500.0 / 1.6},
    // two alike under the same radial load and no other share it
    {"bearing.rolling",
     "kind = \"tapered_roller\"\nf_0 = \ne = 0.37\nY = 1.6\nY_0 = 0.9\nF_a = \"0 N\"\ncarries = \"left\"\n"
     "mate = { F_r = \"2.5 kN\", Y = 1.6 }",
     "F_ax", 0.5 * 2500.0 / 1.6},
};

const Case keys[] = {
    {"shaft.key", "form = \"B\"\nl = \"56 mm\"", "p_2", 22.5e3 / (3.5e-3 * 56e-3)},
    {"shaft.key", "T = \"0 N*m\"", "F_t", 0.0},
    {"shaft.key", "T_max = \"-1 kN*m\"", "F_t", 40e3},
    {"shaft.key", "d = \"50 mm\"", "x_d", 1.0},
    {"shaft.spline", "T = \"0 N*m\"", "p", 0.0},
    {"shaft.spline", "phi = 1\nl = \"100 mm\"\nK_A = 1", "p", 640.0 / 0.028 / (8 * 4e-3 * 0.1)},
    {"shaft.set_screw", "T = \"0 N*m\"\nF_a = \"-500 N\"", "F", 500.0},
    {"shaft.set_screw", "F_a = \"600 N\"", "F", 1000.0},  // 3 4 5
    {"shaft.circlip", "c = \"0 mm\"", "F_ring", 17e3},
    {"shaft.circlip", "c = \"0.01 mm\"", "F_ring", 17e3},  // never more than against a sharp edge
};

const char* const solid =  // of one material: p = U E (1 - (d/D)^2)/(2 d)
    "Rz_1 = \"0 um\"\nRz_2 = \"0 um\"\nd_i = \"0 mm\"\nD = \"120 mm\"\nU_min = \"60 um\"";

const char* const turning =  // at 1000 rad/s
    "Rz_1 = \"0 um\"\nRz_2 = \"0 um\"\nd_i = \"0 mm\"\nD = \"120 mm\"\nU_min = \"60 um\"\nn = \"1000 rad/s\"";

const Case fits[] = {
    {"shaft.press_fit", solid, "p_min", 60e-6 * 210e9 * 0.75 / (2 * 60e-3)},
    {"shaft.press_fit", turning, "p_min",  // less rho omega^2 (3 + nu)(D^2 - d^2)/32
     60e-6 * 210e9 * 0.75 / (2 * 60e-3) - 7840.0 * 1e6 * 3.3 * (0.0144 - 0.0036) / 32.0},
    {"shaft.press_fit", "n = \"0 rpm\"", "u_n", 0.0},
    {"shaft.press_fit", "dT_1 = \"80 K\"\ndT_2 = \"80 K\"", "U_T", 0.0},
    {"shaft.press_fit", "U_max = \"41 um\"\nd_i = \"0 mm\"\nD = \"120 m\"\nRz_1 = \"0 um\"\nRz_2 = \"0 um\"", "sigma_2",
     41e-6 * 210e9 / 60e-3},  // a hub without an end
    {"shaft.press_fit", R"(T = "0 N*m")", "F_res", 0.0},
};

// 2 m of 2 m in diameter: I_p = pi/2 m^4
const char* const spread =
    "end_2 = \"held\"\nc_2 = \nsleeves = \ntorques = \nG = \"1 GPa\"\nsegments = [{ l = \"2 m\", d = \"2 m\", m = \"1 "
    "kN*m/m\" }]";
const char* const unloaded =
    "torques = [{ x = \"0 mm\", T = \"0 N*m\" }]\nsegments = [{ l = \"900 mm\", d = \"60 mm\" }]";
const char* const ring =  // mean radius 1 m, thickness 1 mm
    "T = \"1 N*m\"\ncells = [{ name = \"a\", A = \"3.141592653589793 m^2\" }]\nwalls = [{ cell = \"a\", l = "
    "\"6.283185307179586 m\", t = \"1 mm\" }]";

const Case twists[] = {
    {"shaft.held", spread, "R_1", -1000.0},
    {"shaft.held", spread, "phi_max", 1e3 / (pi / 2 * 1e9) * 4 / 8},
    {"shaft.held", spread, "theta_max", 1e3 / (pi / 2 * 1e9)},
    // from 2 m to 1 m in diameter over 1 m: the integral of (u - 1)/u^4 from 1 to 2 is 1/12
    {"shaft.held",
     "end_2 = \"free\"\nc_2 = \nsleeves = \ntorques = \nG = \"1 GPa\"\nsegments = [{ l = \"1 m\", d = \"2 m\", d_2 = "
     "\"1 m\", m = \"1 kN*m/m\" }]",
     "phi_2", 1e3 * 32 / (pi * 1e9) / 12},
    {"shaft.held", unloaded, "R_1", 0.0},
    {"shaft.held", unloaded, "phi_max", 0.0},
    {"shaft.held", "end_1 = \"free\"", "R_2", -960.0},
    {"shaft.held",
     "behaviour = \"brittle\"\nsleeves = \nend_2 = \"free\"\nc_2 = \nsegments = [{ l = \"2 m\", d = \"2 m\" }]",
     "u_tau", 900.0 / (pi / 2) / 90e6},
    {"section.solid_torsion", "T = \"0 N*m\"", "tau_max", 0.0},
    {"section.solid_torsion", "T = \"0 N*m\"", "theta", 0.0},
    {"section.thin_walled", ring, "I_B", 2 * pi * 1e-3},
    {"section.thin_walled", ring, "I_s", 2 * pi * 1e-9 / 3},
    {"section.thin_walled", "T = \"0 N*m\"", "tau_max", 0.0},
    {"section.thin_walled", "cells = \nwalls = [{ l = \"3 m\", t = \"1 mm\" }]", "W_t", 1e-6},
    {"section.thin_walled", "cells = \nwalls = [{ l = \"3 m\", t = \"1 mm\" }]", "r_I", 1.0},
};

const Case pins[] = {
    {"pin.joint", R"(F = "0 N")", "sigma_v", 0.0},
    {"pin.joint", "", "M_b", 145.0},                            // integrated load by load
    {"pin.joint", R"(spread = "falling")", "M_b", 120.833333},  // the same
    {"pin.joint", R"(d_i = "15 mm")", "tau", 31.9095837e6},     // first moment of half the ring, integrated
    {"pin.joint", R"(held = "one_side")", "p_2", 370.5240885e6},
    {"pin.lug", R"(F = "0 N")", "sigma_n", 0.0},
    {"pin.lug", "", "x_a", 1.0},
    {"pin.en1993", R"(F = "0 kN")", "a_1", 34e-3},  // two thirds of the bore
    {"pin.en1993", "", "u_vm", 0.3742405222},
    {"pin.en1993", "replaceable = \"yes\"\ngamma_M6 = 1\nd_0 = \"50 mm\"", "sigma_h1", 0.0},
    {"pin.en1993", "replaceable = \"yes\"\ngamma_M6 = 1", "sigma_h1", 383.0117753e6},
    {"pin.cross", R"(T = "0 N*m")", "tau", 0.0},
    {"pin.cross", "", "p_2", 32.0 / (8e-3 * 16e-3 * 48e-3)},
    {"link.member", R"(M_b = "0 N*m")", "sigma_M", 0.0},
    {"link.member", "M_b = \"0 N*m\"\nl = \"4 m\"\nlambda_max = 1000", "u_p",  // Euler, hinged
     3.0 * 18e3 * 12 * 16 / (pi * pi * 210e9 * 0.02 * 0.04 * 0.04 * 0.04)},
    {"link.member", R"(N = "18 kN")", "u_p", 0.0},
    // a plate on edge that would tilt long before it yields
    {"link.member", "N = \"0 kN\"\nh = \"200 mm\"\nb = \"5 mm\"\nl = \"2 m\"\nends_z = \"pinned_pinned\"", "M_cr",
     845.6537815669302},
    {"link.member", R"(A_v = "200 mm^2")", "tau", 2e6},
    // a tube by V Q/(I b) at its neutral axis
    {"link.member", "h = \nb = \nd = \"60 mm\"\nd_bore = \"40 mm\"", "tau",
     400.0 * (216e-6 - 64e-6) / 12 / (pi / 64 * (1296e-8 - 256e-8) * 0.02)},
};

const std::span<const Case> groups[] = {pins,   twists,  fits,  keys, shapes,     bars,   tubes,  vessels,
                                        cycles, fatigue, racks, sets, velocities, drives, motion, bearings};

bool is(double value, double expected) {
  return std::abs(value - expected) <= (expected == 0.0 ? 1e-9 : 2e-6 * std::abs(expected));
}

}  // namespace

std::vector<Run> loadpath::test::runs_of_limit_cases() {
  std::vector<Run> runs;
  for (const auto& group : groups) {
    for (const Case& row : group) runs.push_back({row.calculator, row.lines});
  }
  return runs;
}

TEST_SUITE("limit cases" * by_element) {
  TEST_CASE("results that are known without the calculator") {
    for (const auto& group : groups) {
      for (const Case& row : group) {
        if (!takes_id(row.calculator)) continue;
        const std::string what = std::string(row.calculator) + "." + row.result + " with " + row.lines;
        INFO(what);
        const ExampleStep step(row.calculator, row.lines);
        CHECK_MESSAGE(step.fault().empty(), step.fault());
        if (!step.fault().empty()) continue;
        const double si = step(row.result);  // a message may not fail itself
        CHECK_MESSAGE(is(si, row.si), "it is ", si, ", and the row says ", row.si);
      }
    }
  }

  TEST_CASE("every plain calculator has a limit case") {
    std::set<std::string_view> tried;
    for (const auto& group : groups) {
      for (const Case& row : group) tried.insert(row.calculator);
    }
    for (const Calculator* c : calculators()) {
      if (c->evaluate == nullptr) continue;
      CHECK_MESSAGE(
          tried.count(c->id) == 1, std::string(c->id),
          " has no limit case: add a row {calculator, lines, result, SI value} to tests/calculators/limit_cases.cpp");
    }
  }
}
