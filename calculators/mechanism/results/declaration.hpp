// Declaration of a result of a mechanism before its values exist: its path, unit and meaning, and the facts by which
// tables, figures and other results choose it. The text of a path never identifies a result.
#pragma once

#include "lib/calculator/calculator.hpp"
#include "lib/quantity/dimension.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath::planar {

/// Meaning of a result for those who look for it; most have none.
enum class Kind {
  other,
  drive_moment,
  cylinder_force,
  drive_power,
  useful_power,
  friction_power,  // total of all joints
  joint_loss,
  efficiency,
  efficiency_back,
  joint_force,  // its magnitude
  tooth_force,
  pressure_angle,
  transmission_angle,
  direction  // angle of a link: the full turn is (-pi, pi]
};
/// Whether it is the effort of a drive itself.
constexpr bool is_effort(Kind kind) { return kind == Kind::drive_moment || kind == Kind::cylinder_force; }

/// Where the tables of a report have it: what parts are designed for, and at a single position all forces of joints.
enum class Tabled { no, at_one_position, always };

struct Facts {
  Kind kind = Kind::other;
  Tabled tabled = Tabled::no;
  bool detail = false;       // too much where there is little room
  bool is_load = false;      // a part that takes it has to carry it
  bool is_tension = false;   // a load that is positive in tension, negative in compression
  bool loads_crank = false;  // who takes it takes the force of the crank's joint with it
  const char* with = "";     // simultaneous results on the same link: "V, M_b"
  const char* missing = "";  // a message: why there may be none though the mechanism has forces
};

struct Declaration {
  ResultPattern pattern;  // NAME is replaced by the name of its object
  Dimension dimension;
  Facts facts;
};

/// `where`: what has it, in words; empty: everything of its kind.
template <class Quantity>
constexpr Declaration declare(const char* path, const char* doc, const Unit<Quantity>& unit, const char* where,
                              const Facts& facts = {}) {
  return {{path, unit.symbol, doc, where, facts.is_load, facts.with}, unit.dimension(), facts};
}

}  // namespace loadpath::planar
