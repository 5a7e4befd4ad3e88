// The four-bar that several templates start from: O at the origin, C on the x axis, crank OA, coupler AB, rocker CB.
#pragma once

#include "calculators/mechanism/templates/sketch.hpp"

namespace loadpath::planar::templates {

/// A crank and what it moves: whether it can turn round depends on nothing else.
struct Chain {
  Length crank, coupler, rocker, frame;
  const char *coupler_name = "coupler", *rocker_name = "rocker";
};
/// Reason why the crank cannot rotate fully, if so, with the numbers; `path`: the parameter at fault.
std::optional<FieldFault> stop_of(const Chain& chain, const char* path);

struct FourBarLengths {
  Length a = unset<Length>, b = unset<Length>, c = unset<Length>, d = unset<Length>;
  Assembly assembly = Assembly::open;
  static constexpr Fields fields{
      Field{&FourBarLengths::a, "a", mm, "length of the crank OA"}.positive(),
      Field{&FourBarLengths::b, "b", mm, "length of the coupler AB"}.positive(),
      Field{&FourBarLengths::c, "c", mm, "length of the rocker CB"}.positive(),
      Field{&FourBarLengths::d, "d", mm, "distance of the fixed pins O and C, on the x axis"}.positive(),
      Choice{&FourBarLengths::assembly, "assembly", "B is left of the line from A to C: open, or right of it: crossed"}
          .may_be_missing()};

  struct Pins {
    Pin A, B, C;
  };
  /// Draws the crank OA, and says where the other pins are.
  [[nodiscard]] Pins pins(Sketch& sketch) const;
  /// The fixed pin C, coupler AB, rocker CB and their joints. `coupler_pin`, `rocker_pin`: one more pin on that link,
  /// in its axes.
  void draw(Sketch& sketch, const Pins& at, const Pin* coupler_pin = nullptr, const Pin* rocker_pin = nullptr) const;
  [[nodiscard]] std::optional<FieldFault> crank_stop() const { return stop_of({a, b, c, d}, "a"); }
};

}  // namespace loadpath::planar::templates
