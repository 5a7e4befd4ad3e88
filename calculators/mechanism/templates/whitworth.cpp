#include "calculators/mechanism/templates/quick_return.hpp"
#include "calculators/mechanism/templates/template_of.hpp"

namespace loadpath::planar::templates {

struct Whitworth : QuickReturn {
  static constexpr auto id = "whitworth";
  static constexpr auto title = "Whitworth quick-return mechanism";
  static constexpr auto doc =
      "Crank OA turns about the origin O; its pin A turns the slotted lever about B below O, which lies within the "
      "crank's circle. The lever's other arm BC moves the ram D through the rod CD along a guide parallel to the x "
      "axis.";
  static constexpr auto example = R"([shaper]
calculator = "mechanism.planar"
template = "whitworth"
gravity = "0 m/s^2"
r = "100 mm"
d = "40 mm"
c = "80 mm"
l = "250 mm"
crank = { speed = "60 rpm", positions = 72 }
links.ram.mass = "12 kg"
loads = [{ link = "ram", at = "D", F_x = "-1.5 kN", F_y = "0 N" }]
)";

  Length e = 0.0 * m.one;
  static constexpr Fields fields{
      Field{&Whitworth::r, "r", mm, "length of the crank OA"}.positive(),
      Field{&Whitworth::d, "d", mm, "distance of the lever's pin B from O, less than r"}.positive(),
      Field{&Whitworth::c, "c", mm, "length of the lever's arm BC, opposite to A"}.positive(),
      Field{&Whitworth::l, "l", mm, "length of the rod CD"}.positive(),
      Field{&Whitworth::e, "e", mm, "height of the guide above B"},
      Choice{&Whitworth::assembly, "assembly", "open: the ram is ahead of C in x, crossed: behind it"}
          .may_be_missing()};

  void draw(Sketch& sketch) const { QuickReturn::draw(sketch, Arm::opposite, e); }

  [[nodiscard]] std::optional<FieldFault> crank_stop() const {
    if (r <= d) {
      return FieldFault{"r",
                        say("the slotted lever does not turn round: the crank, r = {1}, must be longer than the "
                            "distance of the lever's pin, d = {2}",
                            text_of(r), text_of(d)),
                        say("with a shorter crank the lever swings: template = \"shaper\"")};
    }
    if (l > c + abs(e)) return std::nullopt;
    return FieldFault{
        "l",
        say("the lever cannot make a full revolution: the rod, l = {1}, must exceed the sum of arm and offset, {2}",
            text_of(l), text_of(c + abs(e))),
        part_of_a_turn()};
  }
};

template const MechanismTemplate& mechanism_template<Whitworth>();

}  // namespace loadpath::planar::templates
