// Hub-shaft connections, input record of a component on a shaft: connection = "=key.connection". Keys, splines,
// interference fits, set screws and cross pins give it.
#pragma once

#include "calculators/load/hub.hpp"
#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath {

/// Connection types of a hub.
enum class Fastening { unsaid, key, two_keys, spline, press_fit, set_screw, pin };

constexpr auto choices_of(Fastening) {
  using F = Fastening;
  return std::array{ChoiceName<F>{F::unsaid, "not_given", "not given", "unstated"},
                    ChoiceName<F>{F::key, "key", "a parallel key"},
                    ChoiceName<F>{F::two_keys, "two_keys", "two parallel keys"},
                    ChoiceName<F>{F::spline, "spline", "a spline"},
                    ChoiceName<F>{F::press_fit, "press_fit", "an interference fit"},
                    ChoiceName<F>{F::set_screw, "set_screw", "set screws"},
                    ChoiceName<F>{F::pin, "pin", "a pin across the shaft"}};
}

struct Connection {
  Fastening fastening = Fastening::unsaid;
  Moment T_c = unset<Moment>, T_peak = unset<Moment>;
  Force F_c = unset<Force>;
  Length d_c = unset<Length>, b_c = unset<Length>, l_c = unset<Length>, t_c = unset<Length>;
  Length D_c = unset<Length>;
  AngularSpeed n_c = unset<AngularSpeed>;
  double r_c = unset<double>;
  Stress R_c = unset<Stress>;

  static constexpr Fields fields{
      Choice{&Connection::fastening, "fastening", "type of fastening"},
      Field{&Connection::T_c, "T_c", N_m, "torque for which the connection is assessed"}.holding("K_A"),
      Field{&Connection::T_peak, "T_peak", N_m, "peak torque (start, jam) for which the connection is assessed"}
          .holding("K_A"),
      Field{&Connection::F_c, "F_c", N, "axial force for which the connection is assessed"}.holding("K_A"),
      Field{&Connection::d_c, "d_c", mm, "shaft diameter of the connection"},
      Field{&Connection::b_c, "b_c", mm, "bore of the shaft in the calculation"},
      Field{&Connection::l_c, "l_c", mm, "axial length of the connection"},
      Field{&Connection::t_c, "t_c", mm, "keyway depth in the hub"},
      Field{&Connection::D_c, "D_c", mm, "outer diameter of the hub in that calculation"},
      Field{&Connection::n_c, "n_c", rpm, "speed up to which the interference fit is assessed"},
      Field{&Connection::r_c, "r_c", ratio, "torque ratio T_min/T_max for which the connection is assessed"},
      Field{&Connection::R_c, "R_c", MPa, "yield strength of the shaft in the calculation"}};
};

/// Connection for a torque with application factor, possibly zero: then it fastens nothing.
inline Connection connection_for(Fastening fastening, Moment T, Length d, Length bore) {
  Connection c;
  c.fastening = fastening;
  c.T_c = c.T_peak = T > 0.0 * N_m.one ? T : unset<Moment>;
  c.F_c = 0.0 * N.one, c.d_c = d, c.b_c = bore;
  return c;
}

inline constexpr const char* connection_doc = "shaft-hub connection, for a seat of shaft.design: connection";

}  // namespace loadpath
