// How a force varies on a point of a pin, and the share of its tensile strength that is allowed then.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/quantity/units.hpp"

#include <array>

namespace loadpath::pin {

enum class Loading { unsaid, steady, pulsating, alternating };

constexpr auto choices_of(Loading) {
  return std::array{ChoiceName<Loading>{Loading::unsaid, "", "not given"},
                    ChoiceName<Loading>{Loading::steady, "steady", "static"},
                    ChoiceName<Loading>{Loading::pulsating, "pulsating", "pulsating"},
                    ChoiceName<Loading>{Loading::alternating, "alternating", "reversing, or rotating around the pin"}};
}

/// Share of R_m; unset if the loading is not given.
struct Shares {
  double bending = unset<double>, shear = unset<double>;
};

constexpr Shares shares_of(Loading loading) {
  switch (loading) {
    case Loading::steady:
      return {0.3, 0.2};
    case Loading::pulsating:
      return {0.2, 0.15};
    case Loading::alternating:
      return {0.15, 0.1};
    case Loading::unsaid:
      break;
  }
  return {};
}

/// The typed value, else the share of R_m; unset if neither is known.
template <class Tracer>
Stress allowed_stress(const char* symbol, Stress typed, Stress R_m, double share, const char* why, Tracer& trace) {
  if (is_set(typed)) return trace.value(symbol, typed, "given");
  if (!is_set(R_m)) return typed;
  const double c_R = trace.value("c_R", share, "allowable fraction of R_m for this type of loading, [RM-9]");
  return NAMED_STEP(symbol, c_R * R_m, why);
}

/// Fatigue that the allowable stresses of a loading hold.
constexpr Applies said_to_vary(Loading loading) {
  return where(loading == Loading::pulsating || loading == Loading::alternating);
}

}  // namespace loadpath::pin
