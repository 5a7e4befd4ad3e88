// The words of the choices of a V-belt drive.
#pragma once

#include "calculators/belt/v.hpp"

namespace loadpath::belt {

constexpr auto choices_of(V::BeltClass) {
  using Class = V::BeltClass;
  return std::array{ChoiceName<Class>{Class::unstated, "unstated", "not stated"},
                    ChoiceName<Class>{Class::classes_0_II, "0_II", "classes 0, I and II of GOST 1284.2"},
                    ChoiceName<Class>{Class::III, "III", "class III of GOST 1284.2"},
                    ChoiceName<Class>{Class::IV, "IV", "class IV of GOST 1284.2"}};
}
constexpr auto choices_of(V::Duty) {
  using Duty = V::Duty;
  return std::array{ChoiceName<Duty>{Duty::unstated, "unstated", "not stated"},
                    ChoiceName<Duty>{Duty::light, "light", "even load: fans, centrifugal pumps, lathes"},
                    ChoiceName<Duty>{Duty::medium, "medium", "moderate changes: milling machines, generators"},
                    ChoiceName<Duty>{Duty::heavy, "heavy", "strong changes: piston pumps, planers, presses"},
                    ChoiceName<Duty>{Duty::very_heavy, "very_heavy", "shocks: crushers, mills, shears"}};
}
constexpr auto choices_of(V::Motor) {
  using Motor = V::Motor;
  return std::array{ChoiceName<Motor>{Motor::unstated, "unstated", "not stated"},
                    ChoiceName<Motor>{Motor::normal, "normal", "normal starting torque"},
                    ChoiceName<Motor>{Motor::high, "high", "high starting torque, piston engines"}};
}
constexpr auto choices_of(V::Tensioning) {
  using Tensioning = V::Tensioning;
  return std::array{ChoiceName<Tensioning>{Tensioning::fixed, "fixed", "centres that are fixed when running"},
                    ChoiceName<Tensioning>{Tensioning::constant_force, "constant_force",
                                           "a weight or spring that always pulls alike"}};
}
constexpr auto choices_of(V::End) {
  return std::array{ChoiceName<V::End>{V::End::low, "low", "the low end: more belts"},
                    ChoiceName<V::End>{V::End::high, "high", "the high end"}};
}

}  // namespace loadpath::belt
