#include "lib/project/references/sources.hpp"

#include "lib/project/project.hpp"

#include <cmath>
#include <map>
#include <set>

namespace loadpath::project {

namespace {

/// Places in the lists of a step that references name: those of loads, else of all.
struct Named {
  std::set<std::string> by_loads, by_all;

  void add(const std::string& place, bool is_load) {
    by_all.insert(place);
    if (is_load) by_loads.insert(place);
  }
  /// The only one; empty if there are several.
  [[nodiscard]] std::string only() const {
    const std::set<std::string>& named = by_loads.empty() ? by_all : by_loads;
    return named.size() == 1 ? *named.begin() : "";
  }
};
struct NamedIn {
  Named places;
  std::map<std::string, Named> elements;  // by their list
};

/// The list and the element in "joints.B.F"; empty if there are none.
std::pair<std::string, std::string> element_in(const std::string& path) {
  const std::size_t first = path.find('.'), second = path.find('.', first + 1);
  if (first == std::string::npos || second == std::string::npos) return {};
  return {path.substr(0, first), path.substr(first + 1, second - first - 1)};
}

constexpr int most_places = 12;

}  // namespace

std::vector<Source> sources_of(const Reading& reading) {
  std::map<std::string, NamedIn> places;
  for (const Operand& operand : reading.operands) {
    if (operand.leaf.field->is_factor) continue;  // a safety factor belongs to no part
    for (const auto& reference : operand.expression.references()) {
      const auto [step, path] = split_step(reference.path);
      if (step == "values") continue;
      NamedIn& named = places[step];
      const auto [list, element] = element_in(path);
      if (!element.empty()) named.elements[list].add(element, operand.leaf.field->is_load);
      const std::size_t open = path.find('['), close = path.find(']');
      std::string place;  // empty: behind the last one
      if (open < close && close != std::string::npos) place = path.substr(open + 1, close - open - 1);
      if (place.empty() && !path.ends_with("_out")) continue;
      named.places.add(place, operand.leaf.field->is_load);
    }
  }
  std::vector<Source> sources;
  for (const auto& [step, named] : places) {
    Source& source = sources.emplace_back();
    source.step = step;
    source.is_assumed = named.places.by_all.empty();
    source.place = source.is_assumed ? "1" : named.places.only();
    for (const auto& [list, elements] : named.elements) source.elements[list] = elements.only();
  }
  return sources;
}

namespace {

/// Adds the step of a path; values and tables are none.
void add_step_of(const std::string& path, std::set<std::string>& names) {
  const std::string name = split_step(path).first;
  if (name != "values" && name != "tables") names.insert(name);
}

}  // namespace

std::set<std::string> steps_named_in(const Reading& reading) {
  std::set<std::string> names;
  for_each_reference(reading, [&](const std::string& path) { add_step_of(path, names); });
  return names;
}

std::set<std::string> steps_loading(const Reading& reading) {
  std::set<std::string> names;
  for (const Taken& record : reading.records) add_step_of(record.source, names);
  for (const Operand& operand : reading.operands) {
    if (!operand.leaf.field->is_load) continue;
    for (const auto& reference : operand.expression.references()) add_step_of(reference.path, names);
  }
  return names;
}

std::string path_in(const Source& source, std::string key) {
  if (const std::size_t at = key.find('#'); at != std::string::npos) {
    const bool by_name = at > 0 && key[at - 1] == '.';
    const auto named = source.elements.find(by_name ? key.substr(0, at - 1) : "");
    const std::string place = !by_name ? source.place : named == source.elements.end() ? "" : named->second;
    if (place.empty()) return "";
    key.replace(at, 1, place);
  }
  return source.step + "." + key;
}

std::vector<Source> alternatives(const Source& source) {
  return source.is_assumed ? places_of(source) : std::vector{source};
}

std::vector<Source> places_of(const Source& source) {
  std::vector<Source> all(most_places, source);
  for (int place = 1; place <= most_places; ++place)
    all[static_cast<std::size_t>(place - 1)].place = std::to_string(place);
  return all;
}

std::vector<ComparedKeys> keys_in_sources(const FieldInfo& field) {
  std::vector<ComparedKeys> all;
  for (const ComparedKeys& keys : {ComparedKeys{Comparison::same, field.same_as_source},
                                   {Comparison::at_most, field.most_of_source},
                                   {Comparison::at_least, field.least_of_source},
                                   {Comparison::near, field.near_source}}) {
    if (*keys.keys != '\0') all.push_back(keys);
  }
  return all;
}

namespace {

/// "rho?p_i": "rho" and "p_i", "!rho?p_i": "!rho" and "p_i"; without a condition the first is empty.
std::pair<std::string, std::string> split_condition(const std::string& key) {
  const std::size_t mark = key.find('?');
  return mark == std::string::npos ? std::pair{std::string(), key}
                                   : std::pair{key.substr(0, mark), key.substr(mark + 1)};
}

}  // namespace

std::vector<std::string> keys_where_given(const char* list, const Record& record) {
  std::vector<std::string> keys;
  for (const std::string& key : listed_keys(list)) {
    auto [condition, plain] = split_condition(key);
    const bool is_negated = condition.starts_with('!');
    const Leaf leaf = condition.empty() ? Leaf{} : find_leaf(record, is_negated ? condition.substr(1) : condition);
    const bool is_given = leaf && !std::isnan(leaf.get());
    if (condition.empty() || is_given != is_negated) keys.push_back(std::move(plain));
  }
  return keys;
}

std::vector<std::pair<std::string, std::string>> inputs_made_for(const FieldInfo& field) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const std::string& key : listed_keys(field.made_for)) {
    const std::size_t colon = key.find(':');
    const std::string own = key.substr(0, colon);
    pairs.emplace_back(own, colon == std::string::npos ? own : key.substr(key.find_first_not_of(' ', colon + 1)));
  }
  return pairs;
}

