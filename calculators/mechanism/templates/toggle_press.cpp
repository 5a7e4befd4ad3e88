#include "calculators/mechanism/templates/four_bar_lengths.hpp"
#include "calculators/mechanism/templates/template_of.hpp"

namespace loadpath::planar::templates {

struct TogglePress {
  static constexpr auto id = "toggle_press";
  static constexpr auto title = "Toggle press";
  static constexpr auto doc =
      "Crank OA turns about the origin O; the rod AB moves the knee B of a toggle. The upper lever CB is suspended "
      "from the fixed pin C, the lower lever BD pushes the ram D along the vertical through C.";
  static constexpr auto example = R"([press]
calculator = "mechanism.planar"
template = "toggle_press"
gravity = "0 m/s^2"
r = "40 mm"
l = "215 mm"
b = "180 mm"
f = "180 mm"
x_C = "260 mm"
y_C = "170 mm"
crank = { speed = "30 rpm", positions = 72 }
links.ram.mass = "40 kg"
loads = [{ link = "ram", at = "D", F_x = "0 N", F_y = "8 kN" }]
)";

  Length r = unset<Length>, l = unset<Length>, b = unset<Length>, f = unset<Length>;
  Length x_C = unset<Length>, y_C = unset<Length>;
  Assembly assembly = Assembly::open, ram = Assembly::open;
  static constexpr Fields fields{
      Field{&TogglePress::r, "r", mm, "length of the crank OA"}.positive(),
      Field{&TogglePress::l, "l", mm, "length of the rod AB"}.positive(),
      Field{&TogglePress::b, "b", mm, "length of the upper lever CB"}.positive(),
      Field{&TogglePress::f, "f", mm, "length of the lower lever BD"}.positive(),
      Field{&TogglePress::x_C, "x_C", mm, "fixed pin C"},
      Field{&TogglePress::y_C, "y_C", mm, "fixed pin C"},
      Choice{&TogglePress::assembly, "assembly", "B is right of the line from A to C: open, or left of it: crossed"}
          .may_be_missing(),
      Choice{&TogglePress::ram, "ram", "open: the ram is below B, crossed: above it"}.may_be_missing()};

  void draw(Sketch& sketch) const {
    const Pin A = sketch.crank_arm(r), C{"C", cartesian(x_C, y_C)};
    const Pin B{"B", sketch.meet({"upper", C.at, b}, PlacedLink{"rod", A.at, l}, assembly)};
    const Pin D{"D", sketch.meet({"lower", B.at, f}, Line{C.at, {0.0, -1.0}}, ram)};
    sketch.fixed(C);
    sketch.bar("rod", A, B, l);
    sketch.bar("upper", C, B, b);
    sketch.bar("lower", B, D, f);
    sketch.block("ram", D, 0.0);
    sketch.revolute("A", "crank", "rod");
    sketch.revolute("B", "rod", "upper");
    sketch.revolute("B_lower", "upper", "lower", "B");
    sketch.revolute("C", "ground", "upper");
    sketch.revolute("D", "lower", "ram");
    sketch.prismatic("guide", {"ram", "ground"}, {"D", "C"}, -pi / 2.0);
  }

  [[nodiscard]] std::optional<FieldFault> crank_stop() const {
    return stop_of({r, l, b, sqrt(x_C * x_C + y_C * y_C), "rod", "upper lever"}, "r");
  }
};

template const MechanismTemplate& mechanism_template<TogglePress>();

}  // namespace loadpath::planar::templates
