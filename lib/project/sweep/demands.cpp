#include "lib/project/sweep/demands.hpp"

#include "lib/quantity/format.hpp"
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

/// "rod.mass <= 5 kg": its sides are compared when their dimensions are known.
std::optional<Demand> bound_of(const Placed& asked, const NamedResults& results, std::vector<Issue>& issues) {
  for (const char* sign : {"<=", ">="}) {
    const std::size_t at = asked.text.find(sign);
    if (at == std::string::npos) continue;
    const std::string left = meant(name_and_text(asked.text.substr(0, at)).second, results);
    const std::string right = meant(trimmed(asked.text.substr(at + 2)), results);
    const bool below = *sign == '<';
    const auto literal = parse_literal(right);
    if (literal && literal->dimension.is_number() && is_utilisation(left)) {
      if (literal->si > 0.0) return bound_of_utilisation(asked, left, literal->si, below, issues);
      issues.push_back(refusal(asked, say("'{1}' is not a bound above zero", right),
                               say("write the demand so that its bound is > 0")));
      return std::nullopt;
    }
    Demand demand{asked.text, {}, Kind::at_most_one};
    demand.less = below ? left : right;
    demand.more = below ? right : left;
    return demand;
  }
  issues.push_back(refusal(asked, say("'{1}' is not a constraint", asked.text),
                           say("write \"every mode passes\", \"rod passes\" or \"rod.mass <= 5 kg\"")));
  return std::nullopt;
}

/// The number of an expression in SI units.
std::string number_of(const std::string& text, const Dimension& dimension) {
  return dimension.is_number() ? "(" + text + ")" : "(" + text + ")/(1 " + si_unit(dimension) + ")";
}

/// "x <= b" or "x >= b" as a number that is at most 1: linear in x, for every sign of both.
std::string bounded_by(const std::string& x, const std::string& bound, const Literal& literal, bool below) {
  if (literal.si == 0.0) {
    const std::string by = literal.dimension.is_number() ? "" : "/(1 " + readable_unit(0.0, literal.dimension) + ")";
    return std::string(below ? "1 + (" : "1 - (") + x + ")" + by;
  }
  const std::string ratio = "(" + x + ")/(" + bound + ")";
  return below == (literal.si > 0.0) ? ratio : "2 - " + ratio;
}

/// The same of two results: their difference over the larger side, which is only for a large excess the left one, and
/// is not zero.
std::string compared(const std::string& less, const std::string& more) {
  return "1 + (" + less + " - " + more + ")/max(abs(" + more + "), 0.001*abs(" + less + "), 1e-200)";
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

void form(Demand& demand, const Place& place, Project& project, std::vector<Issue>& issues) {
  const Placed asked{demand.text, place};
  const auto read = [&](const std::string& text) {
    auto column = read_column(text, project);
    if (!column) issues.push_back(refusal(asked, column.fault().message, column.fault().hint));
    return column;
  };
  if (demand.less.empty()) {
    read(demand.column);
    return;
  }
  const auto less = read(demand.less), more = read(demand.more);
  if (!less || !more) return;
  if (less->dimension.without_angle() != more->dimension.without_angle()) {
    issues.push_back(refusal(asked, say("both sides of '{1}' have different dimensions", demand.text)));
    return;
  }
  const auto at_most = parse_literal(demand.more), at_least = parse_literal(demand.less);
  demand.column = at_most ? bounded_by(demand.less, demand.more, *at_most, true)
                  : at_least
                      ? bounded_by(demand.more, demand.less, *at_least, false)
                      : compared(number_of(demand.less, less->dimension), number_of(demand.more, more->dimension));
  read(demand.column);
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
