#include "calculators/catalogue.hpp"

#include "calculators/machine/flywheel_step.hpp"
#include "calculators/mechanism/planar_step.hpp"
#include "lib/project/run/calculator_step.hpp"

#include <array>

namespace loadpath {

namespace {

struct Row {
  const Calculator& (*calculator)();
  std::unique_ptr<project::Step> (*make_step)(project::StepInput&& input) = &project::make_calculator_step;
};

}  // namespace

// One line per calculator; the only list of them. Explicit, because a linker drops objects that nothing refers to.
// clang-format off
static constexpr std::array all{
    Row{&erased<struct PlanarMechanism>, &make_planar_step},
    Row{&erased<struct Torsion>},
    Row{&erased<struct Overhung>},
    Row{&erased<struct SolidCircle>},
    Row{&erased<struct RingSection>},
    Row{&erased<struct RectangleSection>},
    Row{&erased<struct ISection>},
    Row{&erased<struct ChannelSection>},
    Row{&erased<struct AngleSection>},
    Row{&erased<struct TeeSection>},
    Row{&erased<struct HollowSection>},
    Row{&erased<struct PolygonSection>},
    Row{&erased<struct BuiltUpSection>},
    Row{&erased<struct Buckling>},
    Row{&erased<struct LightestColumn>},
    Row{&erased<struct EffectiveLength>},
    Row{&erased<struct VesselCylinder>},
    Row{&erased<struct VesselSphere>},
    Row{&erased<struct VesselCone>},
    Row{&erased<struct VesselTorus>},
    Row{&erased<struct VesselEllipsoid>},
    Row{&erased<struct VesselShell>},
    Row{&erased<struct FatigueCycle>},
    Row{&erased<struct FatigueEndurance>},
    Row{&erased<struct FatigueWohler>},
    Row{&erased<struct GearPair>},
    Row{&erased<struct Planetary>},
    Row{&erased<struct RollerChain>},
    Row{&erased<struct DriveTrain>},
    Row{&erased<struct FlatBelt>},
    Row{&erased<struct VBelt>},
    Row{&erased<struct VBeltSizing>},
    Row{&erased<struct BeltCourse>},
    Row{&erased<struct PointMotion>},
    Row{&erased<struct Rotation>},
    Row{&erased<struct PlaneMotion>},
    Row{&erased<struct CompoundMotion>},
    Row{&erased<struct ForceOfMotion>},
    Row{&erased<struct Throw>},
    Row{&erased<struct Impulse>},
    Row{&erased<struct SystemMomentum>},
    Row{&erased<struct MassCentre>},
    Row{&erased<struct AngularMomentumChange>},
    Row{&erased<struct WorkAndEnergy>},
    Row{&erased<struct Lift>},
    Row{&erased<struct Flywheel>, &make_flywheel_step},
    Row{&erased<struct RunUp>},
};
// clang-format on

project::Catalogue catalogue() {
  static const auto entries = [] {
    std::array<project::CatalogueEntry, all.size()> list{};
    for (std::size_t i = 0; i < all.size(); ++i) list[i] = {&all[i].calculator(), all[i].make_step};
    return list;
  }();
  return entries;
}

Calculators calculators() {
  static const auto list = [] {
    std::array<const Calculator*, all.size()> pointers{};
    for (std::size_t i = 0; i < all.size(); ++i) pointers[i] = catalogue()[i].calculator;
    return pointers;
  }();
  return list;
}

}  // namespace loadpath
