// The series of a solved project to be written: names as the user typed them, in which * matches any characters and ?
// one character.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

/// Whether a name is of this pattern.
bool fits_pattern(std::string_view name, std::string_view pattern);
/// Whether the path matches, by itself or after the name of its step.
bool fits_pattern(std::string_view step, std::string_view path, std::string_view pattern);

class SeriesChoice {
 public:
  /// Every series.
  SeriesChoice() = default;
  /// "drive.M", "links.*.N"; with the step's name in front, "lever.links.*.N", those of that step. None: every series.
  explicit SeriesChoice(std::vector<std::string> patterns) : patterns_(std::move(patterns)) {}

  static SeriesChoice none() { return SeriesChoice({std::string()}); }

  /// Whether the series of this path in this step is one of them.
  [[nodiscard]] bool holds(std::string_view step, std::string_view path) const;
  [[nodiscard]] const std::vector<std::string>& patterns() const { return patterns_; }

 private:
  std::vector<std::string> patterns_;
};

}  // namespace loadpath::project
