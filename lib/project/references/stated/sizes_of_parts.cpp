#include "lib/project/references/stated/sizes_of_parts.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/stated/dimensions.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double of_one_part = 5.0;   // times the size of the step: beyond, it is that of another part
constexpr double of_one_size = 15.0;  // of a state of the part, with a slip of ten

using stated::inertia;
using stated::length;
using stated::mass;

/// Symbols of one quantity: a diameter and its radius, a wall and a thickness.
std::string_view family_of(std::string_view name) {
  const std::string_view symbol = name.substr(0, name.find('_'));
  for (const std::string_view letters : {"dDrR", "lL", "aA", "bB", "hH", "sStT", "mM", "J", "z"}) {
    if (symbol.size() == 1 && letters.find(symbol[0]) != std::string_view::npos) return letters;
  }
  return symbol == "delta" ? "sStT" : symbol == "mass" ? "mM" : symbol == "mu" ? "mu" : std::string_view();
}

/// A state of the part, or a place of it that carries.
bool is_of_state(std::string_view name) {
  return has_word(
      name, {"made",     "actual",      "real",     "measured",  "built",  "existing", "drawn", "eff",     "engaged",
             "free",     "unsupported", "extended", "effective", "bore",   "core",     "root",  "fillet",  "engagement",
             "drawing",  "rim",         "rings",    "hub",       "keyway", "housing",  "neck",  "contact", "worn",
             "corroded", "rusted",      "rust",     "undercut",  "seat",   "relief",   "groove"});
}

/// A part of a drive with an inertia of its own, next to that of the machine.
bool is_of_drive(std::string_view word) {
  return has_word(word, {"gear", "gears", "gearbox", "coupling", "clutch", "brake", "pulley", "flywheel"});
}

bool is_gear(std::string_view word) {
  return has_word(word, {"pinion", "wheel", "gear", "sprocket", "sun", "ring", "planet", "worm", "small", "large",
                         "drive", "driving", "driven", "grooves"});
}

class SizesOfParts {
 public:
  SizesOfParts(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    for (const auto& [name, value] : project_.values.unused())
      compare(name, std::abs(value.si.front()), value.signature.dimension);
    return std::move(found_);
  }

 private:
  /// Whether the name means this step: the state of a size, or the word of a part.
  [[nodiscard]] bool is_meant(const std::string& name, const Dimension& dimension) const {
    const bool is_of_side = name.ends_with("_outer") || name.ends_with("_inner") || name.ends_with("_small");
    const std::string part = is_of_side ? name.substr(0, name.rfind('_')) : name;
    const std::size_t end = part.rfind('_');
    const bool is_of_motor = name.ends_with("_pulley");  // which is a part of the drive
    if (name.ends_with("_small") && find_field(step_.input().calculator->input->fields, part) != nullptr) return true;
    if (end == std::string::npos || (is_of_other_state(name) && !is_of_motor) || has_word(name, {"max"})) return false;
    const std::string_view word = std::string_view(part).substr(end + 1), family = family_of(name);
    if (dimension.is_number()) return family == "mu" || (family == "z" && (is_gear(word) || is_named(step_, word)));
    const bool is_toothed = id_of(step_).starts_with("gear.") && is_gear(word);
    if (dimension == length && family == "bB") return is_of_state(word) || is_toothed;  // of pulleys: mates.hpp
    if (dimension == inertia && id_of(step_).starts_with("machine.")) return family == "J";
    // masses and sizes of mounted components are those of rows, or of other steps
    const bool is_of_rows = id_of(step_) == "shaft.design" || id_of(step_) == "mechanism.planar" ||
                            id_of(step_) == "bearing.rolling" || connects(step_);
    const bool is_way = family == "lL" && (id_of(step_).starts_with("belt.") || id_of(step_).starts_with("chain."));
    const bool is_of_wheels =
        family == "dDrR" && (id_of(step_).starts_with("belt.") || id_of(step_).starts_with("chain."));
    const bool is_pulley = is_of_wheels && has_word(word, {"pulley", "sprocket", "sheave"});
    const bool is_driven = is_of_wheels && has_word(word, {"drum", "roller", "fan", "rotor", "impeller", "cylinder"});
    const bool is_weakest =
        family == "dDrR" && has_word(name, {"neck", "groove", "undercut", "relief"});  // "d_neck_nut"
    return (dimension == length && (is_of_state(word) || is_weakest || is_pulley)) ||
           (word.size() > 2 && !is_of_rows && !is_way && !is_driven && is_named(step_, word));
  }

