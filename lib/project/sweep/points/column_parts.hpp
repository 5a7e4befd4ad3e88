// What a ColumnStep knows of its calculator: where inputs and results lie, what judges the modes; and its memory.
#pragma once

#include "lib/project/sweep/points/column_step.hpp"
#include "lib/project/sweep/points/fed.hpp"
#include "lib/project/sweep/points/sized.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

/// A number of the result.
struct Read {
  std::string path;  // full
  const FieldInfo* field;
  std::size_t offset = 0;
  bool is_row = false;  // a check or a limit that is asked for
  bool is_wanted = false;
  std::vector<double> si = {};
  std::vector<double> worst = {};  // of each point, where positions make it
};

/// What rows of tables are asked at, where that varies: a result, an input, or the same everywhere.
struct Size {
  std::optional<std::size_t> result = {};  // offset
  const FieldInfo* field = nullptr;        // of the result
  std::optional<std::size_t> fed = {};     // which of the inputs
  bool is_sought = false;                  // the size that is searched for
  double same = std::numeric_limits<double>::quiet_NaN();
};

/// How far the search of a point has come.
struct Candidate {
  std::size_t now = 0;
};

/// A size that is searched for in a stock.
struct Sought {
  Leaf leaf = {};  // in the record
  std::vector<double> stock = {};
  std::size_t offset = 0;
  const FieldInfo* least = nullptr;  // the least size, of the result; null: there is none
  std::size_t least_offset = 0;
  std::vector<std::size_t> kept = {};  // of results that a sizing would fix
  std::vector<std::vector<double>> of_kept = {};
  std::vector<char> rules = {};    // that a candidate has to keep
  std::vector<Candidate> at = {};  // of each point
  std::vector<char> breaks = {};   // a rule, of each point
  std::vector<double> si = {};     // over all rows
};

/// Whether a number of a record lies at a fixed place in it, and where.
bool is_fixed(std::span<const FieldInfo> fields, std::string_view path);
std::size_t offset_in(const Record& record, const Leaf& leaf);

/// A mode, and which of the numbers that are read judge it.
struct Judging {
  std::size_t mode;
  std::vector<std::size_t> rows = {};
  account::Unjudged unjudged = {};
};

struct ColumnStep::Parts {
  CalculatorStep& step;
  const Calculator& calculator;
  const Axis* axis;  // null: one position
  Record record, result;
  std::vector<Fed> fed;
  std::vector<std::string> absent;  // that would come along, and did not where this was laid out
  std::vector<Sized> sized;
  std::optional<Size> size;      // of the sized inputs
  std::optional<Sought> sought;  // that is searched for
  std::vector<Read> read;
  std::vector<char> rules;  // of each whether what varies can break it
  std::vector<char> no_rules;
  std::vector<Judging> judging;
  std::vector<InputColumn> in;
  std::size_t inputs_fed = 0;  // the first of them
  std::vector<ResultColumn> out;
  std::vector<std::vector<Applies>> applies;  // of each mode, point by point
  std::vector<Applies*> applies_at;
  std::vector<std::vector<Applies>> applies_over;  // the same over the positions
  std::vector<char> other_rows;                    // over the positions
  std::vector<double> sizes, next_sizes, size_rows;
  Value slice;  // of a series, at one point
  account::RowColumns fold;
  bool is_loaded = false;  // whatever varies
  bool is_load_told = false;

  explicit Parts(CalculatorStep& s)
      : step(s),
        calculator(*s.input().calculator),
        axis(s.axis()),
        record(s.input().reading.record.clone()),
        result(*calculator.result) {}

  bool lay_out(const std::set<std::string>& wanted, const PointColumns& points);
  [[nodiscard]] bool is_plain() const;
  bool add_fed(const PointColumns& points);
  [[nodiscard]] std::optional<std::size_t> place_of(const FieldInfo& field, const std::string& path) const;
  bool add_companions(const PointColumns& points);
  bool add_absent(const Provided& provided, const PointColumns& points);
  bool add_values_of_rows();
  [[nodiscard]] std::string size_field() const;
  [[nodiscard]] Size size_of(const std::string& field) const;
  bool add_read(const std::set<std::string>& wanted);
  [[nodiscard]] bool is_fed(std::string_view field) const;
  void add_rules();
  void add_judging();
  bool add_search();
  void add_rules_of_search();
  void look_for_loads();
  void feed(PointColumns& points);
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
  [[nodiscard]] Extreme largest_of(std::span<const double> si, std::size_t point, const Dimension& dimension);
  void run(PointColumns& points);
  void check_number(Read& number, PointColumns& points) const;
  void tell(const Read& number, PointColumns& points) const;
  void tell_found(PointColumns& points) const;
  void check_inputs(PointColumns& points);
  void ask(PointColumns& points, std::span<const char> asked_rules);
  void gather(PointColumns& points);
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
