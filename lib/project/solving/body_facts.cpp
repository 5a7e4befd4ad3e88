#include "lib/project/solving/body_facts.hpp"

#include "lib/project/because.hpp"
#include "lib/project/run/field_role.hpp"
#include "lib/project/run/neighbours.hpp"
#include "lib/project/solving/bodies.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace loadpath::project {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double rounding = 1e-6;

bool is_named(const char* names, const std::string& name) {
  const auto all = listed_keys(names);
  return std::find(all.begin(), all.end(), name) != all.end();
}

double value_in(const std::vector<Entry>& entries, const char* key) {
  const auto entry = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.path == key; });
  return entry == entries.end() ? unknown : largest_magnitude(entry->values());
}

/// The value of an input, of a choice its index; NaN if it is open.
double value_of(const Step& step, const FieldInfo& field) {
  if (field.type != FieldInfo::Type::choice) return value_in(step.account().inputs, field.key);
  const std::string word = step.word(field.key);
  for (std::size_t i = 0; i < field.choices.size(); ++i) {
    if (!word.empty() && word == field.choices[i].key) return static_cast<double>(i);
  }
  return unknown;
}

/// The result of the name that has a value; null if there is none.
const FieldInfo* result_of(const Step& step, const std::string& name) {
  if (step.input().calculator->result == nullptr) return nullptr;
  for (const FieldInfo& field : step.input().calculator->result->fields) {
    if (is_named(field.shared_as, name) && !std::isnan(value_in(step.account().results, field.key))) return &field;
  }
  return nullptr;
}

double measured(const Step& step, const Statement& by_input) {
  if (step.input().calculator->result == nullptr) return unknown;
  if (by_input.result != nullptr) return std::abs(value_in(step.account().results, by_input.result->key));
  if (by_input.input == nullptr || !by_input.input->is_load) return std::abs(by_input.value);
  const double factor = value_in(step.account().inputs, "K_A");
  return std::abs(by_input.value) * (std::isnan(factor) ? 1.0 : factor);
}

bool is_given(const Step& step, const FieldInfo& field) { return step.input().reading.typed.contains(field.key); }

/// The last given input of the name that has a value, ends_y replaces ends, else the last one with a default.
Statement statement_of(Step& step, const std::string& name) {
  Statement made{&step, nullptr, unknown, unknown};
  for (const FieldInfo& field : step.input().calculator->input->fields) {
    if (!is_named(facts_of(field).c_str(), name)) continue;
    const double value = value_of(step, field);
    const bool is_weaker = made.input != nullptr && is_given(step, *made.input) && !is_given(step, field);
    if (!std::isnan(value) && !is_weaker) made.input = &field, made.value = value;
  }
  made.result = result_of(step, name);
  made.measure = measured(step, made);
  return made;
}

bool is_bore(const std::string& name) { return name == "bore"; }

std::vector<Statement> statements_of(const std::vector<Step*>& members, const std::string& name) {
  std::vector<Statement> all;
  for (Step* step : members) {
    const Statement made = statement_of(*step, name);
    if (!std::isnan(made.measure) && (made.input != nullptr || is_bore(name))) all.push_back(made);
  }
  return all;
}

/// The value of its own input that a step would need to state what another one does.
double in_place_of(const Statement& own, const Statement& other) {
  if (own.input->type == FieldInfo::Type::choice || own.measure == 0.0) return other.value;
  return own.value * other.measure / own.measure;
}

/// Whether another step states something less favourable; of the ends of a bar, anything else.
bool is_surpassed(const Statement& own, const Statement& other) {
  const double a = own.measure, b = other.measure;
  if (std::abs(a - b) <= rounding * std::max(a, b)) return false;
  if (own.input->type != other.input->type) return false;
  if (own.input->type == FieldInfo::Type::choice) return true;
  const bool is_of_material = *own.input->shared_as == '\0';
  if (is_of_material && !is_given(*own.step, *own.input)) return false;
  // A bar in tension in one load case is compressed in another.
  if (a == 0.0 && own.input->signed_load) return false;
  const FieldRole kind = role_in_body(*own.input);
  return is_of_one_part(kind) || is_bolder(kind, a, b);
}

/// Of two values of other steps, whether the first is the less favourable.
bool is_worse(const Statement& a, const Statement& b) {
  return role_in_body(*a.input) == FieldRole::capacity ? a.measure < b.measure : a.measure > b.measure;
}

