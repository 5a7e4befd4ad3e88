#include "lib/project/references/drives/one_drive.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double same_shaft = 0.02;
constexpr double same_data = 1e-6;

/// The source of an input that is a reference and nothing else; empty for any other.
std::string source_of(const Step& step, std::string_view key) {
  for (const Operand& operand : step.input().reading.operands) {
    if (operand.path == key && operand.expression.is_reference()) return operand.expression.references().front().path;
  }
  return {};
}

/// The path of the speed next to a torque: "worm.n_2" of "worm.T_2", "x.shafts[2].n" of "x.shafts[2].T".
std::string speed_beside(const std::string& torque) {
  const std::size_t at = torque.rfind(".T");
  if (at == std::string::npos) return {};
  const std::string rest = torque.substr(at + 2);
  return rest.empty() || rest.front() == '_' ? torque.substr(0, at) + ".n" + rest : "";
}

/// The records of a step that others take: "worm", "wheel".
std::set<std::string> records_taken(const Step& step, const Project& project) {
  std::set<std::string> all;
  for (const auto& other : project.steps) {
    for (const Taken& taken : other->input().reading.records) {
      const auto path = split_step(taken.source);
      if (path.first == step.name()) all.insert(path.second);
    }
  }
  return all;
}

/// Whether two steps of one calculator have the same speed and sizes.
bool is_same_drive(const Step& one, const Step& other, const Project& project) {
  constexpr std::array keys{"n_1", "z_1", "z_2", "d_1", "m_x", "m_n"};
  return std::ranges::all_of(keys, [&](const char* key) {
    const double a = own_value(one, project, key), b = own_value(other, project, key);
    return (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= same_data * std::abs(a);
  });
}

}  // namespace

std::vector<ReducedLoad> torques_at_other_speeds(const Step& step, const Project& project) {
  constexpr std::array<std::array<const char*, 2>, 2> sides{{{"T_1", "n_1"}, {"T", "n"}}};
  for (const auto& side : sides) {
    const std::string torque = source_of(step, side[0]), speed = source_of(step, side[1]);
    const std::string beside = speed_beside(torque);
    if (beside.empty() || speed.empty() || speed == beside) continue;
    if (split_step(torque).first != split_step(speed).first) continue;
    const double n = std::abs(magnitude_at(project, beside)), own = std::abs(magnitude_at(project, speed));
    if (std::isnan(n) || std::isnan(own) || std::abs(n - own) <= same_shaft * n) continue;
    return {{side[0], say("'{1}' acts at '{2}' = {3}, and {4} is '{5}' = {6}: take both of one shaft, or "
                          "because.{7} = \"...\"",
                          torque, beside, format_quantity(n, "rpm", 4), side[1], speed, format_quantity(own, "rpm", 4),
                          side[0])}};
  }
  return {};
}

std::vector<ReducedLoad> hands_in_disagreement(const Step& step, const Project& project) {
  if (find_field(step.input().calculator->input->fields, "hand") == nullptr) return {};
  const std::string hand = step.word("hand");
  const std::set<std::string> own = records_taken(step, project);
  if (hand.empty() || own.size() != 1) return {};
  for (const auto& other : project.steps) {
    if (other.get() == &step || other->input().calculator != step.input().calculator) continue;
    const std::string there = other->word("hand");
    if (there.empty() || there == hand || !is_same_drive(step, *other, project)) continue;
    const std::set<std::string> theirs = records_taken(*other, project);
    if (theirs.size() != 1 || theirs == own) continue;
    return {{"hand", say("hand is {1} here, where '{2}' is taken, and {3} in '{4}', whose '{5}' is taken: take both "
                         "gears from one step, or because.hand = \"...\"",
                         hand, *own.begin(), there, other->name(), *theirs.begin())}};
  }
  return {};
}

}  // namespace loadpath::project
