// Reads a quantity as people write it: "30 MPa", "2,5 kN·m", "120 об/мин". It may refuse; it never guesses.
#pragma once

#include "lib/quantity/dimension.hpp"
#include "lib/quantity/kinds.hpp"
#include "lib/text/issue.hpp"

#include <string>
#include <string_view>

namespace loadpath {

/// Requirements of a field on a literal.
struct Expected {
  Dimension dimension;
  Kind kind = Kind::plain;
  std::string_view unit;         // the field's display unit, for hints: "write 30 mm"
  std::string_view symbol = {};  // the field's key: q is a load per length, of the dimension of a stiffness
};

struct Literal {
  double si = 0.0;
  Dimension dimension;
};

/// A literal that fits `expected`; else the place, the rule and the nearest right word.
/// A bare number is accepted for a dimensionless field only. The grammar is in the guide of `loadpath convert --help`.
Outcome<Literal> parse_literal(std::string_view text, const Expected& expected);

/// A literal of any dimension (for `convert` and for expressions' own tests).
Outcome<Literal> parse_literal(std::string_view text);

/// Whether a text of this dimension leaves open whether revolutions or cycles are counted: "120 1/min", not "2 Hz",
/// "2 1/s".
bool counts_anything(const Dimension& dimension, std::string_view text);

/// The kind of a literal implied by its unit: a frequency for "25 Hz"; nothing if it cannot be read.
Meant kind_of_literal(std::string_view text);

struct UnitValue {
  double factor = 1.0;  // SI value of one unit
  double offset = 0.0;  // SI value of zero: 273.15 for °C, else 0
  Dimension dimension;
};

/// A unit by itself: "N·m", "mm²", "об/мин", "lbf*in"; "-" and "1" are the unit of a ratio. Without a field that
/// expects an angular velocity, 1/min is a frequency; a rotational speed has the unit rpm.
Outcome<UnitValue> parse_unit(std::string_view text);

}  // namespace loadpath
