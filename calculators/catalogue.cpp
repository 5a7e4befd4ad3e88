#include "calculators/catalogue.hpp"

#include "calculators/machine/flywheel_step.hpp"
#include "calculators/machine/motion/step.hpp"
#include "calculators/mechanism/step.hpp"
#include "lib/project/run/calculator_step.hpp"

#include <array>

namespace loadpath {

// clang-format off
namespace shaft { struct Torsion; struct Overhung; struct Design; struct Key; struct Spline; struct SetScrew; struct Circlip; struct PressFit; struct Held; }
namespace section {
  struct Circle; struct Ellipse; struct Ring; struct Rectangle; struct I; struct Channel; struct Angle; struct Tee; struct Hollow;
  struct Polygon; struct BuiltUp; struct ThinWalled; struct SolidTorsion;
}
namespace column { struct Buckling; struct BeamColumn; struct Lightest; struct EffectiveLength; struct Stepped; }
namespace vessel { struct Cylinder; struct Sphere; struct Cone; struct Torus; struct Ellipsoid; struct Shell; struct Thick; struct ThickWalledSphere; struct Compound; struct Autofrettage; struct External; struct End; struct FlatEnd; }
namespace fatigue { struct Cycle; struct Endurance; struct Wohler; struct Din743; struct Life; struct Combined; struct History; struct Multiaxial; struct Staircase; struct Survival; struct Fkm; }
namespace gear { struct Pair; struct Planetary; struct Rating; }
namespace chain { struct Roller; struct InvertedTooth; }
namespace gear { struct Cycloidal; struct Pair; struct Planetary; struct Rating; }
namespace gear { struct Pair; struct Planetary; struct Rating; struct Bevel; }
namespace gear { struct Pair; struct Planetary; struct Rating; struct Bevel; struct Worm; struct Crossed; struct PairSizing; }
namespace chain { struct Roller; }
namespace drive { struct Train; struct FrictionWheels; }
namespace belt { struct Flat; struct V; struct VSizing; struct Synchronous; struct Grooved; struct Course; }
namespace motion { struct Point; struct Rotation; struct Plane; struct Compound; struct Spatial; struct UniversalJoint; struct SphericalFourBar; struct AlongPath; }
namespace dynamics {
  struct ForceOfMotion; struct Throw; struct Impulse; struct SystemMomentum; struct MassCentre;
  struct AngularMomentumChange; struct WorkAndEnergy; struct Lift; struct Motion; struct Inertia;
  struct PathWork;
}
namespace machine { struct Flywheel; struct RunUp; struct Motion; struct Disc; }
namespace bearing { struct Rolling; }
namespace pin { struct Joint; struct Lug; struct En1993; struct Cross; }
namespace link { struct Member; }
// clang-format on

namespace {

struct Row {
  const Calculator& (*calculator)();
  std::unique_ptr<project::Step> (*make_step)(project::StepInput&& input) = &project::make_calculator_step;
};

}  // namespace

// One row per calculator, and its name above. Explicit, because a linker drops objects that nothing refers to.
// clang-format off
static constexpr std::array all{
    Row{&erased<planar::Mechanism>, &planar::make_step},
    Row{&erased<shaft::Torsion>},
    Row{&erased<shaft::Overhung>},
    Row{&erased<shaft::Design>},
    Row{&erased<shaft::Key>},
    Row{&erased<shaft::Spline>},
    Row{&erased<shaft::SetScrew>},
    Row{&erased<shaft::Circlip>},
    Row{&erased<shaft::PressFit>},
    Row{&erased<shaft::Held>},
    Row{&erased<section::Circle>},
    Row{&erased<section::Ellipse>},
    Row{&erased<section::Ring>},
    Row{&erased<section::Rectangle>},
    Row{&erased<section::I>},
    Row{&erased<section::Channel>},
    Row{&erased<section::Angle>},
    Row{&erased<section::Tee>},
    Row{&erased<section::Hollow>},
    Row{&erased<section::Polygon>},
    Row{&erased<section::BuiltUp>},
    Row{&erased<section::ThinWalled>},
    Row{&erased<section::SolidTorsion>},
    Row{&erased<column::Buckling>},
    Row{&erased<column::BeamColumn>},
    Row{&erased<column::Lightest>},
    Row{&erased<column::EffectiveLength>},
    Row{&erased<column::Stepped>},
    Row{&erased<vessel::Cylinder>},
    Row{&erased<vessel::Sphere>},
    Row{&erased<vessel::Cone>},
    Row{&erased<vessel::Torus>},
    Row{&erased<vessel::Ellipsoid>},
    Row{&erased<vessel::Shell>},
    Row{&erased<vessel::Thick>},
    Row{&erased<vessel::ThickWalledSphere>},
    Row{&erased<vessel::Compound>},
    Row{&erased<vessel::Autofrettage>},
    Row{&erased<vessel::External>},
    Row{&erased<vessel::End>},
    Row{&erased<vessel::FlatEnd>},
    Row{&erased<fatigue::Cycle>},
    Row{&erased<fatigue::Endurance>},
    Row{&erased<fatigue::Wohler>},
    Row{&erased<fatigue::Din743>},
    Row{&erased<fatigue::Fkm>},
    Row{&erased<fatigue::Life>},
    Row{&erased<fatigue::Combined>},
    Row{&erased<fatigue::History>},
    Row{&erased<fatigue::Multiaxial>},
    Row{&erased<fatigue::Staircase>},
    Row{&erased<fatigue::Survival>},
    Row{&erased<gear::Pair>},
    Row{&erased<gear::Planetary>},
    Row{&erased<gear::Rating>},
    Row{&erased<gear::PairSizing>},
    Row{&erased<gear::Cycloidal>},
    Row{&erased<gear::Bevel>},
    Row{&erased<gear::Worm>},
    Row{&erased<gear::Crossed>},
    Row{&erased<chain::Roller>},
    Row{&erased<chain::InvertedTooth>},
    Row{&erased<drive::Train>},
    Row{&erased<drive::FrictionWheels>},
    Row{&erased<belt::Flat>},
    Row{&erased<belt::V>},
    Row{&erased<belt::VSizing>},
    Row{&erased<belt::Synchronous>},
    Row{&erased<belt::Grooved>},
    Row{&erased<belt::Course>},
    Row{&erased<motion::Point>},
    Row{&erased<motion::AlongPath>},
    Row{&erased<motion::Rotation>},
    Row{&erased<motion::Plane>},
    Row{&erased<motion::Compound>},
    Row{&erased<motion::Spatial>},
    Row{&erased<motion::UniversalJoint>},
    Row{&erased<motion::SphericalFourBar>},
    Row{&erased<dynamics::ForceOfMotion>},
    Row{&erased<dynamics::Throw>},
    Row{&erased<dynamics::Motion>},
    Row{&erased<dynamics::Impulse>},
    Row{&erased<dynamics::SystemMomentum>},
    Row{&erased<dynamics::MassCentre>},
    Row{&erased<dynamics::Inertia>},
    Row{&erased<dynamics::AngularMomentumChange>},
    Row{&erased<dynamics::WorkAndEnergy>},
    Row{&erased<dynamics::PathWork>},
    Row{&erased<dynamics::Lift>},
    Row{&erased<machine::Flywheel>, &machine::make_flywheel_step},
    Row{&erased<machine::RunUp>},
    Row{&erased<machine::Motion>, &machine::make_motion_step},
    Row{&erased<machine::Disc>},
    Row{&erased<bearing::Rolling>},
    Row{&erased<pin::Joint>},
    Row{&erased<pin::Lug>},
    Row{&erased<pin::En1993>},
    Row{&erased<pin::Cross>},
    Row{&erased<link::Member>},
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
