#include "calculators/mechanism/planar_profiles.hpp"

#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath {

namespace {

using Planar = PlanarMechanism;
using Shape = Planar::Shape;
using mechanism::Vec;

constexpr double whole_turn = 2.0 * pi;

/// A field that only some shapes take, and whether a profile has it.
struct Special {
  const char* key;
  bool (*given)(const Planar::Profile&);
  std::array<Shape, 3> shapes;  // padded with the first
};

const std::array specials{
    Special{"base", [](const auto& p) { return is_set(p.base); }, {Shape::sliding, Shape::swinging, Shape::flat}},
    Special{"roller",
            [](const auto& p) { return in_si(p.roller) != 0.0; },
            {Shape::sliding, Shape::swinging, Shape::sliding}},
    Special{"offset",
            [](const auto& p) { return in_si(p.offset) != 0.0; },
            {Shape::sliding, Shape::sliding, Shape::sliding}},
    Special{"pivot", [](const auto& p) { return is_set(p.pivot); }, {Shape::swinging, Shape::swinging, Shape::swinging}},
    Special{"arm", [](const auto& p) { return is_set(p.arm); }, {Shape::swinging, Shape::swinging, Shape::swinging}},
    Special{"segments",
            [](const auto& p) { return !p.segments.empty(); },
            {Shape::sliding, Shape::swinging, Shape::flat}},
    Special{"r", [](const auto& p) { return is_set(p.r); }, {Shape::circle, Shape::circle, Shape::circle}},
    Special{"centre", [](const auto& p) { return is_set(p.centre.x); }, {Shape::circle, Shape::circle, Shape::circle}},
    Special{"points", [](const auto& p) { return !p.points.empty(); }, {Shape::points, Shape::points, Shape::points}}};

template <class Enum>
const char* key_of(Enum value) {
  for (const auto& choice : choices_of(value)) {
    if (choice.value == value) return choice.key;
  }
  return "";
}

std::string path_of(const Planar::Profile& profile, const std::string& field = "") {
  return "profiles." + std::string(profile.name.view()) + (field.empty() ? "" : "." + field);
}

std::string segment_path(const Planar::Profile& profile, std::size_t k, const char* field = "") {
  return path_of(profile, "segments[" + std::to_string(k + 1) + "]" + (*field == 0 ? "" : "." + std::string(field)));
}

bool is_by_lift(Shape shape) { return shape == Shape::sliding || shape == Shape::swinging || shape == Shape::flat; }

double rise_of(const Planar::Profile& profile, const Planar::Segment& segment) {
  if (profile.shape == Shape::swinging) return is_set(segment.swing) ? segment.swing : 0.0;
  return is_set(segment.lift) ? in_si(segment.lift) : 0.0;
}

class FieldCheck {
 public:
  explicit FieldCheck(const Planar::Profile& profile) : profile_(profile) {}

  std::vector<FieldFault> run() {
    for (const Special& special : specials) check(special);
    if (profile_.shape == Shape::circle) need("r", is_set(profile_.r), "r = \"40 mm\"");
    if (is_by_lift(profile_.shape)) {
      need("base", is_set(profile_.base), "base = \"30 mm\", the radius of its base circle");
      need("segments", !profile_.segments.empty(),
           "segments = [{ law = \"cycloidal\", angle = \"180 deg\", lift = \"10 mm\" }, ...]");
    }
    if (profile_.shape == Shape::swinging) {
      need("pivot", is_set(profile_.pivot), "pivot = \"80 mm\"");
      need("arm", is_set(profile_.arm), "arm = \"70 mm\"");
    }
    if (profile_.shape == Shape::points) {
      need("four points or more", profile_.points.size() >= 4, "points = [[\"30 mm\", \"0 mm\"], ...]");
    }
    for (std::size_t k = 0; k < profile_.segments.size(); ++k) check(k, profile_.segments[k]);
    return std::move(faults_);
  }

 private:
  void check(const Special& special) {
    if (!special.given(profile_)) return;
    if (std::find(special.shapes.begin(), special.shapes.end(), profile_.shape) != special.shapes.end()) return;
    faults_.push_back({path_of(profile_, special.key),
                       say("a profile of the shape {1} takes no '{2}'", key_of(profile_.shape), special.key),
                       say("leave it out, or change the shape")});
  }

