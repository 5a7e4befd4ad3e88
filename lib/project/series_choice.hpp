// Which series of a solved project are written: names as the user typed them, in which * stands for any characters and
// ? for one.
#pragma once

#include "lib/text/issue.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

struct Project;

class SeriesChoice {
 public:
  /// Every series.
  SeriesChoice() = default;
  /// "drive.M", "links.*.N"; with the step's name in front, "lever.links.*.N", those of that step. None: every series.
  explicit SeriesChoice(std::vector<std::string> patterns) : patterns_(std::move(patterns)) {}

  static SeriesChoice none() { return SeriesChoice({std::string()}); }

  /// Whether the series of this path in this step is one of them.
  [[nodiscard]] bool holds(std::string_view step, std::string_view path) const;
  /// The patterns that choose no series of a solved project, with what they may have meant.
  [[nodiscard]] std::vector<FieldFault> check(const Project& project) const;

 private:
  std::vector<std::string> patterns_;
};

}  // namespace loadpath::project
