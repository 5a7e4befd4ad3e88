#include "lib/project/references/sources.hpp"

#include "lib/project/project.hpp"

#include <map>
#include <set>

namespace loadpath::project {

std::vector<Source> sources_of(const Reading& reading) {
  std::map<std::string, std::set<std::string>> places;
  for (const Operand& operand : reading.operands) {
    for (const auto& reference : operand.expression.references()) {
      const auto [step, path] = split_step(reference.path);
      if (step == "values") continue;
      std::set<std::string>& named = places[step];
      const std::size_t open = path.find('['), close = path.find(']');
      if (open < close && close != std::string::npos) named.insert(path.substr(open + 1, close - open - 1));
      if (path.ends_with("_out")) named.insert("");  // behind the last place
    }
  }
  std::vector<Source> sources;
  for (const auto& [step, named] : places) {
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

const char* keys_in_sources(const FieldInfo& field) {
  for (const char* keys : {field.same_as_source, field.most_of_source, field.least_of_source})
    if (*keys != '\0') return keys;
  return "";
}

void for_each_compared(const StepInput& step, const std::function<void(const std::string& path)>& visit) {
  for (const TypedBeside& kept : step.reading.kept) visit(kept.source);
  const auto sources = sources_of(step.reading);
  if (sources.empty()) return;
  for (const FieldInfo& field : step.calculator->input->fields) {
    for (const std::string& key : listed_keys(keys_in_sources(field))) {
      for (const Source& source : sources) {
        for (const Source& place : alternatives(source)) {
          const std::string path = path_in(place, key);
          if (!path.empty()) visit(path);
        }
      }
    }
  }
}

}  // namespace loadpath::project
