// Parts of a shaft: shaft segments, bearings, mounted components, notches.
#pragma once

#include "calculators/load/connection.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/varying.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/quantity/units.hpp"

#include <array>

namespace loadpath::shaft {

/// A cylinder or a taper of the shaft.
struct Piece {
  Name name;
  Length l = unset<Length>, d = unset<Length>;
  Length d_bore = 0.0 * mm;
  Length d_2 = unset<Length>;
  static constexpr Fields fields{
      NameField{&Piece::name, "name", "name of the segment"}.may_be_missing(),
      Field{&Piece::l, "l", mm, "length"}.positive(),
      Field{&Piece::d, "d", mm, "outer diameter (taper: at the left end)"}.positive().usually(1, 2000).findable("R40"),
      Field{&Piece::d_2, "d_2", mm, "outer diameter at the right end (taper)"}
          .positive()
          .usually(1, 2000)
          .may_be_missing(),
      Field{&Piece::d_bore, "d_bore", mm, "bore diameter"}.at_least(0)};
};

enum class Holds { radial, both };
enum class On { cylinder, taper };

/// A bearing, in both planes alike.
struct Support {
  Name name;
  Length x = unset<Length>;
  Holds holds = Holds::radial;
  Stiffness k = unset<Stiffness>;
  double beta_adm = unset<double>;
  On on = On::cylinder;
  Length s_p = 0.0 * mm;
  static constexpr Fields fields{
      NameField{&Support::name, "name", "name of the bearing"}.may_be_missing(),
      Field{&Support::x, "x", mm, "position of the centre, from the left end of the shaft"}.at_least(0),
      Choice{&Support::holds, "holds", "loads that the bearing takes: radial, or radial and axial"}.may_be_missing(),
      Choice{&Support::on, "on", "bearing seat: cylinder or taper"}.may_be_missing(),
      Field{&Support::k, "k", N_per_mm, "radial stiffness of bearing and housing; omitted: rigid"}
          .positive()
          .may_be_missing(),
      Field{&Support::beta_adm, "beta_adm", deg, "allowable shaft slope at the bearing"}
          .positive()
          .usually(0.005, 5)
          .customarily_at_most(0.25)
          .may_be_missing(),
      Field{&Support::s_p, "s_p", mm,
            "offset of the pressure centre, where the reaction acts, from the centre x, positive to the right; "
            "single-row tapered roller and angular contact ball bearings: a - B/2, outward back to back, inward face "
            "to face"}};
};

/// Where the reaction of a bearing acts: at its pressure centre.
inline Length pressure_centre(const Support& support) { return support.x + support.s_p; }

enum class Way { takes, drives, balances };
/// Whether what sits there is one piece with the shaft.
enum class Integral { no, yes };

/// A mounted component that loads the shaft: a gear, a pulley, a sprocket, a coupling, a weight; a crank, whose
/// forces are known over a revolution.
struct Seat {
  Name name;
  Length x = unset<Length>;
  Way way = Way::takes;
  Varying<Moment> T = unset<Moment>;
  double angle = 0.0;
  Varying<Force> F_x = 0.0 * N.one, F_y = 0.0 * N.one, F_z = 0.0 * N.one;
  Varying<double> psi = unset<double>;
  Length x_w = 0.0 * mm;
  AngularSpeed n = unset<AngularSpeed>;
  Mass mass = unset<Mass>;
  MassMoment J = unset<MassMoment>, I_p = unset<MassMoment>, I_d = unset<MassMoment>;
  Length b = unset<Length>;
  Moment k_T = unset<Moment>;
  double beta_adm = unset<double>;
  Integral integral = Integral::no;
  Moment T_c = unset<Moment>, T_peak = unset<Moment>;
  Force F_c = unset<Force>;
  Length b_c = unset<Length>, l_c = unset<Length>;
  double r_c = unset<double>;
  Stress R_c = unset<Stress>;
  Length d_c = unset<Length>, t_c = unset<Length>, d_w = unset<Length>, d_f = unset<Length>, h_t = unset<Length>;
  Length b_r = unset<Length>, bore = unset<Length>, D_c = unset<Length>;
  AngularSpeed n_c = unset<AngularSpeed>;
  Mounted kind = Mounted::unsaid;
  Fastening fastening = Fastening::unsaid;
  static constexpr Fields fields{
      NameField{&Seat::name, "name", "name of the component"}.may_be_missing(),
      Field{&Seat::x, "x", mm, "position of the centre, from the left end of the shaft"}.at_least(0),
      RecordField<Seat>{
          "load",
          "shaft load of the mounted gear, belt, chain or crank: load = \"=gears.gear_2\", \"=press.shafts.O\""},
      Choice{&Seat::way, "way", "role of the component: takes power off, drives, or balances the torque"}
          .may_be_missing(),
      Field{&Seat::T, "T", N_m, "torque of the component; negative during part of a revolution if it returns some"}
          .load()
          .may_be_missing(),
      Field{&Seat::angle, "angle", deg, "direction to the mating part, or of the pull: angle of F_x from X to Y"},
      Field{&Seat::F_x, "F_x", N, "force toward the mating part, or along the pull; negative: away from it"}.load(),
      Field{&Seat::F_y, "F_y", N, "force perpendicular to F_x, 90° further from X to Y"}.load(),
      Field{&Seat::F_z, "F_z", N, "axial force, positive to the right"}.load(),
      Field{&Seat::psi, "psi", deg,
            "shaft angle at each position of a revolution, from X to Y; single value: shaft at rest"}
          .may_be_missing(),
      Field{&Seat::x_w, "x_w", mm, "distance from the axis to the point of action, toward the mating part"},
      Field{&Seat::n, "n", rpm, "speed, that of the shaft"}.of_body().may_be_missing(),
      Field{&Seat::mass, "mass", kg, "mass, for the critical speed and, with g_angle, the weight"}
          .at_least(0)
          .may_be_missing(),
      Field{&Seat::J, "J", kg_m2,
            "moment of inertia about the axis, with all that rotates with the component, for the "
            "torsional critical speed"}
          .at_least(0)
          .may_be_missing(),
      Field{&Seat::I_p, "I_p", kg_m2,
            "moment of inertia of the component about its axis, with I_d or b, for the lateral critical speed"}
          .at_least(0)
          .may_be_missing(),
      Field{&Seat::I_d, "I_d", kg_m2,
            "moment of inertia of the component about a diameter through its centre; thin disc: I_p/2"}
          .at_least(0)
          .may_be_missing(),
      Field{&Seat::b, "b", mm, "axial width of the component, uniform mass, replaces I_d"}.at_least(0).may_be_missing(),
      Field{&Seat::k_T, "k_T", N_m_per_rad,
            "torsional stiffness between the shaft and J (elastic coupling); omitted: rigid"}
          .positive()
          .may_be_missing(),
      Field{&Seat::beta_adm, "beta_adm", deg, "allowable shaft slope at the component"}
          .positive()
          .usually(0.005, 5)
          .customarily_at_most(1)
          .may_be_missing(),
      Choice{&Seat::integral, "integral", "integral with the shaft: no shaft-hub connection"}.may_be_missing(),
      RecordField<Seat>{
          "connection",
          "shaft-hub connection (key, spline, press fit, set screw or pin): connection = \"=key.connection\""},
      Field{&Seat::T_c, "T_c", N_m,
            "torque for which the shaft-hub connection is assessed, with the application factor"}
          .of_a_step()
          .positive()
          .may_be_missing(),
      Field{&Seat::T_peak, "T_peak", N_m,
            "peak torque (start, jam) for which the shaft-hub connection is assessed, compared with k_max T"}
          .of_a_step()
          .positive()
          .may_be_missing(),
      Field{&Seat::F_c, "F_c", N, "axial force that the shaft-hub connection, or an adjacent ring or nut, holds"}
          .of_a_step()
          .at_least(0)
          .may_be_missing(),
      Field{&Seat::b_c, "b_c", mm, "bore of the shaft in the calculation of the connection"}
          .at_least(0)
          .may_be_missing(),
      Field{&Seat::l_c, "l_c", mm, "axial length of the connection"}.positive().may_be_missing(),
      Field{&Seat::r_c, "r_c", ratio, "torque ratio T_min/T_max for which the connection is assessed"}
          .within(-1, 1)
          .may_be_missing(),
      Field{&Seat::R_c, "R_c", MPa, "yield strength of the shaft in the calculation of the connection"}
          .positive()
          .may_be_missing(),
      Field{&Seat::d_c, "d_c", mm, "shaft diameter of the connection"}.positive().may_be_missing(),
      Field{&Seat::t_c, "t_c", mm, "keyway depth in the hub"}.at_least(0).may_be_missing(),
      Field{&Seat::D_c, "D_c", mm, "outer diameter of the hub in the calculation of the connection"}
          .positive()
          .may_be_missing(),
      Field{&Seat::n_c, "n_c", rpm, "speed up to which the interference fit is assessed"}.at_least(0).may_be_missing(),
      Choice{&Seat::fastening, "fastening", "type of connection"}.may_be_missing(),
      Field{&Seat::d_w, "d_w", mm, "diameter at which the forces act, larger than the shaft"}
          .at_least(0)
          .of_body()
          .may_be_missing(),
      Field{&Seat::d_f, "d_f", mm,
            "root diameter of a gear or sprocket, groove bottom diameter of a pulley, for the wall thickness"}
          .positive()
          .of_body()
          .may_be_missing(),
      Field{&Seat::h_t, "h_t", mm, "tooth depth of a gear"}.positive().of_body().may_be_missing(),
      Field{&Seat::b_r, "b_r", mm, "rim width of a gear or pulley, for the hub length where b is missing"}
          .positive()
          .of_body()
          .may_be_missing(),
      Field{&Seat::bore, "bore", mm, "bore of a gear; equals the shaft diameter"}.positive().of_body().may_be_missing(),
      Choice{&Seat::kind, "kind", "mounted component"}.of_body().may_be_missing()};
};

/// Excitation order h that can make the shaft vibrate.
struct Order {
  Name name;
  double h = unset<double>;
  static constexpr Fields fields{
      NameField{&Order::name, "name", "excitation, e.g. tooth mesh of the pinion, firing of the engine"}
          .may_be_missing(),
      Field{&Order::h, "h", ratio, "excitations per revolution of the shaft"}.positive().usually(0.5, 500)};
};

enum class Notch {
  shoulder,
  groove,
  rectangular_groove,
  v_groove,
  keyway,
  two_keyways,
  press_fit,
  cross_hole,
  given,
  beta
};
constexpr bool is_keyed(Notch n) { return n == Notch::keyway || n == Notch::two_keyways; }
constexpr bool is_groove(Notch n) {
  return n == Notch::groove || n == Notch::rectangular_groove || n == Notch::v_groove;
}
/// Notches whose fatigue notch factor is from DIN 743, or typed, and not derived from K_t.
constexpr bool has_factors(Notch n) {
  return n == Notch::rectangular_groove || n == Notch::v_groove || n == Notch::press_fit || n == Notch::cross_hole ||
         n == Notch::beta;
}

/// A place where stress concentrates.
struct Notched {
  Name name;
  Length x = unset<Length>;
  Notch kind = Notch::shoulder;
  Length d = unset<Length>, r = unset<Length>, t = unset<Length>, w = unset<Length>;
  Length h = unset<Length>, l = unset<Length>;
  double K_t = unset<double>, K_ts = unset<double>, beta_b = unset<double>, beta_t = unset<double>, r_T = unset<double>;
  static constexpr Fields fields{
      NameField{&Notched::name, "name", "name of the notch"}.may_be_missing(),
      Field{&Notched::x, "x", mm, "position from the left end of the shaft (keyway: its end)"}.at_least(0),
      RecordField<Notched>{"part", "part that forms the notch: part = \"=key.notch\""},
      Choice{&Notched::kind, "kind", "notch type"},
      Field{&Notched::d, "d", mm, "shaft diameter at the notch"}.positive().may_be_missing(),
      Field{&Notched::r, "r", mm, "notch radius, or radius of a cross hole; keyway: 0.02 d"}
          .positive()
          .usually(0.1, 100)
          .may_be_missing(),
      Field{&Notched::t, "t", mm, "groove depth; in a hollow shaft also keyway or spline depth"}
          .positive()
          .may_be_missing(),
      Field{&Notched::w, "w", mm, "width of a rectangular groove"}.positive().may_be_missing(),
      Field{&Notched::h, "h", mm, "required shoulder height of the abutting part"}.positive().may_be_missing(),
      Field{&Notched::l, "l", mm, "key length from x along the hub: the other keyway end is included"}
          .positive()
          .may_be_missing(),
      Field{&Notched::K_t, "K_t", ratio, "stress concentration factor in bending, on the net section, of a given notch"}
          .within(1, 10)
          .may_be_missing(),
      Field{&Notched::K_ts, "K_ts", ratio, "factor in torsion, on the net section"}.within(1, 10).may_be_missing(),
      Field{&Notched::beta_b, "beta_b", ratio,
            "fatigue notch factor in bending, on the net section, from tests at this diameter"}
          .within(1, 10)
          .may_be_missing(),
      Field{&Notched::beta_t, "beta_t", ratio, "factor in torsion, on the net section"}.within(1, 10).may_be_missing(),
      Field{&Notched::r_T, "r_T", ratio,
            "torque ratio T_min/T_max of the part that forms the notch: -1 for a key under reversing torque"}
          .within(-1, 1)
          .may_be_missing()};
};

constexpr auto choices_of(Holds) {
  return std::array{ChoiceName<Holds>{Holds::radial, "radial", "radial forces: non-locating bearing"},
                    ChoiceName<Holds>{Holds::both, "both", "radial and axial forces: locating bearing"}};
}
constexpr auto choices_of(On) {
  return std::array{ChoiceName<On>{On::cylinder, "cylinder", "a cylinder, as bores of bearings are"},
                    ChoiceName<On>{On::taper, "taper", "a taper: its own bore is one, or that of its sleeve"}};
}
constexpr auto choices_of(Way) {
  return std::array{ChoiceName<Way>{Way::takes, "takes", "driven component, torque output"},
                    ChoiceName<Way>{Way::drives, "drives", "driving component, torque input"},
                    ChoiceName<Way>{Way::balances, "balances", "balancing component (coupling)"}};
}
constexpr auto choices_of(Integral) {
  return std::array{ChoiceName<Integral>{Integral::no, "false", "separate part, fastened to the shaft"},
                    ChoiceName<Integral>{Integral::yes, "true", "integral with the shaft"}};
}
constexpr auto choices_of(Notch) {
  return std::array{
      ChoiceName<Notch>{Notch::shoulder, "shoulder", "fillet of radius r where the diameter changes"},
      ChoiceName<Notch>{Notch::groove, "groove", "round groove of depth t and radius r"},
      ChoiceName<Notch>{Notch::rectangular_groove, "rectangular-groove",
                        "groove of depth t and width w with r at its edges, of a retaining ring"},
      ChoiceName<Notch>{Notch::v_groove, "v-groove", "V-groove of depth t; a thread of that depth"},
      ChoiceName<Notch>{Notch::keyway, "keyway", "end of a keyway, end-milled"},
      ChoiceName<Notch>{Notch::two_keyways, "two-keyways", "ends of two keyways around the shaft"},
      ChoiceName<Notch>{Notch::press_fit, "press-fit", "end of a press-fitted hub"},
      ChoiceName<Notch>{Notch::cross_hole, "cross-hole", "cross hole of radius r"},
      ChoiceName<Notch>{Notch::given, "given", "other notch, by K_t, K_ts and r"},
      ChoiceName<Notch>{Notch::beta, "beta", "other notch (e.g. spline), by fatigue notch factors from tests"}};
}

/// The end of a keyway, an input record of a shaft.
struct KeyNotch {
  Notch kind = Notch::keyway;
  Length d = unset<Length>, t = unset<Length>, l = unset<Length>;
  double r_T = unset<double>;
  static constexpr Fields fields{
      Choice{&KeyNotch::kind, "kind", "notch type"}, Field{&KeyNotch::d, "d", mm, "shaft diameter"},
      Field{&KeyNotch::t, "t", mm, "keyway depth"}, Field{&KeyNotch::l, "l", mm, "length of the key"},
      Field{&KeyNotch::r_T, "r_T", ratio, "torque ratio T_min/T_max: -1 for a reversing torque"}};
};

/// The end of a spline, an input record of a shaft; its notch factors are those of tests.
struct SplineNotch {
  Notch kind = Notch::beta;
  Length d = unset<Length>, t = unset<Length>;
  double beta_b = unset<double>, beta_t = unset<double>, r_T = unset<double>;
  static constexpr Fields fields{
      Choice{&SplineNotch::kind, "kind", "notch type"},
      Field{&SplineNotch::d, "d", mm, "shaft diameter"},
      Field{&SplineNotch::t, "t", mm, "depth of the teeth below the shaft diameter"},
      Field{&SplineNotch::beta_b, "beta_b", ratio, "fatigue notch factor in bending"},
      Field{&SplineNotch::beta_t, "beta_t", ratio, "fatigue notch factor in torsion"},
      Field{&SplineNotch::r_T, "r_T", ratio, "torque ratio T_min/T_max: -1 for a reversing torque"}};
};

/// The groove of a retaining ring, an input record of a shaft.
struct RingNotch {
  Notch kind = Notch::rectangular_groove;
  Length d = unset<Length>, t = unset<Length>, w = unset<Length>, r = unset<Length>;
  static constexpr Fields fields{
      Choice{&RingNotch::kind, "kind", "notch type"},
      Field{&RingNotch::d, "d", mm, "shaft diameter next to the groove"}, Field{&RingNotch::t, "t", mm, "groove depth"},
      Field{&RingNotch::w, "w", mm, "groove width"}, Field{&RingNotch::r, "r", mm, "fillet radius of the groove"}};
};

}  // namespace loadpath::shaft
