#include "calculators/catalogue.hpp"

#include <array>

namespace loadpath {

// One line per calculator; the only list of them. Explicit, because a linker drops objects that nothing refers to.
static constexpr std::array all{
    &erased<struct PlanarMechanism>,
    &erased<struct Torsion>,
    &erased<struct Overhung>,
    &erased<struct PointMotion>,
    &erased<struct Rotation>,
    &erased<struct PlaneMotion>,
    &erased<struct CompoundMotion>,
    &erased<struct ForceOfMotion>,
    &erased<struct Throw>,
    &erased<struct Impulse>,
    &erased<struct SystemMomentum>,
    &erased<struct MassCentre>,
    &erased<struct AngularMomentumChange>,
    &erased<struct WorkAndEnergy>,
    &erased<struct Lift>,
    &erased<struct Flywheel>,
    &erased<struct RunUp>,
};

Catalogue catalogue() {
  static const auto calculators = [] {
    std::array<const Calculator*, all.size()> list{};
    for (std::size_t i = 0; i < all.size(); ++i) list[i] = &all[i]();
    return list;
  }();
  return calculators;
}

}  // namespace loadpath
