#include "lib/report/repeated.hpp"

#include "lib/report/derivation_blocks.hpp"

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
  const auto known = first_.find(calculator);
  if (known == first_.end()) {
    First& first = first_[calculator];
    first.title = title;
    for (const Derived& line : lines) first.formulas.insert(formula_of(line));
    return derivation_blocks(lines);
  }
  First& first = known->second;
  std::vector<Derived> own, repeated;
  for (const Derived& line : lines) (first.formulas.contains(formula_of(line)) ? repeated : own).push_back(line);
  std::vector<Block> all;
  if (!repeated.empty()) {
    all.emplace_back(Paragraph{say("Formulas as for {1}, with these numbers:", first.title), Paragraph::Tone::note});
    all.emplace_back(numbers_of(repeated));
  }
  for (Block& block : derivation_blocks(own)) all.push_back(std::move(block));
  for (const Derived& line : own) first.formulas.insert(formula_of(line));
  return all;
}

}  // namespace loadpath::report
