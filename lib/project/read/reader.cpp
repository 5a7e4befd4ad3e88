#include "lib/project/read/reader.hpp"

#include "lib/calculator/choice_words.hpp"
#include "lib/project/read/meant/elsewhere.hpp"
#include "lib/quantity/literal.hpp"
#include "lib/text/meant.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loadpath::project {

using Type = FieldInfo::Type;

std::string joined(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}

std::vector<std::string> keys_of(const std::vector<Part>& parts) {
  std::vector<std::string> keys;
  for (const Part& part : parts) {
    for (const FieldInfo& field : part.fields) keys.emplace_back(field.key);
  }
  return keys;
}

/// The fields that a value with a unit can have been meant for: "500 mm" is not a strength. None for other values.
static std::vector<Known> known_of_dimension(const Tree& value, const std::vector<Part>& parts) {
  std::vector<Known> known;
  const auto typed = parse_literal(value.text);
  if (!typed || typed->dimension.is_number()) return known;
  for (const Part& part : parts) {
    for (const FieldInfo& field : part.fields) {
      if (field.type == FieldInfo::Type::quantity && field.dimension == typed->dimension)
        known.push_back({field.key, field.doc});
    }
  }
  return known;
}

/// The fields that a wrong key can have been meant for, with their meanings; or the place where it is valid.
static Message fields_near(const Tree::Entry& entry, const std::vector<Part>& parts) {
  const std::string& key = entry.key;
  std::vector<Known> known;
  Message otherwise;
  for (const Part& part : parts) {
    if (Message torque = torque_of_power(entry, part.fields); !torque.empty()) return torque;
    if (Message size = size_meant(entry, part.fields); !size.empty()) return size;
    if (Message element = element_called(key, part.fields, part.owner); !element.empty()) return element;
    if (otherwise.empty()) otherwise = input_within(key, part.fields);
    for (const FieldInfo& field : part.fields) known.push_back({field.key, field.doc});
  }
  if (Message near = meant(key, known_of_dimension(entry.value, parts), {}); !near.empty()) return near;
  return meant(key, known, otherwise.empty() ? there_is(known) : otherwise);
}

Message one_of(const std::string& word, const std::vector<std::string>& candidates) {
  return did_you_mean(word, candidates, there_is(candidates));
}

Message word_near(const std::string& word, const FieldInfo& choice) {
  std::vector<std::string> accepted = words_to_type(choice);
  for (std::string& alias : aliases_of_words(choice)) accepted.push_back(std::move(alias));
  return did_you_mean(word, accepted, there_is(words_to_choose(choice)));
}

static bool takes_several_whole(std::span<const FieldInfo> fields) {
  return std::count_if(fields.begin(), fields.end(), [](const FieldInfo& field) { return field.takes_whole(); }) > 1;
}

void Reader::read_fields(const Tree& table, const std::vector<Part>& parts, const std::string& path,
                         const std::vector<std::string>& reserved) {
  for (const Tree::Entry& entry : table.entries) {
    if (std::find(reserved.begin(), reserved.end(), entry.key) != reserved.end()) continue;
    const auto part = std::find_if(parts.begin(), parts.end(),
                                   [&](const Part& p) { return find_input(p.fields, entry.key) != nullptr; });
    const FieldInfo* const field = part == parts.end() ? nullptr : find_input(part->fields, entry.key);
    const std::string inner = joined(path, field == nullptr ? entry.key : std::string(field->key));
    if (field == nullptr) {
      say_at(entry.place, inner, say("'{1}' is not a valid key here", entry.key), fields_near(entry, parts),
             Severity::error, KeyFault::unknown);
      if (path.empty()) reading_.faulty.insert(nearest(entry.key, keys_of(parts)));
      continue;
    }
    if (entry.key != field->key && table.find(field->key) != nullptr) {
      say_at(entry.place, inner, say("'{1}' and '{2}' are the same input", entry.key, field->key),
             say("give one of them"));
      continue;
    }
    in_step_ = takes_several_whole(part->fields);
    reading_.typed[inner] = {entry.value.text, entry.value.place, false, entry.value.shared};
    read_value(entry.value, *field, part->owner, inner);
  }
  for (const Part& part : parts) require(part.fields, part.owner, path, table.place);
}

/// How to take a record: with a '=' before a path, "=shaft.bearings.left".
static Message as_reference(const Tree& tree, const std::string& path) {
  const bool is_path = tree.type == Tree::Type::text && tree.text.find('.') != std::string::npos;
  const auto parsed = is_path ? Expression::parse(tree.text) : Outcome<Expression>(Fault{});
  if (parsed && parsed->is_reference()) return say("write {1} = \"={2}\"", path, tree.text);
  return say("refer to a step of your file and its record: {1} = \"=STEP.RECORD\"", path);
}

