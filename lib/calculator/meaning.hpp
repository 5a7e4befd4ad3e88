// What a value is beyond its dimension, where two of one dimension must not be taken for one another: a fatigue limit
// in bending is none in shear. Declared beside the fields that give it and those that take it; lib/project compares
// them.
#pragma once

namespace loadpath {

struct Meaning {
  const char* fields;       // of the input or the result: "sigma_D, S_req"
  const char* what;         // "a fatigue limit of a part in shear": equal texts are one meaning
  const char* choice = "";  // the input whose word decides; empty: it is always that
  const char* words = "";   // the words at which it is that: "bending, tension"
};

/// What an input says of the sense of a load: that a torque never changes it, how small it becomes. lib/project
/// compares it with the series that the load comes from, whole or reduced.
struct SenseClaim {
  const char* loads;         // "T", "seats.T", "T_1, P"
  const char* field;         // the choice that says it, or a number: the least value over the largest
  const char* words = "";    // of the choice: at which the load keeps one sense; empty: the field is a number
  const char* instead = "";  // the word for a load that changes it
};

}  // namespace loadpath
