#include "lib/calculator/choice_words.hpp"
#include "lib/project/read/history.hpp"
#include "lib/project/read/reader.hpp"
#include "lib/project/read/spread.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/literal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::project {

using Type = FieldInfo::Type;

void Reader::read_quantity(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  switch (tree.type) {
    case Tree::Type::text:
      return read_text_quantity(tree, field, owner, path);
    case Tree::Type::number:
      return read_literal(format_exact(tree.number), tree, field, owner, path);
    case Tree::Type::table:
      return read_special(tree, field, owner, path);
    case Tree::Type::array:
      return read_grid_of(tree, field, owner, path);
    case Tree::Type::boolean:
      return say_at(tree.place, path, say("a quantity is expected, not {1}", tree.text),
                    say("write a text with a unit, \"30 {1}\"", field.unit));
  }
}

namespace {

/// "give a value; "?" is possible for m_n and T_1": the inputs of the step that have a stock, then largest loads.
Message searched_instead(const Record& record) {
  constexpr std::size_t most = 4;
  std::vector<std::string> keys;
  const auto add = [&](const auto& is_wanted) {
    for (const FieldInfo& field : record.type->fields) {
      if (field.type == FieldInfo::Type::quantity && is_wanted(field) && keys.size() < most)
        keys.emplace_back(field.key);
    }
  };
  add([](const FieldInfo& field) { return *field.searched_in != '\0'; });
  add([](const FieldInfo& field) { return *field.searched_in == '\0' && field.can_be_largest(); });
  std::string names;
  for (const std::string& key : keys) names += (names.empty() ? "" : ", ") + key;
  return names.empty() ? say("give a value") : say("give a value; \"?\" is possible for {1}", names);
}

}  // namespace

void Reader::read_text_quantity(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  if (tree.text == "?") return read_search(tree, field, owner, path);
  if (tree.text.starts_with('?'))
    return say_at(tree.place, path, say("'{1}' is not a value", tree.text),
                  say("to have it sized: {1} = \"?\", or {1} = { stock = \"R20\" }", field.key));
  if (!tree.text.starts_with('=')) return read_literal(tree.text, tree, field, owner, path);
  read_expression(tree, field, owner, path);
}

void Reader::read_search(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  if (*field.searched_in == '\0' && !field.can_be_largest())
    return say_at(tree.place, path, say("'{1}' cannot be searched for", path), searched_instead(reading_.record));
  reading_.searches.push_back({path, {&field, owner}, field.searched_in, tree.place});
}

void Reader::read_expression(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  Place start = tree.place;
  ++start.column;
  std::string text = tree.text.substr(1);
  auto parsed = Expression::parse(text);
  const auto literal = parsed ? Outcome<Literal>(Fault{})
                              : parse_literal(text, Expected{field.dimension, field.kind, field.unit, field.key});
  if (literal)  // a number that is not an expression: "2,5 kN", "20 °C", "1450 1/min"
    parsed = Expression::parse(format_exact(literal->si) + " " + si_unit(literal->dimension));
  if (!parsed) return fault_at(start, text, path, parsed.fault());
  reading_.operands.push_back({path, {&field, owner}, std::move(*parsed), std::move(text), start});
}

/// { file = "gauge.csv" }, { stock = "R40" }, { from = ..., to = ..., count = 11 }, { mean = ..., sd = ... }, { value =
/// ..., tolerance = ... }.
void Reader::read_special(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  if (field.takes_whole() && is_history(tree)) return read_history_of(tree, field, owner, path);
  if (const auto* stock = tree.find("stock")) {
    if (*field.searched_in == '\0')
      return say_at(stock->place, path, say("'{1}' cannot be searched for", path), searched_instead(reading_.record));
    if (stock->value.type != Tree::Type::text)
      return say_at(stock->value.place, path, say("a stock is one name, not {1}", toml::word_for(stock->value.type)),
                    say("`loadpath tables` lists the stocks: {1} = { stock = \"R20\" }", field.key));
    refuse_others(tree, {"stock"}, path);
    reading_.searches.push_back({path, {&field, owner}, stock->value.text, stock->value.place, true});
    return;
  }
  if (tree.find("each") != nullptr) return read_stock(tree, field, owner, path);
  if (is_grid(tree)) return read_grid_of(tree, field, owner, path);
  if (is_uncertain(tree)) return read_uncertain_of(tree, field, owner, path);
  for (const Tree::Entry& entry : tree.entries) {
    const std::string meant = nearest(entry.key, {"from", "to", "count", "step", "mean", "tolerance", "stock"});
    if (meant.size() > 2 && meant != entry.key)
      return say_at(entry.place, path, say("'{1}' is not a valid key here", entry.key),
                    say("did you mean '{1}'?", meant));
  }
  say_at(
      tree.place, path, say("a quantity is expected, not {1}", toml::word_for(tree.type)),
      say("write a text with a unit, \"30 {1}\"; of several values { from = ..., to = ..., count = ... }", field.unit));
}

