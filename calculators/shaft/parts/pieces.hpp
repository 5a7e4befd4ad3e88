// What a shaft is made of and what sits on it: pieces, bearings, seats, notches.
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
      NameField{&Piece::name, "name", "what the piece is"}.may_be_missing(),
      Field{&Piece::l, "l", mm, "length"}.positive(),
      Field{&Piece::d, "d", mm, "outer diameter; of a taper at its left end"}.positive().usually(1, 2000).findable(
          "R40"),
      Field{&Piece::d_2, "d_2", mm, "outer diameter at its right end, of a taper"}
          .positive()
          .usually(1, 2000)
          .may_be_missing(),
      Field{&Piece::d_bore, "d_bore", mm, "diameter of the bore"}.at_least(0)};
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
  static constexpr Fields fields{
      NameField{&Support::name, "name", "name of the bearing"}.may_be_missing(),
      Field{&Support::x, "x", mm, "its middle, from the left end of the shaft"}.at_least(0),
      Choice{&Support::holds, "holds", "what the bearing takes"}.may_be_missing(),
      Choice{&Support::on, "on", "what it sits on"}.may_be_missing(),
      Field{&Support::k, "k", N_per_mm, "radial stiffness of bearing and housing; missing: rigid"}
          .positive()
          .may_be_missing(),
      Field{&Support::beta_adm, "beta_adm", deg, "allowable slope of the shaft in it"}
          .positive()
          .usually(0.005, 5)
          .may_be_missing()};
};

enum class Way { takes, drives, balances };
/// Whether what sits there is one piece with the shaft.
enum class Integral { no, yes };

/// What sits on the shaft and loads it: a gear, a pulley, a sprocket, a coupling, a weight; a crank, whose forces are
/// known over a turn.
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
      NameField{&Seat::name, "name", "what sits there"}.may_be_missing(),
      Field{&Seat::x, "x", mm, "its middle, from the left end of the shaft"}.at_least(0),
      RecordField<Seat>{"load",
                        "gear, belt, chain or crank that sits there, whole: load = \"=gears.gear_2\", "
                        "\"=press.shafts.O\""},
      Choice{&Seat::way, "way", "what it does with the torque"}.may_be_missing(),
      Field{&Seat::T, "T", N_m, "its torque; below zero in a part of a turn where it gives some back"}
          .load()
          .may_be_missing(),
      Field{&Seat::angle, "angle", deg, "direction to its mate, or of the pull: F_x against X, from X to Y"},
      Field{&Seat::F_x, "F_x", N, "force toward its mate, or along the pull; negative away from it"}.load(),
      Field{&Seat::F_y, "F_y", N, "force across, a quarter turn further"}.load(),
      Field{&Seat::F_z, "F_z", N, "force along the shaft, positive to the right"}.load(),
      Field{&Seat::psi, "psi", deg,
            "angle of the shaft at each position of a turn, from X to Y; one value: the shaft stands"}
          .may_be_missing(),
      Field{&Seat::x_w, "x_w", mm, "from the axis to the point where the forces act, toward the mate"},
      Field{&Seat::n, "n", rpm, "its speed, which is that of the shaft"}.of_body().may_be_missing(),
      Field{&Seat::mass, "mass", kg, "mass, for the critical speed, and the weight where that counts"}
          .at_least(0)
          .may_be_missing(),
      Field{&Seat::J, "J", kg_m2,
            "moment of inertia about the axis of all that turns with it, for the critical speed in torsion"}
          .at_least(0)
          .may_be_missing(),
      Field{&Seat::I_p, "I_p", kg_m2,
            "of what sits there alone: moment of inertia about the axis, with I_d or b, for the critical speed in "
            "bending"}
          .at_least(0)
          .may_be_missing(),
      Field{&Seat::I_d, "I_d", kg_m2, "the same about a diameter through its middle; of a thin disc I_p/2"}
          .at_least(0)
          .may_be_missing(),
      Field{&Seat::b, "b", mm, "width of its body along the shaft, mass even along it, in place of I_d"}
          .at_least(0)
          .may_be_missing(),
      Field{&Seat::k_T, "k_T", N_m_per_rad,
            "stiffness in torsion between the shaft and J, of an elastic coupling; missing: rigid"}
          .positive()
          .may_be_missing(),
      Field{&Seat::beta_adm, "beta_adm", deg, "allowable slope of the shaft under it"}
          .positive()
          .usually(0.005, 5)
          .may_be_missing(),
      Choice{&Seat::integral, "integral", "whether it is one piece with the shaft: no connection is needed"}
          .may_be_missing(),
      RecordField<Seat>{"connection",
                        "the key, spline, press fit, set screw or pin that fastens it, whole: connection = "
                        "\"=key.connection\""},
      Field{&Seat::T_c, "T_c", N_m, "torque that its connection is assessed for, with the service factor; a rating"}
          .positive()
          .may_be_missing(),
      Field{&Seat::T_peak, "T_peak", N_m, "the same of a start or a jam, against k_max times the torque"}
          .positive()
          .may_be_missing(),
      Field{&Seat::F_c, "F_c", N, "force along the shaft that its connection, or a ring or nut beside it, holds"}
          .at_least(0)
          .may_be_missing(),
      Field{&Seat::b_c, "b_c", mm, "bore of the shaft that its connection is calculated with"}
          .at_least(0)
          .may_be_missing(),
      Field{&Seat::l_c, "l_c", mm, "length of its connection along the shaft"}.positive().may_be_missing(),
      Field{&Seat::r_c, "r_c", ratio, "least over largest torque that its connection is assessed for"}
          .within(-1, 1)
          .may_be_missing(),
      Field{&Seat::R_c, "R_c", MPa, "yield strength of the shaft that its connection is calculated with"}
          .positive()
          .may_be_missing(),
      Field{&Seat::d_c, "d_c", mm, "shaft diameter that its connection is made for"}.positive().may_be_missing(),
      Field{&Seat::t_c, "t_c", mm, "depth of the keyway in the hub"}.at_least(0).may_be_missing(),
      Field{&Seat::D_c, "D_c", mm, "outer diameter of the hub in the calculation of the connection"}
          .positive()
          .may_be_missing(),
      Field{&Seat::n_c, "n_c", rpm, "speed up to which the interference fit is assessed"}.at_least(0).may_be_missing(),
      Choice{&Seat::fastening, "fastening", "type of connection"}.may_be_missing(),
      Field{&Seat::d_w, "d_w", mm, "diameter that the forces act at: more than that of the shaft"}
          .at_least(0)
          .of_body()
          .may_be_missing(),
      Field{&Seat::d_f, "d_f", mm,
            "root diameter of a gear or sprocket, groove bottom diameter of a pulley, for the wall thickness"}
          .positive()
          .of_body()
          .may_be_missing(),
      Field{&Seat::h_t, "h_t", mm, "tooth height of a gear"}.positive().of_body().may_be_missing(),
      Field{&Seat::b_r, "b_r", mm, "rim width of a gear or pulley, for the hub length where b is missing"}
          .positive()
          .of_body()
          .may_be_missing(),
      Field{&Seat::bore, "bore", mm, "bore of a gear; equals the shaft diameter"}.positive().of_body().may_be_missing(),
      Choice{&Seat::kind, "kind", "mounted component"}.of_body().may_be_missing()};
};

