// Centre of mass of a system, and how far a carrier moves when bodies move on it: a man in a boat, a trolley on a
// crane.
//
// Without an external force along the line the centre of mass stays where it is. The first body is the carrier; the
// others move by s along it. Sign: along x. Source: [B35], theorem of the motion of the centre of mass.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/motion_units.hpp"

#include <array>

namespace loadpath::dynamics {

struct MassCentre {
  static constexpr auto id = "dynamics.mass_centre";
  static constexpr auto title = "Centre of mass of a system";
  static constexpr auto scope =
      "Centre of mass of a system of bodies, and the displacement of a carrier free to move along x when "
      "bodies move on it from rest; resistance along x is not covered.";
  static constexpr auto source = "[B35]";
  static constexpr auto headline = "M = {M}";
  static constexpr auto synonyms =
      "centre of mass, center of gravity, centroid, mass centre motion, Schwerpunkt, Massenmittelpunkt, "
      "Schwerpunktsatz, центр масс, центр тяжести";
  static constexpr auto example = R"toml([project]
title = "A man in a boat"

[boat]
calculator = "dynamics.mass_centre"
bodies = [
  { name = "boat", m = "100 kg" },
  { name = "man", m = "70 kg", s = "2 m" },
]
)toml";

  struct Body {
    Name name;
    Mass mass = unset<Mass>;
    Length x = 0.0 * m, y = 0.0 * m, s = 0.0 * m;
    static constexpr Fields fields{
        NameField{&Body::name, "name", "name of the body"}.may_be_missing(),
        Field{&Body::mass, called("m"), kg, "mass"}.positive().usually(1e-6, 1e7),
        Field{&Body::x, "x", loadpath::m, "position of its centre of mass before, x"},
        Field{&Body::y, "y", loadpath::m, "position of its centre of mass, y"},
        Field{&Body::s, "s", loadpath::m, "path along the carrier, signed along x; none of the carrier"}};
  };
  static constexpr std::size_t most_bodies = 16;

  struct Input {
    List<Body, most_bodies> bodies;
  };
  static constexpr Fields inputs{ListField{&Input::bodies, "bodies", "bodies; the first carries the others"}};

  struct After {
    Name name;
    Length Delta_x = unset<Length>, x_2 = unset<Length>;
    static constexpr Fields fields{NameField{&After::name, "name", "name of the body"},
                                   Field{&After::Delta_x, "Delta_x", loadpath::m, "displacement of the body"},
                                   Field{&After::x_2, "x_2", loadpath::m, "position after, x"}};
  };

  struct Result {
    Mass M = unset<Mass>;
    Length x_C = unset<Length>, y_C = unset<Length>, Delta_x = unset<Length>;
    List<After, most_bodies> after;
  };
  static constexpr Fields results{
      Field{&Result::M, "M", kg, "mass of the system"},
      Field{&Result::x_C, "x_C", loadpath::m, "centre of mass, x: before and after"},
      Field{&Result::y_C, "y_C", loadpath::m, "centre of mass, y"},
      Field{&Result::Delta_x, "Delta_x", loadpath::m, "displacement of the carrier along x"},
      ListField{&Result::after, "after", "bodies after their displacement"}};

  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return !in.bodies.empty(); }, "bodies", "give at least one body"},
      Rule<Input>{[](const Input& in) { return in.bodies.empty() || in_si(in.bodies.front().s) == 0.0; }, "bodies",
                  "the first body is the carrier: it has no path s along itself"}};

  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

}  // namespace loadpath::dynamics
