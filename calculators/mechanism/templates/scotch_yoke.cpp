#include "calculators/mechanism/templates/template_of.hpp"

namespace loadpath::planar::templates {

struct ScotchYoke {
  static constexpr auto id = "scotch_yoke";
  static constexpr auto title = "Scotch yoke: harmonic motion";
  static constexpr auto doc =
      "Crank OA turns about the origin O; its pin A runs in the yoke's slot, which is at right angles to the yoke's "
      "guide along the x axis.";
  static constexpr auto example = R"([pump]
calculator = "mechanism.planar"
template = "scotch_yoke"
gravity = "0 m/s^2"
r = "25 mm"
crank = { speed = "300 rpm", positions = 72 }
links.crank.mass = "0.4 kg"
links.yoke.mass = "1.5 kg"
loads = [{ link = "yoke", at = "K", F_x = "-400 N", F_y = "0 N" }]
)";

  Length r = unset<Length>;
  static constexpr Fields fields{Field{&ScotchYoke::r, "r", mm, "length of the crank OA"}.positive()};

  void draw(Sketch& sketch) const {
    const Pin A = sketch.crank_arm(r), K{"K", {A.at.x, 0.0}};
    sketch.block("yoke", K, 0.0);
    sketch.slot("A", {"crank", "yoke"}, {"A", "K"}, pi / 2.0);
    sketch.prismatic("guide", {"yoke", "ground"}, {"K", "O"});
  }
};

template const MechanismTemplate& mechanism_template<ScotchYoke>();

}  // namespace loadpath::planar::templates
