#include "lib/report/derivation_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loadpath::report {

namespace {

using account::Derived;
using Lines = std::vector<const Derived*>;

std::string list_of(const std::string& scope) { return scope.substr(0, scope.find('[')); }

/// The lines of one list, element by element.
std::vector<Lines> by_element(const std::vector<Derived>& lines, std::size_t first, std::size_t end) {
  std::vector<Lines> elements;
  for (std::size_t i = first; i < end; ++i) {
    if (elements.empty() || elements.back().front()->scope != lines[i].scope) elements.emplace_back();
    elements.back().push_back(&lines[i]);
  }
  return elements;
}

bool same_formulas(const Lines& a, const Lines& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Derived* x, const Derived* y) {
    return x->step.symbol == y->step.symbol && x->step.formula == y->step.formula;
  });
}

Derivation worked(const Lines& lines) {
  Derivation derivation;
  for (const Derived* line : lines) derivation.steps.push_back(line->step);
  return derivation;
}

/// Values that are not calculated, as a table.
Table taken_values(const Lines& lines) {
  Table table{{}, {say("symbol"), say("meaning"), say("value")}, {}};
  for (const Derived* line : lines) table.rows.push_back({Symbol{line->step.symbol}, line->step.why, line->step.value});
  return table;
}

/// Lines in their order: formulas worked out, runs of values that are taken from elsewhere as tables.
void add_lines(const Lines& lines, std::vector<Block>& blocks) {
  constexpr std::size_t least_run = 2;
  Lines formulas;
  for (std::size_t i = 0; i < lines.size();) {
    std::size_t end = i;
    while (end < lines.size() && lines[end]->step.formula.empty()) ++end;
    if (end - i >= least_run) {
      if (!formulas.empty()) blocks.emplace_back(worked(std::exchange(formulas, {})));
      blocks.emplace_back(taken_values(
          {lines.begin() + static_cast<std::ptrdiff_t>(i), lines.begin() + static_cast<std::ptrdiff_t>(end)}));
    } else {
      end = i + 1;
      formulas.push_back(lines[i]);
    }
    i = end;
  }
  if (!formulas.empty()) blocks.emplace_back(worked(formulas));
}

/// The name of an element within its list, or its number in brackets.
std::string name_of(const Derived& line) {
  const std::string list = list_of(line.scope);
  return line.element.substr(list.size() + (line.element[list.size()] == '.' ? 1 : 0));
}

Table values_of(const std::vector<Lines>& elements) {
  Table table;
  table.head.push_back(say("{1}", list_of(elements[0][0]->scope)));
  for (const Derived* line : elements[0]) table.head.push_back(say("{1}", line->step.symbol));
  for (const Lines& lines : elements) {
    std::vector<Cell> row{name_of(*lines[0])};
    for (const Derived* line : lines) row.emplace_back(line->step.value);
    table.rows.push_back(std::move(row));
  }
  return table;
}

void add_list(const std::vector<Lines>& elements, std::vector<Block>& blocks) {
  const bool alike =
      std::all_of(elements.begin(), elements.end(), [&](const Lines& l) { return same_formulas(l, elements[0]); });
  if (!alike || elements.size() == 1) {
    for (const Lines& lines : elements) {
      blocks.emplace_back(Paragraph{say("For {1}:", lines[0]->element)});
      add_lines(lines, blocks);
    }
    return;
  }
  const auto largest = std::max_element(elements.begin(), elements.end(), [](const Lines& a, const Lines& b) {
    return std::abs(a.back()->step.value.si) < std::abs(b.back()->step.value.si);
  });
  blocks.emplace_back(Paragraph{say("Calculation for {1}; all results follow in the table.", (*largest)[0]->element)});
  add_lines(*largest, blocks);
  blocks.emplace_back(values_of(elements));
}

}  // namespace

std::vector<Block> derivation_blocks(const std::vector<Derived>& lines) {
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < lines.size();) {
    std::size_t end = i;
    while (end < lines.size() && list_of(lines[end].scope) == list_of(lines[i].scope)) ++end;
    if (lines[i].scope.empty()) {
      Lines top;
      for (std::size_t k = i; k < end; ++k) top.push_back(&lines[k]);
      add_lines(top, blocks);
    } else {
      add_list(by_element(lines, i, end), blocks);
    }
    i = end;
  }
  return blocks;
}

}  // namespace loadpath::report
