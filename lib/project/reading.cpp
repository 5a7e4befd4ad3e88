#include "lib/project/reading.hpp"

#include "lib/quantity/format.hpp"
#include "lib/quantity/literal.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::project {

namespace {

using io::Tree;
using Type = FieldInfo::Type;

std::size_t code_points(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// Fields, and the aggregate that holds them.
struct Part {
  std::span<const FieldInfo> fields;
  void* owner = nullptr;
};

class Reader {
 public:
  Reader(Reading& reading, std::vector<Issue>& issues, std::string prefix)
      : reading_(reading), issues_(issues), prefix_(std::move(prefix)) {}

  /// Each key goes to the part that has a field of that name.
  void read_fields(const Tree& table, const std::vector<Part>& parts, const std::string& path,
                   const std::vector<std::string>& reserved);

 private:
  void read_value(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_quantity(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_text_quantity(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_special(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_spread(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_literal(const std::string& text, const Tree& tree, const FieldInfo& field, void* owner,
                    const std::string& path);
  void read_count(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_choice(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_name(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  void read_list(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path);
  /// A list, and how many of its elements a template has laid out.
  struct Target {
    const FieldInfo& list;
    void* owner;
    std::size_t given;
    [[nodiscard]] std::vector<std::string> given_names() const;
    [[nodiscard]] void* find_given(const std::string& name) const;
  };
  void read_element(const Tree& tree, const Target& target, const std::string& path, const Tree::Entry* named);
  void read_aggregate(const Tree& tree, const FieldInfo& field, void* inner, const std::string& path);
  void read_array(const Tree& tree, const FieldInfo& field, void* inner, const std::string& path);
  void require(std::span<const FieldInfo> fields, void* owner, const std::string& path, const Place& place);
  void check_names(const FieldInfo& list, void* owner, const std::string& path, const Place& place);

  void say_at(const Place& place, const std::string& path, Message message, Message hint = {},
              Severity severity = Severity::error) {
    issues_.push_back({place, prefix_ + path, std::move(message), std::move(hint), severity});
    if (severity == Severity::error) reading_.faulty.insert(path.substr(0, path.find_first_of(".[")));
  }
  void fault_at(const Place& start, std::string_view text, const std::string& path, const Fault& fault) {
    say_at(place_in(start, text, fault.at, fault.length), path, fault.message, fault.hint);
  }

  Reading& reading_;
  std::vector<Issue>& issues_;
  std::string prefix_;
};

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

/// The nearest candidate, or all of them.
Message one_of(const std::string& word, const std::vector<std::string>& candidates) {
  return did_you_mean(word, candidates, there_is(candidates));
}

void Reader::read_fields(const Tree& table, const std::vector<Part>& parts, const std::string& path,
                         const std::vector<std::string>& reserved) {
  for (const Tree::Entry& entry : table.entries) {
    if (std::find(reserved.begin(), reserved.end(), entry.key) != reserved.end()) continue;
    const std::string inner = joined(path, entry.key);
    const auto part = std::find_if(parts.begin(), parts.end(),
                                   [&](const Part& p) { return find_field(p.fields, entry.key) != nullptr; });
    if (part == parts.end()) {
      say_at(entry.place, inner, say("'{1}' is no field here", entry.key), one_of(entry.key, keys_of(parts)));
      if (path.empty()) reading_.faulty.insert(nearest(entry.key, keys_of(parts)));
      continue;
    }
    reading_.typed[inner] = {entry.value.text, entry.value.place};
    read_value(entry.value, *find_field(part->fields, entry.key), part->owner, inner);
  }
  for (const Part& part : parts) require(part.fields, part.owner, path, table.place);
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
    case Type::group:
      return read_aggregate(tree, field, field.element(owner, 0), path);
    case Type::list:
      return read_list(tree, field, owner, path);
  }
}

void Reader::read_quantity(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  switch (tree.type) {
    case Tree::Type::text:
      return read_text_quantity(tree, field, owner, path);
    case Tree::Type::number:
      return read_literal(format_exact(tree.number), tree, field, owner, path);
    case Tree::Type::table:
      return read_special(tree, field, owner, path);
    case Tree::Type::array:
      return say_at(tree.place, path, say("a list of values makes this a range, and `run` takes one value"),
                    say("use `loadpath sweep` for ranges"));
    case Tree::Type::boolean:
      return say_at(tree.place, path, say("a quantity is expected, not {1}", tree.text),
                    say("write a text with a unit, \"30 {1}\"", field.unit));
  }
}

void Reader::read_text_quantity(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  if (tree.text == "?") {
    if (*field.searched_in == '\0') {
      return say_at(tree.place, path, say("'{1}' cannot be searched for", path), say("give a value"));
    }
    reading_.searches.push_back({path, {&field, owner}, field.searched_in, tree.place});
    return;
  }
  if (!tree.text.starts_with('=')) return read_literal(tree.text, tree, field, owner, path);
  Place start = tree.place;
  ++start.column;
  std::string text = tree.text.substr(1);
  auto parsed = Expression::parse(text);
  if (!parsed) return fault_at(start, text, path, parsed.fault());
  reading_.operands.push_back({path, {&field, owner}, std::move(*parsed), std::move(text), start});
}

/// { stock = "R40" }, { mean = ..., sd = ... }, { value = ..., tolerance = ... }; a range is for sweeps.
void Reader::read_special(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  if (const auto* stock = tree.find("stock")) {
    if (*field.searched_in == '\0')
      return say_at(stock->place, path, say("'{1}' cannot be searched for", path), say("give a value"));
    reading_.searches.push_back({path, {&field, owner}, stock->value.text, stock->value.place});
    return;
  }
  if (tree.find("from") != nullptr) {
    return say_at(tree.place, path, say("this is a range, and `run` takes one value"),
                  say("use `loadpath sweep` for ranges"));
  }
  if (tree.find("mean") != nullptr || tree.find("value") != nullptr) return read_spread(tree, field, owner, path);
  say_at(tree.place, path, say("a quantity is expected, not {1}", io::word_for(tree.type)),
         say("write a text with a unit, \"30 {1}\"", field.unit));
}

void Reader::read_spread(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  static const std::vector<std::string> keys{"mean", "sd", "value", "tolerance"};
  for (const Tree::Entry& entry : tree.entries) {
    if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
    say_at(entry.place, path, say("'{1}' is no field here", entry.key), one_of(entry.key, keys));
  }
  const auto* middle = tree.find("mean") != nullptr ? tree.find("mean") : tree.find("value");
  read_quantity(middle->value, field, owner, path);
  reading_.typed[path].mean_of_uncertain = true;
  say_at(tree.place, path, say("'{1}' is uncertain; computed at its middle value", path), {}, Severity::warning);
}

/// Whether a text that is no quantity refers to other steps, as expressions do.
bool is_bare_expression(const std::string& text) {
  if (parse_unit(text)) return false;  // a number was forgotten
  const auto parsed = Expression::parse(text);
  return parsed && !parsed->references().empty();
}

void Reader::read_literal(const std::string& text, const Tree& tree, const FieldInfo& field, void* owner,
                          const std::string& path) {
  const auto literal = parse_literal(text, Expected{field.dimension, field.kind, field.unit});
  if (!literal && is_bare_expression(text)) {
    return say_at(place_in(tree.place, text, 0, text.size()), path, say("'{1}' is an expression without its '='", text),
                  say("an expression starts with '=': write \"={1}\"", text));
  }
  if (!literal) return fault_at(tree.place, text, path, literal.fault());
  const double si = literal->si;
  if (!field.bounds.holds(si)) {
    return say_at(tree.place, path,
                  say("{1} = {2}: {3}", path, format_quantity(si, field.unit), bounds_message(field).text()));
  }
  if (!field.plausible.holds(si)) {
    say_at(tree.place, path,
           say("{1} = {2} is unusual: {3} to {4} is expected", path, format_quantity(si, field.unit),
               format_quantity(field.plausible.low, field.unit), format_quantity(field.plausible.high, field.unit)),
           say("check the unit"), Severity::warning);
  }
  reading_.typed[path].text = text;
  field.set(owner, si);
}

void Reader::read_count(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  const double n = tree.number;
  if (tree.type != Tree::Type::number || n != std::floor(n)) {
    const bool number = tree.type == Tree::Type::number;
    return say_at(
        tree.place, path,
        say("a whole number is expected, not {1}", number ? format_number(n) : std::string(io::word_for(tree.type))));
  }
  if (!field.bounds.holds(n)) {
    return say_at(tree.place, path, say("{1} = {2}: {3}", path, format_number(n), bounds_message(field).text()));
  }
  reading_.typed[path].text = format_number(n);
  field.set(owner, n);
}

void Reader::read_choice(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  std::vector<std::string> words;
  for (const ChoiceInfo& c : field.choices) words.emplace_back(c.key);
  const auto found = std::find(words.begin(), words.end(), tree.text);
  if (tree.type != Tree::Type::text || found == words.end()) {
    const std::string written =
        tree.type == Tree::Type::text ? "'" + tree.text + "'" : std::string(io::word_for(tree.type));
    return say_at(tree.place, path, say("{1} is none of the words for '{2}'", written, path), one_of(tree.text, words));
  }
  field.set(owner, static_cast<double>(found - words.begin()));
}

void Reader::read_name(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  if (tree.type != Tree::Type::text)
    return say_at(tree.place, path, say("a name is expected, not {1}", io::word_for(tree.type)));
  if (!is_name(tree.text)) {
    return say_at(tree.place, path, say("'{1}' is no name", tree.text),
                  say("a name has Latin letters, digits and '_', and does not start with a digit"));
  }
  if (tree.text.size() > Name::capacity)
    return say_at(tree.place, path, say("the name '{1}' is longer than 31 letters", tree.text));
  field.set_text(owner, tree.text);
}

void Reader::read_list(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  const bool named = tree.type == Tree::Type::table && find_field(field.fields, "name") != nullptr &&
                     find_field(field.fields, "name")->type == Type::name;
  const Target target{field, owner, field.size(owner)};
  std::size_t count = target.given + (tree.type == Tree::Type::array ? tree.items.size() : 1);
  if (named) {
    const auto is_new = [&](const Tree::Entry& entry) { return target.find_given(entry.key) == nullptr; };
    count = target.given + static_cast<std::size_t>(std::count_if(tree.entries.begin(), tree.entries.end(), is_new));
  }
  if (count > field.capacity) {
    return say_at(
        tree.place, path,
        say("at most {1} {2}; here are {3}", std::to_string(field.capacity), field.key, std::to_string(count)));
  }
  if (named) {
    for (const Tree::Entry& entry : tree.entries) read_element(entry.value, target, path, &entry);
  } else if (tree.type == Tree::Type::array) {
    for (const Tree& item : tree.items) read_element(item, target, path, nullptr);
  } else {
    read_element(tree, target, path, nullptr);
  }
  check_names(field, owner, path, tree.place);
}

std::vector<std::string> Reader::Target::given_names() const {
  std::vector<std::string> names;
  const FieldInfo* name = find_field(list.fields, "name");
  for (std::size_t i = 0; name != nullptr && i < given; ++i) names.emplace_back(name->text(list.element(owner, i)));
  return names;
}

void* Reader::Target::find_given(const std::string& name) const {
  const auto names = given_names();
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? nullptr : list.element(owner, static_cast<std::size_t>(found - names.begin()));
}

void Reader::read_element(const Tree& tree, const Target& target, const std::string& path, const Tree::Entry* named) {
  const auto& [list, owner, given] = target;
  const auto* own_name = find_field(list.fields, "name") == nullptr ? nullptr : tree.find("name");
  const std::string written = named != nullptr ? named->key : own_name != nullptr ? own_name->value.text : "";
  void* const known = target.find_given(written);
  void* const element = known != nullptr ? known : list.push(owner);
  std::string inner = path + "[" + std::to_string(list.size(owner)) + "]";
  if (is_name(written) || named != nullptr) inner = path + "." + written;
  if (named != nullptr) {
    if (const auto* again = tree.find("name")) {
      say_at(again->place, inner, say("the name already stands before the table: '{1}'", named->key),
             say("leave out 'name'"));
    }
    Tree name;
    name.type = Tree::Type::text;
    name.text = named->key;
    name.place = named->place;
    reading_.typed[inner + ".name"] = {name.text, name.place};
    read_name(name, *find_field(list.fields, "name"), element, inner);
  }
  if (known != nullptr && reading_.typed.count(inner) != 0)
    say_at(tree.place, path, say("the name '{1}' stands twice in '{2}'", written, path));
  reading_.typed[inner] = {tree.text, tree.place};
  const std::size_t before = issues_.size();
  read_aggregate(tree, list, element, inner);
  for (std::size_t i = before; i < issues_.size() && known == nullptr; ++i) {  // it lacks what one of the given has
    if (issues_[i].hint.empty()) issues_[i].hint = did_you_mean(written, target.given_names(), {}, path + ".");
  }
}

void Reader::read_aggregate(const Tree& tree, const FieldInfo& field, void* inner, const std::string& path) {
  if (tree.type == Tree::Type::table) return read_fields(tree, {{field.fields, inner}}, path, {});
  if (!field.positional) {
    return say_at(tree.place, path, say("'{1}' is a table of fields, not {2}", path, io::word_for(tree.type)),
                  there_is(keys_of({{field.fields, inner}})));
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
    reading_.typed[leaf] = {item.text, item.place};
    read_value(item, *leaves[i], inner, leaf);
  }
  require(field.fields, inner, path, tree.place);
}

bool is_missing(const FieldInfo& field, void* owner) {
  switch (field.type) {
    case Type::quantity:
      return std::isnan(field.get(owner));
    case Type::name:
      return field.text(owner).empty();
    case Type::list:
      return field.size(owner) == 0;
    case Type::count:
    case Type::choice:
    case Type::group:
      return false;
  }
  return false;
}

void Reader::require(std::span<const FieldInfo> fields, void* owner, const std::string& path, const Place& place) {
  for (const FieldInfo& field : fields) {
    const std::string inner = joined(path, field.key);
    if (field.optional || reading_.typed.count(inner) != 0) continue;
    if (field.type == Type::group) {
      require(field.fields, field.element(owner, 0), inner, place);
    } else if (is_missing(field, owner)) {
      const bool in_unit = field.type == Type::quantity && std::string_view(field.unit) != "-";
      say_at(place, inner, say("'{1}' is missing: {2}", inner, field.doc),
             in_unit ? say("write {1} = \"... {2}\"", field.key, field.unit) : Message{});
    }
  }
}

void Reader::check_names(const FieldInfo& list, void* owner, const std::string& path, const Place& place) {
  const FieldInfo* name = find_field(list.fields, "name");
  if (name == nullptr || name->type != Type::name) return;
  std::vector<std::string_view> seen;
  for (std::size_t i = 0; i < list.size(owner); ++i) {
    const std::string_view n = name->text(list.element(owner, i));
    if (!n.empty() && std::find(seen.begin(), seen.end(), n) != seen.end()) {
      const auto typed = reading_.typed.find(path + "." + std::string(n) + ".name");
      say_at(typed == reading_.typed.end() ? place : typed->second.place, path,
             say("the name '{1}' stands twice in '{2}'", n, path));
    }
    seen.push_back(n);
  }
}

}  // namespace

Reading read_record(const io::Tree& table, const RecordType& type, const Template* from, const std::string& prefix,
                    const std::vector<std::string>& reserved, std::vector<Issue>& issues) {
  Reading reading;
  reading.record = Record(type);
  reading.place = table.place;
  std::vector<Part> parts{{type.fields, reading.record.data.get()}};
  if (from != nullptr) {
    from->lay_out(reading.record.data.get());
    reading.parameters = Record(*from->parameters);
    parts.insert(parts.begin(), {from->parameters->fields, reading.parameters.data.get()});
  }
  Reader(reading, issues, prefix).read_fields(table, parts, "", reserved);
  return reading;
}

Message bounds_message(const FieldInfo& field) {
  const Range& b = field.bounds;
  const std::string unit = field.type == Type::quantity ? field.unit : "-";
  const std::string low = (b.low_open ? "> " : ">= ") + format_quantity(b.low, unit);
  const std::string high = (b.high_open ? "< " : "<= ") + format_quantity(b.high, unit);
  if (std::isinf(b.high)) return say("must be {1}", low);
  if (std::isinf(b.low)) return say("must be {1}", high);
  return say("must be {1} and {2}", low, high);
}

bool is_name(std::string_view text) {
  const auto letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  return !text.empty() && letter(text[0]) &&
         std::all_of(text.begin(), text.end(), [&](char c) { return letter(c) || digit(c); });
}

Place place_in(const Place& start, std::string_view text, std::size_t at, std::size_t length) {
  Place place = start;
  at = std::min(at, text.size());
  place.column += static_cast<int>(code_points(text.substr(0, at)));
  place.length = static_cast<int>(std::max<std::size_t>(1, code_points(text.substr(at, length))));
  return place;
}

}  // namespace loadpath::project
