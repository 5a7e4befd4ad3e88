#include "lib/report/terminal/rows.hpp"

#include "lib/formula/formula.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/terminal/layout.hpp"
#include "lib/report/terminal/words.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::terminal {

namespace {

using account::Entry;
using account::Mode;

std::string not_available(const Entry& e) {
  return e.missing.empty() ? format_quantity(NAN, e.unit) : say("not available: {1}", e.missing).text();
}

/// The formula of a line with the branch that ran; as it was written where it is not in the language.
std::string plain_formula(const account::Step& line) {
  const auto tree = formula::parse(line.formula);
  if (!tree) return line.formula;
  const formula::Known known = [&](std::string_view name) -> std::optional<double> {
    const auto given =
        std::find_if(line.given.begin(), line.given.end(), [&](const auto& g) { return g.name == name; });
    return given == line.given.end() ? std::nullopt : std::optional(given->si);
  };
  return formula::plain(*tree, {}, known);
}

std::string name_of(const Mode& mode, bool of_project) { return of_project ? mode.step + "." + mode.id : mode.id; }

/// Modes that no input of their step would permit to assess, by the remedy.
void add_remote(const std::string& reason, const std::string& name,
                std::vector<std::pair<std::string, std::string>>& remote) {
  const auto same = std::ranges::find(remote, reason, &std::pair<std::string, std::string>::first);
  if (same == remote.end())
    remote.emplace_back(reason, name);
  else
    same->second += ", " + name;
}

}  // namespace

std::string value_text(const Entry& e) {
  if (!e.word.empty()) return e.word;
  if (!e.values().is_series()) {
    const double si = e.values().si.empty() ? NAN : e.values().si[0];
    return std::isnan(si) ? not_available(e) : format_quantity(si, e.unit);
  }
  if (is_constant(e.values())) return say("{1}, constant", format_quantity(e.values().si.front(), e.unit)).text();
  const Extreme low = minimum(e.values()), high = maximum(e.values());
  if (std::isnan(low.value)) return not_available(e);
  const Axis& axis = *e.values().signature.axis;
  return format_quantity(low.value, e.unit) + " (at " + format_quantity(low.at, axis.unit, 5) + ") to " +
         format_quantity(high.value, e.unit) + " (at " + format_quantity(high.at, axis.unit, 5) + ")";
}

Row line_row(const account::Derived& line, bool in_element) {
  const account::Step& step = line.step;
  const std::string element = in_element && !line.scope.empty() ? line.element + " " : "";
  const std::string formula = step.formula.empty() ? "" : " = " + plain_formula(step);
  return {"  " + element + formula::symbol_plain(step.symbol) + formula,
          "= " + format_quantity(step.value.si, step.value.unit), step.why.text()};
}

Row mode_row(const Mode& mode, const std::string& name) {
  return {"  " + mode_word(mode), name, mode.utilisation ? format_quantity(*mode.utilisation, "-", 4) : "",
          mode.title.text() + "; " + account::reason(mode).text()};
}

std::string mode_columns(const account::Modes& modes, bool of_project) {
  std::vector<Row> rows;
  std::vector<std::pair<std::string, std::string>> remote;  // calculators that would assess them, and the modes
  for (const Mode& mode : account::in_order(modes)) {
    if (account::is_remote(mode))
      add_remote(account::reason(mode).text(), name_of(mode, of_project), remote);
    else
      rows.push_back(mode_row(mode, name_of(mode, of_project)));
  }
  std::string all = columns(rows);
  for (const auto& [reason, names] : remote)
    all += columns({{"  " + state_word(account::State::open), say("{1}: {2}", reason, names).text()}});
  return all;
}

}  // namespace loadpath::terminal
