// Inputs that rows of tables give, at the size of each point: the yield strength of a steel falls with the diameter.
#pragma once

#include "lib/calculator/calculator.hpp"
#include "lib/project/run/calculator_step.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace loadpath::project {

/// One such input. Values independent of the size are in the record.
class Sized {
 public:
  /// For a row that has values by size.
  Sized(const Provided& provided, std::size_t offset);
  /// Whether a row's values depend on the lookup size.
  static bool is_one(const Provided& provided);

  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[nodiscard]] const std::string& field() const { return field_; }
  [[nodiscard]] const double* si() const { return si_.data(); }
  /// `sizes`: of each point, for so many positions.
  void fill(std::span<const double> sizes, std::size_t positions);

 private:
  struct Class {
    double size_max, si;
  };
  [[nodiscard]] double at(double size) const;

  std::string field_;
  std::size_t offset_;
  std::vector<Class> classes_;
  std::vector<double> si_;
};

}  // namespace loadpath::project
