// Input and result of belt.v, and the words of its choices.
#pragma once

#include "calculators/belt/shaft_load.hpp"
#include "calculators/belt/v/data.hpp"
#include "lib/calculator/field.hpp"

#include <array>

namespace loadpath::belt {

struct VTypes {
  enum class BeltClass { unstated, classes_0_II, III, IV };
  enum class Duty { unstated, light, medium, heavy, very_heavy };
  enum class Motor { unstated, normal, high };
  enum class Tensioning { fixed, constant_force };
  enum class End { low, high };

  struct Input {
    Basis basis = Basis::optibelt;
    Name section;
    BeltClass belt_class = BeltClass::unstated;
    Power P = unset<Power>;
    double K_A = unset<double>, K_A_1 = unset<double>;
    Duty duty = Duty::unstated;
    Motor motor = Motor::unstated;
    Time h_day = unset<Time>;
    AngularSpeed n_1 = unset<AngularSpeed>, n_2_set = unset<AngularSpeed>;
    double i_set = unset<double>;
    double epsilon = 0.01;
    Length d_1 = unset<Length>, d_2 = unset<Length>, a = unset<Length>, L = unset<Length>;
    Whole z = 0;
    End C_K_end = End::low;
    Tensioning tensioning = Tensioning::fixed;
    double mu = unset<double>;
    Speed v_rim_adm = from_si<Speed>(35.0);
  };

  struct Result {
    Basis rating = Basis::optibelt;
    Length d_2 = unset<Length>;
    double i_w = unset<double>, dev_i = unset<double>;
    double i = unset<double>;
    AngularSpeed n_2 = unset<AngularSpeed>, n_k = unset<AngularSpeed>;
    Speed v = unset<Speed>;
    Length a = unset<Length>, L = unset<Length>, l_s = unset<Length>;
    double gamma = unset<double>, alpha_1 = unset<double>, alpha_2 = unset<double>, alpha = unset<double>;
    double K_A = unset<double>;
    Power P_B = unset<Power>, P_0 = unset<Power>, dP = unset<Power>, P_N = unset<Power>, P_all = unset<Power>;
    double c_alpha = unset<double>, c_L = unset<double>, C_K = unset<double>, z_0 = unset<double>;
    Whole z = 0;
    Force F_c = unset<Force>, F_0 = unset<Force>, F_0_new = unset<Force>;
    Force S_1 = unset<Force>, S_2 = unset<Force>;
    Length y = unset<Length>;
    Force Q = unset<Force>, Q_new = unset<Force>;
    AngularSpeed f_s = unset<AngularSpeed>, f_s_new = unset<AngularSpeed>;
    Force R_0 = unset<Force>, R_new = unset<Force>, R_x = unset<Force>, R_y = unset<Force>, R = unset<Force>;
    double theta_R = unset<double>;
    ShaftLoad shaft_1, shaft_2;
    Length B = unset<Length>, d_a1 = unset<Length>, d_a2 = unset<Length>;
    double phi_1 = unset<double>, phi_2 = unset<double>;
    Speed v_rim = unset<Speed>;
    Length Delta_1 = unset<Length>, Delta_2 = unset<Length>, g_r = unset<Length>, g_f = unset<Length>;
    AngularSpeed f_B = unset<AngularSpeed>;
    Time L_h = unset<Time>;
    double u_P = unset<double>, u_grip = unset<double>, u_rim = unset<double>, u_B = unset<double>;
    double x_dmin = unset<double>, x_d = unset<double>, x_n = unset<double>, x_L = unset<double>,
           x_alpha = unset<double>;
    double x_v = unset<double>, x_z = unset<double>, off_d = unset<double>, off_L = unset<double>;
  };
};

constexpr auto choices_of(VTypes::BeltClass) {
  using Class = VTypes::BeltClass;
  return std::array{ChoiceName<Class>{Class::unstated, "not_given", "not given", "unstated"},
                    ChoiceName<Class>{Class::classes_0_II, "0_II", "classes 0, I and II of GOST 1284.2"},
                    ChoiceName<Class>{Class::III, "III", "class III of GOST 1284.2"},
                    ChoiceName<Class>{Class::IV, "IV", "class IV of GOST 1284.2"}};
}
constexpr auto choices_of(VTypes::Duty) {
  using Duty = VTypes::Duty;
  return std::array{ChoiceName<Duty>{Duty::unstated, "not_given", "not given", "unstated"},
                    ChoiceName<Duty>{Duty::light, "light", "even load: fans, centrifugal pumps, lathes"},
                    ChoiceName<Duty>{Duty::medium, "medium", "moderate changes: milling machines, generators"},
                    ChoiceName<Duty>{Duty::heavy, "heavy", "strong changes: piston pumps, planers, presses"},
                    ChoiceName<Duty>{Duty::very_heavy, "very_heavy", "shocks: crushers, mills, shears"}};
}
constexpr auto choices_of(VTypes::Motor) {
  using Motor = VTypes::Motor;
  return std::array{ChoiceName<Motor>{Motor::unstated, "not_given", "not given", "unstated"},
                    ChoiceName<Motor>{Motor::normal, "normal", "normal starting torque"},
                    ChoiceName<Motor>{Motor::high, "high", "high starting torque, piston engines"}};
}
constexpr auto choices_of(VTypes::Tensioning) {
  using Tensioning = VTypes::Tensioning;
  return std::array{
      ChoiceName<Tensioning>{Tensioning::fixed, "fixed", "centres that are fixed when running"},
      ChoiceName<Tensioning>{Tensioning::constant_force, "constant_force", "weight or spring with constant tension"}};
}
constexpr auto choices_of(VTypes::End) {
  return std::array{ChoiceName<VTypes::End>{VTypes::End::low, "low", "the low end: more belts"},
                    ChoiceName<VTypes::End>{VTypes::End::high, "high", "the high end"}};
}

}  // namespace loadpath::belt
