#include "calculators/mechanism/templates/four_bar_lengths.hpp"

namespace loadpath::planar::templates {

std::optional<FieldFault> stop_of(const Chain& chain, const char* path) {
  const Length far = chain.frame + chain.crank, near = abs(chain.frame - chain.crank);
  const Length stretched = chain.coupler + chain.rocker, folded = abs(chain.coupler - chain.rocker);
  if (stretched <= far) {
    return FieldFault{path,
                      say("the crank cannot make a full revolution: its pin moves as far as {1} from the fixed pin of "
                          "the {2}, but {3} and {2} together reach only {4}",
                          text_of(far), chain.rocker_name, chain.coupler_name, text_of(stretched)),
                      part_of_a_turn()};
  }
  if (near <= folded) {
    return FieldFault{path,
                      say("the crank cannot make a full revolution: its pin comes within {1} of the fixed pin of the "
                          "{2}, but {3} and {2} differ by {4}",
                          text_of(near), chain.rocker_name, chain.coupler_name, text_of(folded)),
                      part_of_a_turn()};
  }
  return std::nullopt;
}

FourBarLengths::Pins FourBarLengths::pins(Sketch& sketch) const {
  Pins at{sketch.crank_arm(a), {"B", {}}, {"C", {in_si(d), 0.0}}};
  at.B.at = sketch.meet({"coupler", at.A.at, b}, PlacedLink{"rocker", at.C.at, c}, assembly);
  return at;
}

void FourBarLengths::draw(Sketch& sketch, const Pins& at, const Pin* coupler_pin, const Pin* rocker_pin) const {
  sketch.fixed(at.C);
  sketch.bar("coupler", at.A, at.B, b);
  if (coupler_pin != nullptr) sketch.point(coupler_pin->name, coupler_pin->at);
  sketch.bar("rocker", at.C, at.B, c);
  if (rocker_pin != nullptr) sketch.point(rocker_pin->name, rocker_pin->at);
  sketch.revolute("A", "crank", "coupler");
  sketch.revolute("B", "coupler", "rocker");
  sketch.revolute("C", "ground", "rocker");
}

}  // namespace loadpath::planar::templates
