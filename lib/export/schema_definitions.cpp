#include "lib/export/schema_fields.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/unit_table.hpp"
#include "lib/table/library.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>

namespace loadpath::exports {

namespace {

namespace json = boost::json;

constexpr std::string_view sign_and_digit = "[-+\u2212]?[.,]?[0-9]";
constexpr std::string_view no_letter = "[^A-Za-z\u0410-\u044F\u00B0%\u00B5\u03BC]";
constexpr std::string_view letter = "[A-Za-z\u0410-\u044F]";
/// A product, a quotient or a power of units, or one over a unit: a pattern cannot express its dimension.
constexpr std::string_view composed = "[*\u00B7\u22C5/^\u00B2\u00B3\u2074\u207B0-9]";

std::string escaped(std::string_view text) {
  std::string all;
  for (const char c : text) {
    if (std::string_view(R"(\^$.|?*+()[]{}/)").find(c) != std::string_view::npos) all += '\\';
    all += c;
  }
  return all;
}

bool is_alike(const Dimension& a, const Dimension& b) { return a.without_angle() == b.without_angle(); }

/// The units of a dimension with every prefix, as alternatives.
std::string units_of(const Dimension& dimension) {
  std::string all;
  for (const UnitName& unit : all_unit_names(false)) {
    if (is_alike(unit.row->dimension, dimension)) all += (all.empty() ? "" : "|") + escaped(unit.text);
  }
  return all;
}

/// A number with a unit of the dimension or with one that is composed of several; an expression; a search.
std::string pattern_of(const Dimension& dimension) {
  if (dimension.is_number()) return "^\\s*([=?]|" + std::string(sign_and_digit) + "|[-+]?inf$)";
  const std::string number(sign_and_digit), units = units_of(dimension);
  std::string pattern = "^\\s*(=|\\?$";
  if (!units.empty()) pattern += "|" + number + "(.*" + std::string(no_letter) + ")?(" + units + ")\\s*$";
  const std::string a_letter(letter);
  return pattern + "|" + number + ".*(" + a_letter + ".*" + std::string(composed) + "|/\\s*" + a_letter + "))";
}

/// A name valid after "#/$defs/".
std::string slug(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return text;
}

json::object closed(json::array required, json::object properties) {
  return {{"type", "object"},
          {"additionalProperties", false},
          {"required", std::move(required)},
          {"properties", std::move(properties)}};
}

/// Ranges, lists and distributions for sweeps (lib/project/read/spread.hpp).
void add_spreads(const json::object& one, json::array& forms) {
  const json::object any{{"type", json::array{"string", "number"}}}, whole{{"type", "integer"}, {"minimum", 2}};
  const json::object law{{"enum", json::array{"normal", "lognormal", "uniform", "triangular", "weibull"}}};
  forms.push_back(json::object{{"type", "array"}, {"items", one}, {"minItems", 1}});
  forms.push_back(closed({"from", "to", "step"}, {{"from", any}, {"to", any}, {"step", any}}));
  forms.push_back(closed({"from", "to", "count"}, {{"from", any}, {"to", any}, {"count", whole}}));
  forms.push_back(closed({"from", "to", "log"}, {{"from", any}, {"to", any}, {"log", whole}}));
  forms.push_back(closed({"each"}, {{"each", any}, {"from", any}, {"to", any}}));
  forms.push_back(closed({"mean", "sd"}, {{"mean", any}, {"sd", any}, {"distribution", law}}));
  forms.push_back(closed({"value", "tolerance"}, {{"value", any}, {"tolerance", any}, {"distribution", law}}));
  forms.push_back(closed({"min", "max"}, {{"min", any}, {"mode", any}, {"max", any}, {"distribution", law}}));
  forms.push_back(
      closed({"scale", "shape"}, {{"scale", any}, {"shape", any}, {"location", any}, {"distribution", law}}));
}

json::array forms_of(const Dimension& dimension) {
  const json::object text{{"type", "string"}, {"pattern", pattern_of(dimension)}};
  json::array forms{text, of_one_text("stock")};
  add_spreads(dimension.is_number() ? json::object{{"type", json::array{"string", "number"}}} : text, forms);
  if (dimension.is_number()) forms.push_back(json::object{{"type", "number"}});
  return forms;
}

/// One as it is typed, one of another step.
json::array examples_of(const Dimension& dimension) {
  const std::string unit = readable_unit(1.0, dimension);
  return {dimension.is_number() || unit.empty() ? json::value(2) : json::value("2 " + unit), "=step.result"};
}

json::array names_of(const std::string& group) {
  json::array names;
  for (const table::Table* table : table::tables_of(group)) {
    for (const table::Row& row : table->rows) {
      names.emplace_back(row.name);
      for (const std::string& alias : row.aliases) names.emplace_back(alias);
    }
  }
  return names;
}

/// The columns of a group, each a quantity.
json::object columns_of(const table::Table& group, Definitions& definitions) {
  json::object columns;
  for (const table::Column& column : group.columns) {
    columns[column.key] = definitions.quantity(column.dimension);
    columns[column.key].as_object()["description"] = "in " + column.unit + " or a unit like it";
  }
  return columns;
}

json::object row_schema(const std::string& group, Definitions& definitions) {
  const table::Table head = table::columns_of(group);
  json::object properties = columns_of(head, definitions);
  if (!head.size.key.empty()) {
    json::object step = properties;
    step["size_max"] = definitions.quantity(head.size.dimension);
    properties["by_size"] = {{"type", "array"}, {"items", closed({"size_max"}, std::move(step))}};
  }
  properties["because"] = {{"type", "object"}, {"additionalProperties", json::object{{"type", "string"}}}};
  for (const char* word : {"standard", "kind", "note", "source"}) properties[word] = {{"type", "string"}};
  properties["aliases"] = {{"type", "array"}, {"items", json::object{{"type", "string"}}}};
  return closed({"source"}, std::move(properties));
}

json::object series_schema() {
  const json::object text{{"type", "string"}};
  return closed({"unit", "sizes", "source"},
                {{"title", text},
                 {"unit", text},
                 {"source", text},
                 {"sizes", json::object{{"type", "array"}, {"items", json::object{{"type", "number"}}}}}});
}

json::object rows(json::object row) { return {{"type", "object"}, {"additionalProperties", std::move(row)}}; }

}  // namespace

json::object of_one_text(const char* key) { return closed({key}, {{key, json::object{{"type", "string"}}}}); }

json::object Definitions::quantity(const Dimension& dimension) {
  const std::string name = "quantity_" + slug(dimension.is_number() ? "number" : si_unit(dimension));
  if (!all_.contains(name)) all_[name] = {{"anyOf", forms_of(dimension)}, {"examples", examples_of(dimension)}};
  return reference(name);
}

json::object Definitions::history(const Dimension& dimension) {
  const json::object text{{"type", "string"}};
  const json::object number{{"type", json::array{"number", "string"}}, {"pattern", "^="}};  // or an expression
  const json::object column{{"type", json::array{"string", "integer"}}};
  const json::object values{{"type", "array"}, {"items", number}, {"minItems", 1}};
  return {{"anyOf",
           json::array{
               quantity(dimension),
               closed({"file"}, {{"file", text}, {"column", column}, {"row", column}, {"unit", text}, {"form", text}}),
               closed({"values"}, {{"values", values}, {"unit", text}})}}};
}

json::object Definitions::row(const std::string& group) {
  const json::object text{{"type", "string"}};
  if (!all_.contains(group))
    all_[group] = {
        {"anyOf",
         json::array{json::object{{"enum", names_of(group)}}, json::object{{"type", "string"}}, of_one_text("stock"),
                     of_one_text("each"), closed({"where"}, {{"stock", text}, {"where", text}}),
                     json::object{{"type", "array"}, {"items", json::object{{"type", "string"}}}}}}};
  return reference(group);
}

json::object tables_schema(Calculators calculators, Definitions& definitions) {
  json::object groups;
  for (const Calculator* calculator : calculators) {
    for (const std::string& group : table_groups(*calculator)) {
      if (groups.contains(group)) continue;
      definitions.add(group + "_row", row_schema(group, definitions));
      groups[group + "s"] = rows(Definitions::reference(group + "_row"));
      groups[group] = rows(Definitions::reference(group + "_row"));  // the other may move when this one comes
    }
  }
  groups["series"] = rows(series_schema());
  return {{"type", "object"},
          {"additionalProperties", false},
          {"description", "rows of the project's own, before those of `loadpath tables`"},
          {"properties", std::move(groups)}};
}

}  // namespace loadpath::exports
