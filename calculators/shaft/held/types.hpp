// Input and result of shaft.held.
#pragma once

#include "calculators/load/shear_strength.hpp"
#include "calculators/load/stress_cycle.hpp"
#include "calculators/shaft/held/members.hpp"
#include "lib/calculator/field.hpp"

#include <array>

namespace loadpath::shaft {

struct HeldTypes {
  struct Input : ShearStrength {
    List<Segment, most_segments> segments;
    List<Sleeve, most_sleeves> sleeves;
    List<AxialTorque, most_twisting> torques;
    End end_1 = End::free, end_2 = End::free;
    Moment c_1 = unset<Moment>, c_2 = unset<Moment>;
    double K_A = 1.0;
    Stress G = unset<Stress>;
    Twist theta_adm = unset<Twist>;
    double phi_adm = unset<double>;
  };

  struct Stretch {
    Length x = unset<Length>, l = unset<Length>;
    Moment M_1 = unset<Moment>, M_2 = unset<Moment>;
    double phi = unset<double>;
    static constexpr Fields fields{Field{&Stretch::x, "x", mm, "its first end"}, Field{&Stretch::l, "l", mm, "length"},
                                   Field{&Stretch::M_1, "M_1", N_m, "moment at its first end"},
                                   Field{&Stretch::M_2, "M_2", N_m, "moment at its second end"},
                                   Field{&Stretch::phi, "phi", deg, "rotation of its second end against its first"}};
  };
  struct Section {
    Length x = unset<Length>;
    double phi = unset<double>;
    static constexpr Fields fields{Field{&Section::x, "x", mm, "place"},
                                   Field{&Section::phi, "phi", deg, "rotation from the unloaded position"}};
  };
  /// A segment or a sleeve where its stress is the largest.
  struct Member {
    Name name;
    Length x = unset<Length>, d = unset<Length>;
    Moment T = unset<Moment>;
    Stress tau = unset<Stress>, tau_all = unset<Stress>;
    double u_tau = unset<double>;
    static constexpr Fields fields{
        NameField{&Member::name, "name", "segment or sleeve"},
        Field{&Member::x, "x", mm, "position of its maximum stress"},
        Field{&Member::d, "d", mm, "outer diameter at this position"},
        Field{&Member::T, "T", N_m, "torque of the segment or sleeve at this position, signed"}.holding("K_A"),
        Field{&Member::tau, "tau", MPa, "maximum shear stress"},
        Field{&Member::tau_all, "tau_all", MPa, "allowable shear stress"},
        Field{&Member::u_tau, "u_tau", ratio, "shear stress / allowable shear stress"}};
  };

  struct Result {
    Moment R_1 = unset<Moment>, R_2 = unset<Moment>, M_max = unset<Moment>;
    Length d_s = unset<Length>;
    Stress tau_max = unset<Stress>;
    Twist theta_max = unset<Twist>;
    double phi_1 = unset<double>, phi_2 = unset<double>, phi_max = unset<double>;
    Length x_phi = unset<Length>;
    double s_max = unset<double>, u_tau = unset<double>, u_theta = unset<double>, u_phi = unset<double>;
    double K_ts = unset<double>;
    StressCycle cycle;
    List<Member, most_members> members;
    List<Stretch, most_cuts> stretches;
    List<Section, most_cuts + 1> sections;
  };
};

}  // namespace loadpath::shaft
