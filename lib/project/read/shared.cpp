#include "lib/project/read/shared.hpp"

#include "lib/project/read/reading.hpp"
#include "lib/project/read/spread.hpp"
#include "lib/quantity/literal.hpp"
#include "lib/quantity/number/number.hpp"

#include <algorithm>
#include <utility>

namespace loadpath::project {

namespace {

using toml::Tree;

constexpr std::string_view shared_prefix = "values.";
constexpr std::size_t most_in_place = 1'000'000;  // values and tables that replace a name
constexpr std::size_t deepest = 32;               // nested values
constexpr std::size_t longest_way = 1000;         // length of a chain of references between values

/// "n" for "=values.n"; empty unless the text is a bare reference.
std::string name_of_reference(const Tree& tree) {
  const auto path = lone_reference(tree);
  return path && path->starts_with(shared_prefix) ? path->substr(shared_prefix.size()) : "";
}

/// Every name behind "values." in a text.
std::vector<std::string> names_in(std::string_view text) {
  const auto in_name = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  std::vector<std::string> names;
  for (std::size_t at = text.find(shared_prefix); at != std::string_view::npos; at = text.find(shared_prefix, at + 1)) {
    if (at > 0 && (in_name(text[at - 1]) || text[at - 1] == '.')) continue;
    std::size_t end = at + shared_prefix.size();
    while (end < text.size() && in_name(text[end])) ++end;
    names.emplace_back(text.substr(at + shared_prefix.size(), end - at - shared_prefix.size()));
  }
  return names;
}

/// Collects the names in the texts of a tree.
void collect_names(const Tree& tree, std::vector<std::string>& names) {
  if (tree.type == Tree::Type::text)
    for (std::string& name : names_in(tree.text)) names.push_back(std::move(name));
  for (const Tree& item : tree.items) collect_names(item, names);
  for (const Tree::Entry& entry : tree.entries) collect_names(entry.value, names);
}

/// The value of a text or number that an expression may hold; without unit none of an angle is meant.
std::optional<Value> literal_of(const Tree& tree) {
  if (tree.type == Tree::Type::number) return Value{{}, {tree.number}};
  if (tree.type != Tree::Type::text) return std::nullopt;
  const auto literal = parse_literal(tree.text);
  if (!literal) return std::nullopt;
  return Value{{literal->dimension, nullptr}, {literal->si}};
}

/// The fault of a text that begins like a quantity: "5,5 KW"; nothing for a word.
std::optional<Fault> fault_of(const Tree& tree) {
  const std::size_t begin = tree.type == Tree::Type::text ? tree.text.find_first_not_of(" +-") : std::string::npos;
  if (begin == std::string::npos || tree.text[begin] < '0' || tree.text[begin] > '9') return std::nullopt;
  const auto literal = parse_literal(tree.text);
  return literal ? std::nullopt : std::optional<Fault>{literal.fault()};
}

/// A speed whose unit a field would take as revolutions, while an expression does not.
std::optional<std::string> open_count(const Tree& tree) {
  if (tree.type == Tree::Type::text) {
    const auto literal = parse_literal(tree.text);
    return literal && counts_anything(literal->dimension, tree.text) ? std::optional(tree.text) : std::nullopt;
  }
  for (const Tree& item : tree.items) {
    if (auto text = open_count(item)) return text;
  }
  for (const Tree::Entry& entry : tree.entries) {
    if (auto text = open_count(entry.value)) return text;
  }
  return std::nullopt;
}

}  // namespace

bool is_shared(const Tree::Entry& entry) { return entry.key == "values" && entry.value.find("calculator") == nullptr; }

void Values::read(const Tree::Entry& table, std::vector<Issue>& issues) {
  const auto refuse = [&](const Place& place, const std::string& key, Message message, Message hint) {
    issues.push_back({place, key, std::move(message), std::move(hint), Severity::error});
  };
  if (table.value.type != Tree::Type::table)
    return refuse(table.value.place, table.key, say("'{1}' is a table of values", table.key),
                  say("write [values] and below it n = \"1450 rpm\""));
  for (const Tree::Entry& entry : table.value.entries) {
    if (!is_name(entry.key)) {
      refuse(entry.place, "values." + entry.key, say("'{1}' is not a valid name", entry.key),
             say("a name has Latin letters, digits and '_', and does not start with a digit"));
      continue;
    }
    Shared shared;
    shared.tree = entry.value;
    shared.place = entry.place;
    if (auto literal = literal_of(entry.value)) {
      shared.literal = std::move(*literal);
      shared.is_literal = true;
    }
    all_[entry.key] = std::move(shared);
  }
  std::vector<std::string> path;
  for (auto& [name, shared] : all_) settle(name, path, issues);
}

/// Reads the expression of a value, those that it refers to first, and writes them into it.
void Values::settle(const std::string& name, std::vector<std::string>& path, std::vector<Issue>& issues) {
  Shared& shared = all_.at(name);
  if (shared.search == Shared::Search::done) return;
  path.push_back(name);
  if (shared.search == Shared::Search::open) {
    refuse_circle(path, issues);
    return path.pop_back();
  }
  if (path.size() > longest_way) {
    if (!std::exchange(too_many_, true))
      issues.push_back({shared.tree.place, "values", say("the chain of references between values is too long"),
                        say("at most {1} deep", std::to_string(longest_way)), Severity::error});
    return path.pop_back();
  }
  shared.search = Shared::Search::open;
  std::vector<std::string> names;
  collect_names(shared.tree, names);
  for (const std::string& other : names) {
    const auto found = all_.find(other);
    if (found == all_.end()) continue;  // reported at its place
    if (other != name) found->second.is_used = true;
    settle(other, path, issues);
  }
  path.pop_back();
  shared.search = Shared::Search::done;
  if (shared.in_circle || shared.tree.type != Tree::Type::text || !shared.tree.text.starts_with('=')) return;
  Place start = shared.tree.place;
  ++start.column;
  const std::string text = shared.tree.text.substr(1);
  auto expression = Expression::parse(text);
  if (!expression) {
    const Fault& fault = expression.fault();
    issues.push_back(
        {place_in(start, text, fault.at, fault.length), "values." + name, fault.message, fault.hint, Severity::error});
    reported_.insert(name);
    return;
  }
  write_into(*expression, start, "values." + name, issues);
  shared.expression = std::move(*expression);
  const auto& references = shared.expression->references();
  const auto value_of = [&](const std::string& reference) {
    return reference.starts_with(shared_prefix) ? fixed(reference.substr(shared_prefix.size())) : nullptr;
  };
  if (std::any_of(references.begin(), references.end(), [&](const auto& r) { return value_of(r.path) == nullptr; }))
    return;
  shared.literal =
      shared.expression->evaluate([&](const std::string& path_of) -> const Value& { return *value_of(path_of); });
  shared.is_constant = true;
}

/// `names`: the path that returns to the last of them.
void Values::refuse_circle(const std::vector<std::string>& names, std::vector<Issue>& issues) {
  const auto first = std::find(names.begin(), names.end(), names.back());
  if (first + 2 == names.end()) return refuse_circle(names.back(), issues);
  Shared& shared = all_.at(names.back());
  std::string way;
  bool reported = false;
  for (auto name = first; name != names.end(); ++name) {
    way += (way.empty() ? "values." : " -> values.") + *name;
    reported = std::exchange(all_.at(*name).in_circle, true) && name + 1 != names.end();
  }
  if (!reported)
    issues.push_back({shared.tree.place, "values." + names.back(), say("circular reference between values: {1}", way),
                      say("give one of them a value"), Severity::error});
}

void Values::write_into(Expression& expression, const Place& place, const std::string& key,
                        std::vector<Issue>& issues) const {
  const bool fits = expression.write_out([&](const std::string& path) -> const Expression* {
    if (!path.starts_with(shared_prefix)) return nullptr;
    const auto found = all_.find(path.substr(shared_prefix.size()));
    return found == all_.end() || !found->second.expression ? nullptr : &*found->second.expression;
  });
  if (!fits)
    issues.push_back({place, key, say("the expression grows too large with the values that it refers to"),
                      say("give one of them a value"), Severity::error});
}

void Values::note_uses(const Tree& tree) {
  std::vector<std::string> names;
  collect_names(tree, names);
  for (const std::string& name : names) {
    if (const auto found = all_.find(name); found != all_.end()) found->second.is_used = true;
  }
}

/// Once for each value.
void Values::refuse_circle(const std::string& name, std::vector<Issue>& issues) {
  Shared& shared = all_[name];
  if (std::exchange(shared.in_circle, true)) return;
  issues.push_back({shared.tree.place, "values." + name, say("'values.{1}' refers to itself", name),
                    say("give one of them a value"), Severity::error});
}

Message Values::nearest_to(const std::string& name) const {
  std::vector<std::string> names;
  for (const auto& entry : all_) names.push_back(entry.first);
  return names.empty() ? say("write [values] and below it {1} = \"...\"", name)
                       : did_you_mean(name, names, there_is(names), "values.");
}

Tree Values::in_place(const Tree& tree, std::vector<Issue>& issues) {
  const std::string name = name_of_reference(tree);
  if (!open_.empty()) ++in_place_;
  if (in_place_ > most_in_place || open_.size() > deepest) {
    if (!std::exchange(too_many_, true))
      issues.push_back({tree.place, "values", say("nested values give too many values"),
                        say("at most {1} of them, {2} deep", std::to_string(most_in_place), std::to_string(deepest)),
                        Severity::error});
    return tree;
  }
  if (name.empty()) {
    Tree copy = tree;
    const bool is_step = tree.find("calculator") != nullptr;  // whose choice "mean" is no uncertain value
    const bool is_series = tree.find("values") != nullptr || tree.find("file") != nullptr;
    const bool is_of_numbers = is_series || is_grid(tree) || is_uncertain(tree);
    if (tree.type == Tree::Type::table && !is_step && is_of_numbers) write_out_numbers(copy);
    for (Tree& item : copy.items) item = in_place(item, issues);
    for (Tree::Entry& entry : copy.entries) entry.value = in_place(entry.value, issues);
    return copy;
  }
  const auto found = all_.find(name);
  if (found == all_.end()) {
    Place place = tree.place;
    ++place.column;
    issues.push_back({place_in(place, tree.text, 0, tree.text.size() - 1), "values." + name,
                      say("unknown value '{1}'", name), nearest_to(name), Severity::error});
    reported_.insert(name);
    return tree;
  }
  if (!open_.insert(name).second) {
    refuse_circle(name, issues);
    reported_.insert(name);
    return tree;
  }
  found->second.is_used = true;
  Tree value = in_place(found->second.tree, issues);
  open_.erase(name);
  value.shared = std::string(shared_prefix) + name;
  return value;
}

/// The numbers of ranges, distributions and histories are read at once: none of them waits for another step.
void Values::write_out_numbers(Tree& tree) const {
  const auto known = [&](const std::string& path) {
    return path.starts_with(shared_prefix) ? fixed(path.substr(shared_prefix.size())) : nullptr;
  };
  const auto write_out = [&](Tree& one) {
    if (auto number = number_of(one, known)) one = std::move(*number);
  };
  for (Tree::Entry& entry : tree.entries) {
    write_out(entry.value);
    if (entry.value.type == Tree::Type::array)
      std::for_each(entry.value.items.begin(), entry.value.items.end(), write_out);
  }
}

void Values::write_out_all_numbers(Tree& tree) const {
  for (Tree& item : tree.items) write_out_all_numbers(item);
  for (Tree::Entry& entry : tree.entries) write_out_all_numbers(entry.value);
  write_out_numbers(tree);
}

Outcome<Signature> Values::signature(const std::string& name) {
  const auto found = all_.find(name);
  if (found == all_.end() && reported_.contains(name)) return Fault{};
  if (found == all_.end()) return Fault{0, name.size(), say("unknown value '{1}'", name), nearest_to(name)};
  found->second.is_used = true;
  if (found->second.expression || found->second.in_circle) return Fault{};  // written out, or reported
  if (!found->second.is_literal) read_several(name, found->second);
  if (const auto text = found->second.is_literal ? open_count(found->second.tree) : std::nullopt)
    return Fault{0, name.size(), say("'{1}' is ambiguous: a speed of rotation or a frequency", *text),
                 say("write rpm for a speed of rotation")};
  if (found->second.is_literal) return found->second.literal.signature;
  if (const auto fault = fault_of(found->second.tree))
    return Fault{0, name.size(), say("'values.{1}' is not a number or quantity: {2}", name, fault->message.text()),
                 fault->hint};
  return Fault{0, name.size(), say("'values.{1}' is not a number or quantity", name),
               say("use it without operators: \"=values.{1}\"", name)};
}

/// Reads a range, a list, an uncertain value, when an expression uses it.
void Values::read_several(const std::string& name, Shared& shared) {
  const Tree& tree = shared.tree;
  std::optional<Dimension> dimension;
  const auto to_si = [&](const Tree& text, double& si) {
    const auto one = literal_of(text);
    if (!one || (dimension && one->signature.dimension != *dimension)) return false;
    dimension = one->signature.dimension;
    si = one->si[0];
    return true;
  };
  const auto silent = [](const Place&, const Message&, const Message&) {};  // the caller reports a non-literal
  const auto of_first = [&](const Tree& text) {
    const auto one = literal_of(text);
    return one ? one->signature.dimension : Dimension{};
  };
  Several several{name, shared.place, {}, {}};
  if (is_grid(tree) && (tree.type == Tree::Type::table || !tree.items.empty())) {
    const Tree& first = tree.type == Tree::Type::table ? tree.find("from")->value : tree.items.front();
    auto axis = read_grid(tree, of_first(first), to_si, silent);
    if (!axis || !dimension) return;
    several.axis = std::move(*axis);
  } else if (is_uncertain(tree)) {
    several.distribution = read_uncertain(tree, of_first(tree.entries.front().value), to_si, silent);
    if (!several.distribution || !dimension) return;
  } else {
    return;
  }
  const double first = several.distribution ? several.distribution->mean() : several.axis.at(0);
  shared.literal = {{*dimension, nullptr}, {first}};
  shared.is_literal = true;
  shared.several = std::move(several);
}

std::vector<Values::Several> Values::several() const {
  std::vector<Several> all;
  for (const auto& [name, shared] : all_) {
    if (shared.several) all.push_back(*shared.several);
  }
  return all;
}

void Values::set(const std::string& name, double si) { all_.at(name).literal.si[0] = si; }

const Value* Values::literal(const std::string& name) const {
  const auto found = all_.find(name);
  return found != all_.end() && found->second.is_literal ? &found->second.literal : nullptr;
}

const Value* Values::fixed(const std::string& name) const {
  const auto found = all_.find(name);
  const bool is_one =
      found != all_.end() && !found->second.several && (found->second.is_literal || found->second.is_constant);
  return is_one ? &found->second.literal : nullptr;
}

std::vector<const Value*> Values::numbers() const {
  std::vector<const Value*> all;
  for (const auto& [name, shared] : all_)
    if (const Value* const one = fixed(name)) all.push_back(one);
  return all;
}

std::vector<std::string_view> Values::texts() const {
  std::vector<std::string_view> all;
  for (const auto& [name, shared] : all_)
    if (shared.tree.type == Tree::Type::text) all.emplace_back(shared.tree.text);
  return all;
}

Meant Values::kind(const std::string& name) const {
  const auto found = all_.find(name);
  if (found == all_.end()) return Meant::nothing;
  const Tree* tree = &found->second.tree;
  while (tree->type == Tree::Type::array && !tree->items.empty()) tree = &tree->items.front();
  while (tree->type == Tree::Type::table && !tree->entries.empty()) tree = &tree->entries.front().value;
  return tree->type == Tree::Type::text ? kind_of_literal(tree->text) : Meant::nothing;
}

void Values::collect_unused() {
  unused_.clear(), unused_words_.clear();
  for (const auto& [name, shared] : all_) {
    if (shared.is_used) continue;
    const bool is_one = !shared.several && (shared.is_literal || shared.is_constant);
    const bool is_word = shared.tree.type == Tree::Type::text && !shared.is_literal && !shared.expression;
    if (is_one && !shared.literal.si.empty()) unused_.emplace_back(name, shared.literal);
    if (is_word) unused_words_.emplace_back(name, shared.tree.text);
  }
}

void Values::warn_of_unused(std::vector<Issue>& issues) const {
  if (!reported_.empty()) return;  // a name that was mistyped may have meant it
  for (const auto& [name, shared] : all_) {
    if (shared.is_used) continue;
    issues.push_back(
        {shared.place, "values." + name, say("nothing refers to 'values.{1}'", name), {}, Severity::warning});
  }
}

}  // namespace loadpath::project
