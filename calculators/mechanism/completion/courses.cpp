#include "calculators/mechanism/completion/courses.hpp"

#include "calculators/mechanism/input/law.hpp"
#include "calculators/mechanism/input/loads.hpp"
#include "lib/mechanism/model/frames.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace loadpath::planar {

namespace {

constexpr double largest_share = 1e6;  // beyond it a formula is near a pole

bool is_guide(const planar::Joint& joint) { return joint.type == Type::prismatic || joint.type == Type::slot; }

/// The joint along which a stroke is measured; null where it is not clear which.
const planar::Joint* stroke_joint(const Mechanism::Input& in, const Name& stroke_of) {
  const auto named = [&](const Name& joint) { return find_named(in.joints, joint); };
  if (stroke_of.empty()) {
    if (in.actuators.size() == 1) return named(in.actuators.front().joint);
    if (std::count_if(in.joints.begin(), in.joints.end(), is_guide) != 1) return nullptr;
    return &*std::find_if(in.joints.begin(), in.joints.end(), is_guide);
  }
  if (const auto* actuator = find_named(in.actuators, stroke_of)) return named(actuator->joint);
  const planar::Joint* const joint = named(stroke_of);
  return joint != nullptr && is_guide(*joint) ? joint : nullptr;
}

/// A formula of a course: its field, its variable.
struct Written {
  const char* key;
  Law::Variable variable;
  const Formula Course::*text;
};
const std::array<Written, 3>& formulas() {
  static const std::array<Written, 3> all{Written{"share_of_phi", {"phi", deg.dimension()}, &Course::share_of_phi},
                                          Written{"share_of_t", {"t", sec.dimension()}, &Course::share_of_t},
                                          Written{"share_of_s", {"s", mm.dimension()}, &Course::share_of_s}};
  return all;
}

Outcome<Law> parsed(const Course& course, const Written& written) {
  return Law::parse((course.*written.text).view(), written.variable, ratio.dimension());
}

bool by_time(const Course& c) { return !c.over_time.empty() || !c.share_of_t.empty(); }
bool by_stroke(const Course& c) { return !c.over_stroke.empty() || !c.share_of_s.empty(); }

class CourseCheck {
 public:
  explicit CourseCheck(const Mechanism::Input& in) : in_(in) {}

  std::vector<FieldFault> run() {
    for (const Course& course : in_.courses) check(course);
    for (std::size_t k = 0; k < in_.loads.size(); ++k) check(in_.loads[k], k);
    return std::move(faults_);
  }

 private:
  void add(const Course& course, const char* field, Message message, Message hint = {}) {
    faults_.push_back({path_of("courses", course.name, field), std::move(message), std::move(hint)});
  }

  void check(const planar::Load& load, std::size_t k) {
    if (load.over.empty() || load.course.empty()) return;
    faults_.push_back({path_of(load, k) + ".course", say("'over' and 'course' both give the load curve"),
                       say("leave out one of the two")});
  }

  void check(const Course& course) {
    auto ways = static_cast<int>(!course.over_time.empty()) + static_cast<int>(!course.over_stroke.empty());
    for (const Written& written : formulas()) ways += (course.*written.text).empty() ? 0 : 1;
    if (ways != 1)
      return add(course, "",
                 say("a load curve has its shares in one of five forms, and '{1}' in {2}", course.name.view(),
                     ways == 0 ? "none" : std::to_string(ways)),
                 say("give over_time, over_stroke, share_of_phi, share_of_t or share_of_s"));
    check_points(course, "over_time", course.over_time, [](const auto& p) { return in_si(p.t); });
    check_points(course, "over_stroke", course.over_stroke, [](const auto& p) { return in_si(p.s); });
    for (const Written& written : formulas()) check_formula(course, written);
    check_axis(course);
    check_taken(course);
  }

  template <class Points, class Read>
  void check_points(const Course& course, const char* field, const Points& points, Read x) {
    if (points.size() == 1) return add(course, field, say("one point is not a load curve"), say("add another"));
    const auto late = [&](const auto& a, const auto& b) { return !(x(b) > x(a)); };
    if (std::adjacent_find(points.begin(), points.end(), late) != points.end())
      add(course, field, say("the places of '{1}' must increase", field));
  }

  void check_formula(const Course& course, const Written& written) {
    if ((course.*written.text).empty()) return;
    const auto law = parsed(course, written);
    if (!law) add(course, written.key, law.fault().message, law.fault().hint);
  }

  void check_axis(const Course& course) {
    const bool crank = !in_.crank.joint.empty();
    if (!course.share_of_phi.empty() && !crank)
      add(course, "share_of_phi", say("'share_of_phi' depends on the crank angle, and no crank is given"),
          say("take over_stroke or over_time"));
    const double speed = crank ? in_si(in_.crank.speed) : in_.cylinders.empty() ? 0.0 : in_si(in_.cylinders[0].speed);
    if (by_time(course) && !has_law(in_) && speed == 0.0)
      add(course, "", say("'{1}' is a function of time, but the motion is not given over time", course.name.view()),
          say("give the drive its speed, or a law of motion"));
    const auto& at = in_.crank.at;
    if (by_time(course) && at.size() > 1 && in_si(at[1].angle - at[0].angle) * speed < 0.0)
      add(course, "",
          say("'{1}' is a function of time, and the crank turns against the order of its positions",
              course.name.view()),
          say("give 'at' in the order in which the crank reaches the angles"));
    if (by_stroke(course)) return check_stroke(course);
    if (!course.stroke_of.empty())
      add(course, "stroke_of", say("'{1}' is not a function of a stroke", course.name.view()), say("leave it out"));
  }