void Reader::read_value(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  switch (field.type) {
    case Type::quantity:
      return read_quantity(tree, field, owner, path);
    case Type::count:
      return read_count(tree, field, owner, path);
    case Type::choice:
      return read_choice(tree, field, owner, path);
    case Type::name:
      return read_name(tree, field, owner, path);
    case Type::formula:
      return read_formula(tree, field, owner, path);
    case Type::group:
      return read_aggregate(tree, field, field.element(owner, 0), path);
    case Type::list:
      return read_list(tree, field, owner, path);
    case Type::record:
      if (takes(tree, field, path)) return;
      return say_at(tree.place, path, say("'{1}' takes the record of another step", path), as_reference(tree, path));
  }
}

bool Reader::takes(const Tree& tree, const FieldInfo& field, const std::string& path) {
  if (tree.type != Tree::Type::text || !tree.text.starts_with('=')) return false;
  Place start = tree.place;
  ++start.column;
  if (const auto source = lone_reference(tree)) {
    reading_.taken.push_back({path, &field, *source, start});
    return true;
  }
  const std::string text = tree.text.substr(1);
  if (const auto parsed = Expression::parse(text); !parsed) {
    fault_at(start, text, path, parsed.fault());
  } else if (field.is_word()) {
    say_at(place_in(start, text, 0, text.size()), path, say("'{1}' is not a number", path),
           say("refer to one that another step has: {1} = \"=step.{2}\"", path, field.key));
  } else {
    const bool list = field.type == Type::list;
    say_at(place_in(start, text, 0, text.size()), path,
           say("'{1}' takes {2} of another step", path, list ? say("a list") : say("a record")),
           say("name it and its step: {1} = \"=step.{2}\"", path, list ? field.key : "record"));
  }
  return true;
}

void Reader::read_aggregate(const Tree& tree, const FieldInfo& field, void* inner, const std::string& path) {
  if (tree.type == Tree::Type::table) return read_fields(tree, {{field.fields, inner}}, path, {});
  if (!field.positional && takes(tree, field, path)) return;
  if (!field.positional) {
    const Message hint = tree.type == Tree::Type::text ? value_within(tree.text, field, path)
                                                       : there_is(keys_of({{field.fields, inner}}));
    return say_at(tree.place, path, say("'{1}' is a table of fields, not {2}", path, toml::word_for(tree.type)), hint);
  }
  read_array(tree, field, inner, path);
}

/// The first fields in order, the name left out: ["40 mm", "0 mm"], or one value for the first.
void Reader::read_array(const Tree& tree, const FieldInfo& field, void* inner, const std::string& path) {
  std::vector<const FieldInfo*> leaves;
  for (const FieldInfo& f : field.fields) {
    const bool own_name = field.type == Type::list && std::string_view(f.key) == "name";
    if (f.is_leaf() && !own_name) leaves.push_back(&f);
  }
  const bool array = tree.type == Tree::Type::array;
  const std::size_t count = array ? tree.items.size() : 1;
  if (count > leaves.size()) {
    return say_at(tree.place, path,
                  say("at most {1} values here; there are {2}", std::to_string(leaves.size()), std::to_string(count)));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Tree& item = array ? tree.items[i] : tree;
    const std::string leaf = joined(path, leaves[i]->key);
    reading_.typed[leaf] = {item.text, item.place, false, item.shared};
    read_value(item, *leaves[i], inner, leaf);
  }
  require(field.fields, inner, path, tree.place);
}

/// Whether a record is taken that may fill this field.
static bool may_come(const Reading& reading, const std::string& path) {
  return std::any_of(reading.taken.begin(), reading.taken.end(), [&](const Taken& taken) {
    const bool is_record = taken.field != nullptr && taken.field->type == Type::record;
    return path.starts_with(is_record ? taken.path.substr(0, taken.path.rfind('.') + 1) : taken.path + ".");
  });
}

/// Whether a record is given in addition to the fields, valid or not.
static bool is_record_typed(const Reading& reading, std::span<const FieldInfo> fields, const std::string& path) {
  return std::any_of(fields.begin(), fields.end(), [&](const FieldInfo& f) {
    return f.type == Type::record && reading.typed.count(joined(path, f.key)) != 0;
  });
}

void Reader::require(std::span<const FieldInfo> fields, void* owner, const std::string& path, const Place& place) {
  for (const FieldInfo& field : fields) {
    const std::string inner = joined(path, field.key);
    if (field.optional || reading_.typed.count(inner) != 0) continue;
    if (field.type == Type::group) {
      require(field.fields, field.element(owner, 0), inner, place);
    } else if (is_missing(field, owner)) {
      const MissingInput missing{inner, &field, place};
      if (may_come(reading_, inner) || is_record_typed(reading_, fields, path)) {
        reading_.missing.push_back(missing);
        continue;
      }
      Issue issue = missing_field(missing, prefix_);
      say_at(issue.place, missing.path, std::move(issue.message), std::move(issue.hint), issue.severity,
             issue.key_fault);
    }
  }
}

}  // namespace loadpath::project
