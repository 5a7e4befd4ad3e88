#include "calculators/mechanism/results/values.hpp"

#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/cycle/kinematics.hpp"
#include "calculators/mechanism/cycle/rounding.hpp"
#include "calculators/mechanism/results/missing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace loadpath::planar {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// What is read off the positions of a cycle, thing by thing: results of one thing follow one another.
class Columns {
 public:
  explicit Columns(const Solved& solved) : cycle_(solved.cycle), kinematics_(solved.kinematics) {}

  /// One value for every position; none where the mechanism does not close. Each is taken once.
  std::vector<double> take(const Reading& reading) {
    if (of_ != reading.together.get()) read(*reading.together);
    return std::move(columns_[reading.place]);
  }

 private:
  void read(const Reading::Together& together) {
    const std::size_t positions = cycle_.positions.size();
    of_ = &together;
    columns_.assign(together.count, std::vector<double>(positions, none));
    values_.resize(together.count);
    for (std::size_t k = 0; k < positions; ++k) {
      if (!cycle_.closed[k]) continue;
      together.read({cycle_.positions[k], kinematics_.derivative(k)}, values_);
      for (std::size_t n = 0; n < together.count; ++n) columns_[n][k] = values_[n];
    }
  }

  const Cycle& cycle_;
  const Kinematics& kinematics_;
  const Reading::Together* of_ = nullptr;
  std::vector<std::vector<double>> columns_;
  std::vector<double> values_;  // of all at one position
};

Output::Values values_of(const Output& output, const Solved& solved, const account::Account& account,
                         Columns& columns) {
  if (output.read_results) return output.read_results(account);
  if (output.read_cycle) return output.read_cycle(solved);
  Output::Values values = columns.take(output.read);
  const bool open = std::any_of(values.si.begin(), values.si.end(), [](double x) { return std::isnan(x); });
  if (open) values.missing = output.missing;
  return values;
}

/// Whether an output is made from the results of this path.
bool is_read_by_others(const std::string& path, const std::vector<Output>& outputs) {
  return std::any_of(outputs.begin(), outputs.end(), [&](const Output& o) {
    return std::find(o.results_read.begin(), o.results_read.end(), path) != o.results_read.end();
  });
}

/// The output of the same path; where it was not solved, this one.
const Output& same_of(const std::vector<Output>& outputs, const Output& output) {
  const auto same = std::find_if(outputs.begin(), outputs.end(), [&](const auto& o) { return o.path == output.path; });
  return same == outputs.end() ? output : *same;
}

}  // namespace

void fill_results(const Mechanism::Input& in, const mechanism::Model& model, const std::vector<Output>& told,
                  const std::vector<Output>& read, const Solved& solved, const Axis* axis, const Wants& wants,
                  account::Account& account) {
  Columns columns(solved);
  const auto needed = [&](const Output& output) {
    return axis == nullptr || output.is_single || wants(output.path) || is_read_by_others(output.path, told);
  };
  account.results.clear();
  account.results.reserve(told.size());
  const auto add = [&](const Output& output) {
    Output::Values values({});
    if (needed(output)) {
      values = values_of(same_of(read, output), solved, account, columns);
      explain_missing(in, solved.cycle, values);
    }
    auto& [si, missing] = values;
    Value value{{output.dimension, output.is_single ? nullptr : axis}, std::move(si)};
    account.results.push_back(
        {output.path, output.doc, output.unit, Role::result, std::move(value), {}, "", false, std::move(missing)});
  };
  for (const Output& output : told) {
    if (!output.read_results) add(output);
  }
  clear_rounding(model, solved.cycle, account.results);
  for (const Output& output : told) {  // ratios of what is there now
    if (output.read_results) add(output);
  }
}

}  // namespace loadpath::planar
