#include "lib/project/references/titles/titles.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/project/references/stated/dimensions.hpp"
#include "lib/project/references/titles/quantities.hpp"
#include "lib/quantity/series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double gravity = 9.80665;  // m/s^2
constexpr double as_rounded = 0.03;  // of numbers in titles
constexpr double most = 0.06;        // and with few digits: "98 rpm" of 97.6 rpm, "5 t" of 5.2 t

/// Whether a part is sized by quantities of this kind; lengths, areas and times in a title may be of anything.
bool is_of_rating(const Dimension& dimension) {
  const std::array kinds{stated::mass, stated::force,    stated::torque, stated::power,
                         stated::rate, stated::pressure, stated::heat};
  return std::ranges::find(kinds, dimension) != kinds.end();
}

/// The factor by which a number of one kind counts as one of the other: a mass as its weight; NaN of unlike kinds.
double factor_between(const Dimension& from, const Dimension& to) {
  if (from == to) return 1.0;
  if (from == stated::mass && to == stated::force) return gravity;
  if (from == stated::force && to == stated::mass) return 1.0 / gravity;
  return std::nan("");
}

class Titles {
 public:
  Titles(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    compare(step_.input().title, "its title says", &step_);
    if (is_last_loaded()) compare(project_.title, "the title of the project says", nullptr);
    return std::move(found_);
  }

 private:
  /// Whether a sweep gives an input of such a kind several values: then the title states one of them, or none.
  [[nodiscard]] static bool is_varied(const Project& project) {
    if (!project.values.several().empty()) return true;
    return std::ranges::any_of(project.steps, [](const auto& step) {
      return std::ranges::any_of(step->input().reading.varied, [](const Varied& varied) {
        return varied.leaf.field != nullptr && is_of_rating(varied.leaf.field->dimension.without_angle());
      });
    });
  }

  [[nodiscard]] bool is_last_loaded() const {
    for (auto place = project_.order.rbegin(); place != project_.order.rend(); ++place) {
      const Step& step = *project_.steps[*place];
      if (!load_of(step).empty()) return &step == &step_;
    }
    return false;
  }

  /// The path of an input of the step that is a load; empty if it has none.
  [[nodiscard]] static std::string load_of(const Step& step) {
    const Reading& reading = step.input().reading;
    for (const Operand& operand : reading.operands)
      if (operand.leaf.field != nullptr && operand.leaf.field->is_load) return operand.path;
    for (const auto& [path, typed] : reading.typed) {
      const Leaf leaf = find_leaf(reading.record, path);
      if (leaf && leaf.field->is_load) return path;
    }
    return {};
  }

  /// `titled`: the step that has the title; null: all of them.
  void compare(const std::string& title, std::string_view words, const Step* titled) {
    if (title.empty()) return;
    for (const Said& said : quantities_in(title)) {
      if (!is_of_rating(said.dimension) || said.text.ends_with(" K") || said.si == 0.0 || is_varied(project_)) continue;
      const std::string load = load_of(step_);
      if (load.empty() || !has_others(said, titled) || is_in_file(said)) continue;
      found_.push_back({load, say("{1} {2}, and no number of the file is: correct one of them, or justify it: {3} = "
                                  "\"...\"",
                                  words, said.text, because_key(load))});
    }
  }

  /// The texts of [values], and of the inputs of a step, or of all steps.
  template <class Visit>
  void for_each_text(const Step* titled, const Visit& visit) const {
    for (const std::string_view text : project_.values.texts()) visit(text);
    for (const auto& step : project_.steps) {
      if (titled != nullptr && step.get() != titled) continue;
      for (const auto& [path, typed] : step->input().reading.typed) visit(typed.text);
      for (const Operand& operand : step->input().reading.operands) visit(operand.text);
    }
  }

  /// Whether a number of this kind is typed at all; a temperature that changes strengths should be.
  [[nodiscard]] bool has_others(const Said& said, const Step* titled) const {
    constexpr double cold = 263.15, warm = 323.15;  // K
    bool found = said.dimension == stated::heat && (said.si < cold || said.si > warm);
    for_each_text(titled, [&](std::string_view text) {
      for (const Said& other : quantities_in(text))
        found = found || !std::isnan(factor_between(other.dimension, said.dimension));
    });
    return found;
  }

  [[nodiscard]] static bool agrees(double si, const Dimension& dimension, const Said& said) {
    const double other = std::abs(si * factor_between(dimension, said.dimension));
    const double size = std::abs(said.si);
    const double share = std::clamp(0.5 * said.last_digit / size, as_rounded, most);
    return std::abs(other - size) <= share * size;
  }

  [[nodiscard]] bool is_in_file(const Said& said) const {
    bool found = false;
    for_each_text(nullptr, [&](std::string_view text) {
      for (const Said& other : quantities_in(text)) found = found || agrees(other.si, other.dimension, said);
    });
    for (const Value* const value : project_.values.numbers())
      found = found || agrees(value->si.front(), value->signature.dimension.without_angle(), said);
    return found || is_calculated(said);
  }

  /// Whether an input that is an expression, or a result of a mechanism, is that number. Others are of any kind.
  [[nodiscard]] bool is_calculated(const Said& said) const {
    for (const auto& step : project_.steps) {
      for (const Operand& operand : step->input().reading.operands) {
        const Dimension dimension = operand.leaf.field->dimension.without_angle();
        if (agrees(own_value(*step, project_, operand.path), dimension, said)) return true;
      }
      if (step->input().calculator->result != nullptr) continue;
      for (const account::Entry& entry : step->account().results) {
        const Dimension dimension = entry.value.signature.dimension.without_angle();
        if (!entry.value.si.empty() && agrees(largest(entry.value).value, dimension, said)) return true;
      }
    }
    return false;
  }

  const Step& step_;
  const Project& project_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> titles_of_other_loads(const Step& step, const Project& project) {
  return Titles(step, project).run();
}

}  // namespace loadpath::project
