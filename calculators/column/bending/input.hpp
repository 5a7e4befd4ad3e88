// Inputs of a bar with bending.
#pragma once

#include "calculators/column/bending/critical_moment.hpp"
#include "calculators/column/buckling_input.hpp"

#include <array>

namespace loadpath::column {

/// Reduction factor of lateral-torsional buckling by EN 1993-1-1.
enum class TwistCurves { general, rolled };

constexpr auto choices_of(TwistCurves) {
  using T = TwistCurves;
  return std::array{ChoiceName<T>{T::general, "general", "6.3.2.2, any section"},
                    ChoiceName<T>{T::rolled, "rolled", "6.3.2.3, rolled or equivalent welded I, without the factor f"}};
}

/// What the given moments include of the bending of the deflected bar between its ends.
enum class Analysis { first_order, second_order };

constexpr auto choices_of(Analysis) {
  using A = Analysis;
  return std::array{
      ChoiceName<A>{A::first_order, "first_order", "moments of the undeflected bar (aisc: B_1 is applied)"},
      ChoiceName<A>{A::second_order, "second_order",
                    "moments of the deflected bar (aisc: without B_1; ec3: no difference)"}};
}

/// Inputs of a bar with bending.
struct BeamColumnInput : BucklingInput {
  Moment M_y = unset<Moment>, M_y_1 = unset<Moment>, M_y_2 = unset<Moment>;
  Stiffness q_z = unset<Stiffness>;
  Force F_z = unset<Force>;
  Moment M_z = unset<Moment>, M_z_1 = unset<Moment>, M_z_2 = unset<Moment>;
  Stiffness q_y = unset<Stiffness>;
  Force F_y = unset<Force>;
  Length z_g = unset<Length>, l_LT = unset<Length>;
  double C_1_set = unset<double>;
  SectionModulus W_pl_y = unset<SectionModulus>, W_pl_z = unset<SectionModulus>;
  TwistCurves twist_curves = TwistCurves::general;
  Analysis analysis = Analysis::first_order;
  double gamma_M0 = 1.0, Omega_b = 1.67;
};

}  // namespace loadpath::column