  void need(const char* what, bool given, const char* example) {
    if (given) return;
    faults_.push_back(
        {path_of(profile_),
         say("profile '{1}' of the shape {2} needs {3}", profile_.name.view(), key_of(profile_.shape), what),
         say("add {1}", example)});
  }

  void check(std::size_t k, const Planar::Segment& segment) {
    const bool swings = profile_.shape == Shape::swinging, lift = is_set(segment.lift), swing = is_set(segment.swing);
    const char* const own = swings ? "swing" : "lift";
    if (segment.law == Planar::Law::constant_velocity) {
      faults_.push_back({segment_path(profile_, k, "law"),
                         say("at the ends of a segment with constant velocity the acceleration is infinite"),
                         say("take cycloidal, 3-4-5 or 4-5-6-7")});
    } else if (swings ? lift : swing) {
      faults_.push_back({segment_path(profile_, k, swings ? "lift" : "swing"),
                         say("a profile of the shape {1} is told by '{2}'", key_of(profile_.shape), own), Message{}});
    } else if (segment.law == Planar::Law::dwell && rise_of(profile_, segment) != 0.0) {
      faults_.push_back({segment_path(profile_, k), say("a dwell has no '{1}'", own), say("name another law")});
    } else if (segment.law != Planar::Law::dwell && !(swings ? swing : lift)) {
      faults_.push_back({segment_path(profile_, k), say("segment {1} needs '{2}'", std::to_string(k + 1), own),
                         say("a rise is positive, a fall negative; for a dwell leave out the law")});
    }
  }

  const Planar::Profile& profile_;
  std::vector<FieldFault> faults_;
};

class ValueCheck {
 public:
  explicit ValueCheck(const Planar::Profile& profile) : profile_(profile) {}

  std::vector<FieldFault> run() {
    if (is_by_lift(profile_.shape)) check_segments();
    if (profile_.shape == Shape::sliding) check_sliding();
    if (profile_.shape == Shape::swinging) check_swinging();
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
      const Planar::Segment& segment = profile_.segments[k];
      if (!(segment.angle > 0.0)) {
        faults_.push_back({segment_path(profile_, k, "angle"), say("a segment takes an angle of more than 0"),
                           say("leave the segment out")});
      }
      angle += segment.angle;
      rise += rise_of(profile_, segment);
      least = std::min(least, rise);
      size = std::max(size, std::abs(rise_of(profile_, segment)));
    }
    const char* const unit = profile_.shape == Shape::swinging ? "deg" : "mm";
    if (std::abs(angle - whole_turn) > 1e-9) {
      add("segments",
          say("the segments take {1} of the cam, and must take a whole turn", format_quantity(angle, "deg", 6)),
          say("change an angle, or add a dwell"));
    }
    if (std::abs(rise) > 1e-9 * size) {
      add("segments", say("after a turn the follower is {1} off where it was", format_quantity(rise, unit, 5)),
          say("what it rises it must fall"));
    } else if (least < -1e-9 * size) {
      add("segments",
          say("the follower sinks {1} below where it is on the base circle", format_quantity(-least, unit, 5)),
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
      return add("arm",
                 say("with the pivot {1} from the cam's axis an arm of {2} does not bring the roller {3} from that axis",
                     format_quantity(d, "mm", 5), format_quantity(l, "mm", 5), format_quantity(reach, "mm", 5)),
                 say("change pivot, arm or base"));
    }
    const mechanism::SwingingFollower without_lift{mechanism::Lift({}), {}, reach, d, l, 1.0};
    double angle = without_lift.base_angle();
    for (const Planar::Segment& segment : profile_.segments) {
      angle += rise_of(profile_, segment);
      if (angle < pi) continue;
      return add("segments",
                 say("the arm swings past the line from the cam's axis through its pivot: to {1} from the way back",
                     format_quantity(angle, "deg", 5)),
                 say("make the swing smaller, or the arm longer"));
    }
  }

  void check_points() {
    for (std::size_t k = 0; k < profile_.points.size(); ++k) {
      const Planar::Vertex &here = profile_.points[k], &next = profile_.points[(k + 1) % profile_.points.size()];
      if (here.x != next.x || here.y != next.y) continue;
      const bool last = k + 1 == profile_.points.size();
      faults_.push_back({path_of(profile_, "points[" + std::to_string(k + 1) + "]"),
                         last ? say("the last point is the first again") : say("the next point is the same"),
                         say("leave it out: the profile closes by itself")});
      return;
    }
  }

