#include "lib/project/sweep/variants.hpp"

#include "lib/project/modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace loadpath::project {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<SweptResult> columns_of(Project& project, const std::vector<std::string>& results) {
  std::vector<SweptResult> columns;
  columns.reserve(results.size());
  for (const std::string& text : results) columns.push_back(std::move(*read_column(text, project)));
  for (SweptResult& verdict : verdict_columns(project)) columns.push_back(std::move(verdict));
  return columns;
}

/// Numbers alone: what people read is made for the points that they ask for.
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

}  // namespace

Variants::Variants(Project project, const std::vector<std::string>& results)
    : project_(std::move(project)),
      axes_(swept_inputs(project_)),
      columns_(columns_of(project_, results)),
      wanted_(wanted_by(project_, columns_)) {}

void Variants::evaluate(std::span<const double* const> in, std::span<double* const> out, std::size_t n) {
  refusals_.clear();
  const bool by_columns = solve_columns(in, out, n);
  for (std::size_t row = 0; row < n; ++row) {
    if (!by_columns || points_.is_other[row] != 0) solve_alone(in, out, row);
  }
}

void Variants::solve_alone(std::span<const double* const> in, std::span<double* const> out, std::size_t row) {
  const bool solved = solve_point(in, row);
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const SweptResult& column = columns_[k];
    const bool is_state = column.kind == SweptResult::Kind::state;
    const bool is_flag = column.kind == SweptResult::Kind::passes;
    out[k][row] = solved ? read(column) : is_state ? refused_state : is_flag ? 0.0 : nan;
  }
}

namespace {

/// Whether a part leaves a mode to a calculator of which there is a step: its verdict hangs on more than the part.
bool leaves_modes(const Project& project) {
  const auto runs = [&](std::string_view calculator) {
    return std::any_of(project.steps.begin(), project.steps.end(),
                       [&](const auto& step) { return step->input().calculator->id == calculator; });
  };
  return std::any_of(project.steps.begin(), project.steps.end(), [&](const auto& step) {
    const auto& modes = step->input().calculator->modes;
    return std::any_of(modes.begin(), modes.end(),
                       [&](const ModeInfo& mode) { return *mode.judge != '\0' && runs(mode.judge); });
  });
}

std::set<std::string> referred_to(const Project& project, const std::vector<SweptResult>& columns) {
  std::set<std::string> paths(project.references.begin(), project.references.end());
  for (const SweptResult& column : columns) {
    for (const auto& reference : column.expression.references()) paths.insert(reference.path);
  }
  return paths;
}

}  // namespace

/// Kernels of all steps, laid out at the first point that is solved.
bool Variants::find_kernels(std::span<const double* const> in) {
  way_ = Way::alone;
  if (leaves_modes(project_) || !solve_point(in, 0)) return false;
  const std::set<std::string> wanted = referred_to(project_, columns_);
  for (const std::size_t i : project_.order) {
    auto* const step = dynamic_cast<CalculatorStep*>(project_.steps[i].get());
    auto kernel = step == nullptr ? nullptr : ColumnStep::of(*step, wanted);
    if (!kernel) {
      kernels_.clear();
      return false;
    }
    kernels_.push_back(std::move(kernel));
  }
  for (const std::string& path : wanted) {
    const Value* const value = project_.value(path);
    if (value != nullptr && !value->si.empty()) points_.constants[path] = value->si[0];
  }
  way_ = Way::columns;
  modes_.resize(kernels_.size());
  return true;
}

