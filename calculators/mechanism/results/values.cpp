#include "calculators/mechanism/results/values.hpp"

#include "calculators/mechanism/results/missing.hpp"
#include "calculators/mechanism/results/results.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loadpath::planar {

namespace {

/// Values read off the positions of a cycle, thing by thing: results of one thing follow one another.
class Columns {
 public:
  explicit Columns(const Solved& solved)
      : cycle_(solved.cycle),
        kinematics_(solved.kinematics),
        closes_(std::ranges::find(cycle_.closed, false) == cycle_.closed.end()) {}

  /// One value for every position; none where the mechanism does not close. Each is taken once.
  std::vector<double> take(const Reading& reading) {
    if (closes_ && reading.together->read_one) {
      std::vector<double> values(cycle_.positions.size());
      reading.together->read_one(cycle_.positions, reading.place, values);
      return values;
    }
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
  bool closes_;  // at all positions
  const Reading::Together* of_ = nullptr;
  std::vector<std::vector<double>> columns_;
  std::vector<double> values_;  // values of all at one position
};

Message missing_of(const Output& output) {
  const std::string_view reason = output.what.facts.missing;
  return reason.empty() ? Message{} : say(reason);
}

Output::Values values_of(const Output& output, const Solved& solved, const Results& before, Columns& columns) {
  if (output.read_results) return output.read_results(before);
  if (output.read_cycle) return output.read_cycle(solved);
  Output::Values values = columns.take(output.read);
  const bool open = std::any_of(values.si.begin(), values.si.end(), [](double x) { return std::isnan(x); });
  if (open) values.missing = missing_of(output);
  return values;
}

/// The kinds of results that other outputs are made from.
std::vector<Kind> kinds_read(const std::vector<Output>& outputs) {
  std::vector<Kind> kinds;
  for (const Output& output : outputs) {
    for (const Kind kind : output.results_read) {
      if (std::ranges::find(kinds, kind) == kinds.end()) kinds.push_back(kind);
    }
  }
  return kinds;
}

bool reads_results(const Output& output) { return output.read_results != nullptr; }

/// Finds outputs by their paths. Both lists have the same order, so each search continues from the last one: a search
/// from the first output would make the cost of a long chain quadratic.
class ByPath {
 public:
  explicit ByPath(const std::vector<Output>& outputs) : outputs_(outputs), last_(outputs.begin()) {}

  /// The output of the same path; where it was not solved, this one.
  const Output& same_of(const Output& output) {
    const auto same = [&](const Output& o) { return o.path == output.path; };
    auto found = std::find_if(last_, outputs_.end(), same);
    if (found == outputs_.end()) {
      found = std::find_if(outputs_.begin(), last_, same);
      if (found == last_) return output;
    }
    last_ = found;
    return *found;
  }

 private:
  const std::vector<Output>& outputs_;
  std::vector<Output>::const_iterator last_;
};

}  // namespace

void fill_results(const std::vector<Output>& outputs, const std::vector<Output>& read, const Solved& solved,
                  const Magnitudes& magnitudes, const Wants& wants, account::Account& account) {
  Columns columns(solved);
  ByPath by_path(read);
  const std::vector<Kind> others = kinds_read(outputs);
  const auto needed = [&](const Output& output) {
    return solved.axis == nullptr || output.is_single || wants(output.path) ||
           std::ranges::find(others, output.what.facts.kind) != others.end();
  };
  account.results.clear();
  account.results.reserve(outputs.size());
  const auto add = [&](const Output& output, const Results& before) {
    Output::Values values({});
    if (solved.values != nullptr) {
      values.si = std::move((*solved.values)[account.results.size()]);
    } else if (needed(output)) {
      values = values_of(by_path.same_of(output), solved, before, columns);
      explain_missing(solved.in, solved.cycle, values);
    }
    auto& [si, missing] = values;
    const auto& [pattern, dimension, facts] = output.what;
    Value value{{dimension, output.is_single ? nullptr : solved.axis}, std::move(si)};
    account.results.push_back({output.path,
                               pattern.doc,
                               pattern.unit,
                               Role::result,
                               std::move(value),
                               {},
                               "",
                               false,
                               std::move(missing),
                               !facts.detail});
  };
  const auto ratios = std::find_if(outputs.begin(), outputs.end(), &reads_results);
  const Results none_yet(outputs, account.results);
  std::for_each(outputs.begin(), ratios, [&](const Output& output) { add(output, none_yet); });
  const ResultRounding rounding(solved.given, magnitudes);
  for (std::size_t n = 0; n < account.results.size(); ++n)
    rounding.clear(account.results[n].value, outputs[n].what.facts.kind == Kind::direction);
  const Results before(outputs, account.results);  // ratios are of what is there now
  std::for_each(ratios, outputs.end(), [&](const Output& output) { add(output, before); });
}

}  // namespace loadpath::planar
