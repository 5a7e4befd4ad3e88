#include "lib/project/solving/bodies.hpp"

#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace loadpath::project {

namespace {

using Members = std::vector<Step*>;

const FieldInfo* size_field(const Step& step, std::string_view key) {
  const FieldInfo* const field = find_field(step.input().calculator->input->fields, key);
  return field != nullptr && field->type == FieldInfo::Type::quantity ? field : nullptr;
}

/// Inputs that a calculator can search for, and that another step of the body has too.
std::vector<std::string> sizes_in_common(const Members& members) {
  std::map<std::string, std::pair<std::size_t, bool>> keys;  // steps that have it, and whether one can search for it
  for (const Step* step : members) {
    for (const FieldInfo& field : step->input().calculator->input->fields) {
      if (field.type != FieldInfo::Type::quantity) continue;
      auto& [count, is_searchable] = keys[field.key];
      ++count;
      is_searchable = is_searchable || *field.searched_in != '\0';
    }
  }
  std::vector<std::string> sizes;
  for (const auto& [key, use] : keys) {
    if (use.first > 1 && use.second) sizes.push_back(key);
  }
  return sizes;
}

/// A step with a size of the body that has a value.
using Sized = SharedSize::Of;

std::vector<Sized> sized_of(const Members& members, const std::string& key) {
  std::vector<Sized> all;
  for (Step* step : members) {
    const auto& inputs = step->account().inputs;
    const auto entry = std::find_if(inputs.begin(), inputs.end(), [&](const Entry& e) { return e.path == key; });
    if (entry == inputs.end() || entry->value.is_series() || entry->value.si.empty()) continue;
    const double si = entry->value.si[0];
    if (!std::isnan(si)) all.push_back({step, si, !entry->origin.searched});
  }
  return all;
}

/// The required size of the body: a given one, else the largest that was found.
const Sized& required(const std::vector<Sized>& all) {
  return *std::max_element(all.begin(), all.end(), [](const Sized& a, const Sized& b) {
    return a.is_given != b.is_given ? b.is_given : a.si < b.si;
  });
}

Issue contradiction(const std::string& body, const std::string& key, const Sized& a, const Sized& b) {
  const std::string unit = size_field(*a.step, key)->unit;
  Issue issue = issue_at(b.step->input(), key,
                         say("the body '{1}' needs a single {2}, but {3} has {4} and {5} has {6}", body, key,
                             a.step->name(), format_quantity(a.si, unit), b.step->name(), format_quantity(b.si, unit)),
                         say("give it once, in [values], or let it be searched for: {1} = \"?\"", key));
  return issue;
}

/// Whether a search of the body has to be repeated.
bool hand_out(const SharedSize& size, std::vector<Issue>& issues) {
  const auto& [body, key, all] = size;
  const Sized& whole = required(all);
  bool changed = false;
  for (const Sized& one : all) {
    if (is_one_size(one.si, whole.si)) continue;
    if (one.is_given) {
      issues.push_back(contradiction(body, key, whole, one));
    } else {
      one.step->set_body_size(key, {whole.si, whole.is_given, whole.step->name()});
      changed = true;
    }
  }
  return changed;
}

/// Checks the rows of a table in steps of one body: it is made of one material, and has one section. `row_of`: the
/// name of the row in a step; empty if it has none.
template <class RowOf>
void check_rows(const std::string& body, const Members& members, const RowOf& row_of, std::vector<Issue>& issues) {
  std::map<std::string, const Step*> named;
  for (const Step* step : members) {
    for (const auto& [group, typed] : step->input().rows) {
      const std::string row = row_of(*step, group);
      if (row.empty()) continue;
      const auto [first, is_new] = named.emplace(group, step);
      const std::string other = row_of(*first->second, group);
      if (is_new || other == row) continue;
      issues.push_back(issue_at(step->input(), group,
                                say("the body '{1}' needs a single {2}, but {3} has '{4}' and {5} has '{6}'", body,
                                    group, first->second->name(), other, step->name(), row),
                                say("use the same row in both, or omit 'body' for separate parts")));
    }
  }
}

std::string typed_row(const Step& step, const std::string& group) {
  const auto row = step.input().rows.find(group);
  return row == step.input().rows.end() ? "" : row->second.text;
}

std::string found_row(const Step& step, const std::string& group) { return step.word(group); }

}  // namespace

std::map<std::string, std::vector<Step*>> bodies_of(const Project& project) {
  std::map<std::string, Members> bodies;
  for (const auto& step : project.steps) {
    const std::string& body = step->input().body.text;
    if (!body.empty()) bodies[body].push_back(step.get());
  }
  return bodies;
}

void check_bodies(const Project& project, std::vector<Issue>& issues) {
  std::vector<std::string> names;
  const auto bodies = bodies_of(project);
  names.reserve(bodies.size());
  for (const auto& [body, members] : bodies) names.push_back(body);
  for (const auto& [body, members] : bodies) {
    const StepInput& first = members.front()->input();
    if (members.size() == 1) {
      std::vector<std::string> others = names;
      std::erase(others, body);
      issues.push_back({first.body.place, first.name + ".body", say("no other step describes the body '{1}'", body),
                        did_you_mean(body, others, say("give it to the other steps of the same part, or leave it out")),
                        Severity::error});
      continue;
    }
    check_rows(body, members, typed_row, issues);
    const auto sizes = sizes_in_common(members);
    for (const Step* step : members) {
      const auto has = [&](const std::string& key) { return size_field(*step, key) != nullptr; };
      if (std::any_of(sizes.begin(), sizes.end(), has)) continue;
      issues.push_back({step->input().body.place, step->name() + ".body",
                        say("'{1}' has no size in common with the other steps of the body '{2}'",
                            step->input().calculator->id, body),
                        say("leave out 'body', and refer to the size: d = \"=step.d\""), Severity::error});
    }
  }
}

bool is_one_size(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b)); }

std::vector<SharedSize> shared_sizes(const Project& project) {
  std::vector<SharedSize> sizes;
  for (const auto& [body, members] : bodies_of(project)) {
    for (const std::string& key : sizes_in_common(members)) {
      SharedSize size{body, key, sized_of(members, key)};
      if (size.of.size() > 1) sizes.push_back(std::move(size));
    }
  }
  return sizes;
}

bool hand_out_sizes(Project& project, std::vector<Issue>& issues) {
  bool changed = false;
  for (const auto& [body, members] : bodies_of(project)) check_rows(body, members, found_row, issues);
  for (const SharedSize& size : shared_sizes(project)) changed = hand_out(size, issues) || changed;
  return changed && !has_errors(issues);
}

}  // namespace loadpath::project
