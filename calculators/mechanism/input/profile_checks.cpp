// Possible faults of the profile of a cam: fields, values, and its contact.
#include "calculators/mechanism/input/names.hpp"
#include "calculators/mechanism/input/profiles.hpp"
#include "lib/mechanism/model/whole_turn.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace loadpath::planar {

namespace {

using Shape = CamProfile::Shape;

using planar::path_of;

/// A field that only some shapes take, and whether a profile has it.
struct Special {
  const char* key;
  Some<Shape> shapes;
  bool (*given)(const CamProfile&);
};

constexpr Some by_lift{Shape::sliding, Shape::swinging, Shape::flat, Shape::swinging_flat};

constexpr std::array specials{
    Special{"base", by_lift, [](const auto& p) { return is_set(p.base); }},
    Special{"roller", {Shape::sliding, Shape::swinging}, [](const auto& p) { return in_si(p.roller) != 0.0; }},
    Special{"offset", {Shape::sliding, Shape::swinging_flat}, [](const auto& p) { return in_si(p.offset) != 0.0; }},
    Special{"pivot", {Shape::swinging, Shape::swinging_flat}, [](const auto& p) { return is_set(p.pivot); }},
    Special{"arm", {Shape::swinging}, [](const auto& p) { return is_set(p.arm); }},
    Special{"segments", by_lift, [](const auto& p) { return !p.segments.empty(); }},
    Special{"r", {Shape::circle}, [](const auto& p) { return is_set(p.r); }},
    Special{"centre", {Shape::circle}, [](const auto& p) { return is_set(p.centre.x); }},
    Special{"points", {Shape::points}, [](const auto& p) { return !p.points.empty(); }}};

std::string path_of(const CamProfile& profile, std::string_view field = {}) {
  return path_of("profiles", profile.name, field);
}

std::string segment_path(const CamProfile& profile, std::size_t k, std::string_view field = {}) {
  const std::string segment = path_of(profile, "segments[" + std::to_string(k + 1) + "]");
  return field.empty() ? segment : segment + "." + std::string(field);
}

class FieldCheck {
 public:
  explicit FieldCheck(const CamProfile& profile) : profile_(profile) {}

  std::vector<FieldFault> run() {
    for (const Special& special : specials) check(special);
    if (profile_.shape == Shape::circle) need("r", is_set(profile_.r), "r = \"40 mm\"");
    if (is_by_lift(profile_.shape)) {
      need("base", is_set(profile_.base), "base = \"30 mm\", the radius of its base circle");
      need("segments", !profile_.segments.empty(),
           "segments = [{ law = \"cycloidal\", angle = \"180 deg\", lift = \"10 mm\" }, ...]");
    }
    if (is_by_swing(profile_.shape)) need("pivot", is_set(profile_.pivot), "pivot = \"80 mm\"");
    if (profile_.shape == Shape::swinging) need("arm", is_set(profile_.arm), "arm = \"70 mm\"");
    if (profile_.shape == Shape::points) {
      need("four points or more", profile_.points.size() >= 4, "points = [[\"30 mm\", \"0 mm\"], ...]");
    }
    for (std::size_t k = 0; k < profile_.segments.size(); ++k) check(k, profile_.segments[k]);
    return std::move(faults_);
  }

 private:
  void check(const Special& special) {
    if (!special.given(profile_) || special.shapes.has(profile_.shape)) return;
    faults_.push_back({path_of(profile_, special.key),
                       say("a profile of the shape {1} takes no '{2}'", word_of(profile_.shape), special.key),
                       say("leave it out, or change the shape")});
  }

  void need(const char* what, bool given, const char* example) {
    if (given) return;
    faults_.push_back(
        {path_of(profile_),
         say("profile '{1}' of the shape {2} needs {3}", profile_.name.view(), word_of(profile_.shape), what),
         say("add {1}", example)});
  }

