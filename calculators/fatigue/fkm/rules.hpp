// Constraints between inputs of FKM, for every calculator that rates sections by it.
#pragma once

#include "calculators/fatigue/din743/rules.hpp"
#include "calculators/fatigue/fkm/material.hpp"
#include "lib/calculator/fields.hpp"

namespace loadpath::fatigue {

inline bool knows_size(const FkmSteel& s) {
  const FkmSize size = fkm_size(s);
  return is_set(size.a_m) && is_set(size.d_m) && is_set(size.a_p) && is_set(size.d_p);
}

template <class Input>
constexpr auto fkm_steel_rules() {
  return std::array{
      Rule<Input>{[](const Input& in) { return in.steel != FkmSteelGroup::untold; }, "steel",
                  "steel group missing: fatigue limit, support and size factors depend on it"},
      Rule<Input>{[](const Input& in) { return is_set(in.R_mN) != is_set(in.R_m); }, "R_mN, R_m",
                  "give the tensile strength: R_mN of the standard, or R_m in this size (or a material), not both"},
      Rule<Input>{
          [](const Input& in) { return is_set(in.R_mN) == is_set(in.R_eN) && is_set(in.R_m) == is_set(in.R_e); },
          "R_eN, R_e, R_mN, R_m", "give R_mN with R_eN, or R_m with R_e"},
      Rule<Input>{
          [](const Input& in) { return !is_set(in.R_mN) || in.steel == FkmSteelGroup::untold || knows_size(in); },
          "a_dm, d_Nm, a_dp, d_Np, steel, R_mN",
          "the constants of the size factors of this steel are unknown: give a_dm, d_Nm, a_dp and d_Np, or R_m and R_e "
          "in this size"},
      Rule<Input>{[](const Input& in) {
                    return is_set(in.R_mN) ||
                           !(is_set(in.a_dm) || is_set(in.a_dp) || is_set(in.d_Nm) || is_set(in.d_Np));
                  },
                  "a_dm, a_dp, d_Nm, d_Np, R_m",
                  "the constants of the size factors belong to R_mN; omit them with R_m of this size"},
      Rule<Input>{[](const Input& in) { return !(in.R_eN > in.R_mN || in.R_e > in.R_m); }, "R_eN, R_e, R_mN, R_m",
                  "the yield strength must not exceed the tensile strength"},
      Rule<Input>{[](const Input& in) { return !is_set(in.K_an) || in.fibre == Fibre::along; }, "K_an, fibre",
                  "give the anisotropy as K_an or by fibre, not both"},
      Rule<Input>{[](const Input& in) {
                    const Stress most = is_set(in.R_mN) ? in.R_mN : in.R_m;
                    return !(in.sigma_W >= most || in.tau_W >= most);
                  },
                  "sigma_W, tau_W", "fatigue limit must be below the tensile strength R_m"},
      Rule<Input>{[](const Input& in) {
                    return in.notch == Notch::alpha || !(is_set(in.G_zd) || is_set(in.G_b) || is_set(in.G_t));
                  },
                  "G_zd, G_b, G_t, notch",
                  "gradients belong to given stress concentration factors: notch = \"alpha\""}};
}

template <class Input>
constexpr auto fkm_rules() {
  return join(fkm_steel_rules<Input>(), din743_section_rules<Input>(), din743_load_rules<Input>());
}

}  // namespace loadpath::fatigue
