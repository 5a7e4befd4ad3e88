#include "lib/draw/side/description.hpp"

namespace loadpath::draw::shaft {

std::string description(const std::vector<Cylinder>& cylinders, const std::vector<TorqueSign>& torques,
                        const std::vector<BearingSign>& bearings) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  for (const Cylinder& c : cylinders) {
    const std::string length = format_quantity(c.part->length, "mm", 5), d = diameters(*c.part);
    add(c.bore > 0.0
            ? say("length {1}, diameter {2}, bore {3}", length, d, format_quantity(c.part->bore, "mm", 5)).text()
            : say("length {1}, diameter {2}", length, d).text());
  }
  for (const TorqueSign& sign : torques) {
    add(say("torque {1} = {2} at {3}", plain(sign.torque->label), format_quantity(sign.torque->value, "N*m", 4),
            format_quantity(sign.torque->x, "mm", 5))
            .text());
  }
  for (const BearingSign& sign : bearings) {
    const Message place =
        say("bearing {1} at {2}", plain(sign.bearing->label), format_quantity(sign.bearing->x, "mm", 5));
    const double force = sign.bearing->force;
    add(acts(force) ? say("{1}: {2}", place, format_quantity(force, "N", 4)).text() : place.text());
  }
  return text;
}

}  // namespace loadpath::draw::shaft
