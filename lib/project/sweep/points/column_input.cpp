#include "lib/project/sweep/points/column_input.hpp"

#include "lib/project/run/field_role.hpp"
#include "lib/project/sweep/points/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loadpath::project {

namespace {

Range common_part(Range both, const Range& other) {
  if (other.low > both.low) both.low = other.low, both.low_open = false;
  if (other.high < both.high) both.high = other.high, both.high_open = false;
  return both;
}

/// Beyond common practice, and an empirical value beyond its usual range, a value is weighed
/// (lib/project/run/typed_values.hpp), point by point.
Range accepted_by(const FieldInfo& field) {
  const Range customary = common_part(field.bounds, field.customary);
  return is_empirical(field) ? common_part(customary, field.plausible) : customary;
}

}  // namespace

ColumnInput::ColumnInput(std::string path, const FieldInfo& field, std::size_t offset)
    : path_(std::move(path)), field_(&field), offset_(offset), accepted_(accepted_by(field)) {}

ColumnInput::ColumnInput(std::string path, const FieldInfo& field, std::size_t offset, const Expression& expression,
                         bool is_open, const PointColumns& points)
    : path_(std::move(path)),
      field_(&field),
      offset_(offset),
      accepted_(accepted_by(field)),
      is_open_(is_open),
      expression_(std::in_place, expression, points.signatures) {}

ColumnInput::ColumnInput(std::string path, const FieldInfo& field, std::size_t offset,
                         const std::vector<std::string>& companions, const PointColumns& points)
    : path_(std::move(path)), field_(&field), offset_(offset), accepted_(accepted_by(field)) {
  for (const std::string& companion : companions) {
    const auto signature = points.signatures.find(companion);
    if (signature != points.signatures.end() && signature->second.dimension == field.dimension)
      companions_.push_back({companion, {signature->second, {}}});
  }
}

void ColumnInput::accept_up_to(double highest) {
  accepted_ = common_part(accepted_, {.low = accepted_.low, .high = highest, .low_open = accepted_.low_open});
}

void ColumnInput::fill(PointColumns& points, const Axis* axis) {
  const std::size_t positions = positions_of(axis);
  si_.resize(points.count * positions);
  rounding_.assign(points.count, 0.0);
  if (!companions_.empty())
    fill_from_companions(points, axis);
  else if (expression_)
    fill_from_expression(points, positions);
  else
    fill_from_sweep(points, positions);
  if (is_open_ || !all_within(accepted_, si_)) refuse(points, positions);
}

void ColumnInput::fill_from_sweep(PointColumns& points, std::size_t positions) {
  const std::vector<double>& values = points.values.find(path_)->second;
  spread({values.data(), points.count}, positions);
}

/// The same at all positions of a point.
void ColumnInput::spread(std::span<const double> of_points, std::size_t positions) {
  if (positions == 1) {
    std::ranges::copy(of_points, si_.begin());
    return;
  }
  for (std::size_t point = 0; point < of_points.size(); ++point)
    std::fill_n(si_.begin() + static_cast<std::ptrdiff_t>(point * positions), positions, of_points[point]);
}

void ColumnInput::fill_from_expression(PointColumns& points, std::size_t positions) {
  if (expression_->reads_series() && expression_->is_same_everywhere(points)) {
    if (same_.si.empty()) same_ = expression_->at(points, 0);
    for (std::size_t point = 0; point < points.count; ++point) put(point, same_, positions);
    return;
  }
  if (expression_->reads_series()) {
    for (std::size_t point = 0; point < points.count; ++point) {
      if (points.is_other[point] == 0) put(point, expression_->at(points, point), positions);
    }
    return;
  }
  std::vector<double>& to = positions == 1 ? si_ : of_points_;
  to.resize(points.count);
  if (!expression_->fill(points, to)) std::fill(points.is_other.begin(), points.is_other.end(), char{1});
  if (positions > 1) spread(of_points_, positions);
}

void ColumnInput::put(std::size_t point, const Value& value, std::size_t positions) {
  const auto first = si_.begin() + static_cast<std::ptrdiff_t>(point * positions);
  rounding_[point] = value.rounding;
  if (value.is_series())
    std::ranges::copy(value.si, first);
  else
    std::fill_n(first, positions, value.si[0]);
}

/// The largest of several load components at each position.
void ColumnInput::fill_from_companions(PointColumns& points, const Axis* axis) {
  const std::size_t positions = positions_of(axis);
  std::fill(si_.begin(), si_.end(), 0.0);
  for (std::size_t point = 0; point < points.count; ++point) {
    if (points.is_other[point] != 0) continue;
    std::size_t there = 0;
    for (auto& [path, value] : companions_) {
      points.read(path, point, value);
      if (std::ranges::all_of(value.si, [](double x) { return std::isnan(x); })) continue;
      ++there;
      const bool over_it = value.is_series() && value.signature.axis == axis;
      const double same = over_it ? 0.0 : std::abs(value.is_series() ? largest(value).value : value.si[0]);
      for (std::size_t k = 0; k < positions; ++k) {
        const double size = over_it ? std::abs(value.si[k]) : same;
        double& most = si_[point * positions + k];
        if (size > most || std::isnan(size)) most = size;  // NaN stays
      }
    }
    if (there == 0) points.is_other[point] = 1;  // no load component
  }
}

void ColumnInput::refuse(PointColumns& points, std::size_t positions) const {
  for (std::size_t i = 0; i < si_.size(); ++i) {
    const bool known = !std::isnan(si_[i]);
    if (known == is_open_ || (known && !accepted_.holds(si_[i]))) points.is_other[i / positions] = 1;
  }
}

void ColumnInput::write(PointColumns& points, const Axis* axis) const {
  const auto signature = points.signatures.find(path_);
  if (signature == points.signatures.end() || (!expression_ && companions_.empty())) return;  // otherwise it is there
  if (signature->second.axis != nullptr) {
    points.series[path_] = {si_, rounding_};
    return;
  }
  std::vector<double>& values = points.values[path_];
  values.resize(points.count);
  const std::size_t positions = positions_of(axis);
  for (std::size_t point = 0; point < points.count; ++point) values[point] = si_[point * positions];
}

}  // namespace loadpath::project
