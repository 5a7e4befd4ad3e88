#include "lib/calculator/choice_words.hpp"
#include "lib/export/json.hpp"
#include "lib/export/json_text.hpp"

#include <boost/json.hpp>

#include <string>
#include <vector>

namespace loadpath::exports {

namespace {

namespace json = boost::json;
using Type = FieldInfo::Type;

json::object object_of(std::span<const FieldInfo> fields, bool names_inside);

json::object described(const FieldInfo& field, json::object schema) {
  schema["description"] = field.type == Type::quantity && std::string_view(field.unit) != "-"
                              ? std::string(field.doc) + ", in " + field.unit + " or a unit like it"
                              : std::string(field.doc);
  return schema;
}

/// A quantity: a text with a unit or an expression, a bare number where it has no dimension, or a search or a spread.
json::object quantity(const FieldInfo& field) {
  json::array types{"string", "object"};
  if (field.dimension.is_number()) types.insert(types.begin(), "number");
  return {{"type", std::move(types)}};
}

json::object choice(const FieldInfo& field) {
  json::array words;
  for (std::string& word : words_to_type(field)) words.emplace_back(std::move(word));
  return {{"enum", std::move(words)}};
}

json::object list(const FieldInfo& field) {
  json::array forms{
      json::object{{"type", "array"},
                   {"maxItems", field.capacity},
                   {"items", json::object{{"type", json::array{"object", "array", "string", "number"}}}}}};
  if (!field.positional) forms[0].as_object()["items"] = object_of(field.fields, true);
  if (find_field(field.fields, "name") != nullptr) {
    forms.push_back(json::object{
        {"type", "object"},
        {"additionalProperties", field.positional ? json::value(true) : json::value(object_of(field.fields, false))}});
  } else if (field.positional) {
    forms.push_back(json::object{{"type", json::array{"string", "number"}}});
  }
  return {{"anyOf", std::move(forms)}};
}

json::object field_schema(const FieldInfo& field) {
  switch (field.type) {
    case Type::quantity:
      return quantity(field);
    case Type::count:
      return {{"type", "integer"}, {"minimum", field.bounds.low}, {"maximum", field.bounds.high}};
    case Type::choice:
      return choice(field);
    case Type::name:
      return {{"type", "string"}, {"pattern", "^[A-Za-z_][A-Za-z0-9_]*$"}, {"maxLength", Name::capacity}};
    case Type::formula:
      return {{"type", "string"}, {"maxLength", field.capacity}};
    case Type::list:
      return list(field);
    case Type::group:
      return field.positional ? json::object{{"type", json::array{"object", "array"}}} : object_of(field.fields, true);
  }
  return {};
}

json::object object_of(std::span<const FieldInfo> fields, bool names_inside) {
  json::object properties;
  for (const FieldInfo& field : fields) {
    if (names_inside || std::string_view(field.key) != "name")
      properties[field.key] = described(field, field_schema(field));
  }
  return {{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
}

/// What holds where a step names this template, or none: which keys there are, and what its parameters take.
json::object keys_with(const Template* t, const std::vector<std::string>& own) {
  json::object named{{"required", json::array{"template"}}};
  json::object then;
  json::array keys(own.begin(), own.end());
  if (t != nullptr) {
    json::object parameters = object_of(t->parameters->fields, true)["properties"].as_object();
    for (const auto& [key, schema] : parameters) keys.emplace_back(key);
    keys.emplace_back("template");
    named["properties"] = json::object{{"template", json::object{{"const", t->id}}}};
    then["properties"] = std::move(parameters);
  }
  then["propertyNames"] = json::object{{"enum", std::move(keys)}};
  json::object condition = t == nullptr ? json::object{{"not", std::move(named)}} : std::move(named);
  return {{"if", std::move(condition)}, {"then", std::move(then)}};
}

/// The key that names a template, and the parameters of each beside the fields of the step.
void add_templates(const Calculator& calculator, json::object& step) {
  json::object& properties = step["properties"].as_object();
  std::vector<std::string> own;
  for (const auto& property : properties) own.emplace_back(property.key());
  json::array words, conditions{keys_with(nullptr, own)};
  for (const Template* t : calculator.templates) {
    words.emplace_back(t->id);
    conditions.push_back(keys_with(t, own));
    for (const FieldInfo& f : t->parameters->fields) properties[f.key] = json::object{};
  }
  properties["template"] =
      json::object{{"enum", std::move(words)}, {"description", "an input known in shape, by its parameters"}};
  step["allOf"] = std::move(conditions);
}

json::object step_schema(const Calculator& calculator) {
  json::object step = object_of(calculator.input->fields, true);
  json::object& properties = step["properties"].as_object();
  properties["calculator"] = json::object{{"const", calculator.id}, {"description", calculator.scope}};
  for (const char* key : {"title", "note", "material"}) properties[key] = json::object{{"type", "string"}};
  for (const std::string& group : table_groups(calculator)) properties[group] = json::object{{"type", "string"}};
  properties["display"] = json::object{{"type", "object"}, {"additionalProperties", json::object{{"type", "string"}}}};
  json::object reasons;
  for (const ModeInfo& mode : calculator.modes)
    reasons[mode.id] = json::object{{"type", "string"}, {"minLength", 1}, {"description", mode.title}};
  properties["accept"] = json::object{{"type", "object"},
                                      {"additionalProperties", false},
                                      {"description", "modes of failure that you answer for, each with the reason"},
                                      {"properties", std::move(reasons)}};
  step["required"] = json::array{"calculator"};
  if (!calculator.templates.empty()) add_templates(calculator, step);
  return step;
}

json::object heading_schema() {
  json::object properties;
  for (const char* key : {"title", "number", "revision", "author", "checker", "date", "note"})
    properties[key] = json::object{{"type", "string"}};
  return {{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
}

json::object expectation_schema() {
  json::object properties;
  for (const char* key : {"value", "is", "within", "source", "note"})
    properties[key] = json::object{{"type", "string"}};
  properties["digits"] = json::object{{"type", "integer"}, {"minimum", 1}, {"maximum", 15}};
  return {{"type", "array"},
          {"items", json::object{{"type", "object"},
                                 {"additionalProperties", false},
                                 {"required", json::array{"value", "is", "source"}},
                                 {"properties", std::move(properties)}}}};
}

}  // namespace

std::string project_schema(Calculators calculators) {
  json::array kinds;
  for (const Calculator* calculator : calculators) kinds.push_back(step_schema(*calculator));
  return text_of(
      json::object{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                   {"title", "loadpath project"},
                   {"type", "object"},
                   {"properties", json::object{{"project", heading_schema()}, {"expect", expectation_schema()}}},
                   {"additionalProperties", json::object{{"oneOf", std::move(kinds)}}}});
}

}  // namespace loadpath::exports
