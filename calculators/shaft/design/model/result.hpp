// Result of a shaft between its bearings: bearing loads, deformation, assessment of each section.
#pragma once

#include "calculators/shaft/design/model/input.hpp"
#include "lib/calculator/list.hpp"
#include "lib/quantity/fit_units.hpp"

namespace loadpath::shaft {

inline constexpr std::size_t most_places = 3 * most_pieces + 1 + 2 * most_supports + most_seats + 2 * most_notches;

/// Load of a bearing, an input record of bearing calculators.
struct Carried {
  Name name;
  Length x = unset<Length>;
  Holds holds = Holds::radial;
  Force R_x = unset<Force>, R_y = unset<Force>, F_r = unset<Force>, F_a = unset<Force>;
  Force F_r0 = unset<Force>, F_a0 = unset<Force>;
  AngularSpeed n = unset<AngularSpeed>;
  double beta = unset<double>, u_beta = unset<double>;
  Length d_s = unset<Length>, l_s = unset<Length>, r_f = unset<Length>, d_f = unset<Length>;
  Length s_p = unset<Length>;
  static constexpr Fields fields{
      NameField{&Carried::name, "name", "name of the bearing"},
      Field{&Carried::x, "x", mm, "position"},
      Choice{&Carried::holds, "holds", "loads that the bearing takes: radial, or radial and axial"},
      Field{&Carried::R_x, "R_x", N, "force on the shaft along X (loads over a revolution: at maximum F_r)"}
          .load()
          .with("R_y, F_a")
          .holding("K_A"),
      Field{&Carried::R_y, "R_y", N, "force on the shaft along Y (loads over a revolution: at maximum F_r)"}
          .load()
          .with("R_x, F_a")
          .holding("K_A"),
      Field{&Carried::F_r, "F_r", N, "radial bearing load (loads over a revolution: mean with exponent 10/3)"}
          .load()
          .with("F_a")
          .holding("K_A"),
      Field{&Carried::F_a, "F_a", N, "axial bearing load, positive to the right (loads over a revolution: as F_r)"}
          .load()
          .with("F_r")
          .holding("K_A"),
      Field{&Carried::F_r0, "F_r0", N, "peak radial load, with k_max"}.load().with("F_a0").holding("K_A").at_peak(),
      Field{&Carried::F_a0, "F_a0", N, "peak axial load, with k_max"}.load().with("F_r0").holding("K_A").at_peak(),
      Field{&Carried::n, "n", rpm, "speed of the shaft"},
      Field{&Carried::beta, "beta", deg, "shaft slope at the bearing"},
      Field{&Carried::u_beta, "u_beta", ratio, "slope / allowable slope"}.check().where_it_applies(),
      Field{&Carried::d_s, "d_s", mm, "shaft diameter at the bearing"},
      Field{&Carried::l_s, "l_s", mm, "maximum ring width that fits the shaft segment"},
      Field{&Carried::r_f, "r_f", mm, "fillet radius of the adjacent shoulder"},
      Field{&Carried::d_f, "d_f", mm, "diameter of this shoulder"},
      Field{&Carried::s_p, "s_p", mm, "offset of the point where the reaction acts, positive to the right"}};
};

/// How the shaft moves where something sits on it.
struct Seated {
  Name name;
  Length x = unset<Length>;
  Moment T = unset<Moment>;
  Length v = unset<Length>;
  double beta = unset<double>, u_beta = unset<double>, x_c = unset<double>, x_peak = unset<double>, m_R = unset<double>,
         x_R = unset<double>, x_n = unset<double>;
  Length delta_b = unset<Length>, delta_t = unset<Length>, delta_s = unset<Length>, f_sh = unset<Length>;
  static constexpr Fields fields{
      NameField{&Seated::name, "name", "name of the component"},
      Field{&Seated::x, "x", mm, "position"},
      Field{&Seated::T, "T", N_m, "torque applied to the shaft, maximum over a revolution"}.holding("K_A"),
      Field{&Seated::v, "v", mm, "deflection"},
      Field{&Seated::beta, "beta", deg, "slope"},
      Field{&Seated::u_beta, "u_beta", ratio, "slope / allowable slope"}.check().where_it_applies(),
      Field{&Seated::x_c, "x_c", ratio, "torque / assessed torque of the shaft-hub connection"}
          .limit(0, 1 + 1e-6)
          .criterion()
          .sizeless()
          .where_it_applies(),
      Field{&Seated::x_peak, "x_peak", ratio, "torque with k_max / assessed peak torque of the shaft-hub connection"}
          .limit(0, 1 + 1e-6)
          .criterion()
          .sizeless()
          .where_it_applies(),
      Field{&Seated::m_R, "m_R", ratio,
            "backup ratio of a gear: rim thickness above the keyway / tooth depth (tooth root "
            "formulas apply from 1.2)"}
          .limit(1.2 * (1 - 1e-9), 1e6)
          .where_it_applies(),
      Field{&Seated::x_R, "x_R", ratio,
            "keyway depth / remaining wall of the hub under the root circle (limit set by loadpath)"}
          .limit(0, 1 + 1e-9)
          .where_it_applies(),
      Field{&Seated::x_n, "x_n", ratio, "speed / speed up to which the interference fit is assessed"}
          .limit(0, 1 + 1e-6)
          .sizeless()
          .where_it_applies(),
      Field{&Seated::delta_b, "delta_b", um,
            "bending across the face of a cylindrical gear, along its transverse normal force: right less left end"}
          .holding("K_A"),
      Field{&Seated::delta_t, "delta_t", um,
            "twist of the gear body (d_f missing: of the shaft) across the face x base radius, signed as delta_b"}
          .holding("K_A"),
      Field{&Seated::delta_s, "delta_s", um, "sag of the face: its middle against the line between its ends"}.holding(
          "K_A"),
      Field{&Seated::f_sh, "f_sh", um,
            "misalignment of the teeth from the deflection of the shaft, for f_sh_1 or f_sh_2 of gear.rating"}
          .holding("K_A")};
};

/// A place of the shaft where something changes: the thinner of its two sides, with the larger moments.
struct Section {
  Name name;
  Length x = unset<Length>, d = unset<Length>, d_bore = unset<Length>;
  Moment M_x = unset<Moment>, M_y = unset<Moment>, M = unset<Moment>, T = unset<Moment>;
  Force V = unset<Force>, N = unset<Force>;
  Stress sigma_b = unset<Stress>, sigma_n = unset<Stress>, tau = unset<Stress>, sigma_v = unset<Stress>;
  double psi = unset<double>;
  double u_v = unset<double>, u_h = unset<double>;
  static constexpr Fields fields{
      NameField{&Section::name, "name", "name of the section"},
      Field{&Section::x, "x", mm, "position"},
      Field{&Section::psi, "psi", deg, "shaft angle of maximum stress (loads over a revolution)"},
      Field{&Section::d, "d", mm, "outer diameter (groove: net diameter)"},
      Field{&Section::d_bore, "d_bore", mm, "bore"},
      Field{&Section::M_x, "M_x", N_m, "bending moment in the plane of X"}.holding("K_A"),
      Field{&Section::M_y, "M_y", N_m, "bending moment in the plane of Y"}.holding("K_A"),
      Field{&Section::M, "M", N_m, "resultant bending moment"}.holding("K_A"),
      Field{&Section::T, "T", N_m, "torque, signed"}.holding("K_A"),
      Field{&Section::V, "V", loadpath::N, "transverse force, both planes together"}.holding("K_A"),
      Field{&Section::N, "N", loadpath::N, "axial force, tension positive"}.holding("K_A"),
      Field{&Section::sigma_b, "sigma_b", MPa, "bending stress"},
      Field{&Section::sigma_n, "sigma_n", MPa, "axial stress, signed"},
      Field{&Section::tau, "tau", MPa, "torsional stress"},
      Field{&Section::sigma_v, "sigma_v", MPa, "maximum equivalent stress, von Mises"},
      Field{&Section::u_v, "u_v", ratio, "yielding: maximum equivalent / allowable stress"}.check("S_F"),
      Field{&Section::u_h, "u_h", ratio, "required / actual shoulder height"}.check().where_it_applies()};
};

/// Excitation of order h, compared with the torsional natural frequencies on both sides of it.
struct Harmonic {
  Name name;
  double h = unset<double>;
  AngularSpeed n_below = unset<AngularSpeed>, n_above = unset<AngularSpeed>;
  double u_h = unset<double>;
  static constexpr Fields fields{
      NameField{&Harmonic::name, "name", "excitation"}, Field{&Harmonic::h, "h", ratio, "excitations per revolution"},
      Field{&Harmonic::n_below, "n_below", rpm, "next lower speed at a natural frequency; 0: none below"},
      Field{&Harmonic::n_above, "n_above", rpm, "next higher speed at a natural frequency"},
      Field{&Harmonic::u_h, "u_h", ratio, "torsional critical speed: required / actual separation from the nearer one"}
          .check()};
};

/// A mode in which the bent shaft goes around, forward with its turning or backward.
struct WhirlMode {
  Name name;
  AngularSpeed f_0 = unset<AngularSpeed>;
  AngularSpeed n_F = unset<AngularSpeed>, n_B = unset<AngularSpeed>;
  AngularSpeed f_F = unset<AngularSpeed>, f_B = unset<AngularSpeed>;
  static constexpr Fields fields{
      NameField{&WhirlMode::name, "name", "whirl mode"},
      Field{&WhirlMode::f_0, "f_0", Hz, "natural frequency of the shaft at standstill, with rotary inertia"},
      Field{&WhirlMode::n_F, "n_F", rpm, "critical speed of forward whirl (excited by unbalance)"},
      Field{&WhirlMode::n_B, "n_B", rpm, "critical speed of backward whirl"},
      Field{&WhirlMode::f_F, "f_F", Hz, "frequency of forward whirl at shaft speed"},
      Field{&WhirlMode::f_B, "f_B", Hz, "frequency of backward whirl at shaft speed"}};
};

/// Fatigue assessment of a section, by each method.
struct Safety {
  Name name;
  Length x = unset<Length>;
  double theta = unset<double>;
  double K_t = 1.0, K_ts = 1.0, K_f = unset<double>, K_fs = unset<double>;
  Stress S_e = unset<Stress>, sigma_a = unset<Stress>, sigma_m = unset<Stress>;
  double n_Goodman = unset<double>, n_Soderberg = unset<double>, n_Gerber = unset<double>, n_elliptic = unset<double>;
  double n_DIN743 = unset<double>, n_FKM = unset<double>, n_Serensen = unset<double>;
  double u_D = unset<double>;
  double x_DIN = unset<double>;
  double x_b = unset<double>, x_t = unset<double>, x_d = unset<double>, x_n = unset<double>;
  double x_r = unset<double>;
  static constexpr Fields fields{
      NameField{&Safety::name, "name", "name of the section"},
      Field{&Safety::x, "x", mm, "position"},
      Field{&Safety::theta, "theta", deg,
            "direction of the governing point, fixed to the shaft, from X at psi = 0 (loads over a "
            "revolution)"},
      Field{&Safety::K_t, "K_t", ratio, "stress concentration factor in bending"},
      Field{&Safety::K_ts, "K_ts", ratio, "stress concentration factor in torsion"},
      Field{&Safety::K_f, "K_f", ratio, "fatigue notch factor in bending"},
      Field{&Safety::K_fs, "K_fs", ratio, "fatigue notch factor in torsion"},
      Field{&Safety::S_e, "S_e", MPa, "fatigue limit of the part without the notch"},
      Field{&Safety::sigma_a, "sigma_a", MPa, "equivalent stress amplitude, with notches"},
      Field{&Safety::sigma_m, "sigma_m", MPa, "equivalent mean stress, with notches"},
      Field{&Safety::n_Goodman, "n_Goodman", ratio, "fatigue safety factor by Goodman"}.may_be_infinite(),
      Field{&Safety::n_Soderberg, "n_Soderberg", ratio, "fatigue safety factor by Soderberg"}.may_be_infinite(),
      Field{&Safety::n_Gerber, "n_Gerber", ratio, "fatigue safety factor by Gerber"}.may_be_infinite(),
      Field{&Safety::n_elliptic, "n_elliptic", ratio, "fatigue safety factor by the ASME ellipse"}.may_be_infinite(),
      Field{&Safety::n_DIN743, "n_DIN743", ratio, "fatigue safety factor by DIN 743"}.may_be_infinite(),
      Field{&Safety::n_FKM, "n_FKM", ratio, "fatigue safety factor by FKM"}.may_be_infinite(),
      Field{&Safety::n_Serensen, "n_Serensen", ratio, "fatigue safety factor by Serensen"}.may_be_infinite(),
      Field{&Safety::u_D, "u_D", ratio, "fatigue: required / calculated safety factor"}.check(),
      Field{&Safety::x_DIN, "x_DIN", ratio, "number of validity limits of DIN 743 or FKM exceeded, if they govern"}
          .limit(0, 0.5)
          .where_it_applies(),
      Field{&Safety::x_b, "x_b", ratio,
            "position of h/r, step height over fillet radius, in the range of K_t: 0 at 0.1 (groove 0.25), 1 at 20 "
            "(groove 50)"}
          .limit(-1e-9, 1 + 1e-9)
          .where_it_applies(),
      Field{&Safety::x_t, "x_t", ratio,
            "position of h/r, step height over fillet radius, in the range of K_ts: 0 at 0.25, 1 at 33 (shoulder) or "
            "50 (groove)"}
          .limit(-1e-9, 1 + 1e-9)
          .where_it_applies(),
      Field{&Safety::x_d, "x_d", ratio,
            "position of d in the range of the size factor: 0 at its minimum, 1 at its maximum"}
          .limit(0, 1 + 1e-9)
          .where_it_applies(),
      Field{&Safety::x_n, "x_n", ratio,
            "position of R_m in the range of Neuber's constant: 0 at its minimum, 1 at its maximum"}
          .limit(0, 1)
          .where_it_applies(),
      Field{&Safety::x_r, "x_r", ratio,
            "0.1 mm / notch radius (limit set by loadpath: sharper notches are treated as cracks)"}
          .limit(0, 1 + 1e-9)
          .where_it_applies()};
};

struct DesignResult {
  Length l = unset<Length>, d_max = unset<Length>, d_s = unset<Length>;
  double s_max = unset<double>;
  Mass mass = unset<Mass>;
  Moment M_max = unset<Moment>, T_max = unset<Moment>;
  Length v_max = unset<Length>;
  Twist theta_max = unset<Twist>;
  Moment T_theta = unset<Moment>;              // its torque
  SecondMoment I_theta = unset<SecondMoment>;  // and polar second moment of area
  double phi = unset<double>, psi = unset<double>;
  AngularSpeed n_c = unset<AngularSpeed>, n_R = unset<AngularSpeed>, n_D = unset<AngularSpeed>;
  AngularSpeed n_F = unset<AngularSpeed>;
  AngularSpeed n_T = unset<AngularSpeed>, n = unset<AngularSpeed>;
  double u_y = unset<double>, u_theta = unset<double>, u_n = unset<double>, x_E = unset<double>;
  List<Carried, most_supports> bearings;
  List<Seated, most_seats> seats;
  List<Harmonic, 2 * most_orders + 1> harmonics;
  List<WhirlMode, most_whirls> whirls;
  List<Section, most_places> sections;
  List<Safety, most_places> safeties;
};

}  // namespace loadpath::shaft
