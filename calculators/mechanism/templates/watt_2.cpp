#include "calculators/mechanism/templates/six_bar.hpp"
#include "calculators/mechanism/templates/template_of.hpp"

namespace loadpath::planar::templates {

struct Watt2 : SixBar {
  static constexpr auto id = "watt_2";
  static constexpr auto title = "Watt II six-bar linkage";
  static constexpr auto doc =
      "A four-bar O, A, B, C as template four_bar; its rocker has a second arm CD that drives the second four-bar C, "
      "D, E, F.";
  static constexpr auto example = R"([bars]
calculator = "mechanism.planar"
template = "watt_2"
gravity = "0 m/s^2"
a = "40 mm"
b = "120 mm"
c = "80 mm"
d = "100 mm"
g = "60 mm"
gamma = "-60 deg"
f = "110 mm"
h = "90 mm"
x_F = "220 mm"
y_F = "0 mm"
crank = { speed = "60 rpm", positions = 72 }
links.rocker_2.mass = "1 kg"
loads = [{ link = "rocker_2", M = "-10 N*m" }]
)";

  void draw(Sketch& sketch) const {
    const Pins at = pins(sketch);
    const Pin on_rocker = pin_D();
    FourBarLengths::draw(sketch, at, nullptr, &on_rocker);
    draw_dyad(sketch, pin_D(at.C, at.B), "rocker");
  }
};

template const MechanismTemplate& mechanism_template<Watt2>();

}  // namespace loadpath::planar::templates