void add_facts(const std::vector<Statement>& all, std::map<Step*, BodyFacts>& facts) {
  for (const Statement& own : all) {
    const Statement* worst = nullptr;
    for (const Statement& other : all) {
      if (other.step == own.step || !is_surpassed(own, other)) continue;
      if (worst == nullptr || is_worse(other, *worst)) worst = &other;
    }
    if (worst != nullptr) facts[own.step][own.input->key] = {in_place_of(own, *worst), worst->step->name()};
  }
}

/// Whether two steps state one bore: by its size, or as the same ratio, which each sizes.
bool is_one_bore(const Statement& a, const Statement& b) {
  const bool by_ratio =
      a.input != nullptr && b.input != nullptr && a.input->dimension.is_number() && b.input->dimension.is_number();
  const double p = by_ratio ? a.value : a.measure, q = by_ratio ? b.value : b.measure;
  return std::abs(p - q) <= rounding * std::max(std::abs(p), std::abs(q));
}

/// A bar is bored or not.
void check_bores(const std::string& body, const std::vector<Statement>& all, std::vector<Issue>& issues) {
  for (const Statement& one : all) {
    const Statement& first = all.front();
    if (is_one_bore(first, one)) continue;
    issues.push_back(
        issue_at(one.step->input(), one.input == nullptr ? "body" : one.input->key,
                 say("the body '{1}' needs a single bore, but {2} has {3} and {4} has {5}", body, first.step->name(),
                     format_quantity(first.measure, "mm"), one.step->name(), format_quantity(one.measure, "mm")),
                 say("give the bore in both, or omit 'body' for separate parts")));
    return;
  }
}

std::set<std::string> names_in(const std::vector<Step*>& members) {
  std::set<std::string> names;
  for (const Step* step : members) {
    for (const FieldInfo& field : step->input().calculator->input->fields) {
      for (const std::string& name : listed_keys(facts_of(field))) names.insert(name);
    }
  }
  return names;
}

/// The input of a name, and the text of [values] that it was typed as; null, and empty, if there is none.
const FieldInfo* input_of(const Step& step, const char* name) {
  for (const FieldInfo& field : step.input().calculator->input->fields) {
    if (is_named(field.shared_as, name)) return &field;
  }
  return nullptr;
}
std::string shared_pressure(const Step& step) {
  const FieldInfo* const pressure = input_of(step, "pressure");
  if (pressure == nullptr) return {};
  const auto typed = step.input().reading.typed.find(pressure->key);
  return typed == step.input().reading.typed.end() ? "" : typed->second.shared;
}

/// A wall of a vessel: a step with a radius.
struct Wall {
  Step* step;
  double radius;
  std::string pressure;  // the one of [values] that it is typed as; empty if none is
  bool has_ends;
  bool is_free;  // not of a body that is named
};

std::vector<Wall> walls_of(const Project& project) {
  std::vector<Wall> walls;
  for (const auto& step : project.steps) {
    if (input_of(*step, "radius") == nullptr) continue;
    walls.push_back({step.get(), statement_of(*step, "radius").measure, shared_pressure(*step),
                     find_field(step->input().calculator->input->fields, "ends") != nullptr,
                     step->input().body.text.empty()});
  }
  return walls;
}

bool has_equal_radius(const Wall& a, const Wall& b) {
  return std::abs(a.radius - b.radius) <= rounding * std::max(a.radius, b.radius);
}

/// Walls of one vessel, which nothing calls one body: the same [values] give their pressure, and their radii are equal.
bool are_joined(const Wall& a, const Wall& b) {
  return has_equal_radius(a, b) && !a.pressure.empty() && a.pressure == b.pressure;
}

/// A head of the radius of a shell, neither of them calculated for a body of its own: a shell without ends.
bool is_head_on(const Wall& head, const Wall& shell) {
  return head.is_free && shell.is_free && !head.has_ends && shell.has_ends && has_equal_radius(head, shell);
}

/// A head has the pressure of its shell; below a liquid it has more, which is not an error of the shell.
void add_facts_of_head(Step& head, Step& shell, std::map<Step*, BodyFacts>& facts) {
  std::map<Step*, BodyFacts> both;
  add_facts(statements_of({&head, &shell}, "pressure"), both);
  if (shell.input().reading.typed.contains("h_l")) both.erase(&shell);
  for (auto& [step, own] : both) facts[step].merge(own);
}

