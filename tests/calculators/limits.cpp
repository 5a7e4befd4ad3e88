// Both sides of every validity limit and of every check: a value next to the bound that passes, and one that does not.
#include "tests/calculators/rows.hpp"
#include "tests/calculators/step_text.hpp"
#include "tests/parts.hpp"

#include <set>
#include <span>

namespace {

using namespace loadpath;
using namespace loadpath::test;
using account::State;

constexpr State over = State::fail, outside = State::not_covered;

struct Side {
  const char* calculator;
  const char* field;
  State state;        // beyond the bound
  const char* key;    // changed input
  const char* keeps;  // its value on the side that passes
  const char* leaves;
  const char* lines = "";  // changes of the calculator's example before
};

/// belt.flat with the motor on a pivoted base.
#define PIVOTED_BELT \
  "b = \"100 mm\"\ntensioning = \"pivoted_base\"\nm_m = \"400 kg\"\na_G = \"300 mm\"\nh_P = \"300 mm\""

const Side vessels[] = {
    {"vessel.cylinder", "t_R", outside, "delta", R"("60 mm")", R"("60.1 mm")", "measured = \"mean\"\nc = \"0 mm\""},
    {"vessel.cylinder", "t_M", outside, "delta", R"("30 mm")", R"("30.1 mm")",
     "measured = \"mean\"\nc = \"0 mm\"\nhypothesis = \"membrane\""},
    {"vessel.cylinder", "u_v", over, "sigma_adm", R"("165 MPa")", R"("164 MPa")", R"(delta = "8 mm")"},
    {"vessel.cylinder", "w_r", outside, "l_r", R"("127 mm")", R"("128 mm")",
     "ends = \"ringed\"\nA_r = \"600 mm^2\"\ndelta = \"12 mm\""},
    {"vessel.cylinder", "u_e", over, "delta_e", R"("73.1 mm")", R"("73 mm")", R"(delta = "10 mm")"},
    {"vessel.sphere", "t_R", outside, "delta", R"("500 mm")", R"("501 mm")", "measured = \"mean\"\nc = \"0 mm\""},
    {"vessel.sphere", "t_M", outside, "delta", R"("250 mm")", R"("251 mm")",
     "measured = \"mean\"\nc = \"0 mm\"\nhypothesis = \"membrane\""},
    {"vessel.sphere", "u_v", over, "sigma_adm", R"("125 MPa")", R"("124 MPa")", R"(delta = "20 mm")"},
    {"vessel.cone", "t_R", outside, "delta", R"("69.2 mm")", R"("69.3 mm")"},
    {"vessel.cone", "u_v", over, "sigma_adm", R"("18 MPa")", R"("17 MPa")", R"(delta = "8 mm")"},
    {"vessel.cone", "x_s", outside, "delta", R"("64.9 mm")", R"("65 mm")", R"(measured = "mean")"},
    {"vessel.torus", "t_R", outside, "delta", R"("10 mm")", R"("10.1 mm")"},
    {"vessel.torus", "u_v", over, "sigma_adm", R"("73 MPa")", R"("72 MPa")", R"(delta = "8 mm")"},
    {"vessel.ellipsoid", "t_R", outside, "delta", R"("7.5 mm")", R"("7.6 mm")", R"(measured = "mean")"},
    {"vessel.ellipsoid", "u_v", over, "sigma_adm", R"("67 MPa")", R"("66 MPa")", R"(delta = "8 mm")"},
    {"vessel.ellipsoid", "w_b", outside, "delta", R"("2.4 mm")", R"("2.39 mm")", R"(measured = "mean")"},
    {"vessel.ellipsoid", "x_s", outside, "delta", R"("18.7 mm")", R"("18.8 mm")", R"(measured = "mean")"},
    {"vessel.end", "u_s", over, "sigma_adm", R"("92 MPa")", R"("91 MPa")", R"(delta = "12 mm")"},
    {"vessel.end", "u_y", over, "sigma_adm", R"("160 MPa")", R"("159 MPa")", R"(delta = "12 mm")"},
    {"vessel.end", "u_b", over, "delta", R"("11 mm")", R"("10 mm")"},
    {"vessel.end", "u_f", over, "sigma_adm", R"("91 MPa")", R"("90 MPa")", R"(delta = "12 mm")"},
    {"vessel.end", "x_r", outside, "r", R"("118 mm")", R"("117.9 mm")",
     "delta = \"20 mm\"\nform = \"torispherical\"\nR = \"1900 mm\""},
    {"vessel.end", "x_k", outside, "delta", R"("60.4 mm")", R"("60.6 mm")",
     "form = \"torispherical\"\nR = \"1900 mm\"\nr = \"118 mm\""},
    {"vessel.end", "x_e", outside, "delta", R"("3 mm")", R"("2.9 mm")"},
    {"vessel.end", "x_R", outside, "R", R"("2004 mm")", R"("2005 mm")",
     "delta = \"12 mm\"\nform = \"torispherical\"\nr = \"200 mm\""},
    {"vessel.end", "x_K", outside, "h_i", R"("450 mm")", R"("449 mm")", "delta = \"12 mm\"\nform = \"ellipsoidal\""},
    {"vessel.end", "u_tr", over, "p_t", R"("1.431 MPa")", R"("1.429 MPa")", "delta = \"14 mm\"\nh_t = \"0 mm\""},
    {"vessel.end", "u_t", over, "R_e_t", R"("216 MPa")", R"("215 MPa")",
     R"(delta = "12 mm")"
     "\np_t = \"1.43 MPa\"\nh_t = \"0 mm\""},
    {"vessel.cylinder", "u_tr", over, "p_t", R"("2.29 MPa")", R"("2.28 MPa")",
     "delta = \"10 mm\"\nR_e_t = \"235 MPa\"\nh_t = \"0 mm\""},
    // 10 mm on a mean radius of 605 mm, 2.3 MPa inside: 2.3 (60.5/0.85 + 1) = 166.01 MPa, against R_e_t/1.05
    {"vessel.cylinder", "u_t", over, "R_e_t", R"("174.4 MPa")", R"("174.2 MPa")",
     "delta = \"10 mm\"\np_t = \"2.3 MPa\"\nh_t = \"0 mm\""},
    // C = 0.33, 600 mm and 1 mm of corrosion, f = 117.14 MPa
    {"vessel.flat_end", "u_e", over, "delta", R"("33 mm")", R"("32.9 mm")"},
    {"vessel.flat_end", "x_e", outside, "delta", R"("7.1 mm")", R"("7 mm")"},
    {"vessel.flat_end", "u_t", over, "R_e_t", R"("165.6 MPa")", R"("165.4 MPa")",
     "delta = \"33 mm\"\np_t = \"1.445 MPa\"\nh_t = \"0 mm\""},
    {"vessel.flat_end", "u_tr", over, "p_t", R"("1.431 MPa")", R"("1.429 MPa")", "delta = \"35 mm\"\nh_t = \"0 mm\""},
    // radii of 80 and 120 mm under 40 MPa: 144 MPa by Tresca, over 355 MPa / S
    {"vessel.thick", "u_v", over, "S", "2.465", "2.466", R"(delta = "40 mm")"},
    {"vessel.thick_sphere", "u_v", over, "S", "3.7", "3.701", "delta = \"50 mm\"\np = \"45 MPa\""},
    // 125.6 MPa at the contact of the loose fit, 138.2 MPa of the tight one
    {"vessel.compound", "u_1", over, "R_e_1", R"("498 MPa")", R"("497 MPa")"},
    {"vessel.compound", "u_2", over, "R_e_2", R"("553 MPa")", R"("552 MPa")"},
    {"vessel.compound", "u_U", over, "dT_2", R"("99 K")", R"("101 K")", R"(dT_1 = "0 K")"},
    // 850 MPa (1/2 (1 - 0.49) + ln 1.4) = 502.75 MPa
    {"vessel.autofrettage", "u_p", over, "S", "1.675", "1.676"},
    {"vessel.autofrettage", "u_B", over, "f_B", "0.578", "0.577"},
    {"vessel.autofrettage", "x_k", outside, "R_a", R"("250 mm")", R"("251 mm")"},
    // 5 mm of steel, computed independently: 0.11975 MPa
    {"vessel.external", "u_e", over, "p_e", R"("0.1197 MPa")", R"("0.1198 MPa")", R"(delta = "6 mm")"},
    {"vessel.external", "x_D", outside, "delta", R"("1.61 mm")", R"("1.59 mm")"},
    {"vessel.shell", "t_R", outside, "delta", R"("49.9 mm")", R"("50 mm")"},
    {"vessel.shell", "u_v", over, "sigma_adm", R"("39 MPa")", R"("38 MPa")", R"(delta = "8 mm")"},
    {"vessel.shell", "x_s", outside, "delta", R"("31.2 mm")", R"("31.3 mm")", R"(measured = "mean")"},
    {"vessel.shell", "psi_max", outside, "points",  // turned by 14.9 and by 15.1 degrees
     R"([["0.5 m", "0 m"], ["0.5 m", "1 m"], ["0.75713 m", "1.96638 m"]])",
     R"([["0.5 m", "0 m"], ["0.5 m", "1 m"], ["0.76050 m", "1.96547 m"]])"},
    {"vessel.shell", "s_min", outside, "points",  // a cone that rises by 2.1 % and by 1.9 %
     R"([["0.1 m", "0 m"], ["0.6 m", "0.0105 m"], ["1.1 m", "0.0210 m"]])",
     R"([["0.1 m", "0 m"], ["0.6 m", "0.0095 m"], ["1.1 m", "0.0190 m"]])", "p = \"0.001 MPa\"\ndelta = \"0.5 mm\""},
    {"vessel.shell", "w_kappa", outside, "points",  // a barrel next to a cylinder: radii of 2.6 m and of 2.4 m
     R"([["1.000000 m", "0.000000 m"], ["1.000000 m", "0.100000 m"], ["1.000000 m", "0.200000 m"], ["0.998077 m", "0.299975 m"], ["0.992311 m", "0.399803 m"], ["0.982712 m", "0.499335 m"]])",
     R"([["1.000000 m", "0.000000 m"], ["1.000000 m", "0.100000 m"], ["1.000000 m", "0.200000 m"], ["0.997917 m", "0.299971 m"], ["0.991671 m", "0.399769 m"], ["0.981274 m", "0.499219 m"]])"},
    {"vessel.shell", "w_b", outside, "delta", R"("2.1 mm")", R"("1.9 mm")",  // crown of 1 m, knuckle of 0.1 m
     R"(points = [["0.000000 m", "0.000000 m"], ["0.114884 m", "0.006621 m"], ["0.228247 m", "0.026397 m"], ["0.338588 m", "0.059065 m"], ["0.444444 m", "0.104194 m"], ["0.460167 m", "0.113900 m"], ["0.473836 m", "0.126334 m"], ["0.484984 m", "0.141070 m"], ["0.493230 m", "0.157605 m"], ["0.498293 m", "0.175376 m"], ["0.500000 m", "0.193774 m"]])"},
};

const Side sections[] = {
    {"section.I", "w_t", outside, "t_w", R"("15 mm")", R"("16 mm")"},
    {"section.I", "w_r", outside, "r", R"("30 mm")", R"("30.1 mm")"},
    {"section.channel", "w", outside, "t_f", R"("20 mm")", R"("20.1 mm")"},
    {"section.angle", "w", outside, "t", R"("20 mm")", R"("20.1 mm")"},
    {"section.T", "w", outside, "t_f", R"("25 mm")", R"("25.1 mm")"},
    {"section.hollow", "w", outside, "t", R"("20 mm")", R"("20.1 mm")"},
};

const char* const channel_column =
    "d = \nsection = \"UPN 200\"\nl = \"6 m\"\nends = \nends_y = \"pinned_pinned\"\nbeta_z = 0.3\nmethod = "
    "\"ec3\"\nsigma_P = "
    "\nn_st = \nR_e = \"235 MPa\"\ngamma_M1 = 1\ngamma_F = 1";
const char* const lone_section = "families = [\"HEA\"]\nh_max = \"100 mm\"";

const Side bars[] = {
    {"shaft.torsion", "u_tau", over, "tau_adm", R"("40.1 MPa")", R"("40 MPa")", R"(d = "70 mm")"},
    {"shaft.torsion", "u_theta", over, "theta_adm", R"("0.0144 rad/m")", R"("0.0143 rad/m")", R"(d = "70 mm")"},
    {"shaft.torsion", "F_bend", outside, "F", R"("0 N")", R"("1 N")", R"(d = "70 mm")"},
    {"shaft.overhung", "u_v", over, "sigma_adm", R"("44 MPa")", R"("43 MPa")", R"(d = "40 mm")"},
    {"shaft.overhung", "u_Q", over, "sigma_adm", R"("159 MPa")", R"("158 MPa")", R"(d = "20 mm")"},
    {"shaft.design", "u_y", over, "v_adm", R"("0.0089 mm")", R"("0.00889 mm")"},
    {"shaft.design", "u_theta", over, "theta_adm", R"("0.445 deg/m")", R"("0.444 deg/m")"},
    {"shaft.design", "x_E", outside, "E", R"("179 GPa")", R"("178 GPa")",
     "material = \nG = \"81 GPa\"\nrho = \"7850 kg/m^3\"\nR_e = \"370 MPa\"\nR_m = \"630 MPa\""},
    {"shaft.design", "s_max", outside, "pieces",
     R"([{ l = "100 mm", d = "80 mm" }, { l = "100 mm", d = "80 mm", d_2 = "44.9 mm" }])",
     R"([{ l = "100 mm", d = "80 mm" }, { l = "100 mm", d = "80 mm", d_2 = "44.7 mm" }])",
     "notches = \nsupports = [{ x = \"15 mm\", holds = \"both\" }, { x = \"200 mm\" }]"},
    {"shaft.design", "u_n", over, "n", R"("76800 rpm")", R"("77000 rpm")"},  // n_F/1.25
    {"shaft.overhung", "u_tau", over, "tau_adm", R"("8.8 MPa")", R"("8.7 MPa")", R"(d = "40 mm")"},
    {"column.buckling", "u", over, "P", R"("42 kN")", R"("43 kN")"},
    {"column.buckling", "r_lambda", over, "lambda_max", "160", "159"},
    {"column.buckling", "r_1", outside, "l", R"("493 mm")", R"("492 mm")"},
    {"column.buckling", "r_0", outside, "l", R"("338 mm")", R"("337 mm")",
     "R_e = \nsigma_P = \nmethod = \"tetmajer\"\na_T = \"310 MPa\"\nb_T = \"1.14 MPa\"\nlambda_0 = 60"},
    {"column.buckling", "r_class", outside, "R_e", R"("338 MPa")", R"("339 MPa")",
     "d = \nsigma_P = \nsection = \"IPE 300\"\nkind = \"rolled_I\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1"},
    {"column.buckling", "x_t", over, "N", R"("540 kN")", R"("541 kN")", "P = "},
    {"column.buckling", "u_t", over, "N", R"("270 kN")", R"("271 kN")", "P = \nn_t = 2"},
    {"column.buckling", "u_e", over, "P", R"("32.7 kN")", R"("32.8 kN")", "method = \"secant\"\ne_y = \"5 mm\""},
    {"column.buckling", "x_E", outside, "E", R"("179 GPa")", R"("178 GPa")", "d = \nsection = \"HEB 200\""},
    {"column.buckling", "r_class", outside, "d_bore", R"("37.27 mm")", R"("37.28 mm")",  // 90 x 235/240/3 = 29.375
     "d = \"40 mm\"\nE = \"70 GPa\"\nR_e = \"240 MPa\"\nsigma_P = \"160 MPa\"\nP = \"1 kN\"\nmaterial_class = "
     "\"other\""},
    {"column.beam_column", "u", over, "P", R"("1167 kN")", R"("1168 kN")"},
    {"column.beam_column", "u_s", over, "M_z", R"("60.5 kN*m")", R"("60.6 kN*m")", R"(P = "10 kN")"},
    {"column.beam_column", "u_y", over, "M_y_1", R"("148 kN*m")", R"("149 kN*m")", "M_z = "},
    {"column.beam_column", "u_z", over, "M_z", R"("7.0 kN*m")", R"("7.1 kN*m")"},
    {"column.beam_column", "u_LT", over, "M_y_1", R"("143 kN*m")", R"("144 kN*m")"},
    {"column.beam_column", "u_T", over, "P", R"("1539 kN")", R"("1540 kN")"},
    {"column.beam_column", "u_H", over, "M_z", R"("1.6 kN*m")", R"("1.7 kN*m")",
     "method = \"aisc\"\ngamma_M1 = \ngamma_F = \nP = \"300 kN\""},
    {"column.beam_column", "r_lambda", over, "l", R"("10.12 m")", R"("10.13 m")"},
    {"column.beam_column", "r_class", outside, "R_e", R"("1725 MPa")", R"("1726 MPa")"},
    {"column.beam_column", "x_V", outside, "M_y_2", R"("-43 kN*m")", R"("-44 kN*m")", R"(l = "1 m")"},
    {"column.lightest", "u", over, "P", R"("106 kN")", R"("107 kN")", lone_section},
    {"column.lightest", "x_t", over, "N", R"("499 kN")", R"("500 kN")",
     "families = [\"HEA\"]\nh_max = \"100 mm\"\nP = "},
    {"column.lightest", "u_t", over, "N", R"("249 kN")", R"("250 kN")",
     "families = [\"HEA\"]\nh_max = \"100 mm\"\nP = \nn_t = 2"},
    {"column.lightest", "u_e", over, "P", R"("68 kN")", R"("69 kN")",
     "families = [\"HEA\"]\nh_max = \"100 mm\"\nmethod = \"secant\"\ne_y = \"5 mm\"\nn_st = 2\ngamma_M1 = \ngamma_F "
     "= "},
    {"column.lightest", "x_E", outside, "E", R"("179 GPa")", R"("178 GPa")",
     "families = [\"HEA\"]\nh_max = \"100 mm\"\nP = \"1 kN\"\nmethod = \"johnson\"\nR_e = \"235 MPa\"\nn_st = "
     "2\nmaterial = "
     "\ngamma_M1 = \ngamma_F = "},
    {"column.lightest", "carrying", over, "P", R"("106 kN")", R"("107 kN")", lone_section},
    {"column.lightest", "r_lambda", over, "l", R"("5.01 m")", R"("5.02 m")",
     "families = [\"HEA\"]\nh_max = \"100 mm\"\nP = \"1 kN\""},
    {"column.lightest", "r_1", outside, "l", R"("2.56 m")", R"("2.55 m")",
     "families = [\"HEA\"]\nh_max = \"100 mm\"\nP = \"1 kN\"\nmethod = \"euler\"\nsigma_P = \"200 MPa\"\nn_st = 2\n"
     "gamma_M1 = \ngamma_F = "},
    {"column.lightest", "r_0", outside, "l", R"("1.51 m")", R"("1.5 m")",
     "families = [\"HEA\"]\nh_max = \"100 mm\"\nP = \"1 kN\"\nmethod = \"tetmajer\"\na_T = \"310 MPa\"\nb_T = \"1.14 "
     "MPa\"\n"
     "lambda_0 = 60\nE = \"210 GPa\"\nmaterial = \nn_st = 2\ngamma_M1 = \ngamma_F = "},
    {"column.lightest", "r_class", outside, "R_e", R"("2339 MPa")", R"("2340 MPa")",
     "families = [\"HEA\"]\nh_max = \"100 mm\"\nP = \"1 kN\"\nE = \"210 GPa\"\nmaterial = "},
    {"column.buckling", "u_TF", over, "P", R"("425 kN")", R"("426 kN")", channel_column},
    {"column.lightest", "u_TF", over, "P", R"("223 kN")", R"("224 kN")",
     "families = [\"UPE\"]\nh_max = \"100 mm\"\nl = \"1 m\""},
    {"column.stepped", "u", over, "n_st", "6.65", "6.66"},
    {"column.stepped", "r_P", outside, "sigma_P", R"("56 MPa")", R"("55 MPa")", "R_e = "},
    {"column.effective_length", "u", State::not_available, "c_1", R"("0.1 N*m/rad")", R"("0.001 N*m/rad")",
     R"(k_1 = "0 N/mm")"},
};

const Side fatigue[] = {
    {"fatigue.cycle", "u_y", over, "R_e", R"("120 MPa")", R"("119 MPa")"},
    {"fatigue.cycle", "u_F", over, "R_e", R"("180 MPa")", R"("179 MPa")", "S_F = 1.5"},
    {"fatigue.cycle", "x_N", outside, "N", "1e7", "1.01e7", "rho = \"2700 kg/m^3\"\nN_D = 1e7"},
    {"fatigue.cycle", "u_D", over, "sigma_D", R"("120 MPa")", R"("119 MPa")", "S_D = 1.5"},
    {"fatigue.cycle", "x_m", outside, "sigma_min", R"("-120 MPa")", R"("-119 MPa")",
     "sigma_D = \"200 MPa\"\nS_D = 1.5"},
    {"fatigue.endurance", "x_d", outside, "d", R"("8 mm")", R"("7 mm")"},
    {"fatigue.endurance", "x_d", outside, "d", R"("2.8 mm")", R"("2.7 mm")",
     "school = \"marin\"\nR_z = \nfinish = \"ground\""},
    {"fatigue.endurance", "x_d", outside, "d", R"("254 mm")", R"("255 mm")",
     "school = \"marin\"\nR_z = \nfinish = \"ground\""},
    {"fatigue.endurance", "x_n", outside, "R_m", R"("341 MPa")", R"("339 MPa")"},
    {"fatigue.endurance", "x_n", outside, "R_m", R"("1699 MPa")", R"("1701 MPa")"},
    {"fatigue.endurance", "x_n", outside, "R_m", R"("561 MPa")", R"("559 MPa")", "sensitivity = \"peterson\""},
    {"fatigue.endurance", "x_r", outside, "r_n", R"("0.1 mm")", R"("0.099 mm")"},
    {"fatigue.endurance", "x_Rz", outside, "R_z", R"("199 um")", R"("201 um")"},
    {"fatigue.endurance", "x_E", outside, "E", R"("179 GPa")", R"("178 GPa")"},
    {"fatigue.life", "x_E", outside, "E", R"("179 GPa")", R"("178 GPa")"},
    {"fatigue.combined", "x_E", outside, "E", R"("179 GPa")", R"("178 GPa")"},
    {"pin.joint", "x_E", outside, "E", R"("179 GPa")", R"("178 GPa")"},
    {"pin.cross", "x_E", outside, "E", R"("179 GPa")", R"("178 GPa")"},
    {"fatigue.endurance", "x_T", outside, "T", R"("20 degC")", R"("19 degC")",
     "school = \"marin\"\nR_z = \nfinish = \"ground\""},
    {"fatigue.endurance", "x_T", outside, "T", R"("1000 degF")", R"("1001 degF")",
     "school = \"marin\"\nR_z = \nfinish = \"ground\""},
    {"fatigue.life", "u_y", over, "R_e", R"("180 MPa")", R"("179 MPa")"},
    {"fatigue.life", "u_F", over, "R_e", R"("270 MPa")", R"("269 MPa")"},
    {"fatigue.life", "u_D", over, "S_D", "1.55", "1.56"},
    {"fatigue.life", "x_m", over, "sigma_min", R"("618 MPa")", R"("622 MPa")", R"(sigma_max = "760 MPa")"},
    {"fatigue.life", "x_B", over, "sigma_max", R"("690 MPa")", R"("691 MPa")"},
    {"fatigue.life", "x_B", over, "sigma_max", R"("462.3 MPa")", R"("462.4 MPa")", R"(stress = "shear")"},
    {"fatigue.life", "x_N", outside, "N", "1000", "999"},
    {"fatigue.life", "x_D", outside, "N", "100000000", "101000000", R"(group = "wrought-aluminium")"},
    {"fatigue.life", "x_f", outside, "R_m", R"("1378 MPa")", R"("1380 MPa")", "N = 100000"},
    {"fatigue.combined", "u_y", over, "R_e", R"("118 MPa")", R"("117 MPa")"},
    {"fatigue.combined", "u_F", over, "R_e", R"("177 MPa")", R"("176 MPa")"},
    {"fatigue.combined", "x_N", outside, "N", "1e7", "1.01e7", "rho = \"2700 kg/m^3\"\nN_D = 1e7"},
    {"fatigue.combined", "u_D", over, "S_D", "2.77", "2.78"},
    {"fatigue.combined", "x_v", outside, "tau_D", R"("103.93 MPa")", R"("103.9 MPa")", R"(rule = "goodman")"},
    {"fatigue.combined", "x_B", over, "sigma_m", R"("624.5 MPa")", R"("624.6 MPa")"},
    {"fatigue.wohler", "x_S", outside, "S", R"("310 MPa")", R"("309 MPa")"},
    {"fatigue.wohler", "x_S", outside, "S", R"("420 MPa")", R"("421 MPa")"},
    {"fatigue.wohler", "x_S", outside, "S", R"("0.535 GPa")", R"("0.5351 GPa")",
     R"(tests = [["535 MPa", 38000], ["480 MPa", 91000], ["420 MPa", 262000]])"},
    {"fatigue.wohler", "x_N", outside, "N_0", "980000", "981000"},
    {"fatigue.wohler", "x_0", outside, "N_0", "42600", "42500"},
    {"fatigue.wohler", "x_D", outside, "S_D", R"("239 MPa")", R"("238 MPa")"},
    {"fatigue.wohler", "P_f", outside, "P_s", "0.95", "0.951"},
    {"fatigue.staircase", "x_s", outside, "tests",
     R"([["300 MPa", "failure"], ["290 MPa", "failure"], ["280 MPa", "runout"], ["290 MPa", "runout"], ["300 MPa", "failure"], ["290 MPa", "failure"], ["280 MPa", "failure"], ["270 MPa", "runout"], ["280 MPa", "runout"], ["290 MPa", "failure"], ["280 MPa", "runout"], ["290 MPa", "runout"], ["300 MPa", "runout"], ["310 MPa", "failure"], ["300 MPa", "failure"], ["290 MPa", "runout"], ["300 MPa", "failure"], ["290 MPa", "failure"], ["280 MPa", "runout"], ["290 MPa", "failure"]])",
     R"([["260 MPa", "runout"], ["280 MPa", "runout"], ["300 MPa", "failure"], ["280 MPa", "runout"], ["300 MPa", "failure"], ["280 MPa", "runout"], ["300 MPa", "failure"], ["280 MPa", "failure"], ["260 MPa", "runout"], ["280 MPa", "failure"], ["260 MPa", "runout"], ["280 MPa", "runout"]])"},
    {"fatigue.staircase", "x_n", outside, "tests",
     R"([["300 MPa", "failure"], ["290 MPa", "failure"], ["280 MPa", "runout"], ["290 MPa", "runout"], ["300 MPa", "failure"], ["290 MPa", "failure"], ["280 MPa", "failure"], ["270 MPa", "runout"], ["280 MPa", "runout"], ["290 MPa", "failure"], ["280 MPa", "runout"], ["290 MPa", "runout"], ["300 MPa", "runout"], ["310 MPa", "failure"], ["300 MPa", "failure"]])",
     R"([["300 MPa", "failure"], ["290 MPa", "failure"], ["280 MPa", "runout"], ["290 MPa", "runout"], ["300 MPa", "failure"], ["290 MPa", "failure"], ["280 MPa", "failure"], ["270 MPa", "runout"], ["280 MPa", "runout"], ["290 MPa", "failure"], ["280 MPa", "runout"], ["290 MPa", "runout"], ["300 MPa", "runout"], ["310 MPa", "failure"]])"},
    {"fatigue.staircase", "P_f", outside, "P_s", "0.95", "0.951"},
    {"fatigue.survival", "x_P", outside, "P", "0.999", "0.9991"},
    {"fatigue.multiaxial", "u_y", over, "R_e", R"("165 MPa")", R"("164 MPa")", "S_F = "},
    {"fatigue.multiaxial", "u_F", over, "R_e", R"("247 MPa")", R"("246 MPa")"},
    {"fatigue.multiaxial", "x_N", outside, "N", "1e7", "1.01e7", "rho = \"2700 kg/m^3\"\nN_D = 1e7"},
    {"fatigue.multiaxial", "u_D", over, "S_D", "2.09", "2.1"},
    {"fatigue.multiaxial", "x_D", outside, "tau_D", R"("120 MPa")", R"("119 MPa")"},
    {"fatigue.multiaxial", "x_H", outside, "tau_D", R"("192 MPa")", R"("193 MPa")", R"(criterion = "crossland")"},
    {"fatigue.multiaxial", "x_H", outside, "tau_D", R"("192 MPa")", R"("193 MPa")", R"(criterion = "dang-van")"},
    {"fatigue.multiaxial", "x_C", outside, "tau_D", R"("138.6 MPa")", R"("138.5 MPa")", R"(criterion = "crossland")"},
    {"fatigue.history", "u_y", over, "R_e", R"("180 MPa")", R"("179 MPa")", "S_F = "},
    {"fatigue.history", "u_F", over, "R_e", R"("270 MPa")", R"("269 MPa")"},
    {"fatigue.history", "u_m", over, "R_m", R"("201 MPa")", R"("199.9 MPa")",
     "R_e = \nS_F = \nn_req = \nblocks = [{ sigma_a = \"10 MPa\", sigma_m = \"200 MPa\", n = 1 }]"},
    {"fatigue.history", "x_B", over, "R_m", R"("210 MPa")", R"("209 MPa")",
     "R_e = \nS_F = \nn_req = \nblocks = [{ sigma_a = \"10 MPa\", sigma_m = \"200 MPa\", n = 1 }]"},
    {"fatigue.history", "x_g", outside, "gate", R"("349 MPa")", R"("350 MPa")",
     "blocks = \nmean = \"none\"\nn_req = \nsigma = { values = [-200, 200, -150, 199, -200], unit = \"MPa\" }"},
    {"fatigue.history", "u_D", over, "n_req", "23.4", "23.6"},
    {"fatigue.history", "x_N", outside, "sigma_D", R"("45.3 MPa")", R"("45.1 MPa")",
     "blocks = [{ sigma_a = \"180 MPa\", n = 1 }]"},
    {"fatigue.history", "x_O", outside, "blocks",  // (500 1.5^5)/99 = n 0.75^9
     R"([{ sigma_a = "180 MPa", n = 500 }, { sigma_a = "90 MPa", n = 510 }])",
     R"([{ sigma_a = "180 MPa", n = 500 }, { sigma_a = "90 MPa", n = 512 }])", "miner = \"original\"\nmean = \"none\""},
    {"fatigue.history", "x_R", outside, "R_e", R"("80 MPa")", R"("79 MPa")",
     "sigma_D = \nN_D = \nk = \nmean = \"none\"\ncurve = \"en1993\"\nsigma_C = \"71 MPa\"\nS_F = \n"
     "blocks = [{ sigma_a = \"60 MPa\", n = 100 }]"},
    {"fatigue.din743", "u_D", over, "S_min", "1.69", "1.7"},
    {"fatigue.din743", "u_F", over, "S_min", "2.96", "2.97"},
    {"fatigue.din743", "x_m", over, "M_tm", R"("7300 N*m")", R"("7301 N*m")"},
    {"fatigue.din743", "x_small", outside, "d", R"("7.5 mm")", R"("7.4 mm")", "notch = \"smooth\"\nD = \nr = "},
    {"fatigue.din743", "x_eff", outside, "d_h", R"("500 mm")", R"("501 mm")"},
    {"fatigue.din743", "x_Rz", outside, "R_z", R"("199 um")", R"("201 um")"},
    {"fatigue.din743", "x_E", outside, "E", R"("179 GPa")", R"("178 GPa")"},
    {"fatigue.din743", "x_r", outside, "r", R"("0.121 mm")", R"("0.119 mm")"},
    {"fatigue.din743", "x_r", outside, "r", R"("0.121 mm")", R"("0.119 mm")", R"(notch = "round-groove")"},
    {"fatigue.din743", "x_D", outside, "D", R"("42.86 mm")", R"("42.85 mm")"},
    {"fatigue.din743", "x_alpha", outside, "alpha_b", "6", "6.1", "notch = \"alpha\"\nD = \nr = \nalpha_t = 2"},
    {"fatigue.din743", "x_t", outside, "D", R"("46.3 mm")", R"("46.1 mm")", "notch = \"v-groove\"\nr = "},
    {"fatigue.din743", "x_t", outside, "D", R"("58.7 mm")", R"("58.9 mm")", "notch = \"v-groove\"\nr = "},
    {"fatigue.din743", "x_hole", outside, "r", R"("6.2 mm")", R"("6.4 mm")", "notch = \"cross-hole\"\nD = "},
    {"fatigue.din743", "x_bore", outside, "d_bore", R"("0 mm")", R"("1 mm")"},
    {"fatigue.fkm", "u_D", over, "j_D", "1.79", "1.8"},
    {"fatigue.fkm", "u_S", over, "f_max", "3.4", "3.42"},
    {"fatigue.fkm", "x_eff", outside, "d_h", R"("250 mm")", R"("251 mm")"},
    {"fatigue.fkm", "x_G", outside, "G_b", R"("99.9/mm")", R"("101/mm")",
     "notch = \"alpha\"\nD = \nr = \nalpha_b = 2\nalpha_t = 2"},
    {"fatigue.fkm", "x_G", outside, "d", R"("0.0201 mm")", R"("0.0199 mm")", "notch = \"smooth\"\nD = \nr = "},
    {"fatigue.fkm", "x_Rz", outside, "R_z", R"("199 um")", R"("201 um")"},
    {"fatigue.fkm", "x_E", outside, "E", R"("179 GPa")", R"("178 GPa")"},
    {"fatigue.fkm", "x_N", outside, "N", "10000", "9999"},
    {"fatigue.fkm", "x_small", outside, "d", R"("7.5 mm")", R"("7.4 mm")", "notch = \"keyway\"\nD = \nr = "},
    {"fatigue.fkm", "x_r", outside, "r", R"("0.121 mm")", R"("0.119 mm")"},
    {"fatigue.fkm", "x_D", outside, "D", R"("42.86 mm")", R"("42.85 mm")"},
    {"fatigue.fkm", "x_alpha", outside, "alpha_b", "6", "6.1", "notch = \"alpha\"\nD = \nr = \nalpha_t = 2"},
    {"fatigue.fkm", "x_t", outside, "D", R"("46.3 mm")", R"("46.1 mm")", "notch = \"v-groove\"\nr = "},
    {"fatigue.fkm", "x_hole", outside, "r", R"("6.2 mm")", R"("6.4 mm")", "notch = \"cross-hole\"\nD = "},
    {"fatigue.fkm", "x_bore", outside, "d_bore", R"("0 mm")", R"("1 mm")"},
};

const char* const spur = "beta = \"0 deg\"\na_w = \nx_1 = 0";
// a pitch circle of 50 mm: 400 rad/s are 10 m/s
const char* const cast = "beta = \"0 deg\"\na_w = \nx_1 = 0\ncutting = \"cast\"";
const char* const milled = "beta = \"0 deg\"\na_w = \nx_1 = 0\ncutting = \"milled\"";
const char* const hobbed = "beta = \"0 deg\"\na_w = \nx_1 = 0\ncutting = \"hobbed\"";
const char* const ground = "beta = \"0 deg\"\na_w = \nx_1 = 0\ncutting = \"ground\"";

const Side gears[] = {
    {"gear.pair", "v_share", outside, "n_1", R"("399 rad/s")", R"("401 rad/s")", cast},
    {"gear.pair", "v_share", outside, "n_1", R"("799 rad/s")", R"("801 rad/s")", milled},
    {"gear.pair", "v_share", outside, "n_1", R"("999 rad/s")", R"("1001 rad/s")", hobbed},
    {"gear.pair", "v_share", outside, "n_1", R"("1999 rad/s")", R"("2001 rad/s")", ground},
    {"gear.pair", "eps_gamma", over, "h_aP", "0.6", "0.55", spur},
    {"gear.pair", "x_free", over, "x_1", "-0.18", "-0.19", spur},
    {"gear.pair", "s_a", over, "x_1", "1.18", "1.2", spur},
    {"gear.pair", "f_int", over, "z_1", "16", "15", spur},
    {"gear.pair", "j_bn", over, "a_w", R"("96.25 mm")", R"("96.24 mm")", "beta = \"0 deg\"\nx_1 = 0\nx_2 = 0"},
    {"gear.pair", "v_share", outside, "n_1", R"("9190 rpm")", R"("9200 rpm")"},
    // Beyond the bound every pair of the range fails: the one that comes nearest is shown.
    {"gear.sizing", "u_H1", over, "P", R"("15 kW")", R"("5000 kW")"},
    {"gear.sizing", "u_H2", over, "P", R"("15 kW")", R"("5000 kW")"},
    {"gear.sizing", "u_F1", over, "P", R"("15 kW")", R"("5000 kW")"},
    {"gear.sizing", "u_F2", over, "P", R"("15 kW")", R"("5000 kW")"},
    {"gear.sizing", "found", over, "P", R"("15 kW")", R"("5000 kW")"},
    {"gear.sizing", "x_v", outside, "n_1", R"("1450 rpm")", R"("200000 rpm")"},
    {"gear.sizing", "x_c", outside, "x_sum", "-0.4", "-0.6", "standard = \"iso6336\"\nnu_40 = \"134 mm^2/s\""},
    {"gear.sizing", "x_eps", outside, "h_aP", "1", "0.5"},
    {"gear.sizing", "x_free", over, "z_max", "20", "8", "shift = \"none\"\nz_min = 8"},
    {"gear.sizing", "s_a", over, "h_aP", "1", "1.9"},
    {"gear.sizing", "f_int", over, "h_aP", "1", "1.2"},
    {"gear.sizing", "c_n", over, "h_fP", "1.25", "0.99"},
    {"gear.rating", "u_H1", over, "T_1", R"("758 N*m")", R"("759 N*m")"},
    {"gear.rating", "u_H2", over, "T_1", R"("776 N*m")", R"("777 N*m")"},
    {"gear.rating", "u_F1", over, "T_1", R"("902 N*m")", R"("903 N*m")"},
    {"gear.rating", "u_F2", over, "T_1", R"("893 N*m")", R"("894 N*m")"},
    {"gear.rating", "x_v", outside, "n_1", R"("13440 rpm")", R"("13450 rpm")"},
    {"gear.rating", "x_c", outside, "x_1", "-0.24", "-0.26",
     "standard = \"iso6336\"\nnu_40 = \"150 mm^2/s\"\nx_2 = -0.25"},
    {"gear.rating", "x_free", over, "x_1", "-0.045", "-0.046"},
    {"gear.rating", "s_a", over, "x_1", "1.08", "1.081"},
    {"gear.rating", "f_int", over, "h_aP", "1.167", "1.168"},
    {"gear.rating", "c_n", over, "h_fP", "1.001", "0.999"},
    {"gear.rating", "j_bn", over, "a_w", R"("248.51 mm")", R"("248.5 mm")"},
    {"gear.rating", "x_eps", outside, "h_aP", "0.661", "0.66"},
    {"gear.rating", "x_eps", outside, "h_aP", "1.132", "1.133", "x_1 = 0\nx_2 = 0\nz_1 = 40"},
    {"gear.bevel", "u_H1", over, "S_Hmin", "1.466", "1.467"},
    {"gear.bevel", "u_H2", over, "S_Hmin", "1.446", "1.447"},
    {"gear.bevel", "u_F1", over, "S_Fmin", "2.166", "2.167"},
    {"gear.bevel", "u_F2", over, "S_Fmin", "1.711", "1.712"},
    {"gear.bevel", "x_R", over, "b", R"("29.8 mm")", R"("29.9 mm")"},  // a third of 89.44 mm
    {"gear.bevel", "x_m", over, "b", R"("40 mm")", R"("40.1 mm")", "z_1 = 40\nz_2 = 80"},
    {"gear.bevel", "x_m", over, "b", R"("8 mm")", R"("7.9 mm")"},
    {"gear.bevel", "eps_v", over, "h_aP", "0.734", "0.733",
     "alpha = \"25 deg\"\nz_1 = 8\nz_2 = 8\nb = \"8 mm\"\nx_1 = 0"},
    {"gear.bevel", "x_free", over, "x_1", "-0.327", "-0.328"},
    {"gear.bevel", "s_a", over, "x_1", "0.515", "0.516", "z_1 = 10\nb = \"12 mm\""},
    {"gear.bevel", "x_v", outside, "n_1", R"("6953 rpm")", R"("6954 rpm")"},
    {"gear.bevel", "N_1", outside, "N", "1e10", "1.001e10", "L_h = "},
    {"gear.bevel", "N_2", outside, "N", "2000", "1999", "L_h = "},
    {"gear.bevel", "m_R1", outside, "bore_1", R"("36.1 mm")", R"("36.2 mm")"},
    {"gear.bevel", "m_R2", outside, "bore_2", R"("91.8 mm")", R"("91.9 mm")"},
    {"gear.worm", "u_W", over, "S_Wmin", "5.199", "5.2"},
    {"gear.worm", "u_F", over, "sigma_adm", R"("29.6 MPa")", R"("29.5 MPa")"},
    {"gear.worm", "u_T", over, "dT_adm", R"("14.3 K")", R"("14.2 K")"},
    {"gear.worm", "x_z", over, "z_2", "17", "16"},
    {"gear.worm", "x_L", over, "mu", "0.188", "0.187", "locking = \"required\""},  // 0.2 cos(20 deg)
    {"gear.worm", "x_i", outside, "z_2", "200", "201"},
    {"gear.worm", "m_R2", outside, "bore_2", R"("128.4 mm")", R"("128.5 mm")"},
    {"gear.worm", "x_b", over, "b_2", R"("12 mm")", R"("11.9 mm")"},
    {"gear.worm", "tau_f1", over, "T_1", R"("424.1 N*m")", R"("424.2 N*m")", "P = "},  // 1.25 T_1 / (pi 30^3/16 mm^3)
    {"gear.worm", "x_n", outside, "n_1", R"("3600 rpm")", R"("3601 rpm")"},
    {"gear.worm", "x_s", outside, "n_1", R"("14045 rpm")", R"("14046 rpm")"},
    {"gear.worm", "C_s", outside, "m_x", R"("9.32 mm")", R"("9.33 mm")",  // 10^((1190 - 300)/477) in
     "d_1 = \"200 mm\"\nz_2 = 200\ncasting = \"sand\""},
    {"gear.crossed", "u_C", over, "C_adm", R"("0.672 MPa")", R"("0.671 MPa")"},
    {"gear.crossed", "eps_n", over, "h_aP", "0.729", "0.728",
     "alpha_n = \"30 deg\"\nbeta_1 = \"5 deg\"\nbeta_2 = \"5 deg\""},
    {"gear.crossed", "x_free", over, "z_1", "7", "6"},
    {"gear.crossed", "s_a", over, "h_aP", "1.132", "1.133", "alpha_n = \"30 deg\""},
    {"gear.crossed", "x_b1", over, "b_1", R"("7.33 mm")", R"("7.32 mm")"},  // 2 g_a2 sin(beta_b1)
    {"gear.crossed", "x_b2", over, "b_2", R"("7.33 mm")", R"("7.32 mm")"},
    {"gear.crossed", "x_L", over, "mu", "0.252", "0.251",  // cos(20 deg)/tan(75 deg)
     "beta_1 = \"75 deg\"\nbeta_2 = \"15 deg\"\nlocking = \"required\""},
    {"gear.crossed", "m_R1", outside, "bore_1", R"("40.7 mm")", R"("40.8 mm")"},
    {"gear.crossed", "m_R2", outside, "bore_2", R"("97.3 mm")", R"("97.4 mm")"},
    {"gear.pair", "v_share", State::not_available, "cutting", R"("hobbed")", R"("none")"},
    {"gear.pair", "x_2", outside, "a_w", R"("102.48 mm")", R"("102.49 mm")", "beta = \"0 deg\"\nx_1 = 0"},
    {"gear.pair", "x_2", outside, "a_w", R"("96.1 mm")", R"("95.9 mm")", "beta = \"0 deg\"\nx_1 = 2.9"},
    {"gear.pair", "q_a", over, "x_1", "-1.6", "-1.61", "beta = \"0 deg\"\na_w = \nshortening = \"none\"\nx_2 = 1.6"},
    {"gear.pair", "u_F1", over, "sigma_adm_1", R"("171 MPa")", R"("170 MPa")"},
    {"gear.pair", "u_F2", over, "sigma_adm_2", R"("144 MPa")", R"("143 MPa")"},
    {"gear.pair", "c_1", over, "h_fP", "1", "0.99", "beta = \"0 deg\"\na_w = \nx_1 = 0\nrho_fP = 0"},
    {"gear.pair", "c_2", over, "h_fP", "1", "0.99", "beta = \"0 deg\"\na_w = \nx_1 = 0\nrho_fP = 0"},
    // root circles of 43.75 and 136.25 mm, teeth of 5.625 mm: rims of 6.75 mm
    {"gear.pair", "m_R1", outside, "bore_1", R"("26.2 mm")", R"("26.3 mm")",
     "beta = \"0 deg\"\na_w = \nx_1 = 0\nt_k1 = \"2 mm\""},
    {"gear.pair", "m_R2", outside, "bore_2", R"("116.7 mm")", R"("116.8 mm")",
     "beta = \"0 deg\"\na_w = \nx_1 = 0\nt_k2 = \"3 mm\""},
    {"gear.cycloidal", "eps_pins", over, "k_a", "0.545", "0.54"},
    {"gear.planetary", "z_gap", outside, "z_p", "28", "27"},
    {"gear.planetary", "z_gap", outside, "z_p", "32", "33"},
    {"gear.planetary", "u_N", over, "N_p", "3", "4", "z_s = 12\nz_p = 60\nz_r = 132"},
    {"gear.planetary", "f_sp", over, "z_s", "16", "15", "z_p = 57\nz_r = "},
    {"gear.planetary", "f_pr", over, "h_ar", "0.91", "0.93"},  // 1 - 0.09: recomputed from the base circles
    {"gear.planetary", "eps_sp", over, "h_aP", "0.6", "0.5"},
    {"gear.planetary", "eps_pr", over, "h_ar", "0.3", "0"},
    {"gear.planetary", "c_a", over, "h_aP", "1.25", "1.26"},
    {"gear.planetary", "s_a", over, "x_s", "1.6", "2"},
    {"gear.planetary", "x_free", over, "z_s", "17", "16", "z_r = "},
};

const Side pulleys[] = {
    {"chain.roller", "i", outside, "z_2", "100", "101", "z_1 = 10"},
    {"chain.roller", "alpha_1", outside, "a", R"("700 mm")", R"("500 mm")", "z_1 = 17\nz_2 = 100"},
    {"chain.roller", "alpha_2", outside, "a", R"("700 mm")", R"("500 mm")", "z_1 = 100\nz_2 = 17"},
    {"chain.inverted_tooth", "i", outside, "z_2", "120", "121", "z_1 = 12\na = \"900 mm\""},
    {"chain.inverted_tooth", "alpha_1", outside, "a", R"("560 mm")", R"("450 mm")", "z_1 = 15\nz_2 = 150"},
    {"chain.inverted_tooth", "alpha_2", outside, "a", R"("560 mm")", R"("450 mm")", "z_1 = 150\nz_2 = 15"},
    {"chain.inverted_tooth", "v_share", outside, "n_1", R"("4724 rpm")", R"("4725 rpm")"},
    {"chain.inverted_tooth", "u_b", over, "b", R"("42.1 mm")", R"("41.9 mm")"},
    {"chain.inverted_tooth", "u_F", over, "F_u", R"("4.2 kN")", R"("4.1 kN")"},
    {"chain.inverted_tooth", "u_S", over, "S_min", "13.1", "13.2"},
    {"chain.roller", "g_s", over, "a", R"("13900 mm")", R"("14100 mm")", "theta = \"0 deg\"\nloaded = \"lower\""},
    {"chain.roller", "theta_c", outside, "theta", R"("-59.9 deg")", R"("-61 deg")"},
    {"chain.roller", "v_share", outside, "n_1", R"("670 rpm")", R"("680 rpm")"},
    {"chain.roller", "v_share", outside, "n_1", R"("1349 rpm")", R"("1351 rpm")", R"(lubrication = "bath")"},
    {"chain.roller", "u_p", over, "p_adm", R"("22 MPa")", R"("21 MPa")"},
    {"chain.roller", "u_F", over, "P", R"("39.2 kW")", R"("39.3 kW")"},
    {"chain.roller", "u_S", over, "S_min", "12.6", "12.7"},
    {"chain.roller", "u_P", over, "P_R", R"("3.51 kW")", R"("3.5 kW")"},
    {"belt.course", "u_S", over, "S_0", R"("248 N")", R"("247 N")"},
    {"belt.course", "N_min", over, "S_0", R"("45 N")", R"("44 N")", "mu = "},
    {"belt.course", "u_T", over, "S_adm", R"("2 kN")", R"("0.5 kN")"},
    {"drive.friction_wheels", "u_S", over, "F_p", R"("1919 N")", R"("1918 N")"},
    {"drive.friction_wheels", "u_p", over, "q_adm", R"("24 N/mm")", R"("23.9 N/mm")"},
    {"drive.friction_wheels", "u_p", over, "p_adm", R"("109 MPa")", R"("108 MPa")",
     "E_1 = \"210 GPa\"\nE_2 = \"210 GPa\""},  // 108.37 MPa
    {"belt.flat", "u_S", over, "S_0", R"("1201 N")", R"("1200 N")", R"(b = "100 mm")"},
    {"belt.flat", "u_S", over, "m_m", R"("190 kg")", R"("189 kg")", PIVOTED_BELT},
    {"belt.flat", "u_Sr", over, "m_m", R"("271 kg")", R"("270 kg")", PIVOTED_BELT "\nrotation = \"both\""},
    {"belt.flat", "u_sigma", over, "sigma_adm", R"("7.2 MPa")", R"("7.1 MPa")", "b = \"100 mm\"\nE_b = "},
    {"belt.flat", "sigma_N", over, "n_1", R"("7000 rpm")", R"("7100 rpm")", "b = \"100 mm\"\nE_b = "},
    {"belt.flat", "v_range", outside, "n_1", R"("478 rpm")", R"("477 rpm")", R"(b = "300 mm")"},
    {"belt.flat", "v_range", outside, "n_1", R"("9549 rpm")", R"("9550 rpm")", R"(b = "300 mm")"},
    {"belt.flat", "x_v", outside, "n_1", R"("2864 rpm")", R"("2865 rpm")", "kind = \"conventional\"\nb = \"100 mm\""},
    {"belt.flat", "u_b", over, "E_b", R"("480 MPa")", R"("481 MPa")", R"(b = "100 mm")"},  // 6 MPa at 2.5/200
    {"belt.flat", "u_L", over, "L_req", R"("838 h")", R"("839 h")", "b = \"100 mm\"\nsigma_f = \"9 MPa\"\nm_f = 6"},
    {"belt.flat", "g_x", over, "a", R"("355.1 mm")", R"("354.9 mm")", R"(b = "100 mm")"},
    {"belt.flat", "x_a", outside, "a", R"("2000 mm")", R"("1999 mm")", "arrangement = \"crossed\"\nb = \"100 mm\""},
    {"belt.flat", "x_q", outside, "a", R"("1400 mm")", R"("1399 mm")",
     "arrangement = \"quarter_turn\"\nb = \"100 mm\""},
    {"belt.flat", "x_t", outside, "b", R"("200 mm")", R"("201 mm")", "arrangement = \"quarter_turn\"\na = \"1600 mm\""},
    {"belt.flat", "x_b", outside, "b", R"("299 mm")", R"("301 mm")"},
};

const char* const large = "d_1 = \"140 mm\"\nd_2 = \"4000 mm\"";

const char* const rib_of_3_56_mm =
    "d_b = \nrho = \nsigma_adm = \nE_b = \nphi = \nd_min = \nribbed_belt = \"PK\"\nP_R = \"0.1 kW\"";
const Side v_belts[] = {
    {"belt.grooved", "S_N", over, "n_1", R"("11600 rpm")", R"("11700 rpm")", "z = 1"},
    {"belt.grooved", "u_S", over, "S_0", R"("17.7 N")", R"("17.5 N")"},
    {"belt.grooved", "u_T", over, "P", R"("377 W")", R"("378 W")", "z = 1"},
    {"belt.grooved", "u_P", over, "P_R", R"("0.181 kW")", R"("0.179 kW")", "z = 1"},
    {"belt.grooved", "u_b", over, "E_b", R"("53 MPa")", R"("54 MPa")", "z = 1"},
    {"belt.grooved", "x_d", over, "d_min", R"("80 mm")", R"("81 mm")"},
    {"belt.grooved", "x_v", outside, "v_max", R"("5.9 m/s")", R"("5.8 m/s")"},
    {"belt.grooved", "x_b", outside, "z", "22", "23", rib_of_3_56_mm},
    {"belt.grooved", "g_x", over, "a", R"("126.1 mm")", R"("125.9 mm")"},
    {"belt.synchronous", "u_P", over, "P", R"("5.34 kW")", R"("5.35 kW")"},
    {"belt.synchronous", "P_R", over, "n_1", R"("16100 rpm")", R"("16200 rpm")", R"(b = "76.2 mm")"},
    {"belt.synchronous", "x_m", outside, "a", R"("250 mm")", R"("180 mm")", "z_1 = 6\nz_2 = 60"},
    {"belt.synchronous", "x_z", over, "z_1", "18", "17"},
    {"belt.synchronous", "x_v", outside, "n_1", R"("7795 rpm")", R"("7796 rpm")"},
    {"belt.synchronous", "x_n", outside, "n_1", R"("3600 rpm")", R"("3601 rpm")"},
    {"belt.synchronous", "x_b", outside, "b", R"("76.2 mm")", R"("76.3 mm")"},
    {"belt.synchronous", "x_w", outside, "b", R"("19.1 mm")", R"("19 mm")"},
    {"belt.synchronous", "g_f", over, "z_B", "52", "51", "a = "},
    {"belt.v", "u_P", over, "z", "3", "2"},
    {"belt.v", "u_grip", over, "mu", "0.44", "0.43", "z = 9"},
    {"belt.v", "u_rim", over, "v_rim_adm", R"("15.9 m/s")", R"("15.8 m/s")"},
    {"belt.v", "u_B", over, "n_1", R"("8500 rpm")", R"("8550 rpm")",
     "d_1 = \"140 mm\"\nd_2 = \"140 mm\"\nL = \"1250 mm\""},
    {"belt.v", "P_N", outside, "n_1", R"("5000 rpm")", R"("5500 rpm")", R"(d_1 = "250 mm")"},
    {"belt.v", "x_dmin", over, "d_1", R"("140 mm")", R"("139 mm")"},
    {"belt.v", "x_d", outside, "d_1", R"("140 mm")", R"("139 mm")"},
    {"belt.v", "x_d", outside, "d_1", R"("400 mm")", R"("401 mm")", "L = \"4000 mm\"\nd_2 = \"800 mm\""},
    {"belt.v", "x_n", outside, "n_1", R"("100 rpm")", R"("99 rpm")"},
    {"belt.v", "x_n", outside, "n_1", R"("5500 rpm")", R"("5510 rpm")"},
    {"belt.v", "x_L", outside, "L", R"("1250 mm")", R"("1249 mm")", "d_1 = \"140 mm\"\nd_2 = \"140 mm\""},
    {"belt.v", "x_L", outside, "L", R"("10000 mm")", R"("10001 mm")"},
    {"belt.v", "x_alpha", outside, "L", R"("13200 mm")", R"("13000 mm")", large},
    {"belt.v", "x_v", outside, "n_1", R"("4010 rpm")", R"("4020 rpm")"},
    {"belt.v", "x_z", outside, "z", "16", "17"},
    {"belt.v", "off_d", outside, "d_2", R"("400 mm")", R"("401 mm")"},
    {"belt.v", "off_L", outside, "L", R"("2650 mm")", R"("2651 mm")"},
    {"belt.v", "g_r", over, "a", R"("307.1 mm")", R"("306.9 mm")", "L = "},
    {"belt.v", "g_f", over, "a", R"("360 mm")", R"("340 mm")", "L = "},
    // The sizing lists only drives that pass every check: beyond a bound there is none, and nothing to check.
    {"belt.v_sizing", "u_P", over, "z_max", "8", "4", R"(P = "200 kW")"},
    {"belt.v_sizing", "u_grip", over, "mu", "0.5", "0.3"},
    {"belt.v_sizing", "u_rim", over, "v_rim_adm", R"("10 m/s")", R"("3 m/s")"},
    {"belt.v_sizing", "u_B", State::not_available, "a_set", R"("600 mm")", R"("60 mm")"},
    {"belt.v_sizing", "drives", over, "P", R"("200 kW")", R"("300 kW")"},
};

// At the crank 120 N m at rest and 100 rpm without load; then with a constant load of half of that, on 20 kg m^2.
const char* const straight_motor =
    "points = \nJ_of_phi = \nM_K = \ns_K = \nJ_M = \nM_A = \"10 N*m\"\nn_0 = \"1200 rpm\"\neta = 1";
const char* const carrying_motor =
    "points = \nJ_of_phi = \nM_K = \ns_K = \nJ_M = \nM_A = \"10 N*m\"\nn_0 = \"1200 rpm\"\neta = 1\nM = \"60 N*m\"";
const Side motion[] = {
    // arcs of 60, 40, 50 and 80 deg close up to 95.843 deg, where coupler and output are in line: cos(diagonal) = 0
    {"motion.spherical_four_bar", "u_c", over, "phi_b", R"("95.8 deg")", R"("95.9 deg")",
     "alpha_1 = \"60 deg\"\nalpha_2 = \"40 deg\"\nalpha_3 = \"50 deg\"\nphi_a = \"20 deg\"\nmu_req = "},
    // the diagonal of 110 deg: arccos(|cos(110 deg) - cos(70 deg) cos(60 deg)|/(sin(70 deg) sin(60 deg))) = 50.919 deg
    {"motion.spherical_four_bar", "u_mu", over, "mu_req", R"("50.9 deg")", R"("51 deg")"},
    {"motion.spherical_four_bar", "T_min", over, "alpha_4", R"("99.9 deg")", R"("100 deg")"},
    {"dynamics.throw", "u_h", over, "h", R"("-5 m")", R"("-5.1 m")"},
    {"dynamics.throw", "u_L", over, "L_req", R"("35.3 m")", R"("35.4 m")"},
    {"dynamics.lift", "u_s", over, "s", R"("1.04 m")", R"("1.05 m")",
     "v_0 = \"3 m/s\"\nweights = [{ m = \"8 kg\", i = -1 }]"},
    {"dynamics.lift", "u_s", State::not_available, "weights", R"([{ m = "8 kg" }])", R"([{ m = "8 kg", i = -1 }])"},
    {"dynamics.lift", "T_hang", over, "wheels",  // the drum runs ahead of a weight that falls
     R"([{ J = "0.01 kg*m^2", r = "100 mm", M_d = "0.98 N*m" }])",
     R"([{ J = "0.01 kg*m^2", r = "100 mm", M_d = "0.99 N*m" }])", R"(weights = [{ m = "10 kg" }])"},
    {"dynamics.lift", "T_slope", outside, "wheels", R"([{ J = "0.01 kg*m^2", r = "100 mm", M_d = "0.49 N*m" }])",
     R"([{ J = "0.01 kg*m^2", r = "100 mm", M_d = "0.5 N*m" }])", R"(weights = [{ m = "10 kg", alpha = "30 deg" }])"},
    {"dynamics.work", "u_s", over, "mu", "0.577", "0.578"},
    {"machine.flywheel", "u_delta", over, "delta", "0.0039", "0.0038", R"(J = "8000 kg*m^2")"},
    {"machine.flywheel", "u_P", over, "P_n", R"("377 kW")", R"("376 kW")"},
    {"machine.flywheel", "u_v", over, "v_adm", R"("18.9 m/s")", R"("18.8 m/s")", R"(D = "2 m")"},
    {"machine.disc", "u_v", over, "S", "2.792", "2.793"},
    {"machine.disc", "x_b", outside, "b", R"("125 mm")", R"("126 mm")"},
    {"machine.motion", "u_A", over, "M", R"("119 N*m")", R"("121 N*m")", straight_motor},
    {"machine.motion", "u_S", over, "M", R"("119 N*m")", R"("121 N*m")", straight_motor},
    {"machine.motion", "x_n", outside, "motor", R"([["0 rpm", "10 N*m"], ["601 rpm", "4.99 N*m"]])",
     R"([["0 rpm", "10 N*m"], ["599 rpm", "5.01 N*m"]])",
     "points = \nJ_of_phi = \nM_K = \ns_K = \nn_0 = \neta = 1\nM = \"60 N*m\""},
    {"machine.motion", "u_K", over, "J_F", R"("20 kg*m^2")", R"("8 kg*m^2")"},
    {"machine.motion", "u_delta", over, "delta_adm", "0.2", "0.01"},
    {"machine.motion", "u_t", over, "t_adm", R"("9.25 s")", R"("9.24 s")", carrying_motor},  // tau ln 200 = 9.2473 s
    {"machine.motion", "u_M", over, "M_n", R"("5.01 N*m")", R"("4.99 N*m")", carrying_motor},
    {"machine.run_up", "u_M", over, "load", R"([["0 rpm", "2 N*m"], ["1400 rpm", "39.9 N*m"]])",
     R"([["0 rpm", "2 N*m"], ["1400 rpm", "40.1 N*m"]])"},
    {"machine.run_up", "u_t", over, "t_adm", R"("3.71 s")", R"("3.7 s")"},
};

const char* const radial = "f_0 = \nF_a = ";
const char* const radial_by_maker = "f_0 = \nF_a = \nP_min = \"290.5 N\"";
const char* const tapered = "f_0 = \nkind = \"tapered_roller\"\ne = 0.37\nY = 1.6\nY_0 = 0.9";  // F_i = 0.781 kN

// s_c = 16 - 19.75/2 = 6.125 mm, and a tenth of a more
const char* const at_centre =
    "f_0 = \nkind = \"tapered_roller\"\ne = 0.37\nY = 1.6\nY_0 = 0.9\na = \"16 mm\"\nB = \"19.75 mm\"";
const char* const on_seat =
    "d = \"40 mm\"\nB = \"18 mm\"\nr_s = \"1.1 mm\"\nd_a = \"47 mm\"\nd_s = \"40 mm\"";  // of a bearing 6208

const Side bearings[] = {
    {"bearing.rolling", "x_f", outside, "F_a", R"("8.8 kN")", R"("8.82 kN")"},
    {"bearing.rolling", "F_ao", over, "F_a", R"("0 N")", R"("1 N")", "kind = \"cylindrical_roller_NU\"\nf_0 = "},
    {"bearing.rolling", "F_ro", over, "F_r", R"("0 N")", R"("1 N")", "kind = \"thrust_ball\"\nf_0 = "},
    {"bearing.rolling", "u_L", over, "L_h", R"("15800 h")", R"("15850 h")"},
    {"bearing.rolling", "x_P", outside, "F_r", R"("14.5 kN")", R"("14.6 kN")", radial},
    {"bearing.rolling", "u_0", over, "s_0", "7.1", "7.2"},
    {"bearing.rolling", "x_min", over, "F_r", R"("291 N")", R"("290 N")", radial_by_maker},
    {"bearing.rolling", "u_n", over, "n_max", R"("900 rpm")", R"("899 rpm")"},
    {"bearing.rolling", "u_a", over, "F_a", R"("8.94 kN")", R"("8.96 kN")", "f_0 = \ne = 0.44\nY = 1"},
    {"bearing.rolling", "x_i", outside, "F_a", R"("0.79 kN")", R"("0.78 kN")", tapered},
    {"bearing.rolling", "x_k", outside, "nu", R"("2.06 mm^2/s")", R"("2.04 mm^2/s")",
     "d = \"40 mm\"\nD = \"80 mm\"\ne_C = 0.5\nC_u = \"0.8 kN\""},
    {"bearing.rolling", "x_c", outside, "s_p", R"("7.7 mm")", R"("7.8 mm")", at_centre},
    {"bearing.rolling", "x_d", over, "d_s", R"("40 mm")", R"("40.01 mm")", on_seat},
    {"bearing.rolling", "x_B", over, "l_s", R"("18 mm")", R"("17.9 mm")", on_seat},
    {"bearing.rolling", "x_r", over, "r_f", R"("1.1 mm")", R"("1.2 mm")", on_seat},
    {"bearing.rolling", "x_a", over, "d_f", R"("47 mm")", R"("46.9 mm")", on_seat},
};

const char* const own_key = "key = \nb = \"14 mm\"\nh = \"9 mm\"\nt_1 = \"5.5 mm\"";

const Side keys[] = {
    {"shaft.key", "u_1", over, "T", R"("2051 N*m")", R"("2052 N*m")"},
    {"shaft.key", "u_2", over, "T", R"("1058 N*m")", R"("1059 N*m")"},
    {"shaft.key", "u_k", over, "T", R"("1481 N*m")", R"("1482 N*m")"},
    {"shaft.key", "u_tau", over, "tau_adm", R"("28.8 MPa")", R"("28.6 MPa")"},
    {"shaft.key", "u_W", over, "f_W", "0.426", "0.425", R"(torque = "reversing")"},
    {"shaft.key", "u_n", over, "l_n", R"("70 mm")", R"("69.9 mm")"},
    {"shaft.key", "x_l", outside, "l", R"("79 mm")", R"("79.1 mm")"},
    {"shaft.key", "x_d", over, "d", R"("50 mm")", R"("50.1 mm")"},
    {"shaft.key", "x_d", over, "d", R"("44.1 mm")", R"("44 mm")"},
    {"shaft.key", "x_w", outside, "d_bore", R"("28 mm")", R"("28.1 mm")"},
    {"shaft.key", "x_h", over, "t_2", R"("3.5 mm")", R"("3.4 mm")", own_key},
    {"shaft.key", "u_t", over, "T", R"("2956 N*m")", R"("2958 N*m")", "S_F = 1"},
    {"shaft.key", "x_b", outside, "b", R"("20.9 mm")", R"("21.1 mm")", own_key},
    {"shaft.key", "x_t", outside, "t_1", R"("12.5 mm")", R"("12.6 mm")", "key = \nb = \"14 mm\"\nh = \"20 mm\""},
    {"shaft.key", "m_R", outside, "h_t", R"("13.49 mm")", R"("13.51 mm")", R"(d_f = "90 mm")"},
    {"shaft.key", "x_R", outside, "d_f", R"("65.3 mm")", R"("65.1 mm")"},  // 3.8 mm of keyway, 3.8 mm over it
    {"shaft.spline", "u_1", over, "R_e_1", R"("26.5 MPa")", R"("26.4 MPa")"},
    {"shaft.spline", "u_2", over, "R_e_2", R"("26.5 MPa")", R"("26.4 MPa")"},
    {"shaft.spline", "u_w", over, "p_adm_w", R"("23.9 MPa")", R"("23.8 MPa")", R"(hub = "slides")"},
    {"shaft.spline", "u_tau", over, "tau_adm", R"("9.6 MPa")", R"("9.5 MPa")"},
    {"shaft.spline", "u_W", over, "f_W", "0.265", "0.264", "torque = \"reversing\"\nR_e_2 = \"100 MPa\""},
    {"shaft.spline", "u_t", over, "d_bore", R"("50.1 mm")", R"("50.2 mm")", "S_F = 1"},
    {"shaft.spline", "x_l", outside, "l", R"("72.8 mm")", R"("72.9 mm")"},
    {"shaft.spline", "x_s", outside, "d_2", R"("77.9 mm")", R"("78.1 mm")", "spline = \nz = 8\nd_1 = \"52 mm\""},
    {"shaft.spline", "m_R", outside, "h_t", R"("12.4 mm")", R"("12.6 mm")", R"(d_f = "90 mm")"},
    {"shaft.spline", "x_R", outside, "d_f", R"("68.1 mm")", R"("67.9 mm")"},
    {"shaft.set_screw", "u", over, "T", R"("44.4 N*m")", R"("44.5 N*m")"},
    {"shaft.set_screw", "u_S", over, "S", "1.5", "1.49"},
    {"shaft.set_screw", "u_t", over, "T", R"("90.6 N*m")", R"("90.8 N*m")", "R_e_1 = \"100 MPa\"\nS_F = 1"},
    {"shaft.set_screw", "x_d", outside, "d", R"("19.1 mm")", R"("19 mm")"},  // a screw of 9.525 mm
    {"shaft.set_screw", "x_h", outside, "F_h", R"("11.7 kN")", R"("11.8 kN")", "set_screw = \nd_s = \"10 mm\""},
    {"shaft.set_screw", "m_R", outside, "h_t", R"("16.6 mm")", R"("16.7 mm")", R"(d_f = "60 mm")"},
    {"shaft.set_screw", "x_R", outside, "d_f", R"("39.1 mm")", R"("39 mm")"},
    {"shaft.circlip", "u_N", over, "R_e", R"("180.1 MPa")", R"("180 MPa")"},
    {"shaft.circlip", "u_R", over, "c", R"("1.36 mm")", R"("1.37 mm")"},
    {"shaft.circlip", "u_n", over, "n", R"("39000 rpm")", R"("39001 rpm")"},
    {"shaft.circlip", "x_t", outside, "d_2", R"("16.57 mm")", R"("16.55 mm")",
     "circlip = \nd_1 = \"18 mm\"\nm = \"1.3 mm\"\nw = \"3 mm\"\nF_R = \"17 kN\"\nn_abl = \"39000 rpm\""},
    {"shaft.circlip", "x_b", outside, "d_bore", R"("16 mm")", R"("16.1 mm")"},
    {"shaft.circlip", "x_w", outside, "w", R"("1.5 mm")", R"("1.49 mm")"},
};

const Side fits[] = {
    {"shaft.press_fit", "u_s", over, "S_r", "2.344", "2.345"},
    {"shaft.press_fit", "x_l", outside, "l", R"("90 mm")", R"("90.1 mm")"},
    {"shaft.press_fit", "u_1", over, "R_e_1", R"("249.5 MPa")", R"("249.4 MPa")"},
    {"shaft.press_fit", "u_2", over, "R_e_2", R"("315.7 MPa")", R"("315.6 MPa")"},
    {"shaft.press_fit", "u_n", over, "n", R"("23505 rpm")", R"("23515 rpm")"},
    {"shaft.press_fit", "m_R", outside, "h_t", R"("24.9 mm")", R"("25.1 mm")", R"(d_f = "120 mm")"},
    {"shaft.press_fit", "u_F", over, "F_adm", R"("104.5 kN")", R"("104.4 kN")", "mu_e = 0.1"},
    {"shaft.press_fit", "u_A", over, "dT_adm", R"("216 K")", R"("215 K")"},
    {"shaft.press_fit", "u_t", over, "T", R"("7158 N*m")", R"("7159 N*m")", "S_F = 1"},
};

const Side twists[] = {
    {"shaft.held", "u_tau", over, "sigma_adm", R"("105.3 MPa")", R"("105.2 MPa")"},
    {"shaft.held", "u_theta", over, "theta_adm", R"("2.263 deg/m")", R"("2.262 deg/m")"},
    {"shaft.held", "u_phi", over, "phi_adm", R"("0.3244 deg")", R"("0.3243 deg")"},
    {"shaft.held", "s_max", outside, "segments", R"([{ l = "1 m", d = "400 mm", d_2 = "48.1 mm" }])",
     R"([{ l = "1 m", d = "400 mm", d_2 = "47.9 mm" }])", "sleeves = "},
    {"section.thin_walled", "u_tau", over, "R_e", R"("79.8 MPa")", R"("79.7 MPa")"},
    {"section.thin_walled", "u_theta", over, "theta_adm", R"("0.1003 deg/m")", R"("0.1002 deg/m")"},
    {"section.thin_walled", "w", outside, "walls", R"([{ cell = "a", l = "400 mm", t = "24.9 mm" }])",
     R"([{ cell = "a", l = "400 mm", t = "25.1 mm" }])", R"(cells = [{ name = "a", A = "1e4 mm^2" }])"},
    {"section.solid_torsion", "u_tau", over, "tau_adm", R"("49.2 MPa")", R"("49.1 MPa")"},
    {"section.solid_torsion", "u_theta", over, "theta_adm", R"("1.93 deg/m")", R"("1.92 deg/m")"},
    {"section.solid_torsion", "e_I", outside, "points",
     R"([["0 mm", "0 mm"], ["30 mm", "0 mm"], ["30 mm", "1 mm"], ["0 mm", "1 mm"]])",
     R"([["0 mm", "0 mm"], ["60 mm", "0 mm"], ["60 mm", "1 mm"], ["0 mm", "1 mm"]])", "T = \"1 N*m\"\ntheta_adm = "},
    {"section.solid_torsion", "e_W", outside, "points",  // a sliver
     R"([["0 mm", "0 mm"], ["100 mm", "0 mm"], ["100 mm", "2 mm"]])",
     R"([["0 mm", "0 mm"], ["100 mm", "0 mm"], ["100 mm", "1 mm"]])", "T = \"1 N*m\"\ntheta_adm = "},
    {"section.thin_walled", "w_s", outside, "walls", R"([{ l = "400 mm", t = "40 mm" }])",
     R"([{ l = "400 mm", t = "40.1 mm" }])", "cells = "},
};

const char* const drawn = "replaceable = \"yes\"\ngamma_M6 = 1";

const Side pins[] = {
    {"pin.joint", "u_b", over, "sigma_adm", R"("54.8 MPa")", R"("54.6 MPa")"},
    {"pin.joint", "u_v", over, "sigma_adm", R"("54.8 MPa")", R"("54.6 MPa")"},
    {"pin.joint", "u_tau", over, "tau_adm", R"("17.1 MPa")", R"("17 MPa")"},
    {"pin.joint", "u_1", over, "p_adm_1", R"("20.2 MPa")", R"("20.1 MPa")"},
    {"pin.joint", "u_2", over, "p_adm_2", R"("18.9 MPa")", R"("18.8 MPa")"},
    {"pin.joint", "u_pv", over, "pv_adm", R"("0.95 MPa*m/s")", R"("0.948 MPa*m/s")", R"(n = "30 rpm")"},
    {"pin.lug", "u_n", over, "sigma_adm", R"("31.3 MPa")", R"("31.2 MPa")"},
    {"pin.lug", "u_s", over, "tau_adm", R"("31.3 MPa")", R"("31.2 MPa")"},
    {"pin.lug", "u_p", over, "p_adm", R"("31.3 MPa")", R"("31.2 MPa")"},
    {"pin.lug", "x_a", outside, "a", R"("20 mm")", R"("19.9 mm")"},
    {"pin.en1993", "u_v", over, "F", R"("659 kN")", R"("660 kN")"},
    {"pin.en1993", "u_m", over, "F", R"("504 kN")", R"("505 kN")"},
    {"pin.en1993", "u_vm", over, "F", R"("400 kN")", R"("401 kN")"},
    {"pin.en1993", "u_b1", over, "F", R"("377 kN")", R"("378 kN")"},
    {"pin.en1993", "u_b2", over, "F", R"("453 kN")", R"("454 kN")"},
    {"pin.en1993", "u_a1", over, "e_a1", R"("48.9 mm")", R"("48.8 mm")"},
    {"pin.en1993", "u_c1", over, "e_c1", R"("31.9 mm")", R"("31.8 mm")"},
    {"pin.en1993", "u_a2", over, "e_a2", R"("46.5 mm")", R"("46.4 mm")"},
    {"pin.en1993", "u_c2", over, "e_c2", R"("29.5 mm")", R"("29.4 mm")"},
    {"pin.en1993", "u_ms", over, "F", R"("376 kN")", R"("377 kN")", drawn},
    {"pin.en1993", "u_s1", over, "F", R"("211 kN")", R"("212 kN")", drawn},
    {"pin.en1993", "u_s2", over, "F", R"("253 kN")", R"("254 kN")", drawn},
    {"pin.en1993", "u_h1", over, "F", R"("352 kN")", R"("353 kN")", drawn},
    {"pin.en1993", "u_h2", over, "F", R"("423 kN")", R"("424 kN")", drawn},
    {"pin.cross", "u_tau", over, "tau_adm", R"("19.9 MPa")", R"("19.8 MPa")"},
    {"pin.cross", "u_1", over, "p_adm_1", R"("23.5 MPa")", R"("23.4 MPa")"},
    {"pin.cross", "u_2", over, "p_adm_2", R"("5.3 MPa")", R"("5.2 MPa")"},
    {"pin.cross", "u_t", over, "tau_adm_1", R"("6.4 MPa")", R"("6.3 MPa")"},
    {"pin.cross", "x_d", outside, "d", R"("9.6 mm")", R"("9.7 mm")"},
};

const Side links[] = {
    {"link.member", "u_y", over, "S", "10.5", "10.6"},
    {"link.member", "x_m", outside, "a_m", R"("886 m/s^2")", R"("888 m/s^2")"},
    {"link.member", "u_Q", over, "S", "15.7", "15.8"},
    {"link.member", "u", over, "n_st", "14.4", "14.5"},
    {"link.member", "u_p", over, "n_st", "14.80", "14.81"},
    {"link.member", "u_i", over, "n_st", "13.540", "13.541"},
    {"link.member", "u_t", over, "n_st", "13.537", "13.538"},
    {"link.member", "r_lambda", over, "lambda_max", "45.1", "45"},
    {"link.member", "r_1", outside, "l", R"("739 mm")", R"("738 mm")", "method = \"euler\"\nsigma_P = \"300 MPa\""},
    {"link.member", "r_class", outside, "R_e", R"("338 MPa")", R"("339 MPa")",
     "h = \nb = \nsection = \"IPE 300\"\nkind = \"rolled_I\""},
    {"link.member", "x_E", outside, "E", R"("179 GPa")", R"("178 GPa")",
     "h = \nb = \nsection = \"HEB 200\"\nkind = \"rolled_I\""},
};

const std::span<const Side> groups[] = {pins, links,   twists, fits,    keys,    vessels, sections,
                                        bars, fatigue, gears,  pulleys, v_belts, motion,  bearings};

std::string lines_at(const Side& row, const char* value) {
  const std::string last = std::string(row.key) + " = " + value;
  return *row.lines == '\0' ? last : std::string(row.lines) + "\n" + last;
}

void check(const Side& row) {
  const std::string what = std::string(row.calculator) + "." + row.field + " by " + row.key;
  INFO(what);
  const auto at = [&](const char* value) {
    const ExampleStep step(row.calculator, lines_at(row, value));
    return step.fault().empty() ? std::string(account::slug(step.verdict(row.field))) : step.fault();
  };
  CHECK(at(row.keeps) == account::slug(State::pass));
  CHECK(at(row.leaves) == account::slug(row.state));
}

}  // namespace