/// What comes h times in a turn and can make the shaft swing.
struct Order {
  Name name;
  double h = unset<double>;
  static constexpr Fields fields{
      NameField{&Order::name, "name", "what comes: the teeth of the pinion, the strokes of the engine"}
          .may_be_missing(),
      Field{&Order::h, "h", ratio, "how often in a turn of the shaft"}.positive().usually(0.5, 500)};
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
/// Those whose notch factor is told by DIN 743, or typed, and not made of K_t.
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
      NameField{&Notched::name, "name", "what it is"}.may_be_missing(),
      Field{&Notched::x, "x", mm, "place, from the left end of the shaft; of a keyway its end"}.at_least(0),
      RecordField<Notched>{"part", "what makes it, whole: part = \"=key.notch\""},
      Choice{&Notched::kind, "kind", "kind of notch"},
      Field{&Notched::d, "d", mm, "diameter that it is made for: that of the shaft there"}.positive().may_be_missing(),
      Field{&Notched::r, "r", mm, "radius of its root, or of a cross hole; of a keyway 0.02 d"}
          .positive()
          .usually(0.1, 100)
          .may_be_missing(),
      Field{&Notched::t, "t", mm, "depth of a groove; in a hollow shaft that of the seat of a key, or of splines"}
          .positive()
          .may_be_missing(),
      Field{&Notched::w, "w", mm, "width of a rectangular groove"}.positive().may_be_missing(),
      Field{&Notched::h, "h", mm, "least height of a shoulder, for what is set against it"}.positive().may_be_missing(),
      Field{&Notched::l, "l", mm, "length of a key, from x over the seat that it holds: its other end counts as well"}
          .positive()
          .may_be_missing(),
      Field{&Notched::K_t, "K_t", ratio, "stress concentration in bending, on the net section, of a given notch"}
          .within(1, 10)
          .may_be_missing(),
      Field{&Notched::K_ts, "K_ts", ratio, "the same in torsion"}.within(1, 10).may_be_missing(),
      Field{&Notched::beta_b, "beta_b", ratio,
            "notch factor in bending, on the net section, of tests with this diameter"}
          .within(1, 10)
          .may_be_missing(),
      Field{&Notched::beta_t, "beta_t", ratio, "the same in torsion"}.within(1, 10).may_be_missing(),
      Field{&Notched::r_T, "r_T", ratio,
            "least over largest torque of what makes it: -1 of a key that is beaten both ways"}
          .within(-1, 1)
          .may_be_missing()};
};