void Reader::refuse_others(const Tree& tree, const std::vector<std::string>& keys, const std::string& path) {
  for (const Tree::Entry& entry : tree.entries) {
    if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
    say_at(entry.place, path, say("'{1}' is not a valid key here", entry.key), one_of(entry.key, keys));
  }
}

/// Whether a text other than a quantity refers to other steps, as expressions do.
static bool is_bare_expression(const std::string& text) {
  if (parse_unit(text)) return false;  // a number was forgotten
  const auto parsed = Expression::parse(text);
  return parsed && !parsed->references().empty();
}

static std::optional<double> infinity_of(const std::string& text, const FieldInfo& field) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!field.infinite) return std::nullopt;
  if (text == "inf" || text == "+inf") return infinity;
  return text == "-inf" ? std::optional(-infinity) : std::nullopt;
}

bool is_out_of_proportion(double si) {
  constexpr double largest = 1e30;
  return std::abs(si) > largest || (si != 0.0 && std::abs(si) < 1.0 / largest);
}

Message out_of_proportion(const std::string& path, const FieldInfo& field, double si) {
  return say("{1} = {2} is implausible", path, format_quantity(si, field.unit));
}

void Reader::read_literal(const std::string& text, const Tree& tree, const FieldInfo& field, void* owner,
                          const std::string& path) {
  if (const auto number = infinity_of(text, field)) {
    reading_.typed[path].text = text;
    return field.set(owner, *number);
  }
  const auto literal = parse_literal(text, Expected{field.dimension, field.kind, field.unit, field.key});
  if (!literal && is_bare_expression(text)) {
    return say_at(place_in(tree.place, text, 0, text.size()), path, say("'{1}' is an expression without its '='", text),
                  say("an expression starts with '=': write \"={1}\"", text));
  }
  if (!literal) {
    Fault fault = literal.fault();
    const bool is_word = text.find_first_of("0123456789") == std::string::npos;
    if (is_word && (*field.searched_in != '\0' || field.can_be_largest()))  // "auto"
      fault.hint = say("{1}; to have it found: {2} = \"?\"", fault.hint, field.key);
    return fault_at(tree.place, text, path, fault);
  }
  const double si = literal->si;
  if (!field.bounds.holds(si)) {
    const bool is_of_sign = field.is_load && field.bounds.low == 0.0 && field.bounds.holds(-si);  // a compressive force
    return say_at(tree.place, path, say("{1} = {2}: {3}", path, format_quantity(si, field.unit), bounds_message(field)),
                  is_of_sign ? say("{1}: {2}; write it without the sign", field.key, field.doc) : Message{});
  }
  if (is_out_of_proportion(si)) {
    return say_at(tree.place, path, say("{1} = {2} is implausible", path, format_quantity(si, field.unit)),
                  say("check the unit and the power of ten"));
  }
  if (!field.plausible.holds(si)) {
    say_at(tree.place, path, unusual(path, field, si), unusual_hint(field), Severity::warning);
  }
  reading_.typed[path].text = text;
  field.set(owner, si);
}

