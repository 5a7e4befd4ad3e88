#include "cli/lsp/completion.hpp"

#include "calculators/catalogue.hpp"
#include "cli/fields/words.hpp"
#include "cli/lsp/references.hpp"
#include "cli/lsp/target.hpp"
#include "cli/lsp/words.hpp"
#include "lib/calculator/choice_words.hpp"
#include "lib/project/parts/heading.hpp"
#include "lib/table/library.hpp"
#include "lib/table/tables.hpp"

#include <algorithm>

namespace loadpath::cli::lsp {

namespace {

using Type = FieldInfo::Type;
using Items = std::vector<Completion>;

void add_words(const std::vector<std::string>& words, Kind kind, Items& items) {
  for (const std::string& word : words) items.push_back({.label = word, .kind = kind});
}

/// Puts words in quotes unless the cursor is inside quotes.
void put_in_quotes(Items& items) {
  for (Completion& item : items) {
    item.text = "\"" + (item.text.empty() ? item.label : item.text) + "\"";
    if (!item.snippet.empty()) item.snippet = "\"" + item.snippet + "\"";
  }
}

std::string snippet_of(const FieldInfo& field) {
  const std::string key = std::string(field.key) + " = ";
  std::string words;
  switch (field.type) {
    case Type::quantity:
      return std::string_view(field.unit) == "-" ? key + "$1" : key + "\"$1 " + field.unit + "\"";
    case Type::count:
      return key + "$1";
    case Type::choice:
      for (const std::string& word : words_to_type(field)) words += (words.empty() ? "" : ",") + word;
      return key + "\"${1|" + words + "|}\"";
    case Type::name:
    case Type::formula:
      return key + "\"$1\"";
    case Type::group:
      return key + "{ $1 }";
    case Type::list:
      return key + "[\n  { $1 },\n]";
    case Type::record:
      return key + "\"=$1\"";
  }
  return key;
}

Completion of_field(const FieldInfo& field, void* owner) {
  const std::string given = field.has_fields() || field.type == Type::record ? "" : default_of(field, owner);
  return {.label = field.key,
          .kind = Kind::field,
          .detail = type_of(field) + (given.empty() ? "" : "; " + given),
          .meaning = field.doc,
          .text = std::string(field.key) + " = ",
          .snippet = snippet_of(field),
          .rank = given == "required" ? 0 : 1};
}

void add_fields(std::span<const FieldInfo> fields, void* owner, Items& items) {
  for (const FieldInfo& field : fields) items.push_back(of_field(field, owner));
}

void add_step_keys(const Target& target, Items& items) {
  for (const StepKey& known : general_keys(*target.calculator)) {
    const bool is_table = known.key == "display" || known.key == "accept" || known.key == "because";
    items.push_back({.label = known.key,
                     .kind = Kind::field,
                     .meaning = known.meaning,
                     .text = known.key + " = ",
                     .snippet = known.key + (is_table ? " = { $1 }" : " = \"$1\""),
                     .rank = 2});
  }
  if (target.from != nullptr) add_fields(target.from->parameters->fields, target.parameters.data.get(), items);
  add_fields(target.calculator->input->fields, target.input.data.get(), items);
}

Completion plain_key(const std::string& key) {
  return {.label = key, .kind = Kind::field, .text = key + " = ", .snippet = key + " = \"$1\""};
}

/// Adds the keys of tables other than steps.
bool add_known_keys(const Path& table, Items& items) {
  if (table == Path{"project"}) {
    for (const project::HeadingKey& known : project::heading_keys()) {
      items.push_back(plain_key(known.key));
      items.back().meaning = known.meaning;
    }
    return true;
  }
  const bool in_expect = table.size() == 2 && table[0] == "expect";
  if (in_expect) {
    for (const char* key : {"value", "is", "digits", "within", "source", "note"}) items.push_back(plain_key(key));
  }
  return !table.empty() && (table[0] == "values" || table[0] == "tables" || in_expect);
}

Items keys_for(const OpenFile& file, const Path& table) {
  Items items;
  if (table.empty() || add_known_keys(table, items)) return items;
  const Target target = target_of(file.outline, file.document.text(), table);
  if (target.calculator == nullptr) {
    if (table.size() == 1) items.push_back(plain_key("calculator"));
  } else if (table.size() == 1) {
    add_step_keys(target, items);
  } else if (target.in_accept && table.size() == 2) {
    for (const ModeInfo& mode : target.calculator->modes) {
      items.push_back(plain_key(mode.id));
      items.back().meaning = mode.title;
    }
  } else if (target.in_because && table.size() == 2) {
    for (const FieldInfo& field : target.calculator->input->fields) {
      items.push_back(plain_key(field.key));
      items.back().meaning = field.doc;
    }
  } else if (target.inner != nullptr) {
    add_fields(target.field->fields, target.inner, items);
  }
  return items;
}

/// Omits the keys that the table has; the one under the cursor stays.
void leave_out_given(const OpenFile& file, const Path& table, std::string_view typed, Items& items) {
  const std::vector<std::string> given = keys_in(file.outline, table);
  std::erase_if(items, [&](const Completion& item) {
    return item.label != typed && std::find(given.begin(), given.end(), item.label) != given.end();
  });
}

void add_rows(const OpenFile& file, const std::string& group, Items& items) {
  for (const std::string& row : own_rows(file, group))
    items.push_back({.label = row, .detail = "own table of the project", .rank = 0});
  for (const table::Table* table : table::tables_of(group)) {
    for (const table::Row& row : table->rows) items.push_back({.label = row.name, .detail = table->title});
  }
}

/// The words that a text may be.
Items words_for(const OpenFile& file, const Path& path, const Target& target) {
  Items items;
  if (path.size() == 2 && path[1] == "calculator") {
    for (const Calculator* c : calculators())
      items.push_back({.label = c->id, .kind = Kind::module, .detail = c->title, .meaning = c->scope});
  } else if (path.back() == "stock") {
    add_words(tables_of(file).series_names(), Kind::enumeration, items);
  } else if (target.calculator != nullptr && path.size() == 2 && path[1] == "template") {
    for (const Template* t : target.calculator->templates)
      items.push_back({.label = t->id, .kind = Kind::module, .detail = t->title, .meaning = t->doc});
  } else if (!target.group.empty()) {
    add_rows(file, target.group, items);
  } else if (target.field != nullptr && target.field->type == Type::choice) {
    for (const ChoiceInfo& c : target.field->choices) {
      if (*c.key != '\0') items.push_back({.label = c.key, .kind = Kind::enumeration, .meaning = c.doc});
    }
  }
  return items;
}

/// The position of the unit after a number; npos if there is no number.
std::size_t unit_start(std::string_view text) {
  const std::size_t last = text.find_last_of("0123456789");
  if (text.empty() || last == std::string_view::npos) return std::string_view::npos;
  if (text.find_first_not_of("0123456789.,+-eE '/") < last) return std::string_view::npos;
  return std::min(text.find_first_not_of(' ', last + 1), text.size());
}

Items units_of(const FieldInfo& field, bool after_space) {
  Items items;
  int rank = 0;
  for (const std::string& unit : units_for({field.dimension, field.kind, field.unit}))
    items.push_back(
        {.label = unit, .kind = Kind::unit, .text = (after_space ? "" : " ") + unit, .rank = std::min(rank++, 9)});
  return items;
}

Completions in_text(const OpenFile& file, const Spot& spot, std::size_t offset) {
  const std::string_view typed = std::string_view(file.document.text()).substr(spot.begin, offset - spot.begin);
  const Target target = target_of(file.outline, file.document.text(), spot.path);
  const bool is_expected = spot.path[0] == "expect" && spot.path.back() == "value";
  if (typed.starts_with('=') || is_expected) return references_at(file, spot, offset, target.field);
  const bool is_quantity = target.field != nullptr && target.field->type == Type::quantity;
  if (const std::size_t start = unit_start(typed); is_quantity && start != std::string_view::npos)
    return {file.document.range_of(spot.begin + start, offset), units_of(*target.field, typed[start - 1] == ' ')};
  return {file.document.range_of(spot.begin, offset), words_for(file, spot.path, target)};
}

/// After `=`, before any quote.
Completions in_value(const OpenFile& file, const Spot& spot, std::size_t offset) {
  const Target target = target_of(file.outline, file.document.text(), spot.path);
  Completions all{file.document.range_of(spot.begin, offset), words_for(file, spot.path, target)};
  put_in_quotes(all.items);
  return all;
}

Completions in_key(const OpenFile& file, const Spot& spot, std::size_t offset) {
  const std::string typed = file.document.text().substr(spot.begin, offset - spot.begin);
  Completions all{file.document.range_of(spot.begin, offset), keys_for(file, spot.path)};
  leave_out_given(file, spot.path, typed, all.items);
  return all;
}

}  // namespace

Completions completions_at(const OpenFile& file, std::size_t offset) {
  const Spot spot = spot_at(file.document.text(), offset);
  const std::size_t begin = std::min(spot.begin, offset);
  const Spot within{spot.in, spot.path, begin};
  if (spot.in == Spot::In::key) return in_key(file, within, offset);
  if (spot.in == Spot::In::text && !spot.path.empty()) return in_text(file, within, offset);
  if (spot.in == Spot::In::value && !spot.path.empty()) return in_value(file, within, offset);
  return {};
}

}  // namespace loadpath::cli::lsp
