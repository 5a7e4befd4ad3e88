// The meaning of a value beyond its dimension: a shear stress differs from a normal stress, a frequency from an
// angular velocity. One table gives the kinds of literals by unit, of fields by symbol and meaning, and the kinds that
// each field takes. Propagation through expressions is in lib/quantity/expression/kinds.cpp.
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
  uniaxial_stress,  // mises(sigma, tau): accepted for normal and equivalent stresses
  strength,         // accepted for any allowable stress
  frequency,        // cycles or turns per time
  angular_speed,
  rate,  // 1/s as a speed over a radius, a power over a moment, a root: radians per time
  work,
  torque,
  temperature,
  difference  // temperature difference
};

/// A field or a result, by its declaration.
struct Declaration {
  std::string_view symbol;   // "tau_max": the last name of its path
  std::string_view meaning;  // "maximum shear stress"
  std::string_view unit;     // "MPa"
  Dimension dimension;
  Kind kind = Kind::plain;
};
Meant kind_of_field(const Declaration& field);

/// The kind of a literal: a frequency in hertz, a work in joules, a point on a scale of temperatures.
Meant kind_of_unit(const Dimension& dimension, bool hertz, bool work, bool scale);

/// "a shear stress"
std::string_view name_of(Meant kind);

/// Whether a field takes a value; of two that are known of one dimension.
bool takes_kind(Meant field, Meant given);

/// Whether a value of one dimension is accepted for the other, apart from angles: a speed over a radius is an angular
/// speed, a frequency is not. `turns`: pi in the value converts revolutions to radians.
bool fits_but_for_angle(const Dimension& wanted, const Dimension& given, Meant kind, bool turns);

}  // namespace loadpath
