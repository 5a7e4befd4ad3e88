#include "calculators/mechanism/templates/planar_template.hpp"

#include <array>

namespace loadpath::templates {

// One line per template; the only list of them.
// clang-format off
static constexpr std::array list{
    &planar_template<struct SliderCrank>,
    &planar_template<struct OscillatingCylinder>,
    &planar_template<struct FourBar>,
    &planar_template<struct SlottedLever>,
    &planar_template<struct Shaper>,
    &planar_template<struct Whitworth>,
    &planar_template<struct ScotchYoke>,
    &planar_template<struct Watt2>,
    &planar_template<struct FourBarSlider>,
    &planar_template<struct Stephenson3>,
    &planar_template<struct TogglePress>,
    &planar_template<struct LoaderArm>,
    &planar_template<struct CamFollower>,
    &planar_template<struct CamArm>,
    &planar_template<struct CamFlatFollower>,
};
// clang-format on

std::span<const Template* const> all() {
  static const auto templates = [] {
    std::array<const Template*, list.size()> made{};
    for (std::size_t i = 0; i < list.size(); ++i) made[i] = &list[i]();
    return made;
  }();
  return templates;
}

}  // namespace loadpath::templates
