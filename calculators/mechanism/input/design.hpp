// Requests in addition to motion and forces: errors by tolerances, counterweights, hodographs.
#pragma once

#include "lib/calculator/field.hpp"

#include <array>

namespace loadpath::planar {

enum class Toleranced { length, x, y, angle, mass, J, radius, radius_second, direction, mu, rate, drive };
struct Tolerance {
  Name name;
  Toleranced of = Toleranced::length;
  Name link, point, to, joint, spring;
  Length t = unset<Length>;
  double t_angle = unset<double>;
  Mass t_mass = unset<Mass>;
  double t_part = unset<double>, sigmas = 3.0;
  static constexpr Fields fields{
      NameField{&Tolerance::name, "name", "name of the tolerance"},
      Choice{&Tolerance::of, "of", "toleranced dimension"}.may_be_missing(),
      NameField{&Tolerance::link, "link", "link: of a length, x, y, angle, mass, J; also ground"}.may_be_missing(),
      NameField{&Tolerance::point, "point", "point of the link that has the coordinate, or that is measured from"}
          .may_be_missing(),
      NameField{&Tolerance::to, "to", "length, angle: point that is measured to, and that moves"}.may_be_missing(),
      NameField{&Tolerance::joint, "joint", "joint: of a radius, direction, mu; drive: the driven joint"}
          .may_be_missing(),
      NameField{&Tolerance::spring, "spring", "spring: of a rate"}.may_be_missing(),
      Field{&Tolerance::t, "t", mm, "half width of a length, a coordinate, a radius"}.at_least(0).may_be_missing(),
      Field{&Tolerance::t_angle, "t_angle", deg, "half width of an angle"}.within(0, 45).may_be_missing(),
      Field{&Tolerance::t_mass, "t_mass", kg, "half width of a mass"}.at_least(0).may_be_missing(),
      Field{&Tolerance::t_part, "t_part", ratio, "half width as a share of the value: mass, J, mu, rate"}
          .within(0, 1)
          .may_be_missing(),
      Field{&Tolerance::sigmas, "sigmas", ratio, "half width of the tolerance / standard deviation"}.within(0.5, 10)};
};
enum class Watched { x, y, angle, drive, force };
struct Accuracy {
  Name name;
  Watched of = Watched::x;
  Name point, link, joint;
  static constexpr Fields fields{
      NameField{&Accuracy::name, "name", "name of the output"},
      Choice{&Accuracy::of, "of", "output whose error is requested"},
      NameField{&Accuracy::point, "point", "x, y: the point"}.may_be_missing(),
      NameField{&Accuracy::link, "link",
                "angle: the link; x, y: the link whose point is meant if a clearance separates them"}
          .may_be_missing(),
      NameField{&Accuracy::joint, "joint", "force: the joint; drive: the driven joint, where there are several"}
          .may_be_missing()};
};

struct Counterweight {
  Name name, link, at;
  Length radius = unset<Length>;
  double direction = unset<double>;
  Mass mass = 0.0 * kg.one;
  static constexpr Fields fields{
      NameField{&Counterweight::name, "name", "name of the counterweight"},
      NameField{&Counterweight::link, "link", "link that carries the counterweight"},
      NameField{&Counterweight::at, "at", "pivot: point of the link from which the arm is measured"},
      Field{&Counterweight::radius, "radius", mm, "length of the arm, to find the mass"}.positive().may_be_missing(),
      Field{&Counterweight::direction, "direction", deg,
            "direction of its arm in the link's axes; omitted: the best one"}
          .may_be_missing(),
      Field{&Counterweight::mass, "mass", kg, "mass of the counterweight, if the pivot moves"}.at_least(0)};
};
enum class Balance { rms, peak };

struct Hodograph {
  Name joint;
  static constexpr Fields fields{NameField{&Hodograph::joint, "joint", "name of the joint"}};
};

constexpr auto choices_of(Toleranced) {
  using T = Toleranced;
  return std::array{ChoiceName<T>{T::length, "length", "distance of two points of a link"},
                    ChoiceName<T>{T::x, "x", "x coordinate of a point in its link's axes"},
                    ChoiceName<T>{T::y, "y", "y coordinate of a point in its link's axes"},
                    ChoiceName<T>{T::angle, "angle", "direction from one point of a link to another"},
                    ChoiceName<T>{T::mass, "mass", "mass of a link"},
                    ChoiceName<T>{T::J, "J", "moment of inertia of a link"},
                    ChoiceName<T>{T::radius, "radius", "radius of the wheel on a joint's first link"},
                    ChoiceName<T>{T::radius_second, "radius_second", "radius of the wheel on its second link"},
                    ChoiceName<T>{T::direction, "direction", "direction of a guide, slot or rack"},
                    ChoiceName<T>{T::mu, "mu", "coefficient of friction of a joint"},
                    ChoiceName<T>{T::rate, "rate", "rate of a spring"},
                    ChoiceName<T>{T::drive, "drive", "position of the drive"}};
}
constexpr auto choices_of(Watched) {
  using T = Watched;
  return std::array{ChoiceName<T>{T::x, "x", "position of a point along x"},
                    ChoiceName<T>{T::y, "y", "position of a point along y"},
                    ChoiceName<T>{T::angle, "angle", "angle of a link"},
                    ChoiceName<T>{T::drive, "drive", "moment or force of the drive"},
                    ChoiceName<T>{T::force, "force", "magnitude of a joint's force"}};
}
constexpr auto choices_of(Balance) {
  using T = Balance;
  return std::array{ChoiceName<T>{T::rms, "rms", "the root mean square of the shaking force over the cycle"},
                    ChoiceName<T>{T::peak, "peak", "its maximum magnitude"}};
}

}  // namespace loadpath::planar
