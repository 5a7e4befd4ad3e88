// How the diameters of segments go together when they are searched for: each for itself, the lightest shaft of all.
#include "calculators/shaft/section.hpp"
#include "calculators/shaft/torsion/parts.hpp"
#include "calculators/shaft/torsion/torsion.hpp"

#include <numbers>

namespace loadpath::shaft {

bool Torsion::arrange(const Input&, std::span<OpenSize> sought, std::size_t way) {
  for (std::size_t i = 0; i < sought.size(); ++i) sought[i].like = i;
  return way == 0;
}

bool Torsion::raise(const Input&, std::span<OpenSize>) { return true; }

double Torsion::cost(const Input& in) {
  double volume = 0.0;
  for (const Cylinder& c : cylinders_of(in)) {
    const Length bore = bore_of(c.d_bore, c.chi, c.d);
    volume += in_si(std::numbers::pi / 4.0 * (c.d * c.d - bore * bore) * c.l);
  }
  return volume;
}

/// Strength and twist are checked for the complete shaft.
const void* Torsion::place(const Input&, std::string_view, const void*) { return nullptr; }

Message Torsion::unsound(const Input&, std::span<const OpenSize>, std::size_t) { return {}; }

}  // namespace loadpath::shaft
