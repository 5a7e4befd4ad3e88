#include "calculators/mechanism/cycle/between.hpp"

#include "calculators/mechanism/cycle/law_line.hpp"
#include "calculators/mechanism/input/law.hpp"
#include "calculators/mechanism/input/names.hpp"
#include "calculators/mechanism/input/profiles.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace loadpath::planar {

namespace {

using Places = std::vector<double>;
using By = LawLine::By;

constexpr std::size_t most_inserted = 7200;  // as many positions as can be requested
constexpr std::size_t most_counted = 200'000;
constexpr double least_apart = 1e-8;  // distance of two positions, parts of the requested steps
constexpr double waves_shown = 16.0;  // positions in a segment of a cam that show its acceleration within 2 %

/// Arguments of laws, at every place; the last is the end of the cycle.
struct Arguments {
  std::vector<double> crank_angle, time, law_time;
  std::vector<std::vector<double>> stroke, cam;  // by course, by joint
};

class Inserting {
 public:
  Inserting(const Mechanism::Input& in, const mechanism::Model& model, bool redundant, const Assembled& assembled)
      : in_(in), model_(model), redundant_(redundant), assembled_(assembled), courses_(in.courses.size()) {
    for (std::size_t c = 0; c < in.courses.size(); ++c) courses_[c].emplace_back(in, in.courses[c]);
    places_.resize(positions_of(in));
    std::iota(places_.begin(), places_.end(), 0.0);
    const bool strokes = std::any_of(courses_.begin(), courses_.end(),
                                     [](const auto& course) { return course.front().goes_by_stroke(); });
    closes_ = strokes || has_short_segments(in);
  }

  Between run() {
    Between found;
    found.places = places_;
    if (places_.size() < 2) return found;
    find_arguments();
    watch();
    if (watched_.empty()) return found;
    const std::size_t asked = places_.size();
    // If arguments require closing the mechanism, positions beyond the solvable number are not counted.
    const std::size_t most = closes_ ? asked + most_inserted : most_counted;
    while (insert_once() && places_.size() <= most) find_arguments();
    const bool too_many = places_.size() > asked + most_inserted || !in_.crank.at.empty();
    if (too_many && places_.size() > asked) {
      found.missed = first_missed_;
      found.needed = places_.size() > most ? 0 : places_.size();
    } else {
      found.inserted = places_.size() - asked;
      found.places = places_;
    }
    const auto lost = std::find_if(watched_.begin(), watched_.end(), [](const LawLine& w) { return !w.complete; });
    if (lost != watched_.end()) found.missed = lost->name, found.needed = 0;
    return found;
  }

 private:
  /// With the end of the cycle behind the last.
  [[nodiscard]] Places with_end() const {
    Places all = places_;
    if (is_whole_turn(in_)) all.push_back(static_cast<double>(positions_of(in_)));
    return all;
  }

  void find_arguments() {
    const Places all = with_end();
    const Schedule schedule = schedule_of(in_, assembled_, all);
    arguments_ = {};
    arguments_.stroke.resize(courses_.size());
    arguments_.cam.resize(model_.joints.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double angle = schedule.drives[k].empty() ? 0.0 : schedule.drives[k][0].coordinate - schedule.turns;
      arguments_.crank_angle.push_back(angle);
      arguments_.time.push_back(time_at(in_, schedule.at, k));
      arguments_.law_time.push_back(schedule.at[k]);
    }
    if (closes_) close(schedule);
  }

  /// The places of strokes and cams follow from the positions of the links.
  void close(const Schedule& schedule) {
    mechanism::ReleasedSystem system(model_, redundant_);
    (void)system.assemble();  // the solver of the cycle has reported a failure
    const bool statics = leaves_out_inertia(in_);
    mechanism::Position place = mechanism::blank_position(model_);
    for (std::size_t k = 0; k < schedule.drives.size(); ++k) {
      const auto status = system.solve(schedule.drives[k], place, statics);
      const bool known = status == mechanism::Status::closed || status == mechanism::Status::jams;
      for (std::size_t c = 0; c < courses_.size(); ++c) {
        if (!courses_[c].front().goes_by_stroke()) continue;
        arguments_.stroke[c].push_back(known ? courses_[c].front().argument({0.0, 0.0, place}, model_)
                                             : last_of(arguments_.stroke[c]));
      }
      for (std::size_t j = 0; j < model_.joints.size(); ++j) {
        if (model_.joints[j].kind != mechanism::JointKind::cam) continue;
        auto& angles = arguments_.cam[j];
        const double touch = place.reactions[j].touch;
        const double before = last_of(angles);
        angles.push_back(known ? before + std::remainder(touch - before, 2.0 * pi) : before);
      }
    }
  }
  static double last_of(const std::vector<double>& values) { return values.empty() ? 0.0 : values.back(); }

