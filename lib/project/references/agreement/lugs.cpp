#include "lib/project/references/agreement/lugs.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace loadpath::project {

namespace {

/// The sine of the 5 degrees by which a force may leave the axis of a lug.
constexpr double most_across = 0.0872;

bool is_lug(const Step& step) { return step.input().calculator->id == std::string_view("pin.lug"); }

/// Whether it assesses plates by their distances along and across the force.
bool has_plates(const Step& step) { return step.input().calculator->id == std::string_view("pin.en1993"); }

/// The input of a pin joint that is the thickness of this part of it.
std::string thickness_of(const std::string& part) { return part == "eye" ? "t_1" : part == "cheek" ? "t_2" : ""; }

/// "press.joints.A" of "press.joints.A.F"; empty of anything else.
std::string joint_of(const Step& step) {
  const Operand* const force = step.input().reading.operand("F");
  if (force == nullptr || force->expression.references().empty()) return {};
  const std::string& path = force->expression.references().front().path;
  const bool is_of_joint = split_step(path).second.starts_with("joints.") && path.ends_with(".F");
  return is_of_joint ? path.substr(0, path.size() - 2) : std::string();
}

/// What a lug is part of: a pin joint and its part, or the joint of a mechanism itself.
struct LugPlace {
  const Step* pin = nullptr;
  std::string part, joint;
};

LugPlace place_of_lug(const Step& lug, const Project& project) {
  for (const Taken& record : lug.input().reading.records) {
    const auto [name, rest] = split_step(record.source);
    const Step* const pin = project.find(name);
    if (record.path == "load" && pin != nullptr && !thickness_of(rest).empty()) return {pin, rest, joint_of(*pin)};
  }
  return {nullptr, "", joint_of(lug)};
}

class LugCheck {
 public:
  LugCheck(const Step& lug, const Project& project) : lug_(lug), project_(project), at_(place_of_lug(lug, project)) {}

  std::vector<ReducedLoad> run() {
    if (!find_links()) return {};
    if (has_plates(lug_)) return of_plates();
    const int own = own_link();
    for (const int k : {0, 1}) {
      if ((own == k || (own < 0 && is_on_either(k))) && is_crossed(k)) return {held(k)};
    }
    return {};
  }

 private:
  /// The links of the joint; false if it is of no mechanism.
  bool find_links() {
    const auto [name, rest] = split_step(at_.joint);
    const Step* const mechanism = at_.joint.empty() ? nullptr : project_.find(name);
    if (mechanism == nullptr) return false;
    mechanism_ = name;
    for (const int k : {0, 1}) {
      const Leaf leaf =
          find_leaf(mechanism->input().reading.record, rest + ".links." + std::string(k == 0 ? "first" : "second"));
      if (leaf) links_[static_cast<std::size_t>(k)] = leaf.field->text(leaf.owner);
    }
    return true;
  }

  /// End and edge distances of the plate of a link that the force crosses; of unknown plates those of both.
  [[nodiscard]] std::vector<ReducedLoad> of_plates() const {
    const std::array<int, 2> found{link_behind(lug_, "t_1"), link_behind(lug_, "t_2")};
    std::vector<ReducedLoad> held;
    for (const std::size_t plate : {0U, 1U}) {
      const int known = found[plate] >= 0 ? found[plate] : found[1 - plate] >= 0 ? 1 - found[1 - plate] : -1;
      const std::string end = plate == 0 ? "e_a1" : "e_a2";
      for (const int k : {0, 1}) {
        if ((known >= 0 && known != k) || !is_crossed(k) || std::isnan(own_value(lug_, project_, end))) continue;
        held.push_back(
            {end, say("force across the plate: '{1}' has up to {2} across the axis of link '{3}', and {4} is the end "
                      "distance along the force: assess this separately and say how: {5} = \"...\"",
                      at_.joint, format_quantity(across(k), "kN", 3), links_[static_cast<std::size_t>(k)], end,
                      because_key(end))});
        break;
      }
    }
    return held;
  }

