#include "cli/fields/words.hpp"

#include "lib/calculator/choice_words.hpp"
#include "lib/project/read/reading.hpp"
#include "lib/quantity/format.hpp"

#include <cmath>

namespace loadpath::cli {

using Type = FieldInfo::Type;

std::string bounds_of(const FieldInfo& field) {
  const bool open = std::isinf(field.bounds.low) && std::isinf(field.bounds.high);
  return open || field.type == Type::choice ? "" : project::bounds_message(field).text();
}

std::string words_of(const FieldInfo& field) {
  std::string all;
  for (const ChoiceInfo& choice : field.choices) {
    if (!states_nothing(choice)) all += (all.empty() ? "" : " | ") + std::string(choice.key);
  }
  return all;
}

std::string default_of(const FieldInfo& field, void* owner) {
  if (field.sought_unasked) return std::string("searched in ") + field.searched_in;
  if (field.provider.kind == Provider::Kind::table) return std::string("from ") + field.provider.table;
  if (field.provider.kind == Provider::Kind::companion) return std::string("linked with ") + field.provider.column;
  if (field.type == Type::choice) {
    const bool given = !std::isnan(field.get(owner));
    const std::string word = word_of(Leaf{&field, owner});
    return !given ? "required" : word.empty() ? "optional" : word;
  }
  const bool number = field.type == Type::quantity || field.type == Type::count;
  if (number && !is_missing(field, owner))
    return "default " + format_quantity(field.get(owner), field.type == Type::count ? "-" : field.unit);
  return field.optional ? "optional" : "required";
}

std::string searched_of(const FieldInfo& field) {
  const bool is_input = field.role == Role::input && *field.searched_in == '\0';
  return is_input && field.can_be_largest() ? "; \"?\" finds the largest" : "";
}

std::string list_of(const FieldInfo& field) {
  return field.capacity == no_bound ? "list" : "list, at most " + std::to_string(field.capacity);
}

std::string type_of(const FieldInfo& field) {
  switch (field.type) {
    case Type::quantity:
      return field.unit;
    case Type::count:
      return "integer";
    case Type::choice:
      return words_of(field);
    case Type::name:
      return "name";
    case Type::formula:
      return "formula";
    case Type::group:
      return "table";
    case Type::list:
      return list_of(field);
    case Type::record:
      return "record";
  }
  return "";
}

}  // namespace loadpath::cli
