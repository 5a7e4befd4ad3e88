#include "lib/project/references/sources.hpp"

#include "lib/project/project.hpp"

#include <cmath>
#include <map>
#include <set>

namespace loadpath::project {

namespace {

/// The places in the lists of a step that references name: those of loads, else of all.
struct Named {
  std::set<std::string> by_loads, by_all;
};

}  // namespace

std::vector<Source> sources_of(const Reading& reading) {
  std::map<std::string, Named> places;
  for (const Operand& operand : reading.operands) {
    if (operand.leaf.field->is_factor) continue;  // a safety factor belongs to no part
    for (const auto& reference : operand.expression.references()) {
      const auto [step, path] = split_step(reference.path);
      if (step == "values") continue;
      Named& named = places[step];
      const std::size_t open = path.find('['), close = path.find(']');
      std::string place;  // empty: behind the last one
      if (open < close && close != std::string::npos) place = path.substr(open + 1, close - open - 1);
      if (place.empty() && !path.ends_with("_out")) continue;
      named.by_all.insert(place);
      if (operand.leaf.field->is_load) named.by_loads.insert(place);
    }
  }
  std::vector<Source> sources;
  for (const auto& [step, all] : places) {
    const std::set<std::string>& named = all.by_loads.empty() ? all.by_all : all.by_loads;
    if (named.empty())
      sources.push_back({step, "1", true});
    else
      sources.push_back({step, named.size() == 1 ? *named.begin() : ""});
  }
  return sources;
}

std::string path_in(const Source& source, std::string key) {
  if (const std::size_t at = key.find('#'); at != std::string::npos) {
    if (source.place.empty()) return "";
    key.replace(at, 1, source.place);
  }
  return source.step + "." + key;
}

std::vector<Source> alternatives(const Source& source) {
  constexpr int most_places = 12;
  if (!source.is_assumed) return {source};
  std::vector<Source> all;
  for (int place = 1; place <= most_places; ++place) all.push_back({source.step, std::to_string(place), true});
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

/// "rho?p_i": "rho" and "p_i"; without a condition the first is empty.
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
    const Leaf given = condition.empty() ? Leaf{} : find_leaf(record, condition);
    if (condition.empty() || (given && !std::isnan(given.get()))) keys.push_back(std::move(plain));
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

/// The paths of a key in the sources.
void visit_in(const std::vector<Source>& sources, const std::string& key,
              const std::function<void(const std::string& path)>& visit) {
  for (const Source& source : sources) {
    for (const Source& place : alternatives(source)) {
      const std::string path = path_in(place, key);
      if (!path.empty()) visit(path);
    }
  }
}

}  // namespace

void for_each_compared(const StepInput& step, const std::function<void(const std::string& path)>& visit) {
  for (const TypedBeside& kept : step.reading.kept) visit(kept.source);
  for (const Operand& operand : step.reading.operands) {
    if (!operand.expression.is_reference()) continue;
    const std::string source = split_step(operand.expression.references().front().path).first;
    for (const auto& [own, theirs] : inputs_made_for(*operand.leaf.field))
      visit(std::string(source).append(".").append(theirs));
  }
  const auto sources = sources_of(step.reading);
  if (sources.empty()) return;
  for (const FieldInfo& field : step.calculator->input->fields) {
    for (const ComparedKeys& compared : keys_in_sources(field)) {
      for (const std::string& key : listed_keys(compared.keys)) visit_in(sources, split_condition(key).second, visit);
    }
  }
}

}  // namespace loadpath::project
