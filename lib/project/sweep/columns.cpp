#include "lib/project/sweep/columns.hpp"

#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

using Kind = SweptResult::Kind;

/// The fault of "m" in "m = rod.mass"; the columns that every sweep has keep their names.
std::optional<Fault> wrong_name(const std::string& name, const std::string& text) {
  const auto fault = [&](Message message, Message hint) {
    return Fault{0, std::max<std::size_t>(1, name.size()), std::move(message), std::move(hint)};
  };
  if (name.empty()) return fault(say("a name is missing before '='"), say("write m = {1}", text));
  if (name.find_first_of("<>!") != std::string::npos || text.starts_with('='))
    return fault(say("a result is a number, not a comparison"),
                 say("\"passes\" is 1 or 0; --such-that and --seek compare"));
  if (name != text && (name == "point" || name == "state" || name == "utilisation"))
    return fault(say("'{1}' is a column of every sweep", name),
                 say("give it another name: \"my_{1} = {2}\"", name, text));
  return std::nullopt;
}

std::optional<Kind> kind_of_word(std::string_view word) {
  if (word == "state") return Kind::state;
  if (word == "utilisation") return Kind::utilisation;
  if (word == "passes") return Kind::passes;
  return std::nullopt;
}

/// "rod", "buckling", "utilisation" of "rod.modes.buckling.utilisation"; false if the text speaks of no verdict.
bool read_verdict(const std::string& text, const Project& project, SweptResult& column) {
  const std::size_t last = text.rfind('.');
  if (const auto kind = kind_of_word(text)) {
    column.kind = *kind;
    return true;
  }
  constexpr std::string_view modes = ".modes.";
  const std::size_t at = text.find(modes);
  const auto kind = last == std::string::npos ? std::nullopt : kind_of_word(std::string_view(text).substr(last + 1));
  const std::string of = kind ? text.substr(0, last) : text;
  if (!kind && at == std::string::npos) return false;
  column.step = of.substr(0, std::min(at, of.size()));
  if (at != std::string::npos && at < of.size()) column.mode = of.substr(at + modes.size());
  column.kind = kind.value_or(Kind::utilisation);
  const Step* const step = project.find(column.step);
  return step != nullptr && (at != std::string::npos || step->field(text.substr(last + 1)) == nullptr);
}

/// The unit that a result is shown in: of the first number in it that is of its kind, else the custom of that kind, as
/// the results of a mechanism have it.
std::string unit_of(const SweptResult& column, const Project& project) {
  for (const auto& reference : column.expression.references()) {
    const std::string& path = reference.path;
    const Step* const step = project.find(path.substr(0, path.find('.')));
    const FieldInfo* const field = step == nullptr ? nullptr : step->field(path.substr(path.find('.') + 1));
    if (field != nullptr && field->dimension == column.dimension) return field->unit;
  }
  return readable_unit(0.0, column.dimension);
}

}  // namespace

std::vector<std::string> modes_of(const Step& step) {
  std::vector<std::string> modes;
  for (const ModeInfo& mode : step.input().calculator->modes) modes.emplace_back(mode.id);
  for (const char* id : {"inputs", "load"}) modes.emplace_back(id);  // without a value, without a load
  return modes;
}

std::vector<SweptResult> verdict_columns(const Project& project) {
  const auto verdict = [](Kind kind, const std::string& name, const std::string& step, const std::string& mode) {
    SweptResult column;
    column.kind = kind;
    column.name = column.text = name;
    column.unit = "-";
    column.step = step;
    column.mode = mode;
    return column;
  };
  std::vector<SweptResult> columns;
  columns.push_back(verdict(Kind::state, "state", "", ""));
  columns.push_back(verdict(Kind::utilisation, "utilisation", "", ""));
  for (const auto& step : project.steps) {
    for (const std::string& mode : modes_of(*step)) {
      const std::string name = step->name() + ".modes." + mode;
      columns.push_back(verdict(Kind::state, name + ".state", step->name(), mode));
      columns.push_back(verdict(Kind::utilisation, name + ".utilisation", step->name(), mode));
    }
  }
  return columns;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::pair<std::string, std::string> name_and_text(const std::string& column) {
  const std::size_t equals = column.find('=');
  if (equals == std::string::npos) return {trimmed(column), trimmed(column)};
  return {trimmed(column.substr(0, equals)), trimmed(column.substr(equals + 1))};
}

Outcome<SweptResult> read_column(const std::string& given, Project& project) {
  SweptResult column;
  auto [name, text] = name_and_text(given);
  column.name = name;
  column.text = text;
  if (text.empty()) return Fault{0, 1, say("a result is expected"), say("name one: \"rod.u\"")};
  if (auto wrong = wrong_name(name, text)) return std::move(*wrong);
  if (read_verdict(text, project, column)) {
    const Step* const step = project.find(column.step);
    const auto modes = step == nullptr ? std::vector<std::string>{} : modes_of(*step);
    if (text.find(".modes.") != std::string::npos && std::find(modes.begin(), modes.end(), column.mode) == modes.end())
      return Fault{0, text.size(), say("'{1}' has no mode '{2}'", column.step, column.mode),
                   did_you_mean(column.mode, modes, there_is(modes))};
    return column;
  }
  auto parsed = Expression::parse(text);
  if (!parsed) return parsed.fault();
  column.expression = std::move(*parsed);
  std::vector<Issue> too_large;
  project.values.write_into(column.expression, {}, name, too_large);
  if (!too_large.empty()) return Fault{0, text.size(), too_large.front().message, too_large.front().hint};
  const auto signature = column.expression.check([&](const std::string& path) { return project.signature(path); });
  if (!signature) return signature.fault();
  if (signature->axis != nullptr)
    return Fault{0, text.size(), say("'{1}' is a series over {2}", text, signature->axis->name()),
                 say("reduce it with peak, max, min, mean, rms or at")};
  column.dimension = signature->dimension;
  column.unit = unit_of(column, project);
  return column;
}

}  // namespace loadpath::project
