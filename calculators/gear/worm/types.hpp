// Choices, input and result of gear.worm.
#pragma once

#include "calculators/gear/pair_choices.hpp"
#include "calculators/load/shaft_load.hpp"
#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/quantity/fit_units.hpp"

#include <array>

namespace loadpath::gear {

struct WormTypes {
  enum class Casting { unsaid, sand, chill, centrifugal };
  enum class Locking { unsaid, required };
  enum class Cooling { still, fan };

  struct Input {
    Whole z_1 = 0, z_2 = 0;
    Length m_x = unset<Length>, d_1 = unset<Length>, b_2 = unset<Length>;
    double alpha_n = 20.0 * deg.one, h_aP = 1.0, h_fP = 1.25;
    Hand hand = Hand::right;
    Moment T_1 = unset<Moment>, T_2 = unset<Moment>;
    Power P = unset<Power>;
    AngularSpeed n_1 = unset<AngularSpeed>;
    Turns turns = Turns::ccw;
    double K_A = 1.0, mu = unset<double>;
    Locking locking = Locking::unsaid;
    Length bore_2 = unset<Length>;
    Casting casting = Casting::unsaid;
    double S_Wmin = unset<double>, y = unset<double>;
    Stress sigma_adm = unset<Stress>;
    Cooling cooling = Cooling::still;
    Area A_h = unset<Area>;
    Heating dT_adm = unset<Heating>;
    Power P_cool = unset<Power>;
  };

  struct Result {
    double i = unset<double>, q = unset<double>, gamma = unset<double>;
    Length p_x = unset<Length>, p_z = unset<Length>, d_2 = unset<Length>, a = unset<Length>;
    Length d_a1 = unset<Length>, d_f1 = unset<Length>, d_a2 = unset<Length>, d_f2 = unset<Length>;
    Length L_1 = unset<Length>, b_2H = unset<Length>;
    double x_b = unset<double>;
    double z_min = unset<double>, x_z = unset<double>;
    AngularSpeed n_2 = unset<AngularSpeed>;
    Speed v_2 = unset<Speed>, v_s = unset<Speed>;
    double mu = unset<double>, eta = unset<double>, eta_b = unset<double>, x_L = unset<double>;
    Moment T_1 = unset<Moment>, T_2 = unset<Moment>;
    Force F_t1 = unset<Force>, F_t2 = unset<Force>, F_r = unset<Force>, F_n = unset<Force>;
    Power P_1 = unset<Power>, P_2 = unset<Power>, P_V = unset<Power>;
    Force F_y1 = unset<Force>, F_z1 = unset<Force>;
    Stress tau_f1 = unset<Stress>;
    ShaftLoad worm, wheel;
    double m_R2 = unset<double>;
    double C_s = unset<double>, C_m = unset<double>, C_v = unset<double>, x_i = unset<double>, x_s = unset<double>;
    double x_n = unset<double>;
    Length F_e = unset<Length>;
    Force W_tR = unset<Force>;
    double S_W = unset<double>, y = unset<double>, K_v = unset<double>;
    Stress sigma_F = unset<Stress>;
    Power P_K = unset<Power>;
    Heating dT = unset<Heating>;
    double u_W = unset<double>, u_F = unset<double>, u_T = unset<double>;
  };
};

constexpr auto choices_of(WormTypes::Casting) {
  using Casting = WormTypes::Casting;
  return std::array{ChoiceName<Casting>{Casting::unsaid, "", "not given"},
                    ChoiceName<Casting>{Casting::sand, "sand", "sand-cast bronze"},
                    ChoiceName<Casting>{Casting::chill, "chill", "chill-cast or forged bronze"},
                    ChoiceName<Casting>{Casting::centrifugal, "centrifugal", "centrifugally cast bronze"}};
}
constexpr auto choices_of(WormTypes::Locking) {
  using Locking = WormTypes::Locking;
  return std::array{ChoiceName<Locking>{Locking::unsaid, "", "not given"},
                    ChoiceName<Locking>{Locking::required, "required", "the wheel must not drive the worm"}};
}
constexpr auto choices_of(WormTypes::Cooling) {
  using Cooling = WormTypes::Cooling;
  return std::array{ChoiceName<Cooling>{Cooling::still, "still", "case without a fan"},
                    ChoiceName<Cooling>{Cooling::fan, "fan", "fan on the worm shaft"}};
}

}  // namespace loadpath::gear
