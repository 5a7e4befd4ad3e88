#include "calculators/catalogue.hpp"

#include <array>

namespace loadpath {

// One line per calculator; the only list of them. Explicit, because a linker drops objects that nothing refers to.
// clang-format off
static constexpr std::array all{
    &erased<struct PlanarMechanism>,
    &erased<struct Torsion>,
    &erased<struct Overhung>,
    &erased<struct SolidCircle>,
    &erased<struct RingSection>,
    &erased<struct RectangleSection>,
    &erased<struct ISection>,
    &erased<struct ChannelSection>,
    &erased<struct AngleSection>,
    &erased<struct TeeSection>,
    &erased<struct HollowSection>,
    &erased<struct PolygonSection>,
    &erased<struct BuiltUpSection>,
    &erased<struct Buckling>,
    &erased<struct LightestColumn>,
    &erased<struct EffectiveLength>,
    &erased<struct VesselCylinder>,
    &erased<struct VesselSphere>,
    &erased<struct VesselCone>,
    &erased<struct VesselTorus>,
    &erased<struct VesselEllipsoid>,
    &erased<struct VesselShell>,
    &erased<struct FatigueCycle>,
    &erased<struct FatigueEndurance>,
    &erased<struct FatigueWohler>,
    &erased<struct GearPair>,
    &erased<struct Planetary>,
    &erased<struct RollerChain>,
    &erased<struct DriveTrain>,
    &erased<struct FlatBelt>,
    &erased<struct VBelt>,
    &erased<struct VBeltSizing>,
    &erased<struct BeltCourse>,
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
// clang-format on

Catalogue catalogue() {
  static const auto calculators = [] {
    std::array<const Calculator*, all.size()> list{};
    for (std::size_t i = 0; i < all.size(); ++i) list[i] = &all[i]();
    return list;
  }();
  return calculators;
}

}  // namespace loadpath
