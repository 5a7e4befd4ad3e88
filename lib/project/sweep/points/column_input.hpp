// Inputs of a step that vary from point to point: of the sweep, by expressions, with load components.
#pragma once

#include "lib/project/run/calculator_step.hpp"
#include "lib/project/sweep/points/point_columns.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace loadpath::project {

class ColumnInput {
 public:
  /// An input of the sweep.
  ColumnInput(std::string path, const FieldInfo& field, std::size_t offset);
  /// `is_open`: a record of another step leaves it out.
  ColumnInput(std::string path, const FieldInfo& field, std::size_t offset, const Expression& expression, bool is_open,
              const PointColumns& points);
  /// The largest of the load components of other inputs.
  ColumnInput(std::string path, const FieldInfo& field, std::size_t offset, const std::vector<std::string>& companions,
              const PointColumns& points);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const FieldInfo& field() const { return *field_; }
  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[nodiscard]] bool is_open() const { return is_open_; }
  [[nodiscard]] bool may_vary_over_positions() const {
    return !companions_.empty() || (expression_ && expression_->reads_series());
  }
  /// At every position of every point.
  [[nodiscard]] const std::vector<double>& si() const { return si_; }

  /// Above this a point is another's.
  void accept_up_to(double highest);
  /// Over the positions of `axis`, which is null if there is one. Points where it has no value, or one that its
  /// field refuses or that is unusual, become another's.
  void fill(PointColumns& points, const Axis* axis);
  /// Publishes the values that others may refer to.
  void write(PointColumns& points, const Axis* axis) const;

 private:
  void fill_from_sweep(PointColumns& points, std::size_t positions);
  void fill_from_expression(PointColumns& points, std::size_t positions);
  void fill_from_companions(PointColumns& points, const Axis* axis);
  void put(std::size_t point, const Value& value, std::size_t positions);
  void spread(std::span<const double> of_points, std::size_t positions);
  void refuse(PointColumns& points, std::size_t positions) const;

  std::string path_;  // full
  const FieldInfo* field_;
  std::size_t offset_;  // in the record
  Range accepted_;      // outside of it a point is another's
  bool is_open_ = false;
  std::optional<PointExpression> expression_;
  std::vector<std::pair<std::string, Value>> companions_;
  Value same_;  // of an expression that has one value for all points
  std::vector<double> si_;
  std::vector<double> of_points_;
  std::vector<double> rounding_;  // rounding at each point
};

}  // namespace loadpath::project