/// Joined walls have the same medium inside, and a head the pressure of its shell.
void add_facts_of_vessels(const Project& project, std::map<Step*, BodyFacts>& facts) {
  const std::vector<Wall> walls = walls_of(project);
  for (const Wall& a : walls) {
    for (const Wall& b : walls) {
      if (a.step == b.step) continue;
      if (are_joined(a, b)) add_facts(statements_of({a.step, b.step}, "allowance"), facts);
      if (is_head_on(a, b)) add_facts_of_head(*a.step, *b.step, facts);
    }
  }
}

bool is_fact(const StepInput& step, const std::string& key) {
  const FieldInfo* const field = find_field(step.calculator->input->fields, key);
  return field != nullptr && !facts_of(*field).empty();
}

/// Whether the steps have to be solved again: with other facts, or to judge reasons that may be about them.
bool hand_out_to(const Project& project, std::map<Step*, BodyFacts>& facts) {
  bool changed = false;
  for (const auto& step : project.steps) {
    BodyFacts& own = facts[step.get()];
    const auto& because = step->input().because;
    const bool has_reason = std::any_of(because.begin(), because.end(),
                                        [&](const auto& reason) { return is_fact(step->input(), reason.first); });
    changed = changed || own != step->body_facts().value_or(BodyFacts{}) || (has_reason && !step->body_facts());
    step->set_body_facts(std::move(own));
  }
  return changed;
}

}  // namespace

std::vector<BodyStatements> statements_of_bodies(const Project& project) {
  std::vector<BodyStatements> stated;
  for (const auto& [body, members] : bodies_of(project)) {
    for (const std::string& name : names_in(members)) stated.push_back({name, statements_of(members, name)});
  }
  return stated;
}

bool agree(const BodyStatements& stated) {
  const std::vector<Statement>& all = stated.all;
  if (is_bore(stated.name)) {
    return std::all_of(all.begin(), all.end(), [&](const Statement& one) { return is_one_bore(all.front(), one); });
  }
  return std::all_of(all.begin(), all.end(), [&](const Statement& own) {
    const auto is_less = [&](const Statement& other) { return other.step != own.step && is_surpassed(own, other); };
    return std::ranges::none_of(all, is_less) || reason_for(own.step->input(), own.input->key) != nullptr;
  });
}

bool compares_walls(const Project& project, const std::set<std::string>& affected) {
  const auto may_vary = [&](const Wall& wall, const char* name) {
    if (!affected.contains(wall.step->name())) return false;
    const Reading& reading = wall.step->input().reading;
    const Statement stated = statement_of(*wall.step, name);
    const auto is_it = [&](const auto& one) { return stated.input != nullptr && one.path == stated.input->key; };
    const auto is_computed = [&](const Operand& operand) { return is_it(operand) && !operand.of_record; };
    return stated.result != nullptr || std::ranges::any_of(reading.varied, is_it) ||
           std::ranges::any_of(reading.operands, is_computed);
  };
  const auto differ_elsewhere = [&](const Wall& a, const Wall& b) {
    if (may_vary(a, "radius") || may_vary(b, "radius")) return true;
    const auto has_other = [&](const char* name) { return may_vary(a, name) || may_vary(b, name); };
    return has_equal_radius(a, b) && (has_other("pressure") || has_other("allowance"));
  };
  const std::vector<Wall> walls = walls_of(project);
  return std::ranges::any_of(walls, [&](const Wall& a) {
    return std::ranges::any_of(walls, [&](const Wall& b) { return a.step != b.step && differ_elsewhere(a, b); });
  });
}

bool hand_out_facts(Project& project, std::vector<Issue>& issues) {
  std::map<Step*, BodyFacts> facts;
  for (const auto& [body, members] : bodies_of(project)) {
    for (const std::string& name : names_in(members)) {
      const std::vector<Statement> all = statements_of(members, name);
      is_bore(name) ? check_bores(body, all, issues) : add_facts(all, facts);
    }
  }
  add_facts_of_vessels(project, facts);
  return hand_out_to(project, facts) && !has_errors(issues);
}

}  // namespace loadpath::project
