// Input and result of shaft.torsion.
#pragma once

#include "calculators/load/shear_strength.hpp"
#include "calculators/load/stress_cycle.hpp"
#include "calculators/shaft/torsion/diagram.hpp"
#include "lib/calculator/field.hpp"

#include <array>

namespace loadpath::shaft {

using TorsionalStiffness = decltype(Moment() * Length());
inline constexpr Unit<TorsionalStiffness> N_m2{"N*m^2", from_si<TorsionalStiffness>(1.0)};

struct TorsionTypes {
  enum class Fixed { none, left, right };
  enum class Governs { strength, stiffness, neither };

  struct Segment {
    Name name;
    Length l = unset<Length>, d = unset<Length>;
    double chi = unset<double>;
    Length d_bore = unset<Length>, rho = unset<Length>;
    static constexpr Fields fields{
        NameField{&Segment::name, "name", "name of the part"}.may_be_missing(),
        Field{&Segment::l, "l", mm, "length"}.positive().usually(0.1, 1e5),
        Field{&Segment::d, "d", mm, "outer diameter; d if omitted"}
            .positive()
            .usually(1, 2000)
            .findable("R40")
            .may_be_missing(),
        Field{&Segment::chi, "chi", ratio, "bore ratio d_bore/d"}.at_least(0).below(0.99).may_be_missing(),
        Field{&Segment::d_bore, "d_bore", mm, "bore diameter"}.at_least(0).may_be_missing(),
        Field{&Segment::rho, "rho", mm, "radius for the shear stress tau_rho, from the bore to the surface"}
            .at_least(0)
            .may_be_missing()};
  };

  struct Torque {
    Name name;
    Length x = unset<Length>;
    Moment T = unset<Moment>;
    static constexpr Fields fields{NameField{&Torque::name, "name", "source of the torque"}.may_be_missing(),
                                   Field{&Torque::x, "x", mm, "position from the left end"}.at_least(0),
                                   Field{&Torque::T, "T", N_m, "torque on the shaft, signed"}.load()};
  };

  struct Input : ShearStrength {
    Moment T = unset<Moment>;
    Power P = unset<Power>;
    AngularSpeed n = unset<AngularSpeed>;
    Length l = unset<Length>;
    Length d = unset<Length>;
    double chi = unset<double>;
    Length d_bore = unset<Length>, d_h = unset<Length>;
    double K_A = 1.0;
    Stress G = unset<Stress>;
    Twist theta_adm = unset<Twist>;
    Force F = unset<Force>;
    Fixed fixed = Fixed::none;
    List<Torque, most_torques> torques;
    List<Segment, most_cylinders> segments;
    Length d_f = unset<Length>, bore = unset<Length>;
  };

  struct Stretch {
    Length x = unset<Length>, l = unset<Length>;
    Moment M = unset<Moment>, M_t = unset<Moment>;
    Length d_strength = unset<Length>, d_stiffness = unset<Length>, d = unset<Length>, d_bore = unset<Length>;
    Stress tau = unset<Stress>, tau_rho = unset<Stress>;
    TorsionalStiffness GI_t = unset<TorsionalStiffness>;
    Twist theta = unset<Twist>;
    double phi = unset<double>;
    static constexpr Fields fields{
        Field{&Stretch::x, "x", mm, "left end"},
        Field{&Stretch::l, "l", mm, "length"},
        Field{&Stretch::M, "M", N_m, "internal torque, signed"},
        Field{&Stretch::M_t, "M_t", N_m, "design moment"},
        Field{&Stretch::d_strength, "d_strength", mm, "minimum diameter for strength"},
        Field{&Stretch::d_stiffness, "d_stiffness", mm, "minimum diameter for stiffness"},
        Field{&Stretch::d, "d", mm, "outer diameter"},
        Field{&Stretch::d_bore, "d_bore", mm, "bore"},
        Field{&Stretch::tau, "tau", MPa, "maximum shear stress"},
        Field{&Stretch::tau_rho, "tau_rho", MPa, "shear stress at the radius rho"}.where_it_applies(),
        Field{&Stretch::GI_t, "GI_t", N_m2, "torsional stiffness G I_t: torque per angle of twist per unit length"}
            .where_it_applies(),
        Field{&Stretch::theta, "theta", deg_per_m, "angle of twist per unit length, signed"},
        Field{&Stretch::phi, "phi", deg, "angle of twist of the right end relative to the left, positive like M"}};
  };

  struct Section {
    Length x = unset<Length>;
    double phi = unset<double>;
    static constexpr Fields fields{Field{&Section::x, "x", mm, "position from the left end"},
                                   Field{&Section::phi, "phi", deg, "angle of twist relative to the left end, signed"}};
  };

  struct Result {
    Stress tau_all = unset<Stress>;
    Moment M_max = unset<Moment>;
    Length d_strength = unset<Length>, d_stiffness = unset<Length>, d_min = unset<Length>;
    Governs governs = Governs::neither;
    Length D_star = unset<Length>;
    Length d = unset<Length>, d_bore = unset<Length>, d_max = unset<Length>, d_s = unset<Length>;
    Stress tau_max = unset<Stress>;
    Twist theta_max = unset<Twist>;
    double phi = unset<double>, phi_max = unset<double>;
    Moment k_t = unset<Moment>;
    double u_tau = unset<double>, u_theta = unset<double>;
    Force F_bend = unset<Force>;
    double K_ts = unset<double>;
    StressCycle cycle;
    List<Stretch, most_stretches> segments;
    List<Section, most_stretches + 1> sections;
  };
};

constexpr auto choices_of(TorsionTypes::Fixed) {
  return std::array{ChoiceName<TorsionTypes::Fixed>{TorsionTypes::Fixed::none, "none", "free at both ends"},
                    ChoiceName<TorsionTypes::Fixed>{TorsionTypes::Fixed::left, "left", "held at the left end"},
                    ChoiceName<TorsionTypes::Fixed>{TorsionTypes::Fixed::right, "right", "held at the right end"}};
}

constexpr auto choices_of(TorsionTypes::Governs) {
  return std::array{
      ChoiceName<TorsionTypes::Governs>{TorsionTypes::Governs::strength, "strength", "the allowable stress"},
      ChoiceName<TorsionTypes::Governs>{TorsionTypes::Governs::stiffness, "stiffness", "the allowable twist"},
      ChoiceName<TorsionTypes::Governs>{TorsionTypes::Governs::neither, "", "no condition is given"}};
}

}  // namespace loadpath::shaft
