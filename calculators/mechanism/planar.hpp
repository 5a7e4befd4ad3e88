// A planar mechanism in a project: links, joints, drives and loads as a user writes them.
//
// Decides positions, velocities, accelerations, the reaction of every joint and the driving moment or force, over a
// turn of the crank, over strokes of cylinders, or at given positions (lib/mechanism). Rigid links; play counts as an
// error only. Signs: moments counter-clockwise positive; a joint's force is that of its first link on its second
// (R_12). A link's points are written in its own axes, or, where neither origin nor angle is given, as drawn on paper.
#pragma once

#include "calculators/mechanism/cam_profile.hpp"
#include "calculators/mechanism/planar_design.hpp"
#include "lib/field.hpp"

#include <array>

namespace loadpath {

struct PlanarMechanism {
  static constexpr auto id = "mechanism.planar";
  static constexpr auto title = "Planar mechanism";
  static constexpr auto scope =
      "Motion, joint reactions and driving effort of a planar mechanism with pins, slides, slots, gears, belts, cams, "
      "rolling wheels and friction, with masses and loads, over a cycle or at given positions. Rigid links; play "
      "counts "
      "as an error of outputs, elasticity is not covered.";
  static constexpr auto source = "[A10], [B29], [B31], [D3]";
  static constexpr auto example = R"([project]
title = "Slider-crank"

[press]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "60 rpm", positions = 72 }

[press.ground]
O = ["0 mm", "0 mm"]
B = ["0 mm", "0 mm"]

[press.links.crank]
points = { O = ["0 mm", "0 mm"], A = ["50 mm", "0 mm"] }
angle = "30 deg"

[press.links.rod]
points = { A = ["0 mm", "0 mm"], B = ["200 mm", "0 mm"] }
angle = "-7 deg"

[press.links.slider]
points = { B = ["0 mm", "0 mm"] }
angle = "0 deg"
mass = "2 kg"

[press.joints]
O = { type = "revolute", links = ["crank", "ground"] }
A = { type = "revolute", links = ["crank", "rod"] }
B = { type = "revolute", links = ["rod", "slider"] }
guide = { type = "prismatic", links = ["slider", "ground"], points = ["B", "B"] }

[[press.loads]]
link = "slider"
at = "B"
F_x = "-1 kN"
F_y = "0 N"
)";

  /// A point of a link: Cartesian, or by distance and angle.
  struct Point {
    Name name;
    Length x = unset<Length>, y = unset<Length>, r = unset<Length>;
    double angle = unset<double>;
    static constexpr std::tuple fields{
        NameField{&Point::name, "name", "name of the point"},
        Field{&Point::x, "x", mm, "along the axes of the link"}.may_be_missing(),
        Field{&Point::y, "y", mm, "across them"}.may_be_missing(),
        Field{&Point::r, "r", mm, "distance from the origin, in place of x and y"}.may_be_missing(),
        Field{&Point::angle, "angle", deg, "direction of that distance, from the x axis"}.may_be_missing()};
  };
  struct Origin {
    Length x = unset<Length>, y = unset<Length>;
    static constexpr std::tuple fields{Field{&Origin::x, "x", mm, "global"}, Field{&Origin::y, "y", mm, "global"}};
  };
  struct Pair {
    Name first, second;
    static constexpr std::tuple fields{NameField{&Pair::first, "first", "of the first link"},
                                       NameField{&Pair::second, "second", "of the second link"}};
  };

  enum class MassLine { automatic, uniform, lumped };
  enum class Masses { as_given, two_points, three_points };
  struct Link {
    Name name;
    List<Point, 16> points;
    Mass mass = 0.0 * kg.one;
    MassMoment J = 0.0 * kg_m2.one;
    Name S;
    Origin origin;
    double angle = unset<double>;
    MassLine mass_line = MassLine::automatic;
    Masses masses = Masses::as_given;
    Pair mass_points;
    static constexpr std::tuple fields{
        NameField{&Link::name, "name", "name of the link"},
        ListField{&Link::points, "points",
                  "points in the link's axes, or as drawn where it has neither origin nor angle"}
            .as_arrays(),
        Field{&Link::mass, "mass", kg, "mass"}.at_least(0),
        Field{&Link::J, "J", kg_m2,
              "moment of inertia about the mass centre; where missing 0, for a template's bar that of a slender bar"}
            .at_least(0),
        NameField{&Link::S, "S",
                  "point that is the mass centre; where missing the origin, for a template's bar its middle S_LINK"}
            .may_be_missing(),
        Group{&Link::origin, "origin", "rough place of the link's origin in the stated assembly"}
            .as_array()
            .may_be_missing(),
        Field{&Link::angle, "angle", deg, "rough angle of the link in the stated assembly"}.may_be_missing(),
        Choice{&Link::mass_line, "mass_line", "how its mass lies along its axis, for its internal forces"}
            .may_be_missing(),
        Choice{&Link::masses, "masses", "whether its mass is reduced to points, and to which"}.may_be_missing(),
        Group{&Link::mass_points, "mass_points", "two of its points, on a line with S, that the mass is reduced to"}
            .as_array()
            .may_be_missing()};
  };

  enum class Type {
    revolute,
    prismatic,
    slot,
    rigid,
    gear,
    ring_gear,
    rack,
    belt,
    crossed_belt,
    rolling,
    rolling_inside,
    rolling_on_line,
    cam,
    cam_flat
  };
  enum class Holding { one_side, groove };
  struct Radii {
    Length first = unset<Length>, second = unset<Length>;
    static constexpr std::tuple fields{Field{&Radii::first, "first", mm, "of the first link's wheel"}.positive(),
                                       Field{&Radii::second, "second", mm, "of the second link's wheel"}.positive()};
  };
  struct Joint {
    Name name;
    Type type = Type::revolute;
    Pair links, points;
    double direction = 0.0;
    double angle = unset<double>;
    Radii radii;
    Length radius = unset<Length>;
    double pressure_angle = pi / 9.0;
    Name profile;
    double face = 0.0;
    Holding holding = Holding::one_side;
    Force slack = 0.0 * N.one;
    double mu = 0.0;
    Length pin_radius = unset<Length>, guide_length = unset<Length>, guide_width = unset<Length>;
    Length rolling_arm = 0.0 * m.one, clearance = 0.0 * m.one;
    double efficiency = 1.0, efficiency_back = unset<double>;
    Damping c = 0.0 * N_s_per_m.one;
    TurningDamping c_turn = 0.0 * N_m_s.one;
    static constexpr std::tuple fields{
        NameField{&Joint::name, "name",
                  "name of the joint; also of its point on both links unless points says otherwise"},
        Choice{&Joint::type, "type", "kind of joint"},
        Group{&Joint::links, "links", "the two links; the ground is called ground"}.as_array(),
        Group{&Joint::points, "points", "point of the first and of the second link; of wheels their centres"}
            .as_array()
            .may_be_missing(),
        Field{&Joint::direction, "direction", deg,
              "of the guide, slot or rack through the second link's point, or of its profile's x axis, in that link's "
              "axes"},
        Field{&Joint::angle, "angle", deg,
              "prismatic, rigid: angle of the first link against the second; as assembled where missing"}
            .may_be_missing(),
        Group{&Joint::radii, "radii", "two wheels: their pitch or rolling radii"}.as_array().may_be_missing(),
        Field{&Joint::radius, "radius", mm,
              "rack, rolling_on_line: radius of the first link's wheel; cam: of its roller, where missing that of the "
              "profile"}
            .positive()
            .may_be_missing(),
        Field{&Joint::pressure_angle, "pressure_angle", deg, "teeth: angle of the force against the pitch line"}.within(
            0, 45),
        NameField{&Joint::profile, "profile", "cam, cam_flat: profile of the second link, one of the profiles"}
            .may_be_missing(),
        Field{&Joint::face, "face", deg, "cam_flat: direction of the flat face, in the first link's axes"},
        Choice{&Joint::holding, "holding", "cam, cam_flat: whether the cam can also pull"}.may_be_missing(),
        Field{&Joint::slack, "slack", N, "belts: tension of the slack span"}.at_least(0),
        Field{&Joint::mu, "mu", ratio,
              "coefficient of friction: revolute, prismatic, slot, cam_flat, and an edge on a cam"}
            .within(0, 2),
        Field{&Joint::pin_radius, "pin_radius", mm, "revolute, slot: radius of the pin"}.positive().may_be_missing(),
        Field{&Joint::guide_length, "guide_length", mm,
              "prismatic: length of the block about the first link's point, for the forces on its edges"}
            .positive()
            .may_be_missing(),
        Field{&Joint::guide_width, "guide_width", mm, "prismatic: distance between the two faces that it rests on"}
            .at_least(0)
            .may_be_missing(),
        Field{&Joint::rolling_arm, "rolling_arm", mm, "rolling: lever arm of the rolling resistance"}.at_least(0),
        Field{&Joint::efficiency, "efficiency", ratio, "teeth, belts: power passed on over power taken in"}.within(0.01,
                                                                                                                   1),
        Field{&Joint::efficiency_back, "efficiency_back", ratio,
              "the same when the second link drives; as efficiency where missing, negative where that locks (worms)"}
            .within(-20, 1)
            .may_be_missing(),
        Field{&Joint::c, "c", N_s_per_m, "prismatic, slot: viscous resistance to sliding"}.at_least(0),
        Field{&Joint::c_turn, "c_turn", N_m_s, "revolute, rolling: viscous resistance to turning"}.at_least(0),
        Field{&Joint::clearance, "clearance", mm,
              "revolute: play of the pin in its diameter, which shifts it by half of that either way"}
            .at_least(0)};
  };

  enum class Impending { either, forward, backward };
  enum class LawShape { spline, monotone };

  struct Crank {
    Name joint, to;
    AngularSpeed speed = 0.0 * rad_per_s.one;
    AngularAcceleration acceleration = 0.0 * rad_per_s2.one;
    double start = 0.0;
    int positions = 360, turns = 1;
    struct Place {
      double angle = unset<double>;
      static constexpr std::tuple fields{Field{&Place::angle, "angle", deg, "crank angle"}.within(-3600, 3600)};
    };
    List<Place, 64> at;
    struct Moment {
      Time t = unset<Time>;
      double angle = unset<double>;
      static constexpr std::tuple fields{Field{&Moment::t, "t", sec, "time"},
                                         Field{&Moment::angle, "angle", deg, "crank angle then"}.within(-36000, 36000)};
    };
    List<Moment, 64> law;
    LawShape law_shape = LawShape::spline;
    Formula angle_of_t;
    Time duration = unset<Time>;
    Impending impending = Impending::either;
    static constexpr std::tuple fields{
        NameField{&Crank::joint, "joint", "revolute joint that is driven"},
        NameField{&Crank::to, "to",
                  "point of the driven link that the crank angle is measured to; the link's x axis where missing"}
            .may_be_missing(),
        Field{&Crank::speed, "speed", rad_per_s, "angular speed, counter-clockwise positive"},
        Field{&Crank::acceleration, "acceleration", rad_per_s2, "angular acceleration at every position"},
        Field{&Crank::start, "start", deg, "crank angle of the first position of a turn"}.within(-3600, 3600),
        Count{&Crank::positions, "positions", 8, 7200, "positions of a cycle"},
        Count{&Crank::turns, "turns", 1, 100, "turns of the crank until the mechanism is back where it was"},
        ListField{&Crank::at, "at", "given crank angles, rising or falling, in place of a whole turn"}
            .as_arrays()
            .may_be_missing(),
        ListField{&Crank::law, "law",
                  "crank angles over time, in place of a turn at a given speed; smooth, from rest to rest"}
            .as_arrays()
            .may_be_missing(),
        Choice{&Crank::law_shape, "law_shape", "how 'law' runs between its points"}.may_be_missing(),
        FormulaField{&Crank::angle_of_t, "angle_of_t",
                     "crank angle as a formula of the time t, in place of a law by points: 30 deg + 9 deg*sin(t/(1 s))"}
            .may_be_missing(),
        Field{&Crank::duration, "duration", sec, "time for which the formula holds, from t = 0 s"}
            .positive()
            .may_be_missing(),
        Choice{&Crank::impending, "impending", "which way a crank at rest is about to turn: the sense of friction"}
            .may_be_missing()};
  };

  struct Cylinder {
    Name name, joint;
    Speed speed = 0.0 * m_per_s.one;
    Acceleration acceleration = 0.0 * m_per_s2.one;
    Length from = unset<Length>, to = unset<Length>;
    struct Moment {
      Time t = unset<Time>;
      Length place = unset<Length>;
      static constexpr std::tuple fields{Field{&Moment::t, "t", sec, "time"},
                                         Field{&Moment::place, "place", mm, "place along the guide then"}};
    };
    List<Moment, 64> law;
    LawShape law_shape = LawShape::spline;
    Formula place_of_t;
    Time duration = unset<Time>;
    Impending impending = Impending::either;
    static constexpr std::tuple fields{
        NameField{&Cylinder::name, "name", "name of the drive"},
        NameField{&Cylinder::joint, "joint", "prismatic or slot joint that is driven"},
        Field{&Cylinder::speed, "speed", m_per_s, "speed of the first link along the guide"},
        Field{&Cylinder::acceleration, "acceleration", m_per_s2, "acceleration along the guide"},
        Field{&Cylinder::from, "from", mm, "place at the first position; as assembled where missing"}.may_be_missing(),
        Field{&Cylinder::to, "to", mm, "place at the last position of a stroke"}.may_be_missing(),
        ListField{&Cylinder::law, "law", "places over time, in place of a stroke; smooth, from rest to rest"}
            .as_arrays()
            .may_be_missing(),
        Choice{&Cylinder::law_shape, "law_shape", "how 'law' runs between its points"}.may_be_missing(),
        FormulaField{&Cylinder::place_of_t, "place_of_t",
                     "place along the guide as a formula of the time t, in place of a law by points"}
            .may_be_missing(),
        Field{&Cylinder::duration, "duration", sec, "time for which the formula holds, from t = 0 s"}
            .positive()
            .may_be_missing(),
        Choice{&Cylinder::impending, "impending", "which way a drive at rest is about to move: the sense of friction"}
            .may_be_missing()};
  };

  enum class Axes { fixed, link };
  enum class Useful { no, yes };
  struct Share {
    double angle = unset<double>, share = unset<double>;
    static constexpr std::tuple fields{Field{&Share::angle, "angle", deg, "crank angle"}.within(-3600, 3600),
                                       Field{&Share::share, "share", ratio, "share of F and M there"}};
  };
  struct Load {
    Name name, link, at;
    Force F = unset<Force>;
    double direction = unset<double>;
    Force F_x = unset<Force>, F_y = unset<Force>;
    Moment M = unset<Moment>;
    Axes axes = Axes::fixed;
    List<Share, 24> over;
    Useful useful = Useful::no;
    static constexpr std::tuple fields{
        NameField{&Load::name, "name", "name of the load"}.may_be_missing(),
        NameField{&Load::link, "link", "link that it acts on"},
        NameField{&Load::at, "at", "point that the force acts at"}.may_be_missing(),
        Field{&Load::F, "F", N, "force, with its direction"}.may_be_missing(),
        Field{&Load::direction, "direction", deg, "direction of the force, from the x axis"}.may_be_missing(),
        Field{&Load::F_x, "F_x", N, "force along x, in place of F and direction"}.may_be_missing(),
        Field{&Load::F_y, "F_y", N, "force along y"}.may_be_missing(),
        Field{&Load::M, "M", N_m, "couple, counter-clockwise positive"}.may_be_missing(),
        Choice{&Load::axes, "axes", "axes of direction, F_x and F_y"}.may_be_missing(),
        ListField{
            &Load::over, "over",
            "shares of F and M over the crank angle, rising, straight from each to the next and round to the first"}
            .as_arrays()
            .may_be_missing(),
        Choice{&Load::useful, "useful",
               "whether the work against it is what the machine is for: the efficiency counts it"}
            .may_be_missing()};
  };

  struct Spring {
    Name name;
    Pair links, points;
    Stiffness k = 0.0 * N_per_mm.one;
    Length free = unset<Length>;
    Damping c = 0.0 * N_s_per_m.one;
    Moment k_turn = 0.0 * N_m_per_rad.one;
    double free_angle = unset<double>;
    TurningDamping c_turn = 0.0 * N_m_s.one;
    static constexpr std::tuple fields{
        NameField{&Spring::name, "name", "name of the spring or damper"},
        Group{&Spring::links, "links", "the two links; the ground is called ground"}.as_array(),
        Group{&Spring::points, "points", "its ends, on the first and on the second link"}.as_array().may_be_missing(),
        Field{&Spring::k, "k", N_per_mm, "rate"}.at_least(0),
        Field{&Spring::free, "free", mm, "length without force"}.at_least(0).may_be_missing(),
        Field{&Spring::c, "c", N_s_per_m, "damping"}.at_least(0),
        Field{&Spring::k_turn, "k_turn", N_m_per_rad, "rate of a turning spring, in place of k"}.at_least(0),
        Field{&Spring::free_angle, "free_angle", deg,
              "turning: angle of the first link against the second without moment"}
            .may_be_missing(),
        Field{&Spring::c_turn, "c_turn", N_m_s, "damping of the turning, in place of c"}.at_least(0)};
  };

  struct Side {
    Name side;
    static constexpr std::tuple fields{NameField{&Side::side, "side", "side of a group: \"B_left\", \"D_ahead\""}};
  };

  enum class Analysis { kinetostatic, statics };
  struct Input {
    List<Point, 32> ground;
    List<Link, 128> links;
    List<Joint, 192> joints;
    List<CamProfile, 8> profiles;
    Crank crank;
    List<Cylinder, 16> cylinders;
    int positions = 1;
    List<Load, 64> loads;
    List<Spring, 32> springs;
    List<Side, 16> sides;
    List<planar::Tolerance, 64> tolerances;
    List<planar::Accuracy, 16> accuracy;
    List<planar::Counterweight, 16> counterweights;
    planar::Balance balance = planar::Balance::rms;
    List<planar::Hodograph, 16> hodographs;
    Acceleration gravity = 0.0 * m_per_s2.one;
    double gravity_direction = -pi / 2.0;
    Analysis analysis = Analysis::kinetostatic;
  };
  static constexpr std::tuple inputs{
      ListField{&Input::ground, "ground", "points of the fixed link"}.as_arrays().may_be_missing(),
      ListField{&Input::links, "links", "moving links, by name"},
      ListField{&Input::joints, "joints", "joints, by name"},
      ListField{&Input::profiles, "profiles", "profiles of cams, by name"}.may_be_missing(),
      Group{&Input::crank, "crank", "drive of a revolute joint"}.may_be_missing(),
      ListField{&Input::cylinders, "cylinders", "drives of prismatic joints, by name"}.may_be_missing(),
      Count{&Input::positions, "positions", 1, 7200, "positions of a stroke of cylinders, or of a law of motion"},
      ListField{&Input::loads, "loads", "forces and couples"}.may_be_missing(),
      ListField{&Input::springs, "springs", "springs and dampers, by name"}.may_be_missing(),
      ListField{&Input::sides, "sides",
                "assembly by the sides of its groups, which the report lists; as stated or drawn where missing"}
          .as_arrays()
          .may_be_missing(),
      ListField{&Input::tolerances, "tolerances", "dimensions and masses that are not exact, by name"}.may_be_missing(),
      ListField{&Input::accuracy, "accuracy", "outputs whose error by tolerances and play is wanted, by name"}
          .may_be_missing(),
      ListField{&Input::counterweights, "counterweights", "where counterweights are wanted, by name"}.may_be_missing(),
      Choice{&Input::balance, "balance", "what counterweights make as small as it gets"}.may_be_missing(),
      ListField{&Input::hodographs, "hodographs",
                "joints whose force is drawn as a hodograph; the busiest where missing"}
          .as_arrays()
          .may_be_missing(),
      Field{&Input::gravity, "gravity", m_per_s2, "acceleration of gravity; none where missing"}.at_least(0).usually(
          0, 30),
      Field{&Input::gravity_direction, "gravity_direction", deg, "direction of gravity"},
      Choice{&Input::analysis, "analysis", "with the inertia of the links, or loads alone"}.may_be_missing()};
};

