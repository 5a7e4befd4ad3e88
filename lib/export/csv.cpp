#include "lib/export/csv.hpp"

#include "lib/project/project.hpp"
#include "lib/quantity/decimal.hpp"
#include "lib/quantity/format.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace loadpath::exports {

namespace {

using account::Entry;
using project::SeriesChoice;

/// 15 digits: 30, not 29.999999999999996.
void append_rounded(double value, std::string& text) {
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value + 0.0, std::chars_format::general, 15);
  text.append(buffer.data(), end.ptr);
}

/// Numbers in the unit of their column, with as many digits as rounding leaves significant.
class Column {
 public:
  Column(const std::vector<double>& si, double rounding, const std::string& unit) : values_(in_unit(si, unit)) {
    if (rounding > 0.0) decimals_ = Decimals::beyond(in_unit(rounding, unit) - in_unit(0.0, unit));
  }
  /// Nothing if there is no value: a reader of CSV must not meet "nan".
  void add_cell(std::size_t position, std::string& text) const {
    const double value = values_[position];
    if (!std::isfinite(value)) return;
    if (decimals_)
      decimals_->append_nearest(value, text);
    else
      append_rounded(value, text);
  }

 private:
  std::vector<double> values_;
  std::optional<Decimals> decimals_;  // if the rounding error is known
};

std::vector<const Entry*> chosen_series(const project::Step& step, const SeriesChoice& choice) {
  std::vector<const Entry*> series;
  for (const Entry& e : step.account().results) {
    if (e.values().is_series() && choice.holds(step.name(), e.path)) series.push_back(&e);
  }
  return series;
}

/// All of one axis.
std::string table_of(const std::vector<const Entry*>& series) {
  const Axis& axis = *series.front()->values().signature.axis;
  std::string text = axis.quantity + " [" + axis.unit + "]";
  std::vector<Column> columns{{axis.at.values(), 0.0, axis.unit}};
  columns.reserve(series.size() + 1);
  for (const Entry* e : series) {
    if (e->values().signature.axis != &axis) continue;
    text += "," + e->path + " [" + e->unit + "]";
    columns.emplace_back(e->values().si, e->values().rounding, e->unit);
  }
  text += "\n";
  constexpr std::size_t usual = 16;  // length of a cell
  text.reserve(text.size() + usual * columns.size() * axis.at.size());
  for (std::size_t i = 0; i < axis.at.size(); ++i) {
    for (const Column& column : columns) {
      column.add_cell(i, text);
      text += ',';
    }
    text.back() = '\n';
  }
  return text;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> csv_of(const project::Project& project, const SeriesChoice& choice) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& step : project.steps) {
    const auto series = chosen_series(*step, choice);
    if (!series.empty()) files.emplace_back(step->name() + ".csv", table_of(series));
  }
  return files;
}

}  // namespace loadpath::exports
