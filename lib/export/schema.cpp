#include "lib/export/json.hpp"
#include "lib/export/json_text.hpp"
#include "lib/export/schema_fields.hpp"
#include "lib/project/parts/heading.hpp"

#include <boost/json.hpp>

#include <string>
#include <vector>

namespace loadpath::exports {

namespace {

namespace json = boost::json;

json::object text() { return {{"type", "string"}}; }

/// The schema of a step that names this template, or none: its keys, and the values of its parameters.
json::object keys_with(const Template* t, const std::vector<std::string>& own, Definitions& definitions) {
  json::object named{{"required", json::array{"template"}}};
  json::object then;
  json::array keys(own.begin(), own.end());
  if (t != nullptr) {
    Record blank(*t->parameters);
    json::object parameters = object_of(t->parameters->fields, blank.data.get(), definitions);
    for (const auto& [key, schema] : parameters["properties"].as_object()) keys.emplace_back(key);
    keys.emplace_back("template");
    named["properties"] = json::object{{"template", json::object{{"const", t->id}}}};
    then["properties"] = parameters["properties"];
    if (parameters.contains("required")) then["required"] = parameters["required"];
  }
  then["propertyNames"] = json::object{{"enum", std::move(keys)}};
  json::object condition = t == nullptr ? json::object{{"not", std::move(named)}} : std::move(named);
  return {{"if", std::move(condition)}, {"then", std::move(then)}};
}

/// Adds the key that names a template, and the parameters of each, to the fields of the step.
void add_templates(const Calculator& calculator, json::object& step, Definitions& definitions) {
  json::object& properties = step["properties"].as_object();
  std::vector<std::string> own;
  for (const auto& property : properties) own.emplace_back(property.key());
  json::array words, conditions{keys_with(nullptr, own, definitions)};
  for (const Template* t : calculator.templates) {
    words.emplace_back(t->id);
    conditions.push_back(keys_with(t, own, definitions));
    for (const FieldInfo& f : t->parameters->fields) properties[f.key] = json::object{};
  }
  properties["template"] =
      json::object{{"enum", std::move(words)}, {"description", "a standard mechanism, by its parameters"}};
  step["allOf"] = std::move(conditions);
}

json::object display_schema(const Calculator& calculator) {
  json::object units;
  for (const FieldInfo& field : calculator.result->fields) {
    if (field.type == FieldInfo::Type::quantity) units[field.key] = text();
  }
  return {{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(units)}};
}

json::object accept_schema(const Calculator& calculator) {
  json::object reasons;
  for (const ModeInfo& mode : calculator.modes)
    reasons[mode.id] = json::object{{"type", "string"}, {"minLength", 1}, {"description", mode.title}};
  return {{"type", "object"},
          {"additionalProperties", false},
          {"description", "modes of failure that you answer for, each with the reason"},
          {"properties", std::move(reasons)}};
}

json::object because_schema(const Calculator& calculator) {
  json::object reasons;
  for (const FieldInfo& field : calculator.input->fields)
    reasons[field.key] = json::object{{"type", "string"}, {"minLength", 1}, {"description", field.doc}};
  return {{"type", "object"},
          {"description", "inputs that are more favourable than their row or record, each with the reason"},
          {"properties", std::move(reasons)},
          {"additionalProperties", text()}};
}

/// A step of one calculator. A template replaces inputs that must be given otherwise.
json::object step_schema(const Calculator& calculator, Definitions& definitions) {
  Record blank(*calculator.input);
  void* const needed = calculator.templates.empty() ? blank.data.get() : nullptr;
  json::object step = object_of(calculator.input->fields, needed, definitions);
  json::object& properties = step["properties"].as_object();
  properties["calculator"] = json::object{{"const", calculator.id}, {"description", calculator.scope}};
  for (const char* key : {"title", "note"}) properties[key] = text();
  properties["body"] = json::object{
      {"type", "string"}, {"minLength", 1}, {"description", "the physical part that several steps describe: one size"}};
  for (const std::string& group : table_groups(calculator)) properties[group] = definitions.row(group);
  if (calculator.result != nullptr) properties["display"] = display_schema(calculator);
  properties["accept"] = accept_schema(calculator);
  properties["because"] = because_schema(calculator);
  if (!calculator.templates.empty()) add_templates(calculator, step, definitions);
  return step;
}

/// A step is validated against the calculator that it names.
json::object any_step(Calculators calculators, Definitions& definitions) {
  json::array ids, conditions;
  for (const Calculator* calculator : calculators) {
    definitions.add(calculator->id, step_schema(*calculator, definitions));
    ids.emplace_back(calculator->id);
    conditions.push_back(json::object{
        {"if", json::object{{"required", json::array{"calculator"}},
                            {"properties", json::object{{"calculator", json::object{{"const", calculator->id}}}}}}},
        {"then", Definitions::reference(calculator->id)}});
  }
  return {{"type", "object"},
          {"required", json::array{"calculator"}},
          {"properties", json::object{{"calculator", json::object{{"enum", std::move(ids)}}}}},
          {"allOf", std::move(conditions)}};
}

json::object heading_schema() {
  json::object properties;
  for (const project::HeadingKey& known : project::heading_keys()) properties[known.key] = text();
  properties["paper"] = {{"enum", json::array{"A4", "letter"}}};
  properties["report"] = {{"type", "string"}, {"pattern", "\\.(html|md|tex|pdf)$"}};
  properties["tables"] = {{"type", "array"}, {"items", text()}};
  properties["sweep"] = {{"type", "object"}};
  for (const project::HeadingKey& known : project::heading_keys())
    properties[known.key].as_object()["description"] = known.meaning;
  return {{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
}

json::object expectation_schema() {
  json::object properties;
  for (const char* key : {"value", "is", "within", "source", "note"}) properties[key] = text();
  properties["digits"] = json::object{{"type", "integer"}, {"minimum", 1}, {"maximum", 15}};
  return {{"type", "array"},
          {"items", json::object{{"type", "object"},
                                 {"additionalProperties", false},
                                 {"required", json::array{"value", "is", "source"}},
                                 {"properties", std::move(properties)}}}};
}

}  // namespace

std::string project_schema(Calculators calculators) {
  Definitions definitions;
  json::object tables = tables_schema(calculators, definitions);
  json::object step = any_step(calculators, definitions);
  return text_of(json::object{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                              {"title", "loadpath project"},
                              {"type", "object"},
                              {"properties", json::object{{"project", heading_schema()},
                                                          {"expect", expectation_schema()},
                                                          {"tables", std::move(tables)},
                                                          {"values", json::object{{"type", "object"}}}}},
                              {"additionalProperties", std::move(step)},
                              {"$defs", definitions.take()}});
}

}  // namespace loadpath::exports