  void watch() {
    const double period = 2.0 * pi * in_.crank.turns;
    std::vector<bool> taken(courses_.size());
    for (const planar::Load& load : in_.loads) {
      if (load.over.size() > 1 && has_crank(in_)) watched_.push_back(watched_shares(load, period));
      if (!load.course.empty()) taken[index_of(in_.courses, load.course)] = true;
    }
    for (std::size_t c = 0; c < courses_.size(); ++c) {
      if (taken[c]) watched_.push_back(watched_course(in_, c, courses_[c].front(), reach_of(c)));
    }
    for (LawLine& drive : watched_drives(in_)) watched_.push_back(std::move(drive));
    if (has_short_segments(in_)) watch_cams();
    if (!in_.crank.at.empty() && !has_law(in_)) {  // given angles are kept
      for (LawLine& watched : watched_) watched.has_corners = false;
    }
  }

  void watch_cams() {
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
      if (model_.joints[j].kind != mechanism::JointKind::cam) continue;
      const CamProfile* const profile = find_profile(in_, in_.joints[j].profile);
      std::vector<double> ends;
      double to = 0.0;
      if (profile != nullptr) {
        for (const auto& segment : profile->segments) ends.push_back(to += segment.angle);
      }
      if (auto cam = watched_cam(model_.joints[j], j, ends)) watched_.push_back(std::move(*cam));
    }
  }

  [[nodiscard]] Reach reach_of(std::size_t course) const {
    using Goes = CourseNow::By;
    const Goes by = courses_[course].front().by();
    const auto& x = by == Goes::crank_angle ? arguments_.crank_angle
                    : by == Goes::time      ? arguments_.time
                                            : arguments_.stroke[course];
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    return {*low, *high};
  }

  [[nodiscard]] const std::vector<double>& argument_of(const LawLine& watched) const {
    switch (watched.by) {
      case By::crank_angle:
        return arguments_.crank_angle;
      case By::time:
        return arguments_.time;
      case By::law_time:
        return arguments_.law_time;
      case By::stroke:
        return arguments_.stroke[watched.index];
      case By::cam:
        return arguments_.cam[watched.index];
    }
    return arguments_.crank_angle;
  }

  /// By how much the variable of a law may overshoot its values at two neighbouring positions.
  [[nodiscard]] double swing(const LawLine& watched, const std::vector<double>& x, std::size_t k) const {
    const bool even = !has_law(in_) && (watched.by == By::crank_angle || watched.by == By::time);
    if (even || watched.by == By::law_time || x.size() < 4) return 0.0;
    const double before = k > 0 ? x[k - 1] : x[k], after = k + 2 < x.size() ? x[k + 2] : x[k + 1];
    return 0.1 * std::abs(before - x[k] - x[k + 1] + after);
  }

  /// Inserts the most missed place between every two places; false if none is missing.
  bool insert_once() {
    const Places all = with_end();
    Places more;
    for (std::size_t k = 0; k + 1 < all.size(); ++k) {
      if (all[k + 1] - all[k] <= 2.0 * least_apart) continue;
      std::optional<double> place;
      double most = 0.0;
      for (const LawLine& watched : watched_) {
        const std::vector<double>& x = argument_of(watched);
        const auto miss = watched.worst_between(x[k], x[k + 1], swing(watched, x, k));
        if (!miss || miss->by <= most) continue;
        most = miss->by;
        const double share = (miss->x - x[k]) / (x[k + 1] - x[k]);
        place = all[k] + (share > 0.0 && share < 1.0 ? share : 0.5) * (all[k + 1] - all[k]);
        if (first_missed_.empty()) first_missed_ = watched.name;
      }
      if (place && *place - all[k] > least_apart && all[k + 1] - *place > least_apart) more.push_back(*place);
    }
    if (more.empty()) return false;
    places_.insert(places_.end(), more.begin(), more.end());
    std::sort(places_.begin(), places_.end());
    return true;
  }

  const Mechanism::Input& in_;
  const mechanism::Model& model_;
  bool redundant_;
  const Assembled& assembled_;
  std::vector<std::vector<CourseNow>> courses_;  // one each: a course is not copied
  bool closes_ = false;
  Places places_;
  Arguments arguments_;
  std::vector<LawLine> watched_;
  std::string first_missed_;
};

}  // namespace

bool has_short_segments(const Mechanism::Input& in) {
  if (in.profiles.empty()) return false;
  const auto* const joint = find_named(in.joints, in.crank.joint);
  const auto cam_of = [](const planar::Joint& cam) { return cam.links.second; };
  const double step = is_whole_turn(in) ? 2.0 * pi * in.crank.turns / in.crank.positions : 2.0 * pi;
  return std::any_of(in.joints.begin(), in.joints.end(), [&](const planar::Joint& cam) {
    const CamProfile* const profile = is_cam(cam.type) ? find_profile(in, cam.profile) : nullptr;
    if (profile == nullptr) return false;
    const bool driven =
        joint != nullptr && ((joint->links.first == cam_of(cam) && joint->links.second.view() == "ground") ||
                             (joint->links.second == cam_of(cam) && joint->links.first.view() == "ground"));
    return std::any_of(profile->segments.begin(), profile->segments.end(), [&](const CamProfile::Segment& segment) {
      return rise_of(*profile, segment) != 0.0 && (!driven || segment.angle < waves_shown * step);
    });
  });
}

Between places_between(const Mechanism::Input& in, const mechanism::Model& model, bool redundant,
                       const Assembled& assembled) {
  return Inserting(in, model, redundant, assembled).run();
}

}  // namespace loadpath::planar
