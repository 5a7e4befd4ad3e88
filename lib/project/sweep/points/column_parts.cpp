#include "lib/project/sweep/points/column_parts.hpp"

#include "lib/account/rows.hpp"
#include "lib/project/run/evaluation/left_loads.hpp"
#include "lib/project/sweep/points/bounds.hpp"
#include "lib/quantity/extremes/extremes.hpp"
#include "lib/sweep/nan.hpp"
#include "lib/sweep/statistics/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace loadpath::project {

void ColumnParts::feed(PointColumns& points) {
  in.clear();
  in_series.clear();
  for (ColumnInput& input : fed) {
    input.fill(points, axis);
    if (!input.is_open() && input.may_vary_over_positions()) in_series.push_back(in.size());
    if (!input.is_open()) in.push_back({input.offset(), input.si().data()});
    input.write(points, axis);
  }
  inputs_fed = in.size();
  for (const std::string& path : absent) {  // a component present at another point loads the part there
    const double* const si = points.of(path);
    for (std::size_t point = 0; point < points.count; ++point) {
      if (!std::isnan(si[point])) leave(points, point);
    }
  }
}

/// Leaves points where others of the components that the step does not include act: its modes report them.
void ColumnParts::leave_other_components(PointColumns& points) {
  for (LeftComponent& component : left_components) {
    for (std::size_t point = 0; point < points.count; ++point) {
      points.read(component.path, point, component.value);
      if (acts(component.value) != component.acts) leave(points, point);
    }
  }
}

/// Leaves points where a typed value is more favourable than a bound: it holds back modes there.
void ColumnParts::leave_bolder(PointColumns& points) const {
  if (bounds.empty()) return;
  char* const base = static_cast<char*>(record.data.get());
  for (std::size_t point = 0; point < points.count; ++point) {
    if (is_other(points, point)) continue;
    const std::size_t first = point * positions();
    for (const InputColumn& column : in) std::memcpy(base + column.offset, column.si + first, sizeof(double));
    const bool keeps_all = std::ranges::all_of(
        bounds, [&](const KeptBound& kept) { return keeps(kept, calculator.bound(kept.bound, base, kept.element)); });
    if (!keeps_all) leave(points, point);
  }
}

/// Values of rows at the sizes as they are now, behind the inputs that are fed.
void ColumnParts::provide(PointColumns& points) {
  in.resize(inputs_fed);
  for (Sized& value : sized) {
    value.fill(sizes, positions());
    in.push_back({value.offset(), value.si()});
    for (std::size_t point = 0; point < points.count; ++point) {
      const bool is_beyond = std::isnan(value.si()[point * positions()]);  // the table; in a search it does not fit
      if (is_beyond && !sought) leave(points, point);
    }
  }
}

/// The largest over the positions, refined between them.
Extreme ColumnParts::largest_of(std::span<const double> si, std::size_t point) const {
  if (axis == nullptr) return {si[point], 0.0, 0};
  return maximum(SeriesView{si.subspan(point * positions(), positions()), axis});
}

/// The sizes that follow from the values at the sizes as they are now.
void ColumnParts::read_sizes(PointColumns& points, std::vector<double>& next) {
  next.resize(points.count);
  if (size->is_sought) {
    const bool is_set = inputs_fed > 0 && in[inputs_fed - 1].si == sought->si.data();
    for (std::size_t point = 0; point < points.count; ++point)
      next[point] = is_set ? sought->si[point * positions()] : sizes[point];
    return;
  }
  if (size->fed) {
    const ColumnInput& from = fed[*size->fed];
    for (std::size_t point = 0; point < points.count; ++point) next[point] = largest_of(from.si(), point).value;
    return;
  }
  size_rows.resize(points.count * positions());
  const ResultColumn column{*size->result, size_rows.data()};
  calculator.sweep(record.data.get(), in, {&column, 1}, size_rows.size());
  for (std::size_t point = 0; point < points.count; ++point) next[point] = largest_of(size_rows, point).value;
}

/// A strength falls with the size that it is looked up at, so the size only grows from one round to the next.
void ColumnParts::settle_sizes(PointColumns& points) {
  if (!size || size->fed) return;
  for (int round = 0; round < most_size_rounds; ++round) {
    read_sizes(points, next_sizes);
    bool settled = true;
    for (std::size_t point = 0; point < points.count; ++point) {
      const double next = next_sizes[point];
      if (is_other(points, point) || std::isnan(next) || next == sizes[point]) continue;
      if (round + 1 == most_size_rounds) leave(points, point);  // the single solution reports the alternating sizes
      sizes[point] = next;
      settled = false;
    }
    if (settled) return;
    provide(points);
  }
}

