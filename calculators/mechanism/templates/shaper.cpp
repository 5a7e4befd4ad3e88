#include "calculators/mechanism/templates/quick_return.hpp"
#include "calculators/mechanism/templates/template_of.hpp"

namespace loadpath::planar::templates {

struct Shaper : QuickReturn {
  static constexpr auto id = "shaper";
  static constexpr auto title = "Shaper mechanism";
  static constexpr auto doc =
      "Crank OA turns about the origin O; its pin A runs in the slot of the lever BC, which swings about B below O, "
      "outside of the crank's circle. The lever moves the ram D through the rod CD along a guide parallel to the x "
      "axis.";
  static constexpr auto example = R"([shaper]
calculator = "mechanism.planar"
template = "shaper"
gravity = "0 m/s^2"
r = "80 mm"
d = "250 mm"
c = "450 mm"
l = "150 mm"
e = "440 mm"
crank = { speed = "60 rpm", positions = 72 }
links.lever.mass = "6 kg"
links.ram.mass = "15 kg"
loads = [{ link = "ram", at = "D", F_x = "-1.5 kN", F_y = "0 N" }]
)";

  Length e = unset<Length>;
  static constexpr Fields fields{
      Field{&Shaper::r, "r", mm, "length of the crank OA"}.positive(),
      Field{&Shaper::d, "d", mm, "distance of the lever's pin B from O, more than r"}.positive(),
      Field{&Shaper::c, "c", mm, "length of the lever BC"}.positive(),
      Field{&Shaper::l, "l", mm, "length of the rod CD"}.positive(),
      Field{&Shaper::e, "e", mm, "height of the guide above B"},
      Choice{&Shaper::assembly, "assembly", "open: the ram is ahead of C in x, crossed: behind it"}.may_be_missing()};

  void draw(Sketch& sketch) const { QuickReturn::draw(sketch, Arm::along_slot, e); }

  [[nodiscard]] std::optional<FieldFault> crank_stop() const {
    if (r >= d) {
      return FieldFault{"r",
                        say("the lever does not swing: the crank, r = {1}, must be shorter than the distance of the "
                            "lever's pin, d = {2}",
                            text_of(r), text_of(d)),
                        say("with a longer crank the lever makes full revolutions: template = \"whitworth\"")};
    }
    if (c <= d + r) return leaves_slot("c", c, d + r);
    const Length lowest = c * sqrt(1.0 - r * r / (d * d));  // height of C above B, at the ends of the swing
    const Length away = max(abs(c - e), abs(lowest - e));
    if (l > away) return std::nullopt;
    return FieldFault{"l",
                      say("the crank cannot make a full revolution: the end of the lever moves as far as {1} from the "
                          "guide, but the rod is only {2} long",
                          text_of(away), text_of(l)),
                      part_of_a_turn()};
  }
};

template const MechanismTemplate& mechanism_template<Shaper>();

}  // namespace loadpath::planar::templates