void Reader::read_count(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  if (tree.type == Tree::Type::text && tree.text.starts_with('=')) return read_expression(tree, field, owner, path);
  if (is_grid(tree)) return read_grid_of(tree, field, owner, path);
  const double n = tree.number;
  if (tree.type != Tree::Type::number || n != std::floor(n)) {
    if (tree.text == "?")
      return say_at(tree.place, path, say("'{1}' cannot be searched for", path), say("give an integer without quotes"));
    const bool number = tree.type == Tree::Type::number;
    const bool is_quoted = !tree.text.empty() && tree.text.find_first_not_of("0123456789") == std::string::npos;
    const Message hint = is_quoted ? say("write it without quotes, as in {1} = 3", field.key)
                                   : say("write an integer, as in {1} = 3", field.key);
    return say_at(
        tree.place, path,
        say("an integer is expected, not {1}", number ? format_number(n) : std::string(toml::word_for(tree.type))),
        number ? Message{} : hint);
  }
  if (!field.bounds.holds(n)) {
    return say_at(tree.place, path, say("{1} = {2}: {3}", path, format_number(n), bounds_message(field)));
  }
  reading_.typed[path].text = format_number(n);
  field.set(owner, n);
}

void Reader::read_choice(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  if (takes(tree, field, path)) return;
  if (tree.type == Tree::Type::array) return read_words(tree, field, owner, path);
  const bool is_word = tree.type == Tree::Type::text || tree.type == Tree::Type::boolean;  // integral = true
  const auto number = is_word ? number_of_word(field, tree.text) : std::nullopt;
  if (!number) {
    const std::string written = is_word ? "'" + tree.text + "'" : std::string(toml::word_for(tree.type));
    return say_at(tree.place, path, say("{1} is not a valid value of '{2}'", written, path),
                  word_near(tree.text, field));
  }
  field.set(owner, *number);
}

void Reader::read_name(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  if (takes(tree, field, path)) return;
  if (tree.type != Tree::Type::text)
    return say_at(tree.place, path, say("a name is expected, not {1}", toml::word_for(tree.type)));
  if (tree.text == "?" && *field.searched_in != '\0')
    return reading_.searches.push_back({path, {}, field.searched_in, tree.place});
  if (!is_name(tree.text)) {
    return say_at(tree.place, path, say("'{1}' is not a valid name", tree.text),
                  say("a name has Latin letters, digits and '_', and does not start with a digit"));
  }
  if (tree.text.size() > Name::capacity)
    return say_at(tree.place, path, say("the name '{1}' is longer than 31 characters", tree.text));
  field.set_text(owner, tree.text);
}

void Reader::read_formula(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  const bool refers = tree.type == Tree::Type::text && lone_reference(tree);
  if (refers && takes(tree, field, path)) return;
  if (tree.type != Tree::Type::text)
    return say_at(tree.place, path, say("a formula is expected, not {1}", toml::word_for(tree.type)),
                  say("write it as a text: \"20 mm*sin(t/(1 s))\""));
  if (tree.text.size() > field.capacity) {
    return say_at(tree.place, path, say("the formula is longer than {1} characters", std::to_string(field.capacity)),
                  say("shorten it"));
  }
  field.set_text(owner, std::string_view(tree.text).substr(tree.text.starts_with('=') ? 1 : 0));
}

/// The column or the row of a file that a history is; the first column where neither is named.
static std::string part_of_file(const Tree& tree) {
  for (const char* const key : {"column", "row"}) {
    if (const auto* const entry = tree.find(key); entry != nullptr)
      return std::string(key) + " " +
             (entry->value.text.empty() ? format_number(entry->value.number) : entry->value.text);
  }
  return "column 1";
}

void Reader::read_history_of(const Tree& tree, const FieldInfo& field, void* owner, const std::string& path) {
  const bool of_file = names_history_file(tree);
  refuse_others(tree,
                of_file ? std::vector<std::string>{"file", "column", "row", "unit", "form"}
                        : std::vector<std::string>{"values", "unit"},
                path);
  History history;
  HistoryFault fault;
  if (!read_history(tree, field, in_step_ ? Kept::all : Kept::turns, history, fault)) {
    if (!fault.place.file.empty()) return say_at(fault.place, path, fault.fault.message, fault.fault.hint);
    const auto* const key = tree.find(fault.key);
    return say_at(key == nullptr ? tree.place : key->value.place, path, fault.fault.message, fault.fault.hint);
  }
  reading_.typed[path].text = of_file ? tree.find("file")->value.text : "values";
  if (of_file) reading_.typed[path].part = part_of_file(tree);
  reading_.axes.push_back(std::move(history.axis));
  field.set_series(owner, std::move(history.series));
}

}  // namespace loadpath::project
