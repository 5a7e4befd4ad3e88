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

/// Rotating bending: a stress or moment that reverses with each revolution. Used as a mean stress, or as one end of a
/// cycle that is not symmetric, it is not fully included.
inline constexpr auto reverses_in_turns = "reverses in turns";
inline constexpr auto steady_part = "stays";

/// Amplitude and midrange of a cycle, valid only together.
inline constexpr auto paired_amplitude = "amplitude with its mean value";
inline constexpr auto paired_middle = "mean value with its amplitude";

/// The notch factor that belongs to a nominal stress or to a fatigue limit. A fatigue limit must include the notch at
/// which the stress acts.
struct NotchClaim {
  const char* fields;      // "cycle.sigma_max, sigma_n", or the limit "sigma_D"
  const char* factor;      // of a stress the shape factor K_t at least; of a limit the notch factor K_f
  const char* shape = "";  // of a limit: the shape factor that K_f follows from, where it is given
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
