#include "lib/project/sweep/variants.hpp"

#include "lib/project/modes.hpp"
#include "lib/project/references/machine/machine.hpp"
#include "lib/project/references/machine/same_part.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/solving/bodies.hpp"
#include "lib/project/solving/body_facts.hpp"
#include "lib/project/solving/elements.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/project/sweep/points/column_step.hpp"
#include "lib/project/sweep/points/constant.hpp"
#include "lib/project/sweep/points/single_step.hpp"
#include "lib/sweep/nan.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace loadpath::project {

namespace {

std::vector<SweptResult> columns_of(Project& project, const std::vector<std::string>& results) {
  std::vector<SweptResult> columns;
  columns.reserve(results.size());
  for (const std::string& text : results) columns.push_back(std::move(*read_column(text, project)));
  for (SweptResult& verdict : verdict_columns(project)) columns.push_back(std::move(verdict));
  return columns;
}

/// Numbers only: text for readers is made for the points that they request.
Wanted wanted_by(const Project& project, const std::vector<SweptResult>& columns) {
  Wanted wanted{.pictures = false, .formulas = false, .unused = false, .words = false, .series = SeriesChoice::none()};
  for (const SweptResult& column : columns) {
    for (const auto& reference : column.expression.references()) wanted.compared.insert(reference.path);
  }
  return with_references(project, std::move(wanted));
}

bool concerns(const SweptResult& column, const account::Mode& mode) {
  return (column.step.empty() || column.step == mode.step) && (column.mode.empty() || column.mode == mode.id);
}

account::Modes modes_in(const Project& project, const SweptResult& column) {
  account::Modes modes;
  for (const auto& step : project.steps) {
    for (const account::Mode& mode : step->account().modes) {
      if (concerns(column, mode)) modes.push_back(mode);
    }
  }
  return project.strict ? account::strictly(std::move(modes)) : modes;
}

/// Expectations of the project do not apply to its points.
Project without_expectations(Project project) {
  project.expectations.clear();
  return project;
}

}  // namespace

Variants::Variants(Project project, const std::vector<std::string>& results)
    : project_(without_expectations(std::move(project))),
      axes_(swept_inputs(project_)),
      columns_(columns_of(project_, results)),
      wanted_(wanted_by(project_, columns_)) {}

void Variants::evaluate(std::span<const double* const> in, std::span<double* const> out, std::size_t n) {
  refusals_.clear();
  if (way_ == Way::unknown) find_way(in, n);
  for (std::size_t start = 0; start < n;) {
    const std::size_t count = std::min(batch(), n - start);
    solve_batch(in, out, start, count);
    start += count;
  }
}

void Variants::solve_batch(std::span<const double* const> in, std::span<double* const> out, std::size_t start,
                           std::size_t count) {
  const bool one_alone = points_.axes_differ;
  from_.assign(in.begin(), in.end());
  to_.assign(out.begin(), out.end());
  for (const double*& column : from_) column += start;
  for (double*& column : to_) column += start;
  if (way_ == Way::columns) solve_columns(from_, to_, count);
  if (points_.axes_differ && !one_alone) {  // other positions of the series: one by one from now on
    for (std::size_t row = 0; row < count; ++row) solve_batch(in, out, start + row, 1);
    return;
  }
  for (std::size_t row = 0; row < count; ++row) {
    if (way_ != Way::columns || points_.is_other[row] != 0) solve_alone(in, out, start + row);
  }
}

/// Points that are solved together: with their series they stay in the cache.
std::size_t Variants::batch() const {
  constexpr std::size_t most_rows = 4096, most = 1024;
  if (points_.axes_differ) return 1;
  std::size_t positions = 1;
  for (const auto& [path, signature] : points_.signatures)
    positions = std::max(positions, positions_of(signature.axis));
  return way_ == Way::columns && positions > 1 ? std::max<std::size_t>(1, most_rows / positions) : most;
}

void Variants::solve_alone(std::span<const double* const> in, std::span<double* const> out, std::size_t row) {
  const bool solved = solve_point(in, row);
  ++alone_;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const SweptResult& column = columns_[k];
    const bool is_state = column.kind == SweptResult::Kind::state;
    const bool is_flag = column.kind == SweptResult::Kind::passes;
    out[k][row] = solved ? read(column) : is_state ? account::refused_state : is_flag ? 0.0 : nan;
  }
}