/// Leaves points where every load is zero.
void ColumnParts::leave_unloaded(PointColumns& points) const {
  if (is_loaded || !is_load_told) return;
  if (std::any_of(fed.begin(), fed.end(), [](const ColumnInput& f) { return f.field().is_load && all_act(f.si()); }))
    return;
  for (std::size_t point = 0; point < points.count; ++point) {
    const auto loads = [&](const ColumnInput& f) {
      const auto first = f.si().begin() + static_cast<std::ptrdiff_t>(point * positions());
      return f.field().is_load && std::any_of(first, first + static_cast<std::ptrdiff_t>(positions()), account::acts);
    };
    if (std::none_of(fed.begin(), fed.end(), loads)) leave(points, point);
  }
}

/// A size that follows from the values, or is searched for, starts at zero.
void ColumnParts::start_sizes(PointColumns& points) {
  if (!size) return;
  sizes.assign(points.count, 0.0);
  if (size->fed) read_sizes(points, sizes);
  provide(points);
}

/// Rules, loads that are all zero, sizes, and which modes concern the part.
void ColumnParts::check_inputs(PointColumns& points) {
  leave_unloaded(points);
  if (sought) return search(points);
  start_sizes(points);
  ask(points, rules);
  if (!size || !size->result) return;
  settle_sizes(points);
  ask(points, no_rules);
}

/// Sizes that were found and values of rows, one number a point: others may refer to them.
void ColumnParts::report_found(PointColumns& points) const {
  const auto write_one = [&](const std::string& field, const double* si) {
    const std::string path = step.name() + "." + field;
    if (!points.signatures.contains(path)) return;
    std::vector<double>& values = points.values[path];
    values.resize(points.count);
    for (std::size_t point = 0; point < points.count; ++point) values[point] = si[point * positions()];
  };
  for (const Sized& value : sized) write_one(value.field(), value.si());
  if (sought) write_one(step.searches().front().path, sought->si.data());
}

/// Values beyond the range of numbers are not available; a point with a missing check is handed over.
void ColumnParts::check_number(Read& number, PointColumns& points) const {
  if (sweep::all_finite(number.si)) return;
  const bool is_set_somewhere = number.field->where_set;
  for (std::size_t point = 0; point < points.count; ++point) {
    std::size_t missing = 0;
    for (std::size_t k = 0; k < positions(); ++k) {
      double& x = number.si[point * positions() + k];
      if (std::isinf(x) && !number.field->infinite) x = nan;
      missing += std::isnan(x) ? 1 : 0;
    }
    const bool gone = missing == positions() && is_set_somewhere;  // the calculator has left it unset
    if (number.is_row && missing > 0 && !gone) leave(points, point);
  }
}

void ColumnParts::write(const Read& number, PointColumns& points) const {
  if (!number.is_wanted) return;
  if (axis == nullptr) {
    points.values[number.path] = number.si;
    return;
  }
  SeriesColumn& series = points.series[number.path];
  series.si = number.si;
  series.rounding.assign(points.count, 0.0);
}

void ColumnParts::evaluate_read(std::size_t rows) {
  out.clear();
  for (Read& number : read) {
    number.si.resize(rows);
    number.worst.resize(rows / positions());
    out.push_back({number.offset, number.si.data()});
  }
  calculator.sweep(record.data.get(), in, out, rows);
}

void ColumnParts::run(PointColumns& points) {
  if (!sought) evaluate_read(points.count * positions());  // otherwise the last candidates have been
  for (Read& number : read) {
    check_number(number, points);
    write(number, points);
  }
}

/// A check or a limit at every point: over positions the largest, or the value farthest beyond its bounds.
std::span<const double> ColumnParts::worst_of(Read& number, std::size_t n) {
  if (axis == nullptr) return number.si;
  const bool is_known =
      sought && number.field->role == Role::check && !number.field->is_informative;  // result of a search
  for (std::size_t point = 0; point < n && !is_known; ++point) {
    const auto here = std::span(number.si).subspan(point * positions(), positions());
    number.worst[point] = number.field->role == Role::check ? largest_of(number.si, point).value
                                                            : account::farthest_from(number.field->bounds, here);
  }
  return number.worst;
}

void ColumnParts::fold_rows(const Judging& judged, std::size_t n) {
  fold.clear(n);
  for (const std::size_t which : judged.rows) {
    const FieldInfo& field = *read[which].field;
    const std::span<const double> si = worst_of(read[which], n);
    if (field.role == Role::check)
      fold.take_check(si);
    else
      fold.take_limit(field.bounds, field.is_criterion, si);
  }
}

void ColumnParts::judge(const PointColumns& points, std::vector<account::ModeColumns>& modes) {
  modes.resize(calculator.modes.size());
  for (const Judging& judged : judging) {
    if (judged.rows.empty()) {
      account::leave_mode(applies[judged.mode], judged.unjudged, modes[judged.mode]);
    } else {
      fold_rows(judged, points.count);
      fold.judge(applies[judged.mode], judged.unjudged, modes[judged.mode]);
    }
  }
}

}  // namespace loadpath::project
