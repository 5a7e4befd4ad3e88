// How results follow their inputs: what doubles, what grows with a power, what stays, and what only rises or falls.
#include "tests/calculators/rows.hpp"
#include "tests/calculators/step_text.hpp"
#include "tests/parts.hpp"

#include <cmath>
#include <optional>
#include <set>
#include <span>

namespace {

using namespace loadpath;
using namespace loadpath::test;

/// `result` is multiplied by `factor` where the example goes from the first lines to the second.
/// shaft.design with all that its material gives but the moduli.
#define WITHOUT_MATERIAL "material = \nrho = \"7850 kg/m^3\"\nR_e = \"370 MPa\"\nR_m = \"630 MPa\"\n"

/// belt.flat with the motor on a pivoted base.
#define PIVOTED "b = \"100 mm\"\ntensioning = \"pivoted_base\"\nm_m = \"400 kg\"\na_G = \"300 mm\"\nh_P = \"300 mm\"\n"

/// gear.rating by ISO 6336.
#define OF_ISO "standard = \"iso6336\"\nnu_40 = \"150 mm^2/s\"\n"

/// The same under a load spectrum.
#define OF_SPECTRUM OF_ISO "L_h = \"2000 h\"\nblocks = [{ q = 0.4 }, { q = 0.6, k = 0.7, n = \"700 rpm\" }]\n"

struct Law {
  const char* calculator;
  const char* from;
  const char* to;
  const char* result;
  double factor;
};

const Law sections[] = {
    {"section.circle", R"(d = "40 mm")", R"(d = "80 mm")", "I_t", 16},
    {"section.circle", R"(d = "40 mm")", R"(d = "80 mm")", "W_max", 8},
    {"section.ellipse", "", "b = \"80 mm\"\nh = \"40 mm\"", "I_t", 16},
    {"section.ring", "", "d = \"120 mm\"\nt = \"10 mm\"", "I_y", 16},
    {"section.ring", "", "d = \"120 mm\"\nt = \"10 mm\"", "W_t", 8},
    {"section.rectangle", "", "b = \"40 mm\"\nh = \"120 mm\"", "I_t", 16},
    {"section.rectangle", "", R"(h = "120 mm")", "I_y", 8},
    {"section.I", "", "h = \"400 mm\"\nb = \"400 mm\"\nt_w = \"18 mm\"\nt_f = \"30 mm\"\nr = \"36 mm\"", "I_t", 16},
    {"section.channel", "", "h = \"400 mm\"\nb = \"160 mm\"\nt_w = \"12 mm\"\nt_f = \"22 mm\"\nr = \"26 mm\"", "I_z",
     16},
    {"section.angle", "", "h = \"200 mm\"\nb = \"200 mm\"\nt = \"20 mm\"\nr = \"24 mm\"\nr_2 = \"12 mm\"", "I_min", 16},
    {"section.T", "", "h = \"200 mm\"\nb = \"200 mm\"\nt_w = \"11.2 mm\"\nt_f = \"17 mm\"\nr = \"24 mm\"", "z_S", 2},
    {"section.hollow", "", "h = \"200 mm\"\nb = \"200 mm\"\nt = \"10 mm\"\nr_o = \"15 mm\"\nr_i = \"10 mm\"", "I_t",
     16},
    {"section.polygon", "holes = \npoints = [[\"0 mm\", \"0 mm\"], [\"60 mm\", \"0 mm\"], [\"0 mm\", \"90 mm\"]]",
     "holes = \npoints = [[\"0 mm\", \"0 mm\"], [\"120 mm\", \"0 mm\"], [\"0 mm\", \"180 mm\"]]", "I_yz", 16},
    {"section.built_up", R"(parts = [{ shape = "rectangle", b = "20 mm", h = "60 mm", z = "15 mm" }])",
     R"(parts = [{ shape = "rectangle", b = "40 mm", h = "120 mm", z = "30 mm" }])", "I_max", 16},
};

const Law bars[] = {
    {"shaft.torsion", R"(d = "70 mm")", R"(d = "140 mm")", "u_tau", 1.0 / 8},
    {"shaft.torsion", R"(d = "70 mm")", R"(d = "140 mm")", "u_theta", 1.0 / 16},
    {"shaft.torsion", R"(d = "70 mm")", R"(d = "140 mm")", "k_t", 16},
    {"shaft.overhung", R"(d = "40 mm")", "d = \"40 mm\"\nF = \"7308 N\"\nT = \"156.6 N*m\"", "u_v", 2},
    {"shaft.overhung", R"(d = "40 mm")", "d = \"40 mm\"\nF = \"7308 N\"\nT = \"156.6 N*m\"", "u_Q", 2},
    {"shaft.design", "g_angle = ", "g_angle = \nK_A = 2", "M_max", 2},  // weight is not a service load
    {"shaft.design", "", "K_A = 2", "phi", 2},
    {"shaft.design", WITHOUT_MATERIAL "E = \"210 GPa\"\nG = \"81 GPa\"",
     WITHOUT_MATERIAL "E = \"420 GPa\"\nG = \"162 GPa\"", "v_max", 1.0 / 2},
    {"shaft.design", WITHOUT_MATERIAL "E = \"210 GPa\"\nG = \"81 GPa\"",
     WITHOUT_MATERIAL "E = \"840 GPa\"\nG = \"324 GPa\"", "n_c", 2},
    {"shaft.design", WITHOUT_MATERIAL "E = \"210 GPa\"\nG = \"81 GPa\"",
     WITHOUT_MATERIAL "E = \"840 GPa\"\nG = \"324 GPa\"", "n_F", 2},
    {"shaft.design", WITHOUT_MATERIAL "E = \"210 GPa\"\nG = \"81 GPa\"",
     WITHOUT_MATERIAL "E = \"840 GPa\"\nG = \"324 GPa\"", "n_T", 2},
    {"column.buckling", "", R"(l = "1800 mm")", "N_cr", 1.0 / 4},
    {"column.buckling", "", R"(d = "90 mm")", "N_cr", 16},
    {"column.beam_column", "I_t = \"60 cm^4\"\nI_w = \"171100 cm^6\"",
     "I_t = \"60 cm^4\"\nI_w = \"171100 cm^6\"\nM_y_1 = \"120 kN*m\"\nM_y_2 = \"-40 kN*m\"", "u_LT", 2},
    {"column.lightest", "families = [\"HEA\"]\nh_max = \"100 mm\"\nP = \"1 kN\"",
     "families = [\"HEA\"]\nh_max = \"100 mm\"\nP = \"1 kN\"\nl = \"2.25 m\"", "N_cr", 4},
    {"column.stepped", "parts = [{ l = \"2 m\", d = \"100 mm\", P = \"50 kN\" }]\nrho = ",
     "parts = [{ l = \"4 m\", d = \"100 mm\", P = \"50 kN\" }]\nrho = ", "alpha_cr", 1.0 / 4},
    {"column.stepped", "parts = [{ l = \"2 m\", d = \"100 mm\" }]", "parts = [{ l = \"4 m\", d = \"200 mm\" }]",
     "alpha_cr", 1.0 / 2},  // under its weight: q as d^2, E I as d^4, l^3
    {"column.effective_length", "end_1 = \"pinned\"\nc_1 = \nmode = 2", "end_1 = \"pinned\"\nc_1 = \nmode = 6",
     "N_cr_n", 9},
    {"column.effective_length", "", "l = \"2.4 m\"\nc_1 = \"20 kN*m/rad\"", "beta", 1},
    // turned about: the ends change places
    {"column.effective_length", "", "end_1 = \"pinned\"\nc_1 = \nend_2 = \"elastic\"\nc_2 = \"40 kN*m/rad\"", "beta",
     1},
    {"column.effective_length", R"(k_1 = "900 N/mm")",
     "end_1 = \"pinned\"\nc_1 = \nend_2 = \"elastic\"\nc_2 = \"40 kN*m/rad\"\nk_2 = \"900 N/mm\"", "beta", 1},
};

const char* const half_stresses =
    "S = \"175 MPa\"\ntests = [[\"210 MPa\", 38000], [\"210 MPa\", 52000], [\"190 MPa\", 91000], [\"190 MPa\", "
    "127000], "
    "[\"170 MPa\", 262000], [\"170 MPa\", 365000], [\"155 MPa\", 720000], [\"155 MPa\", 980000], "
    "[\"145 MPa\", 10000000, \"runout\"], [\"140 MPa\", 10000000, \"runout\"]]";

const char* const doubled_section = "M_ba = \"1600 N*m\"\nM_tm = \"1800 N*m\"\nM_ta = \"300 N*m\"";

const char* const half_a_cycle = "sigma_max = \"90 MPa\"\nsigma_min = \"-10 MPa\"";
const char* const halved_together = "sigma_m = \"10 MPa\"\nsigma_a = \"30 MPa\"\ntau_m = \"20 MPa\"\ntau_a = \"5 MPa\"";

const Law fatigue[] = {
    {"fatigue.cycle", "", "sigma_max = \"240 MPa\"\nsigma_min = \"-80 MPa\"", "sigma_a", 2},
    {"fatigue.cycle", "", "sigma_max = \"240 MPa\"\nsigma_min = \"-80 MPa\"", "r", 1},
    {"fatigue.endurance", R"(sigma_W = "200 MPa")", R"(sigma_W = "400 MPa")", "sigma_D", 2},
    {"fatigue.life", "", half_a_cycle, "n", 2},
    {"fatigue.life", "", half_a_cycle, "u_D", 0.5},
    {"fatigue.life", "", half_a_cycle, "u_y", 0.5},
    {"fatigue.life", "line = \"slope\"\nk = 5\nN = 10000", "line = \"slope\"\nk = 5\nN = 320000", "S_e", 0.5},
    {"fatigue.combined", "", halved_together, "n_Serensen", 2},
    {"fatigue.combined", "", halved_together, "n_Gerber", 2},
    {"fatigue.combined", "", halved_together, "u_F", 0.5},
    {"fatigue.wohler", "", half_stresses, "S_D", 0.5},
    {"fatigue.wohler", "", half_stresses, "k", 1},
    {"fatigue.wohler", "", half_stresses, "N_P", 1},
    {"fatigue.history", "", "n_req = 2", "u_D", 2},
    {"fatigue.history", "", "K_A = 2", "u_y", 2},
    {"fatigue.history", "mean = \"none\"\nminer = \"elementary\"", "mean = \"none\"\nminer = \"elementary\"\nS_D = 2",
     "D", 32},
    {"fatigue.staircase", "tests = [[\"300 MPa\", \"failure\"], [\"280 MPa\", \"runout\"]]",
     "tests = [[\"150 MPa\", \"failure\"], [\"140 MPa\", \"runout\"]]", "S_50", 0.5},
    {"fatigue.survival", "", "sigma_0 = \"576 MPa\"", "sigma_P", 2},
    {"fatigue.multiaxial", "", "S_D = 3", "u_D", 2},
    {"fatigue.multiaxial", "", "K_A = 2", "u_y", 2},
    {"fatigue.multiaxial", "", "K_A = 2", "n_DV", 0.5},
    {"fatigue.din743", "", doubled_section, "u_D", 2},
    {"fatigue.din743", "", doubled_section, "u_F", 2},
    {"fatigue.din743", "", doubled_section, "S_D", 0.5},
    {"fatigue.din743", "", "f_max = 3.6", "u_F", 2},
    {"fatigue.din743", "", "f_max = 3.6", "u_D", 1},
    {"fatigue.din743", "", "S_min = 2.4", "u_D", 2},
    {"fatigue.din743", "", "S_min = 2.4", "u_F", 2},
    {"fatigue.fkm", "", doubled_section, "u_D", 2},
    {"fatigue.fkm", "", doubled_section, "u_S", 2},
    {"fatigue.fkm", "", doubled_section, "S_D", 0.5},
    {"fatigue.fkm", "", "f_max = 3.6", "u_S", 2},
    {"fatigue.fkm", "", "f_max = 3.6", "u_D", 1},
    {"fatigue.fkm", "", "j_D = 3", "u_D", 2},
    {"fatigue.fkm", "", "j_D = 3", "S_D", 1},
    {"fatigue.fkm", "", "j_m = 4\nj_p = 3", "u_S", 2},
    {"fatigue.fkm", "M_ta = \"0 N*m\"\nN = 1000000", "M_ta = \"0 N*m\"\nN = 31250", "u_D", 0.5},
};

const char* const thick = R"(delta = "10 mm")";
const char* const thick_barrel = R"(delta = "40 mm")";

const Law vessels[] = {
    {"vessel.cylinder", thick, "delta = \"10 mm\"\np = \"3.2 MPa\"", "sigma_o", 2},
    {"vessel.cylinder", "delta = \"10 mm\"\nc = \"0 mm\"", "delta = \"20 mm\"\nc = \"0 mm\"\nR = \"1200 mm\"", "u_v",
     1},
    {"vessel.sphere", "delta = \"30 mm\"", "delta = \"30 mm\"\np = \"1.6 MPa\"", "sigma_M", 2},
    // two equal stresses: both hypotheses are one
    {"vessel.sphere", "delta = \"30 mm\"\nhypothesis = \"tresca\"", "delta = \"30 mm\"\nhypothesis = \"mises\"",
     "sigma_v", 1},
    {"vessel.sphere", "delta = \"30 mm\"\nc = \"0 mm\"", "delta = \"60 mm\"\nc = \"0 mm\"\nR = \"10 m\"", "p_max", 1},
    {"vessel.cone", "delta = \"10 mm\"\nrho = \nh_l = ", "delta = \"10 mm\"\nrho = \nh_l = \np = \"0.2 MPa\"",
     "sigma_o", 2},
    {"vessel.cone", "delta = \"10 mm\"\nrho = \nh_l = ", "delta = \"20 mm\"\nrho = \nh_l = \nR = \"2.4 m\"", "u_v", 1},
    {"vessel.torus", thick, "delta = \"10 mm\"\np = \"5 MPa\"", "sigma_M", 2},
    {"vessel.torus", thick, "delta = \"20 mm\"\nR_0 = \"2 m\"\nr = \"400 mm\"", "u_v", 1},
    {"vessel.ellipsoid", thick, "delta = \"10 mm\"\np = \"1.2 MPa\"", "sigma_v", 2},
    {"vessel.ellipsoid", thick, "delta = \"20 mm\"\na = \"1200 mm\"\nb = \"600 mm\"", "u_v", 1},
    {"vessel.shell", thick, "delta = \"10 mm\"\np = \"1.2 MPa\"", "sigma_v", 2},
    {"vessel.end", "delta = \"12 mm\"", "delta = \"12 mm\"\np = \"2 MPa\"", "u_y", 2},
    {"vessel.end", "delta = \"12 mm\"\nc = \"0 mm\"", "delta = \"24 mm\"\nc = \"0 mm\"\nD_i = \"3960 mm\"", "u_b", 1},
    {"vessel.end", "delta = \"12 mm\"\np_t = \"1 MPa\"\nh_t = \"0 mm\"",
     "delta = \"12 mm\"\np_t = \"2 MPa\"\nh_t = \"0 mm\"", "u_tr", 0.5},
    {"vessel.cylinder", "delta = \"10 mm\"\np_t = \"1 MPa\"\nh_t = \"0 mm\"\nR_e_t = \"300 MPa\"",
     "delta = \"10 mm\"\np_t = \"2 MPa\"\nh_t = \"0 mm\"\nR_e_t = \"300 MPa\"", "u_t", 2},
    {"vessel.flat_end", "delta = \"40 mm\"", "delta = \"40 mm\"\np = \"2 MPa\"", "u_e", 2},
    {"vessel.flat_end", "delta = \"40 mm\"\nc = \"0 mm\"", "delta = \"80 mm\"\nc = \"0 mm\"\nD_i = \"1200 mm\"",
     "p_max", 1},
    {"vessel.flat_end", "delta = \"40 mm\"\nc = \"0 mm\"", "delta = \"80 mm\"\nc = \"0 mm\"", "p_max", 4},
    {"vessel.thick", thick_barrel, "delta = \"40 mm\"\np = \"80 MPa\"", "sigma_ti", 2},
    {"vessel.thick", thick_barrel, "delta = \"80 mm\"\nR = \"160 mm\"", "w_a", 2},
    {"vessel.thick", thick_barrel, "delta = \"80 mm\"\nR = \"160 mm\"", "p_pl", 1},
    {"vessel.thick_sphere", thick_barrel, "delta = \"40 mm\"\np = \"180 MPa\"", "sigma_ti", 2},
    {"vessel.thick_sphere", thick_barrel, "delta = \"80 mm\"\nR = \"200 mm\"", "w_i", 2},
    {"vessel.thick_sphere", thick_barrel, "delta = \"80 mm\"\nR = \"200 mm\"", "p_pl", 1},
    {"vessel.compound", "", "p = \"500 MPa\"\nU_min = \"480 um\"\nU_max = \"560 um\"", "sigma_v1", 2},
    {"vessel.compound", "", "p = \"500 MPa\"\nU_min = \"480 um\"\nU_max = \"560 um\"", "sigma_v2", 2},
    {"vessel.compound", "", "d_i = \"200 mm\"\nd = \"400 mm\"\nD = \"800 mm\"\nU_min = \"480 um\"\nU_max = \"560 um\"",
     "u_2", 1},
    {"vessel.autofrettage", "", "p = \"600 MPa\"\nR_e = \"1700 MPa\"", "sigma_ri", 2},
    {"vessel.autofrettage", "", "R_i = \"100 mm\"\nR_a = \"200 mm\"\nr_p = \"140 mm\"", "p_A", 1},
    {"vessel.external", "delta = \"8 mm\"\nc = \"0 mm\"",
     "delta = \"16 mm\"\nc = \"0 mm\"\nD_a = \"2400 mm\"\nL = \"4800 mm\"", "p_cr", 1},
    {"vessel.external", "delta = \"8 mm\"\nc = \"0 mm\"",
     "delta = \"16 mm\"\nc = \"0 mm\"\nD_a = \"2400 mm\"\nL = \"4800 mm\"", "p_a", 1},
};

const Law drives[] = {
    {"gear.sizing", "", "rho = \"15700 kg/m^3\"", "mass", 2},
    {"gear.rating", "", "S_Hmin = 2.2", "u_H1", 2},
    {"gear.rating", "", "S_Hmin = 2.2", "u_H2", 2},
    {"gear.rating", "", "S_Fmin = 2.8", "u_F1", 2},
    {"gear.rating", "", "S_Fmin = 2.8", "u_F2", 2},
    {"gear.rating", "place = \nf_sh_1 = \"7 um\"", "place = \nf_sh_1 = \"9 um\"\nf_sh_2 = \"5 um\"", "f_sh", 2},
    {"gear.rating", OF_ISO "place = \nf_sh_1 = \"7 um\"", OF_ISO "place = \nf_sh_1 = \"14 um\"", "f_sh", 2},
    {"gear.rating", "", OF_ISO, "sigma_H0", 1},  // spur gears
    {"gear.rating", OF_ISO, OF_ISO "T_1 = \"800 N*m\"", "c_prime", 1},
    {"gear.rating", OF_ISO, OF_ISO "T_1 = \"800 N*m\"", "B_p", 0.5},
    {"gear.rating", OF_ISO "T_1 = \"1 N*m\"", OF_ISO "T_1 = \"16 N*m\"", "c_prime", 2},  // the fourth root
    {"gear.rating", OF_ISO "T_1 = \"1 N*m\"", OF_ISO "T_1 = \"16 N*m\"", "B_f", 0.125},
    {"gear.rating", OF_ISO, OF_ISO "n_1 = \"1960 rpm\"", "N_res", 2},
    {"gear.rating", OF_ISO, OF_ISO "S_Fmin = 2.8", "u_F1", 2},
    {"gear.rating", OF_ISO, OF_ISO "R_z1 = \"10 um\"\nR_z2 = \"10 um\"", "Z_R", std::pow(0.5, 0.08)},
    {"gear.rating", OF_ISO "L_h = \"10000 h\"", OF_ISO "n_1 = \"490 rpm\"\nL_h = \"20000 h\"", "Z_NT2", 1},
    {"gear.rating", OF_SPECTRUM, OF_SPECTRUM "T_1 = \"800 N*m\"", "T_F2", 2},
    {"gear.rating", OF_SPECTRUM "S_Hmin = 1.5", OF_SPECTRUM "S_Hmin = 1.5\nq_1 = 2", "D_H1", 2},
    {"gear.bevel", "", R"(P = "10 kW")", "F_a1", 2},
    {"gear.bevel", "", R"(P = "20 kW")", "s_c", 2},
    {"gear.bevel", "", R"(P = "10 kW")", "s_t1", 2},
    {"gear.bevel", "", "m_et = \"8 mm\"\nb = \"56 mm\"", "R_m", 2},
    {"gear.bevel", "", "m_et = \"8 mm\"\nb = \"56 mm\"", "eps_v", 1},
    {"gear.bevel", "", "S_Hmin = 2.2", "u_H1", 2},
    {"gear.bevel", "", "S_Fmin = 3", "u_F2", 2},
    {"gear.worm", "", R"(P = "1.2 kW")", "F_r", 2},
    {"gear.worm", "", R"(P = "1.2 kW")", "u_W", 2},
    {"gear.worm", "", R"(P = "1.2 kW")", "u_T", 2},
    {"gear.worm", "", R"(dT_adm = "30 K")", "u_T", 2},
    {"gear.worm", "mu = 0.05", "mu = 0.05\nm_x = \"8 mm\"\nd_1 = \"80 mm\"", "eta", 1},
    {"gear.worm", "mu = 0.05", "mu = 0.05\nm_x = \"8 mm\"\nd_1 = \"80 mm\"", "F_t2", 0.5},
    {"gear.crossed", "", R"(P = "0.5 kW")", "F_a1", 2},
    {"gear.crossed", "", R"(P = "0.5 kW")", "u_C", 2},
    {"gear.crossed", "", R"(C_adm = "4 MPa")", "u_C", 0.5},
    {"gear.crossed", "", "m_n = \"4 mm\"\nb_1 = \"40 mm\"\nb_2 = \"40 mm\"", "a", 2},
    {"gear.crossed", "", "m_n = \"4 mm\"\nb_1 = \"40 mm\"\nb_2 = \"40 mm\"", "eps_n", 1},
    {"gear.crossed", "", "m_n = \"4 mm\"\nb_1 = \"40 mm\"\nb_2 = \"40 mm\"", "C", 0.125},
    {"gear.crossed", "", R"(n_1 = "2000 rpm")", "v_s", 2},
    {"gear.pair", "", "m_n = \"5 mm\"\na_w = \"200 mm\"\nb = \"56 mm\"\nT_1 = \"480 N*m\"", "F_t", 4},
    {"gear.pair", "", "m_n = \"5 mm\"\na_w = \"200 mm\"\nb = \"56 mm\"\nT_1 = \"480 N*m\"", "eps_gamma", 1},
    {"gear.pair", "cutting = ", "cutting = \nm_n = \"5 mm\"\na_w = \"200 mm\"\nb = \"56 mm\"\nT_1 = \"480 N*m\"",
     "u_F1", 1},
    {"gear.cycloidal", "", "m = \"4 mm\"\nd_p = \"6 mm\"", "d_a2", 2},
    {"gear.cycloidal", "", "m = \"4 mm\"\nd_p = \"6 mm\"", "eps", 1},
    {"gear.planetary", "", R"(T_s = "100 N*m")", "T_c", 2},
    {"gear.planetary", "", R"(n_s = "2900 rpm")", "n_p", 2},
    {"chain.roller", "", R"(P = "6 kW")", "F_t", 2},
    {"chain.roller", "", R"(n_1 = "192 rpm")", "F_c", 4},
    {"chain.inverted_tooth", "", R"(P = "30 kW")", "b_min", 2},
    {"chain.inverted_tooth", "", R"(n_1 = "2000 rpm")", "F_c", 4},
    {"drive.train", "", R"(P = "11 kW")", "T_out", 2},
    {"drive.train", "", R"(n_1 = "2900 rpm")", "T_out", 0.5},
    {"drive.friction_wheels", "", R"(P = "3 kW")", "F_p", 2},
    {"drive.friction_wheels", "", "d_1 = \"400 mm\"\nd_2 = \"1200 mm\"", "q", 0.5},
    {"drive.friction_wheels", "E_1 = \"100 GPa\"\nE_2 = \"100 GPa\"",
     "E_1 = \"100 GPa\"\nE_2 = \"100 GPa\"\nP = \"6 kW\"", "p_H", 2},
    {"drive.friction_wheels", "E_1 = \"100 GPa\"\nE_2 = \"100 GPa\"", "E_1 = \"400 GPa\"\nE_2 = \"400 GPa\"", "b_H",
     0.5},
    {"belt.course", "", R"(n_1 = "2900 rpm")", "F_c", 4},
    {"belt.flat", R"(b = "100 mm")", "b = \"100 mm\"\nd_1 = \"400 mm\"\nd_2 = \"1000 mm\"\na = \"2400 mm\"", "L", 2},
    {"belt.flat", R"(b = "100 mm")", "b = \"100 mm\"\nn_1 = \"2900 rpm\"", "F_c", 4},
    {"belt.flat", PIVOTED, PIVOTED "m_m = \"800 kg\"", "S_0", 2},
    {"belt.flat", PIVOTED, PIVOTED "P = \"30 kW\"", "m_min", 2},
    {"belt.flat", "b = \"100 mm\"\nsigma_f = \"9 MPa\"\nm_f = 6",
     "b = \"100 mm\"\nsigma_f = \"9 MPa\"\nm_f = 6\nN_f = 2e7", "L_h", 2},
    {"belt.grooved", "z = 2", "z = 2\nP = \"300 W\"", "F_t", 2},
    {"belt.grooved", "", R"(n_1 = "2800 rpm")", "F_c", 4},
    {"belt.synchronous", "", R"(P = "8 kW")", "u_P", 2},
    {"belt.synchronous", "", R"(n_1 = "2900 rpm")", "F_c", 4},
    {"belt.v", "z = 4", "z = 4\nP = \"60 kW\"", "u_P", 2},
    {"belt.v", "L = \na = \"800 mm\"", "L = \nd_1 = \"400 mm\"\nd_2 = \"800 mm\"\na = \"1600 mm\"", "L", 2},
    {"belt.v_sizing", "", "P = \"13.2 kW\"\nK_A = 1", "u_P", 1},
};

const Law motion[] = {
    {"motion.point", "", "x = \"6 m*sin(pi*t/(1 s))\"\ny = \"10 m*cos(pi*t/(1 s))\"", "a", 2},
    {"motion.point", "", "x = \"6 m*sin(pi*t/(1 s))\"\ny = \"10 m*cos(pi*t/(1 s))\"", "kappa", 0.5},
    {"motion.point", "", "x = \"6 m*sin(pi*t/(1 s))\"\ny = \"10 m*cos(pi*t/(1 s))\"", "x_max", 2},
    {"motion.along_path", "", "S = \"40 m/s*t - 4 m/s^2*t^2\"\nt = \"2 s\"", "a_n", 4},
    {"motion.along_path", "", "S = \"40 m/s*t - 4 m/s^2*t^2\"\nt = \"2 s\"", "kappa", 1},
    {"motion.rotation", "", R"(phi = "180 deg*(t/(1 s))^2")", "a_n", 4},
    {"motion.plane", "", R"(v_A = "1.2 m/s")", "omega", 2},
    {"motion.plane", "", R"(v_A = "1.2 m/s")", "PA", 1},
    {"motion.compound", "", "v_xi = \"4 m/s\"\na_xi = \"12 m/s^2\"\nomega = \"6 rad/s\"\nepsilon = \"8 rad/s^2\"", "a",
     4},
    {"motion.spatial", "", R"(zeta = "24 m")", "a", 2},
    {"motion.spatial", "", "psi = \"0.6*t/(1 s)\"\ntheta = \"60 deg - 1*t/(1 s)\"", "epsilon", 4},
    {"motion.universal_joint", "", R"(n_1 = "3000 rpm")", "epsilon_max", 4},
    {"motion.universal_joint", "", R"(J_2 = "0.24 kg*m^2")", "M_J", 2},
    {"motion.spherical_four_bar", "", R"(n_1 = "600 rpm")", "omega_2", 2},
    {"motion.spherical_four_bar", "", R"(n_1 = "600 rpm")", "epsilon_4", 4},
    {"motion.spherical_four_bar", "", R"(n_1 = "600 rpm")", "epsilon_2", 4},
    {"motion.spherical_four_bar", "", R"(M_4 = "20 N*m")", "M_1max", 2},
    {"dynamics.force", "", R"(m = "4 kg")", "P", 2},
    {"dynamics.motion", "F_x = \"10 N\"\nF_y = \nuntil = \nt_2 = \"2 s\"",
     "F_x = \"20 N\"\nF_y = \nuntil = \nt_2 = \"2 s\"", "F_max", 2},
    {"dynamics.motion", "F_x = \"0 N\"\nF_y = \"-g*0.145 kg\"",
     "F_x = \"0 N\"\nF_y = \"-g*0.145 kg\"\nv_x0 = \"60 m/s\"\nv_y0 = \"40 m/s\"", "x_E", 4},
    {"dynamics.throw", "", R"(V_0 = "40 m/s")", "L", 4},
    {"dynamics.throw", "", R"(V_0 = "40 m/s")", "t_L", 2},
    {"dynamics.impulse", "v_1x = \"0 m/s\"", "m = \"6 kg\"\nv_1x = \"0 m/s\"", "v_2x", 0.5},
    {"dynamics.mass_centre", "", R"(bodies = [{ m = "200 kg" }, { m = "140 kg", s = "2 m" }])", "Delta_x", 1},
    {"dynamics.mass_centre", "", R"(bodies = [{ m = "100 kg" }, { m = "70 kg", s = "6 m" }])", "Delta_x", 3},
    {"dynamics.inertia", "parts = [{ shape = \"sphere\", D = \"100 mm\" }]",
     "parts = [{ shape = \"sphere\", D = \"200 mm\" }]", "J", 32},
    {"dynamics.inertia", "", R"(rho = "14400 kg/m^3")", "J", 2},
    {"dynamics.inertia", "", R"(rho = "14400 kg/m^3")", "i", 1},
    {"dynamics.momentum", "",
     R"(bodies = [{ m = "5 kg", v_1 = "8 m/s" }, { m = "1 kg", v_1 = "8 m/s", v_2 = "60 m/s" }])", "Delta_E", 4},
    {"dynamics.angular_momentum", "",
     R"(parts = [{ m = "0.2 kg", R_1 = "400 mm", R_2 = "100 mm", omega_1 = "120 rpm" }])", "omega_2", 4},
    {"dynamics.work", "", R"(m = "5 kg")", "v_2", 1},
    {"dynamics.work", "", R"(s = "8 m")", "v_2", 2},
    {"dynamics.path_work", "", "F_x = \"-1 N/m*x\"\nF_y = \"-1 N/m*y\"\nF_z = \"0.5 N\"", "A", 2},
    {"dynamics.path_work", "F_x = \"1 N*v_x/v\"\nF_y = \nF_z = ",
     "x = \"2 m*cos(t/(1 s))\"\ny = \"2 m*sin(t/(1 s))\"\nz = \"2 m/s*t\"\nF_x = \"1 N*v_x/v\"\nF_y = \nF_z = ", "A_x",
     2},
    {"dynamics.lift", "", R"(s = "4.8 m")", "v", 2},
    {"machine.flywheel", "", "M_of_phi = \"40 kN*m + 19 kN*m*sin(2*phi) - 11.4 kN*m*cos(2*phi)\"", "J_F", 2},
    {"machine.flywheel", "", R"(omega = "360 rpm")", "J_F", 0.25},
    {"machine.disc", "", R"(n = "12000 rpm")", "sigma_ti", 4},
    {"machine.disc", "", "D = \"1000 mm\"\nd_i = \"200 mm\"\nb = \"80 mm\"", "sigma_rm", 4},
    {"machine.disc", "", "D = \"1000 mm\"\nd_i = \"200 mm\"\nb = \"80 mm\"", "J_z", 32},
    {"machine.run_up", "", R"(parts = [{ J = "0.1 kg*m^2" }, { J = "7.2 kg*m^2", u = 0.5 }])", "t", 2},
    {"machine.motion", "J_of_phi = \npoints = \nM = \"20 N*m\"", "J_of_phi = \npoints = \nM = \"40 N*m\"", "A_L", 2},
    {"machine.motion", "", R"(M_K = "84 N*m")", "M_start", 2},
    {"machine.run_up", "load = ",
     "load = \nmotor = [[\"0 rpm\", \"90 N*m\"], [\"1000 rpm\", \"120 N*m\"], [\"1400 rpm\", \"80 N*m\"]]", "t", 0.5},
};

const char* const radial = "f_0 = \nF_a = ";
const char* const pair =
    "f_0 = \nkind = \"tapered_roller\"\ne = 0.37\nY = 1.6\nY_0 = 0.9\ncarries = \"left\"\n"
    "mate = { F_r = \"6 kN\", Y = 1.4 }";
const char* const pair_of_double_load =
    "f_0 = \nkind = \"tapered_roller\"\ne = 0.37\nY = 1.6\nY_0 = 0.9\ncarries = \"left\"\nF_r = \"5 kN\"\n"
    "F_a = \"2 kN\"\nmate = { F_r = \"12 kN\", Y = 1.4 }";

const Law bearings[] = {
    {"bearing.rolling", radial, "f_0 = \nF_a = \nF_r = \"1.25 kN\"", "L_10", 8},
    {"bearing.rolling", "", R"(n = "1800 rpm")", "L_10h", 0.5},
    {"bearing.rolling", radial, "f_0 = \nF_a = \nK_A = 2", "C_req", 2},
    {"bearing.rolling", "", R"(C = "58.2 kN")", "L_nh", 8},
    {"bearing.rolling", pair, pair_of_double_load, "F_ax", 2},
};

const Law keys[] = {
    {"shaft.key", "", R"(T = "900 N*m")", "p_2", 2},
    {"shaft.key", "", "i = 2", "p_1", 1 / 1.5},
    {"shaft.key", "", "K_A = 2.5", "F_t", 2},
    {"shaft.key", "", "f_W = 0.5\ntorque = \"reversing\"", "u_2", 1},
    {"shaft.spline", "", R"(T = "1280 N*m")", "p", 2},
    {"shaft.spline", "", R"(l = "25 mm")", "p", 2},
    {"shaft.spline", "", "centring = \"flanks\"", "p", 0.75 / 0.9},
    {"shaft.spline", "", "k_l = 1.5", "tau", 1.5},
    {"shaft.spline", "spline = \nz = 8\nd_1 = \"52 mm\"\nd_2 = \"60 mm\"\nb = \"10 mm\"",
     "spline = \nz = 8\nd_1 = \"52 mm\"\nd_2 = \"60 mm\"\nb = \"5 mm\"", "tau", 2},
    {"shaft.spline", "", "f_W = 0.5\ntorque = \"reversing\"", "u_2", 1},
    {"shaft.set_screw", "", R"(d = "40 mm")", "T_h", 2},
    {"shaft.set_screw", "", R"(T = "16 N*m")", "u", 2},
    {"shaft.set_screw", "", "point = \"oval\"", "F_zul", 0.9},
    {"shaft.set_screw", "", "i = 2\nphi = 0.9", "F_zul", 1.8},
    {"shaft.circlip", "", R"(F_a = "4.4 kN")", "u_N", 2},
    {"shaft.circlip", "", R"(R_e = "680 MPa")", "F_N", 2},
    {"shaft.circlip", "", "q = 2.4", "F_N", 0.5},
    {"shaft.circlip", "", R"(c = "2 mm")", "F_ring", 0.5},
    {"shaft.key", "key = \nb = \"14 mm\"\nh = \"9 mm\"\nt_1 = \"5.5 mm\"",
     "key = \nb = \"28 mm\"\nh = \"18 mm\"\nt_1 = \"11 mm\"\nd = \"100 mm\"\nl = \"140 mm\"", "tau", 1.0 / 8},
};

const Law pins[] = {
    {"pin.joint", "", R"(F = "-29 kN")", "sigma_b", 2},
    {"pin.joint", "", "K_A = 2.5", "tau", 2},
    {"pin.joint", "", "d = \"60 mm\"\nt_1 = \"60 mm\"\nt_2 = \"32 mm\"\nc = \"1 mm\"", "sigma_v", 1.0 / 4},
    {"pin.joint", R"(held = "one_side")", "held = \"one_side\"\nd = \"60 mm\"", "p_2", 1.0 / 2},
    {"pin.joint", R"(n = "30 rpm")", R"(n = "-60 rpm")", "pv", 2},
    {"pin.lug", "", R"(t = "80 mm")", "sigma_n", 1.0 / 2},
    {"pin.lug", "", "K_A = 2", "tau_s", 2},
    {"pin.en1993", "", "gamma_F = 2.8", "u_vm", 2},
    {"pin.en1993", "", "d = \"100 mm\"\nd_0 = \"102 mm\"", "M_Rd", 8},
    {"pin.cross", "", R"(T = "-64 N*m")", "p_1", 2},
    {"pin.cross", "", "d = \"16 mm\"\nd_w = \"64 mm\"\nD = \"128 mm\"", "tau", 1.0 / 8},
    {"link.member", "", R"(M_b = "-120 N*m")", "sigma_M", 2},
    {"link.member", "", "S = 3", "u_y", 2},
    {"link.member", "", R"(V = "-0.8 kN")", "tau", 2},
};

const char* const smooth = "Rz_1 = \"0 um\"\nRz_2 = \"0 um\"";

const Law fits[] = {
    {"shaft.press_fit", smooth, "Rz_1 = \"0 um\"\nRz_2 = \"0 um\"\nU_min = \"82 um\"", "p_min", 2},
    {"shaft.press_fit", "n = \"3000 rpm\"", "n = \"-6000 rpm\"", "U_n", 4},
    {"shaft.press_fit", "", "mu = 0.28", "T_slip", 2},
    {"shaft.press_fit", "", R"(T = "1200 N*m")", "F_res", 2},
    {"shaft.press_fit", smooth,
     "Rz_1 = \"0 um\"\nRz_2 = \"0 um\"\nd = \"120 mm\"\nd_i = \"40 mm\"\nD = \"220 mm\"\nl = \"120 mm\"\nU_min = \"82 "
     "um\"\nU_max = \"180 um\"",
     "F_slip", 4},
};

const char* const free_bar = "end_2 = \"free\"\nc_2 = \nsleeves = ";

const Law twists[] = {
    {"shaft.held", "", "K_A = 2", "R_1", 2},
    {"shaft.held", "", "K_A = 2", "phi_max", 2},
    {"shaft.held", free_bar, "end_2 = \"free\"\nc_2 = \nsleeves = \nG = \"160 GPa\"", "phi_2", 1.0 / 2},
    {"shaft.held", free_bar,
     "end_2 = \"free\"\nc_2 = \nsleeves = \nsegments = [{ l = \"300 mm\", d = \"120 mm\" }, { l = \"200 mm\", d = "
     "\"120 "
     "mm\", d_2 = \"80 mm\" }, { l = \"400 mm\", d = \"80 mm\", d_bore = \"40 mm\", m = \"150 N*m/m\" }]",
     "phi_2", 1.0 / 16},
    {"shaft.held", free_bar,
     "end_2 = \"free\"\nc_2 = \nsleeves = \nsegments = [{ l = \"300 mm\", d = \"120 mm\" }, { l = \"200 mm\", d = "
     "\"120 "
     "mm\", d_2 = \"80 mm\" }, { l = \"400 mm\", d = \"80 mm\", d_bore = \"40 mm\", m = \"150 N*m/m\" }]",
     "u_tau", 1.0 / 8},
    {"section.thin_walled", "", "T = \"36 kN*m\"", "tau_max", 2},
    {"section.thin_walled", "", "G = \"160 GPa\"", "theta", 1.0 / 2},
    {"section.thin_walled", "cells = \nwalls = [{ l = \"100 mm\", t = \"3 mm\" }]",
     "cells = \nwalls = [{ l = \"100 mm\", t = \"6 mm\" }]", "I_t", 8},
    {"section.thin_walled",
     "cells = [{ name = \"a\", A = \"1e4 mm^2\" }]\nwalls = [{ cell = \"a\", l = \"400 mm\", t = \"3 mm\" }]",
     "cells = [{ name = \"a\", A = \"4e4 mm^2\" }]\nwalls = [{ cell = \"a\", l = \"800 mm\", t = \"6 mm\" }]", "W_t",
     8},
};

const char* const small_triangle = "points = [[\"0 mm\", \"0 mm\"], [\"30 mm\", \"0 mm\"], [\"10 mm\", \"20 mm\"]]";
const char* const large_triangle = "points = [[\"5 mm\", \"9 mm\"], [\"65 mm\", \"9 mm\"], [\"25 mm\", \"49 mm\"]]";

const Law solids[] = {
    {"section.solid_torsion", small_triangle, large_triangle, "I_t", 16},
    {"section.solid_torsion", small_triangle, large_triangle, "W_t", 8},
    {"section.solid_torsion", "", "K_A = 2", "theta", 2},
};

const std::span<const Law> laws[] = {pins, solids,  twists,  fits,   keys,   sections,
                                     bars, fatigue, vessels, drives, motion, bearings};

/// Trend of `result` over the values of a key, one after the other.
enum class Sense { rises, falls };
using enum Sense;
struct Trend {
  const char* calculator;
  const char* result;
  Sense sense;
  const char* key;
  std::vector<const char*> values;
  const char* lines = "";
};

const Trend trends[] = {
    {"section.ring", "I_t", rises, "t", {R"("2 mm")", R"("5 mm")", R"("10 mm")", R"("20 mm")", R"("29 mm")"}},
    {"section.built_up",
     "i_min",
     rises,
     "parts",
     {R"([{ section = "UPN 200", y = "10 mm" }, { section = "UPN 200", y = "-10 mm", angle = "180 deg" }])",
      R"([{ section = "UPN 200", y = "30 mm" }, { section = "UPN 200", y = "-30 mm", angle = "180 deg" }])",
      R"([{ section = "UPN 200", y = "50 mm" }, { section = "UPN 200", y = "-50 mm", angle = "180 deg" }])"}},
    {"shaft.torsion",
     "tau_max",
     rises,
     "d_bore",
     {R"("0 mm")", R"("20 mm")", R"("40 mm")", R"("60 mm")"},
     R"(d = "70 mm")"},
    {"column.buckling", "sigma_cr", falls, "l", {R"("500 mm")", R"("700 mm")", R"("900 mm")", R"("1200 mm")"}},
    {"column.beam_column", "u_z", rises, "M_z", {R"("0 kN*m")", R"("2 kN*m")", R"("5 kN*m")", R"("40 kN*m")"}},
    {"column.stepped", "alpha_cr", falls, "rho", {R"("100 kg/m^3")", R"("2700 kg/m^3")", R"("7850 kg/m^3")"}},
    {"column.effective_length",
     "beta",
     falls,
     "c_1",
     {R"("0 N*m/rad")", R"("10 kN*m/rad")", R"("40 kN*m/rad")", R"("10 MN*m/rad")"}},
    {"vessel.cone",
     "sigma_o",
     rises,
     "alpha",
     {R"("10 deg")", R"("30 deg")", R"("45 deg")", R"("60 deg")"},
     "delta = \"8 mm\"\nrho = \nh_l = "},
    {"vessel.torus",
     "sigma_M",
     falls,
     "R_0",
     {R"("0.4 m")", R"("0.6 m")", R"("1 m")", R"("10 m")"},
     R"(delta = "8 mm")"},
    {"vessel.ellipsoid",
     "u_v",
     falls,
     "b",
     {R"("200 mm")", R"("300 mm")", R"("400 mm")", R"("600 mm")"},
     R"(delta = "8 mm")"},
    {"vessel.sphere", "delta_min", falls, "z_l", {"0.7", "0.8", "0.9", "1"}, "delta = \"30 mm\"\nz_c = 1"},
    {"vessel.end", "u_y", falls, "delta", {R"("6 mm")", R"("12 mm")", R"("20 mm")", R"("60 mm")"}},
    {"vessel.compound", "sigma_v1", falls, "U_min", {R"("160 um")", R"("200 um")", R"("240 um")", R"("280 um")"}},
    {"vessel.autofrettage", "sigma_ri", falls, "r_p", {R"("55 mm")", R"("65 mm")", R"("80 mm")", R"("95 mm")"}},
    {"vessel.external", "p_a", falls, "L", {R"("0.6 m")", R"("1.2 m")", R"("6 m")", R"("30 m")"}, "delta = \"8 mm\""},
    {"vessel.thick_sphere", "u_v", falls, "delta", {R"("20 mm")", R"("40 mm")", R"("80 mm")", R"("200 mm")"}},
    {"vessel.thick", "u_v", falls, "delta", {R"("20 mm")", R"("40 mm")", R"("80 mm")", R"("200 mm")"}},
    {"vessel.shell", "p_max", rises, "delta", {R"("4 mm")", R"("6 mm")", R"("8 mm")", R"("10 mm")"}},
    {"fatigue.endurance", "sigma_D", falls, "K_t", {"1.01", "1.2", "1.65", "2.5"}},
    {"fatigue.endurance", "sigma_D", falls, "R_z", {R"("1.6 um")", R"("6.3 um")", R"("25 um")", R"("100 um")"}},
    {"fatigue.endurance", "sigma_D", falls, "d", {R"("10 mm")", R"("30 mm")", R"("60 mm")", R"("140 mm")"}},
    {"fatigue.endurance",
     "sigma_D",
     falls,
     "P_s",
     {"0.5", "0.9", "0.99", "0.9999"},
     "school = \"marin\"\nR_z = \nfinish = \"ground\""},
    {"fatigue.endurance",
     "sigma_D",
     falls,
     "T",
     {R"("300 degC")", R"("400 degC")", R"("500 degC")"},
     "school = \"marin\"\nR_z = \nfinish = \"ground\""},
    {"fatigue.life", "N_f", falls, "sigma_max", {R"("320 MPa")", R"("360 MPa")", R"("420 MPa")"}},
    {"fatigue.life", "n", falls, "K_m", {"1", "1.5", "2.5"}},
    {"fatigue.combined", "n_Serensen", rises, "K_sigma", {"1", "1.5", "2.5"}},
    {"fatigue.combined", "n_Serensen", falls, "psi_tau", {"0.05", "0.1", "0.5"}},
    {"fatigue.wohler", "N_P", falls, "P_s", {"0.5", "0.7", "0.9", "0.95"}},
    {"fatigue.wohler", "N_50", falls, "S", {R"("310 MPa")", R"("340 MPa")", R"("380 MPa")", R"("420 MPa")"}},
    {"fatigue.history", "D", falls, "sigma_D", {R"("100 MPa")", R"("120 MPa")", R"("150 MPa")", R"("175 MPa")"}},
    {"fatigue.history", "D", falls, "R_m", {R"("500 MPa")", R"("600 MPa")", R"("800 MPa")", R"("1200 MPa")"}},
    {"fatigue.din743", "S_D", falls, "R_z", {R"("1.6 um")", R"("6.3 um")", R"("25 um")", R"("100 um")"}},
    {"fatigue.din743", "S_D", falls, "d_h", {R"("50 mm")", R"("60 mm")", R"("100 mm")", R"("250 mm")"}},
    {"fatigue.din743", "S_D", falls, "M_tm", {R"("0 N*m")", R"("500 N*m")", R"("1500 N*m")", R"("4000 N*m")"}},
    {"fatigue.din743", "S_D", rises, "r", {R"("0.5 mm")", R"("1 mm")", R"("2.5 mm")", R"("4 mm")"}},
    {"fatigue.din743", "S_D", rises, "K_V", {"1", "1.1", "1.3", "1.6"}},
    {"fatigue.din743", "S_F", rises, "d", {R"("36 mm")", R"("40 mm")", R"("42 mm")", R"("46 mm")"}},
    {"fatigue.fkm", "S_D", falls, "R_z", {R"("1.6 um")", R"("6.3 um")", R"("25 um")", R"("100 um")"}},
    {"fatigue.fkm", "S_D", falls, "d_h", {R"("50 mm")", R"("60 mm")", R"("100 mm")", R"("250 mm")"}},
    {"fatigue.fkm", "S_D", falls, "M_tm", {R"("0 N*m")", R"("500 N*m")", R"("1500 N*m")", R"("4000 N*m")"}},
    {"fatigue.fkm", "S_D", falls, "N", {"10000", "100000", "1000000"}},
    {"fatigue.fkm", "S_D", rises, "r", {R"("0.5 mm")", R"("1 mm")", R"("2.5 mm")", R"("4 mm")"}},
    {"fatigue.fkm", "S_D", rises, "K_V", {"1", "1.1", "1.3", "1.6"}},
    {"fatigue.fkm", "S_D", rises, "K_an", {"0.8", "0.9", "1"}},
    {"fatigue.fkm", "u_S", falls, "R_pmax", {R"("600 MPa")", R"("1050 MPa")", R"("2000 MPa")"}},
    {"gear.pair", "eps_gamma", rises, "beta", {R"("0 deg")", R"("8 deg")", R"("16 deg")"}, "a_w = \nx_1 = 0"},
    {"gear.pair", "x_free", rises, "z_1", {"10", "14", "17", "30"}, "a_w = \nx_1 = 0"},
    {"gear.bevel", "delta_1", rises, "Sigma", {R"("60 deg")", R"("90 deg")", R"("110 deg")"}},
    {"gear.bevel", "K_v", falls, "Q_v", {"5", "7", "9", "11"}},
    {"gear.bevel", "S_F1", falls, "R", {"0.9", "0.99", "0.999"}},
    {"gear.bevel", "S_H2", falls, "L_h", {R"("1000 h")", R"("10000 h")", R"("30000 h")"}},
    {"gear.worm", "eta", falls, "mu", {"0.02", "0.04", "0.08"}},
    {"gear.worm", "eta", rises, "n_1", {R"("10 rpm")", R"("100 rpm")", R"("1000 rpm")", R"("3000 rpm")"}},
    {"gear.worm", "C_v", falls, "n_1", {R"("100 rpm")", R"("1000 rpm")", R"("3000 rpm")", R"("9000 rpm")"}},
    {"gear.crossed", "eta", falls, "mu", {"0.02", "0.05", "0.1"}},
    {"gear.crossed", "v_s", rises, "beta_2", {R"("10 deg")", R"("30 deg")", R"("45 deg")"}},
    {"gear.planetary", "eta", rises, "eta_0", {"0.9", "0.95", "0.99", "1"}},
    {"chain.roller", "delta_1", falls, "z_1", {"11", "17", "21", "25"}},
    {"chain.roller", "p_r", rises, "K_A", {"1", "1.3", "1.7"}},
    {"drive.friction_wheels", "F_pmin", falls, "mu", {"0.1", "0.2", "0.4"}, "pair = "},
    {"drive.friction_wheels",
     "F_pmin",
     rises,
     "alpha",
     {R"("10 deg")", R"("16.7 deg")", R"("25 deg")"},
     R"(shape = "grooved")"},
    {"drive.friction_wheels",
     "delta_1",
     falls,
     "d_2",
     {R"("200 mm")", R"("400 mm")", R"("800 mm")"},
     R"(shape = "bevel")"},
    {"belt.course", "S_0_min", falls, "mu", {"0.2", "0.4", "0.8"}},
    {"belt.flat", "S_0_min", falls, "mu", {"0.2", "0.3", "0.4", "0.5"}, R"(b = "100 mm")"},
    {"belt.flat",
     "L_h",
     falls,
     "P",
     {R"("5 kW")", R"("15 kW")", R"("20 kW")"},
     "b = \"100 mm\"\nsigma_f = \"9 MPa\"\nm_f = 6"},
    {"belt.flat",
     "alpha_2",
     falls,
     "a",
     {R"("1500 mm")", R"("2000 mm")", R"("4000 mm")"},
     "b = \"100 mm\"\narrangement = \"quarter_turn\""},
    {"belt.flat", "alpha_1", rises, "a", {R"("500 mm")", R"("1000 mm")", R"("2000 mm")"}, R"(b = "100 mm")"},
    {"belt.grooved", "m_e", falls, "phi", {R"("30 deg")", R"("40 deg")", R"("60 deg")"}},
    {"belt.grooved", "S_0_min", falls, "mu", {"0.2", "0.4", "0.8"}},
    {"belt.synchronous", "u_P", falls, "b", {R"("25.4 mm")", R"("38.1 mm")", R"("50.8 mm")", R"("76.2 mm")"}},
    {"belt.synchronous", "alpha_1", rises, "a", {R"("200 mm")", R"("400 mm")", R"("1000 mm")"}},
    {"belt.v", "u_P", falls, "z", {"2", "3", "4", "6"}},
    {"belt.v", "c_L", rises, "L", {R"("2000 mm")", R"("2650 mm")", R"("4000 mm")", R"("8000 mm")"}},
    {"gear.sizing", "mass", rises, "P", {R"("2 kW")", R"("5 kW")", R"("15 kW")", R"("50 kW")"}},
    {"belt.v_sizing", "drives", falls, "P", {R"("5 kW")", R"("11 kW")", R"("50 kW")", R"("100 kW")"}},
    {"drive.train",
     "n_out",
     rises,
     "n_1",
     {R"("700 rpm")", R"("1450 rpm")", R"("2900 rpm")"},
     "stages = [{ kind = \"gear\", z_1 = 20, z_2 = 60 }, { kind = \"gear\", z_1 = 20, z_2 = 60 }]"},
    {"dynamics.throw", "L", rises, "theta", {R"("10 deg")", R"("25 deg")", R"("40 deg")", R"("45 deg")"}},
    {"dynamics.throw", "L", falls, "theta", {R"("45 deg")", R"("55 deg")", R"("70 deg")", R"("85 deg")"}},
    {"dynamics.work", "v_2", falls, "mu", {"0", "0.1", "0.3", "0.5"}},
    {"shaft.press_fit", "p_min", rises, "D", {R"("70 mm")", R"("90 mm")", R"("200 mm")"}},
    {"shaft.press_fit", "p_min", falls, "d_i", {R"("0 mm")", R"("20 mm")", R"("50 mm")"}},
    {"shaft.press_fit", "T_slip", falls, "dT_2", {R"("5 K")", R"("15 K")", R"("30 K")"}},
    {"link.member", "u_p", rises, "l", {R"("200 mm")", R"("400 mm")", R"("800 mm")", R"("1500 mm")"}},
    {"link.member", "u_i", rises, "M_b", {R"("0 N*m")", R"("60 N*m")", R"("200 N*m")", R"("900 N*m")"}},
    {"pin.joint", "sigma_b", rises, "d_i", {R"("0 mm")", R"("10 mm")", R"("20 mm")", R"("28 mm")"}},
    {"shaft.key", "p_2", falls, "l", {R"("25 mm")", R"("50 mm")", R"("70 mm")"}},
    {"bearing.rolling", "L_10h", falls, "F_a", {R"("0.8 kN")", R"("1 kN")", R"("3 kN")", R"("8 kN")"}},
    {"bearing.rolling", "C_req", falls, "a_1", {"0.25", "0.64", "1"}},
    {"machine.disc", "sigma_ti", rises, "d_i", {R"("1 mm")", R"("50 mm")", R"("200 mm")", R"("490 mm")"}},
    {"machine.flywheel", "J_F", falls, "delta", {"0.005", "0.01", "0.02", "0.05"}},
    {"machine.motion", "delta", falls, "J_F", {R"("15 kg*m^2")", R"("20 kg*m^2")", R"("30 kg*m^2")", R"("60 kg*m^2")"}},
    {"machine.run_up",
     "t",
     rises,
     "load",
     {R"([["0 rpm", "0 N*m"], ["1400 rpm", "0 N*m"]])", R"([["0 rpm", "5 N*m"], ["1400 rpm", "20 N*m"]])",
      R"([["0 rpm", "5 N*m"], ["1400 rpm", "39 N*m"]])"}},
};

std::string lines_at(const Trend& trend, const char* value) {
  const std::string last = std::string(trend.key) + " = " + value;
  return *trend.lines == '\0' ? last : std::string(trend.lines) + "\n" + last;
}

}  // namespace

