#include "lib/report/verification.hpp"

#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace loadpath::report {

namespace {

using project::Comparison;
using project::Expectation;

constexpr int most_digits = 2;  // of a deviation

constexpr double rounding = 1e-9;  // smaller deviations differ between C libraries

/// Whether the result is the published value but for rounding.
bool is_same(const Comparison& c) { return std::abs(c.deviation) <= rounding; }

/// Whether the deviation is a difference, in the unit of the value.
bool is_absolute(const Comparison& c) { return c.expectation->within_si || c.expectation->is.si == 0.0; }

/// "[Gere]" of "[Gere] problem 8.2-4"; a source without a key as a whole.
std::string key_of(const std::string& source) {
  const std::size_t first = source.find('['), last = source.find(']', first);
  return last == std::string::npos ? source : source.substr(first, last + 1 - first);
}

/// "keys" of "keys.toml", "press" of "press/project.toml".
std::string anchor_of(const std::string& file) {
  const std::filesystem::path path(file);
  const bool is_of_folder = path.stem() == "project" && path.has_parent_path();
  return (is_of_folder ? path.parent_path().filename() : path.stem()).string();
}

std::string title_of(const VerifiedFile& file) {
  return file.project.title.empty() ? file.project.file : file.project.title;
}

/// The largest deviation as a part of a published value; empty if all are differences in a unit.
Cell largest_deviation(const std::vector<Comparison>& values) {
  double largest = -1.0;
  bool is_known = false;
  for (const Comparison& value : values) {
    is_known = is_known || !std::isnan(value.deviation);
    if (!is_absolute(value) && !std::isnan(value.deviation)) largest = std::max(largest, std::abs(value.deviation));
  }
  if (!is_known) return say("no result");
  if (largest < 0.0) return say("see below");
  return largest <= rounding ? format_quantity(0.0, "%", most_digits) : format_quantity(largest, "%", most_digits);
}

Table table_of_files(std::span<const VerifiedFile> files) {
  Table table{
      say("Published cases"), {say("topic"), say("values"), say("hold"), say("sources"), say("largest deviation")}, {}};
  for (const VerifiedFile& file : files) {
    std::set<std::string> sources;
    for (const Comparison& value : file.values) sources.insert(key_of(value.expectation->source));
    const auto hold = std::ranges::count_if(file.values, [](const Comparison& value) { return value.holds; });
    table.rows.push_back({title_of(file), std::to_string(file.values.size()), std::to_string(hold),
                          std::to_string(sources.size()), largest_deviation(file.values)});
  }
  return table;
}

Table table_of_values(const VerifiedFile& file) {
  Table table{{}, {say("quantity"), say("published"), say("computed"), say("deviation"), say("source")}, {}};
  for (const Comparison& value : file.values) {
    table.rows.push_back({value.expectation->text, value.expectation->is_text, computed_text(value),
                          value.holds ? Cell(deviation_text(value)) : Cell(say("MISS: {1}", deviation_text(value))),
                          source_text(value)});
  }
  return table;
}

Paragraph introduction(std::span<const VerifiedFile> files) {
  std::size_t values = 0, misses = 0;
  std::set<std::string> sources;
  for (const VerifiedFile& file : files) {
    values += file.values.size();
    for (const Comparison& value : file.values) {
      misses += value.holds ? 0 : 1;
      sources.insert(key_of(value.expectation->source));
    }
  }
  return {say("{1} published values from {2} sources: this version reproduces {3} and misses {4}. A value is "
              "reproduced if it differs from "
              "the published one by at most half a unit of its last printed digit, or by the tolerance that its case "
              "states with the reason.",
              std::to_string(values), std::to_string(sources.size()), std::to_string(values - misses),
              std::to_string(misses)),
          misses == 0 ? Paragraph::Tone::plain : Paragraph::Tone::warning};
}

}  // namespace

std::string computed_text(const Comparison& value) {
  const Expectation& e = *value.expectation;
  const int digits = e.digits ? std::max(*e.digits, 6) : 6;
  return format_quantity(is_same(value) ? e.is.si : value.ours, e.unit, digits);
}

std::string deviation_text(const Comparison& value) {
  const Expectation& e = *value.expectation;
  if (std::isnan(value.deviation)) return "not available";
  const bool absolute = is_absolute(value);
  if (is_same(value)) return format_quantity(0.0, absolute ? e.unit : "%", most_digits);
  return absolute ? format_quantity(value.ours - e.is.si, e.unit, most_digits)
                  : format_quantity(value.deviation, "%", most_digits);
}

std::string source_text(const Comparison& value) {
  const Expectation& e = *value.expectation;
  return e.source + (e.note.empty() ? "" : "; " + e.note);
}

Document verification(std::span<const VerifiedFile> files, const std::string& program) {
  Document document;
  document.title = "Verification";
  document.program = program;
  document.meta = {{say("Program"), program}};
  document.blocks.emplace_back(introduction(files));
  document.blocks.emplace_back(table_of_files(files));
  for (const VerifiedFile& file : files) {
    document.blocks.emplace_back(Heading{2, title_of(file), anchor_of(file.project.file)});
    document.blocks.emplace_back(Paragraph{say("File: {1}", file.project.file), Paragraph::Tone::note});
    document.blocks.emplace_back(table_of_values(file));
  }
  return document;
}

}  // namespace loadpath::report
