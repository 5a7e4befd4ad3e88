// Rules, and which modes concern the part, at the points. What no input that varies over the positions decides is asked
// once a point.
#include "lib/project/sweep/points/column_parts.hpp"

#include <algorithm>
#include <cstring>

namespace loadpath::project {

/// With the inputs as they are now.
void ColumnParts::ask(PointColumns& points, std::span<const char> asked_rules) {
  applies.resize(calculator.modes.size());
  applies_at.clear();
  for (std::vector<Applies>& of_mode : applies) {
    of_mode.assign(points.count, Applies::no);
    applies_at.push_back(of_mode.data());
  }
  survey_first_positions(points, asked_rules);
  if (axis == nullptr) return;
  find_open_modes(points);
  survey_positions(points, asked_rules);
}

/// Only rules: before a search nothing is assessed.
void ColumnParts::ask_rules(PointColumns& points, std::span<const char> asked_rules) {
  applies_at.clear();
  open_modes.clear();
  survey_first_positions(points, asked_rules);
  if (axis != nullptr) survey_positions(points, asked_rules);
}

/// Of the requested rules those that the positions of a point decide, or the others; false if there are none.
bool ColumnParts::keep_rules(std::span<const char> asked_rules, bool over_positions) {
  asked_now.assign(asked_rules.begin(), asked_rules.end());
  for (std::size_t rule = 0; rule < asked_now.size(); ++rule)
    if ((series_rules[rule] != 0) != over_positions) asked_now[rule] = 0;
  return std::ranges::find(asked_now, char{1}) != asked_now.end();
}

/// Rules that every position decides alike, and modes: most that apply do so at the first position.
void ColumnParts::survey_first_positions(PointColumns& points, std::span<const char> asked_rules) {
  if (axis == nullptr) {
    calculator.survey(record.data.get(), in, asked_rules, applies_at, points.count, points.is_other.data());
    return;
  }
  if (!keep_rules(asked_rules, false) && applies_at.empty()) return;
  first_inputs.resize(in.size());
  columns.clear();
  for (std::size_t k = 0; k < in.size(); ++k) {
    first_inputs[k].resize(points.count);
    for (std::size_t point = 0; point < points.count; ++point) first_inputs[k][point] = in[k].si[point * positions()];
    columns.push_back({in[k].offset, first_inputs[k].data()});
  }
  calculator.survey(record.data.get(), columns, asked_now, applies_at, points.count, points.is_other.data());
}

void ColumnParts::find_open_modes(const PointColumns& points) {
  open_modes.clear();
  for (std::size_t mode = 0; mode < applies.size(); ++mode) {
    const ModeInfo& info = calculator.modes[mode];
    if (info.is_fixed || (info.is_independent_of_loads && is_series_of_loads)) continue;
    bool is_open = false;
    for (std::size_t point = 0; point < points.count; ++point)
      is_open = is_open || (!is_other(points, point) && applies[mode][point] != Applies::yes);
    if (is_open) open_modes.push_back(mode);
  }
}

/// A rule is violated at a point if it is so at any position.
void ColumnParts::survey_positions(PointColumns& points, std::span<const char> asked_rules) {
  if (!keep_rules(asked_rules, true) && open_modes.empty()) return;
  applies_over.resize(applies.size());
  applies_at.assign(open_modes.empty() ? 0 : applies.size(), nullptr);
  for (const std::size_t mode : open_modes) {
    applies_over[mode].resize(positions());
    applies_at[mode] = applies_over[mode].data();
  }
  for (std::size_t point = 0; point < points.count; ++point)
    if (!is_other(points, point)) survey_positions_of(points, point);
}

namespace {

/// Without a branch, for the compiler to put into lanes.
Applies applies_anywhere(std::span<const Applies> positions) {
  int yes = 0, unseen = 0;
  for (const Applies at : positions) {
    yes |= static_cast<int>(at == Applies::yes);
    unseen |= static_cast<int>(at == Applies::unseen);
  }
  return yes != 0 ? Applies::yes : unseen != 0 ? Applies::unseen : Applies::no;
}

}  // namespace

/// A mode applies at a point if it does at any position.
void ColumnParts::survey_positions_of(PointColumns& points, std::size_t point) {
  const std::size_t start = point * positions();
  char* const base = static_cast<char*>(record.data.get());
  for (const InputColumn& column : in) std::memcpy(base + column.offset, column.si + start, sizeof(double));
  columns.clear();
  for (const std::size_t k : in_series) columns.push_back({in[k].offset, in[k].si + start});
  breaks.assign(positions(), 0);
  calculator.survey(base, columns, asked_now, applies_at, positions(), breaks.data());
  if (std::ranges::find(breaks, char{1}) != breaks.end()) leave(points, point);
  for (const std::size_t mode : open_modes) applies[mode][point] = applies_anywhere(applies_over[mode]);
}

}  // namespace loadpath::project
