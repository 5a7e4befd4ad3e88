// A typed value next to a row of a table or a record that fills its field too. One rule for all fields: equal to the
// digits typed is equal; what says which part it is may not differ; what the part bears may be lower, what it has to
// bear may be higher, and the other way wants a reason (lib/project/because.hpp).
#pragma once

#include "lib/calculator/record.hpp"

#include <string_view>

namespace loadpath::project {

/// What a field is about, which its declaration tells.
enum class Beside {
  identity,  // geometry, kind, numbers: of one part only
  modulus,   // the same, as far as books agree on it
  capacity,  // strengths and ratings: stress, force, moment, power
  demand,    // loads, lengths of which the largest is sought, factors of safety and service
  either,    // speeds, and sizes of the bar that a factor was calculated for: higher and lower may be unsafe
  usual      // empirical values: within a range that experience gives
};
Beside beside_of(const FieldInfo& field);
/// By the dimension alone: what bears or loads a part is a capacity.
Beside beside_of_dimension(const Dimension& dimension);
/// Whether a different value is another part.
constexpr bool is_of_one_part(Beside beside) { return beside == Beside::identity || beside == Beside::modulus; }

/// Whether a field has an empirical range: friction, notch sensitivities, strengths. Not the engineer's choices: sizes,
/// loads, speeds, safety and application factors.
bool is_empirical(const FieldInfo& field);

/// Half a unit of the last digit of a literal over its number, or of a lone literal behind '='; of another text nothing
/// but rounding. Never more than 1 %, for "1e2 mm" is no 140 mm.
double relative_rounding(std::string_view typed);

/// Whether the typed value is the other one, as far as its digits tell.
bool is_equal(Beside beside, double typed, double other, double rounding);
/// Whether it is on the side that wants a reason: more than the part has, or less than it has to bear.
bool is_bolder(Beside beside, double typed, double other);

}  // namespace loadpath::project