namespace {

/// Whether the judge takes a record of the part.
bool takes_record(const Step& judge, const Step& part) {
  const auto& records = judge.input().reading.records;
  return std::any_of(records.begin(), records.end(),
                     [&](const Taken& taken) { return taken.source.starts_with(part.name() + "."); });
}

/// Whether a part leaves a mode to a step that takes a record of it: its verdict depends on more than the part.
bool leaves_modes(const Project& project) {
  const auto is_left = [&](const Step& part, const ModeInfo& mode) {
    return std::any_of(project.steps.begin(), project.steps.end(), [&](const auto& step) {
      return step->input().calculator->id == std::string_view(mode.judge) && takes_record(*step, part);
    });
  };
  return std::any_of(project.steps.begin(), project.steps.end(), [&](const auto& step) {
    const auto& modes = step->input().calculator->modes;
    return std::any_of(modes.begin(), modes.end(), [&](const ModeInfo& mode) { return is_left(*step, mode); });
  });
}

}  // namespace

/// Solves the first valid one of a few points; false if there is none.
bool Variants::solve_first(std::span<const double* const> in, std::size_t n) {
  constexpr std::size_t most = 16;
  bool solved = false;
  for (std::size_t row = 0; row < std::min(n, most) && !solved; ++row) solved = solve_point(in, row);
  refusals_.clear();  // they are reported when the block is solved
  return solved;
}

/// Set up at the first point that is solved; without one the next block is tried.
void Variants::find_way(std::span<const double* const> in, std::size_t n) {
  const bool solved_twice = project_.passes.size() != project_.order.size() || !project_.beforehand.empty();
  const std::set<std::string> affected = affected_with_bodies(project_, axes_);
  const bool depends_on_others =
      leaves_modes(project_) || leaves_elements(project_) || solved_twice || compares_walls(project_, affected);
  if (!depends_on_others && !solve_first(in, n)) return;
  const bool has_kernels = !depends_on_others && (find_kernels(false) || find_kernels(true));
  way_ = has_kernels ? Way::columns : Way::alone;
  if (!has_kernels) kernels_.clear();
}

/// Whether another value at a path may come with another point: of an input that varies or is computed, of a result, of
/// [values].
bool may_vary(const Project& project, const std::string& path, const std::set<std::string>& affected) {
  const auto [name, rest] = split_step(path);
  const Step* const step = project.find(name);
  if (step == nullptr && name == "values")
    return project.values.literal(rest) != nullptr && project.values.fixed(rest) == nullptr;
  if (step == nullptr || !affected.contains(name)) return false;
  const Reading& reading = step->input().reading;
  const auto is_it = [&, &input = rest](const auto& one) { return one.path == input; };
  if (std::ranges::any_of(reading.varied, is_it) || std::ranges::any_of(reading.operands, is_it)) return true;
  const auto& fields = step->input().calculator->input->fields;
  const bool is_known =
      step->field(rest) != nullptr || find_field(fields, rest.substr(0, rest.find_first_of(".["))) != nullptr;
  return is_known && !find_leaf(reading.record, rest);
}

/// Whether numbers that vary decide if an input needs a reason: typed values, other steps, what the project states.
bool compares_with_others(const Step& step, const Project& project, const std::set<std::string>& affected) {
  if (affected.contains(step.name()) && compares_numbers(step, project)) return true;
  const NotedReads reads;
  contradictions(step, project);
  return std::ranges::any_of(reads.paths(), [&](const auto& path) { return may_vary(project, path, affected); });
}

/// The values that columns read; false if one of them is a series that has no value here.
bool Variants::find_referred() {
  points_ = {};
  referred_ = wanted_.taken;
  referred_.insert(wanted_.compared.begin(), wanted_.compared.end());
  referred_.insert(bodies_.paths().begin(), bodies_.paths().end());
  for (const std::string& path : referred_) {
    const Value* const value = project_.value(path);
    if (value == nullptr || value->si.empty()) {  // it may have one at another point
      const auto signature = project_.signature(path);
      if (signature && signature->axis != nullptr) return false;
      if (signature) points_.signatures[path] = *signature;
      continue;
    }
    points_.signatures[path] = value->signature;
    if (!value->is_series()) points_.constants[path] = value->si[0];
  }
  return true;
}

