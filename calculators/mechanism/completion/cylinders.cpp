#include "calculators/mechanism/completion/cylinders.hpp"

#include "calculators/mechanism/input/model.hpp"
#include "calculators/mechanism/input/names.hpp"
#include "calculators/mechanism/input/points.hpp"
#include "lib/mechanism/model/frames.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace loadpath::planar {

namespace {

using mechanism::Vec;

bool lies_between_points(const Cylinder& c) { return !c.links.first.empty() || !c.points.first.empty(); }

bool is_moved(const Cylinder& c) {
  const bool speed = in_si(c.speed) != 0.0 || in_si(c.acceleration) != 0.0;
  const bool law = !c.law.empty() || !c.place_of_t.empty();
  return speed || law || is_set(c.from) || is_set(c.to) || c.impending != Impending::either;
}

Name part_of(const Cylinder& c, const char* part) { return Name(text(c.name) + "_" + part); }

class CylinderCheck {
 public:
  explicit CylinderCheck(NameFaults& faults) : faults_(faults), in_(faults.input()) {}

  void check(const Cylinder& c) {
    check_way(c);
    if (!lies_between_points(c)) return check_joint(c);
    if (!c.joint.empty())
      return add(c, "joint", say("'joint' and 'links' both state the parts moved by '{1}'", c.name.view()),
                 say("leave out 'joint' for a cylinder between two points, or 'links' and 'points' for a slide"));
    check_ends(c);
    check_name(c);
    check_force(c);
  }

 private:
  void add(const Cylinder& c, const char* field, Message message, Message hint) {
    faults_.add(path_of("cylinders", c.name, field), std::move(message), std::move(hint));
  }

  void check_joint(const Cylinder& c) {
    if (c.joint.empty())
      return add(c, "", say("'{1}' names neither the links that it lies between nor a joint", c.name.view()),
                 say("add links = [\"ground\", \"boom\"] and points = [\"O\", \"A\"]"));
    faults_.require_joint(c.joint, path_of("cylinders", c.name, "joint"));
    if (is_set(c.F))
      add(c, "F", say("'F' belongs to a cylinder between two points, and '{1}' drives a joint", c.name.view()),
          say("give the force as a load on its link, and leave the drive out"));
  }

  /// Against its speed the time would run backwards.
  void check_way(const Cylinder& c) {
    if (!is_set(c.from) || !is_set(c.to) || in_si(c.to - c.from) * in_si(c.speed) >= 0.0) return;
    add(c, "speed",
        say("'{1}' goes from {2} to {3}, and its speed has the other sign", c.name.view(),
            format_quantity(in_si(c.from), mm.symbol), format_quantity(in_si(c.to), mm.symbol)),
        say("a cylinder that gets shorter has a negative speed"));
  }

  void check_ends(const Cylinder& c) {
    if (c.links.first.empty() || c.points.first.empty())
      return add(c, "", say("a cylinder between two points needs 'links' and 'points'"),
                 say("write links = [\"ground\", \"boom\"], points = [\"O\", \"A\"]"));
    const std::string links = path_of("cylinders", c.name, "links"), points = path_of("cylinders", c.name, "points");
    const bool first = faults_.require_link(c.links.first, links + ".first");
    const bool second = faults_.require_link(c.links.second, links + ".second");
    if (first && c.links.first == c.links.second)
      add(c, "links", say("a cylinder lies between two links, or a link and the ground"),
          say("name the other link: links = [\"ground\", \"boom\"]"));
    if (first) faults_.require_point(link_index(in_, c.links.first), c.points.first, points + ".first");
    if (second) faults_.require_point(link_index(in_, c.links.second), c.points.second, points + ".second");
  }

  /// Its parts are called after it.
  void check_name(const Cylinder& c) {
    constexpr std::size_t longest = Name::capacity - std::string_view("_barrel").size();
    if (c.name.view().size() > longest)
      add(c, "", say("the name '{1}' is too long for the parts that are named after it", c.name.view()),
          say("at most {1} letters", std::to_string(longest)));
    for (const char* const part : {"barrel", "rod"}) {
      if (find_named(in_.links, part_of(c, part)) != nullptr)
        add(c, "", say("the cylinder adds its own link '{1}', and there is already one", part_of(c, part).view()),
            say("give that link another name"));
    }
    for (const char* const part : {"foot", "eye", "bore"}) {
      if (find_named(in_.joints, part_of(c, part)) != nullptr)
        add(c, "", say("the cylinder adds its own joint '{1}', and there is already one", part_of(c, part).view()),
            say("give that joint another name"));
    }
  }

