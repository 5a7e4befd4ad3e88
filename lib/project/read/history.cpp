#include "lib/project/read/history.hpp"

#include "lib/project/read/reading.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/literal.hpp"
#include "lib/rainflow/series/cells.hpp"
#include "lib/rainflow/series/read_series.hpp"
#include "lib/rainflow/turning_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

namespace loadpath::project {

namespace {

namespace fs = std::filesystem;
using toml::Tree;

constexpr std::size_t most_turns = 20'000'000;  // of 12 bytes each
constexpr std::size_t most_in_step = 5'000;     // each is looked at on thousands of planes
constexpr double largest = 1e30;                // as of a value that is typed: beyond all machines

constexpr std::array<std::pair<std::string_view, rainflow::Format>, 4> forms{{{"csv", rainflow::Format::csv},
                                                                              {"npy", rainflow::Format::npy},
                                                                              {"f64", rainflow::Format::f64},
                                                                              {"f32", rainflow::Format::f32}}};

Fault wrong_history(Message message, Message hint) { return {0, 1, std::move(message), std::move(hint)}; }

/// What a heading names: "F [kN]"; none where it names no unit of the field.
std::optional<UnitValue> unit_in(std::string_view heading, const FieldInfo& field) {
  const std::string unit = rainflow::heading_of(heading).unit;
  const auto parsed = unit.empty() ? Outcome<UnitValue>(Fault{}) : parse_unit(unit);
  if (!parsed || parsed->dimension != field.dimension || parsed->offset != 0.0) return std::nullopt;
  return *parsed;
}

/// The value of one unit: "MPa", or "2.5 MPa"; without it, what the heading says.
Outcome<double> unit_of(const Tree& table, const FieldInfo& field, std::string_view heading = {}) {
  const auto* const unit = table.find("unit");
  if (unit == nullptr) {
    if (const auto unit_there = unit_in(heading, field)) return unit_there->factor;
  }
  if (unit == nullptr && field.dimension.is_number()) return 1.0;
  const auto wanted = [&](std::string_view text) {
    return wrong_history(
        say("'{1}' is not a valid {2}", text, name_of(field.dimension)),
        say("name the unit in the header, F [{1}], or give the unit of the numbers in the file: unit = "
            "\"{1}\", or unit = \"2.5 {1}\"",
            field.unit));
  };
  if (unit == nullptr || unit->value.type != Tree::Type::text) return wanted(unit == nullptr ? "" : unit->value.text);
  const std::string& text = unit->value.text;
  const auto plain = parse_unit(text);
  const auto scaled = parse_literal(text);
  const bool fits = (plain && plain->dimension == field.dimension && plain->offset == 0.0) ||
                    (scaled && scaled->dimension == field.dimension);
  const double factor = !fits ? 0.0 : plain ? plain->factor : scaled->si;
  if (!(std::abs(factor) > 1.0 / largest) || std::abs(factor) > largest) return wanted(text);
  return factor;
}

/// A unit of the key that the heading contradicts; a scale, "2.5 MPa", does not.
std::optional<Fault> contradiction(const Tree& table, const FieldInfo& field, std::string_view heading) {
  const auto* const unit = table.find("unit");
  const auto there = unit_in(heading, field);
  const auto here = unit == nullptr ? Outcome<UnitValue>(Fault{}) : parse_unit(unit->value.text);
  if (!there || !here || std::abs(here->factor / there->factor - 1.0) < 1e-12) return std::nullopt;
  return wrong_history(say("the heading is '{1}', and unit = \"{2}\"", heading, unit->value.text),
                       say("leave out unit; or, where the heading is wrong, write unit = \"1 {1}\"", unit->value.text));
}

Outcome<rainflow::Form> form_of(const Tree& table) {
  rainflow::Form form;
  const auto* const named_form = table.find("form");
  const std::string& path = table.find("file")->value.text;
  const auto by_name = rainflow::format_of(path);
  if (named_form != nullptr) {
    const auto known =
        std::find_if(forms.begin(), forms.end(), [&](const auto& row) { return row.first == named_form->value.text; });
    if (known == forms.end())
      return wrong_history(say("'{1}' is not a known file format", named_form->value.text),
                           say("csv, npy, f64 or f32"));
    form.format = known->second;
  } else if (by_name) {
    form.format = *by_name;
  } else if (path != "-") {
    return wrong_history(say("the name '{1}' does not show the format of the file", path),
                         say("add form = \"csv\", npy, f64 or f32"));
  }
  const auto place_in_file = [&](const char* key) -> std::string {
    const auto* const entry = table.find(key);
    if (entry == nullptr) return {};
    return entry->value.type == Tree::Type::number ? format_exact(entry->value.number) : entry->value.text;
  };
  form.column = place_in_file("column"), form.row = place_in_file("row");
  if (form.row.empty()) return form;
  if (!form.column.empty())
    return wrong_history(say("a series is a column or a row of the file, not both"),
                         say("leave out one of column and row"));
  if (form.format != rainflow::Format::csv)
    return wrong_history(say("'row' applies to text files, and this is not one"), say("leave out row"));
  return form;
}

fs::path path_of(const Tree& named) { return fs::path(named.place.file).parent_path() / named.text; }

/// Only files: a device may have no end, and a named pipe waits for a writer. "-" is what is piped in.
Outcome<std::unique_ptr<rainflow::Source>> open(const Tree& table) {
  const Tree& named = table.find("file")->value;
  if (named.text == "-") return rainflow::open_source("-");
  const fs::path path = path_of(named);
  std::error_code error;
  const fs::file_type type = fs::status(path, error).type();
  if (type != fs::file_type::regular)
    return wrong_history(say("file '{1}' does not exist or cannot be read", path.string()),
                         fs::exists(path, error)
                             ? say("the file must have an end; for piped input use file = \"-\", with its form")
                             : say("the path is relative to the project file"));
  return rainflow::open_source(path.string());
}

/// The samples that a file of plain numbers has at most; none of what is piped in.
std::size_t samples_in(const Tree& table) {
  std::error_code error;
  const auto bytes = fs::file_size(path_of(table.find("file")->value), error);
  return error ? 0 : std::min<std::size_t>(bytes / sizeof(double), most_turns);
}

/// Where the series turns, or all of it, in the unit of the file.
class Turns {
 public:
  explicit Turns(Kept kept) : kept_(kept) {}

