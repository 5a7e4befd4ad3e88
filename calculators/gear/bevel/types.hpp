// Choices, input and result of gear.bevel.
#pragma once

#include "calculators/gear/pair_choices.hpp"
#include "calculators/load/shaft_load.hpp"
#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/quantity/fit_units.hpp"

#include <array>

namespace loadpath::gear {

struct BevelTypes {
  enum class Mounting { overhung, one_straddled, both_straddled };
  enum class Crowning { none, crowned };
  enum class Service { critical, general };

  struct Input {
    Whole z_1 = 0, z_2 = 0;
    Length m_et = unset<Length>, b = unset<Length>;
    double Sigma = 90.0 * deg.one, alpha = 20.0 * deg.one;
    double x_1 = 0.0, h_aP = 1.0, h_fP = 1.25;
    Moment T_1 = unset<Moment>;
    Power P = unset<Power>;
    AngularSpeed n_1 = unset<AngularSpeed>;
    Turns turns = Turns::ccw;
    double K_A = 1.0;
    Idler idler = Idler::none;
    Length bore_1 = unset<Length>, bore_2 = unset<Length>;
    Whole Q_v = 6;
    Mounting mounting = Mounting::overhung;
    Crowning crowning = Crowning::none;
    double I = unset<double>, J_1 = unset<double>, J_2 = unset<double>;
    double H_B1 = unset<double>, H_B2 = unset<double>;
    Stress s_ac1 = unset<Stress>, s_ac2 = unset<Stress>, s_at1 = unset<Stress>, s_at2 = unset<Stress>;
    Stress E_1 = 206.84 * GPa, E_2 = 206.84 * GPa;
    double nu_1 = 0.3, nu_2 = 0.3;
    double N = unset<double>;
    Time L_h = unset<Time>;
    Service service = Service::critical;
    double R = 0.99;
    Heating T_G = unset<Heating>;
    double C_H = 1.0;
    double S_Hmin = unset<double>, S_Fmin = unset<double>;
  };

  struct Result {
    double i = unset<double>, delta_1 = unset<double>, delta_2 = unset<double>;
    Length d_1 = unset<Length>, d_2 = unset<Length>, R_e = unset<Length>, R_m = unset<Length>;
    Length d_m1 = unset<Length>, d_m2 = unset<Length>, m_m = unset<Length>;
    Length h_a1 = unset<Length>, h_a2 = unset<Length>, h_f1 = unset<Length>, h_f2 = unset<Length>;
    Length d_a1 = unset<Length>, d_a2 = unset<Length>, d_f1 = unset<Length>, d_f2 = unset<Length>;
    Length d_fi1 = unset<Length>, d_fi2 = unset<Length>;
    double theta_f1 = unset<double>, theta_f2 = unset<double>;
    double delta_a1 = unset<double>, delta_a2 = unset<double>, delta_f1 = unset<double>, delta_f2 = unset<double>;
    double z_v1 = unset<double>, z_v2 = unset<double>;
    double x_R = unset<double>, x_m = unset<double>, eps_v = unset<double>, x_free = unset<double>, s_a = unset<double>;
    AngularSpeed n_2 = unset<AngularSpeed>;
    Speed v_e = unset<Speed>;
    Moment T_2 = unset<Moment>;
    Force F_t = unset<Force>, F_r1 = unset<Force>, F_a1 = unset<Force>, F_r2 = unset<Force>, F_a2 = unset<Force>;
    Force F_y1 = unset<Force>;
    ShaftLoad gear_1, gear_2;
    double m_R1 = unset<double>, m_R2 = unset<double>;
    Force W_t = unset<Force>;
    double K_v = unset<double>, x_v = unset<double>, K_s = unset<double>, K_m = unset<double>;
    double C_s = unset<double>, C_xc = unset<double>, C_p = unset<double>;
    double N_1 = unset<double>, N_2 = unset<double>;
    double C_L1 = unset<double>, C_L2 = unset<double>, K_L1 = unset<double>, K_L2 = unset<double>;
    double K_R = unset<double>, C_R = unset<double>, K_T = unset<double>;
    Stress s_c = unset<Stress>, s_wc1 = unset<Stress>, s_wc2 = unset<Stress>;
    Stress s_t1 = unset<Stress>, s_t2 = unset<Stress>, s_wt1 = unset<Stress>, s_wt2 = unset<Stress>;
    double S_H1 = unset<double>, S_H2 = unset<double>, S_F1 = unset<double>, S_F2 = unset<double>;
    double u_H1 = unset<double>, u_H2 = unset<double>, u_F1 = unset<double>, u_F2 = unset<double>;
  };
};

constexpr auto choices_of(BevelTypes::Mounting) {
  using Mounting = BevelTypes::Mounting;
  return std::array{ChoiceName<Mounting>{Mounting::overhung, "overhung", "both gears overhung: K_mb = 1.25"},
                    ChoiceName<Mounting>{Mounting::one_straddled, "one_straddled", "one gear between bearings: 1.10"},
                    ChoiceName<Mounting>{Mounting::both_straddled, "both_straddled", "both between bearings: 1.00"}};
}
constexpr auto choices_of(BevelTypes::Crowning) {
  using Crowning = BevelTypes::Crowning;
  return std::array{ChoiceName<Crowning>{Crowning::none, "none", "teeth without crowning: C_xc = 2"},
                    ChoiceName<Crowning>{Crowning::crowned, "crowned", "crowned teeth: C_xc = 1.5"}};
}
constexpr auto choices_of(BevelTypes::Service) {
  using Service = BevelTypes::Service;
  return std::array{ChoiceName<Service>{Service::critical, "critical", "critical service, the lower life factor"},
                    ChoiceName<Service>{Service::general, "general", "general service"}};
}

}  // namespace loadpath::gear
