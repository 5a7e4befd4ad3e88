// The rules of a compressed bar but for its section, and what they say of an input that breaks them.
#pragma once

#include "calculators/column/member/member.hpp"
#include "calculators/column/member/section.hpp"
#include "lib/text/issue.hpp"

#include <array>

namespace loadpath::column {

bool supports_inside(const Member& in);
FieldFault support_outside(const Member& in);
bool supports_need_ends(const Member& in);
bool set_meets_euler(const Member& in);
bool set_near_euler(const Member& in);
FieldFault gap_of_set(const Member& in);
bool set_fits_modulus(const Member& in);
bool set_is_of_material(const Member& in);
FieldFault modulus_of_set(const Member& in);
bool usual_safety(const Member& in);
FieldFault unusual_safety(const Member& in);
/// EN 1993-1-1, AISC 360 and SP 16 apply only to steel.
bool method_suits_class(const Member& in);
/// S460 has 400 MPa in plates of 100 mm, EN 10025-3 (recalled).
inline bool yields_as_graded(const Member& in) { return in.grade != Grade::S460 || !(in.R_e < 400.0 * MPa); }
FieldFault method_of_steel(const Member& in);

/// Missing inputs of the governing method; empty if none. `curves`: whether the buckling curves are known.
Message missing_inputs(const Member& in, Method by, bool curves);
FieldFault missing_for_method(const Member& in, Method by, bool curves);

/// Whether the partial factors of a compressed bar are given, or need not be: of ec3 they are assumed.
bool factors_given(const Member& in, Method by);
/// Whether a typed n_st has an effect, or a method is named.
bool safety_counts(const Member& in, Method by);
FieldFault assumed_factors(const Member& in);

/// A function of the bar as one of an input that derives from it.
template <class Input, auto of_member>
auto of(const Input& in) {
  return of_member(in);
}

/// Load, length and ends.
template <class Input>
constexpr auto held_rules() {
  return std::array{
      Rule<Input>{[](const Input& in) { return !(is_set(in.N) && is_set(in.P)); }, "N, P",
                  "give the force as N, positive in tension, or as P, positive in compression, not both"},
      Rule<Input>{[](const Input& in) { return is_set(in.E) || !(is_set(in.N) || is_set(in.P)); }, "E, N, P",
                  "give a material, or the modulus E"},
      Rule<Input>{[](const Input& in) {
                    const bool y = is_set(in.beta_y) || in.ends_y != Ends::unsaid || in.ends != Ends::unsaid;
                    const bool z = is_set(in.beta_z) || in.ends_z != Ends::unsaid || in.ends != Ends::unsaid;
                    return y && z;
                  },
                  "ends, ends_y, ends_z, beta_y, beta_z",
                  "give the end conditions ends, or ends_y and ends_z, or beta_y, beta_z"},
      Rule<Input>{[](const Input& in) {
                    return !(is_set(in.beta_y) && in.ends_y != Ends::unsaid) &&
                           !(is_set(in.beta_z) && in.ends_z != Ends::unsaid);
                  },
                  "ends_y, ends_z, beta_y, beta_z", "give the ends of an axis or its factor beta, not both"},
      Rule<Input>{&of<Input, &supports_inside>, "supports_y, supports_z, l",
                  "supports must lie between the ends, in order along the bar", &of<Input, &support_outside>},
      Rule<Input>{&of<Input, &supports_need_ends>, "supports_y, supports_z, beta_y, beta_z, beta_basis",
                  "the effective length with supports is computed exactly from the ends: omit beta of that axis and "
                  "use beta_basis = \"exact\""}};
}

/// Material and method, but for what the method needs (`missing_inputs`).
template <class Input>
constexpr auto method_rules() {
  return std::array{
      Rule<Input>{&of<Input, &method_suits_class>, "method, material_class, E", "the method covers steel only",
                  &of<Input, &method_of_steel>},
      Rule<Input>{&of<Input, &yields_as_graded>, "grade, R_e",
                  "grade S460 has a yield strength of at least 400 MPa; omit grade for another steel"},
      Rule<Input>{[](const Input& in) { return is_set(in.a_T) == is_set(in.b_T); }, "a_T, b_T",
                  "a_T and b_T must be given together"},
      Rule<Input>{[](const Input& in) { return in.transition == Transition::computed || is_set(in.lambda_1); },
                  "transition, lambda_1", "give lambda_1 of the set, the published transition"},
      Rule<Input>{[](const Input& in) { return !is_set(in.sigma_P) || !is_set(in.R_e) || in.sigma_P <= in.R_e; },
                  "sigma_P, R_e", "the proportional limit must not exceed the yield strength"},
      Rule<Input>{&of<Input, &set_meets_euler>, "a_T, b_T, c_T, E, transition",
                  "with this modulus the Tetmajer line must intersect Euler's hyperbola"},
      Rule<Input>{&of<Input, &set_near_euler>, "a_T, b_T, c_T, E, lambda_1",
                  "the Tetmajer line must meet Euler's hyperbola at its lambda_1", &of<Input, &gap_of_set>, true},
      Rule<Input>{&of<Input, &set_is_of_material>, "E_T, E", "this Tetmajer set belongs to another material",
                  &of<Input, &modulus_of_set>},
      Rule<Input>{&of<Input, &set_fits_modulus>, "E_T, E", "this Tetmajer set belongs to another modulus of elasticity",
                  &of<Input, &modulus_of_set>, true},
      Rule<Input>{&of<Input, &usual_safety>, "n_st, material_class", "the safety factor is unusual",
                  &of<Input, &unusual_safety>, true}};
}

/// What is assumed, or has no effect, by the method that decides.
template <class Input, auto method_of>
constexpr auto assumption_rules() {
  return std::array{
      Rule<Input>{[](const Input& in) { return factors_given(in, method_of(in)); }, "method, gamma_M1, gamma_F",
                  "partial factors are assumed", &of<Input, &assumed_factors>, true, "buckling, bent, tension"},
      Rule<Input>{[](const Input& in) { return safety_counts(in, method_of(in)); }, "n_st, method",
                  "EN 1993-1-1 takes gamma_M1 and gamma_F and no n_st: omit n_st, or name the method that takes it, "
                  "e.g. \"johnson\""}};
}

/// Rules of a bar with eccentricities or bows.
template <class Input>
constexpr auto eccentricity_rules() {
  return std::array{Rule<Input>{[](const Input& in) { return !(is_offset_about_y(in) && is_offset_about_z(in)); },
                                "e_y, e_z, e_0y, e_0z",
                                "the secant formula covers an eccentricity or a bow about one axis only"}};
}

/// Whether sizes, area and second moments are of one section.
bool is_one_section(const Section& in);
FieldFault two_sections(const Section& in);

/// Whether the kind is that of a bar with only its outline given.
bool is_solid_if_full(const Section& in);
/// Whether the walls of a section without its area are those of a tube or a rectangular hollow section.
bool walls_fit(const Section& in);
FieldFault unfit_walls(const Section& in);
/// Whether the extreme fibre is farther from the axis than the radius of gyration.
bool fibres_reach(const Section& in);
bool is_least_moment(const Section& in);

/// Rules of a bar with a typed section, or a row of the tables.
template <class Input, auto given, auto missing, auto fit>
constexpr auto section_rules() {
  return std::array{
      Rule<Input>{&of<Input, given>, "A, I_y, i_y, I_z, i_z, d, d_bore, h, b, t_w",
                  "give section = \"IPE 200\", or d, or h and b, or A with I_y and I_z", &of<Input, missing>},
      Rule<Input>{&of<Input, fit>, "A, I_y, I_z, i_y, i_z",
                  "I and i of an axis must satisfy I = A i^2; give one of them"},
      Rule<Input>{&of<Input, &is_one_section>, "A, I_y, I_z, i_y, i_z, I_min, I_t, I_w, h, b, d, t_f, t_w, kind",
                  "sizes, area and second moments of area must belong to the same section", &of<Input, &two_sections>},
      Rule<Input>{[](const Input& in) { return !is_set(in.d_bore) || (is_set(in.d) && in.d_bore < in.d); }, "d_bore, d",
                  "the bore d_bore must be smaller than d; give both"},
      Rule<Input>{
          &of<Input, &is_solid_if_full>, "kind, d, h, b, A, d_bore, t_w",
          "a bar given by d, or by h and b, is solid, with d_bore or t_w a hollow section: omit kind, or give A, "
          "I and the wall thicknesses"},
      Rule<Input>{&of<Input, &walls_fit>, "t_w, t_f, d_bore, r, d, h, b, A", "the walls do not fit the section",
                  &of<Input, &unfit_walls>},
      Rule<Input>{&of<Input, &fibres_reach>, "c_y, c_z, A, I_y, I_z, i_y, i_z",
                  "the distance to the extreme fibre must exceed the radius of gyration"},
      Rule<Input>{&of<Input, &is_least_moment>, "I_min, I_y, I_z", "I_min cannot exceed I_y or I_z"}};
}

}  // namespace loadpath::column
