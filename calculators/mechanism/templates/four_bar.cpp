#include "calculators/mechanism/templates/four_bar_lengths.hpp"
#include "calculators/mechanism/templates/template_of.hpp"

namespace loadpath::planar::templates {

struct FourBar : FourBarLengths {
  static constexpr auto id = "four_bar";
  static constexpr auto title = "Four-bar linkage";
  static constexpr auto doc =
      "Crank OA turns about the origin O; the coupler AB moves the rocker CB, whose fixed pin C is on the x axis.";
  static constexpr auto example = R"([bar]
calculator = "mechanism.planar"
template = "four_bar"
gravity = "0 m/s^2"
a = "40 mm"
b = "120 mm"
c = "80 mm"
d = "100 mm"
crank = { speed = "60 rpm", positions = 72 }
links.coupler.mass = "1 kg"
links.rocker.mass = "0.8 kg"
loads = [{ link = "rocker", M = "-15 N*m" }]
)";

  void draw(Sketch& sketch) const { FourBarLengths::draw(sketch, pins(sketch)); }
};

template const MechanismTemplate& mechanism_template<FourBar>();

}  // namespace loadpath::planar::templates
