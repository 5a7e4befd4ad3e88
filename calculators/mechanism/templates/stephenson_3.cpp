#include "calculators/mechanism/templates/six_bar.hpp"
#include "calculators/mechanism/templates/template_of.hpp"

namespace loadpath::planar::templates {

struct Stephenson3 : SixBar {
  static constexpr auto id = "stephenson_3";
  static constexpr auto title = "Stephenson III six-bar linkage";
  static constexpr auto doc =
      "A four-bar O, A, B, C as template four_bar; the point D of its coupler, reckoned from A, drives a dyad DE, FE.";
  static constexpr auto example = R"([dwell]
calculator = "mechanism.planar"
template = "stephenson_3"
gravity = "0 m/s^2"
a = "40 mm"
b = "120 mm"
c = "80 mm"
d = "100 mm"
g = "70 mm"
gamma = "40 deg"
f = "150 mm"
h = "140 mm"
x_F = "200 mm"
y_F = "100 mm"
crank = { speed = "60 rpm", positions = 72 }
links.rocker_2.mass = "1 kg"
loads = [{ link = "rocker_2", M = "-10 N*m" }]
)";

  void draw(Sketch& sketch) const {
    const Pins at = pins(sketch);
    const Pin on_coupler = pin_D();
    FourBarLengths::draw(sketch, at, &on_coupler);
    draw_dyad(sketch, pin_D(at.A, at.B), "coupler");
  }
};

template const MechanismTemplate& mechanism_template<Stephenson3>();

}  // namespace loadpath::planar::templates
