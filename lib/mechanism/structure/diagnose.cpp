#include "lib/mechanism/forces/induced_source.hpp"
#include "lib/mechanism/structure/release.hpp"
#include "lib/mechanism/structure/structure.hpp"
#include "lib/quantity/format.hpp"

#include <numeric>
#include <string>
#include <utility>

namespace loadpath::mechanism {
namespace {

std::vector<std::size_t> all(std::size_t count) {
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

Finding not_closing(const Model& model, const Structure& structure) {
  return {Finding::About::joint, structure.open_joint,
          say("joint '{1}' does not close: a gap of {2} remains", model.joints[structure.open_joint].name,
              format_quantity(structure.gap, "mm", 4)),
          say("the given angles are too far from an assembly position, or the lengths do not permit one")};
}

/// Whether a joint imposes a ratio of speeds.
bool has_ratio(JointKind kind) {
  switch (kind) {
    case JointKind::gear:
    case JointKind::rack:
    case JointKind::belt:
    case JointKind::rolling:
    case JointKind::rolling_on_line:
      return true;
    case JointKind::revolute:
    case JointKind::prismatic:
    case JointKind::slot:
    case JointKind::rigid:
    case JointKind::cam:
    case JointKind::none:
      break;
  }
  return false;
}

/// Gears, racks, belts and rolling wheels without one of which the mechanism would move.
std::vector<std::size_t> locking_wheels(const Model& model) {
  std::vector<std::size_t> locking;
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    if (!has_ratio(model.joints[k].kind)) continue;
    Model without = model;
    without.joints.erase(without.joints.begin() + static_cast<std::ptrdiff_t>(k));
    without.drivers.clear();
    if (check_parts(without).empty() && analyse(without).mobility > 0) locking.push_back(k);
  }
  return locking;
}

Finding wrong_number_of_drivers(const Model& model, const Structure& structure) {
  const auto drivers = static_cast<int>(model.drivers.size());
  Message message =
      say("mobility {1}, number of drives {2}", std::to_string(structure.mobility), std::to_string(drivers));
  Message hint = structure.mobility > drivers
                     ? say("add a drive or a joint: {1} can still move", names_of(model.links, structure.loose))
                     : say("remove a drive: {1}", names_of(model.drivers, all(model.drivers.size())));
  const auto locking = structure.mobility == 0 ? locking_wheels(model) : std::vector<std::size_t>{};
  if (locking.size() > 1) {
    hint = say("the mechanism is locked: the ratios of {1} contradict each other; correct their radii, or remove one",
               names_of(model.joints, locking));
  }
  return {Finding::About::model, 0, std::move(message), std::move(hint)};
}

/// The pin about which a link spins that is nothing but the roller of a cam; nullptr if it is more than that.
const Joint* pin_of_roller(const Model& model, std::size_t k) {
  const int link = static_cast<int>(k);
  const Joint *pin = nullptr, *cam = nullptr;
  for (const Joint& joint : model.joints) {
    if (joint.i != link && joint.j != link) continue;
    const bool rolls = joint.kind == JointKind::cam && joint.contact == CamContact::round && joint.i == link;
    if ((rolls && cam != nullptr) || (!rolls && (joint.kind != JointKind::revolute || pin != nullptr))) return nullptr;
    (rolls ? cam : pin) = &joint;
  }
  if (pin == nullptr || cam == nullptr) return nullptr;
  const Vec own = pin->i == link ? pin->point_i : pin->point_j;
  return length(own - cam->point_i) == 0.0 ? pin : nullptr;
}

/// Rollers that are links of their own: each has a freedom that no drive has to hold.
std::vector<Finding> spinning_rollers(const Model& model, const Structure& structure) {
  std::vector<Finding> findings;
  for (const std::size_t k : structure.loose) {
    const Joint* pin = pin_of_roller(model, k);
    if (pin == nullptr) continue;
    findings.push_back(
        {Finding::About::link, k,
         say("the roller '{1}' spins about '{2}' whatever the drive does: a passive freedom", model.links[k].name,
             pin->name),
         say("leave the link out: give the cam's joint the link that carries the roller, the pin as its point, and the "
             "radius")});
  }
  return findings;
}

Finding singular(const Model& model, const Structure& structure) {
  return {Finding::About::model, 0,
          say("the stated position is singular: {1} can move in more than one direction",
              names_of(model.links, structure.loose)),
          say("state the assembly slightly away from this position, so that the direction of motion is determined")};
}

Finding redundant(const Model& model, const SharedFreedoms& shared) {
  return {Finding::About::joint, shared.joints.front(),
          say("{1}: their reactions are not unique", too_many(model, shared.joints, shared.freedoms)),
          say("replace one of them with a joint with more freedom, or remove a link that only repeats what others do")};
}

Finding rubs_without_knowing(const Model& model, std::size_t joint) {
  return {Finding::About::joint, joint,
          say("friction, tooth or belt forces of joint '{1}' depend on its reaction, which is not unique: other joints "
              "constrain the same freedom",
              model.joints[joint].name),
          say("leave out its friction and pressure angle, or the joints that repeat it")};
}

/// Reasons why a mechanism with redundant constraints cannot be solved.
std::vector<Finding> about_redundancy(const Model& model, const Structure& structure) {
  std::vector<Finding> findings;
  if (!can_release(model)) {
    for (const SharedFreedoms& shared : shared_freedoms(structure)) findings.push_back(redundant(model, shared));
    return findings;
  }
  const auto unique = uniqueness(model);
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const bool known = unique[k].force && unique[k].couple;
    if (!known && modes_of(model.joints[k]) > 0) findings.push_back(rubs_without_knowing(model, k));
  }
  return findings;
}

Finding without_effect(const Model& model, const Structure& structure) {
  return {Finding::About::driver, 0,
          say("the drivers {1} do not hold {2} at the stated position",
              names_of(model.drivers, all(model.drivers.size())), names_of(model.links, structure.loose)),
          say("this is a dead point of the drive, or two drivers act on the same freedom")};
}

Finding not_fitting(const Model& model, const CentreDistanceError& misfit) {
  const Joint& joint = model.joints[misfit.joint];
  const std::string apart = format_quantity(misfit.apart, "mm", 4), needed = format_quantity(misfit.needed, "mm", 4);
  if (joint.kind == JointKind::rack) {
    return {Finding::About::joint, misfit.joint,
            say("the centre of the wheel of '{1}' is {2} from the line of its rack, and its radius is {3}", joint.name,
                apart, needed),
            say("move the rack's point or the centre, or change the radius")};
  }
  Message message =
      joint.kind == JointKind::belt
          ? say("the wheels of the belt '{1}' overlap: the centre distance is {2} and must be more than {3}",
                joint.name, apart, needed)
          : say("the centre distance of '{1}' is {2}, but the radii require {3}", joint.name, apart, needed);
  return {Finding::About::joint, misfit.joint, std::move(message), say("move a centre, or change a radius")};
}

Finding parting(const Model& model, std::size_t index) {
  const Joint& joint = model.joints[index];
  if (joint.kind == JointKind::belt) {
    return {Finding::About::joint, index,
            say("the belt '{1}' keeps its length, and the distance of its centres changes as the mechanism moves",
                joint.name),
            say("keep both centres on one link; a tensioner is a wheel on a link of its own with a second belt")};
  }
  return {Finding::About::joint, index,
          say("the teeth of '{1}' do not stay in mesh: the distance of its centres changes as the mechanism moves",
              joint.name),
          say("fix the distance by other joints: both centres on one link, or a slide along the rack")};
}

std::vector<Finding> about_mobility(const Model& model, const Structure& structure) {
  std::vector<Finding> findings;
  if (!structure.closes) {
    for (const std::size_t joint : structure.parting) findings.push_back(parting(model, joint));
    return findings.empty() ? std::vector<Finding>{not_closing(model, structure)} : findings;
  }
  for (const CentreDistanceError& misfit : structure.misfits) findings.push_back(not_fitting(model, misfit));
  if (!findings.empty()) return findings;
  if (structure.singular) return {singular(model, structure)};
  if (!structure.redundant.empty()) findings = about_redundancy(model, structure);
  const bool sound = findings.empty();
  for (Finding& finding : spinning_rollers(model, structure)) findings.push_back(std::move(finding));
  if (sound && !findings.empty()) return findings;
  if (structure.mobility != static_cast<int>(model.drivers.size())) {
    findings.push_back(wrong_number_of_drivers(model, structure));
  } else if (!structure.loose.empty()) {
    findings.push_back(without_effect(model, structure));
  } else {
    for (const std::size_t joint : structure.parting) findings.push_back(parting(model, joint));
  }
  return findings;
}

}  // namespace

std::vector<SharedFreedoms> shared_freedoms(const Structure& structure) {
  std::vector<SharedFreedoms> all;
  for (const auto& joints : structure.redundant) {  // in order: equal ones are neighbours
    if (all.empty() || all.back().joints != joints) all.push_back({joints, 0});
    ++all.back().freedoms;
  }
  return all;
}

Message too_many(const Model& model, const std::vector<std::size_t>& joints, std::size_t freedoms) {
  return freedoms == 1
             ? say("the joints {1} together constrain one degree of freedom too many", names_of(model.joints, joints))
             : say("the joints {1} together constrain {2} degrees of freedom too many", names_of(model.joints, joints),
                   std::to_string(freedoms));
}

std::vector<Finding> diagnose(const Model& model, Structure& structure) {
  std::vector<Finding> findings = check_parts(model);
  if (!findings.empty()) return findings;
  structure = analyse(model);
  return about_mobility(model, structure);
}

std::vector<Finding> diagnose(const Model& model) {
  Structure structure;
  return diagnose(model, structure);
}

}  // namespace loadpath::mechanism
