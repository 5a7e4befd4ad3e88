#include "calculators/mechanism/completion/masses.hpp"

#include "calculators/mechanism/input/names.hpp"
#include "calculators/mechanism/input/points.hpp"
#include "calculators/mechanism/input/profiles.hpp"

#include <algorithm>
#include <optional>

namespace loadpath::planar {

namespace {

using Typed = std::function<bool(const std::string&)>;

/// A link with wheels is not a bar.
bool carries_wheel(const Mechanism::Input& in, const Name& link) {
  return std::any_of(in.joints.begin(), in.joints.end(), [&](const planar::Joint& joint) {
    const bool own = joint.links.first == link || joint.links.second == link;
    return own && (is_set(joint.radii.first) || (is_set(joint.radius) && !is_cam(joint.type)));
  });
}

bool slides(const Mechanism::Input& in, const Name& link) {
  return std::any_of(in.joints.begin(), in.joints.end(), [&](const planar::Joint& joint) {
    return joint.type == Type::prismatic && (joint.links.first == link || joint.links.second == link);
  });
}

Name middle_of(const planar::Link& link) { return Name("S_" + text(link.name)); }

/// A bar whose middle is called, and is not yet among its points.
bool is_bar(const planar::Link& link) {
  return !link.S.empty() && link.S == middle_of(link) && find_named(link.points, link.S) == nullptr;
}

/// The two ends of a bar, in its axes.
std::pair<mechanism::Vec, mechanism::Vec> ends_of(const Mechanism::Input& in, const planar::Link& link) {
  const auto points = joint_points(in, link.name);
  return {vector_of(*find_named(link.points, points[0])), vector_of(*find_named(link.points, points[1]))};
}

FieldFault no_centre(const std::string& name) {
  return {path_of("links", name, "mass"), say("link '{1}' has a mass, but its mass centre is missing", name),
          say("give it a point S, name it with S = \"S\", and J = \"... kg*m^2\" about it; only a bar between two "
              "joints, a slide and a link of one point need neither")};
}

FieldFault no_inertia(const std::string& name) {
  const std::string path = path_of("links", name);
  return {path,
          say("'{1}.J' is missing: '{2}' has its own mass centre, so the slender-bar default does not "
              "apply",
              path, name),
          say("write J = \"... kg*m^2\", about the mass centre; 0 kg*m^2 where its mass is in that point")};
}

FieldFault reaches_beyond(const planar::Link& link, const planar::Point& point) {
  return {path_of("links", link.name, "mass"),
          say("the point '{1}' of '{2}' lies beyond its joints: its mass is not that of a bar between them",
              point.name.view(), link.name.view()),
          say("give it a point S, name it with S = \"S\", and J = \"... kg*m^2\" about it")};
}

/// Turns about a point that is not its mass centre, or may do so.
bool needs_inertia(const Mechanism::Input& in, const planar::Link& link, const std::vector<Name>& joints) {
  const bool block = joints.size() == 1 && link.S == joints[0];
  return in.analysis == Mechanism::Analysis::kinetostatic && !block;
}

}  // namespace

std::vector<FieldFault> name_mass_centres(Mechanism::Input& in, const Typed& typed) {
  std::vector<FieldFault> faults;
  for (planar::Link& link : in.links) {
    const std::string name = text(link.name);
    if (!typed(path_of("links", name, "mass")) || in_si(link.mass) == 0.0) continue;
    const auto joints = joint_points(in, link.name);
    const bool two_pins = joints.size() == 2 && !carries_wheel(in, link.name);
    if (typed(path_of("links", name, "S"))) {
      if (needs_inertia(in, link, joints) && !typed(path_of("links", name, "J"))) faults.push_back(no_inertia(name));
    } else if (link.S.empty() && joints.size() == 1 && (link.points.size() == 1 || slides(in, link.name))) {
      link.S = joints[0];
    } else if (link.S.empty() && two_pins && find_named(link.points, middle_of(link)) == nullptr) {
      link.S = middle_of(link);
    } else if (link.S.empty()) {
      faults.push_back(no_centre(name));
    }
  }
  return faults;
}

Mechanism::Input without_named_centres(const Mechanism::Input& given, const Typed& typed) {
  Mechanism::Input in = given;
  for (planar::Link& link : in.links) {
    if (!typed(path_of("links", link.name, "S"))) link.S = {};
  }
  return in;
}

std::vector<FieldFault> check_bars(const Mechanism::Input& in) {
  constexpr double nearly = 0.01;
  std::vector<FieldFault> faults;
  for (const planar::Link& link : in.links) {
    if (!is_bar(link)) continue;
    const auto [from, to] = ends_of(in, link);
    const mechanism::Vec along = to - from;
    for (const planar::Point& point : link.points) {
      const double share = dot(vector_of(point) - from, along) / dot(along, along);
      if (share < -nearly || share > 1.0 + nearly) faults.push_back(reaches_beyond(link, point));
    }
  }
  return faults;
}

void set_bar_inertia(Mechanism::Input& in, const Typed& typed) {
  for (planar::Link& link : in.links) {
    if (!is_bar(link) || typed(path_of("links", link.name, "J"))) continue;
    const auto [from, to] = ends_of(in, link);
    const Length l = from_si<Length>(mechanism::length(to - from));
    link.J = link.mass * l * l / 12.0;
  }
}

Mechanism::Input with_mass_centres(const Mechanism::Input& given) {
  Mechanism::Input in = given;
  for (planar::Link& link : in.links) {
    if (!is_bar(link)) continue;
    const auto [from, to] = ends_of(in, link);
    const mechanism::Vec middle = 0.5 * (from + to);
    planar::Point point;
    point.name = link.S;
    point.x = from_si<Length>(middle.x);
    point.y = from_si<Length>(middle.y);
    link.points.push_back(point);
  }
  return in;
}

}  // namespace loadpath::planar
