// Whether the points of a course cover the range required by its loads, and its formula has a value there.
#include "calculators/mechanism/completion/courses.hpp"

#include "calculators/mechanism/cycle/ranges.hpp"
#include "calculators/mechanism/results/aspect.hpp"

#include <algorithm>
#include <vector>

namespace loadpath::planar {

namespace {

/// At which positions the course has no share of its own.
std::vector<bool> beyond(const Solved& solved, const CourseNow& course) {
  const Cycle& cycle = solved.proved;
  std::vector<bool> outside(cycle.positions.size());
  for (std::size_t k = 0; k < outside.size(); ++k) {
    if (!cycle.closed[k] && course.goes_by_stroke()) continue;
    const double time = solved.axis == nullptr ? 0.0 : time_at(solved.in, solved.axis->at, k);
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
                       : say("the formula of the course '{1}' has a value, and no pole near by", given.name.view()),
        .value = say("{1} of {2}", std::to_string(outside.size() - count), std::to_string(outside.size())),
        .bound = say("every position"),
        .state = count == 0 ? account::State::pass : account::State::not_covered});
    if (count > 0 && solved.axis != nullptr) v.note = say("not {1}", range_of(outside, true, *solved.axis));
  }
}

}  // namespace

constinit const Aspect aspects::courses{.judge = &judge_courses};

}  // namespace loadpath::planar
