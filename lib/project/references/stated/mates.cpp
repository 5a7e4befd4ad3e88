#include "lib/project/references/stated/mates.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/stated/dimensions.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double fitted = 0.02;   // of sizes that are rounded
constexpr double of_hole = 0.12;  // of the diameters of a pin and its hole

using Keys = std::initializer_list<const char*>;

/// The value of an input: typed, of a row, found; or a result.
double size_at(const Step& step, const Project& project, const std::string& key) {
  const double own = std::abs(own_value(step, project, key));
  return std::isnan(own) ? std::abs(magnitude_at(project, step.name() + "." + key)) : own;
}

/// Whether the name is a diameter, a width or a thickness by its first or its last word.
bool is_size(std::string_view name, std::initializer_list<std::string_view> words) {
  return has_word(name.substr(0, name.find('_')), words) || has_word(name.substr(name.rfind('_') + 1), words);
}

bool is_diameter(std::string_view name) { return is_size(name, {"d", "dia", "diameter"}); }
bool is_width(std::string_view name) { return is_size(name, {"b", "width", "w"}); }
bool is_thickness(std::string_view name) { return is_size(name, {"t", "thickness"}); }

class Mates {
 public:
  Mates(const Step& step, const Project& project) : step_(step), project_(project), id_(id_of(step)) {}

  std::vector<ReducedLoad> run() {
    for (const auto& [name, value] : project_.values.unused()) {
      const double si = value.si.front();
      if (value.signature.dimension == stated::force) compare_pull(name, si);
      if (!(value.signature.dimension == stated::length) || !(si > 0.0)) continue;
      if (is_width(name)) compare_width(name, si);
      if (has_word(name, {"max", "min", "adm", "lim"})) continue;  // limits
      if (is_diameter(name)) compare_shaft(name, si), compare_pin(name, si);
      if (is_thickness(name)) compare_plates(name, si);
    }
    return std::move(found_);
  }

 private:
  /// Whether a step has this size under one of these keys; of shafts, any diameter of a segment.
  [[nodiscard]] bool has_size(double si, Keys keys, double share) const {
    return std::ranges::any_of(project_.steps, [&](const auto& step) {
      if (std::ranges::any_of(keys, [&](const char* key) { return is_near(size_at(*step, project_, key), si, share); }))
        return true;
      bool found = false;
      for_each_leaf(step->input().reading.record, [&](const std::string& path, const Leaf&) {
        found = found || (path.ends_with(".d") && is_near(size_at(*step, project_, path), si, share));
      });
      return found;
    });
  }

  /// "d_shaft" next to a hub, a bearing or a ring of another bore.
  void compare_shaft(const std::string& name, double si) {
    const bool is_on_shaft = connects(step_) || id_ == "bearing.rolling" || id_ == "shaft.circlip";
    const bool is_meant = has_word(name, {"shaft", "journal"}) || (connects(step_) && has_word(name, {"motor"}));
    if (!is_on_shaft || !is_meant || has_size(si, {"d", "d_1", "d_2"}, fitted)) return;
    add(std::isnan(size_at(step_, project_, "d")) ? "d_1" : "d", name, si);
  }

  /// "d_pin", "d_hole" next to a pin or a lug of another diameter.
  void compare_pin(const std::string& name, double si) {
    const bool is_meant = has_word(name, {"pin", "bolt", "shackle", "hole", "eye"});
    const double share = has_word(name, {"hole", "eye"}) ? of_hole : fitted;
    if (id_.starts_with("pin.") && is_meant && !has_size(si, {"d", "d_0"}, share)) add("d", name, si);
  }

  /// "t_fork" next to other plates of a pin.
  void compare_plates(const std::string& name, double si) {
    const bool is_meant = has_word(name, {"fork", "cheek", "clevis", "eye", "lug", "plate"});
    if (!id_.starts_with("pin.") || !is_meant || has_size(si, {"t", "t_1", "t_2", "b", "h"}, fitted)) return;
    for (const char* const key : {"t_1", "t"}) {
      if (!std::isnan(size_at(step_, project_, key))) return add(key, name, si);
    }
  }

  /// "b_pulley" below the width of the belt, of the silent chain or of the friction wheels.
  void compare_width(const std::string& name, double si) {
    const bool is_drive = id_.starts_with("belt.") || id_ == "chain.inverted_tooth" || id_ == "drive.friction_wheels";
    if (!is_drive || !has_word(name, {"pulley", "pulleys", "sprocket", "sprockets", "wheel", "rim", "face", "max"}))
      return;
    const double b = size_at(step_, project_, "b"), B = size_at(step_, project_, "B");
    const double here = std::isnan(b) ? B : b;
    if (si < (1.0 - fitted) * here) add(std::isnan(b) ? "P" : "b", name, si, here);
  }

  /// "F_shaft_max", "F_adm" below the load on the shafts of a drive.
  void compare_pull(const std::string& name, double si) {
    const bool is_limit = has_word(name, {"adm", "zul", "perm", "lim", "allowable"}) ||
                          (has_word(name, {"max"}) && has_word(name, {"shaft", "s", "w", "radial", "r", "motor"}));
    const double F = std::abs(magnitude_at(project_, step_.name() + ".shaft_1.F"));
    if (!is_limit || size_at(step_, project_, name) == si || !(si > 0.0 && si < (1.0 - fitted) * F)) return;
    found_.push_back({"P", say("values.{1} = {2} acts on no step, and the load on the shafts is {3}: delete the value, "
                               "or justify it: because.P = \"...\"",
                               name, format_quantity(si, "N", 5), format_quantity(F, "N", 5))});
  }

  void add(const std::string& key, const std::string& name, double si) {
    const double here = size_at(step_, project_, key);
    if (!std::isnan(here)) add(key, name, si, here);
  }

  void add(const std::string& key, const std::string& name, double si, double here) {
    found_.push_back({key, say("values.{1} = {2} acts on no step, and this part has {3}: refer to it, delete it, or "
                               "justify it: because.{4} = \"...\"",
                               name, format_quantity(si, "mm", 5), format_quantity(here, "mm", 5), key)});
  }

  const Step& step_;
  const Project& project_;
  std::string_view id_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> mates_stated_otherwise(const Step& step, const Project& project) {
  return Mates(step, project).run();
}

}  // namespace loadpath::project
