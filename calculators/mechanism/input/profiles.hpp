// Cam profiles from the words of a project to those of the solver.
#pragma once

#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/account/block.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/text/issue.hpp"

#include <memory>
#include <vector>

namespace loadpath::planar {

/// The profile that a joint names; nullptr where there is none of that name.
const CamProfile* find_profile(const Mechanism::Input& in, const Name& name);

/// Rise of a segment, m or rad.
double rise_of(const CamProfile& profile, const CamProfile::Segment& segment);

bool is_cam(planar::Type type);

/// Fields that the shape of a profile needs and has not, or has and does not take. Needs no values.
std::vector<FieldFault> check_fields(const CamProfile& profile);
/// Lengths and angles that make no profile. Needs values.
std::vector<FieldFault> check_values(const CamProfile& profile);
/// The same of all of them; also a profile that a flat face, or a roller of its radius, cannot touch all round.
std::vector<FieldFault> check_profiles(const Mechanism::Input& in);

std::shared_ptr<const mechanism::Profile> profile_of(const CamProfile& profile);

/// The radius of the roller of a cam joint, m; 0 of an edge.
double roller_radius(const Mechanism::Input& in, const planar::Joint& joint);

/// The angle of the cam at which it touches a straight guide at this parameter of its profile, for laws of lift; else
/// where the point of the profile lies as seen from the axis. rad, 0 to 2 pi.
double cam_angle(const mechanism::Profile& profile, double parameter);

/// Dimensions and segments of the profiles.
std::vector<account::Table> profile_tables(const Mechanism::Input& in);

}  // namespace loadpath::planar
