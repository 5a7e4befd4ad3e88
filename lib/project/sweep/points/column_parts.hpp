// The kernel of a ColumnStep over columns of points, and its memory.
#pragma once

#include "lib/project/sweep/points/column_plan.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::project {

struct ColumnParts : ColumnPlan {
  std::vector<InputColumn> in;
  std::size_t inputs_fed = 0;          // the first of them
  std::vector<std::size_t> in_series;  // of these, those that vary over the positions of a point
  std::vector<ResultColumn> out;
  std::vector<std::vector<Applies>> applies;  // applicability of each mode, point by point
  std::vector<Applies*> applies_at;
  std::vector<std::vector<Applies>> applies_over;  // of open modes over the positions of a point
  std::vector<std::size_t> open_modes;             // that other positions than the first one may decide
  std::vector<std::vector<double>> first_inputs;   // at the first position of each point
  std::vector<InputColumn> columns;                // what a survey is given
  std::vector<char> asked_now, breaks;
  std::vector<double> sizes, next_sizes, size_rows;
  account::RowColumns fold;

  explicit ColumnParts(ColumnPlan&& plan) : ColumnPlan(std::move(plan)) {}

  void feed(PointColumns& points);
  void leave_other_components(PointColumns& points);
  void leave_bolder(PointColumns& points) const;
  void provide(PointColumns& points);
  void start_sizes(PointColumns& points);
  void settle_sizes(PointColumns& points);
  void search(PointColumns& points);
  void find_first_candidates(PointColumns& points);
  void run_for_least(PointColumns& points);
  void ask_candidates(PointColumns& points);
  bool is_found(std::size_t point);
  /// Whether no check, criterion or limit fails with the candidate of a point, but for limits that no size changes.
  [[nodiscard]] bool fits(std::size_t point);
  [[nodiscard]] bool is_kept(Read& number, std::size_t point);
  void evaluate_read(std::size_t rows);
  void read_sizes(PointColumns& points, std::vector<double>& next);
  [[nodiscard]] Extreme largest_of(std::span<const double> si, std::size_t point) const;
  void run(PointColumns& points);
  void check_number(Read& number, PointColumns& points) const;
  void write(const Read& number, PointColumns& points) const;
  void report_found(PointColumns& points) const;
  void check_inputs(PointColumns& points);
  void ask(PointColumns& points, std::span<const char> asked_rules);
  void ask_rules(PointColumns& points, std::span<const char> asked_rules);
  void survey_first_positions(PointColumns& points, std::span<const char> asked_rules);
  void survey_positions(PointColumns& points, std::span<const char> asked_rules);
  void survey_positions_of(PointColumns& points, std::size_t point);
  void find_open_modes(const PointColumns& points);
  bool keep_rules(std::span<const char> asked_rules, bool over_positions);
  void judge(const PointColumns& points, std::vector<account::ModeColumns>& modes);
  void leave_unloaded(PointColumns& points) const;
  void fold_rows(const Judging& judged, std::size_t n);
  std::span<const double> worst_of(Read& number, std::size_t n);
  [[nodiscard]] std::size_t positions() const { return positions_of(axis); }
  static void leave(PointColumns& points, std::size_t point) { points.is_other[point] = 1; }
  /// Whether a point is another's.
  [[nodiscard]] static bool is_other(const PointColumns& points, std::size_t point) {
    return points.is_other[point] != 0;
  }
};

}  // namespace loadpath::project
