#include "lib/project/references/stated/moving_bodies.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace loadpath::project {

namespace {

constexpr double bodies_few_digits = 0.02;  // values that are rounded elsewhere
const Dimension body_mass = Dimension::of(0, 1, 0);
const Dimension of_stroke = Dimension::of(1, 0, 0);
const Dimension body_inertia = Dimension::of(2, 1, 0);
const Dimension rate_of_spring = Dimension::of(0, 1, -2);
const Dimension rate_of_turning_spring = Dimension::of(2, 1, -2);

/// The elements of a list of a mechanism, by name: links with results, whether typed or of its template.
std::set<std::string> elements_of(const Step& mechanism, std::string_view list) {
  NotedReads::note(mechanism.name() + "." + std::string(list));
  const std::string prefix = std::string(list) + ".";
  std::set<std::string> names;
  for (const account::Entry& entry : mechanism.account().results) {
    if (!entry.path.starts_with(prefix)) continue;
    const std::string rest = entry.path.substr(prefix.size());
    names.insert(rest.substr(0, rest.find('.')));
  }
  return names;
}

std::string in_small_letters(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Other names of a link in the slider-crank and its kin: of its driven body, of its rod.
constexpr std::array links_of_one_name{
    std::array<std::string_view, 7>{"slider", "piston", "plunger", "ram", "crosshead", "punch", "carriage"},
    std::array<std::string_view, 7>{"rod", "conrod", "con_rod", "connecting_rod", "coupler", "pitman",
                                    "connectingrod"}};

/// The names of an element in small letters: its own, and those that no other element has.
std::vector<std::string> names_of(const std::string& element, const std::set<std::string>& elements) {
  std::vector<std::string> names{in_small_letters(element)};
  const auto is_taken = [&](std::string_view name) {
    return std::ranges::any_of(elements, [&](const std::string& other) { return in_small_letters(other) == name; });
  };
  for (const auto& alike : links_of_one_name) {
    if (std::ranges::find(alike, std::string_view(names.front())) == alike.end()) continue;
    for (const std::string_view name : alike) {
      if (!is_taken(name)) names.emplace_back(name);
    }
    break;
  }
  return names;
}

/// The element that a name means after or before one of these words: "rod" of "m_rod" and "rod_mass"; empty if none.
std::string meant_by(const std::string& name, const std::set<std::string>& elements,
                     std::initializer_list<std::string_view> words) {
  const std::string small = in_small_letters(name);
  for (const std::string& element : elements) {
    for (const std::string& own : names_of(element, elements)) {
      for (const std::string_view word : words) {
        const std::string before = std::string(word) + "_" + own, after = own + "_" + std::string(word);
        if (small == before || small == after) return element;
      }
    }
  }
  return {};
}

class Bodies {
 public:
  Bodies(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    for (const auto& [name, value] : project_.values.unused()) {
      const Dimension dimension = value.signature.dimension.without_angle();
      const double si = std::abs(value.si.front());
      if (si == 0.0) continue;
      if (dimension == body_mass) compare_link(name, si, "mass", "kg", {"m", "mass"});
      if (dimension == body_inertia) compare_link(name, si, "J", "kg*m^2", {"j", "inertia"});
      if (dimension.is_number()) compare_friction(name, si);
      if (dimension == of_stroke) compare_stroke(name, si);
      if (dimension == rate_of_spring || dimension == rate_of_turning_spring) compare_spring(name);
    }
    return std::move(found_);
  }

 private:
  /// The mass or moment of inertia of a link that is lighter in the mechanism.
  void compare_link(const std::string& name, double si, const char* key, const char* unit,
                    std::initializer_list<std::string_view> words) {
    const std::string link = meant_by(name, elements_of(step_, "links"), words);
    if (link.empty()) return;
    const std::string path = "links." + link + "." + key;
    const double own = own_value(step_, project_, path), here = std::isnan(own) ? 0.0 : std::abs(own);
    if (!(si > (1.0 + bodies_few_digits) * here)) return;
    add("links", say("values.{1} = {2} acts on no step, and {3} is {4}: refer to it, delete it, or justify it: "
                     "because.links = \"...\"",
                     name, format_quantity(si, unit, 4), path, format_quantity(here, unit, 4)));
  }

  /// A coefficient of friction of a joint, or of all of them: "mu", "mu_B", "friction".
  void compare_friction(const std::string& name, double si) {
    const auto joints = elements_of(step_, "joints");
    const std::string joint = meant_by(name, joints, {"mu", "friction"});
    const bool is_of_all =
        has_only_words(name, {"mu", "friction", "coefficient", "joints", "pins", "guide", "slider"}) &&
        has_word(name, {"mu", "friction"});
    if (joint.empty() && !is_of_all) return;
    const auto is_rough = [&](const std::string& one) {
      return own_value(step_, project_, "joints." + one + ".mu") >= (1.0 - bodies_few_digits) * si;
    };
    if (joint.empty() ? std::ranges::any_of(joints, is_rough) : is_rough(joint)) return;
    add("joints",
        say("values.{1} = {2} acts on no step, and the joints have less friction: give joints.NAME.mu, delete "
            "it, or justify it: because.joints = \"...\"",
            name, format_number(si, 4)));
  }

  /// The stroke of a guide, next to those of the mechanism.
  void compare_stroke(const std::string& name, double si) {
    if (!has_word(name, {"stroke", "hub", "travel"}) ||
        !has_only_words(name, {"stroke", "hub", "travel", "s", "l", "h", "piston", "slider", "ram", "plunger", "punch",
                               "carriage", "table", "work", "working", "total", "full"}))
      return;
    std::string nearest;
    double of_nearest = std::nan("");
    for (const std::string& joint : elements_of(step_, "joints")) {
      const double here = magnitude_at(project_, step_.name() + ".joints." + joint + ".stroke");
      if (std::isnan(here) || std::abs(here - si) > std::abs(of_nearest - si)) continue;
      of_nearest = here, nearest = joint;
    }
    if (!(std::abs(of_nearest - si) > bodies_few_digits * si)) return;
    add("joints",
        say("values.{1} = {2} acts on no step, and '{3}' has a stroke of {4}: correct the lengths, delete the "
            "value, or justify it: because.joints = \"...\"",
            name, format_quantity(si, "mm", 4), nearest, format_quantity(of_nearest, "mm", 4)));
  }

  /// A spring next to a mechanism without one.
  void compare_spring(const std::string& name) {
    const bool is_spring = has_word(name, {"spring", "springs"}) || name == "k" ||
                           (name.starts_with("k_") && !is_of_other_state(name)) || name == "c_spring";
    const auto& typed = step_.input().reading.typed;
    const bool has_springs =
        std::ranges::any_of(typed, [](const auto& entry) { return entry.first.starts_with("springs"); });
    if (!is_spring || has_springs) return;
    add("springs",
        say("values.{1} acts on no step, and the mechanism has no spring: give springs, delete it, or justify "
            "it: because.springs = \"...\"",
            name));
  }

  void add(const std::string& key, Message message) { found_.push_back({key, std::move(message)}); }

  const Step& step_;
  const Project& project_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> bodies_stated_only(const Step& step, const Project& project) {
  if (std::string_view(step.input().calculator->id) != "mechanism.planar") return {};
  return Bodies(step, project).run();
}

}  // namespace loadpath::project
