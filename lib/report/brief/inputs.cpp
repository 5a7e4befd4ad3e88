#include "lib/report/brief/inputs.hpp"

#include "lib/report/appendix.hpp"
#include "lib/report/brief/names.hpp"
#include "lib/report/columns.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/why.hpp"
#include "lib/report/worked.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace loadpath::report {

namespace {

using account::Entry;
using project::Project;
using project::Step;

struct Input {
  const Step* step;
  const Entry* entry;
  int rank = 0;  // the smaller, the more it matters
};

bool is_of_list(const Entry& entry) { return entry.path.find_first_of("[.") != std::string::npos; }

/// A coordinate of zero says little.
bool is_zero_of_list(const Entry& entry) {
  constexpr double rounding = 1e-15;  // in SI units: the cosine of a right angle
  return is_of_list(entry) && entry.word.empty() && !entry.values().is_series() && !entry.values().si.empty() &&
         std::abs(entry.values().si.front()) < rounding;
}

/// The joints and points that a template lays out follow from its own inputs.
bool is_of_template(const Entry& entry) { return entry.origin.text.id == "template {1}"; }

bool is_name(const Entry& entry) { return entry.path == "name" || entry.path.ends_with(".name"); }

/// What the user gave comes before what other steps give, which is among their own inputs or results.
int rank_of(const Entry& entry, bool decides) {
  const bool is_linked = comes_from_step(entry), is_listed = is_of_list(entry);
  if (decides && !entry.origin.assumed && !is_linked) return 0;
  if (entry.origin.assumed) return 4;
  if (is_linked) return decides ? 2 : 5;
  return is_listed ? 3 : 1;
}

/// The inputs that the governing modes follow from.
std::set<const Entry*> deciding_inputs(const Project& project, const std::vector<Governing>& governing) {
  std::set<const Entry*> inputs;
  for (const Governing& row : governing) {
    const Step* const step = project.find(row.mode.step);
    if (step == nullptr) continue;
    for (const Entry* const entry : reasons_of(step->account(), row.mode.governs).inputs) inputs.insert(entry);
  }
  return inputs;
}

std::vector<Input> given_inputs(const Project& project, const std::vector<Governing>& governing) {
  const std::set<const Entry*> deciding = deciding_inputs(project, governing);
  std::vector<Input> inputs;
  for (const auto& step : project.steps) {
    for (const Entry& entry : step->account().inputs) {
      const bool decides = deciding.contains(&entry);
      if (!is_available(entry) || is_name(entry)) continue;
      const bool says_little = entry.origin.assumed || is_of_template(entry) || is_zero_of_list(entry);
      if (!decides && says_little) continue;
      const int rank = rank_of(entry, decides);
      inputs.push_back({step.get(), &entry, rank});
    }
  }
  return inputs;
}

std::string name_of(const Input& input, bool several) {
  return capitalised((several ? component_name(*input.step) + ": " : std::string()) + short_name(*input.entry));
}

double height_of(const Input& input, bool several) {
  constexpr double of_line = 3.2, gap = 0.8, letters_in_line = 23.0, of_source = 13.0;  // mm; letters
  const double letters = letters_of(name_of(input, several)), source = letters_of(short_origin(*input.entry));
  return gap + of_line * std::ceil(std::max(letters / letters_in_line, source / of_source));
}

/// Drops the inputs of the highest ranks until the rest fits.
void keep_what_fits(std::vector<Input>& inputs, bool several, double height) {
  std::vector<Input> sorted = inputs;
  std::ranges::stable_sort(sorted, {}, &Input::rank);
  std::set<const Entry*> kept;
  for (const Input& input : sorted) {
    height -= height_of(input, several);
    if (height < 0.0) break;
    kept.insert(input.entry);
  }
  std::erase_if(inputs, [&](const Input& input) { return !kept.contains(input.entry); });
}

std::vector<Cell> row_of(const Input& input, bool several) {
  const Entry& entry = *input.entry;
  const std::string_view symbol = named_symbol(entry.path).symbol;
  const bool is_quantity = entry.word.empty() && !is_word(symbol);  // "at", of a point, is no symbol
  return {name_of(input, several), is_quantity ? Cell(Symbol{std::string(symbol)}) : Cell(std::string()),
          short_value(entry), short_origin(entry)};
}

}  // namespace

Table inputs_table(const Project& project, const std::vector<Governing>& governing, double height) {
  constexpr double heading = 12.0;
  const bool several = project.steps.size() > 1;
  std::vector<Input> inputs = given_inputs(project, governing);
  const std::size_t all = inputs.size();
  keep_what_fits(inputs, several, height - heading);
  Table table{{}, {say("Quantity"), say("Symbol"), say("Value"), say("Source")}, {}};
  for (const Input& input : inputs) table.rows.push_back(row_of(input, several));
  if (all > inputs.size())
    table.rows.push_back({say("{1} more: appendix", std::to_string(all - inputs.size())).text(), std::string(),
                          std::string(), std::string()});
  return table;
}

}  // namespace loadpath::report
