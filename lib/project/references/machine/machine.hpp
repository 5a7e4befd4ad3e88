// Inputs that the other steps of the same machine contradict: factors, runs of drives, required lives, places of gears.
#pragma once

#include "lib/project/project.hpp"

namespace loadpath::project {

/// What the project states and no step takes, next to this step: loads, load cases, repetitions, limits.
std::vector<ReducedLoad> stated_and_not_taken(const Step& step, const Project& project);

/// What the other steps contradict, as far as they are solved.
std::vector<ReducedLoad> contradictions(const Step& step, const Project& project);

/// Adds those without a reason to the loads of the step that are not assessed; after check_reductions.
void check_machine(Step& step, const Project& project);

/// After all steps are solved: whether a step that was solved before another one has other contradictions now, so that
/// the project is to be solved again. The order of the tables in a file does not decide.
bool hand_out_contradictions(Project& project);

}  // namespace loadpath::project
