#include "lib/report/repeated.hpp"

#include "lib/report/derivation_blocks.hpp"

#include <algorithm>

namespace loadpath::report {

namespace {

using account::Derived;

/// A line without its numbers.
std::string formula_of(const Derived& line) {
  const std::string list = line.scope.substr(0, line.scope.find('['));
  return list + '\n' + line.step.symbol + '\n' + line.step.formula + '\n' + line.step.why.text();
}

/// Symbols and values, several in a row.
Table numbers_of(const std::vector<Derived>& lines) {
  constexpr std::size_t in_row = 3;
  Table table;
  for (const Derived& line : lines) {
    if (table.rows.empty() || table.rows.back().size() == 2 * in_row) table.rows.emplace_back();
    const std::string place = line.element.empty() ? line.scope : line.element;
    table.rows.back().emplace_back(Symbol{place.empty() ? line.step.symbol : place + "." + line.step.symbol});
    table.rows.back().emplace_back(line.step.value);
  }
  for (auto& row : table.rows) row.resize(2 * in_row, std::string());
  return table;
}

}  // namespace

std::vector<Block> PrintedFormulas::blocks(const std::string& calculator, const std::string& title,
                                           const std::vector<Derived>& lines) {
  std::vector<Printed>& steps = printed_[calculator];
  std::vector<Derived> own, repeated;
  const auto is_known = [&](const Derived& line) {
    const std::string formula = formula_of(line);
    return std::ranges::any_of(steps, [&](const Printed& step) { return step.formulas.contains(formula); });
  };
  for (const Derived& line : lines) (is_known(line) ? repeated : own).push_back(line);
  std::vector<Block> all;
  for (const Printed& step : steps) {
    std::vector<Derived> of_step;
    for (const Derived& line : repeated) {
      if (step.formulas.contains(formula_of(line))) of_step.push_back(line);
    }
    if (of_step.empty()) continue;
    all.emplace_back(Paragraph{say("Formulas as for {1}, with these numbers:", step.title), Paragraph::Tone::note});
    all.emplace_back(numbers_of(of_step));
  }
  for (Block& block : derivation_blocks(own)) all.push_back(std::move(block));
  if (own.empty()) return all;
  steps.push_back({title, {}});
  for (const Derived& line : own) steps.back().formulas.insert(formula_of(line));
  return all;
}

}  // namespace loadpath::report
