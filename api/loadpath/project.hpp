// A project file: read, solved, swept.
#pragma once

#include <cstdint>
#include <loadpath/solution.hpp>
#include <loadpath/sweep.hpp>
#include <string>
#include <vector>

namespace loadpath::api {

/// Keeps the text; every call reads it again, so that several threads may use one object.
class Project {
 public:
  /// An Error with every fault of the text.
  static Project read(std::string text, std::string name = "project");
  static Project open(const std::string& file);

  [[nodiscard]] const std::string& title() const { return title_; }
  [[nodiscard]] const std::vector<std::string>& steps() const { return steps_; }
  /// Inputs that take many values: "crankshaft.T".
  [[nodiscard]] const std::vector<std::string>& swept() const { return swept_; }

  [[nodiscard]] Solution solve(bool strict = false) const;
  /// One point of its sweep, counted from 0, as a separate design.
  [[nodiscard]] Solution solve_point(std::uint64_t point, const SweepOptions& points = {}) const;
  [[nodiscard]] Sweep sweep(const SweepOptions& options = {}) const;

 private:
  Project(std::string text, std::string name);

  std::string text_, name_, title_;
  std::vector<std::string> steps_, swept_;
};

}  // namespace loadpath::api
