#include "calculators/mechanism/input/profiles.hpp"

#include "calculators/mechanism/input/names.hpp"
#include "lib/mechanism/model/whole_turn.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar {

namespace {

using Shape = CamProfile::Shape;
using mechanism::Vec;

mechanism::LiftLaw law_of(CamProfile::Law law) {
  switch (law) {
    case CamProfile::Law::harmonic:
      return mechanism::LiftLaw::harmonic;
    case CamProfile::Law::cycloidal:
      return mechanism::LiftLaw::cycloidal;
    case CamProfile::Law::polynomial_345:
      return mechanism::LiftLaw::polynomial_345;
    case CamProfile::Law::polynomial_4567:
      return mechanism::LiftLaw::polynomial_4567;
    case CamProfile::Law::modified_sine:
      return mechanism::LiftLaw::modified_sine;
    case CamProfile::Law::modified_trapezoid:
      return mechanism::LiftLaw::modified_trapezoid;
    case CamProfile::Law::dwell:
    case CamProfile::Law::constant_velocity:
      break;
  }
  return mechanism::LiftLaw::dwell;
}

mechanism::Lift lift_of(const CamProfile& profile) {
  std::vector<mechanism::LiftSegment> segments;
  for (const CamProfile::Segment& s : profile.segments) {
    segments.push_back({law_of(s.law), s.angle, rise_of(profile, s)});
  }
  return mechanism::Lift(segments);
}

bool has_roller(Shape shape) { return shape == Shape::sliding || shape == Shape::swinging; }

/// Round counter-clockwise.
std::vector<Vec> points_of(const CamProfile& profile) {
  std::vector<Vec> points;
  for (const CamProfile::Vertex& p : profile.points) points.push_back({in_si(p.x), in_si(p.y)});
  double area = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) area += cross(points[k], points[(k + 1) % points.size()]);
  if (area < 0.0) std::reverse(points.begin(), points.end());
  return points;
}

mechanism::Profile::Curve curve_of(const CamProfile& p) {
  const auto sense =
      p.sense == CamProfile::Sense::clockwise ? mechanism::CamSense::clockwise : mechanism::CamSense::counter_clockwise;
  const double base = in_si(p.base), reach = base + in_si(p.roller);
  const double side = p.side == CamProfile::Hand::left ? 1.0 : -1.0;
  switch (p.shape) {
    case Shape::sliding:
      return mechanism::SlidingFollower{lift_of(p), sense, reach, in_si(p.offset)};
    case Shape::swinging:
      return mechanism::SwingingFollower{lift_of(p), sense, reach, in_si(p.pivot), in_si(p.arm), side};
    case Shape::flat:
      return mechanism::FlatFollower{lift_of(p), sense, base};
    case Shape::swinging_flat:
      return mechanism::SwingingFace{lift_of(p), sense, base, in_si(p.pivot), in_si(p.offset), side};
    case Shape::points:
      return mechanism::SplineCurve(points_of(p));
    case Shape::circle:
      break;
  }
  const bool centred = !is_set(p.centre.x);
  return mechanism::Circle{centred ? Vec{} : Vec{in_si(p.centre.x), in_si(p.centre.y)}, in_si(p.r)};
}

account::Table segment_table(const CamProfile& profile) {
  account::Table table{say("Profile {1}: segments of the lift", profile.name.view()),
                       {say("from"), say("to"), say("law"), say("rise"), say("remark")},
                       {}};
  const char* const unit = is_by_swing(profile.shape) ? "deg" : "mm";
  const std::vector<double> jumps = lift_of(profile).jumps();
  double from = 0.0;
  for (const CamProfile::Segment& s : profile.segments) {
    const bool jumps_here =
        std::any_of(jumps.begin(), jumps.end(), [&](double at) { return std::abs(at - from) < 1e-9; });
    table.rows.push_back(
        {account::Quantity{from, "deg"}, account::Quantity{from + s.angle, "deg"}, say(word_of(s.law)),
         account::Quantity{rise_of(profile, s), unit},
         jumps_here ? say("the acceleration jumps where it begins") : account::Cell(std::string("–"))});
    from += s.angle;
  }
  return table;
}

}  // namespace

const CamProfile* find_profile(const Mechanism::Input& in, const Name& name) { return find_named(in.profiles, name); }

bool is_cam(planar::Type type) { return type == planar::Type::cam || type == planar::Type::cam_flat; }

double rise_of(const CamProfile& profile, const CamProfile::Segment& segment) {
  return is_by_swing(profile.shape) ? si_or_zero(segment.swing) : si_or_zero(segment.lift);
}

std::shared_ptr<const mechanism::Profile> profile_of(const CamProfile& profile) {
  const double inset = has_roller(profile.shape) ? in_si(profile.roller) : 0.0;
  return std::make_shared<const mechanism::Profile>(curve_of(profile), inset);
}

double roller_radius(const Mechanism::Input& in, const planar::Joint& joint) {
  if (joint.type == planar::Type::cam_flat) return 0.0;
  if (is_set(joint.radius)) return in_si(joint.radius);
  const CamProfile* profile = find_profile(in, joint.profile);
  return profile == nullptr ? 0.0 : in_si(profile->roller);
}

double cam_angle(const mechanism::Profile& profile, double parameter) {
  const double angle = std::visit(
      [&](const auto& curve) {
        if constexpr (requires { curve.sense; }) {
          return curve.sense == mechanism::CamSense::clockwise ? parameter : -parameter;
        } else {
          const Vec flank = profile.flank(parameter);
          return std::atan2(flank.y, flank.x);
        }
      },
      profile.curve());
  return angle - whole_turn * std::floor(angle / whole_turn);
}

std::vector<account::Table> profile_tables(const Mechanism::Input& in) {
  using account::Cell;
  using account::Quantity;
  std::vector<account::Table> tables;
  if (in.profiles.empty()) return tables;
  const auto length = [](const Length& l, bool has) {
    return has && is_set(l) ? Cell(Quantity{in_si(l), "mm"}) : Cell(std::string("–"));
  };
  account::Table table{say("Cam profiles"),
                       {say("profile"), say("shape"), say("base circle"), say("roller"), say("offset"), say("pivot"),
                        say("arm"), say("radius of the circle"), say("the cam turns")},
                       {}};
  for (const CamProfile& p : in.profiles) {
    const bool lift = is_by_lift(p.shape);
    table.rows.push_back(
        {std::string(p.name.view()), say(word_of(p.shape)), length(p.base, lift), length(p.roller, has_roller(p.shape)),
         length(p.offset, p.shape == Shape::sliding || p.shape == Shape::swinging_flat),
         length(p.pivot, is_by_swing(p.shape)), length(p.arm, p.shape == Shape::swinging),
         length(p.r, p.shape == Shape::circle), lift ? Cell(say(choice_of(p.sense).doc)) : Cell(std::string("–"))});
  }
  tables.push_back(std::move(table));
  for (const CamProfile& p : in.profiles) {
    if (is_by_lift(p.shape)) tables.push_back(segment_table(p));
  }
  return tables;
}

}  // namespace loadpath::planar
