#include "calculators/mechanism/templates/four_bar_lengths.hpp"
#include "calculators/mechanism/templates/template_of.hpp"
#include "lib/calculator/fields.hpp"

namespace loadpath::planar::templates {

struct FourBarSlider : FourBarLengths {
  static constexpr auto id = "four_bar_slider";
  static constexpr auto title = "Six-bar slider mechanism (four-bar and slider)";
  static constexpr auto doc =
      "A four-bar O, A, B, C as template four_bar; its rocker has a second arm CD that moves the slider E through the "
      "rod DE along a guide parallel to the x axis.";
  static constexpr auto example = R"([feeder]
calculator = "mechanism.planar"
template = "four_bar_slider"
gravity = "0 m/s^2"
a = "40 mm"
b = "120 mm"
c = "80 mm"
d = "100 mm"
g = "120 mm"
l = "200 mm"
e = "100 mm"
crank = { speed = "60 rpm", positions = 72 }
links.slider.mass = "3 kg"
loads = [{ link = "slider", at = "E", F_x = "-200 N", F_y = "0 N" }]
)";

  Length g = unset<Length>;
  double gamma = 0.0;
  Length l = unset<Length>, e = unset<Length>;
  Assembly assembly_2 = Assembly::open;
  static constexpr auto fields =
      join(FourBarLengths::fields,
           Fields{Field{&FourBarSlider::g, "g", mm, "length of the rocker's arm CD"}.positive(),
                  Field{&FourBarSlider::gamma, "gamma", deg, "direction of D, from CB, counter-clockwise"},
                  Field{&FourBarSlider::l, "l", mm, "length of the rod DE"}.positive(),
                  Field{&FourBarSlider::e, "e", mm, "height of the guide: its y"},
                  Choice{&FourBarSlider::assembly_2, "assembly_2", "open: E is ahead of D in x, crossed: behind it"}
                      .may_be_missing()});

  void draw(Sketch& sketch) const {
    const Pins at = pins(sketch);
    const Pin on_rocker{"D", polar(g, gamma)};
    const Pin D{"D", at.C.at + polar(g, gamma + direction(at.C.at, at.B.at))}, G{"G", {0.0, in_si(e)}};
    const Pin E{"E", sketch.meet({"rod", D.at, l}, Line{G.at, {1.0, 0.0}}, assembly_2)};
    FourBarLengths::draw(sketch, at, nullptr, &on_rocker);
    sketch.fixed(G);
    sketch.bar("rod", D, E, l);
    sketch.block("slider", E, 0.0);
    sketch.revolute("D", "rocker", "rod");
    sketch.revolute("E", "rod", "slider");
    sketch.prismatic("guide", {"slider", "ground"}, {"E", "G"});
  }
};

template const MechanismTemplate& mechanism_template<FourBarSlider>();

}  // namespace loadpath::planar::templates
