#include "calculators/mechanism/templates/template_of.hpp"

namespace loadpath::planar::templates {

struct OscillatingCylinder {
  static constexpr auto id = "oscillating_cylinder";
  static constexpr auto title = "Oscillating cylinder (inverted slider-crank)";
  static constexpr auto doc =
      "Crank OA turns about the origin O; its pin A moves a rod in a cylinder that swings about C on the x axis.";
  static constexpr auto example = R"([engine]
calculator = "mechanism.planar"
template = "oscillating_cylinder"
gravity = "0 m/s^2"
r = "40 mm"
d = "160 mm"
crank = { speed = "120 rpm", positions = 72 }
links.crank.mass = "0.5 kg"
loads = [
  { link = "rod", at = "A", F_x = "300 N", F_y = "0 N", axes = "link" },
  { link = "cylinder", at = "C", F_x = "-300 N", F_y = "0 N", axes = "link" },
]
)";

  Length r = unset<Length>, d = unset<Length>;
  static constexpr Fields fields{
      Field{&OscillatingCylinder::r, "r", mm, "length of the crank OA"}.positive(),
      Field{&OscillatingCylinder::d, "d", mm, "distance of the cylinder's pin C from O"}.positive()};

  void draw(Sketch& sketch) const {
    const Pin A = sketch.crank_arm(r), C{"C", {in_si(d), 0.0}};
    const double along = direction(C.at, A.at);
    sketch.fixed(C);
    sketch.block("rod", A, along);
    sketch.block("cylinder", C, along);
    sketch.revolute("A", "crank", "rod");
    sketch.revolute("C", "ground", "cylinder");
    sketch.prismatic("bore", {"rod", "cylinder"}, {"A", "C"});
  }

  [[nodiscard]] std::optional<FieldFault> crank_stop() const { return pin_runs_through("C", r, d); }
};

template const MechanismTemplate& mechanism_template<OscillatingCylinder>();

}  // namespace loadpath::planar::templates
