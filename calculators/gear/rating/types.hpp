// Input and result of gear.rating.
#pragma once

#include "calculators/gear/pair_choices.hpp"
#include "calculators/gear/rated_mesh.hpp"
#include "calculators/gear/rating/choices.hpp"
#include "calculators/gear/rating/spectrum.hpp"
#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/quantity/fit_units.hpp"

namespace loadpath::gear {

using Viscosity = decltype(from_si<Area>(1.0) / from_si<Time>(1.0));
inline constexpr Unit<Viscosity> mm2_per_s{"mm^2/s", from_si<Viscosity>(1e-6)};

struct RatingTypes {
  struct Input {
    RatingStandard standard = RatingStandard::din3990;
    RootEdition root_edition = RootEdition::of_2006;
    Whole z_1 = 0, z_2 = 0;
    Length m_n = unset<Length>;
    double alpha_n = 20.0 * deg.one, beta = 0.0, x_1 = 0.0, x_2 = unset<double>;
    Length a_w = unset<Length>;
    double h_aP = 1.0, h_fP = 1.25, rho_fP = 0.38, s_pr = unset<double>;
    Shortening shortening = Shortening::clearance;
    Length b = unset<Length>;
    Moment T_1 = unset<Moment>;
    AngularSpeed n_1 = unset<AngularSpeed>;
    double K_A = 1.0;
    Idler idler = Idler::none;
    Whole grade = 0;
    Finish finish = Finish::hobbed;
    Length R_z1 = unset<Length>, R_z2 = unset<Length>;
    Viscosity nu_40 = unset<Viscosity>;
    Length s_R1 = unset<Length>, s_R2 = unset<Length>;
    GearMaterial material_1 = GearMaterial::steel, material_2 = GearMaterial::steel;
    Quality quality_1 = Quality::untold, quality_2 = Quality::untold;
    double H_1 = unset<double>, H_2 = unset<double>;
    Stress sigma_Hlim_1 = unset<Stress>, sigma_Hlim_2 = unset<Stress>;
    Stress sigma_Flim_1 = unset<Stress>, sigma_Flim_2 = unset<Stress>;
    Place place = Place::untold;
    Length l = unset<Length>, s = unset<Length>, d_sh = unset<Length>;
    Length f_sh_1 = unset<Length>, f_sh_2 = unset<Length>;
    Stiffening stiffening = Stiffening::none;
    Crowning crowning = Crowning::none;
    Length f_ma = unset<Length>, C_a = unset<Length>;
    Pattern pattern = Pattern::unfavourable;
    Time L_h = unset<Time>;
    double S_Hmin = unset<double>, S_Fmin = unset<double>;
    Whole q_1 = 1, q_2 = 1;
    List<LoadBlock, most_load_blocks> blocks;
  };

  struct Result {
    Force F_t = unset<Force>;
    Speed v = unset<Speed>;
    double c_th = unset<double>, c_prime = unset<double>, c_gamma_alpha = unset<double>, c_gamma_beta = unset<double>;
    double x_c = unset<double>, N_res = unset<double>, B_p = unset<double>, B_f = unset<double>, B_k = unset<double>;
    Length f_pbeff = unset<Length>, y_alpha = unset<Length>;
    double K_V = unset<double>, x_v = unset<double>;
    Length f_sh = unset<Length>, F_betax = unset<Length>, y_beta = unset<Length>, F_betay = unset<Length>;
    double K_Hbeta = unset<double>, q_alpha = unset<double>, K_Halpha = unset<double>, K_Falpha = unset<double>;
    double K_Fbeta1 = unset<double>, K_Fbeta2 = unset<double>;
    double Z_H = unset<double>, Z_E = unset<double>, Z_eps = unset<double>, Z_beta = unset<double>;
    double Z_B = unset<double>, Z_D = unset<double>, Z_LVR = unset<double>;
    double Z_L = unset<double>, Z_v = unset<double>, Z_R = unset<double>;
    double Z_NT1 = unset<double>, Z_NT2 = unset<double>;
    Stress sigma_H0 = unset<Stress>, sigma_H1 = unset<Stress>, sigma_H2 = unset<Stress>;
    Stress sigma_HG1 = unset<Stress>, sigma_HG2 = unset<Stress>;
    double S_H1 = unset<double>, S_H2 = unset<double>;
    double Y_Fa1 = unset<double>, Y_Fa2 = unset<double>, Y_Sa1 = unset<double>, Y_Sa2 = unset<double>;
    double Y_F1 = unset<double>, Y_F2 = unset<double>, Y_S1 = unset<double>, Y_S2 = unset<double>;
    double Y_B1 = unset<double>, Y_B2 = unset<double>, Y_NT1 = unset<double>, Y_NT2 = unset<double>;
    double Y_eps = unset<double>, f_eps = unset<double>, Y_beta = unset<double>;
    Stress sigma_F01 = unset<Stress>, sigma_F02 = unset<Stress>, sigma_F1 = unset<Stress>, sigma_F2 = unset<Stress>;
    Stress sigma_FG1 = unset<Stress>, sigma_FG2 = unset<Stress>;
    double S_F1 = unset<double>, S_F2 = unset<double>;
    double u_H1 = unset<double>, u_H2 = unset<double>, u_F1 = unset<double>, u_F2 = unset<double>;
    double x_eps = unset<double>;
    double x_free = unset<double>, s_a = unset<double>, f_int = unset<double>;
    Length c_n = unset<Length>, j_bn = unset<Length>;
    double D_H1 = unset<double>, D_H2 = unset<double>, D_F1 = unset<double>, D_F2 = unset<double>;
    Moment T_H1 = unset<Moment>, T_H2 = unset<Moment>, T_F1 = unset<Moment>, T_F2 = unset<Moment>;
    double K_AH = unset<double>, K_AF = unset<double>;
    List<BlockDamage, most_load_blocks> blocks;
  };
};

}  // namespace loadpath::gear
