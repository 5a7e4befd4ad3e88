#include "lib/project/solving/row_pairs.hpp"

#include "lib/project/run/calculator_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::project {

namespace {

using Indices = std::vector<std::size_t>;

bool gives_same(const RowOfSearch& a, const RowOfSearch& b) {
  return std::equal(a.given.begin(), a.given.end(), b.given.begin(), b.given.end(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

/// One step of a pair: its rows, and in place of each the first one that gives the other step the same values.
struct Side {
  CalculatorStep& step;
  const std::vector<std::string>& keys;  // of the values
  std::vector<RowOfSearch> rows;
  Indices alike;

  Side(Step& of, const std::vector<std::string>& taken)
      : step(dynamic_cast<CalculatorStep&>(of)), keys(taken), rows(step.rows_of_search(taken)) {
    for (const RowOfSearch& row : rows) {
      const auto first = std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return gives_same(r, row); });
      alike.push_back(static_cast<std::size_t>(first - rows.begin()));
    }
  }

  /// Lets the other step take the values of a row.
  void hand_out(Project& project, const RowOfSearch& row) const {
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const FieldInfo& field = *find_field(step.input().calculator->input->fields, keys[k]);
      project.beforehand[step.name() + "." + keys[k]] = Value{{field.dimension, nullptr}, {row.given[k]}};
    }
  }
};

/// For every kind of row of `other`, the first row of each kind of `side` that passes next to it.
std::vector<Indices> first_passing(Project& project, const Side& side, const Side& other, const Known& known) {
  std::vector<Indices> all(other.rows.size());
  for (std::size_t k = 0; k < other.rows.size(); ++k) {
    if (other.alike[k] != k) continue;
    other.hand_out(project, other.rows[k]);
    all[k] = side.step.first_rows_that_pass(known, side.alike);
  }
  return all;
}

}  // namespace

void find_rows_together(Project& project, const RowPair& pair, const Known& known) {
  const Side a(*project.steps[pair.a], pair.of_a), b(*project.steps[pair.b], pair.of_b);
  const std::vector<Indices> of_a = first_passing(project, a, b, known), of_b = first_passing(project, b, a, known);
  double least = std::numeric_limits<double>::infinity();
  const RowOfSearch *row_a = nullptr, *row_b = nullptr;
  for (std::size_t j = 0; j < of_a.size(); ++j) {
    for (std::size_t i = 0; i < of_b.size(); ++i) {
      if (of_a[j].empty() || of_b[i].empty()) continue;  // the same values as those of a row before
      const std::size_t first_a = of_a[j][i], first_b = of_b[i][j];
      if (first_a >= a.rows.size() || first_b >= b.rows.size()) continue;
      const double size = a.rows[first_a].size + b.rows[first_b].size;
      if (!(size < least)) continue;
      least = size;
      row_a = &a.rows[first_a], row_b = &b.rows[first_b];
    }
  }
  if (!a.rows.empty()) a.hand_out(project, row_a == nullptr ? a.rows.back() : *row_a);  // none: it is reported there
  if (!b.rows.empty()) b.hand_out(project, row_b == nullptr ? b.rows.back() : *row_b);
  a.step.keep_to_row({row_a == nullptr ? "" : row_a->name, b.step.name()});
  b.step.keep_to_row({row_b == nullptr ? "" : row_b->name, a.step.name()});
}

}  // namespace loadpath::project