  void check(std::size_t k, const CamProfile::Segment& segment) {
    const bool swings = is_by_swing(profile_.shape), lift = is_set(segment.lift), swing = is_set(segment.swing);
    const char* const own = swings ? "swing" : "lift";
    if (segment.law == CamProfile::Law::constant_velocity) {
      faults_.push_back({segment_path(profile_, k, "law"),
                         say("at the ends of a segment with constant velocity the acceleration is infinite"),
                         say("take cycloidal, 3-4-5, 4-5-6-7, modified_sine or modified_trapezoid")});
    } else if (swings ? lift : swing) {
      faults_.push_back({segment_path(profile_, k, swings ? "lift" : "swing"),
                         say("a profile of shape {1} is defined by '{2}'", word_of(profile_.shape), own), Message{}});
    } else if (segment.law == CamProfile::Law::dwell && rise_of(profile_, segment) != 0.0) {
      faults_.push_back({segment_path(profile_, k), say("a dwell has no '{1}'", own), say("name another law")});
    } else if (segment.law != CamProfile::Law::dwell && !(swings ? swing : lift)) {
      faults_.push_back({segment_path(profile_, k), say("segment {1} needs '{2}'", std::to_string(k + 1), own),
                         say("a rise is positive, a fall negative; for a dwell leave out the law")});
    }
  }

  const CamProfile& profile_;
  std::vector<FieldFault> faults_;
};

class ValueCheck {
 public:
  explicit ValueCheck(const CamProfile& profile) : profile_(profile) {}

  std::vector<FieldFault> run() {
    if (is_by_lift(profile_.shape)) check_segments();
    if (profile_.shape == Shape::sliding) check_sliding();
    if (profile_.shape == Shape::swinging) check_swinging();
    if (profile_.shape == Shape::swinging_flat && faults_.empty()) check_face();
    if (profile_.shape == Shape::points) check_points();
    return std::move(faults_);
  }

 private:
  void add(const char* field, Message message, Message hint) {
    faults_.push_back({path_of(profile_, field), std::move(message), std::move(hint)});
  }

  void check_segments() {
    double angle = 0.0, rise = 0.0, least = 0.0, size = 0.0;
    for (std::size_t k = 0; k < profile_.segments.size(); ++k) {
      const CamProfile::Segment& segment = profile_.segments[k];
      if (!(segment.angle > 0.0)) {
        faults_.push_back({segment_path(profile_, k, "angle"), say("a segment takes an angle of more than 0"),
                           say("leave the segment out")});
      }
      angle += segment.angle;
      rise += rise_of(profile_, segment);
      least = std::min(least, rise);
      size = std::max(size, std::abs(rise_of(profile_, segment)));
    }
    const char* const unit = is_by_swing(profile_.shape) ? "deg" : "mm";
    if (std::abs(angle - whole_turn) > 1e-9) {
      add("segments",
          say("the segments cover {1} of the cam, and must cover a full revolution", format_quantity(angle, "deg", 6)),
          say("change an angle, or add a dwell"));
    }
    if (std::abs(rise) > 1e-9 * size) {
      add("segments",
          say("after a revolution the follower is {1} away from its initial position", format_quantity(rise, unit, 5)),
          say("total rise and total fall must be equal"));
    } else if (least < -1e-9 * size) {
      add("segments",
          say("the follower falls {1} below its position on the base circle", format_quantity(-least, unit, 5)),
          say("begin with the rise, on the base circle"));
    }
    if (size == 0.0) add("segments", say("the follower never moves"), say("give a segment a lift"));
  }

  void check_sliding() {
    const double reach = in_si(profile_.base) + in_si(profile_.roller), offset = std::abs(in_si(profile_.offset));
    if (reach > offset) return;
    add("offset",
        say("the guide passes the cam at {1}, and base circle and roller reach {2}", format_quantity(offset, "mm", 5),
            format_quantity(reach, "mm", 5)),
        say("make the offset smaller, or the base circle larger"));
  }

  void check_swinging() {
    const double reach = in_si(profile_.base) + in_si(profile_.roller), d = in_si(profile_.pivot);
    const double l = in_si(profile_.arm);
    if (!(reach > std::abs(d - l) && reach < d + l)) {
      return add(
          "arm",
          say("with the pivot {1} from the cam's axis an arm of {2} does not bring the roller {3} from that axis",
              format_quantity(d, "mm", 5), format_quantity(l, "mm", 5), format_quantity(reach, "mm", 5)),
          say("change pivot, arm or base"));
    }
    const mechanism::SwingingFollower without_lift{mechanism::Lift({}), {}, reach, d, l, 1.0};
    const double angle = without_lift.base_angle() + largest_swing();
    if (angle < pi) return;
    add("segments",
        say("the arm swings past the line from the cam axis through its pivot: to {1} from the direction towards that "
            "axis",
            format_quantity(angle, "deg", 5)),
        say("make the swing smaller, or the arm longer"));
  }