constexpr auto choices_of(Holds) {
  return std::array{ChoiceName<Holds>{Holds::radial, "radial", "forces across the shaft: a floating bearing"},
                    ChoiceName<Holds>{Holds::both, "both", "forces across and along: the fixed bearing"}};
}
constexpr auto choices_of(On) {
  return std::array{ChoiceName<On>{On::cylinder, "cylinder", "a cylinder, as bores of bearings are"},
                    ChoiceName<On>{On::taper, "taper", "a taper: its own bore is one, or that of its sleeve"}};
}
constexpr auto choices_of(Way) {
  return std::array{ChoiceName<Way>{Way::takes, "takes", "takes the torque from the shaft"},
                    ChoiceName<Way>{Way::drives, "drives", "drives the shaft"},
                    ChoiceName<Way>{Way::balances, "balances", "gives or takes what the others leave: a coupling"}};
}
constexpr auto choices_of(Integral) {
  return std::array{ChoiceName<Integral>{Integral::no, "false", "it is fastened to the shaft"},
                    ChoiceName<Integral>{Integral::yes, "true", "it is one piece with the shaft"}};
}
constexpr auto choices_of(Notch) {
  return std::array{ChoiceName<Notch>{Notch::shoulder, "shoulder", "fillet of radius r where the diameter changes"},
                    ChoiceName<Notch>{Notch::groove, "groove", "round groove of depth t and radius r"},
                    ChoiceName<Notch>{Notch::rectangular_groove, "rectangular-groove",
                                      "groove of depth t and width w with r at its edges, of a retaining ring"},
                    ChoiceName<Notch>{Notch::v_groove, "v-groove", "V-groove of depth t; a thread of that depth"},
                    ChoiceName<Notch>{Notch::keyway, "keyway", "end of a keyway, end-milled"},
                    ChoiceName<Notch>{Notch::two_keyways, "two-keyways", "ends of two keyways around the shaft"},
                    ChoiceName<Notch>{Notch::press_fit, "press-fit", "end of a hub that is pressed on"},
                    ChoiceName<Notch>{Notch::cross_hole, "cross-hole", "hole of radius r across the shaft"},
                    ChoiceName<Notch>{Notch::given, "given", "anything else, by its K_t, K_ts and r"},
                    ChoiceName<Notch>{Notch::beta, "beta", "anything else, by notch factors of tests: splines"}};
}

/// The end of the seat of a key, for a shaft to take whole.
struct KeyNotch {
  Notch kind = Notch::keyway;
  Length d = unset<Length>, t = unset<Length>, l = unset<Length>;
  double r_T = unset<double>;
  static constexpr Fields fields{
      Choice{&KeyNotch::kind, "kind", "kind of notch"}, Field{&KeyNotch::d, "d", mm, "diameter that it is made for"},
      Field{&KeyNotch::t, "t", mm, "depth of the seat"}, Field{&KeyNotch::l, "l", mm, "length of the key"},
      Field{&KeyNotch::r_T, "r_T", ratio, "-1 where the torque changes its sense"}};
};

/// The end of a spline, for a shaft to take whole; its notch factors are those of tests.
struct SplineNotch {
  Notch kind = Notch::beta;
  Length d = unset<Length>, t = unset<Length>;
  double beta_b = unset<double>, beta_t = unset<double>, r_T = unset<double>;
  static constexpr Fields fields{Choice{&SplineNotch::kind, "kind", "kind of notch"},
                                 Field{&SplineNotch::d, "d", mm, "diameter that it is made for"},
                                 Field{&SplineNotch::t, "t", mm, "depth of its teeth below that"},
                                 Field{&SplineNotch::beta_b, "beta_b", ratio, "notch factor in bending"},
                                 Field{&SplineNotch::beta_t, "beta_t", ratio, "notch factor in torsion"},
                                 Field{&SplineNotch::r_T, "r_T", ratio, "-1 where the torque changes its sense"}};
};

/// The groove of a retaining ring, for a shaft to take whole.
struct RingNotch {
  Notch kind = Notch::rectangular_groove;
  Length d = unset<Length>, t = unset<Length>, w = unset<Length>, r = unset<Length>;
  static constexpr Fields fields{Choice{&RingNotch::kind, "kind", "kind of notch"},
                                 Field{&RingNotch::d, "d", mm, "diameter of the shaft beside it"},
                                 Field{&RingNotch::t, "t", mm, "its depth"}, Field{&RingNotch::w, "w", mm, "its width"},
                                 Field{&RingNotch::r, "r", mm, "radius at its edges"}};
};

}  // namespace loadpath::shaft
