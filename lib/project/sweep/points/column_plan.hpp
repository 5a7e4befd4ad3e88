// The data of a ColumnStep about its calculator: offsets of inputs and results, checks of the modes.
#pragma once

#include "lib/account/fold.hpp"
#include "lib/project/sweep/points/column_input.hpp"
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
  bool is_row = false;  // an active check or limit
  bool is_wanted = false;
  std::vector<double> si = {};
  std::vector<double> worst = {};  // worst value at each point, if there are positions
};

/// The size for looking up rows of tables, if it varies: a result, an input, or constant.
struct Size {
  std::optional<std::size_t> result = {};  // offset
  const FieldInfo* field = nullptr;        // field of the result
  std::optional<std::size_t> fed = {};     // index of the input
  bool is_sought = false;                  // the size that is searched for
  double same = std::numeric_limits<double>::quiet_NaN();
};

/// The progress of a point's search.
struct Candidate {
  std::size_t now = 0;
};

/// A size that is searched for in a stock.
struct SearchedSize {
  Leaf leaf = {};  // in the record
  std::vector<double> stock = {};
  std::size_t offset = 0;
  const FieldInfo* least = nullptr;  // result with the minimum size; null: there is none
  std::size_t least_offset = 0;
  std::vector<double> least_of_body = {};  // at each point, from other steps; empty: none
  std::vector<std::size_t> kept = {};      // results that a sizing would fix
  std::vector<std::vector<double>> of_kept = {};
  std::vector<char> rules = {};    // rules for a candidate
  std::vector<Candidate> at = {};  // candidate at each point
  std::vector<char> breaks = {};   // a rule, of each point
  std::vector<double> si = {};     // over all rows
};

/// Whether a number of a record lies at a fixed place in it, and where.
bool is_fixed(std::span<const FieldInfo> fields, std::string_view path);
std::size_t offset_in(const Record& record, const Leaf& leaf);

/// A mode, and which of the numbers that are read assess it.
struct Judging {
  std::size_t mode;
  std::vector<std::size_t> rows = {};
  account::Unjudged unjudged = {};
};

/// A component of a load that the step does not include, and whether it acts where the step was laid out.
struct LeftComponent {
  std::string path;
  Value value;
  bool acts;
};

struct ColumnPlan {
  CalculatorStep& step;
  const Calculator& calculator;
  const Axis* axis;  // null: one position
  Record record, result;
  std::vector<ColumnInput> fed;
  std::vector<LeftComponent> left_components = {};
  std::vector<std::string> absent;  // load components that were absent where this was laid out
  std::vector<Sized> sized;
  std::optional<Size> size;            // size of the sized inputs
  std::optional<SearchedSize> sought;  // searched input
  std::vector<Read> read;
  std::vector<char> rules;         // for each rule, whether varying inputs can violate it
  std::vector<char> series_rules;  // for each rule, whether inputs that vary over the positions can
  std::vector<char> no_rules;
  bool is_series_of_loads = true;  // whether only loads vary over the positions
  std::vector<Judging> judging;
  std::vector<KeptBound> bounds;  // that typed values must keep at each point
  bool is_loaded = false;         // for all varying inputs
  bool is_load_told = false;

  explicit ColumnPlan(CalculatorStep& s)
      : step(s),
        calculator(*s.input().calculator),
        axis(s.axis()),
        record(s.input().reading.record.clone()),
        result(*calculator.result) {}
};

/// For a step that was solved at one point; nothing if it needs more than its kernel. `wanted`: full paths of its
/// values that others refer to. `points`: with the signatures of the values it refers to.
std::optional<ColumnPlan> plan_columns(CalculatorStep& step, const std::set<std::string>& wanted,
                                       const PointColumns& points);

}  // namespace loadpath::project
