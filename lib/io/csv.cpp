#include "lib/io/csv.hpp"

#include "lib/quantity/format.hpp"

#include <cmath>

namespace loadpath::io {

namespace {

/// Empty where there is no value: a reader of CSV must not meet "nan". 15 digits: 30, not 29.999999999999996.
std::string cell(double si, const std::string& unit) {
  return std::isfinite(si) ? format_number(in_unit(si, unit), 15) : std::string();
}

std::string table_of(const project::Account& account, const Axis& axis) {
  std::string text = axis.quantity + " [" + axis.unit + "]";
  std::vector<const project::Entry*> columns;
  for (const project::Entry& e : account.results) {
    if (e.value.signature.axis == &axis) columns.push_back(&e);
  }
  for (const auto* e : columns) text += "," + e->path + " [" + e->unit + "]";
  text += "\n";
  for (std::size_t i = 0; i < axis.at.size(); ++i) {
    text += cell(axis.at[i], axis.unit);
    for (const auto* e : columns) text += "," + cell(e->value.si[i], e->unit);
    text += "\n";
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
