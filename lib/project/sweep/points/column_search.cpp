// A size that is searched for in a stock, at every point: the smallest with which every check passes.
#include "lib/account/rows.hpp"
#include "lib/project/sweep/points/column_parts.hpp"
#include "lib/sweep/nan.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace loadpath::project {

namespace {

/// Whether a sizing has found something for an input left open.
bool is_kept_result(double found) { return !(found == 0.0 || std::isnan(found)); }

/// Without a branch, for the compiler to put into lanes.
bool any_kept(std::span<const double> found) {
  std::uint64_t any = 0;
  for (const double x : found) any |= static_cast<std::uint64_t>(x == x) & static_cast<std::uint64_t>(x != 0.0);
  return any != 0;
}

}  // namespace

/// The start of a search: the minimum size, computed without one.
void ColumnParts::find_first_candidates(PointColumns& points) {
  SearchedSize& wanted = *sought;
  const double found = wanted.leaf.get();
  wanted.leaf.set(nan);
  start_sizes(points);
  if (rules != no_rules) ask_rules(points, rules);
  settle_sizes(points);
  wanted.at.assign(points.count, {});
  if (wanted.least != nullptr) {
    run_for_least(points);
    for (std::size_t point = 0; point < points.count; ++point) {
      const double least = largest_of(size_rows, point).value;
      const auto start = std::lower_bound(wanted.stock.begin(), wanted.stock.end(), account::least_candidate(least));
      wanted.at[point].now = static_cast<std::size_t>(start - wanted.stock.begin());
      if (std::isnan(least) || start == wanted.stock.end()) leave(points, point);
    }
  }
  wanted.leaf.set(found);
  for (std::size_t point = 0; point < wanted.least_of_body.size(); ++point) {
    const double least = account::least_candidate(wanted.least_of_body[point]);
    const auto start = std::lower_bound(wanted.stock.begin(), wanted.stock.end(), least);
    wanted.at[point].now = std::max(wanted.at[point].now, static_cast<std::size_t>(start - wanted.stock.begin()));
    if (start == wanted.stock.end()) leave(points, point);
  }
}

/// The minimum size over all rows. Results of the sizing for inputs left open would be kept when the size is rounded
/// up: such a point is handed over.
void ColumnParts::run_for_least(PointColumns& points) {
  const std::size_t rows = points.count * positions();
  size_rows.resize(rows);
  out.assign(1, {sought->least_offset, size_rows.data()});
  sought->of_kept.resize(sought->kept.size(), {});
  for (std::size_t k = 0; k < sought->kept.size(); ++k) {
    sought->of_kept[k].resize(rows);
    out.push_back({sought->kept[k], sought->of_kept[k].data()});
  }
  calculator.sweep(record.data.get(), in, out, rows);
  for (const std::vector<double>& found : sought->of_kept) {
    if (!any_kept(found)) continue;
    for (std::size_t row = 0; row < rows; ++row) {
      if (is_kept_result(found[row])) leave(points, row / positions());
    }
  }
}

/// Sets the size of every point; the results are those of the last candidates, which pass.
void ColumnParts::search(PointColumns& points) {
  SearchedSize& wanted = *sought;
  find_first_candidates(points);
  wanted.si.resize(points.count * positions());
  in.resize(inputs_fed);
  in.push_back({wanted.offset, wanted.si.data()});
  ++inputs_fed;
  for (bool again = true; again;) {
    again = false;
    for (std::size_t point = 0; point < points.count; ++point) {
      const double tried = wanted.stock[std::min(wanted.at[point].now, wanted.stock.size() - 1)];
      std::fill_n(wanted.si.data() + point * positions(), positions(), tried);
    }
    start_sizes(points);
    settle_sizes(points);
    evaluate_read(points.count * positions());
    ask_candidates(points);
    for (std::size_t point = 0; point < points.count; ++point) {
      if (is_other(points, point) || is_found(point)) continue;
      again = true;
      if (wanted.at[point].now == wanted.stock.size()) leave(points, point);
    }
  }
}

/// Whether the candidate of a point is the result; otherwise takes the next one to be tried. As in the search of a
/// single design: the first with no failure that a size changes. A point without a result is handed over.
bool ColumnParts::is_found(std::size_t point) {
  if (fits(point)) return true;
  ++sought->at[point].now;
  return false;
}

/// Finds the candidates that violate a rule, and the modes that concern the part with them.
void ColumnParts::ask_candidates(PointColumns& points) {
  const std::vector<char> others = points.is_other;
  ask(points, sought->rules);
  sought->breaks.resize(points.count);
  for (std::size_t point = 0; point < points.count; ++point)
    sought->breaks[point] = static_cast<char>(points.is_other[point] != others[point]);
  points.is_other = others;
}

bool ColumnParts::fits(std::size_t point) {
  return sought->breaks[point] == 0 && std::all_of(read.begin(), read.end(), [&](Read& number) {
           return !number.is_row || number.field->is_informative || number.field->is_sizeless || is_kept(number, point);
         });
}

bool ColumnParts::is_kept(Read& number, std::size_t point) {
  const FieldInfo& field = *number.field;
  if (field.role == Role::check) {
    const double most = largest_of(number.si, point).value;
    if (axis != nullptr) number.worst[point] = most;
    return account::is_kept(field, most);
  }
  const auto here = std::span(number.si).subspan(point * positions(), positions());
  return std::all_of(here.begin(), here.end(), [&](double si) { return account::is_kept(field, si); });
}

}  // namespace loadpath::project
