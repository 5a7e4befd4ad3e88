// The largest stress of a part, an input record of fatigue.cycle: cycle = "=shaft.cycle". The cycle type is given
// there, and passed to fatigue.life with both extremes.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/quantity/units.hpp"

#include <array>

namespace loadpath {

enum class Stresses { normal, shear };

constexpr auto choices_of(Stresses) {
  return std::array{ChoiceName<Stresses>{Stresses::normal, "normal", "normal stresses, sigma"},
                    ChoiceName<Stresses>{Stresses::shear, "shear", "shear stresses: read tau for sigma"}};
}

/// A nominal stress, with the application factor.
struct StressCycle {
  Stresses stress = Stresses::normal;
  Stress sigma_max = unset<Stress>;

  static constexpr Fields fields{
      Choice{&StressCycle::stress, "stress", "stress component: normal or shear"},
      Field{&StressCycle::sigma_max, "sigma_max", MPa, "maximum nominal stress, with the application factor"}
          .load()
          .holding("K_A")};
};

/// A cycle with both its ends.
struct WholeCycle {
  Stresses stress = Stresses::normal;
  Stress sigma_max = unset<Stress>, sigma_min = unset<Stress>;

  static constexpr Fields fields{
      Choice{&WholeCycle::stress, "stress", "stress component: normal or shear"},
      Field{&WholeCycle::sigma_max, "sigma_max", MPa, "maximum nominal stress, signed"}.load(),
      Field{&WholeCycle::sigma_min, "sigma_min", MPa, "minimum nominal stress, signed"}.load()};
};

}  // namespace loadpath
