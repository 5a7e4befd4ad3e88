#include "lib/export/sweep/csv.hpp"

#include "lib/account/state.hpp"
#include "lib/quantity/format.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace loadpath::exports {

namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string all = "\"";
  for (const char c : text) all += c == '"' ? std::string("\"\"") : std::string(1, c);
  return all + "\"";
}

std::string head(const std::string& name, const std::string& unit) {
  return quoted(unit.empty() || unit == "-" ? name : name + " [" + unit + "]");
}

void append(double value, std::string& text) {
  if (!std::isfinite(value)) return;
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value + 0.0);
  text.append(buffer.data(), end.ptr);
}

/// A column in its unit.
std::vector<double> shown(const std::vector<double>& si, const std::string& unit) {
  return unit.empty() || unit == "-" ? si : in_unit(si, unit);
}

std::string word_of(double state) {
  if (state == account::refused_state) return "refused";
  return account::slug(static_cast<account::State>(static_cast<int>(state)));
}

}  // namespace

std::string csv_head(const project::SweepPlan& plan) {
  std::string text = "point";
  for (const project::SweptInput& input : plan.inputs) text += "," + head(input.name, input.unit);
  for (const std::size_t k : plan.output_columns()) text += "," + head(plan.columns[k].name, plan.columns[k].unit);
  return text + ",state,utilisation\n";
}

void append_csv(const project::SweepPlan& plan, const project::SolvedBlock& block, std::string& text) {
  const std::size_t inputs = plan.inputs.size(), results = plan.columns.size();
  std::vector<std::vector<double>> columns;
  for (std::size_t i = 0; i < inputs; ++i) columns.push_back(shown(block.inputs[i], plan.inputs[i].unit));
  for (const std::size_t k : plan.output_columns()) columns.push_back(shown(block.results[k], plan.columns[k].unit));
  for (std::size_t row = 0; row < block.count; ++row) {
    text += std::to_string(block.first + row);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      text += ',';
      const bool is_word = c < inputs && !plan.inputs[c].words.empty();
      if (is_word)
        text += quoted(plan.inputs[c].words[static_cast<std::size_t>(columns[c][row])]);
      else
        append(columns[c][row], text);
    }
    text += "," + word_of(block.results[results][row]) + ",";
    append(block.results[results + 1][row], text);
    text += '\n';
  }
}

}  // namespace loadpath::exports