  /// Memory for so many samples: what is not needed is never touched.
  void expect(std::size_t samples) {
    values_.reserve(samples);
    at_.reserve_samples(samples);
  }

  /// None where all is well.
  std::optional<Fault> take(std::span<const double> samples) {
    if (kept_ == Kept::all) return take_all(samples);
    next_values_.resize(samples.size() + 4);
    next_at_.resize(next_values_.size());
    const auto more = turning_points_.feed(samples, next_values_.data(), next_at_.data());
    if (!more) return more.fault();
    append(*more);
    if (values_.size() > most_turns)
      return wrong_history(say("it has more than {1} turning points", std::to_string(most_turns)),
                           say("cut it, and count its parts"));
    return std::nullopt;
  }
  /// None where there is a history.
  std::optional<Fault> finish(const Message& what) {
    if (kept_ == Kept::turns) append(turning_points_.finish(next_values_.data(), next_at_.data()));
    if (samples() == 0) return wrong_history(say("{1} has no values", what), {});
    if (samples() == 1) return wrong_history(say("{1} has one value; a history needs at least two", what), {});
    return std::nullopt;
  }
  [[nodiscard]] std::vector<double>& values() { return values_; }
  /// Their samples, counted from 0.
  [[nodiscard]] Places& at() { return at_; }
  [[nodiscard]] std::uint64_t samples() const {
    return kept_ == Kept::all ? values_.size() : turning_points_.samples();
  }

 private:
  std::optional<Fault> take_all(std::span<const double> samples) {
    if (values_.size() + samples.size() > most_in_step)
      return wrong_history(say("it has more than {1} samples", std::to_string(most_in_step)),
                           say("several series stay in step: cut all of them to the same range"));
    for (const double sample : samples) {
      if (!std::isfinite(sample))
        return wrong_history(say("sample {1} is not a number", std::to_string(values_.size())), {});
      at_.add_sample(values_.size());
      values_.push_back(sample);
    }
    return std::nullopt;
  }
  void append(std::size_t count) {
    const auto end = static_cast<std::ptrdiff_t>(count);
    values_.insert(values_.end(), next_values_.begin(), next_values_.begin() + end);
    for (std::size_t i = 0; i < count; ++i) at_.add_sample(next_at_[i]);
  }

