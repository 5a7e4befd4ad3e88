#include "calculators/mechanism/templates/sketch.hpp"

#include "calculators/mechanism/input/names.hpp"
#include "calculators/mechanism/input/profiles.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar::templates {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

planar::Point point_of(const char* name, Vec at) {
  planar::Point point;
  point.name = name;
  point.x = from_si<Length>(at.x);
  point.y = from_si<Length>(at.y);
  return point;
}

void put_zero(planar::Point& point) { point.x = point.y = 0.0 * m.one; }

}  // namespace

void put_zeros(Mechanism::Input& in) {
  for (auto& point : in.ground) put_zero(point);
  for (auto& link : in.links) {
    for (auto& point : link.points) put_zero(point);
    link.origin = {0.0 * m.one, 0.0 * m.one};
    link.angle = 0.0;
  }
  for (auto& joint : in.joints) joint.direction = 0.0;
  for (auto& profile : in.profiles) {
    profile.base = 0.0 * m.one;
    if (is_by_swing(profile.shape)) profile.pivot = profile.arm = 0.0 * m.one;
    if (profile.segments.empty()) profile.segments.push_back({.angle = 0.0});
  }
}

Vec polar(Length r, double angle) { return in_si(r) * Vec{std::cos(angle), std::sin(angle)}; }
Vec cartesian(Length x, Length y) { return {in_si(x), in_si(y)}; }
double direction(Vec from, Vec to) { return std::atan2(to.y - from.y, to.x - from.x); }
std::string text_of(Length l) { return format_quantity(in_si(l), "mm", 5); }

Message part_of_a_turn() {
  return say("change a length, or solve part of a revolution: crank = { at = [\"0 deg\", \"10 deg\"] }");
}

Message part_of_a_turn(const Message& part) {
  return say("change a length, or solve part of a revolution, {1}: crank = { at = [...] }", part);
}

Message start_elsewhere() { return say("change a length, or start elsewhere"); }

Message start_elsewhere(const Message& part) {
  return say("change a length, or start elsewhere: the mechanism closes {1}", part);
}

std::optional<FieldFault> pin_runs_through(const char* pin, Length r, Length d) {
  if (abs(r - d) > 1e-9 * d) return std::nullopt;
  return FieldFault{
      "r",
      say("the crank cannot make a full revolution: r and d are both {1}, so its pin A passes through {2}", text_of(r),
          pin),
      part_of_a_turn()};
}

FieldFault leaves_slot(const char* path, Length lever, Length farthest) {
  return {path,
          say("the crank pin leaves the slot: it moves as far as d + r = {1} from B, but the lever is only {2} long",
              text_of(farthest), text_of(lever)),
          part_of_a_turn()};
}

std::string Sketch::where() const {
  return std::isnan(angle_) ? "" : " at a crank angle of " + format_quantity(angle_, "deg", 5);
}

void Sketch::refuse(Message message) {
  const Message hint = std::isnan(angle_) ? say("change a length") : start_elsewhere();
  if (!fault_) fault_ = FieldFault{"", std::move(message), hint};
}

Vec Sketch::meet(const PlacedLink& one, const PlacedLink& other, Assembly assembly) {
  const double r = in_si(one.l), q = in_si(other.l);
  const Vec apart = other.from - one.from;
  const double d = mechanism::length(apart);
  const double along = (d * d + r * r - q * q) / (2.0 * d), across_squared = r * r - along * along;
  if (!(across_squared >= 0.0)) {
    const bool is_far = d > r + q;
    const std::string bound = text_of(is_far ? one.l + other.l : abs(one.l - other.l));
    refuse(say("'{1}' ({2}) and '{3}' ({4}) do not meet{5}: their other ends are {6} apart, {7}", one.link,
               text_of(one.l), other.link, text_of(other.l), where(), text_of(from_si<Length>(d)),
               is_far ? say("more than their sum of {1}", bound) : say("less than their difference of {1}", bound)));
    return {nan, nan};
  }
  const double across = (assembly == Assembly::open ? 1.0 : -1.0) * std::sqrt(across_squared);
  return one.from + (along / d) * apart + (across / d) * mechanism::normal(apart);
}

