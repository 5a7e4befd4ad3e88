// Constraints between strengths of one material, and inputs of a safety factor, common to calculators.
#pragma once

#include "lib/calculator/field.hpp"

namespace loadpath {

template <class Input>
constexpr Rule<Input> yields_before_it_breaks() {
  return {[](const Input& in) { return !(in.R_e > in.R_m); }, "R_e, R_m",
          "the yield strength R_e must not exceed the tensile strength R_m"};
}

/// `limit`: the member that is a fatigue limit; `fields`: its key and that of the tensile strength.
template <auto limit, class Input>
constexpr Rule<Input> lasts_below_tensile(const char* fields) {
  return {[](const Input& in) { return !(in.*limit >= in.R_m); }, fields,
          "fatigue limit must be below the tensile strength R_m"};
}

template <class Input>
constexpr Rule<Input> safety_has_its_yield() {
  return {[](const Input& in) { return !is_set(in.S_F) || is_set(in.R_e); }, "S_F, R_e",
          "the safety factor S_F needs the yield strength R_e, or a material"};
}

}  // namespace loadpath
