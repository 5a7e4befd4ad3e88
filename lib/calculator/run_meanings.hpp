// Meanings of the inputs of a run of a drive, and of the flywheels that run with it; lib/project compares them with the
// other steps of the project.
#pragma once

namespace loadpath {

inline constexpr auto speed_of_run = "a speed of a run";
inline constexpr auto moment_of_motor = "a moment of a motor";
inline constexpr auto inertia_of_flywheel = "an inertia of a flywheel";

}  // namespace loadpath