/// Kernels of all steps; false if one of them takes more from others than numbers, or columns would bring no gain.
/// `by_bodies`: the steps of a body are solved together, point by point.
bool Variants::find_kernels(bool by_bodies) {
  const std::set<std::string> affected = affected_with_bodies(project_, axes_);
  kernels_.clear();
  bodies_ = {};
  solved_together_ = by_bodies ? separable_bodies(project_, affected) : Bodies{};
  const bool can_do = by_bodies ? !solved_together_.empty() : bodies_.lay_out(project_, affected);
  if (!can_do || !find_referred()) return false;
  bool brings = by_bodies;
  for (const std::size_t i : project_.order) {
    Step& step = *project_.steps[i];
    auto* const calculator = dynamic_cast<CalculatorStep*>(&step);
    std::unique_ptr<PointStep> kernel;
    const bool is_affected = affected.contains(step.name());
    if (compares_with_others(step, project_, affected) || (is_affected && takes_sizes(step, project_))) return false;
    if (body_with(step, solved_together_) != nullptr) {
      if (!add_body_step(step)) return false;
      continue;
    }
    if (!is_affected) kernel = ConstantStep::of(step, referred_, points_);
    if (!kernel && calculator != nullptr) kernel = ColumnStep::of(*calculator, referred_, points_);
    brings = brings || kernel != nullptr;
    if (!kernel) kernel = SingleStep::of(step, wanted_, referred_, points_);
    if (!kernel || !bodies_.take(step, kernel.get())) return false;
    kernels_.push_back(std::move(kernel));
  }
  points_.speeds_matter = std::any_of(kernels_.begin(), kernels_.end(), [](const auto& k) { return k->reads_axes(); });
  modes_.resize(kernels_.size());
  return brings;
}

/// A place for a step of a body; in that of the last one all are solved.
bool Variants::add_body_step(Step& step) {
  const std::vector<Step*>& body = *body_with(step, solved_together_);
  if (&step != body.back()) {
    kernels_.push_back(std::make_unique<EarlierStep>());
    return true;
  }
  std::vector<SingleBody::Member> members;
  for (Step* const one : body) {
    SingleBody::Member& member = members.emplace_back();
    member.step = SingleStep::of_body(*one, body, wanted_, referred_, points_);
    if (!member.step) return false;
    const auto is_it = [&](std::size_t i) { return project_.steps[i].get() == one; };
    const auto place = static_cast<std::size_t>(std::ranges::find_if(project_.order, is_it) - project_.order.begin());
    if (one != &step) member.modes = [this, place]() -> SingleBody::Modes& { return modes_[place]; };
  }
  kernels_.push_back(std::make_unique<SingleBody>(std::move(members), [this] { return hand_out_in_bodies(); }));
  return true;
}

SingleBody::Handed Variants::hand_out_in_bodies() {
  std::vector<Issue> issues;
  const bool again = hand_out_sizes(project_, issues) || hand_out_facts(project_, issues);
  if (has_errors(issues)) return SingleBody::Handed::contradicts;
  return again ? SingleBody::Handed::again : SingleBody::Handed::settled;
}

void Variants::solve_columns(std::span<const double* const> in, std::span<double* const> out, std::size_t n) {
  if (n > points_.count) points_.values.clear();  // otherwise constant values are already there
  points_.count = n;
  points_.is_other.assign(n, 0);
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    const auto put = [&](const std::string& path) { points_.values[path].assign(in[k], in[k] + n); };
    put(axes_[k].name);
    for (const SweptInput::Target& target : axes_[k].targets)
      put(target.step->name() + "." + target.step->input().reading.varied[target.varied].path);
  }
  if (!run_kernels()) return;  // their series have other places: one by one
  if (expressions_.empty()) {
    for (const SweptResult& column : columns_) expressions_.emplace_back(column.expression, points_.signatures);
  }
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    if (columns_[k].kind != SweptResult::Kind::expression) continue;
    if (!expressions_[k].fill(points_, {out[k], n}))
      std::fill(points_.is_other.begin(), points_.is_other.end(), char{1});
  }
  read_verdicts(out, n);
}

