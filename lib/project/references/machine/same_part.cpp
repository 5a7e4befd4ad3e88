#include "lib/project/references/machine/same_part.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/units.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace loadpath::project {

namespace {

constexpr double same = 1e-3;  // of a value: sizes typed with few digits

bool is_outer_diameter(std::string_view key) { return key == "d" || key == "d_w" || key == "d_max" || key == "d_1"; }
bool is_side_of_plate(std::string_view key) { return key == "h" || key == "b" || key == "t"; }
bool is_radius(std::string_view key) { return key == "R" || key == "r" || key.starts_with("R_i") || key == "R_a"; }
bool is_diameter(std::string_view key) { return key.starts_with("D") || key.starts_with("d"); }

std::string_view key_in(std::string_view path) { return path.substr(path.rfind('.') + 1); }

/// A length that is a size of another step as it is, "=shaft.d".
struct TakenSize {
  const Operand* operand;
  const Step* source;
  std::string rest;  // "segments.a.d"
};

std::vector<TakenSize> sizes_taken(const Step& step, const Project& project) {
  std::vector<TakenSize> all;
  for (const Operand& operand : step.input().reading.operands) {
    if (operand.leaf.field->dimension != m.dimension() || !operand.expression.is_reference()) continue;
    auto [name, rest] = split_step(operand.expression.references().front().path);
    const Step* const source = project.find(name);
    if (source != nullptr && source != &step) all.push_back({&operand, source, std::move(rest)});
  }
  return all;
}

class PartCheck {
 public:
  PartCheck(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    for (const TakenSize& size : sizes_taken(step_, project_)) {
      compare_bore(size);
      compare_measure(size);
      if (is_of_same_body(size)) compare_material(size.operand->path, *size.source);
    }
    compare_bore_of_shaft();
    compare_seat();
    for (const Taken& record : step_.input().reading.records) {
      const auto [name, rest] = split_step(record.source);
      const Step* const source = project_.find(name);
      if (source != nullptr && key_in(rest) == "cycle") compare_material(record.path, *source), compare_bar(*source);
    }
    return std::move(found_);
  }

 private:
  /// A connection on a smaller diameter than the shaft in torsion that carries the same torque of [values].
  void compare_seat() {
    constexpr double step_of_bearing = 0.98;
    const auto torque = step_.input().reading.typed.find("T");
    if (id_of(step_) != "shaft.torsion" || torque == step_.input().reading.typed.end()) return;
    for (const auto& other : project_.steps) {
      const auto there = other->input().reading.typed.find("T");
      const bool is_alike = connects(*other) && there != other->input().reading.typed.end() &&
                            !torque->second.shared.empty() && there->second.shared == torque->second.shared;
      if (!is_alike) continue;
      const bool is_across = find_field(other->input().calculator->input->fields, "d_w") != nullptr;  // d of its pin
      const double d = own_value(step_, project_, "d"), seat = own_value(*other, project_, is_across ? "d_w" : "d");
      if (!(seat < step_of_bearing * d)) continue;
      found_.push_back({"d", say("d = {1}, and '{2}' with the same torque has {3}: assess the thinnest diameter of the "
                                 "shaft, or justify it: because.d = \"...\"",
                                 format_quantity(d, "mm", 4), other->name(), format_quantity(seat, "mm", 4))});
    }
  }

  void add(const std::string& path, Message message) {
    const auto is_it = [&](const ReducedLoad& one) { return one.path == path; };
    if (std::none_of(found_.begin(), found_.end(), is_it)) found_.push_back({path, std::move(message)});
  }

  [[nodiscard]] Leaf leaf(const std::string& path) const { return find_leaf(step_.input().reading.record, path); }

  /// The bore of the part whose diameter is taken: of the same element of a list, else of the whole part.
  double bore_of(const TakenSize& size) const {
    const std::string name = size.source->name() + ".";
    const double adjacent = magnitude_at(project_, name + prefix_of(size.rest) + "d_bore");
    return std::isnan(adjacent) ? magnitude_at(project_, name + "d_bore") : adjacent;
  }

  /// The key of the bore that belongs to a diameter of this step; empty if it has none.
  std::string own_bore(const std::string& prefix) const {
    for (const char* const key : {"d_bore", "d_i"}) {
      if (leaf(prefix + key)) return prefix + key;
    }
    return {};
  }

  void compare_bore(const TakenSize& size) {
    const std::string& path = size.operand->path;
    if (!is_outer_diameter(key_in(path)) || !is_outer_diameter(key_in(size.rest))) return;
    const double bore = bore_of(size);
    if (!(bore > 0.0)) return;
    const std::string own = own_bore(prefix_of(path)), text = format_quantity(bore, "mm", 4);
    if (own.empty()) {
      if (connects(step_))
        add(path, say("'{1}' has a bore of {2}, and the formulas are those of a solid shaft; justify it: because.{3} = "
                      "\"...\"",
                      size.source->name(), text, path));
      return;
    }
    if (is_less(own, bore))
      add(path,
          say("{1} is the diameter of '{2}', which has a bore of {3}: give {4} = \"{3}\", or because.{1} = \"...\"",
              path, size.source->name(), text, own));
  }

