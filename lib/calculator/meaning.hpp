// The meaning of a value beyond its dimension, where quantities of one dimension must not be confused: a fatigue
// limit in bending does not apply in shear. Declared next to the fields that give it and those that take it;
// lib/project compares them.
#pragma once

namespace loadpath {

struct Meaning {
  const char* fields;       // keys of the input or the result: "sigma_D, S_req"
  const char* what;         // "a fatigue limit of a part in shear": equal texts are one meaning
  const char* choice = "";  // the choice that decides; empty: the meaning is fixed
  const char* words = "";   // the words at which it is that: "bending, tension"
};

/// Rotating bending: a stress or moment that reverses with each revolution. Used as a mean stress, or as one end of a
/// cycle that is not symmetric, it is not fully included.
inline constexpr auto reverses_in_turns = "reverses in turns";
inline constexpr auto steady_part = "stays";

/// Amplitude and midrange of a cycle, valid only together.
inline constexpr auto paired_amplitude = "amplitude with its mean";
inline constexpr auto paired_middle = "mean with its amplitude";

/// A ratio of the speeds of two shafts: computed from a ratio, it is that or its reciprocal.
inline constexpr auto ratio_of_speeds = "a ratio of speeds";

/// Inputs of a run of a drive, and of the flywheels that run with it.
inline constexpr auto speed_of_run = "a speed of a run";
inline constexpr auto moment_of_motor = "a moment of a motor";
inline constexpr auto inertia_of_flywheel = "an inertia of a flywheel";

/// The notch factor that belongs to a nominal stress or to a fatigue limit. A fatigue limit must include the notch at
/// which the stress acts.
struct NotchClaim {
  const char* fields;      // "cycle.sigma_max, sigma_n", or the limit "sigma_D"
  const char* factor;      // stress concentration factor K_t of a stress, at least; fatigue notch factor K_f of a limit
  const char* shape = "";  // for a limit: the stress concentration factor that K_f follows from, where given
};

/// A claim of an input about the direction of a load: that a torque never reverses, however small it becomes.
/// lib/project compares it with the series that the load comes from, in full or reduced.
struct SenseClaim {
  const char* loads;         // "T", "seats.T", "T_1, P"
  const char* field;         // the choice that decides, or a number: minimum over maximum value
  const char* words = "";    // words of the choice for one-way loads; empty: the field is a number
  const char* instead = "";  // the word for a load that changes it
};

}  // namespace loadpath