bool Variants::solve_columns(std::span<const double* const> in, std::span<double* const> out, std::size_t n) {
  if (way_ == Way::unknown && !find_kernels(in)) refusals_.clear();
  if (way_ == Way::alone) return false;
  points_.count = n;
  points_.is_other.assign(n, 0);
  points_.values.clear();
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    const auto put = [&](const std::string& path) { points_.values[path].assign(in[k], in[k] + n); };
    put(axes_[k].name);
    for (const SweptInput::Target& target : axes_[k].targets)
      put(target.step->name() + "." + target.step->input().reading.varied[target.varied].path);
  }
  for (std::size_t k = 0; k < kernels_.size(); ++k) kernels_[k]->evaluate(points_, modes_[k]);
  const Expression::Column column_of = [this](const std::string& path) { return points_.of(path); };
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    if (columns_[k].kind != SweptResult::Kind::expression) continue;
    if (!columns_[k].expression.evaluate(column_of, {out[k], n}))
      std::fill(points_.is_other.begin(), points_.is_other.end(), char{1});
  }
  read_verdicts(out, n);
  return true;
}

/// What columns of verdicts say, from the modes of all steps.
void Variants::read_verdicts(std::span<double* const> out, std::size_t n) {
  if (of_column_.empty()) find_modes_of_columns();
  const SweptResult* before = nullptr;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const SweptResult& column = columns_[k];
    if (column.kind == SweptResult::Kind::expression) continue;
    if (before == nullptr || before->step != column.step || before->mode != column.mode) fold(of_column_[k], n);
    before = &column;
    read_verdict(column, {out[k], n});
  }
}

static_assert(account::rank(account::State::pass) == static_cast<int>(account::State::pass) &&
                  account::rank(account::State::not_judged) == static_cast<int>(account::State::not_judged) &&
                  account::rank(account::State::fail) == static_cast<int>(account::State::fail),
              "the worst of several is the largest number");

/// Of one mode, or of several together.
void Variants::fold(const std::vector<const ModeColumns*>& modes, std::size_t n) {
  constexpr auto open = static_cast<signed char>(account::State::open);
  const signed char instead = project_.strict ? static_cast<signed char>(account::State::not_judged) : open;
  folded_.worst.assign(n, static_cast<signed char>(absent_state));
  folded_.judged.assign(n, 0);
  folded_.utilisation.assign(n, nan);
  signed char* const worst = folded_.worst.data();
  signed char* const judged = folded_.judged.data();
  double* const utilisation = folded_.utilisation.data();
  for (const ModeColumns* mode : modes) {
    const signed char* const state = mode->state.data();
    const double* const used = mode->utilisation.data();
    for (std::size_t i = 0; i < n; ++i) {
      const signed char here = state[i] == open ? instead : state[i];
      worst[i] = std::max(worst[i], here);
      judged[i] = static_cast<signed char>(judged[i] | ((here >= 0) & (here != open)));
    }
    for (std::size_t i = 0; i < n; ++i)
      utilisation[i] = used[i] > utilisation[i] || utilisation[i] != utilisation[i] ? used[i] : utilisation[i];
  }
}

void Variants::find_modes_of_columns() {
  for (const SweptResult& column : columns_) {
    std::vector<const ModeColumns*>& modes = of_column_.emplace_back();
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

/// As read() says it of a machine that was solved alone.
void Variants::read_verdict(const SweptResult& column, std::span<double> out) const {
  using account::State;
  constexpr auto open = static_cast<signed char>(State::open);
  const bool is_whole = column.mode.empty();
  switch (column.kind) {
    case SweptResult::Kind::utilisation:
      std::copy_n(folded_.utilisation.begin(), out.size(), out.begin());
      break;
    case SweptResult::Kind::passes:
      std::transform(out.begin(), out.end(), folded_.worst.begin(), out.begin(),
                     [](double, signed char worst) { return worst <= open ? 1.0 : 0.0; });
      break;
    default:
      for (std::size_t i = 0; i < out.size(); ++i) {
        const signed char worst = folded_.worst[i];
        const signed char passed = folded_.judged[i] != 0 ? static_cast<signed char>(State::pass) : open;
        out[i] = is_whole && worst <= open ? passed : worst;
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

double Variants::read(const SweptResult& column) const {
  using Kind = SweptResult::Kind;
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

double Variants::state_of(const SweptResult& column) const {
  const account::Modes modes = modes_in(project_, column);
  if (modes.empty()) return column.mode.empty() ? static_cast<double>(account::State::open) : absent_state;
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
