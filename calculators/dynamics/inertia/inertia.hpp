// Mass, centre of mass and moment of inertia of a body composed of simple ones, about the axis z through the origin.
//
// Decides nothing: J is for calculators that take a moment of inertia. The bodies are homogeneous; x, y, z is the
// position of the centre of mass of each, z along the axis. A hole counts negative. n identical parts are equally
// spaced about the axis. Bodies of revolution may be inclined by beta; a cuboid is parallel to the axes. Source: [B36]
// for the definition, [Wikibooks-Solids] for the bodies. Not covered: products of inertia, and whether solid parts
// overlap.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/motion_units.hpp"
#include "lib/text/issue.hpp"

#include <array>

namespace loadpath::dynamics {

struct Inertia {
  static constexpr auto id = "dynamics.inertia";
  static constexpr auto title = "Moment of inertia of a body";
  static constexpr auto scope =
      "Mass, centre of mass, moment of inertia and radius of gyration of a rigid body composed of cylinders, rings, "
      "rods, cones, spheres, cuboids and holes, about a given axis and the parallel axis through the centre of mass; "
      "products of inertia and overlapping parts are not covered.";
  static constexpr auto source = "[B36], [Wikibooks-Solids]";
  static constexpr auto headline = "m = {m}, J = {J}";
  static constexpr auto synonyms =
      "moment of inertia, mass moment of inertia, rotational inertia, parallel-axis theorem, Steiner, radius of "
      "gyration, WR2, GD2, flywheel effect, Massenträgheitsmoment, Trägheitsmoment, Trägheitsradius, Satz von Steiner, "
      "Schwungmoment, момент инерции, теорема Штейнера, радиус инерции, маховой момент";
  static constexpr auto example = R"toml([project]
title = "A wheel with spokes"

[wheel]
calculator = "dynamics.inertia"
rho = "7200 kg/m^3"
parts = [
  { name = "rim", shape = "cylinder", D = "600 mm", d_i = "500 mm", h = "80 mm" },
  { name = "hub", shape = "cylinder", D = "120 mm", d_i = "50 mm", h = "100 mm" },
  { name = "spokes", shape = "rod", D = "30 mm", h = "190 mm", beta = "90 deg", x = "155 mm", n = 6 },
]
)toml";

  enum class Shape { cylinder, rod, cone, sphere, cuboid, point, other };
  enum class As { full, hole };

  struct Part {
    Name name;
    Shape shape = Shape::cylinder;
    As as = As::full;
    Length D = unset<Length>, d_i = unset<Length>, h = unset<Length>, a = unset<Length>, b = unset<Length>;
    Mass mass = unset<Mass>;
    Density rho = unset<Density>;
    MassMoment J_c = unset<MassMoment>;
    Length x = 0.0 * m, y = 0.0 * m, z = 0.0 * m;
    double beta = unset<double>;
    Whole n = 1;
    static constexpr Fields fields{
        NameField{&Part::name, "name", "name of the part"}.may_be_missing(),
        Choice{&Part::shape, "shape", "shape of the part"},
        Choice{&Part::as, "as", "material or hole"}.may_be_missing(),
        Field{&Part::D, "D", mm, "outer diameter; for a cone, at its base; for a rod omitted: slender (then give m)"}
            .positive()
            .may_be_missing(),
        Field{&Part::d_i, "d_i", mm, "inner diameter of a hollow cylinder, ring, tube or sphere; omitted: solid"}
            .at_least(0)
            .may_be_missing(),
        Field{&Part::h, "h", mm,
              "length along its axis, cuboid: along z; for a cylinder omitted: thin disc (then give m)"}
            .positive()
            .may_be_missing(),
        Field{&Part::a, "a", mm, "side of a cuboid along x"}.positive().may_be_missing(),
        Field{&Part::b, "b", mm, "side of a cuboid along y"}.positive().may_be_missing(),
        Field{&Part::mass, called("m"), kg, "mass of one part, replaces rho"}.positive().may_be_missing(),
        Field{&Part::rho, "rho", kg_per_m3, "density of the part, if different"}
            .positive()
            .usually(100, 23000)
            .may_be_missing(),
        Field{&Part::J_c, "J_c", kg_m2, "shape other: moment of inertia about its own centroidal axis parallel to z"}
            .at_least(0)
            .may_be_missing(),
        Field{&Part::x, "x", mm, "centre of mass, x; of a cone h/4 above its base"},
        Field{&Part::y, "y", mm, "centre of mass, y"},
        Field{&Part::z, "z", mm, "centre of mass, along the axis"},
        Field{&Part::beta, "beta", deg, "angle of its own axis to z; needed for a rod, omitted: 0"}
            .within(-180, 180)
            .may_be_missing(),
        Count{&Part::n, "n", 1, 10000, "number of identical parts, equally spaced about the axis"}.may_be_missing()};
  };
  static constexpr std::size_t most_parts = 32;

