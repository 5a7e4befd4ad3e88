#include "calculators/catalogue.hpp"
#include "cli/catalogue/not_included.hpp"
#include "cli/commands.hpp"
#include "cli/describe/field.hpp"
#include "cli/describe/full.hpp"
#include "cli/describe/rows.hpp"
#include "cli/describe/short.hpp"
#include "cli/describe/templates.hpp"
#include "lib/export/json_catalogue.hpp"
#include "lib/project/catalogue.hpp"

#include <iostream>

namespace loadpath::cli {

namespace {

int refuse(const std::string& id, const Message& hint) {
  std::cerr << "loadpath: unknown calculator '" << id << "'\n  = help: " << hint.text() << "\n";
  return wrong_input;
}

/// The remedy for an unknown id: what is not included, the calculators of an element, the one of this name, or the
/// nearest id.
Message remedy(const std::string& id) {
  std::vector<std::string> ids, own;
  for (const Calculator* known : calculators()) {
    ids.emplace_back(known->id);
    if (known->element() == id) own.emplace_back(known->id);
    if (std::string_view(known->id).ends_with("." + id)) return say("did you mean '{1}'?", known->id);
    for (const Template* t : known->templates) ids.push_back(std::string(known->id) + "." + t->id);
  }
  if (const auto subjects = not_included(id.substr(0, id.find('.')), true); own.empty() && !subjects.empty())
    return say("not included: {1}", subjects.front()->what);
  if (!own.empty()) return say("'{1}' is an element; `loadpath describe` takes one of {2}", id, joined(own));
  return project::calculator_meant(id, ids);
}

/// "mechanism.planar.slider_crank": false where there is none of that name.
bool describe_template(const DescribeOptions& options, const std::string& id) {
  const Calculator* calculator = nullptr;
  const Template* const t = template_of(id, calculator);
  if (t == nullptr) return false;
  if (options.toml)
    std::cout << t->example;
  else
    show_template(*calculator, *t);
  return true;
}

/// A part, a field, a mode or a template; "rules" of fatigue.life is a part and an input.
int describe_part(const DescribeOptions& options, const Calculator& calculator, const std::string& name) {
  const bool is_part = show_part(calculator, name), is_field = show_field(calculator, name);
  if (is_part || is_field || describe_template(options, std::string(calculator.id) + "." + name)) return passed;
  return refuse_field(calculator, name);
}

int describe_calculator(const DescribeOptions& options, const Calculator& calculator, const std::string& part) {
  if (options.json)
    std::cout << exports::json_of(calculator);
  else if (options.toml)
    std::cout << calculator.example;
  else if (!part.empty())
    return describe_part(options, calculator, part);
  else if (options.full)
    show_in_full(calculator);
  else
    std::cout << short_form(calculator);
  return passed;
}

}  // namespace

int describe(const DescribeOptions& options) {
  const Calculator* whole = find_calculator(calculators(), options.id);
  const std::string id = whole != nullptr || options.name.empty() ? options.id : options.id + "." + options.name;
  const std::string part = whole != nullptr ? options.name : options.part;
  const Calculator* c = find_calculator(calculators(), id);
  if (c == nullptr) return describe_template(options, id) ? passed : refuse(id, remedy(id));
  return describe_calculator(options, *c, part);
}

}  // namespace loadpath::cli
