// A cycloidal wheel that drives a pinion with radial flanks, or a lantern pinion with round pins.
//
// The flanks of the wheel are epicycloids of a circle that rolls on its pitch circle: of half the diameter of the
// pinion for radial flanks, which are its hypocycloids, and of its diameter for pins, of whose centres they are the
// path, offset by the radius of the pin. Both flanks of a tooth meet in a point; the tips keep a share of that height.
// Decides the geometry of the wheel, how far the pinion is driven after the line of centres, whether a lantern is
// driven without interruption, and how the flanks slide. Pins are in contact from the place at which their flank
// begins. Numbers agree with the table of addendum factors of BS 978-2. Source: [BS978-2], [TecScience-lantern]. Not
// covered: the addendum of the pinion, which leads before the line of centres, a driving pinion, strength.
#pragma once

#include "lib/calculator/bound.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>
#include <vector>

namespace loadpath::gear {

struct Cycloidal {
  static constexpr auto id = "gear.cycloidal";
  static constexpr auto title = "Cycloidal gear pair, lantern pinion";
  static constexpr auto scope =
      "Geometry, contact ratio after the line of centres, pressure angle and sliding of a cycloidal wheel that drives "
      "a pinion with radial flanks or a lantern pinion; pinion addenda and tooth strength are not covered.";
  static constexpr auto source = "[BS978-2], [TecScience-lantern]";
  static constexpr auto headline = "z {z_1}/{z_2}, m {m}";
  static constexpr auto details = "d_p = {d_p}, tip diameter {d_a2}|tip diameter {d_a2}";
  static constexpr auto synonyms =
      "cycloidal gear, lantern gear, lantern pinion, pin gear, trundle, clock gear, watch gear, epicycloid, cycloidal "
      "teeth, Zykloidenverzahnung, Triebstockverzahnung, Uhrenverzahnung, циклоидное зацепление, цевочное зацепление";
  static constexpr auto example = R"toml([project]
title = "A lantern pinion of ten pins"

[lantern]
calculator = "gear.cycloidal"
pinion = "pins"
m = "2 mm"
z_1 = 10
z_2 = 60
d_p = "3 mm"
)toml";

  enum class Pinion { leaves, pins };

  struct Input {
    Pinion pinion = Pinion::leaves;
    Length m = unset<Length>;
    Whole z_1, z_2;
    Length d_p = unset<Length>, j = 0.0 * mm;
    double k_a = 0.95;
  };
  static constexpr Fields inputs{
      Choice{&Input::pinion, "pinion", "teeth of the pinion"}.may_be_missing(),
      Field{&Input::m, called("m"), mm, "module"}.positive().usually(0.05, 50),
      Count{&Input::z_1, "z_1", 3, 200, "number of leaves or pins of the pinion"},
      Count{&Input::z_2, "z_2", 6, 2000, "number of teeth of the wheel"},
      Field{&Input::d_p, "d_p", mm, "diameter of the pins"}.positive().may_be_missing(),
      Field{&Input::j, "j", mm, "backlash on the pitch circle, by thinner teeth of the wheel"}.at_least(0),
      Field{&Input::k_a, "k_a", ratio, "tooth height / height of pointed teeth"}.within(0.1, 1)};

  struct Result {
    double i = unset<double>;
    Length d_1 = unset<Length>, d_2 = unset<Length>, a = unset<Length>, p = unset<Length>;
    Length s_1 = unset<Length>, s_2 = unset<Length>;
    double f = unset<double>;
    Length h_a2 = unset<Length>, d_a2 = unset<Length>, r_f2 = unset<Length>, h_f1 = unset<Length>;
    double phi_a = unset<double>, alpha_a = unset<double>, eps = unset<double>, phi_e = unset<double>;
    double eps_pins = unset<double>, K_g = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::i, "i", ratio, "ratio, teeth of the wheel / teeth of the pinion"},
      Field{&Result::d_1, "d_1", mm, "pitch diameter of the pinion; of the centres of the pins"},
      Field{&Result::d_2, "d_2", mm, "pitch diameter of the wheel"},
      Field{&Result::a, "a", mm, "centre distance"},
      Field{&Result::p, "p", mm, "pitch"},
      Field{&Result::s_1, "s_1", mm, "thickness of the leaves on the pitch circle"},
      Field{&Result::s_2, "s_2", mm, "tooth thickness of the wheel on the pitch circle"},
      Field{&Result::f, "f", ratio, "addendum factor: height of pointed teeth / module"},
      Field{&Result::h_a2, "h_a2", mm, "addendum of the wheel"},
      Field{&Result::d_a2, "d_a2", mm, "tip diameter of the wheel"},
      Field{&Result::r_f2, "r_f2", mm, "radius of the arcs in place of the epicycloids"},
      Field{&Result::h_f1, "h_f1", mm, "dedendum of the leaves"},
      Field{&Result::phi_a, "phi_a", deg, "rotation of the pinion from the line of centres to the end of contact"},
      Field{&Result::alpha_a, "alpha_a", deg, "pressure angle at the end of contact"},
      Field{&Result::eps, "eps", ratio, "contact ratio of the flanks of the wheel"},
      Field{&Result::phi_e, "phi_e", deg, "rotation of the pinion before the line of centres, led by its addendum"},
      Field{&Result::K_g, "K_g", ratio, "sliding speed at the end of contact / pitch line velocity"},
      Field{&Result::eps_pins, "eps_pins", ratio, "contact ratio of the pins (at least 1)"}
          .limit(1, 100)
          .criterion()
          .where_it_applies()};

  static bool is_lantern(const Input& in) { return in.pinion == Pinion::pins; }
  static bool has_teeth(const Input& in);
  /// Whether the leaves must lead: below a contact ratio of 0.7, of 6 leaves and fewer, their addendum does much of the
  /// driving; from memory.
  static Applies leads(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{[](const Input& in) { return !is_lantern(in) || is_set(in.d_p); }, "d_p",
                  "a lantern pinion needs the diameter d_p of its pins"},
      Rule<Input>{[](const Input& in) { return is_lantern(in) || !is_set(in.d_p); }, "d_p, pinion",
                  "d_p applies to pins only: omit d_p, or give pinion = \"pins\""},
      Rule<Input>{&has_teeth, "d_p, j, m",
                  "pins and backlash must leave teeth of the wheel above its pitch circle: reduce d_p or j"}};

  static double least_teeth_of_wheel(const Input& in);
  static double least_pins(const Input& in);
  static constexpr std::array bounds{
      Bound<Input>{"z_2", "8 teeth, a usual minimum of wheels that drive pins", &least_teeth_of_wheel}.least(),
      Bound<Input>{"d_p", "half the module, thin pins bend", &least_pins}.least()};

  static constexpr std::array modes{
      Mode<Input>{"contact", "contact ratio", [](const Input& in) { return where(is_lantern(in)); }}
          .judged_by("eps_pins")
          .of_shape(),
      Mode<Input>{"lead", "engagement before the line of centres", &leads}.special(),
      Mode<Input>{"breakage", "breakage of teeth, leaves and pins", &unseen<Input>},
      Mode<Input>{"wear", "wear of the flanks", &unseen<Input>}.special()};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Cycloidal::Pinion) {
  using P = Cycloidal::Pinion;
  return std::array{ChoiceName<P>{P::leaves, "leaves", "leaves with radial flanks"},
                    ChoiceName<P>{P::pins, "pins", "round pins: a lantern pinion"}};
}

}  // namespace loadpath::gear
