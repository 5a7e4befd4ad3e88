// The teeth of a rating next to the steps that show where they run: the shaft that carries the pinion, and the
// planetary gear whose sun it is.
#pragma once

#include "lib/project/project.hpp"

#include <vector>

namespace loadpath::project {

/// Inputs of a rating that need a reason: a place of the pinion that is more favourable than on its shaft, and fewer
/// load cycles than the planets cause; bevel gears mounted between bearings that are overhung on their shafts.
std::vector<ReducedLoad> values_of_ratings(const Step& step, const Project& project);

/// Two strengths of one material, or two allowable stresses of one part, out of proportion: "sigma_adm = 900 MPa" next
/// to "tau_adm = 50 MPa". They need a reason.
std::vector<ReducedLoad> strengths_out_of_proportion(const Step& step, const Project& project);

}  // namespace loadpath::project
