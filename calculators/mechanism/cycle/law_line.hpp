// Features that positions must show: a law as a line with corners, over its argument.
#pragma once

#include "calculators/mechanism/cycle/schedule.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::planar {

struct LawLine {
  enum class By { crank_angle, time, law_time, stroke, cam };
  std::string name = {};
  By by = By::crank_angle;
  std::size_t index = 0;                                // index of the course, or of the cam's joint
  std::vector<std::pair<double, double>> corners = {};  // rising
  double period = 0.0;                                  // 0: it does not repeat
  bool has_corners = false;                             // its corners count themselves, not only how far it goes
  bool complete = true;
  double most = 0.0;  // largest magnitude

  [[nodiscard]] double at(double x) const;
  /// The corner most missed by the values at two places, with the error as a share of the largest magnitude; none if
  /// the values suffice.
  struct Miss {
    double x = 0.0, by = 0.0;
  };
  [[nodiscard]] std::optional<Miss> worst_between(double x_0, double x_1, double beyond) const;
};

/// The range of what a law goes by.
struct Reach {
  double low, high;
};

LawLine watched_shares(const planar::Load& load, double period);
LawLine watched_course(const Mechanism::Input& in, std::size_t course, const CourseNow& now, const Reach& reach);
/// The acceleration of a drive that follows a law of time.
std::vector<LawLine> watched_drives(const Mechanism::Input& in);
/// The acceleration of a follower by lift, over the angle of its cam; none where the profile has no law of lift.
std::optional<LawLine> watched_cam(const mechanism::Joint& joint, std::size_t index,
                                   const std::vector<double>& ends_of_segments);

}  // namespace loadpath::planar
