// Whether the points of a course cover the range required by its loads, and its formula has a value there; and whether
// the positions include the largest share of a load.
#include "calculators/mechanism/completion/courses.hpp"

#include "calculators/mechanism/cycle/ranges.hpp"
#include "calculators/mechanism/input/law.hpp"
#include "calculators/mechanism/input/loads.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace loadpath::planar {

namespace {

/// At which positions the course has no share of its own.
std::vector<bool> beyond(const Solved& solved, const CourseNow& course) {
  const Cycle& cycle = solved.proved;
  std::vector<bool> outside(cycle.positions.size());
  for (std::size_t k = 0; k < outside.size(); ++k) {
    if (!cycle.closed[k] && course.goes_by_stroke()) continue;
    const double time = solved.axis == nullptr ? 0.0 : time_at(solved.in, solved.axis->at.numbers(), k);
    const double crank_angle = solved.axis == nullptr ? 0.0 : solved.axis->at[k];
    outside[k] = !course.reaches(course.argument({crank_angle, time, cycle.positions[k]}, solved.given));
  }
  return outside;
}

void judge_courses(const Solved& solved, std::vector<account::Verdict>& verdicts) {
  for (const Course& given : solved.in.courses) {
    const bool by_points = !given.over_time.empty() || !given.over_stroke.empty();
    if (!given.share_of_phi.empty() && (has_law(solved.in) || solved.axis == nullptr))
      continue;  // its angles are not kept
    const std::vector<bool> outside = beyond(solved, CourseNow(solved.in, given));
    const auto count = static_cast<std::size_t>(std::count(outside.begin(), outside.end(), true));
    account::Verdict& v = verdicts.emplace_back(account::Verdict{
        .step = solved.step,
        .symbol = "course_" + text(given.name),
        .meaning = by_points
                       ? say("the points of the course '{1}' reach as far as the mechanism goes", given.name.view())
                       : say("the formula of the course '{1}' has a value and no pole nearby", given.name.view()),
        .value = say("{1} of {2}", std::to_string(outside.size() - count), std::to_string(outside.size())),
        .bound = say("every position"),
        .state = count == 0 ? account::State::pass : account::State::not_covered});
    if (count > 0 && solved.axis != nullptr) v.note = say("not {1}", range_of(outside, true, *solved.axis));
  }
}

/// The largest share of either sign; a share of zero is not a load.
struct Extremes {
  double low = 0.0, high = 0.0;
  void take(double share) { low = std::fmin(low, share), high = std::fmax(high, share); }
};

/// The crank angles that the mechanism takes.
std::vector<double> crank_angles(const Solved& solved) {
  if (solved.axis != nullptr) return solved.axis->at.values();
  return {solved.in.crank.at.empty() ? solved.in.crank.start : solved.in.crank.at[0].angle};
}

/// The shares of a load: of all that is given, and of what the positions show.
struct Shares {
  Extremes there, seen;
};

/// Over the crank angle, by points or a formula, with given crank angles.
Shares shares_by_angle(const Solved& solved, const planar::Load& load, const CourseNow* course) {
  constexpr int steps = 720;
  const double period = 2.0 * pi * solved.in.crank.turns;
  Shares all;
  for (const Share& corner : load.over) all.there.take(corner.share);
  for (int k = 0; course != nullptr && k < steps; ++k) all.there.take(course->share(period * k / steps));
  for (const double angle : crank_angles(solved))
    all.seen.take(course != nullptr ? course->share(angle) : share_at(load, angle, period));
  return all;
}

/// Over the time, by points: those after the last position are not seen.
Shares shares_by_time(const Solved& solved, const CourseNow& course) {
  const double last =
      solved.axis == nullptr ? 0.0 : time_at(solved.in, solved.axis->at.numbers(), solved.axis->at.size() - 1);
  Shares all;
  all.seen.take(course.share(last));
  for (const auto& [t, share] : course.points()) {
    all.there.take(share);
    if (t <= last) all.seen.take(share);
  }
  return all;
}

/// The shares of a load where its positions may miss some; those of a full revolution are checked by their resolution.
std::optional<Shares> shares_of(const Solved& solved, const planar::Load& load, const CourseNow* course) {
  const bool has_given_angles = !solved.in.crank.at.empty() && !has_law(solved.in);
  const bool by_angle = course != nullptr ? course->by() == CourseNow::By::crank_angle : !load.over.empty();
  if (by_angle && has_given_angles) return shares_by_angle(solved, load, course);
  if (course != nullptr && course->by() == CourseNow::By::time && course->formula() == nullptr)
    return shares_by_time(solved, *course);
  return std::nullopt;
}

/// Shares of a load which are larger between or beyond the positions.
std::optional<account::Verdict> unseen_share(const Solved& solved, const LoadCourses& courses, std::size_t n) {
  constexpr double missed = 0.02;
  const planar::Load& load = solved.in.loads[n];
  const auto shares = shares_of(solved, load, courses.of(n));
  if (!shares) return std::nullopt;
  const auto& [there, seen] = *shares;
  const double most = std::max(there.high, -there.low);
  const bool is_low = seen.high >= there.high - missed * most;
  const bool is_seen = is_low && seen.low <= there.low + missed * most;
  return account::Verdict{
      .step = solved.step,
      .symbol = "course_seen_" + std::to_string(n + 1),
      .meaning = say("the positions include the largest share of load {1}",
                     load.name.empty() ? std::to_string(n + 1) : "'" + text(load.name) + "'"),
      .value = account::Quantity{is_low ? seen.low : seen.high, "-", 4},
      .bound = say("{1}", format_quantity(is_low ? there.low : there.high, "-", 4)),
      .state = is_seen ? account::State::pass : account::State::not_covered,
      .note = is_seen ? Message{} : say("add the position of the largest share, or calculate the full cycle")};
}

void judge_all(const Solved& solved, std::vector<account::Verdict>& verdicts) {
  judge_courses(solved, verdicts);
  const LoadCourses courses(solved.in);
  for (std::size_t n = 0; n < solved.in.loads.size(); ++n) {
    if (auto verdict = unseen_share(solved, courses, n)) verdicts.push_back(std::move(*verdict));
  }
}

}  // namespace

constinit const Aspect aspects::courses{.judge = &judge_all};

}  // namespace loadpath::planar
