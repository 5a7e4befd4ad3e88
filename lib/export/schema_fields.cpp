#include "lib/export/schema_fields.hpp"

#include "lib/calculator/choice_words.hpp"

#include <algorithm>

namespace loadpath::exports {

namespace {

namespace json = boost::json;
using Type = FieldInfo::Type;

/// A text behind `=`: a value of another step.
json::object expression() { return {{"type", "string"}, {"pattern", "^="}}; }

json::object either(json::object one, json::object other) {
  return {{"anyOf", json::array{std::move(one), std::move(other)}}};
}

/// One of them, or a list that a sweep goes through.
json::object one_or_more(json::object one) {
  json::object list{{"type", "array"}, {"items", one}, {"minItems", 1}};
  return either(std::move(one), std::move(list));
}

json::object choice(const FieldInfo& field) {
  json::array words;
  for (std::string& word : words_to_type(field)) {
    if (word == "true" || word == "false") words.emplace_back(word == "true");
    words.emplace_back(std::move(word));
  }
  for (std::string& alias : aliases_of_words(field)) words.emplace_back(std::move(alias));
  return either(one_or_more({{"enum", std::move(words)}}), expression());
}

json::object count(const FieldInfo& field) {
  const json::object range{{"type", "object"}, {"required", json::array{"from", "to"}}};
  return either(
      either(one_or_more({{"type", "integer"}, {"minimum", field.bounds.low}, {"maximum", field.bounds.high}}), range),
      expression());
}

/// A table of named elements: the content of an element has no name.
json::object without_name(json::object element) {
  element["properties"].as_object().erase("name");
  return element;
}

/// { file = "rows.csv", columns = { t = "time", p = 3 } }.
json::object rows_in_file() {
  const json::object column{{"type", json::array{"string", "integer"}}};
  return {
      {"type", "object"},
      {"additionalProperties", false},
      {"required", json::array{"file"}},
      {"properties", json::object{{"file", json::object{{"type", "string"}}},
                                  {"columns", json::object{{"type", "object"}, {"additionalProperties", column}}}}}};
}

json::object list(const FieldInfo& field, void* blank, Definitions& definitions) {
  json::object element = object_of(field.fields, blank == nullptr ? nullptr : field.push(blank), definitions);
  json::object array{{"type", "array"}, {"items", element}};
  if (field.capacity != no_bound) array["maxItems"] = field.capacity;
  if (field.positional) array["items"] = {{"type", json::array{"object", "array", "string", "number"}}};
  json::array forms{std::move(array)};
  if (find_field(field.fields, "name") != nullptr) {
    forms.push_back(
        json::object{{"type", "object"},
                     {"additionalProperties",
                      field.positional ? json::value(true) : json::value(without_name(std::move(element)))}});
  } else if (field.positional) {
    forms.push_back(json::object{{"type", json::array{"string", "number"}}});
  }
  if (find_field(field.fields, "name") == nullptr) forms.push_back(rows_in_file());
  forms.push_back(expression());
  return {{"anyOf", std::move(forms)}};
}

json::object group(const FieldInfo& field, void* blank, Definitions& definitions) {
  if (field.positional) return {{"type", json::array{"object", "array", "string"}}};
  return either(object_of(field.fields, blank == nullptr ? nullptr : field.element(blank, 0), definitions),
                expression());
}

json::object schema_of(const FieldInfo& field, void* blank, Definitions& definitions) {
  switch (field.type) {
    case Type::quantity:
      return field.takes_whole() ? definitions.history(field.dimension) : definitions.quantity(field.dimension);
    case Type::count:
      return count(field);
    case Type::choice:
      return choice(field);
    case Type::name:
      return either(
          {{"type", "string"},
           {"pattern", *field.searched_in == '\0' ? "^[A-Za-z_][A-Za-z0-9_]*$" : "^([A-Za-z_][A-Za-z0-9_]*|[?])$"},
           {"maxLength", Name::capacity}},
          expression());
    case Type::formula:
      return {{"type", "string"}, {"maxLength", field.capacity}};
    case Type::list:
      return list(field, blank, definitions);
    case Type::group:
      return group(field, blank, definitions);
    case Type::record:
      return expression();
  }
  return {};
}

/// The object found by "?" for a field; empty if it finds nothing.
std::string searched_text(const FieldInfo& field) {
  if (*field.searched_in != '\0') return std::string("; \"?\" searches in ") + field.searched_in;
  return field.can_be_largest() ? "; \"?\" finds the largest that passes" : "";
}

json::string description(const FieldInfo& field) {
  std::string text = field.doc;
  const bool in_unit = field.type == Type::quantity && std::string_view(field.unit) != "-";
  if (in_unit) text += std::string(", in ") + field.unit + " or a unit like it";
  text += searched_text(field);
  return json::string(text);
}

bool is_needed(const FieldInfo& field, void* blank) {
  if (field.optional || *field.also_called != '\0') return false;  // another word may replace it
  if (field.type != Type::group) return is_missing(field, blank);
  return std::any_of(field.fields.begin(), field.fields.end(),
                     [&](const FieldInfo& inner) { return is_needed(inner, field.element(blank, 0)); });
}

/// The required keys; the record of another step may give them instead.
json::object wanting(json::array required, std::span<const FieldInfo> fields) {
  const auto record =
      std::find_if(fields.begin(), fields.end(), [](const FieldInfo& f) { return f.type == Type::record; });
  json::object all{{"required", std::move(required)}};
  return record == fields.end() ? all : either(std::move(all), {{"required", json::array{record->key}}});
}

}  // namespace

json::object object_of(std::span<const FieldInfo> fields, void* blank, Definitions& definitions) {
  json::object properties;
  json::array required;
  for (const FieldInfo& field : fields) {
    if (blank != nullptr && is_needed(field, blank) && std::string_view(field.key) != "name")
      required.emplace_back(field.key);
    json::object schema = schema_of(field, blank, definitions);
    schema["description"] = description(field);
    for (const std::string& other : listed_keys(field.also_called)) properties[other] = schema;
    properties[field.key] = std::move(schema);
  }
  json::object all{{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
  if (required.empty()) return all;
  for (auto& [key, rule] : wanting(std::move(required), fields)) all[key] = rule;
  return all;
}

}  // namespace loadpath::exports
