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
constexpr double same_mesh = 1e-3;  // of the speeds of two gears in mesh: typed with few digits

/// The source of an input that is a reference and nothing else; empty for any other.
std::string source_of(const Step& step, std::string_view key) {
  for (const Operand& operand : step.input().reading.operands) {
    if (operand.path == key && operand.expression.is_reference()) return operand.expression.references().front().path;
  }
  return {};
}

/// The path of the speed next to a torque: "worm.n_2" of "worm.T_2", "x.shafts[2].n" of "x.shafts[2].T".
std::string speed_of_torque(const std::string& torque) {
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

bool are_equal(double a, double b, double tolerance) {
  return (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= tolerance * std::abs(a);
}

/// Whether two steps of one calculator have the same speed and sizes.
bool is_same_drive(const Step& one, const Step& other, const Project& project) {
  constexpr std::array keys{"n_1", "z_1", "z_2", "d_1", "m_x", "m_n"};
  return std::ranges::all_of(keys, [&](const char* key) {
    return are_equal(own_value(one, project, key), own_value(other, project, key), same_data);
  });
}

/// Whether gear 1 of a step is gear 2 of the other one: an external pair that each step describes from its own shaft.
bool is_same_pair_from_its_mate(const Step& one, const Step& other, const Project& project) {
  const auto here = [&](const char* key) { return own_value(one, project, key); };
  const auto there = [&](const char* key) { return own_value(other, project, key); };
  const double pitch_speed = std::abs(here("n_1") * here("z_1"));
  const Leaf mesh = find_leaf(one.input().reading.record, "mesh");
  return mesh && word_of(mesh) == "external" && here("z_1") == there("z_2") && here("z_2") == there("z_1") &&
         are_equal(here("m_n"), there("m_n"), same_data) && are_equal(here("beta"), there("beta"), same_data) &&
         are_equal(pitch_speed, std::abs(there("n_1") * there("z_1")), same_mesh);
}

/// The hand that a step calculates with: stated, taken or by default; empty where it has no effect.
std::string hand_of(const Step& step, const Project& project) {
  const Leaf leaf = find_leaf(step.input().reading.record, "hand");
  if (!leaf || own_value(step, project, "beta") == 0.0) return {};
  const std::string word = step.word("hand");
  return word.empty() ? word_of(leaf) : word;
}

}  // namespace

std::vector<ReducedLoad> torques_at_other_speeds(const Step& step, const Project& project) {
  constexpr std::array<std::array<const char*, 2>, 2> sides{{{"T_1", "n_1"}, {"T", "n"}}};
  for (const auto& side : sides) {
    const std::string torque = source_of(step, side[0]), speed = source_of(step, side[1]);
    const std::string its_speed = speed_of_torque(torque);
    if (its_speed.empty() || speed.empty() || speed == its_speed) continue;
    if (split_step(torque).first != split_step(speed).first) continue;
    const double n = std::abs(magnitude_at(project, its_speed)), own = std::abs(magnitude_at(project, speed));
    if (!(std::abs(n - own) > same_shaft * n)) continue;
    return {{side[0], say("'{1}' acts at '{2}' = {3}, and {4} is '{5}' = {6}: take both of one shaft, or "
                          "because.{7} = \"...\"",
                          torque, its_speed, format_quantity(n, "rpm", 4), side[1], speed,
                          format_quantity(own, "rpm", 4), side[0])}};
  }
  return {};
}

std::vector<ReducedLoad> hands_in_disagreement(const Step& step, const Project& project) {
  const std::string hand = hand_of(step, project);
  const std::set<std::string> own = records_taken(step, project);
  if (hand.empty() || own.size() != 1) return {};
  for (const auto& other : project.steps) {
    if (other.get() == &step || other->input().calculator != step.input().calculator) continue;
    const std::string there = hand_of(*other, project);
    const std::set<std::string> theirs = records_taken(*other, project);
    if (there.empty() || theirs.size() != 1) continue;
    if (there != hand && theirs != own && is_same_drive(step, *other, project))
      return {{"hand", say("hand is {1} here, where '{2}' is taken, and {3} in '{4}', whose '{5}' is taken: take both "
                           "gears from one step, or because.hand = \"...\"",
                           hand, *own.begin(), there, other->name(), *theirs.begin())}};
    if (there == hand && theirs == own && is_same_pair_from_its_mate(step, *other, project))
      return {{"hand", say("hand is {1} here and in '{2}', which has the mating gear: the gears of an external pair "
                           "have opposite hands; correct one, or because.hand = \"...\"",
                           hand, other->name())}};
  }
  return {};
}

}  // namespace loadpath::project