  const Planar::Profile& profile_;
  std::vector<FieldFault> faults_;
};

/// A flat face stands off where the profile is hollow.
void check_flat_faces(const Planar::Input& in, std::vector<FieldFault>& faults) {
  for (const Planar::Joint& joint : in.joints) {
    if (joint.type != Planar::Type::cam_flat) continue;
    const auto profile = profile_of(*find_profile(in, joint.profile));
    const mechanism::Bends bends = mechanism::bends_of(*profile);
    if (!std::isfinite(bends.hollow)) continue;
    faults.push_back({"joints." + std::string(joint.name.view()) + ".profile",
                      say("the profile '{1}' is hollow at a cam angle of {2}, and a flat face does not reach into it",
                          joint.profile.view(), format_quantity(cam_angle(*profile, bends.hollow_at), "deg", 4)),
                      say("take a roller that fits, or make the base circle larger")});
  }
}

mechanism::LiftLaw law_of(Planar::Law law) {
  switch (law) {
    case Planar::Law::harmonic:
      return mechanism::LiftLaw::harmonic;
    case Planar::Law::cycloidal:
      return mechanism::LiftLaw::cycloidal;
    case Planar::Law::polynomial_345:
      return mechanism::LiftLaw::polynomial_345;
    case Planar::Law::polynomial_4567:
      return mechanism::LiftLaw::polynomial_4567;
    case Planar::Law::dwell:
    case Planar::Law::constant_velocity:
      break;
  }
  return mechanism::LiftLaw::dwell;
}

mechanism::Lift lift_of(const Planar::Profile& profile) {
  std::vector<mechanism::LiftSegment> segments;
  for (const Planar::Segment& s : profile.segments) {
    segments.push_back({law_of(s.law), s.angle, rise_of(profile, s)});
  }
  return mechanism::Lift(segments);
}

/// Round counter-clockwise.
std::vector<Vec> points_of(const Planar::Profile& profile) {
  std::vector<Vec> points;
  for (const Planar::Vertex& p : profile.points) points.push_back({in_si(p.x), in_si(p.y)});
  double area = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) area += cross(points[k], points[(k + 1) % points.size()]);
  if (area < 0.0) std::reverse(points.begin(), points.end());
  return points;
}

mechanism::Profile::Curve curve_of(const Planar::Profile& p) {
  const auto sense = p.sense == Planar::Sense::clockwise ? mechanism::CamSense::clockwise
                                                         : mechanism::CamSense::counter_clockwise;
  const double base = in_si(p.base), reach = base + in_si(p.roller);
  switch (p.shape) {
    case Shape::sliding:
      return mechanism::SlidingFollower{lift_of(p), sense, reach, in_si(p.offset)};
    case Shape::swinging:
      return mechanism::SwingingFollower{
          lift_of(p), sense, reach, in_si(p.pivot), in_si(p.arm), p.side == Planar::Hand::left ? 1.0 : -1.0};
    case Shape::flat:
      return mechanism::FlatFollower{lift_of(p), sense, base};
    case Shape::points:
      return mechanism::SplineCurve(points_of(p));
    case Shape::circle:
      break;
  }
  const bool centred = !is_set(p.centre.x);
  return mechanism::Circle{centred ? Vec{} : Vec{in_si(p.centre.x), in_si(p.centre.y)}, in_si(p.r)};
}

report::Table segment_table(const Planar::Profile& profile) {
  report::Table table{say("Profile {1}: segments of the lift", profile.name.view()),
                      {say("from"), say("to"), say("law"), say("rise"), say("remark")},
                      {}};
  const char* const unit = profile.shape == Shape::swinging ? "deg" : "mm";
  const std::vector<double> jumps = lift_of(profile).jumps();
  double from = 0.0;
  for (const Planar::Segment& s : profile.segments) {
    const bool jumps_here =
        std::any_of(jumps.begin(), jumps.end(), [&](double at) { return std::abs(at - from) < 1e-9; });
    table.rows.push_back({report::Quantity{from, "deg"}, report::Quantity{from + s.angle, "deg"}, say(key_of(s.law)),
                          report::Quantity{rise_of(profile, s), unit},
                          jumps_here ? say("the acceleration jumps where it begins") : report::Cell(std::string("–"))});
    from += s.angle;
  }
  return table;
}

}  // namespace

