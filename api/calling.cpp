#include "api/calling.hpp"

#include "calculators/catalogue.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/sweep/blocks.hpp"
#include "lib/project/sweep/variants.hpp"
#include "lib/sweep/ordered.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

namespace loadpath::api {

namespace {

using Kind = project::SweptResult::Kind;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t block_size = project::block_size;

std::vector<std::string> numbers_of(const loadpath::Calculator& calculator) {
  std::vector<std::string> names;
  if (calculator.result == nullptr) return names;
  const Record blank(*calculator.result);
  for_each_leaf(blank, [&](const std::string& path, const Leaf& leaf) {
    if (leaf.field->is_number()) names.push_back(path);
  });
  return names;
}

bool is_of_whole(const std::string& name) { return name == "state" || name == "utilisation" || name == "passes"; }

/// The outputs read at every point, with the interface that a project's sweep uses.
class Asked {
 public:
  Asked(const loadpath::Calculator& calculator, const Call& call, const std::vector<std::string>& results);

  [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }

 private:
  void add(const std::string& name);

  const Call& call_;
  std::vector<std::string> known_, names_, texts_;
};

Asked::Asked(const loadpath::Calculator& calculator, const Call& call, const std::vector<std::string>& results)
    : call_(call), known_(numbers_of(calculator)) {
  for (const std::string& name : results.empty() ? known_ : results) add(name);
}

void Asked::add(const std::string& name) {
  if (std::find(names_.begin(), names_.end(), name) != names_.end()) refuse(say("'{1}' is requested twice", name));
  const bool is_word = name.find_first_of(".[") == std::string::npos;
  if (is_word && !is_of_whole(name) && std::find(known_.begin(), known_.end(), name) == known_.end())
    refuse_name("unknown result '{1}'", name, known_);
  names_.push_back(name);
  if (name == "state" || name == "utilisation") return;  // there is one anyhow
  texts_.push_back(is_of_whole(name) ? name : name + " = " + call_.step + "." + name);
}

/// The solver of one thread.
class Caller {
 public:
  Caller(const Call& call, project::Project project, const std::vector<std::string>& texts)
      : call_(call), variants_(std::move(project), texts) {
    for (const project::SweptInput& axis : variants_.axes()) {
      const auto column = std::find_if(call.columns.begin(), call.columns.end(),
                                       [&](const GivenColumn& c) { return call.step + "." + c.name == axis.name; });
      columns_.push_back(&*column);
    }
    in_.resize(columns_.size());
    out_.resize(variants_.outputs());
    given_.assign(columns_.size(), std::vector<double>(block_size));
    unasked_.resize(block_size);
  }

  /// The rows from `first` on; the columns that are kept take them from `at` on.
  void solve(std::size_t first, std::size_t n, const std::vector<double*>& results, std::size_t at);
  [[nodiscard]] const std::vector<std::pair<std::size_t, loadpath::Issue>>& refused() const { return refused_; }
  [[nodiscard]] const project::Variants& variants() const { return variants_; }

 private:
  const double* feed(std::size_t which, std::size_t first, std::size_t n);
  void mark_refused(std::size_t row);

  const Call& call_;
  project::Variants variants_;
  std::vector<const GivenColumn*> columns_;
  std::vector<const double*> in_;
  std::vector<double*> out_;
  std::vector<std::vector<double>> given_;
  std::vector<double> unasked_;
  std::vector<std::size_t> lacking_;  // per row, the first column without a value; none: past the last
  std::vector<std::pair<std::size_t, loadpath::Issue>> refused_;
};

/// SI columns are read in place, without a copy.
const double* Caller::feed(std::size_t which, std::size_t first, std::size_t n) {
  const GivenColumn& column = *columns_[which];
  std::vector<double>& si = given_[which];
  bool as_it_stands = !column.unit;
  for (std::size_t i = 0; i < n; ++i) {
    if (column.take(first + i, si[i])) continue;
    si[i] = column.stand_in;
    lacking_[i] = std::min(lacking_[i], which);
    as_it_stands = false;
  }
  return as_it_stands ? column.numbers.data() + first : si.data();
}

void Caller::mark_refused(std::size_t row) {
  for (std::size_t k = 0; k < out_.size(); ++k) {
    const Kind kind = variants_.columns()[k].kind;
    out_[k][row] = kind == Kind::state ? account::refused_state : kind == Kind::passes ? 0.0 : nan;
  }
}

void Caller::solve(std::size_t first, std::size_t n, const std::vector<double*>& results, std::size_t at) {
  refused_.clear();
  lacking_.assign(n, columns_.size());
  for (std::size_t k = 0; k < columns_.size(); ++k) in_[k] = feed(k, first, n);
  for (std::size_t k = 0; k < out_.size(); ++k) out_[k] = k < results.size() ? results[k] + at : unasked_.data();
  variants_.evaluate(in_, out_, n);
  for (const project::Refusal& refusal : variants_.refusals()) {
    if (lacking_[refusal.row] == columns_.size()) refused_.emplace_back(first + refusal.row, refusal.issue);
  }
  for (std::size_t row = 0; row < n; ++row) {
    if (lacking_[row] == columns_.size()) continue;
    mark_refused(row);
    const GivenColumn& column = *columns_[lacking_[row]];
    const bool counts = column.field != nullptr && column.field->type == FieldInfo::Type::count;
    Message message = counts ? say("{1} is not an integer", column.name) : say("{1} is not a number", column.name);
    refused_.emplace_back(first + row, loadpath::Issue{{}, call_.step + "." + column.name, std::move(message), {}});
  }
}

/// Reasons, each with its first point. Points come in no order.
class Refusals {
 public:
  void add(std::size_t point, const loadpath::Issue& issue) {
    Refused& alike = all_[issue.key + "\n" + std::string(issue.message.id)];
    if (alike.count++ == 0 || point < alike.first) alike = {alike.count, point, issue.key, issue.message.text()};
  }
  [[nodiscard]] std::vector<Refused> in_order() const {
    std::vector<Refused> list;
    for (const auto& [id, refused] : all_) list.push_back(refused);
    return api::in_order(std::move(list));
  }

