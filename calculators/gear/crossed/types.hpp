// Choices, input and result of gear.crossed.
#pragma once

#include "calculators/gear/pair_choices.hpp"
#include "calculators/load/shaft_load.hpp"
#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/quantity/fit_units.hpp"

#include <array>

namespace loadpath::gear {

struct CrossedTypes {
  enum class Locking { unsaid, required };

  struct Input {
    Whole z_1 = 0, z_2 = 0;
    Length m_n = unset<Length>;
    double beta_1 = unset<double>, beta_2 = unset<double>;
    Length b_1 = unset<Length>, b_2 = unset<Length>;
    double alpha_n = 20.0 * deg.one, x_1 = 0.0, h_aP = 1.0, h_fP = 1.25;
    double mu = unset<double>;
    Moment T_1 = unset<Moment>, T_2 = unset<Moment>;
    Power P = unset<Power>;
    AngularSpeed n_1 = unset<AngularSpeed>;
    Turns turns = Turns::ccw;
    double K_A = 1.0;
    Locking locking = Locking::unsaid;
    Stress C_adm = unset<Stress>;
    Length bore_1 = unset<Length>, bore_2 = unset<Length>;
  };

  struct Result {
    double i = unset<double>, Sigma = unset<double>;
    Length d_1 = unset<Length>, d_2 = unset<Length>, a = unset<Length>;
    Length d_a1 = unset<Length>, d_a2 = unset<Length>, d_f1 = unset<Length>, d_f2 = unset<Length>;
    Length d_b1 = unset<Length>, d_b2 = unset<Length>;
    double beta_b1 = unset<double>, beta_b2 = unset<double>;
    Length g_a1 = unset<Length>, g_a2 = unset<Length>;
    double eps_n = unset<double>, x_free = unset<double>, s_a = unset<double>;
    double x_b1 = unset<double>, x_b2 = unset<double>;
    AngularSpeed n_2 = unset<AngularSpeed>;
    Speed v_1 = unset<Speed>, v_2 = unset<Speed>, v_s = unset<Speed>;
    double eta = unset<double>, eta_b = unset<double>, x_L = unset<double>;
    Moment T_1 = unset<Moment>, T_2 = unset<Moment>;
    Force F_n = unset<Force>, F_t1 = unset<Force>, F_t2 = unset<Force>;
    Force F_a1 = unset<Force>, F_a2 = unset<Force>, F_r = unset<Force>;
    Power P_1 = unset<Power>, P_2 = unset<Power>, P_V = unset<Power>;
    Force F_y1 = unset<Force>, F_z1 = unset<Force>, F_y2 = unset<Force>, F_z2 = unset<Force>;
    ShaftLoad gear_1, gear_2;
    double m_R1 = unset<double>, m_R2 = unset<double>;
    Length b_e = unset<Length>;
    Stress C = unset<Stress>;
    double u_C = unset<double>;
  };
};

constexpr auto choices_of(CrossedTypes::Locking) {
  using Locking = CrossedTypes::Locking;
  return std::array{ChoiceName<Locking>{Locking::unsaid, "", "not given"},
                    ChoiceName<Locking>{Locking::required, "required", "gear 2 must not drive gear 1"}};
}

}  // namespace loadpath::gear