  void check_force(const Cylinder& c) {
    if (is_set(c.F) && is_moved(c))
      add(c, "F", say("the force of '{1}' is given, and so is its motion", c.name.view()),
          say("leave out 'F', and its force is a result; or leave out speed, from, to, law and place_of_t"));
    if (!is_set(c.F) && !c.course.empty())
      add(c, "course", say("'course' is the load curve of F, and '{1}' has no F", c.name.view()),
          say("add F, or leave it out"));
    if (!c.course.empty()) faults_.require_course(c.course, path_of("cylinders", c.name, "course"));
  }

  NameFaults& faults_;
  const Mechanism::Input& in_;
};

planar::Point origin_of(const Name& name) {
  planar::Point point;
  point.name = name;
  point.x = point.y = 0.0 * m.one;
  return point;
}

planar::Link part_at(const Name& name, const Name& end, Vec at, double angle) {
  planar::Link link;
  link.name = name;
  link.points.push_back(origin_of(end));
  link.origin = {from_si<Length>(at.x), from_si<Length>(at.y)};
  link.angle = angle;
  return link;
}

planar::Joint joint_of(const Name& name, Type type, const planar::Pair& links, const planar::Pair& points) {
  planar::Joint joint;
  joint.name = name;
  joint.type = type;
  joint.links = links;
  joint.points = points;
  if (type == Type::prismatic) joint.angle = 0.0;
  return joint;
}

planar::Load push_on(const Name& part, const Name& end, const Cylinder& c, double direction) {
  planar::Load load;
  load.name = part;
  load.link = part;
  load.at = end;
  load.F = c.F;
  load.direction = direction;
  load.axes = Axes::link;
  load.course = c.course;
  return load;
}

Vec place_of(const Mechanism::Input& in, const mechanism::Model& placed, const Name& link, const Name& point) {
  const int k = link_index(in, link);
  return mechanism::placed_in(placed, k).point(vector_of(*find_point(in, k, point)));
}

void add_between(const Cylinder& c, Vec from, Vec to, Mechanism::Input& in) {
  const Name barrel = part_of(c, "barrel"), rod = part_of(c, "rod"), bore = part_of(c, "bore");
  const auto [first, second] = c.points;
  const double angle = std::atan2(to.y - from.y, to.x - from.x);
  in.links.push_back(part_at(barrel, first, from, angle));
  in.links.push_back(part_at(rod, second, to, angle));
  in.joints.push_back(joint_of(part_of(c, "foot"), Type::revolute, {c.links.first, barrel}, {first, first}));
  in.joints.push_back(joint_of(part_of(c, "eye"), Type::revolute, {rod, c.links.second}, {second, second}));
  in.joints.push_back(joint_of(bore, Type::prismatic, {rod, barrel}, {second, first}));
  in.actuators.push_back({c.name, bore, !is_set(c.F), true});
  if (is_set(c.F)) {
    in.loads.push_back(push_on(rod, second, c, 0.0));
    in.loads.push_back(push_on(barrel, first, c, pi));
  } else {
    in.cylinders.push_back(c);
    in.cylinders.back().joint = bore;
  }
}

}  // namespace

void check_cylinders(NameFaults& faults) {
  CylinderCheck check(faults);
  for (const Cylinder& c : faults.input().cylinders) check.check(c);
}

Mechanism::Input with_cylinders(const Mechanism::Input& given) {
  Mechanism::Input in = given;
  in.cylinders.clear();
  const bool some = std::any_of(given.cylinders.begin(), given.cylinders.end(), lies_between_points);
  const mechanism::Model placed = some ? model_of(given) : mechanism::Model();
  for (const Cylinder& c : given.cylinders) {
    if (lies_between_points(c)) {
      add_between(c, place_of(given, placed, c.links.first, c.points.first),
                  place_of(given, placed, c.links.second, c.points.second), in);
    } else {
      in.actuators.push_back({.name = c.name, .joint = c.joint});
      in.cylinders.push_back(c);
    }
  }
  return in;
}

}  // namespace loadpath::planar
