#include "lib/project/references/turning.hpp"

#include "lib/calculator/meaning.hpp"
#include "lib/project/modes.hpp"
#include "lib/project/references/references.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

/// Whether the field has this meaning.
bool has_meaning(const Calculator& calculator, const std::string& path, std::string_view what) {
  return std::any_of(calculator.meanings.begin(), calculator.meanings.end(), [&](const Meaning& meaning) {
    const auto fields = listed_keys(meaning.fields);
    return meaning.what == what &&
           std::any_of(fields.begin(), fields.end(), [&](const std::string& field) { return names_row(field, path); });
  });
}

/// Whether the shaft is stationary.
bool stands(const Step& step, const Project& project) {
  const Value* const n = project.value(step.name() + ".n");
  return n != nullptr && std::all_of(n->si.begin(), n->si.end(), [](double x) { return std::isnan(x) || x == 0.0; });
}

bool is_turning(const std::string& path, const Project& project) {
  const auto [name, rest] = split_step(path);
  const Step* const source = project.find(name);
  if (source == nullptr) return false;
  return has_meaning(*source->input().calculator, rest, reverses_in_turns) && !stands(*source, project);
}

/// Share of the reversing stresses in the value of an expression, by a small change of them.
class Share {
 public:
  explicit Share(const Project& project) : project_(project) {}

  [[nodiscard]] double of(const Operand& operand) { return value(operand, 1.0 + step_) - value(operand, 1.0); }

 private:
  static constexpr double step_ = 1e-3;

  [[nodiscard]] double value(const Operand& operand, double raised) {
    const auto value_at = [&](const std::string& path) -> const Value& {
      const Value* const known = project_.value(path);
      if (known == nullptr) return none_;
      if (raised == 1.0 || !is_turning(path, project_)) return *known;
      Value& more = raised_[path];
      more = *known;
      for (double& x : more.si) x *= raised;
      return more;
    };
    const Value found = operand.expression.evaluate(value_at);
    return found.si.empty() ? std::nan("") : found.si.front();
  }

  const Project& project_;
  Value none_{{}, {std::nan("")}};
  std::map<std::string, Value> raised_;
};

/// Whether the other inputs of the cycle make it symmetric: r = -1, the other end, the amplitude or the mean.
bool is_reversed(const Step& step, const Operand& operand, const Project& project) {
  const std::string prefix = prefix_of(operand.path);
  if (has_reversed_ratio(step, prefix, project)) return true;
  Share share(project);
  const double own = share.of(operand);
  const auto share_of = [&](const char* key) {
    const Operand* const other = step.input().reading.operand(prefix + key);
    return other == nullptr ? 0.0 : share.of(*other);
  };
  const auto is = [&](double a, double b) { return std::abs(a - b) <= 0.02 * std::abs(own); };
  const auto is_given = [&](const char* key) { return step.input().reading.typed.contains(prefix + key); };
  if (is_given("sigma_a")) return is(std::abs(share_of("sigma_a")), std::abs(own));
  if (is_given("sigma_m")) return is(share_of("sigma_m"), 0.0);
  const bool both = is_given("sigma_max") && is_given("sigma_min");
  return both && is(share_of("sigma_max"), -share_of("sigma_min"));
}

}  // namespace

std::optional<Message> turning_message(const Step& step, const Operand& operand, const Project& project) {
  const Calculator& taker = *step.input().calculator;
  const bool is_kinematically_stable = has_meaning(taker, operand.path, steady_part);
  const bool is_end = has_meaning(taker, operand.path, "max") || has_meaning(taker, operand.path, "min");
  if (!is_kinematically_stable && !is_end) return std::nullopt;
  for (const auto& reference : operand.expression.references()) {
    if (!is_turning(reference.path, project)) continue;
    if (is_end && is_reversed(step, operand, project)) return std::nullopt;
    return is_end ? say("{1} is '{2}', which reverses with each revolution: write r = -1, or because.{1} = "
                        "\"...\"",
                        operand.path, reference.path)
                  : say("{1} is '{2}', which reverses with each revolution and is an amplitude: correct it, or "
                        "because.{1} = \"...\"",
                        operand.path, reference.path);
  }
  return std::nullopt;
}

}  // namespace loadpath::project