  /// A connection is on the shaft whose torque it takes, though it may type the diameter.
  void compare_bore_of_shaft() {
    const std::string own = own_bore("");
    if (own.empty() || !connects(step_) || !found_.empty()) return;
    for (const std::string& name : steps_loading(step_.input().reading)) {
      const double bore = magnitude_at(project_, name + ".d_bore");
      if (bore > 0.0 && is_less(own, bore))
        add(own, say("'{1}' has a bore of {2}: give {3} = \"{2}\", or because.{3} = \"...\"", name,
                     format_quantity(bore, "mm", 4), own));
    }
  }

  bool is_less(const std::string& own, double bore) const {
    return !(own_value(step_, project_, own) >= bore * (1.0 - same));
  }

  /// A radius in place of a diameter is half of it, a diameter in place of a radius twice.
  void compare_measure(const TakenSize& size) {
    const std::string& path = size.operand->path;
    const std::string_view here = key_in(path), there = key_in(size.rest);
    const std::string source = size.source->name() + "." + size.rest;
    if (is_diameter(here) && is_radius(there))
      add(path, say("{1} is a diameter, and '{2}' is a radius; justify it: because.{1} = \"...\"", path, source));
    if (is_radius(here) && is_diameter(there))
      add(path, say("{1} is a radius, and '{2}' is a diameter; justify it: because.{1} = \"...\"", path, source));
  }

  /// Whether a size shows that both steps describe one part: a round bar, whose bore this step takes too, or a plate.
  [[nodiscard]] bool is_of_same_body(const TakenSize& size) const {
    if (size.operand->of_record)
      return false;  // the eye of a pin has the plate of the joint, and the material of its own
    const std::string_view here = key_in(size.operand->path), there = key_in(size.rest);
    if (is_side_of_plate(here) && is_side_of_plate(there)) return true;
    return here == "d" && is_outer_diameter(there) && !own_bore(prefix_of(size.operand->path)).empty();
  }

  /// The material of a connection is that of its hub.
  void compare_material(const std::string& path, const Step& source) {
    if (connects(step_) || connects(source)) return;
    const std::string own = named_material(step_, project_), theirs = named_material(source, project_);
    if (!own.empty() && !theirs.empty() && own != theirs) {
      add(path, say("'{2}' is made of {3}, but this step uses {4} for the same part: because.{1} = \"...\"", path,
                    source.name(), theirs, own));
      return;
    }
    if (!own.empty()) return;
    for (const char* const key : {"R_e", "R_m"}) {
      const double here = own_value(step_, project_, key), there = magnitude_at(project_, source.name() + "." + key);
      if (here > there * (1.0 + same))
        add(path, say("{2} = {3}, but '{4}' has {5} for the same part: because.{1} = \"...\"", path, key,
                      format_quantity(here, "MPa", 4), source.name(), format_quantity(there, "MPa", 4)));
    }
  }

  /// The size that the fatigue strength is for, and the input with it: its own, or that of the limit that it takes.
  [[nodiscard]] std::pair<const char*, double> size_of_strength() const {
    const double own = own_value(step_, project_, "d_h");
    if (!std::isnan(own)) return {"d_h", own};
    for (const char* const key : {"sigma_D", "tau_D"}) {
      const Operand* const limit = step_.input().reading.operand(key);
      if (limit == nullptr || !limit->expression.is_reference()) continue;
      const std::string source = split_step(limit->expression.references().front().path).first;
      const double treated = magnitude_at(project_, source + ".d_h");
      return {key, std::isnan(treated) ? magnitude_at(project_, source + ".d") : treated};
    }
    return {"d_h", std::nan("")};
  }

  /// A solid bar that is thicker than the one of the fatigue strength. Its stress may come through a cycle of its own.
  void compare_bar(const Step& cycle) {
    constexpr double most = 1.05;  // of a diameter in round numbers
    const auto [key, size] = size_of_strength();
    std::set<std::string> parts = steps_named_in(cycle.input().reading);
    parts.insert(cycle.name());
    for (const std::string& name : parts) {
      const Step* const part = project_.find(name);
      if (part == nullptr || connects(*part)) continue;
      const std::string_view id = part->input().calculator->id;
      if (!id.starts_with("shaft.") && !id.starts_with("link.")) continue;
      const double d = magnitude_at(project_, name + ".d"), bore = magnitude_at(project_, name + ".d_bore");
      if (bore > 0.0 || !(d > most * size)) continue;
      add(key, say("the stress is that of '{1}', d = {2}, and the fatigue strength that of {3}: correct the size, or "
                   "because.{4} = \"...\"",
                   name, format_quantity(d, "mm", 4), format_quantity(size, "mm", 4), key));
    }
  }

  const Step& step_;
  const Project& project_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> values_of_same_part(const Step& step, const Project& project) {
  return PartCheck(step, project).run();
}

bool takes_sizes(const Step& step, const Project& project) { return !sizes_taken(step, project).empty(); }

}  // namespace loadpath::project
