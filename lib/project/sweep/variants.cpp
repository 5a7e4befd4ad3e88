#include "lib/project/sweep/variants.hpp"

#include "lib/project/modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::project {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<ResultColumn> columns_of(Project& project, const std::vector<std::string>& results) {
  std::vector<ResultColumn> columns;
  for (const std::string& text : results) columns.push_back(std::move(*read_column(text, project)));
  for (ResultColumn& verdict : verdict_columns(project)) columns.push_back(std::move(verdict));
  return columns;
}

/// Numbers alone: what people read is made for the points that they ask for.
Wanted wanted_by(const Project& project, const std::vector<ResultColumn>& columns) {
  Wanted wanted{
      .pictures = false, .formulas = false, .unused = false, .words = false, .series = SeriesChoice::none()};
  for (const ResultColumn& column : columns) {
    for (const auto& reference : column.expression.references()) wanted.compared.insert(reference.path);
  }
  return with_references(project, std::move(wanted));
}

bool concerns(const ResultColumn& column, const account::Mode& mode) {
  return (column.step.empty() || column.step == mode.step) && (column.mode.empty() || column.mode == mode.id);
}

account::Modes modes_in(const Project& project, const ResultColumn& column) {
  account::Modes modes;
  for (const auto& step : project.steps) {
    for (const account::Mode& mode : step->account().modes) {
      if (concerns(column, mode)) modes.push_back(mode);
    }
  }
  return project.strict ? account::strictly(std::move(modes)) : modes;
}

}  // namespace

Variants::Variants(Project project, const std::vector<std::string>& results)
    : project_(std::move(project)),
      axes_(swept_inputs(project_)),
      columns_(columns_of(project_, results)),
      wanted_(wanted_by(project_, columns_)) {}

void Variants::evaluate(std::span<const double* const> in, std::span<double* const> out, std::size_t n) {
  refusals_.clear();
  for (std::size_t row = 0; row < n; ++row) {
    const bool solved = solve_point(in, row);
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const ResultColumn& column = columns_[k];
      const bool is_state = column.kind == ResultColumn::Kind::state;
      const bool is_flag = column.kind == ResultColumn::Kind::passes;
      out[k][row] = solved ? read(column) : is_state ? refused : is_flag ? 0.0 : nan;
    }
  }
}

/// False, with a refusal, where the point is none that can be solved.
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

double Variants::read(const ResultColumn& column) const {
  using Kind = ResultColumn::Kind;
  if (column.kind == Kind::utilisation) return utilisation_of(column);
  if (column.kind == Kind::state) return state_of(column);
  if (column.kind == Kind::passes)
    return account::rank(account::worst(modes_in(project_, column))) <= account::rank(account::State::open) ? 1.0 : 0.0;
  static const Value none{{}, {nan}};
  const Value value = column.expression.evaluate([&](const std::string& path) -> const Value& {
    const Value* const known = project_.value(path);
    return known == nullptr ? none : *known;
  });
  return value.si[0];
}

double Variants::state_of(const ResultColumn& column) const {
  const account::Modes modes = modes_in(project_, column);
  if (modes.empty()) return column.mode.empty() ? static_cast<double>(account::State::open) : absent;
  return static_cast<double>(column.mode.empty() ? account::overall(modes) : account::worst(modes));
}

double Variants::utilisation_of(const ResultColumn& column) const {
  double most = nan;
  for (const account::Mode& mode : modes_in(project_, column)) {
    if (mode.utilisation && !(most >= *mode.utilisation)) most = *mode.utilisation;
  }
  return most;
}

}  // namespace loadpath::project
