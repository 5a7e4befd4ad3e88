// Inputs of dished and flat ends alike: the pressure from the shell, and the strength.
#pragma once

#include "calculators/vessel/wall.hpp"

namespace loadpath::vessel {

template <class Input>
constexpr auto pressure_on_end() {
  return Fields{RecordField<Input>{"shell", "cylindrical vessel: shell = \"=tank.shell\""},
                Field<Input, Stress>{&Input::p, "p", MPa, "internal gauge pressure on the end, liquid included"}
                    .load()
                    .at_least_that_of_source(pressure_below)
                    .positive()
                    .usually(0.01, 100)};
}

template <class Input>
constexpr auto strength_of_end() {
  return Fields{Field<Input, Stress>{&Input::sigma_adm, "sigma_adm", MPa, "allowable stress (safety factor included)"}
                    .positive()
                    .usually(10, 1000)
                    .customarily_at_most(400)
                    .may_be_missing(),
                Field<Input, Stress>{&Input::R_e, "R_e", MPa, "yield strength at the temperature in service"}
                    .positive()
                    .usually(50, 1100)
                    .customarily_at_most(960)
                    .from("material", "R_e", "delta"),
                Field<Input, Stress>{&Input::R_m, "R_m", MPa, "tensile strength"}.positive().usually(100, 1500).from(
                    "material", "R_m", "delta")};
}

}  // namespace loadpath::vessel
