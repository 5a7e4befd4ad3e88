#include "calculators/mechanism/templates/template_of.hpp"

namespace loadpath::planar::templates {

struct SlottedLever {
  static constexpr auto id = "slotted_lever";
  static constexpr auto title = "Slotted-lever mechanism";
  static constexpr auto doc =
      "Crank OA turns about the origin O; its pin A runs in the slot of the lever BC, which swings about B on the x "
      "axis left of O, or turns with the crank where r > d.";
  static constexpr auto example = R"([lever]
calculator = "mechanism.planar"
template = "slotted_lever"
gravity = "0 m/s^2"
r = "30 mm"
d = "90 mm"
l = "150 mm"
crank = { speed = "45 rad/s", positions = 72 }
links.lever.mass = "2 kg"
loads = [{ link = "lever", M = "-30 N*m" }]
)";

  Length r = unset<Length>, d = unset<Length>, l = unset<Length>;
  static constexpr Fields fields{Field{&SlottedLever::r, "r", mm, "length of the crank OA"}.positive(),
                                 Field{&SlottedLever::d, "d", mm, "distance of the lever's pin B from O"}.positive(),
                                 Field{&SlottedLever::l, "l", mm, "length of the lever BC"}.positive()};

  void draw(Sketch& sketch) const {
    const Pin A = sketch.crank_arm(r), B{"B", {-in_si(d), 0.0}};
    const Pin C{"C", B.at + polar(l, direction(B.at, A.at))};
    sketch.fixed(B);
    sketch.bar("lever", B, C, l);
    sketch.revolute("B", "ground", "lever");
    sketch.slot("A", {"crank", "lever"}, {"A", "B"});
  }

  [[nodiscard]] std::optional<FieldFault> crank_stop() const {
    if (l > d + r) return pin_runs_through("B", r, d);
    return leaves_slot("l", l, d + r);
  }
};

template const MechanismTemplate& mechanism_template<SlottedLever>();

}  // namespace loadpath::planar::templates
