#include "calculators/mechanism/templates/template_of.hpp"

namespace loadpath::planar::templates {

struct SliderCrank {
  static constexpr auto id = "slider_crank";
  static constexpr auto title = "Slider-crank, central or offset";
  static constexpr auto doc =
      "Crank OA turns about the origin O, the rod AB moves the slider B along a guide parallel to the x axis.";
  static constexpr auto example = R"([press]
calculator = "mechanism.planar"
template = "slider_crank"
gravity = "0 m/s^2"
r = "50 mm"
l = "200 mm"
crank = { speed = "60 rpm", positions = 72 }
links.rod.mass = "1 kg"
links.slider.mass = "2 kg"
loads = [{ link = "slider", at = "B", F_x = "-1 kN", F_y = "0 N" }]
)";

  Length r = unset<Length>, l = unset<Length>, e = 0.0 * m.one;
  Assembly assembly = Assembly::open;
  static constexpr Fields fields{
      Field{&SliderCrank::r, "r", mm, "length of the crank OA"}.positive(),
      Field{&SliderCrank::l, "l", mm, "length of the rod AB"}.positive(),
      Field{&SliderCrank::e, "e", mm, "offset of the guide: its y"},
      Choice{&SliderCrank::assembly, "assembly", "open: the slider is ahead of the crank pin in x, crossed: behind it"}
          .may_be_missing()};

  void draw(Sketch& sketch) const {
    const Pin A = sketch.crank_arm(r), G{"G", {0.0, in_si(e)}};
    const Pin B{"B", sketch.meet({"rod", A.at, l}, Line{G.at, {1.0, 0.0}}, assembly)};
    sketch.fixed(G);
    sketch.bar("rod", A, B, l);
    sketch.block("slider", B, 0.0);
    sketch.revolute("A", "crank", "rod");
    sketch.revolute("B", "rod", "slider");
    sketch.prismatic("guide", {"slider", "ground"}, {"B", "G"});
  }

  [[nodiscard]] std::optional<FieldFault> crank_stop() const {
    if (l > r + abs(e)) return std::nullopt;
    return FieldFault{
        "l",
        say("the crank cannot make a full revolution: the rod, l = {1}, must exceed the sum of crank and offset, {2}",
            text_of(l), text_of(r + abs(e))),
        part_of_a_turn()};
  }
};

template const MechanismTemplate& mechanism_template<SliderCrank>();

}  // namespace loadpath::planar::templates
