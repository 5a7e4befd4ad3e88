// The failure and serviceability modes of any shaft; the modes of its calculator precede them.
#pragma once

#include "lib/calculator/fields.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/quantity/units.hpp"

#include <algorithm>

namespace loadpath::shaft {

/// A service factor says that the load is not even.
template <class Input>
Applies load_varies(const Input& in) {
  return shown_by(in.K_A > 1.0);
}

/// Walls thinner than d/20 can buckle in torsion before they yield; solid and thick ones do not.
inline Applies thin_wall_of(Length d, double chi, Length d_bore) {
  constexpr double thin = 0.9;
  if (is_set(d_bore)) return is_set(d) ? where(d_bore > thin * d) : Applies::unseen;
  return where(chi > thin);
}

template <class Input>
Applies thin_wall(const Input& in) {
  Applies applies = thin_wall_of(in.d, in.chi, in.d_bore);
  if constexpr (requires { in.segments; }) {
    for (const auto& s : in.segments)
      applies = std::max(applies, thin_wall_of(is_set(s.d) ? s.d : in.d, s.chi, s.d_bore));
  }
  return applies;
}

/// Where a shaft breaks first that turns, or whose load varies.
template <class Input>
constexpr Mode<Input> fatigue_of_shaft() {
  return Mode<Input>{"fatigue", "fatigue (shoulders, keyways, press fits)", &load_varies<Input>}
      .independent_of_loads()
      .in_service();
}

/// Modes of the calculator, and those of every shaft.
template <class Input, std::size_t judged>
constexpr auto with_modes_of_shafts(const std::array<Mode<Input>, judged>& own) {
  const std::array common{
      Mode<Input>{"other_loads", "other load components", &unseen<Input>}.by_companions().assessed_in("shaft.design"),
      Mode<Input>{"critical_bending", "lateral critical speed (whirling)", &unseen<Input>}.in_service().assessed_in(
          "shaft.design"),
      Mode<Input>{"critical_torsion", "torsional critical speed", &unseen<Input>}.in_service().assessed_in(
          "shaft.design"),
      Mode<Input>{"deflection", "deflection and slope", &unseen<Input>}.of_service().assessed_in("shaft.design"),
      Mode<Input>{"keyway", "yielding at keyways and notches", &unseen<Input>}.assessed_in("shaft.design"),
      Mode<Input>{"hub", "slip of shaft-hub connections", &unseen<Input>}.assessed_additionally_in(
          "shaft.key, shaft.spline, shaft.press_fit, shaft.set_screw"),
      Mode<Input>{"wall", "local buckling of thin walls", &thin_wall<Input>}.independent_of_loads(),
      Mode<Input>{"brittle", "brittle fracture", &unseen<Input>}.special()};
  return join(own, common);
}

}  // namespace loadpath::shaft