  [[nodiscard]] double across(int k) const {
    return magnitude_at(project_, at_.joint + ".F_t" + std::to_string(k + 1));
  }
  [[nodiscard]] bool is_crossed(int k) const {
    return across(k) > most_across * magnitude_at(project_, at_.joint + ".F");
  }

  /// The link whose step of link.member an input takes its value from; negative if none is.
  [[nodiscard]] int link_behind(const Step& step, const std::string& key) const {
    const Operand* const operand = key.empty() ? nullptr : step.input().reading.operand(key);
    if (operand == nullptr) return -1;
    for (const auto& reference : operand->expression.references()) {
      const Step* const bar = project_.find(split_step(reference.path).first);
      if (bar == nullptr) continue;
      for (const Taken& record : bar->input().reading.records) {
        for (const int k : {0, 1}) {
          if (record.source == mechanism_ + ".links." + links_[static_cast<std::size_t>(k)]) return k;
        }
      }
    }
    return -1;
  }

  /// The link of a part by its thickness or width.
  [[nodiscard]] int link_of(const Step& lug, const std::string& part) const {
    for (const char* const key : {"t", "b"}) {
      if (const int k = link_behind(lug, key); k >= 0) return k;
    }
    return at_.pin == nullptr ? -1 : link_behind(*at_.pin, thickness_of(part));
  }

  [[nodiscard]] const Step* other_lug() const {
    for (const auto& step : project_.steps) {
      if (step.get() == &lug_ || !is_lug(*step) || at_.pin == nullptr) continue;
      const LugPlace there = place_of_lug(*step, project_);
      if (there.pin == at_.pin && there.part != at_.part) return step.get();
    }
    return nullptr;
  }

  /// Of eye and cheek, one belongs to each link.
  [[nodiscard]] int own_link() const {
    if (const int k = link_of(lug_, at_.part); k >= 0) return k;
    if (at_.pin == nullptr) return -1;
    const std::string other = at_.part == "eye" ? "cheek" : "eye";
    const Step* const lug = other_lug();
    const int theirs = lug != nullptr ? link_of(*lug, other) : link_behind(*at_.pin, thickness_of(other));
    return theirs < 0 ? -1 : 1 - theirs;
  }

  /// Of a lug whose link is not known: whether a lug of this link is among those assessed at the joint.
  [[nodiscard]] bool is_on_either(int k) const { return other_lug() != nullptr || is_crossed(1 - k); }

  [[nodiscard]] ReducedLoad held(int k) const {
    const std::string& link = links_[static_cast<std::size_t>(k)];
    const std::string key = at_.pin == nullptr ? "t" : thickness_of(at_.part);
    const std::string path = at_.pin == nullptr ? "F" : "load";
    return {path,
            own_link() == k
                ? say("force across the lug: '{1}' has up to {2} across the axis of link '{3}', and the lug is "
                      "assessed along it; assess this separately and say how: {4} = \"...\"",
                      at_.joint, format_quantity(across(k), "kN", 3), link, because_key(path))
                : say("force across the lug: '{1}' has up to {2} across the axis of link '{3}', which this lug may "
                      "belong to: take {5} from the step of its link, or say how this is assessed: {4} = \"...\"",
                      at_.joint, format_quantity(across(k), "kN", 3), link, because_key(path), key)};
  }