constexpr auto choices_of(PlanarMechanism::Type) {
  using T = PlanarMechanism::Type;
  return std::array{
      ChoiceName<T>{T::revolute, "revolute", "pin: the points coincide, the links turn"},
      ChoiceName<T>{T::prismatic, "prismatic", "slide along a line of the second link, no turning"},
      ChoiceName<T>{T::slot, "slot", "pin of the first link in a slot of the second"},
      ChoiceName<T>{T::rigid, "rigid", "the points coincide, no turning"},
      ChoiceName<T>{T::gear, "gear", "spur gears that mesh outside; other joints hold their centres"},
      ChoiceName<T>{T::ring_gear, "ring_gear", "spur gear of the first link inside the ring of the second"},
      ChoiceName<T>{T::rack, "rack", "spur gear of the first link on a rack of the second"},
      ChoiceName<T>{T::belt, "belt",
                    "belt or chain over wheels on both links, open; the distance of their centres must not change"},
      ChoiceName<T>{T::crossed_belt, "crossed_belt", "the same, crossed"},
      ChoiceName<T>{T::rolling, "rolling", "wheels that roll on each other without slip"},
      ChoiceName<T>{T::rolling_inside, "rolling_inside", "wheel of the first link that rolls inside the second's"},
      ChoiceName<T>{T::rolling_on_line, "rolling_on_line", "wheel of the first link on a line of the second"},
      ChoiceName<T>{T::cam, "cam",
                    "roller or edge about the first link's point on the profile of the second, whose "
                    "axis is the second's point; the spin of the roller is left out"},
      ChoiceName<T>{T::cam_flat, "cam_flat", "flat face through the first link's point on the profile of the second"}};
}
constexpr auto choices_of(PlanarMechanism::Holding) {
  using T = PlanarMechanism::Holding;
  return std::array{ChoiceName<T>{T::one_side, "one_side", "the cam only pushes: elsewhere the follower lifts off"},
                    ChoiceName<T>{T::groove, "groove", "it holds the follower on both sides"}};
}
constexpr auto choices_of(PlanarMechanism::Axes) {
  using T = PlanarMechanism::Axes;
  return std::array{ChoiceName<T>{T::fixed, "fixed", "the force keeps its direction"},
                    ChoiceName<T>{T::link, "link", "the force turns with the link"}};
}
constexpr auto choices_of(PlanarMechanism::MassLine) {
  using T = PlanarMechanism::MassLine;
  return std::array{
      ChoiceName<T>{T::automatic, "automatic", "uniform where J and S are those of a slender bar, else lumped"},
      ChoiceName<T>{T::uniform, "uniform", "evenly along the axis; J must be m l^2 / 12 within 1 %"},
      ChoiceName<T>{T::lumped, "lumped", "all of it at the mass centre"}};
}
constexpr auto choices_of(PlanarMechanism::Masses) {
  using T = PlanarMechanism::Masses;
  return std::array{
      ChoiceName<T>{T::as_given, "as_given", "mass, mass centre and J as they are"},
      ChoiceName<T>{T::two_points, "two_points", "static replacement: two masses in mass_points; J becomes theirs"},
      ChoiceName<T>{T::three_points, "three_points", "dynamic replacement: a third mass in S keeps J"}};
}
constexpr auto choices_of(PlanarMechanism::Useful) {
  using T = PlanarMechanism::Useful;
  return std::array{ChoiceName<T>{T::no, "no", "not counted as useful"},
                    ChoiceName<T>{T::yes, "yes", "the machine is there to work against it"}};
}
constexpr auto choices_of(PlanarMechanism::Impending) {
  using T = PlanarMechanism::Impending;
  return std::array{ChoiceName<T>{T::either, "either", "not stated: the effort is a band, from one way to the other"},
                    ChoiceName<T>{T::forward, "forward", "in the positive sense of the drive"},
                    ChoiceName<T>{T::backward, "backward", "in the negative sense"}};
}
constexpr auto choices_of(PlanarMechanism::LawShape) {
  using T = PlanarMechanism::LawShape;
  return std::array{ChoiceName<T>{T::spline, "spline", "a cubic spline: gentle, but it may swing beyond the points"},
                    ChoiceName<T>{T::monotone, "monotone", "never beyond the points; rests where they turn or dwell"}};
}
constexpr auto choices_of(PlanarMechanism::Analysis) {
  using T = PlanarMechanism::Analysis;
  return std::array{ChoiceName<T>{T::kinetostatic, "kinetostatic", "loads, weights and inertia"},
                    ChoiceName<T>{T::statics, "static", "loads and weights; no inertia"}};
}

}  // namespace loadpath