  void check_stroke(const Course& course) {
    if (stroke_joint(in_, course.stroke_of) != nullptr) return;
    auto names = names_in(in_.actuators);
    for (const planar::Joint& joint : in_.joints) {
      if (is_guide(joint)) names.emplace_back(joint.name.view());
    }
    if (course.stroke_of.empty())
      return add(course, "stroke_of", say("the stroke that '{1}' depends on is ambiguous", course.name.view()),
                 there_is(names));
    add(course, "stroke_of", say("'{1}' is not a cylinder, prismatic joint or slot", course.stroke_of.view()),
        did_you_mean(course.stroke_of.view(), names, there_is(names)));
  }

  void check_taken(const Course& course) {
    const auto takes = [&](const planar::Load& load) { return load.course == course.name; };
    if (std::none_of(in_.loads.begin(), in_.loads.end(), takes))
      add(course, "", say("no load follows the course '{1}'", course.name.view()),
          say("write course = \"{1}\" in a load or a cylinder, or leave it out", course.name.view()));
  }

  const Mechanism::Input& in_;
  std::vector<FieldFault> faults_;
};

}  // namespace

CourseNow::CourseNow(const Mechanism::Input& in, const Course& course) {
  by_ = by_time(course) ? By::time : by_stroke(course) ? By::stroke : By::crank_angle;
  for (const auto& p : course.over_time) points_.emplace_back(in_si(p.t), p.share);
  for (const auto& p : course.over_stroke) points_.emplace_back(in_si(p.s), p.share);
  for (const Written& written : formulas()) {
    if ((course.*written.text).empty()) continue;
    if (auto law = parsed(course, written)) formula_ = std::move(*law);
  }
  if (by_ == By::stroke) joint_ = index_of(in.joints, stroke_joint(in, course.stroke_of)->name);
}

double CourseNow::argument(const Instant& now, const mechanism::Model& model) const {
  if (by_ == By::crank_angle) return now.crank_angle;
  if (by_ == By::time) return now.time;
  const mechanism::Joint& guide = model.joints[joint_];
  mechanism::PairPlace place;
  mechanism::place(mechanism::shape_of(guide), mechanism::placed_at(now.at, guide.i),
                   mechanism::placed_at(now.at, guide.j), place);
  return dot(place.along, place.apart);
}

double CourseNow::share(double argument) const {
  if (formula_) return formula_->at(argument).value;
  const auto next = std::upper_bound(points_.begin(), points_.end(), argument,
                                     [](double x, const auto& point) { return x < point.first; });
  if (next == points_.begin()) return points_.front().second;
  if (next == points_.end()) return points_.back().second;
  const auto& before = *(next - 1);
  return before.second + (next->second - before.second) * (argument - before.first) / (next->first - before.first);
}

bool CourseNow::reaches(double argument) const {
  if (formula_) return std::abs(share(argument)) <= largest_share;  // not where it has no value
  const double rounding = 1e-9 * (points_.back().first - points_.front().first);
  return argument >= points_.front().first - rounding && argument <= points_.back().first + rounding;
}

LoadCourses::LoadCourses(const Mechanism::Input& in) {
  for (const Course& course : in.courses) all_.emplace_back(in, course);
  for (const planar::Load& load : in.loads)
    of_load_.push_back(load.course.empty() ? -1 : static_cast<int>(index_of(in.courses, load.course)));
}

bool LoadCourses::by_stroke() const {
  return std::any_of(all_.begin(), all_.end(), [](const CourseNow& course) { return course.goes_by_stroke(); });
}

double time_at(const Mechanism::Input& in, std::span<const double> at, std::size_t k) {
  if (has_law(in)) return at[k] - at[0];
  const bool crank = !in.crank.joint.empty();
  const double speed = crank ? in_si(in.crank.speed) : in.cylinders.empty() ? 0.0 : in_si(in.cylinders[0].speed);
  return speed == 0.0 ? 0.0 : (at[k] - at[0]) / speed;
}

std::vector<FieldFault> check_courses(const Mechanism::Input& in) { return CourseCheck(in).run(); }

account::Table course_table(const Mechanism::Input& in) {
  account::Table table{say("Load curves"), {say("name"), say("goes by"), say("share")}, {}};
  for (const Course& course : in.courses) {
    const std::size_t points = course.over_time.size() + course.over_stroke.size();
    std::string shares = points > 0 ? std::to_string(points) + " points" : "";
    for (const Written& written : formulas()) shares += (course.*written.text).view();
    const char* const by = by_time(course) ? "time" : by_stroke(course) ? "stroke" : "crank angle";
    table.rows.push_back({text(course.name), say(by), shares});
  }
  return table;
}

}  // namespace loadpath::planar