const Planar::Profile* find_profile(const Planar::Input& in, const Name& name) {
  const auto found =
      std::find_if(in.profiles.begin(), in.profiles.end(), [&](const Planar::Profile& p) { return p.name == name; });
  return found == in.profiles.end() ? nullptr : &*found;
}

bool is_cam(Planar::Type type) { return type == Planar::Type::cam || type == Planar::Type::cam_flat; }

std::vector<FieldFault> check_fields(const Planar::Profile& profile) { return FieldCheck(profile).run(); }

std::vector<FieldFault> check_profiles(const Planar::Input& in) {
  std::vector<FieldFault> faults;
  for (const Planar::Profile& profile : in.profiles) {
    for (FieldFault& fault : ValueCheck(profile).run()) faults.push_back(std::move(fault));
  }
  if (faults.empty()) check_flat_faces(in, faults);
  return faults;
}

std::shared_ptr<const mechanism::Profile> profile_of(const Planar::Profile& profile) {
  const double inset = profile.shape == Shape::sliding || profile.shape == Shape::swinging ? in_si(profile.roller) : 0.0;
  return std::make_shared<const mechanism::Profile>(curve_of(profile), inset);
}

double roller_radius(const Planar::Input& in, const Planar::Joint& joint) {
  if (joint.type == Planar::Type::cam_flat) return 0.0;
  if (is_set(joint.radius)) return in_si(joint.radius);
  const Planar::Profile* profile = find_profile(in, joint.profile);
  return profile == nullptr ? 0.0 : in_si(profile->roller);
}

double cam_angle(const mechanism::Profile& profile, double parameter) {
  const auto by_lift = [&](mechanism::CamSense sense) {
    return sense == mechanism::CamSense::clockwise ? parameter : -parameter;
  };
  double angle = 0.0;
  if (const auto* sliding = std::get_if<mechanism::SlidingFollower>(&profile.curve())) {
    angle = by_lift(sliding->sense);
  } else if (const auto* swinging = std::get_if<mechanism::SwingingFollower>(&profile.curve())) {
    angle = by_lift(swinging->sense);
  } else if (const auto* flat = std::get_if<mechanism::FlatFollower>(&profile.curve())) {
    angle = by_lift(flat->sense);
  } else {
    const Vec flank = profile.flank(parameter);
    angle = std::atan2(flank.y, flank.x);
  }
  return angle - whole_turn * std::floor(angle / whole_turn);
}

std::vector<report::Table> profile_tables(const Planar::Input& in) {
  using report::Cell;
  using report::Quantity;
  std::vector<report::Table> tables;
  if (in.profiles.empty()) return tables;
  const auto length = [](const Length& l, bool has) {
    return has && is_set(l) ? Cell(Quantity{in_si(l), "mm"}) : Cell(std::string("–"));
  };
  report::Table table{say("Profiles of cams"),
                      {say("profile"), say("shape"), say("base circle"), say("roller"), say("offset"), say("pivot"),
                       say("arm"), say("radius of the circle"), say("the cam turns")},
                      {}};
  for (const Planar::Profile& p : in.profiles) {
    const bool lift = is_by_lift(p.shape);
    table.rows.push_back({std::string(p.name.view()), say(key_of(p.shape)), length(p.base, lift),
                          length(p.roller, lift && p.shape != Shape::flat), length(p.offset, p.shape == Shape::sliding),
                          length(p.pivot, p.shape == Shape::swinging), length(p.arm, p.shape == Shape::swinging),
                          length(p.r, p.shape == Shape::circle),
                          lift ? Cell(say(choices_of(p.sense)[static_cast<std::size_t>(p.sense)].doc))
                               : Cell(std::string("–"))});
  }
  tables.push_back(std::move(table));
  for (const Planar::Profile& p : in.profiles) {
    if (is_by_lift(p.shape)) tables.push_back(segment_table(p));
  }
  return tables;
}

}  // namespace loadpath
