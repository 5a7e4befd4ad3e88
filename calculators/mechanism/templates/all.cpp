#include "calculators/mechanism/templates/template.hpp"

#include <array>

namespace loadpath::planar::templates {

// One line per template; the only list of them.
// clang-format off
static constexpr std::array list{
    &mechanism_template<struct SliderCrank>,
    &mechanism_template<struct OscillatingCylinder>,
    &mechanism_template<struct FourBar>,
    &mechanism_template<struct SlottedLever>,
    &mechanism_template<struct Shaper>,
    &mechanism_template<struct Whitworth>,
    &mechanism_template<struct ScotchYoke>,
    &mechanism_template<struct Watt2>,
    &mechanism_template<struct FourBarSlider>,
    &mechanism_template<struct Stephenson3>,
    &mechanism_template<struct TogglePress>,
    &mechanism_template<struct LoaderArm>,
    &mechanism_template<struct CamFollower>,
    &mechanism_template<struct CamArm>,
    &mechanism_template<struct CamFlatFollower>,
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

}  // namespace loadpath::planar::templates