Vec Sketch::meet(const PlacedLink& link, const Line& line, Assembly assembly) {
  const Vec to = line.through - link.from;
  const double away = mechanism::cross(line.along, to), l = in_si(link.l);
  const double rest = l * l - away * away;
  if (!(rest >= 0.0)) {
    refuse(say("'{1}' ({2}) does not reach its guide, which is {3} away{4}", link.link, text_of(link.l),
               text_of(from_si<Length>(std::abs(away))), where()));
    return {nan, nan};
  }
  const double ahead = (assembly == Assembly::open ? 1.0 : -1.0) * std::sqrt(rest);
  return line.through + (ahead - mechanism::dot(to, line.along)) * line.along;
}

/// The fixed pin that the crank turns about.
static constexpr Pin O{"O", {0.0, 0.0}};

Pin Sketch::crank_arm(Length r) {
  const Pin A{"A", polar(r, angle_)};
  bar("crank", O, A, r);
  drive("crank");
  return A;
}

void Sketch::turning_cam() {
  block("cam", O, angle_);
  drive("cam");
}

void Sketch::drive(const char* link) {
  fixed(O);
  revolute("O", "ground", link);
  in_.crank.joint = "O";
}

void Sketch::fixed(const Pin& pin) { in_.ground.push_back(point_of(pin.name, pin.at)); }

void Sketch::link(const char* name, Vec origin, double angle) {
  planar::Link link;
  link.name = name;
  link.origin = {from_si<Length>(origin.x), from_si<Length>(origin.y)};
  link.angle = angle;
  in_.links.push_back(link);
}

void Sketch::bar(const char* name, const Pin& from, const Pin& to, Length l) {
  link(name, from.at, direction(from.at, to.at));
  point(from.name, {0.0, 0.0});
  point(to.name, {in_si(l), 0.0});
  const std::string centre = std::string("S_") + name;
  point(centre.c_str(), {0.5 * in_si(l), 0.0});
  in_.links.back().S = Name(centre);
  bars_.emplace_back(in_.links.size() - 1, l);
}

void Sketch::point(const char* name, Vec at) { in_.links.back().points.push_back(point_of(name, at)); }

void Sketch::block(const char* name, const Pin& pin, double angle) {
  link(name, pin.at, angle);
  point(pin.name, {0.0, 0.0});
  in_.links.back().S = pin.name;
}

void Sketch::joint(const char* name, planar::Type type, const planar::Pair& links, const planar::Pair& points,
                   double angle) {
  planar::Joint joint;
  joint.name = name;
  joint.type = type;
  joint.links = links;
  joint.points = points;
  joint.direction = angle;
  in_.joints.push_back(joint);
}

void Sketch::revolute(const char* name, const char* first, const char* second, const char* point) {
  joint(name, planar::Type::revolute, {first, second}, {point, point}, 0.0);
}

void Sketch::prismatic(const char* name, std::pair<const char*, const char*> links,
                       std::pair<const char*, const char*> points, double angle) {
  joint(name, planar::Type::prismatic, {links.first, links.second}, {points.first, points.second}, angle);
}

void Sketch::slot(const char* name, std::pair<const char*, const char*> links,
                  std::pair<const char*, const char*> points, double angle) {
  joint(name, planar::Type::slot, {links.first, links.second}, {points.first, points.second}, angle);
}

void Sketch::cam(const char* name, std::pair<const char*, const char*> links,
                 std::pair<const char*, const char*> points, const CamProfile& profile, double angle,
                 planar::Type type) {
  joint(name, type, {links.first, links.second}, {points.first, points.second}, angle);
  in_.joints.back().profile = profile.name;
  in_.profiles.push_back(profile);
  if (fault_ || std::isnan(angle_)) return;
  auto faults = check_fields(profile);
  if (faults.empty()) faults = check_values(profile);
  if (faults.empty()) return;
  fault_ = std::move(faults.front());
  const std::string own = path_of("profiles", profile.name);
  fault_->path.erase(0, std::min(fault_->path.size(), own.size() + 1));
}

Vec Sketch::follower_at(const CamProfile& profile, double angle) const {
  const auto shape = profile_of(profile);
  const Vec at = mechanism::turn(angle_ + angle)(shape->at(-angle_).at);
  if (profile.shape != CamProfile::Shape::flat) return at;
  const Vec out = mechanism::turn(angle)({1.0, 0.0});  // the profile touches next to it
  return mechanism::dot(at, out) * out;
}

void Sketch::cylinder(const char* name, const char* joint) {
  planar::Cylinder cylinder;
  cylinder.name = name;
  cylinder.joint = joint;
  in_.cylinders.push_back(cylinder);
}

}  // namespace loadpath::planar::templates