  [[nodiscard]] double largest_swing() const {
    double swing = 0.0, largest = 0.0;
    for (const CamProfile::Segment& segment : profile_.segments) {
      swing += rise_of(profile_, segment);
      largest = std::max(largest, swing);
    }
    return largest;
  }

  void check_face() {
    const double d = in_si(profile_.pivot), passing = in_si(profile_.base) + in_si(profile_.offset);
    if (!(std::abs(passing) < d)) {
      return add("pivot",
                 say("the pivot is {1} from the cam's axis, and a face that touches the base circle passes that axis "
                     "at {2} more than it passes the pivot",
                     format_quantity(d, "mm", 5), format_quantity(std::abs(passing), "mm", 5)),
                 say("move the pivot out, or change base or offset"));
    }
    const double angle = std::asin(passing / d) + largest_swing();
    if (!(angle < 0.5 * pi)) {
      return add("segments",
                 say("the face swings to {1} from the line between its pivot and the cam's axis, and touches the cam "
                     "up to 90°",
                     format_quantity(angle, "deg", 5)),
                 say("make the swing smaller, or move the pivot out"));
    }
    check_turning();
  }

  /// The contact runs off along the face where that swings as fast as the cam turns.
  void check_turning() {
    constexpr int samples = 3600;
    const auto profile = profile_of(profile_);
    for (int k = 0; k < samples; ++k) {
      const double parameter = whole_turn * k / samples;
      if (profile->at(parameter).turning > 0.0) continue;
      return add("segments",
                 say("at a cam angle of {1} the face swings as fast as the cam turns, or faster, and no profile "
                     "touches it",
                     format_quantity(cam_angle(*profile, parameter), "deg", 4)),
                 say("make the swing smaller, or its segment longer"));
    }
  }

  void check_points() {
    for (std::size_t k = 0; k < profile_.points.size(); ++k) {
      const CamProfile::Vertex &here = profile_.points[k], &next = profile_.points[(k + 1) % profile_.points.size()];
      if (here.x != next.x || here.y != next.y) continue;
      const bool last = k + 1 == profile_.points.size();
      faults_.push_back({path_of(profile_, "points[" + std::to_string(k + 1) + "]"),
                         last ? say("the last point is the first again") : say("the next point is the same"),
                         say("leave it out: the profile closes by itself")});
      return;
    }
  }

  const CamProfile& profile_;
  std::vector<FieldFault> faults_;
};

/// At a hollow of the profile a flat face loses contact, and too large a roller touches at two places.
void check_hollows(const Mechanism::Input& in, std::vector<FieldFault>& faults) {
  for (const planar::Joint& joint : in.joints) {
    if (!is_cam(joint.type)) continue;
    const auto profile = profile_of(*find_profile(in, joint.profile));
    const mechanism::Bends bends = mechanism::bends_of(*profile);
    const bool flat = joint.type == planar::Type::cam_flat;
    if (!(flat ? std::isfinite(bends.hollow) : bends.hollow <= roller_radius(in, joint))) continue;
    const std::string angle = format_quantity(cam_angle(*profile, bends.hollow_at), "deg", 4);
    const Message message =
        flat
            ? say("the profile '{1}' is hollow at a cam angle of {2}, and a flat face does not reach into it",
                  joint.profile.view(), angle)
            : say("the profile '{1}' is hollow at a cam angle of {2}, with a radius of {3}, and the roller of {4} does "
                  "not reach into it",
                  joint.profile.view(), angle, format_quantity(bends.hollow, "mm", 4),
                  format_quantity(roller_radius(in, joint), "mm", 4));
    faults.push_back({path_of("joints", joint.name, flat || !is_set(joint.radius) ? "profile" : "radius"), message,
                      say("take a smaller roller, or make the base circle larger")});
  }
}

}  // namespace

std::vector<FieldFault> check_fields(const CamProfile& profile) { return FieldCheck(profile).run(); }

std::vector<FieldFault> check_values(const CamProfile& profile) { return ValueCheck(profile).run(); }

std::vector<FieldFault> check_profiles(const Mechanism::Input& in) {
  std::vector<FieldFault> faults;
  for (const CamProfile& profile : in.profiles) append(check_values(profile), faults);
  if (faults.empty()) check_hollows(in, faults);
  return faults;
}

}  // namespace loadpath::planar
