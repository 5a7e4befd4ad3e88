#include "lib/rainflow/rules.hpp"

#include <cmath>

namespace loadpath::rainflow {

std::optional<Fault> contradiction(const Rules& rules) {
  if (!(rules.gate >= 0.0) || !std::isfinite(rules.gate))
    return Fault{0, 1, say("the gate must be a range, 0 or more"), {}};
  if (rules.residue != Residue::repeated) return std::nullopt;
  if (rules.method == Method::astm)
    return Fault{0, 1, say("ASTM E1049 counts its residue as half cycles, and none is left to be repeated"),
                 say("count one period as periodic, or by the four-point method")};
  if (rules.method == Method::hcm)
    return Fault{0, 1, say("HCM leaves no start that a repetition could come back to"),
                 say("count one period as periodic, or by the four-point method")};
  return std::nullopt;
}

}  // namespace loadpath::rainflow
