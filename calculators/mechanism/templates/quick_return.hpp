// Common part of the shaper and Whitworth's mechanism: the pin A of a crank about O runs in the slot of a lever about
// B below O, whose end C moves a ram D through a rod along a guide parallel to the x axis.
#pragma once

#include "calculators/mechanism/templates/sketch.hpp"

namespace loadpath::planar::templates {

struct QuickReturn {
  Length r = unset<Length>, d = unset<Length>, c = unset<Length>, l = unset<Length>;  // OA, OB, BC, CD
  Assembly assembly = Assembly::open;

  enum class Arm { along_slot, opposite };
  /// `e`: height of the guide above B.
  void draw(Sketch& sketch, Arm arm, Length e) const {
    const Pin A = sketch.crank_arm(r), B{"B", {0.0, -in_si(d)}};
    const double of_arm = arm == Arm::along_slot ? direction(B.at, A.at) : direction(A.at, B.at);
    const Pin C{"C", B.at + polar(c, of_arm)}, G{"G", {0.0, in_si(e - d)}};
    const Pin D{"D", sketch.meet({"rod", C.at, l}, Line{G.at, {1.0, 0.0}}, assembly)};
    sketch.fixed(B);
    sketch.fixed(G);
    sketch.bar("lever", B, C, c);
    sketch.bar("rod", C, D, l);
    sketch.block("ram", D, 0.0);
    sketch.slot("A", {"crank", "lever"}, {"A", "B"});
    sketch.revolute("B", "ground", "lever");
    sketch.revolute("C", "lever", "rod");
    sketch.revolute("D", "rod", "ram");
    sketch.prismatic("guide", {"ram", "ground"}, {"D", "G"});
  }
};

}  // namespace loadpath::planar::templates
