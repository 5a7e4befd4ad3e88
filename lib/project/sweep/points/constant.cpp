#include "lib/project/sweep/points/constant.hpp"

#include "lib/project/project.hpp"

#include <algorithm>

namespace loadpath::project {

std::unique_ptr<ConstantStep> ConstantStep::of(const Step& step, const std::set<std::string>& referred,
                                               PointColumns& points) {
  std::unique_ptr<ConstantStep> constant(new ConstantStep);
  const auto& known = step.input().calculator->modes;
  constant->states_.resize(known.size());
  for (const account::Mode& mode : step.account().modes) {
    const auto same =
        std::find_if(known.begin(), known.end(), [&](const ModeInfo& info) { return info.id == mode.id; });
    if (same == known.end()) return nullptr;
    account::Judged& state = constant->states_[static_cast<std::size_t>(same - known.begin())];
    state.state = account::number(mode.state);
    if (mode.utilisation) state.utilisation = *mode.utilisation;
  }
  for (const std::string& path : referred) {
    const auto [name, within] = split_step(path);
    if (name != step.name()) continue;
    points.same_everywhere.insert(path);
    const Value* const value = step.value(within);
    if (value != nullptr && value->is_series()) constant->series_.emplace_back(path, *value);
  }
  return constant;
}

void ConstantStep::evaluate(PointColumns& points, std::vector<account::ModeColumns>& modes) {
  modes.resize(states_.size());
  for (std::size_t k = 0; k < states_.size(); ++k) {
    modes[k].state.assign(points.count, states_[k].state);
    modes[k].utilisation.assign(points.count, states_[k].utilisation);
  }
  for (const auto& [path, value] : series_) {  // single values are constants of the points
    SeriesColumn& column = points.series[path];
    if (column.rounding.size() >= points.count) continue;
    column.rounding.assign(points.count, value.rounding);
    column.si.clear();
    column.si.reserve(points.count * value.si.size());
    for (std::size_t point = 0; point < points.count; ++point)
      column.si.insert(column.si.end(), value.si.begin(), value.si.end());
  }
}

}  // namespace loadpath::project
