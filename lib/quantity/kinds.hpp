// What a value is beyond its dimension: a shear stress is no normal stress, and a frequency no angular speed. One table
// tells the kinds of literals by their units, of fields by their symbols and meanings, and which field takes which
// kind. How kinds pass through an expression is in lib/quantity/expression/kinds.cpp.
#pragma once

#include "lib/quantity/dimension.hpp"

#include <cstdint>
#include <string_view>

namespace loadpath {

enum class Meant : std::uint8_t {
  nothing,  // not known: read like a literal
  normal_stress,
  shear_stress,
  equivalent_stress,
  uniaxial_stress,  // of mises(sigma, tau): what normal and equivalent stresses take
  strength,         // what any allowable stress takes
  frequency,        // cycles or turns per time
  angular_speed,
  rate,  // 1/s of a speed over a radius, a power over a moment, a root: radians per time
  work,
  torque,
  temperature,
  difference  // of temperatures
};

/// A field or a result, by what it declares of itself.
struct Declaration {
  std::string_view symbol;   // "tau_max": the last name of its path
  std::string_view meaning;  // "maximum shear stress"
  std::string_view unit;     // "MPa"
  Dimension dimension;
  Kind kind = Kind::plain;
};
Meant kind_of_field(const Declaration& field);

/// Of a literal: of hertz a frequency, of joules a work.
Meant kind_of_unit(const Dimension& dimension, bool hertz, bool work);

/// "a shear stress"
std::string_view name_of(Meant kind);

/// Whether a field takes a value; of two that are known of one dimension.
bool takes_kind(Meant field, Meant given);

/// Whether a value of one dimension may stand where the other is expected, their angles left out: a speed over a radius
/// is an angular speed, a frequency is not. `turns`: pi in the value makes radians of turns.
bool fits_but_for_angle(const Dimension& wanted, const Dimension& given, Meant kind, bool turns);

}  // namespace loadpath
