#include "lib/project/sweep/points/point_columns.hpp"

#include "lib/sweep/nan.hpp"

#include <algorithm>

namespace loadpath::project {

const double* PointColumns::of(const std::string& path) {
  const auto known = values.find(path);
  if (known != values.end()) return known->second.data();
  const auto constant = constants.find(path);
  const double same = constant == constants.end() ? nan : constant->second;
  return values.emplace(path, std::vector<double>(count, same)).first->second.data();
}

void PointColumns::read(const std::string& path, std::size_t point, Value& value) {
  const auto known = series.find(path);
  if (known == series.end()) {
    value.si.assign(1, of(path)[point]);
    return;
  }
  const std::size_t positions = positions_of(value.signature.axis);
  const auto first = known->second.si.begin() + static_cast<std::ptrdiff_t>(point * positions);
  value.si.assign(first, first + static_cast<std::ptrdiff_t>(positions));
  value.rounding = known->second.rounding[point];
}

PointExpression::PointExpression(const Expression& expression,
                                 const std::map<std::string, Signature, std::less<>>& signatures)
    : expression_(expression) {
  for (const Expression::Reference& reference : expression.references()) {
    const auto signature = signatures.find(reference.path);
    referred_.push_back({reference.path, {signature == signatures.end() ? Signature{} : signature->second, {}}});
    reads_series_ = reads_series_ || referred_.back().second.is_series();
  }
}

bool PointExpression::is_same_everywhere(const PointColumns& points) const {
  return std::all_of(referred_.begin(), referred_.end(),
                     [&](const auto& r) { return points.same_everywhere.contains(r.first); });
}

Value PointExpression::at(PointColumns& points, std::size_t point) {
  for (auto& [path, value] : referred_) points.read(path, point, value);
  return expression_.evaluate([&](const std::string& path) -> const Value& {
    return std::find_if(referred_.begin(), referred_.end(), [&](const auto& r) { return r.first == path; })->second;
  });
}

bool PointExpression::fill(PointColumns& points, std::span<double> out) {
  if (!reads_series_) return expression_.evaluate([&](const std::string& path) { return points.of(path); }, out);
  if (is_same_everywhere(points)) {
    const auto first = std::ranges::find(points.is_other, char{0});
    if (first == points.is_other.end()) return true;
    if (!same_) same_ = at(points, static_cast<std::size_t>(first - points.is_other.begin())).si[0];
    std::ranges::fill(out, *same_);
    return true;
  }
  for (std::size_t point = 0; point < out.size(); ++point)
    out[point] = points.is_other[point] != 0 ? nan : at(points, point).si[0];
  return true;
}

std::size_t positions_of(const Axis* axis) { return axis == nullptr ? 1 : axis->at.size(); }

}  // namespace loadpath::project
