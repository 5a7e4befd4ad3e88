// Failure modes of the wall of a vessel, common to all shapes.
#pragma once

#include "calculators/vessel/membrane.hpp"
#include "lib/calculator/mode.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace loadpath::vessel {

/// Whether the pressure outside is the larger one.
template <class Input>
constexpr Applies squeezed(const Input& in) {
  if constexpr (requires { in.p_e; }) return shown_by(in.p_e > in.p);
  return Applies::unseen;
}

template <class Input>
Applies tested(const Input& in) {
  return shown_by(is_set(in.p_t));
}

template <class Input>
constexpr Mode<Input> test_mode() {
  return Mode<Input>{"test_pressure", "yielding at test pressure", &tested<Input>}.judged_by("u_t").special();
}
/// The test must reach the pressure that the standard requires.
template <class Input>
constexpr Mode<Input> test_level_mode() {
  return Mode<Input>{"test_level", "required test pressure", &tested<Input>}.judged_by("u_tr").special().at_any_load();
}

/// `strength`: that of the wall; `test`: its test before service; `own`: the modes that not every wall has.
template <class Input, class... Own>
constexpr auto modes_of_tested_wall(const Mode<Input>& strength, const Mode<Input>& test, Own... own) {
  using M = Mode<Input>;
  return std::array{strength,
                    own...,
                    M{"fatigue", "fatigue under pressure cycles", &unseen<Input>}.in_service(),
                    M{"vacuum", "buckling under external pressure", &squeezed<Input>}.special(),
                    M{"nozzles", "reinforcement of openings and nozzles", &unseen<Input>}.special(),
                    M{"supports", "local bending at supports, junctions, edges", &unseen<Input>}.special(),
                    test,
                    M{"low_temperature", "brittle fracture at low temperature", &unseen<Input>}.special(),
                    M{"creep", "creep at elevated temperature", &unseen<Input>}.special()};
}

/// The same without a test.
template <class Input, class... Own>
constexpr auto modes_of_wall(const Mode<Input>& strength, Own... own) {
  return modes_of_tested_wall<Input>(
      strength, Mode<Input>{"test_pressure", "yielding at test pressure", &unseen<Input>}.special(), own...);
}

/// The modes of a shell whose wall vessel.external takes: wall = "=tank.wall".
template <class Modes>
constexpr Modes with_vacuum_assessed(Modes modes) {
  for (auto& mode : modes) {
    if (std::string_view(mode.id) == "vacuum") mode = mode.left_to("vessel.external", "wall.buckling");
  }
  return modes;
}

/// The strength of a thin wall, by these checks and limits of a shape.
template <class Input>
constexpr Mode<Input> membrane_strength(const char* by) {
  return Mode<Input>{"strength", "membrane stress of the wall", &always<Input>}.judged_by(by);
}

template <class Input, class... Own>
constexpr auto wall_modes(const char* strength, Own... own) {
  return modes_of_wall<Input>(membrane_strength<Input>(strength), own...);
}

/// Where a wall is in compression, in one direction or both. It follows only from the balance, at any thickness.
struct Pressed {
  bool in_knuckle = false;  // by the gas itself, around the axis: the meridian is bent too sharply there
  bool elsewhere = false;
};

template <class Shape>
Pressed pressed(const Shape& shape, Stress p) {
  constexpr double rounding = 1e-9;
  NoTrace off;
  const Strength any{1.0 * MPa, 1.0, 1.0, Hypothesis::membrane};
  const Length unit = 1.0 * m;
  Stress largest = 0.0 * MPa;
  for (std::size_t i = 0; i < shape.places(); ++i) {
    const Membrane s = membrane(shape.at(shape.place(i), off), p, unit, any, off);
    largest = max(largest, max(abs(s.o), abs(s.M)));
  }
  Pressed found;
  for (std::size_t i = 0; i < shape.places(); ++i) {
    const Place place = shape.at(shape.place(i), off);
    const Membrane s = membrane(place, p, unit, any, off);
    const bool hoop = -s.o > rounding * largest;
    const bool knuckle = in_si(place.q_M) * in_si(place.kappa_M) > 1.0;
    found.in_knuckle = found.in_knuckle || (hoop && knuckle);
    found.elsewhere = found.elsewhere || (hoop && !knuckle) || s.M < -rounding * largest;
  }
  return found;
}

}  // namespace loadpath::vessel
