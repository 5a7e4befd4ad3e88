// What fastens a hub to a shaft, for the seat of a shaft to take whole: connection = "=key.connection". Keys, splines,
// press fits, set screws and pins across the shaft give it.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath {

struct Connection {
  Moment T_c = unset<Moment>;
  Length d_c = unset<Length>, t_c = unset<Length>;

  static constexpr Fields fields{
      Field{&Connection::T_c, "T_c", N_m, "torque that the connection is assessed for"}.holding("K_A"),
      Field{&Connection::d_c, "d_c", mm, "diameter of the shaft that it is made for"},
      Field{&Connection::t_c, "t_c", mm, "depth of the keyway in the hub"}};
};

/// `T`: with the service factor; a torque of zero fastens nothing.
inline Connection connection_for(Moment T, Length d, Length t_2 = unset<Length>) {
  return {T > 0.0 * N_m.one ? T : unset<Moment>, d, t_2};
}

inline constexpr const char* connection_doc = "what fastens the hub, for a seat of shaft.design: connection";

}  // namespace loadpath