std::vector<Run> loadpath::test::runs_of_limits() {
  std::vector<Run> runs;
  for (const auto& group : groups) {
    for (const Side& row : group) {
      runs.push_back({row.calculator, lines_at(row, row.keeps)});
      runs.push_back({row.calculator, lines_at(row, row.leaves)});
    }
  }
  return runs;
}

TEST_SUITE("limits" * by_element) {
  TEST_CASE("both sides of every limit and check") {
    for (const auto& group : groups) {
      for (const Side& row : group) {
        if (takes_id(row.calculator)) check(row);
      }
    }
  }

  TEST_CASE("no limit and no check of a plain calculator is left out") {
    std::set<std::string> tried;
    for (const auto& group : groups) {
      for (const Side& row : group) tried.insert(std::string(row.calculator) + "." + row.field);
    }
    for (const Calculator* c : calculators()) {
      if (c->evaluate == nullptr) continue;
      for (const FieldInfo& f : c->result->fields) {
        if (f.role != Role::limit && f.role != Role::check) continue;
        const std::string name = std::string(c->id) + "." + f.key;
        CHECK_MESSAGE(tried.count(name) == 1, name,
                      " has no row with both of its sides: add {calculator, field, state ",
                      "beyond, key, value that passes, value that does not} to tests/calculators/limits.cpp");
      }
    }
  }
}