/// All steps, and again as long as bodies require larger sizes; false if series turn out to lie over other places.
bool Variants::run_kernels() {
  constexpr int most_rounds = 4;
  const bool one_alone = points_.axes_differ;
  bodies_.start();
  for (int round = 0; round < most_rounds; ++round) {
    for (std::size_t k = 0; k < kernels_.size(); ++k) {
      kernels_[k]->evaluate(points_, modes_[k]);
      if (points_.axes_differ && !one_alone) return false;
    }
    if (!bodies_.require_sizes(points_)) break;
  }
  bodies_.leave_contradicting(points_);
  return true;
}

/// Fills the columns of verdicts from the modes of all steps.
void Variants::read_verdicts(std::span<double* const> out, std::size_t n) {
  if (of_column_.empty()) find_modes_of_columns();
  const SweptResult* before = nullptr;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const SweptResult& column = columns_[k];
    if (column.kind == SweptResult::Kind::expression) continue;
    if (before == nullptr || before->step != column.step || before->mode != column.mode)
      together_.fold(of_column_[k], n, project_.strict);
    before = &column;
    read_verdict(column, {out[k], n});
  }
}

void Variants::find_modes_of_columns() {
  for (const SweptResult& column : columns_) {
    std::vector<const account::ModeColumns*>& modes = of_column_.emplace_back();
    for (std::size_t s = 0; s < kernels_.size(); ++s) {
      const Step& step = *project_.steps[project_.order[s]];
      for (std::size_t m = 0; m < modes_[s].size(); ++m) {
        if ((column.step.empty() || column.step == step.name()) &&
            (column.mode.empty() || column.mode == step.input().calculator->modes[m].id))
          modes.push_back(&modes_[s][m]);
      }
    }
  }
}

/// The same result as read() for a design solved separately.
void Variants::read_verdict(const SweptResult& column, std::span<double> out) const {
  switch (column.kind) {
    case SweptResult::Kind::utilisation:
      std::ranges::copy(together_.utilisation(), out.begin());
      break;
    case SweptResult::Kind::passes:
      together_.write_passes(out);
      break;
    default:
      together_.write_state(column.mode.empty(), out);
  }
}

/// False, with a refusal, if the point cannot be solved.
bool Variants::solve_point(std::span<const double* const> in, std::size_t row) {
  std::vector<Issue> issues;
  for (std::size_t k = 0; k < axes_.size(); ++k) set_input(project_, axes_[k], in[k][row], issues);
  if (issues.empty()) solve_again(project_, issues, wanted_);
  const auto error =
      std::find_if(issues.begin(), issues.end(), [](const Issue& i) { return i.severity == Severity::error; });
  if (error == issues.end()) return true;
  refusals_.push_back({row, std::move(*error)});
  return false;
}

double Variants::read(const SweptResult& column) const {
  using Kind = SweptResult::Kind;
  if (column.kind == Kind::utilisation) return utilisation_of(column);
  if (column.kind == Kind::state) return state_of(column);
  if (column.kind == Kind::passes) return account::passes(modes_in(project_, column)) ? 1.0 : 0.0;
  static const Value none{{}, {nan}};
  const Value value = column.expression.evaluate([&](const std::string& path) -> const Value& {
    const Value* const known = project_.value(path);
    return known == nullptr ? none : *known;
  });
  return value.si[0];
}

double Variants::state_of(const SweptResult& column) const {
  const account::Modes modes = modes_in(project_, column);
  if (modes.empty()) return column.mode.empty() ? static_cast<double>(account::State::open) : account::absent_state;
  return static_cast<double>(column.mode.empty() ? account::overall(modes) : account::worst(modes));
}

double Variants::utilisation_of(const SweptResult& column) const {
  double most = nan;
  for (const account::Mode& mode : modes_in(project_, column)) {
    if (mode.utilisation && !(most >= *mode.utilisation)) most = *mode.utilisation;
  }
  return most;
}

}  // namespace loadpath::project
