// A typed value next to a row of a table or a record that fills its field too. One rule for all fields: equal to the
// digits typed is equal; identifying data of the part must not differ; a lower capacity or a higher load is
// conservative; the opposite needs a reason (lib/project/because.hpp).
#pragma once

#include "lib/calculator/record.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace loadpath::project {

/// The role of a field, which its declaration gives.
enum class FieldRole {
  identity,  // geometry, kind, numbers: of one part only
  modulus,   // the same, as far as books agree on it
  capacity,  // strengths and ratings: stress, force, moment, power
  demand,    // loads, lengths of which the largest is sought, factors of safety and service
  either,    // speeds, and sizes of the bar that a factor was calculated for: higher and lower may be unsafe
  usual      // empirical values: within a range that experience gives
};
FieldRole role_of_field(const FieldInfo& field);
/// The role by dimension only: capacities and loads count as capacities.
FieldRole role_of_dimension(const Dimension& dimension);
/// Whether a different value is another part.
constexpr bool is_of_one_part(FieldRole role) { return role == FieldRole::identity || role == FieldRole::modulus; }

/// The names under which a field is a fact of a body that several steps describe: its own, or the column of the
/// material that it is; empty if it is none.
std::string facts_of(const FieldInfo& field);
/// The role of such a field next to that of another step.
FieldRole role_in_body(const FieldInfo& field);

/// Whether a field has an empirical range: friction, notch sensitivities, strengths. Not the engineer's choices: sizes,
/// loads, speeds, safety and application factors.
bool is_empirical(const FieldInfo& field);

/// A bound of the calculator that a typed value keeps: at another point of a sweep the bound may have another value.
struct KeptBound {
  std::size_t bound, element;  // the index in the calculator, and the element of a list
  FieldRole kind;
  double typed, rounding;
  double value;  // of the bound, where the step was solved
};

/// Half a unit of the last digit of a literal relative to its number, or of a bare literal after '='; for any other
/// text the rounding error. At most 1 %, because "1e2 mm" does not equal 140 mm.
double relative_rounding(std::string_view typed);

/// Whether the typed value equals the other one, to the digits typed.
bool is_equal(FieldRole role, double typed, double other, double rounding);
/// Whether it is on the side that needs a reason: a higher capacity, or a lower load.
bool is_bolder(FieldRole role, double typed, double other);
/// Whether the typed value keeps this value of its bound; NaN: there is none.
bool keeps(const KeptBound& bound, double value);

}  // namespace loadpath::project
