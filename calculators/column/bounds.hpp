// Bounds on typed inputs of a compressed bar: the buckling curves that the code gives for its section, and the end
// conditions of a link of a mechanism.
#pragma once

#include "calculators/column/buckling_parts.hpp"
#include "calculators/column/member/length_factor.hpp"
#include "lib/calculator/bound.hpp"

#include <array>

namespace loadpath::column {

/// Whether the effective length about this axis is shorter than with pinned ends.
inline bool is_held_better(const Member& in, AxisName axis) {
  const double beta = axis == AxisName::y ? in.beta_y : in.beta_z;
  return (is_set(beta) ? beta : length_factor(ends_of(in, axis), Basis::exact)) < 1.0;
}
/// The ends of a link of a mechanism are pinned about the axis of its joints, so at most one axis can be restrained.
inline bool is_held_about_both(const Member& in) {
  return is_held_better(in, AxisName::y) && is_held_better(in, AxisName::z);
}

template <class Input>
double hinged_about_y(const Input& in) {
  const bool wanted = in.ends_y != Ends::unsaid && is_held_about_both(in);
  return wanted ? static_cast<double>(Ends::pinned_pinned) : unset<double>;
}
template <class Input>
double hinged_about_both(const Input& in) {
  const bool wanted = in.ends_y == Ends::unsaid && !is_set(in.beta_y) && is_held_about_both(in);
  return wanted ? static_cast<double>(Ends::pinned_pinned) : unset<double>;
}
template <class Input>
double whole_length(const Input& in) {
  return is_held_about_both(in) ? 1.0 : unset<double>;
}

/// The smallest effective length factor of a bar supported at its ends only.
template <class Input>
double least_length_factor(const Input&) {
  return length_factor(Ends::fixed_fixed, Basis::exact);
}

/// That of the ends, where both factors are typed next to them; a single one may be that of a brace in between.
template <class Input>
double factor_of_ends(const Input& in) {
  const bool are_replaced = in.ends != Ends::unsaid && is_set(in.beta_y) && is_set(in.beta_z);
  return are_replaced ? length_factor(in.ends, Basis::exact) : unset<double>;
}

/// Residual stresses end the proportional range below yield; books have 0.75 to 0.85 of it for steel.
template <class Input>
double most_proportional(const Input& in) {
  return 0.9 * in_si(in.R_e);
}

template <class Input>
constexpr auto held_bounds() {
  constexpr auto of_link = "a link of a mechanism with pin joints";
  constexpr auto of_ends = "a bar with both ends fixed";
  return std::array{Bound<Input>{"ends", of_link, &hinged_about_both<Input>}.where_source_has("length"),
                    Bound<Input>{"ends_y", of_link, &hinged_about_y<Input>}.where_source_has("length"),
                    Bound<Input>{"beta_y", of_link, &whole_length<Input>}.least().where_source_has("length"),
                    Bound<Input>{"beta_y", of_ends, &least_length_factor<Input>}.least().sparing_results(),
                    Bound<Input>{"beta_z", of_ends, &least_length_factor<Input>}.least().sparing_results(),
                    Bound<Input>{"beta_y", "the ends", &factor_of_ends<Input>}.least().sparing_results(),
                    Bound<Input>{"beta_z", "the ends", &factor_of_ends<Input>}.least().sparing_results(),
                    Bound<Input>{"sigma_P", "0.9 R_e", &most_proportional<Input>}};
}

/// The buckling curve of table 6.2. Where the kind of section is not given: that of a solid section if it is one,
/// otherwise the most favourable curve of any section.
template <class Input, AxisName axis>
double curve_of_table(const Input& in) {
  const Curve typed = axis == AxisName::y ? in.curve_y : in.curve_z;
  if (method_of(in) != Method::ec3 || typed == Curve::by_kind) return unset<double>;
  Plates plates = plates_of(in);
  if (plates.kind == SectionKind::unsaid) plates.kind = is_solid(in) ? SectionKind::solid : SectionKind::hot_hollow;
  const Curve own = buckling_curve(plates, axis);
  return own == Curve::by_kind ? unset<double> : static_cast<double>(own);
}

/// The curves are in order, the most favourable first.
template <class Input>
constexpr auto curve_bounds() {
  constexpr auto table = "EN 1993-1-1, table 6.2";
  return std::array{Bound<Input>{"curve_y", table, &curve_of_table<Input, AxisName::y>}.least(),
                    Bound<Input>{"curve_z", table, &curve_of_table<Input, AxisName::z>}.least()};
}

/// A safety factor against yielding in tension; in EC3 the partial factors of the code.
template <class Input>
double least_tension_safety(const Input& in) {
  constexpr double customary = 1.2;
  return method_of(in) == Method::ec3 ? unset<double> : customary;
}

template <class Input>
constexpr auto tension_bounds() {
  return std::array{Bound<Input>{"n_t", "common practice", &least_tension_safety<Input>}.least()};
}

}  // namespace loadpath::column
