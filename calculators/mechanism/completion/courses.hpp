// How loads vary: shares of them over the crank angle, the time or a stroke, by points or a formula.
#pragma once

#include "calculators/mechanism/input/mechanism.hpp"
#include "calculators/mechanism/input/names.hpp"
#include "lib/account/block.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"
#include "lib/quantity/expression/law.hpp"
#include "lib/text/issue.hpp"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace loadpath::planar {

/// Possible arguments of a course, for the mechanism at `at`.
struct Instant {
  double crank_angle = 0.0;  // rad
  double time = 0.0;         // since the first position, s
  const mechanism::Position& at;
};

/// A course, ready for use.
class CourseNow {
 public:
  CourseNow(const Mechanism::Input& in, const Course& course);

  [[nodiscard]] bool goes_by_stroke() const { return by_ == By::stroke; }
  /// Its argument, rad, s or m.
  [[nodiscard]] double argument(const Instant& now, const mechanism::Model& model) const;
  /// Beyond the points the nearest of them: the caller has `reaches` reported.
  [[nodiscard]] double share(double argument) const;
  [[nodiscard]] bool reaches(double argument) const;
  enum class By { crank_angle, time, stroke };
  [[nodiscard]] By by() const { return by_; }
  /// Its formula; null where it has points.
  [[nodiscard]] const Law* formula() const { return formula_ ? &*formula_ : nullptr; }
  [[nodiscard]] const std::vector<std::pair<double, double>>& points() const { return points_; }

 private:
  By by_ = By::time;
  std::vector<std::pair<double, double>> points_;
  std::optional<Law> formula_;
  std::size_t joint_ = 0;  // joint of the stroke
};

/// The courses of all loads.
class LoadCourses {
 public:
  explicit LoadCourses(const Mechanism::Input& in);

  [[nodiscard]] bool by_stroke() const;
  /// Course of a load; null where it has none.
  [[nodiscard]] const CourseNow* of(std::size_t load) const { return of_load_[load] < 0 ? nullptr : &all_[at(load)]; }

 private:
  [[nodiscard]] std::size_t at(std::size_t load) const { return static_cast<std::size_t>(of_load_[load]); }

  std::vector<CourseNow> all_;
  std::vector<int> of_load_;
};

/// The time since the first position, s; `at`: the places of all of them on the axis.
double time_at(const Mechanism::Input& in, std::span<const double> at, std::size_t k);

/// Courses that say nothing or too much, that go by what the mechanism does not have, that no load takes. Needs values.
std::vector<FieldFault> check_courses(const Mechanism::Input& in);

account::Table course_table(const Mechanism::Input& in);

}  // namespace loadpath::planar
