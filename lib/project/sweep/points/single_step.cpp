#include "lib/project/sweep/points/single_step.hpp"

#include "lib/project/project.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/project/run/calculator_step.hpp"
#include "lib/sweep/nan.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

/// Whether all values that it takes from others, or is compared with, are numbers, and no factor that decides on
/// permitted combinations.
bool takes_numbers(const Step& step) {
  const Reading& reading = step.input().reading;
  const auto is_number = [](const Varied& v) { return v.leaf && v.words.empty() && !v.leaf.field->is_factor; };
  const auto is_factor = [](const Operand& o) { return o.leaf.field->is_factor; };
  const auto is_word = [](const TypedOverride& kept) { return kept.is_word; };
  return reading.taken.empty() && std::none_of(reading.kept.begin(), reading.kept.end(), is_word) &&
         std::all_of(reading.varied.begin(), reading.varied.end(), is_number) &&
         std::none_of(reading.operands.begin(), reading.operands.end(), is_factor);
}

}  // namespace

SingleStep::SingleStep(Step& step, const Wanted& wanted) : step_(step), wanted_(wanted) {}

std::unique_ptr<SingleStep> SingleStep::of(Step& step, const Wanted& wanted, const std::set<std::string>& referred,
                                           const PointColumns& points) {
  return of_body(step, {}, wanted, referred, points);
}

std::unique_ptr<SingleStep> SingleStep::of_body(Step& step, const std::vector<Step*>& body, const Wanted& wanted,
                                                const std::set<std::string>& referred, const PointColumns& points) {
  const auto* const calculator = dynamic_cast<const CalculatorStep*>(&step);
  if (!takes_numbers(step)) return nullptr;
  std::unique_ptr<SingleStep> alone(new SingleStep(step, wanted));
  alone->body_ = body;
  const auto refer_to = [&](const std::string& path) { alone->refer_to(path, points); };
  for_each_reference(step.input().reading, refer_to);
  for_each_compared(step.input(), refer_to);
  if (calculator != nullptr) {
    for (const Provided& provided : calculator->provided()) {
      for (const std::string& path : provided.companions) alone->refer_to(path, points);
    }
    for (const LoadComponent& component : calculator->components_not_included())
      alone->refer_to(component.path, points);
  }
  for (const std::string& path : referred) {
    const auto signature = points.signatures.find(path);
    if (path.starts_with(step.name() + ".") && signature != points.signatures.end())
      alone->written_.push_back({path.substr(step.name().size() + 1), path, signature->second});
  }
  return alone;
}

void SingleStep::refer_to(const std::string& path, const PointColumns& points) {
  const auto signature = points.signatures.find(path);
  if (signature != points.signatures.end() && in_body(path) == nullptr) referred_[path] = {signature->second, {}};
}

/// The other step of the body that a path is of.
const Step* SingleStep::in_body(const std::string& path) const {
  const std::string name = split_step(path).first;
  const auto found = std::ranges::find_if(body_, [&](const Step* other) { return other->name() == name; });
  return found == body_.end() || *found == &step_ ? nullptr : *found;
}

Known SingleStep::known() const {
  static const Value none{{}, {nan}};
  return {.value = [this](const std::string& path) -> const Value& {
            const auto found = referred_.find(path);
            if (found != referred_.end()) return found->second;
            const Step* const other = in_body(path);
            const Value* const value = other == nullptr ? nullptr : other->value(split_step(path).second);
            return value == nullptr ? none : *value;
          },
          .word = [](const std::string&) { return std::string(); },
          .within = [](const std::string&) { return std::vector<std::pair<std::string, const Entry*>>(); }};
}

void SingleStep::start(PointColumns& points, std::vector<account::ModeColumns>& modes) {
  modes.resize(step_.input().calculator->modes.size());
  for (account::ModeColumns& mode : modes) {
    mode.state.assign(points.count, account::absent_state);
    mode.utilisation.assign(points.count, nan);
  }
  for (const Written& written : written_) {
    if (written.signature.axis == nullptr) points.values[written.path].assign(points.count, nan);
  }
  axes_.clear();
}

