// Choices of a gear pair.
#pragma once

#include "lib/calculator/field.hpp"

#include <array>

namespace loadpath::gear {

enum class Mesh { external, internal, rack };
enum class Hand { right, left };
enum class Turns { ccw, cw };
enum class Shortening { clearance, none };
enum class Cutting { none, cast, milled, hobbed, ground };
enum class Idler { none, gear_1, gear_2, both };

constexpr auto choices_of(Mesh) {
  return std::array{ChoiceName<Mesh>{Mesh::external, "external", "external gear"},
                    ChoiceName<Mesh>{Mesh::internal, "internal", "internal gear (ring gear)"},
                    ChoiceName<Mesh>{Mesh::rack, "rack", "a rack"}};
}
constexpr auto choices_of(Hand) {
  return std::array{ChoiceName<Hand>{Hand::right, "right", "right-hand helix"},
                    ChoiceName<Hand>{Hand::left, "left", "left-hand helix"}};
}
constexpr auto choices_of(Turns) {
  return std::array{ChoiceName<Turns>{Turns::ccw, "ccw", "counter-clockwise"},
                    ChoiceName<Turns>{Turns::cw, "cw", "clockwise"}};
}
constexpr auto choices_of(Shortening) {
  return std::array{
      ChoiceName<Shortening>{Shortening::clearance, "clearance", "shortened to keep the clearance of the basic rack"},
      ChoiceName<Shortening>{Shortening::none, "none", "full addendum"}};
}
constexpr auto choices_of(Cutting) {
  return std::array{ChoiceName<Cutting>{Cutting::none, "none", "no velocity factor: a load at rest"},
                    ChoiceName<Cutting>{Cutting::cast, "cast", "cast teeth"},
                    ChoiceName<Cutting>{Cutting::milled, "milled", "cut or milled teeth"},
                    ChoiceName<Cutting>{Cutting::hobbed, "hobbed", "hobbed or shaped teeth"},
                    ChoiceName<Cutting>{Cutting::ground, "ground", "shaved or ground teeth"}};
}
constexpr auto choices_of(Idler) {
  return std::array{ChoiceName<Idler>{Idler::none, "none", "no gear of the pair"},
                    ChoiceName<Idler>{Idler::gear_1, "gear_1", "gear 1, between two mates"},
                    ChoiceName<Idler>{Idler::gear_2, "gear_2", "gear 2, between two mates"},
                    ChoiceName<Idler>{Idler::both, "both", "both gears"}};
}
/// Whether gear 1 or gear 2 is an idler gear (reversed tooth bending).
constexpr bool is_idler(Idler idler, Idler gear) { return idler == gear || idler == Idler::both; }

}  // namespace loadpath::gear