  /// Inputs and results of a step under symbols of this family.
  template <class Use>
  void for_each_size(const Step& step, const Dimension& dimension, const Use& use) const {
    const Calculator& calculator = *step.input().calculator;
    for (const auto* const type : {calculator.input, calculator.result}) {
      if (type == nullptr) continue;
      for (const FieldInfo& field : type->fields) {
        const bool is_number = field.is_number() || field.type == FieldInfo::Type::count;
        if (!is_number || !(field.dimension == dimension)) continue;
        const double own = std::abs(own_value(step, project_, field.key));
        const double si = std::isnan(own) ? std::abs(magnitude_at(project_, step.name() + "." + field.key)) : own;
        if (si > 0.0) use(field, si);
      }
    }
    for_each_leaf(step.input().reading.record, [&](const std::string& path, const Leaf& leaf) {
      const double si = std::abs(own_value(step, project_, path));
      if (leaf.field->dimension == dimension && path.find('.') != std::string::npos && si > 0.0) use(*leaf.field, si);
    });
  }

  [[nodiscard]] bool is_known(const std::string& name, double stated, const Dimension& dimension) const {
    const bool is_round = dimension == length && family_of(name) == "dDrR";
    const std::string word = name.substr(name.rfind('_') + 1);
    const bool is_of_other = dimension == inertia && is_of_drive(word) && !is_named(step_, word);
    const bool is_heavy =
        (dimension == mass || dimension == inertia) && !is_of_other;  // a heavier part is on the safe side
    bool found = false;
    for (const auto& step : project_.steps) {
      for_each_size(*step, dimension, [&](const FieldInfo& field, double si) {
        const std::string_view family = family_of(field.key);
        if (dimension == length && is_round != (family == "dDrR")) return;
        if (dimension.is_number() && family != family_of(name)) return;
        found =
            found || is_near(si, stated, stated::rounded) || (is_heavy && si >= stated) ||
            (is_round && (is_near(2.0 * si, stated, stated::rounded) || is_near(0.5 * si, stated, stated::rounded)));
      });
    }
    return found;
  }

  void compare(const std::string& name, double stated, const Dimension& dimension) {
    const bool is_compared = dimension == length || dimension == mass || dimension == inertia || dimension.is_number();
    if (!is_compared || !(stated > 0.0) || !is_meant(name, dimension) || is_known(name, stated, dimension)) return;
    const FieldInfo* nearest = nullptr;
    double here = std::nan("");
    for_each_size(step_, dimension, [&](const FieldInfo& field, double si) {
      const bool is_same = field.key[0] == name[0];  // D of D_hub, d else
      const bool is_nearer =
          nearest == nullptr || (is_same && nearest->key[0] != name[0]) ||
          (is_same == (nearest->key[0] == name[0]) && std::abs(si - stated) < std::abs(here - stated));
      if (family_of(field.key) == family_of(name) && is_nearer) nearest = &field, here = si;
    });
    const double most = is_of_state(name) ? of_one_size : of_one_part;
    const bool is_of_other = dimension == length && (stated > most * here || here > most * stated);
    const bool is_wider = dimension == length && family_of(name) == "bB" && stated > here;  // the narrower one carries
    if (nearest == nullptr || is_of_other || is_wider) return;
    const std::string reason = reason_for(step_, nearest->key);
    if (reason.empty()) return;
    const auto shown = [&](double si) {
      return dimension.is_number() ? format_number(si, 5) : format_quantity(si, nearest->unit, 5);
    };
    found_.push_back({reason, say("values.{1} = {2} acts on no step, and {3} is {4} here: refer to it, delete it, or "
                                  "justify it: because.{5} = \"...\"",
                                  name, shown(stated), nearest->key, shown(here), reason)});
  }

  /// The input that a reason belongs to: the size, or the first load where it is a result or in a list.
  [[nodiscard]] std::string reason_for(const Step& step, const std::string& key) const {
    const auto& fields = step.input().calculator->input->fields;
    if (find_field(fields, key) != nullptr) return key;
    for (const FieldInfo& field : fields) {
      if (field.is_load && step.input().reading.typed.contains(field.key)) return field.key;
    }
    const auto& typed = step.input().reading.typed;
    for (const FieldInfo& field : fields) {
      if (typed.contains(field.key) || field.type == FieldInfo::Type::list) return field.key;
    }
    return {};
  }

  const Step& step_;
  const Project& project_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> sizes_of_parts_stated(const Step& step, const Project& project) {
  return SizesOfParts(step, project).run();
}

}  // namespace loadpath::project