bool SingleStep::solve_at(PointColumns& points, std::size_t point) {
  return set_inputs(points, point) && solve(points, point);
}

bool SingleStep::take(PointColumns& points, std::size_t point, std::vector<account::ModeColumns>& modes) {
  const bool taken = take_modes(point, modes) && take_values(points, point);
  if (!keeps_axes(points.speeds_matter)) points.axes_differ = true;
  return taken;
}

void SingleStep::evaluate(PointColumns& points, std::vector<account::ModeColumns>& modes) {
  start(points, modes);
  for (std::size_t point = 0; point < points.count; ++point) {
    if (points.is_other[point] != 0) continue;
    const bool solved = solve_at(points, point);
    if (!solved || !take(points, point, modes)) points.is_other[point] = 1;
    if (!solved && !keeps_axes(points.speeds_matter)) points.axes_differ = true;
  }
}

bool SingleStep::reads_axes() const {
  return std::any_of(referred_.begin(), referred_.end(), [](const auto& r) { return r.second.is_series(); });
}

/// Whether all series lie over the places of the first point.
bool SingleStep::keeps_axes(bool with_speed) {
  const auto same = [with_speed](const Axis& a, const Axis& b) {
    return a.at == b.at && a.share == b.share && a.period == b.period && (!with_speed || a.speed == b.speed);
  };
  const Axis* before = nullptr;  // most series lie over one axis
  return std::all_of(written_.begin(), written_.end(), [&](const Written& written) {
    const Axis* const axis = written.signature.axis;
    if (axis == nullptr || axis == before) return true;
    before = axis;
    return same(axes_.try_emplace(axis, *axis).first->second, *axis);
  });
}

/// False if a field refuses its value.
bool SingleStep::set_inputs(const PointColumns& points, std::size_t point) {
  for (const Varied& varied : step_.input().reading.varied) {
    const double si = points.values.find(step_.name() + "." + varied.path)->second[point];
    if (!varied.leaf.field->bounds.holds(si)) return false;
    varied.leaf.set(si);
  }
  return true;
}

bool SingleStep::solve(PointColumns& points, std::size_t point) {
  for (auto& [path, value] : referred_) points.read(path, point, value);
  std::vector<Issue> issues;
  step_.forget();
  step_.solve(known(), wanted_, issues);
  return !has_errors(issues);
}

bool SingleStep::take_modes(std::size_t point, std::vector<account::ModeColumns>& modes) const {
  const auto& known = step_.input().calculator->modes;
  for (const account::Mode& mode : step_.account().modes) {
    const auto same =
        std::find_if(known.begin(), known.end(), [&](const ModeInfo& info) { return info.id == mode.id; });
    if (same == known.end()) return false;  // a missing input or load
    account::ModeColumns& columns = modes[static_cast<std::size_t>(same - known.begin())];
    columns.state[point] = static_cast<double>(mode.state);
    columns.utilisation[point] = mode.utilisation.value_or(nan);
  }
  return true;
}

/// False if a series is not as long as its axis.
bool SingleStep::take_values(PointColumns& points, std::size_t point) {
  for (const Written& written : written_) {
    const Value* const value = step_.value(written.within);
    if (written.signature.axis == nullptr) {
      if (value != nullptr) points.values[written.path][point] = value->si[0];
      continue;
    }
    const std::size_t positions = positions_of(written.signature.axis);
    if (value == nullptr || value->si.size() != positions) return false;
    SeriesColumn& column = points.series[written.path];
    column.si.resize(points.count * positions);
    column.rounding.resize(points.count);
    std::ranges::copy(value->si, column.si.begin() + static_cast<std::ptrdiff_t>(point * positions));
    column.rounding[point] = value->rounding;
  }
  return true;
}

}  // namespace loadpath::project
