#include "lib/project/sweep/demands.hpp"

#include "lib/quantity/literal.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace loadpath::project {

namespace {

using Kind = sweep::Constraint::Kind;

/// "rod.utilisation <= 0.8".
std::optional<Demand> bound_of_utilisation(const Placed& asked, const std::string& utilisation, double bound,
                                           bool below, std::vector<Issue>& issues) {
  if (below) return Demand{asked.text, utilisation, Kind::at_most_one, bound};
  issues.push_back(refusal(asked, say("a utilisation has an upper bound only"), say("write {1} <= 0.8", utilisation)));
  return std::nullopt;
}

/// "rod.mass <= 5 kg" as a utilisation: (rod.mass)/(5 kg).
std::optional<Demand> bound_of(const Placed& asked, const NamedResults& results, std::vector<Issue>& issues) {
  for (const char* sign : {"<=", ">="}) {
    const std::size_t at = asked.text.find(sign);
    if (at == std::string::npos) continue;
    const std::string left = meant(name_and_text(asked.text.substr(0, at)).second, results);
    const std::string right = trimmed(asked.text.substr(at + 2));
    const auto literal = parse_literal(right);
    if (literal && !(literal->si > 0.0)) {
      issues.push_back(refusal(asked, say("'{1}' is not a bound above zero", right),
                               say("write the demand so that its bound is > 0")));
      return std::nullopt;
    }
    const bool below = *sign == '<';
    if (literal && literal->dimension.is_number() && is_utilisation(left))
      return bound_of_utilisation(asked, left, literal->si, below, issues);
    return Demand{asked.text, "(" + (below ? left : right) + ")/(" + (below ? right : left) + ")", Kind::at_most_one};
  }
  issues.push_back(refusal(asked, say("'{1}' is not a constraint", asked.text),
                           say("write \"every mode passes\", \"rod passes\" or \"rod.mass <= 5 kg\"")));
  return std::nullopt;
}

}  // namespace

Issue refusal(const Placed& at, Message message, Message hint) {
  return {at.place, at.place.file.substr(std::min<std::size_t>(2, at.place.file.size())), std::move(message),
          std::move(hint), Severity::error};
}

std::string meant(const std::string& text, const NamedResults& results) {
  const auto found = std::find_if(results.begin(), results.end(), [&](const auto& r) { return r.first == text; });
  return found == results.end() ? text : found->second;
}

bool is_utilisation(const std::string& text) {
  return text == "utilisation" || text.ends_with(".utilisation") || text.find(".modes.") != std::string::npos;
}

std::vector<Demand> demands_of(const std::vector<Placed>& such_that, const NamedResults& results,
                               std::vector<Issue>& issues) {
  std::vector<Demand> demands;
  const auto passes = [&](const std::string& text, const std::string& step) {
    demands.push_back({text, step + "utilisation", Kind::at_most_one});
    demands.push_back({text, step + "passes", Kind::is_one});
  };
  if (such_that.empty()) passes("every mode passes", "");
  for (const Placed& asked : such_that) {
    constexpr std::string_view verb = " passes";
    const std::string text = trimmed(asked.text);
    if (text == "every mode passes") {
      passes(text, "");
    } else if (text.ends_with(verb)) {
      passes(text, name_and_text(text.substr(0, text.size() - verb.size())).second + ".");
    } else if (auto bound = bound_of({text, asked.place}, results, issues)) {
      demands.push_back(std::move(*bound));
    }
  }
  return demands;
}

void check_sides(const Placed& asked, const SweptResult& column, std::vector<Issue>& issues) {
  if (column.dimension.without_angle().is_number()) return;
  issues.push_back(refusal(asked, say("both sides of '{1}' are of unlike dimensions", asked.text)));
}

bool SweptDemand::is_met(double value) const {
  return kind == Kind::is_one ? value == 1.0 : std::isfinite(value) && value <= bound;
}

bool SweptDemand::is_met(std::uint64_t met, std::uint64_t valued, std::uint64_t samples, double level,
                         double quantile) const {
  if (kind == Kind::is_one) return static_cast<double>(met) >= quantile * static_cast<double>(samples);
  return valued == samples && is_met(level);
}

}  // namespace loadpath::project