  struct Input {
    List<Part, most_parts> parts;
    Density rho = unset<Density>;
  };
  static constexpr Fields inputs{
      ListField{&Input::parts, "parts", "parts of the body; the axis is z, through the origin"},
      Field{&Input::rho, "rho", kg_per_m3, "density of the parts without m and rho"}
          .positive()
          .usually(100, 23000)
          .from("material", "rho")
          .where_it_has()
          .may_be_missing()};

  struct Share {
    Name name;
    Mass mass = unset<Mass>;
    MassMoment J_c = unset<MassMoment>;
    Length e = unset<Length>;
    MassMoment J_A = unset<MassMoment>;
    static constexpr Fields fields{
        NameField{&Share::name, "name", "name of the part"}, Field{&Share::mass, called("m"), kg, "mass of one part"},
        Field{&Share::J_c, "J_c", kg_m2, "moment of inertia of one part about its own centroidal axis parallel to z"},
        Field{&Share::e, "e", mm, "distance of its centre of mass from the axis"},
        Field{&Share::J_A, "J_A", kg_m2, "contribution to J of all n parts, negative for a hole"}};
  };

  struct Result {
    Mass mass = unset<Mass>;
    Length x_S = unset<Length>, y_S = unset<Length>, z_S = unset<Length>, e_S = unset<Length>;
    MassMoment J = unset<MassMoment>, J_S = unset<MassMoment>;
    Length i = unset<Length>, i_S = unset<Length>;
    List<Share, most_parts> parts;
  };
  static constexpr Fields results{
      Field{&Result::mass, called("m"), kg, "mass"},
      Field{&Result::x_S, "x_S", mm, "centre of mass, x"},
      Field{&Result::y_S, "y_S", mm, "centre of mass, y"},
      Field{&Result::z_S, "z_S", mm, "centre of mass, along the axis"},
      Field{&Result::e_S, "e_S", mm, "distance of the centre of mass from the axis"},
      Field{&Result::J, "J", kg_m2, "moment of inertia about the axis"},
      Field{&Result::J_S, "J_S", kg_m2, "moment of inertia about the parallel axis through the centre of mass"},
      Field{&Result::i, "i", mm, "radius of gyration about the axis"},
      Field{&Result::i_S, "i_S", mm, "radius of gyration about the parallel axis through the centre of mass"},
      ListField{&Result::parts, "parts", "contributions of the parts"}};

  static bool parts_are_complete(const Input& in);
  static FieldFault incomplete(const Input& in);
  static bool holes_fit(const Input& in);
  static bool holes_lie_inside(const Input& in);
  static FieldFault misplaced_hole(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{&parts_are_complete, "parts, rho",
                  "each part needs the sizes of its shape, and m or a density; no other sizes", &incomplete},
      Rule<Input>{&holes_fit, "parts",
                  "the holes remove more than the other parts have: check their sizes and positions"},
      Rule<Input>{&holes_lie_inside, "parts", "holes must lie within the solid parts and must not overlap on a circle",
                  &misplaced_hole}};

  static constexpr std::array<Mode<Input>, 0> modes{};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
};

constexpr auto choices_of(Inertia::Shape) {
  using S = Inertia::Shape;
  return std::array{ChoiceName<S>{S::cylinder, "cylinder", "cylinder, disc, shaft; with d_i a ring, tube or rim"},
                    ChoiceName<S>{S::rod, "rod", "rod or tube; without D slender"},
                    ChoiceName<S>{S::cone, "cone", "circular cone; frustum: with the tip as a hole"},
                    ChoiceName<S>{S::sphere, "sphere", "sphere; with d_i hollow"},
                    ChoiceName<S>{S::cuboid, "cuboid", "cuboid or plate, sides along x, y, z"},
                    ChoiceName<S>{S::point, "point", "mass that is small compared with its distance"},
                    ChoiceName<S>{S::other, "other", "any body of known m and J_c"}};
}

constexpr auto choices_of(Inertia::As) {
  using A = Inertia::As;
  return std::array{ChoiceName<A>{A::full, "full", "material"},
                    ChoiceName<A>{A::hole, "hole", "hole, counts negative"}};
}

}  // namespace loadpath::dynamics