  Kept kept_;
  rainflow::TurningPoints turning_points_;
  std::vector<double> values_;
  Places at_;
  std::vector<double> next_values_ = std::vector<double>(4);  // of the samples that were taken last
  std::vector<std::uint64_t> next_at_ = std::vector<std::uint64_t>(4);
};

std::optional<Fault> read_turns(rainflow::Reader& reader, Turns& turns) {
  while (true) {
    const auto samples = reader.next();
    if (!samples) return samples.fault();
    if (samples->empty()) break;
    if (auto fault = turns.take(*samples)) return fault;
  }
  return turns.finish(say("the file"));
}

std::optional<Fault> take_values(const Tree& list, Turns& turns) {
  std::vector<double> values;
  for (const Tree& item : list.items) {
    if (item.type == Tree::Type::number) values.push_back(item.number);
  }
  if (values.empty() || values.size() != list.items.size())
    return wrong_history(say("a history is a list of numbers"), say("values = [0, 3, -1], unit = \"MPa\""));
  if (auto fault = turns.take(values)) return fault;
  return turns.finish(say("the list"));
}

/// In SI, over the samples; a value that the field refuses is a fault.
std::optional<Fault> put(Turns& turns, double unit, const FieldInfo& field, History& history) {
  auto axis = std::make_shared<Axis>();
  axis->quantity = "sample", axis->unit = "-";
  for (std::size_t i = 0; i < turns.values().size(); ++i) {
    double& si = turns.values()[i];
    si *= unit;
    if (!field.bounds.holds(si) || std::abs(si) > largest)
      return wrong_history(say("sample {1} is {2}", std::to_string(static_cast<std::uint64_t>(turns.at()[i])),
                               format_quantity(si, field.unit)),
                           say("check the column and the unit"));
  }
  history.series.si = std::move(turns.values());
  axis->at = std::move(turns.at());
  history.series.signature = {field.dimension, axis.get()};
  history.axis = std::move(axis);
  return std::nullopt;
}

}  // namespace

bool names_history_file(const Tree& tree) {
  const auto* const file = tree.type == Tree::Type::table ? tree.find("file") : nullptr;
  return file != nullptr && file->value.type == Tree::Type::text;
}

bool is_history(const Tree& tree) {
  return names_history_file(tree) || (tree.type == Tree::Type::table && tree.find("values") != nullptr);
}

bool read_history(const Tree& table, const FieldInfo& field, Kept kept, History& history, HistoryFault& fault) {
  const auto refuse = [&](const char* key, const Fault& found) {
    fault = {key, {}, found};
    return false;
  };
  const bool of_file = names_history_file(table);
  const bool names_unit = table.find("unit") != nullptr || !of_file;
  const auto unit = names_unit ? unit_of(table, field) : Outcome<double>(1.0);
  if (!unit) return refuse("unit", unit.fault());
  Turns turns(kept);
  if (!of_file) {
    if (const auto found = take_values(table.find("values")->value, turns)) return refuse("values", *found);
    if (const auto found = put(turns, *unit, field, history)) return refuse("values", *found);
    return true;
  }
  const auto form = form_of(table);
  if (!form) return refuse(table.find("form") == nullptr ? "file" : "form", form.fault());
  auto source = open(table);
  if (!source) return refuse("file", source.fault());
  const auto refuse_at_line = [&](const char* key, const Fault& found) {
    refuse(key, found);
    const Tree& named = table.find("file")->value;
    const bool has_lines = form->format == rainflow::Format::csv && named.text != "-" && found.at > 0;
    if (has_lines) fault.place = {path_of(named).string(), static_cast<int>(found.at), 1, 1};
    return false;
  };
  auto reader = rainflow::read_series(std::move(*source), *form);
  if (!reader) return refuse_at_line("file", reader.fault());
  if (const auto found = contradiction(table, field, (*reader)->heading())) return refuse("unit", *found);
  const auto scale = unit_of(table, field, (*reader)->heading());
  if (!scale) return refuse("unit", scale.fault());
  if (form->format == rainflow::Format::f64) turns.expect(samples_in(table));
  if (const auto found = read_turns(**reader, turns)) return refuse_at_line("file", *found);
  if (const auto found = put(turns, *scale, field, history)) return refuse("file", *found);
  return true;
}

}  // namespace loadpath::project