  const Step& lug_;
  const Project& project_;
  LugPlace at_;
  std::string mechanism_;
  std::array<std::string, 2> links_;
};

bool is_pin_joint(const Step& step) { return step.input().calculator->id == std::string_view("pin.joint"); }

/// The values of [values] in the force of a step, of one dimension: the forces, or the factors without one.
std::set<std::string> shared_in_force(const Step& step, const Project& project, const Dimension& dimension) {
  std::set<std::string> all;
  const auto add = [&](const std::string& path) {
    const Value* const value = path.starts_with("values.") ? project.values.fixed(path.substr(7)) : nullptr;
    if (value != nullptr && value->signature.dimension == dimension) all.insert(path);
  };
  const auto& reading = step.input().reading;
  if (const auto typed = reading.typed.find("F"); typed != reading.typed.end()) add(typed->second.shared);
  if (const Operand* const force = step.input().reading.operand("F"); force != nullptr) {
    for (const auto& reference : force->expression.references()) add(reference.path);
  }
  return all;
}

const Dimension of_force = Dimension::of(1, 1, -2), of_number = Dimension::of(0, 0, 0);

/// The only pin joint of a file, where a lug with its load from the same value of [values] does not refer to it.
const Step* pin_of_lug(const Step& lug, const Project& project) {
  const Step* pin = nullptr;
  for (const auto& step : project.steps) {
    if (is_pin_joint(*step) && std::exchange(pin, step.get()) != nullptr) return nullptr;
  }
  if (pin == nullptr) return nullptr;
  for (const Taken& record : lug.input().reading.records) {
    if (split_step(record.source).first == pin->name()) return nullptr;
  }
  const auto own = shared_in_force(lug, project, of_force), there = shared_in_force(*pin, project, of_force);
  return !own.empty() && own == there ? pin : nullptr;
}

/// Diameter and force of a lug next to those of the pin in it.
std::vector<ReducedLoad> lug_of_pin(const Step& lug, const Project& project) {
  constexpr double as_rounded = 1e-3, play = 0.1;
  const Step* const pin = pin_of_lug(lug, project);
  if (pin == nullptr) return {};
  const double d = own_value(lug, project, "d"), of_pin = own_value(*pin, project, "d");
  if (std::abs(d - of_pin) > play * of_pin)
    return {{"d", say("d = {1}, and the pin '{2}' of the same load has {3}: take load = \"={2}.eye\" or "
                      "\"={2}.cheek\", or because.d = \"...\"",
                      format_quantity(d, "mm", 4), pin->name(), format_quantity(of_pin, "mm", 4))}};
  const double F = std::abs(own_value(lug, project, "F")), there = std::abs(own_value(*pin, project, "F"));
  const double t = own_value(lug, project, "t"), t_1 = own_value(*pin, project, "t_1");
  if (!is_near(t, t_1, as_rounded) || !(F < (1.0 - as_rounded) * there)) return {};
  return {{"F", say("F = {1}, and the pin '{2}' in this eye carries {3}: take load = \"={2}.eye\", or because.F = "
                    "\"...\"",
                    format_quantity(F, "kN", 4), pin->name(), format_quantity(there, "kN", 4))}};
}

/// Force of a pin next to that of a lug, which has a factor of [values] that the pin does not have.
std::vector<ReducedLoad> pin_of_lugs(const Step& pin, const Project& project) {
  constexpr double as_rounded = 1e-3;
  for (const auto& lug : project.steps) {
    if (!is_lug(*lug) || pin_of_lug(*lug, project) != &pin) continue;
    const double F = std::abs(own_value(pin, project, "F")), there = std::abs(own_value(*lug, project, "F"));
    const auto factors = shared_in_force(*lug, project, of_number), own = shared_in_force(pin, project, of_number);
    if (!(F < (1.0 - as_rounded) * there) || std::ranges::includes(own, factors)) continue;
    return {{"F", say("F = {1}, and the lug '{2}' of this pin carries {3}; justify it: because.F = \"...\"",
                      format_quantity(F, "kN", 4), lug->name(), format_quantity(there, "kN", 4))}};
  }
  return {};
}

}  // namespace

std::vector<ReducedLoad> forces_across_lugs(const Step& step, const Project& project) {
  if (is_pin_joint(step)) return pin_of_lugs(step, project);
  if (!is_lug(step) && !has_plates(step)) return {};
  std::vector<ReducedLoad> found = LugCheck(step, project).run();
  if (!found.empty() || !is_lug(step)) return found;
  return lug_of_pin(step, project);
}

}  // namespace loadpath::project
