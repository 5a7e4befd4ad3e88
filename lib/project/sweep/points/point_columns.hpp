// The values of a project's steps at many points at once: columns of numbers, and of series.
#pragma once

#include "lib/quantity/expression/expression.hpp"
#include "lib/quantity/series.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace loadpath::project {

/// A series at every point: the positions of the first, of the second...
struct SeriesColumn {
  std::vector<double> si;
  std::vector<double> rounding;  // rounding at each point (Value::rounding)
};

/// Columns by full paths, and which points are out of the ordinary.
struct PointColumns {
  std::size_t count = 0;
  std::map<std::string, std::vector<double>, std::less<>> values;
  std::map<std::string, SeriesColumn, std::less<>> series;
  std::map<std::string, double, std::less<>> constants;      // values equal at every point
  std::map<std::string, Signature, std::less<>> signatures;  // signatures of the referenced values
  std::set<std::string, std::less<>> same_everywhere;        // paths of steps that no varied input affects
  std::vector<char> is_other;
  bool axes_differ = false;   // between points: no common series can represent them
  bool speeds_matter = true;  // speeds of axes are read

  /// The values of a path, NaN if it has none.
  const double* of(const std::string& path);
  /// A number or a series at one point, as the step gives it for that point; `value` keeps its memory.
  void read(const std::string& path, std::size_t point, Value& value);
};

/// An expression at one point after another.
class PointExpression {
 public:
  /// `signatures`: of all that it refers to.
  PointExpression(const Expression& expression, const std::map<std::string, Signature, std::less<>>& signatures);

  /// Whether it is made of series.
  [[nodiscard]] bool reads_series() const { return reads_series_; }
  /// Whether it has the same value at every point.
  [[nodiscard]] bool is_same_everywhere(const PointColumns& points) const;
  Value at(PointColumns& points, std::size_t point);
  /// One number per point; without series in lanes. False if it takes a place of a series of numbers.
  bool fill(PointColumns& points, std::span<double> out);

 private:
  const Expression& expression_;
  std::vector<std::pair<std::string, Value>> referred_;
  bool reads_series_ = false;
  std::optional<double> same_;  // the value that it has at every point
};

/// The positions of an axis; 1 if there is none.
std::size_t positions_of(const Axis* axis);

}  // namespace loadpath::project
