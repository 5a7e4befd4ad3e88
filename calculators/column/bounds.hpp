// What a compressed bar knows itself beside typed inputs: the buckling curves that the code has for its section, and
// how its ends are held as a link of a mechanism.
#pragma once

#include "calculators/column/buckling_parts.hpp"
#include "calculators/column/member/length_factor.hpp"
#include "lib/calculator/bound.hpp"

#include <array>

namespace loadpath::column {

/// Shorter than that of hinged ends about this axis.
inline bool is_held_better(const Member& in, AxisName axis) {
  const double beta = axis == AxisName::y ? in.beta_y : in.beta_z;
  return (is_set(beta) ? beta : length_factor(ends_of(in, axis), Basis::exact)) < 1.0;
}
/// Of a link of a mechanism one axis is in the plane of the joints, on which it turns: its ends are hinged about that.
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

/// The least factor of a bar that is held at its ends alone.
template <class Input>
double least_length_factor(const Input&) {
  return length_factor(Ends::fixed_fixed, Basis::exact);
}

template <class Input>
constexpr auto held_bounds() {
  constexpr auto of_link = "a link of a mechanism, which turns on its joints";
  constexpr auto of_ends = "a bar that is built in at both ends";
  return std::array{Bound<Input>{"ends", of_link, &hinged_about_both<Input>}.where_source_has("length"),
                    Bound<Input>{"ends_y", of_link, &hinged_about_y<Input>}.where_source_has("length"),
                    Bound<Input>{"beta_y", of_link, &whole_length<Input>}.least().where_source_has("length"),
                    Bound<Input>{"beta_y", of_ends, &least_length_factor<Input>}.least().sparing_results(),
                    Bound<Input>{"beta_z", of_ends, &least_length_factor<Input>}.least().sparing_results()};
}

/// Table 6.2 for a typed curve: of a section whose kind is not said that of a solid bar where it is one, else the best
/// that any section has.
template <class Input, AxisName axis>
double curve_of_table(const Input& in) {
  const Curve typed = axis == AxisName::y ? in.curve_y : in.curve_z;
  if (in.method != Method::ec3 || typed == Curve::by_kind) return unset<double>;
  Plates plates = plates_of(in);
  if (plates.kind == Profile::unsaid) plates.kind = is_solid(in) ? Profile::solid : Profile::hot_hollow;
  const Curve own = buckling_curve(plates, axis);
  return own == Curve::by_kind ? unset<double> : static_cast<double>(own);
}

/// The curves stand in their order, the best one first.
template <class Input>
constexpr auto curve_bounds() {
  constexpr auto table = "EN 1993-1-1, table 6.2";
  return std::array{Bound<Input>{"curve_y", table, &curve_of_table<Input, AxisName::y>}.least(),
                    Bound<Input>{"curve_z", table, &curve_of_table<Input, AxisName::z>}.least()};
}

}  // namespace loadpath::column
