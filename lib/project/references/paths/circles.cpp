#include "lib/project/references/paths/circles.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

Message of_input(const Step& step, const std::string& input, const std::string& source, const Place& place) {
  const std::string name = step.name() + "." + input;
  return place.line > 0 ? say("{1} takes {2} (line {3})", name, source, std::to_string(place.line))
                        : say("{1} takes {2}", name, source);
}

bool is_part_of(const std::string& path, const std::string& whole) {
  return path == whole || path.starts_with(whole + ".") || path.starts_with(whole + "[");
}

}  // namespace

Message how_taken(const Step& step, const std::string& path) {
  const Reading& reading = step.input().reading;
  for (const auto* all : {&reading.records, &reading.taken}) {
    for (const Taken& taken : *all) {
      if (!taken.of_record && is_part_of(path, taken.source))
        return of_input(step, taken.path, taken.source, taken.place);
    }
  }
  const auto names = [&](const Expression::Reference& reference) { return reference.path == path; };
  for (const auto* all : {&reading.operands, &reading.whole}) {
    for (const Operand& operand : *all) {
      const auto& references = operand.expression.references();
      if (!operand.of_record && std::any_of(references.begin(), references.end(), names))
        return of_input(step, operand.path, path, operand.place);
    }
  }
  return say("{1} takes {2}", step.name(), path);
}

Message row_to_name(const Step& source, const std::string& path) {
  const std::string key = path.substr(std::min(path.size(), source.name().size() + 1));
  const FieldInfo* const field = find_field(source.input().calculator->input->fields, key);
  if (field == nullptr) return {};
  const auto& searches = source.input().reading.searches;
  const auto search = std::find_if(searches.begin(), searches.end(),
                                   [&](const Search& one) { return !one.leaf && one.path == field->provider.table; });
  if (search == searches.end()) return {};
  return say(
      "{1} is of the row that '{2}' searches for: name a row there, {3} = \"...\", or write its sizes as numbers "
      "and search only the rows that have them, {3} = { where = \"{4} = ... {5}\" }",
      path, source.name(), search->path, key, field->unit);
}

}  // namespace loadpath::project
