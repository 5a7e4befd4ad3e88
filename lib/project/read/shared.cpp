#include "lib/project/read/shared.hpp"

#include "lib/project/read/reading.hpp"
#include "lib/project/read/spread.hpp"
#include "lib/quantity/literal.hpp"
#include "lib/quantity/number.hpp"

#include <algorithm>
#include <utility>

namespace loadpath::project {

namespace {

using toml::Tree;

constexpr std::string_view shared_prefix = "values.";
constexpr std::size_t most_in_place = 1'000'000;  // values and tables that stand in the place of a name
constexpr std::size_t deepest = 32;               // values that refer to one another

/// "=values.n": "n"; empty where the text is none that stands alone.
std::string name_of_reference(const Tree& tree) {
  const auto path = lone_reference(tree);
  return path && path->starts_with(shared_prefix) ? path->substr(shared_prefix.size()) : "";
}

/// The value of a text or number that an expression may hold; without unit none of an angle is meant.
std::optional<Value> literal_of(const Tree& tree) {
  if (tree.type == Tree::Type::number) return Value{{}, {tree.number}};
  if (tree.type != Tree::Type::text) return std::nullopt;
  const auto literal = parse_literal(tree.text);
  if (!literal) return std::nullopt;
  return Value{{literal->dimension, nullptr}, {literal->si}};
}

/// What is wrong with a text that begins as a quantity does: "5,5 KW"; nothing of a word.
std::optional<Fault> fault_of(const Tree& tree) {
  const std::size_t begin = tree.type == Tree::Type::text ? tree.text.find_first_not_of(" +-") : std::string::npos;
  if (begin == std::string::npos || tree.text[begin] < '0' || tree.text[begin] > '9') return std::nullopt;
  const auto literal = parse_literal(tree.text);
  return literal ? std::nullopt : std::optional<Fault>{literal.fault()};
}

/// A speed whose unit a field would know to be of revolutions, and an expression does not.
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
      refuse(entry.place, "values." + entry.key, say("'{1}' is no name", entry.key),
             say("a name has Latin letters, digits and '_', and does not start with a digit"));
      continue;
    }
    Shared shared{entry.value, entry.place, {}, std::nullopt, false, false, false};
    if (auto literal = literal_of(entry.value)) {
      shared.literal = std::move(*literal);
      shared.is_literal = true;
    }
    all_[entry.key] = std::move(shared);
  }
  refuse_circles(issues);
}

/// Once for each value.
void Values::refuse_circle(const std::string& name, std::vector<Issue>& issues) {
  Shared& shared = all_[name];
  if (std::exchange(shared.in_circle, true)) return;
  issues.push_back({shared.tree.place, "values." + name, say("'values.{1}' refers to itself", name),
                    say("give one of the circle a value"), Severity::error});
}

void Values::refuse_circles(std::vector<Issue>& issues) {
  for (const auto& [name, shared] : all_) {
    std::set<std::string> seen{name};
    for (std::string next = name_of_reference(shared.tree); all_.contains(next);
         next = name_of_reference(all_[next].tree)) {
      if (seen.insert(next).second) continue;
      if (next == name) refuse_circle(name, issues);
      break;
    }
  }
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
      issues.push_back({tree.place, "values", say("values that stand in values come to too many"),
                        say("at most {1} of them, {2} deep", std::to_string(most_in_place), std::to_string(deepest)),
                        Severity::error});
    return tree;
  }
  if (name.empty()) {
    Tree copy = tree;
    for (Tree& item : copy.items) item = in_place(item, issues);
    for (Tree::Entry& entry : copy.entries) entry.value = in_place(entry.value, issues);
    return copy;
  }
  const auto found = all_.find(name);
  if (found == all_.end()) {
    Place place = tree.place;
    ++place.column;
    issues.push_back({place_in(place, tree.text, 0, tree.text.size() - 1), "values." + name,
                      say("there is no value '{1}'", name), nearest_to(name), Severity::error});
    told_.insert(name);
    return tree;
  }
  if (!open_.insert(name).second) {
    refuse_circle(name, issues);
    told_.insert(name);
    return tree;
  }
  found->second.is_used = true;
  Tree value = in_place(found->second.tree, issues);
  open_.erase(name);
  value.shared = std::string(shared_prefix) + name;
  return value;
}

Outcome<Signature> Values::signature(const std::string& name) {
  const auto found = all_.find(name);
  if (found == all_.end() && told_.contains(name)) return Fault{};
  if (found == all_.end()) return Fault{0, name.size(), say("there is no value '{1}'", name), nearest_to(name)};
  found->second.is_used = true;
  if (!found->second.is_literal) read_several(name, found->second);
  if (const auto text = found->second.is_literal ? open_count(found->second.tree) : std::nullopt)
    return Fault{0, name.size(), say("'{1}' is a speed in revolutions to some and a frequency to others", *text),
                 say("write rpm for a speed of rotation")};
  if (found->second.is_literal) return found->second.literal.signature;
  if (const auto fault = fault_of(found->second.tree))
    return Fault{0, name.size(), say("'values.{1}' is no literal to calculate with: {2}", name, fault->message.text()),
                 fault->hint};
  return Fault{0, name.size(), say("'values.{1}' is no literal to calculate with", name),
               say("it can stand alone: \"=values.{1}\"", name)};
}

/// A range, a list, an uncertain value, where an expression asks for it.
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
  const auto silent = [](const Place&, const Message&, const Message&) {};  // the caller tells that it is no literal
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

void Values::warn_of_unused(std::vector<Issue>& issues) const {
  if (!told_.empty()) return;  // a name that was mistyped may have meant it
  for (const auto& [name, shared] : all_) {
    if (shared.is_used) continue;
    issues.push_back(
        {shared.place, "values." + name, say("nothing refers to 'values.{1}'", name), {}, Severity::warning});
  }
}

}  // namespace loadpath::project