namespace {

/// The paths of the keys in the sources, at every place.
void visit_in(const std::vector<Source>& sources, const FieldInfo& field,
              const std::function<void(const std::string& path)>& visit) {
  for (const ComparedKeys& compared : keys_in_sources(field)) {
    for (const std::string& key : listed_keys(compared.keys)) {
      for (const Source& source : sources) {
        for (const Source& place : places_of(source)) {
          const std::string path = path_in(place, split_condition(key).second);
          if (!path.empty()) visit(path);
        }
      }
    }
  }
}

/// Where loads that are magnitudes come from: whether their direction reverses.
void visit_directions(const Reading& reading, const std::function<void(const std::string& path)>& visit) {
  for (const Operand& operand : reading.operands) {
    if (!operand.leaf.field->is_load) continue;
    for (const auto& reference : operand.expression.references()) visit(path_of_reversal(reference.path));
  }
}

}  // namespace

std::string path_of_reversal(const std::string& load) { return load.substr(0, load.rfind('.') + 1) + "reversal"; }

void for_each_compared(const StepInput& step, const std::function<void(const std::string& path)>& visit) {
  for (const TypedOverride& kept : step.reading.kept) visit(kept.source);
  for (const Operand& operand : step.reading.operands) {
    if (!operand.expression.is_reference()) continue;
    const std::string source = split_step(operand.expression.references().front().path).first;
    for (const auto& [own, theirs] : inputs_made_for(*operand.leaf.field))
      visit(std::string(source).append(".").append(theirs));
  }
  if (!step.calculator->senses.empty()) visit_directions(step.reading, visit);
  const auto sources = sources_of(step.reading);
  if (sources.empty()) return;
  for (const FieldInfo& field : step.calculator->input->fields) visit_in(sources, field, visit);
  if (step.calculator->result != nullptr) {
    for (const FieldInfo& field : step.calculator->result->fields) visit_in(sources, field, visit);
  }
}

std::string named_material(const Step& step, const Project& project) {
  const auto row = step.input().rows.find("material");
  const bool is_named = row != step.input().rows.end() && !row->second.text.empty();
  if (is_named && row->second.text[0] != '=') return row->second.text;
  for (const Taken& taken : step.input().reading.taken) {
    const auto [name, rest] = split_step(taken.source);
    const Step* const source = taken.path == "material" && rest == "material" ? project.find(name) : nullptr;
    if (source != nullptr && source != &step) return named_material(*source, project);
  }
  return step.word("material");
}

}  // namespace loadpath::project
