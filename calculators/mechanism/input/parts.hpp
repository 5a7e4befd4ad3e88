// The links of a planar mechanism with their points and masses, and the joints between them, as a user writes them.
#pragma once

#include "lib/calculator/field.hpp"

#include <array>
#include <vector>

namespace loadpath::planar {

/// A point of a link: Cartesian, or by distance and angle.
struct Point {
  Name name;
  Length x = unset<Length>, y = unset<Length>, r = unset<Length>;
  double angle = unset<double>;
  static constexpr Fields fields{
      NameField{&Point::name, "name", "name of the point"},
      Field{&Point::x, "x", mm, "x coordinate in the axes of the link"}.may_be_missing(),
      Field{&Point::y, "y", mm, "y coordinate in the axes of the link"}.may_be_missing(),
      Field{&Point::r, "r", mm, "distance from the origin, in place of x and y"}.may_be_missing(),
      Field{&Point::angle, "angle", deg, "direction of the distance r, from the x axis"}.may_be_missing()};
};
struct Origin {
  Length x = unset<Length>, y = unset<Length>;
  static constexpr Fields fields{Field{&Origin::x, "x", mm, "global x coordinate"},
                                 Field{&Origin::y, "y", mm, "global y coordinate"}};
};
struct Pair {
  Name first, second;
  static constexpr Fields fields{NameField{&Pair::first, "first", "first link or point"},
                                 NameField{&Pair::second, "second", "second link or point"}};
};

enum class MassLine { automatic, uniform, lumped };
enum class Masses { as_given, two_points, three_points };
struct Link {
  Name name;
  std::vector<Point> points;
  Mass mass = 0.0 * kg.one;
  MassMoment J = 0.0 * kg_m2.one;
  Name S;
  Origin origin;
  double angle = unset<double>;
  MassLine mass_line = MassLine::automatic;
  Masses masses = Masses::as_given;
  Pair mass_points;
  static constexpr Fields fields{
      NameField{&Link::name, "name", "name of the link"},
      ListField{&Link::points, "points", "points in the link's axes; without origin and angle in global axes"}
          .as_arrays(),
      Field{&Link::mass, "mass", kg, "mass"}.at_least(0),
      Field{&Link::J, "J", kg_m2,
            "moment of inertia about the mass centre; omitted: slender bar between its two joints; 0 for a one-point "
            "block"}
          .at_least(0),
      NameField{&Link::S, "S",
                "point that is the mass centre; omitted: midpoint S_LINK of the bar, or the point of a one-point block"}
          .may_be_missing(),
      Group{&Link::origin, "origin", "approximate position of the link's origin in the assembly position"}
          .as_array()
          .may_be_missing(),
      Field{&Link::angle, "angle", deg, "approximate angle of the link in the assembly position"}.may_be_missing(),
      Choice{&Link::mass_line, "mass_line", "mass distribution along its axis, for its internal forces"}
          .may_be_missing(),
      Choice{&Link::masses, "masses", "reduction of its mass to points"}.may_be_missing(),
      Group{&Link::mass_points, "mass_points", "two points, on a line with S, to which the mass is reduced"}
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
  static constexpr Fields fields{Field{&Radii::first, "first", mm, "radius of the first link's wheel"}.positive(),
                                 Field{&Radii::second, "second", mm, "radius of the second link's wheel"}.positive()};
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
  double mu = 0.0, mu_s = unset<double>, delta_s = 2.0;
  Speed v_s = unset<Speed>;
  Length pin_radius = unset<Length>, guide_length = unset<Length>, guide_width = unset<Length>;
  Length rolling_arm = 0.0 * m.one, clearance = 0.0 * m.one;
  double efficiency = 1.0, efficiency_back = unset<double>;
  Damping c = 0.0 * N_s_per_m.one;
  TurningDamping c_turn = 0.0 * N_m_s.one;
  double gamma_min = unset<double>;
  Length h_max = unset<Length>;
  static constexpr Fields fields{
      NameField{&Joint::name, "name", "name of the joint; also of its point on both links unless points are given"},
      Choice{&Joint::type, "type", "joint type"},
      Group{&Joint::links, "links", "the two links; the ground is called ground"}.as_array(),
      Group{&Joint::points, "points", "point of the first and of the second link; of wheels their centres"}
          .as_array()
          .may_be_missing(),
      Field{&Joint::direction, "direction", deg,
            "direction of the guide, slot or rack through the second link's point, or of its profile's x axis, in that "
            "link's axes"},
      Field{&Joint::angle, "angle", deg,
            "prismatic, rigid: angle of the first link relative to the second; omitted: as assembled"}
          .may_be_missing(),
      Group{&Joint::radii, "radii", "two wheels: their pitch or rolling radii"}.as_array().may_be_missing(),
      Field{&Joint::radius, "radius", mm,
            "rack, rolling_on_line: radius of the first link's wheel; cam: of its roller, omitted: that of the profile"}
          .positive()
          .may_be_missing(),
      Field{&Joint::pressure_angle, "pressure_angle", deg, "teeth: angle of the force against the pitch line"}.within(
          0, 45),
      NameField{&Joint::profile, "profile", "cam, cam_flat: profile of the second link, one of the profiles"}
          .may_be_missing(),
      Field{&Joint::face, "face", deg, "cam_flat: direction of the flat face, in the first link's axes"},
      Choice{&Joint::holding, "holding", "cam, cam_flat: form closure (the cam can also pull the follower)"}
          .may_be_missing(),
      Field{&Joint::slack, "slack", N, "belts: tension of the slack span"}.at_least(0),
      Field{&Joint::mu, "mu", ratio,
            "coefficient of friction: revolute, prismatic, slot, cam_flat, and an edge on a cam"}
          .within(0, 2),
      Field{&Joint::mu_s, "mu_s", ratio,
            "mixed friction: coefficient at rest, at least mu; mu(v) = mu + (mu_s - mu) exp(-(|v|/v_s)^delta_s)"}
          .within(0, 2)
          .may_be_missing(),
      Field{&Joint::v_s, "v_s", m_per_s, "mixed friction: Stribeck velocity, of the surfaces on each other"}
          .positive()
          .may_be_missing(),
      Field{&Joint::delta_s, "delta_s", ratio, "mixed friction: exponent of the Stribeck curve"}.within(1, 10),
      Field{&Joint::pin_radius, "pin_radius", mm, "revolute, slot: radius of the pin; mu needs it"}
          .positive()
          .may_be_missing(),
      Field{&Joint::guide_length, "guide_length", mm,
            "prismatic: length of the block about the first link's point, for the forces on its edges; mu needs it"}
          .positive()
          .may_be_missing(),
      Field{&Joint::guide_width, "guide_width", mm,
            "prismatic: distance between the two faces that it rests on; mu needs it"}
          .at_least(0)
          .may_be_missing(),
      Field{&Joint::rolling_arm, "rolling_arm", mm, "rolling: lever arm of the rolling resistance"}.at_least(0),
      Field{&Joint::efficiency, "efficiency", ratio, "teeth, belts: output power / input power"}.within(0.01, 1),
      Field{&Joint::efficiency_back, "efficiency_back", ratio,
            "efficiency when the second link drives; omitted: as efficiency; negative: self-locking (worms)"}
          .within(-20, 1)
          .may_be_missing(),
      Field{&Joint::c, "c", N_s_per_m, "prismatic, slot, cams: viscous resistance to sliding"}.at_least(0),
      Field{&Joint::c_turn, "c_turn", N_m_s, "revolute, rolling: viscous resistance to turning"}.at_least(0),
      Field{&Joint::clearance, "clearance", mm, "revolute: diametral clearance of the pin"}.at_least(0),
      Field{&Joint::gamma_min, "gamma_min", deg,
            "inner joint of a dyad: required minimum transmission angle; omitted: that of the mechanism"}
          .within(25, 90)
          .may_be_missing(),
      Field{&Joint::h_max, "h_max", mm,
            "prismatic: maximum distance of the guide force (at least a tenth of its maximum) from the first link's "
            "point; half the guide_length: the force acts within the block"}
          .at_least(0)
          .may_be_missing()};
};

constexpr auto choices_of(Type) {
  using T = Type;
  return std::array{
      ChoiceName<T>{T::revolute, "revolute", "pin: coincident points"},
      ChoiceName<T>{T::prismatic, "prismatic", "slide along a line of the second link, no rotation"},
      ChoiceName<T>{T::slot, "slot", "pin of the first link in a slot of the second"},
      ChoiceName<T>{T::rigid, "rigid", "coincident points, no rotation"},
      ChoiceName<T>{T::gear, "gear", "external spur gears; centres held by other joints"},
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
constexpr auto choices_of(Holding) {
  using T = Holding;
  return std::array{
      ChoiceName<T>{T::one_side, "one_side", "force-closed: the cam only pushes, else the follower lifts off"},
      ChoiceName<T>{T::groove, "groove", "form-closed (groove)"}};
}
constexpr auto choices_of(MassLine) {
  using T = MassLine;
  return std::array{
      ChoiceName<T>{T::automatic, "automatic", "uniform where J and S are those of a slender bar, else lumped"},
      ChoiceName<T>{T::uniform, "uniform", "evenly along the axis; J must be m l^2 / 12 within 1 %"},
      ChoiceName<T>{T::lumped, "lumped", "all of it at the mass centre"}};
}
constexpr auto choices_of(Masses) {
  using T = Masses;
  return std::array{
      ChoiceName<T>{T::as_given, "as_given", "mass, mass centre and J as they are"},
      ChoiceName<T>{T::two_points, "two_points", "static replacement: two masses in mass_points; J becomes theirs"},
      ChoiceName<T>{T::three_points, "three_points", "dynamic replacement: a third mass in S keeps J"}};
}

}  // namespace loadpath::planar