std::vector<Run> loadpath::test::runs_of_laws() {
  std::vector<Run> runs;
  for (const auto& group : laws) {
    for (const Law& law : group) {
      runs.push_back({law.calculator, law.from});
      runs.push_back({law.calculator, law.to});
    }
  }
  for (const Trend& trend : trends) {
    for (const char* value : trend.values) runs.push_back({trend.calculator, lines_at(trend, value)});
  }
  return runs;
}

TEST_SUITE("laws" * by_element) {
  TEST_CASE("results scale as they must") {
    for (const auto& group : laws) {
      for (const Law& law : group) {
        if (!takes_id(law.calculator)) continue;
        const std::string what = std::string(law.calculator) + "." + law.result + " with " + law.to;
        INFO(what);
        const double from = ExampleStep(law.calculator, law.from)(law.result);
        const double to = ExampleStep(law.calculator, law.to)(law.result);
        CHECK(std::abs(from) > 0.0);
        CHECK_MESSAGE(std::abs(to - law.factor * from) <= 1e-9 * std::abs(to), "factor ", to / from,
                      ", and the row says ", law.factor);
      }
    }
  }

  TEST_CASE("results rise and fall as they must") {
    for (const Trend& trend : trends) {
      if (!takes_id(trend.calculator)) continue;
      std::optional<double> last;
      for (const char* value : trend.values) {
        const std::string what =
            std::string(trend.calculator) + "." + trend.result + " with " + trend.key + " = " + value;
        INFO(what);
        const double now = ExampleStep(trend.calculator, lines_at(trend, value))(trend.result);
        if (last) CHECK((trend.sense == rises ? now > *last : now < *last));
        last = now;
      }
    }
  }

  TEST_CASE("every plain calculator has a law") {
    std::set<std::string_view> tried;
    for (const auto& group : laws) {
      for (const Law& law : group) tried.insert(law.calculator);
    }
    for (const Calculator* c : calculators()) {
      if (c->evaluate == nullptr) continue;
      CHECK_MESSAGE(tried.count(c->id) == 1, std::string(c->id),
                    " has no law: add a row {calculator, from, to, result, factor} to tests/calculators/laws.cpp");
    }
  }
}
