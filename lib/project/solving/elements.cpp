#include "lib/project/solving/elements.hpp"

#include "lib/project/modes.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

namespace {

using account::State;

/// The elements of the list that a mode concerns.
struct Elements {
  const Step& part;
  const FieldInfo& list;
  std::string_view loads;  // the list of results with the loads before and behind each element: "shafts"

  [[nodiscard]] void* owner() const { return part.input().reading.record.data.get(); }
  [[nodiscard]] std::size_t count() const { return list.size(owner()); }
  /// "train.stages.first", "train.stages[1]".
  [[nodiscard]] std::string by_name(std::size_t i) const {
    return part.name() + "." + list.key + element_path(list, owner(), i);
  }
  [[nodiscard]] std::string by_number(std::string_view key, std::size_t i) const {
    return part.name() + "." + std::string(key) + "[" + std::to_string(i + 1) + "]";
  }
};

std::optional<Elements> elements_of(const Step& part, const ModeInfo& mode) {
  if (*mode.each == '\0') return std::nullopt;
  const FieldInfo* const list = find_field(part.input().calculator->input->fields, mode.each);
  if (list == nullptr || list->type != FieldInfo::Type::list) return std::nullopt;
  return Elements{part, *list, mode.loads};
}

/// Whether a quantity of the whole part is that of the shaft before the first element, its inputs and "T_1", or behind
/// the last one, "T_out". Others are of neither: the loss of power.
bool is_of_end(const Elements& all, std::string_view key, std::size_t i) {
  const bool enters = key.ends_with("_1") || find_field(all.part.input().calculator->input->fields, key) != nullptr;
  return (i == 0 && enters) || (i + 1 == all.count() && key.ends_with("_out"));
}

/// Whether a step refers to the element, and to its load: torque or power of the shaft before or behind it, or those at
/// the same end of the whole part.
bool assesses(const Step& judge, const Elements& all, std::size_t i) {
  const std::string name = all.by_name(i) + ".", number = all.by_number(all.list.key, i) + ".";
  const std::string before = all.by_number(all.loads, i) + ".", behind = all.by_number(all.loads, i + 1) + ".";
  const std::string whole = all.part.name() + ".";
  bool takes_size = false, takes_load = false;
  for (const Operand& operand : judge.input().reading.operands) {
    for (const auto& reference : operand.expression.references()) {
      const std::string& path = reference.path;
      takes_size = takes_size || path.starts_with(name) || path.starts_with(number);
      const bool is_whole = path.starts_with(whole) && path.find_first_of(".[", whole.size()) == std::string::npos &&
                            is_of_end(all, path.substr(whole.size()), i);
      if (!is_whole && !path.starts_with(before) && !path.starts_with(behind)) continue;
      const auto signature = all.part.signature(path.substr(whole.size()));
      const bool is_speed = signature && signature->dimension.without_angle() == Dimension::of(0, 0, -1);
      takes_load = takes_load || (signature && !is_speed && !signature->dimension.is_number());
    }
  }
  return takes_size && takes_load;
}

/// The modes of strength of the steps that assess an element; empty if there is none.
std::vector<const account::Mode*> judges_of(const Elements& all, std::size_t i, const ModeInfo& mode,
                                            const Project& project) {
  const auto calculators = listed_keys(mode.add);
  std::vector<const account::Mode*> judges;
  for (const auto& step : project.steps) {
    const std::string_view id = step->input().calculator->id;
    if (std::find(calculators.begin(), calculators.end(), id) == calculators.end() || !assesses(*step, all, i))
      continue;
    for (const account::Mode& own : step->account().modes) {
      if (own.kind == ModeKind::strength && own.state != State::open) judges.push_back(&own);
    }
  }
  return judges;
}

/// "gear.pair, chain.roller": the calculators of the steps of these modes.
std::string calculators_of(const std::vector<const account::Mode*>& modes, const Project& project) {
  std::string all;
  for (const account::Mode* mode : modes) {
    const std::string id = project.find(mode->step)->input().calculator->id;
    if (all.find(id) == std::string::npos) all += (all.empty() ? "" : ", ") + id;
  }
  return all;
}

void settle_mode(account::Mode& mode, const ModeInfo& info, const Elements& all, const Project& project) {
  std::vector<const account::Mode*> judges;
  std::string unchecked;
  for (std::size_t i = 0; i < all.count(); ++i) {
    const auto own = judges_of(all, i, info, project);
    judges.insert(judges.end(), own.begin(), own.end());
    if (own.empty()) unchecked += (unchecked.empty() ? "" : ", ") + all.by_name(i).substr(all.part.name().size() + 1);
  }
  if (judges.empty()) return;
  if (unchecked.empty()) {
    settle(mode, judges);
    mode.judge = calculators_of(judges, project);
    return;
  }
  mode.note = say("no step takes size and load of {1}", unchecked);
}

}  // namespace

void settle_elements(Project& project) {
  for (const auto& step : project.steps) {
    for (account::Mode& mode : step->modes()) {
      const auto& infos = step->input().calculator->modes;
      const auto info = std::find_if(infos.begin(), infos.end(), [&](const ModeInfo& i) { return mode.id == i.id; });
      const bool waits = mode.state == State::open || mode.state == State::not_judged;
      if (info == infos.end() || !waits) continue;
      if (const auto all = elements_of(*step, *info)) settle_mode(mode, *info, *all, project);
    }
  }
}

bool leaves_elements(const Project& project) {
  const auto is_left = [&](const ModeInfo& mode) {
    const auto calculators = listed_keys(mode.add);
    return *mode.each != '\0' && std::any_of(project.steps.begin(), project.steps.end(), [&](const auto& step) {
      return std::find(calculators.begin(), calculators.end(), step->input().calculator->id) != calculators.end();
    });
  };
  return std::any_of(project.steps.begin(), project.steps.end(), [&](const auto& step) {
    const auto& modes = step->input().calculator->modes;
    return std::any_of(modes.begin(), modes.end(), is_left);
  });
}

}  // namespace loadpath::project