 private:
  std::map<std::string, Refused> all_;
};

class Sweeping {
 public:
  Sweeping(const loadpath::Calculator& calculator, const Call& call, const SweepOptions& options)
      : call_(call), options_(options), texts_(Asked(calculator, call, options.results).texts()) {}

  Sweep run();

 private:
  [[nodiscard]] project::Project read() const;
  [[nodiscard]] std::unique_ptr<Caller> caller() const;
  void lay_out();
  void solve();

  const Call& call_;
  const SweepOptions& options_;
  std::vector<std::string> texts_;
  Sweep sweep_;
  std::vector<double*> starts_;
  Refusals refusals_;
};

project::Project Sweeping::read() const {
  std::vector<loadpath::Issue> issues;
  project::Project project = project::read_project(call_.project, "call", catalogue(), issues, project::Ranges::taken);
  refuse_errors(issues, call_.sources);
  project.strict = options_.strict;
  return project;
}

void Sweeping::lay_out() {
  project::Project project = read();
  const auto add = [&](const project::SweptResult& result) {
    sweep_.columns.push_back(column_of(result));
    sweep_.columns.back().values.resize(call_.rows);
  };
  for (const std::string& text : texts_) {
    const auto column = project::read_column(text, project);
    if (!column) refuse(column.fault().message, column.fault().hint);
    add(*column);
  }
  for (const project::SweptInput& input : project::swept_inputs(project)) {
    const auto is_its = [&](const GivenColumn& c) { return call_.step + "." + c.name == input.name; };
    if (std::none_of(call_.columns.begin(), call_.columns.end(), is_its))
      refuse(say("'{1}' goes through many values of its own", input.name), say("give it a column of values"));
  }
  const auto verdicts = project::verdict_columns(project);
  add(verdicts[0]), add(verdicts[1]);
  for (Column& column : sweep_.columns) starts_.push_back(column.values.data());
}

/// It learns at the first point that it solves how others are solved quickly: one that is a machine.
std::unique_ptr<Caller> Sweeping::caller() const {
  constexpr std::size_t trials = 8;
  std::unique_ptr<Caller> caller;
  std::vector<std::vector<double>> room(starts_.size(), std::vector<double>(1));
  for (std::size_t trial = 0; trial < trials; ++trial) {
    const std::size_t row = trial * call_.rows / trials;
    caller = std::make_unique<Caller>(call_, read(), texts_);
    std::vector<double*> results;
    results.reserve(room.size());
    for (std::vector<double>& one : room) results.push_back(one.data());
    caller->solve(row, 1, results, 0);
    if (caller->refused().empty()) break;
  }
  return caller;
}

void Sweeping::solve() {
  using Done = std::vector<std::pair<std::size_t, loadpath::Issue>>;
  using Parts = sweep::Ordered<Done>;
  constexpr std::size_t part_size = 64 * block_size;
  const std::size_t parts = (call_.rows + part_size - 1) / part_size;
  bool stopped = false;
  Parts work(0, parts, static_cast<unsigned>(std::min<std::size_t>(threads_for(options_.jobs), parts)));
  work.run(
      [&]() -> Parts::Worker {
        return [this, caller = std::shared_ptr<Caller>(this->caller())](std::uint64_t part) {
          Done done;
          const std::size_t last = std::min(call_.rows, (part + 1) * part_size);
          for (std::size_t first = part * part_size; first < last; first += block_size) {
            caller->solve(first, std::min(block_size, last - first), starts_, first);
            done.insert(done.end(), caller->refused().begin(), caller->refused().end());
          }
          return done;
        };
      },
      [&](std::uint64_t part, Done&& done) {
        for (const auto& [point, issue] : done) refusals_.add(point, issue);
        const std::uint64_t rows = std::min<std::uint64_t>(call_.rows, (part + 1) * part_size);
        stopped = options_.goes_on && !options_.goes_on(rows, call_.rows);
        return !stopped;
      });
  if (stopped) refuse(say("the sweep was stopped"));
}

Sweep Sweeping::run() {
  lay_out();
  sweep_.points = call_.rows;
  if (call_.rows != 0) solve();
  sweep_.refused = refusals_.in_order();
  return std::move(sweep_);
}

}  // namespace

Sweep sweep_of(const loadpath::Calculator& calculator, const Call& call, const SweepOptions& options) {
  return Sweeping(calculator, call, options).run();
}

}  // namespace loadpath::api
