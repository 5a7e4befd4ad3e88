#include "lib/io/csv.hpp"

#include "lib/quantity/format.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace loadpath::io {

namespace {

/// Nothing where there is no value: a reader of CSV must not meet "nan". 15 digits: 30, not 29.999999999999996.
void add_cell(double value, std::string& text) {
  if (!std::isfinite(value)) return;
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value + 0.0, std::chars_format::general, 15);
  text.append(buffer.data(), end.ptr);
}

std::string table_of(const project::Account& account, const Axis& axis) {
  std::string text = axis.quantity + " [" + axis.unit + "]";
  std::vector<const project::Entry*> columns;
  for (const project::Entry& e : account.results) {
    if (e.value.signature.axis == &axis) columns.push_back(&e);
  }
  for (const auto* e : columns) text += "," + e->path + " [" + e->unit + "]";
  text += "\n";
  const std::vector<double> places = in_unit(axis.at, axis.unit);
  std::vector<std::vector<double>> values;
  values.reserve(columns.size());
  for (const auto* e : columns) values.push_back(in_unit(e->value.si, e->unit));
  for (std::size_t i = 0; i < places.size(); ++i) {
    add_cell(places[i], text);
    for (const auto& column : values) {
      text += ',';
      add_cell(column[i], text);
    }
    text += '\n';
  }
  return text;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> csv_of(const project::Project& project) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& step : project.steps) {
    for (const project::Entry& e : step->account().results) {
      if (!e.value.is_series()) continue;
      files.emplace_back(step->name() + ".csv", table_of(step->account(), *e.value.signature.axis));
      break;
    }
  }
  return files;
}

}  // namespace loadpath::io
