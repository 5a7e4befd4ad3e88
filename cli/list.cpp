#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "lib/export/json_catalogue.hpp"
#include "lib/report/terminal/terminal.hpp"

#include <algorithm>
#include <iostream>
#include <string_view>

namespace loadpath::cli {

namespace {

int refuse(const std::string& word) {
  std::vector<std::string> elements;
  for (const Calculator* c : calculators()) {
    if (elements.empty() || elements.back() != c->element()) elements.emplace_back(c->element());
  }
  if (const Calculator* const named = find_calculator(calculators(), word)) {
    std::cerr << "loadpath: '" << word << "' is a calculator of '" << named->element()
              << "'\n  = help: `loadpath describe " << word << "` tells all of it, `loadpath list " << named->element()
              << "` those beside it\n";
    return wrong_input;
  }
  for (const std::string_view beyond :
       {"bolt", "screw", "rivet", "weld", "spring", "clutch", "brake", "coupling", "seal"}) {
    if (word.find(beyond) == std::string::npos) continue;
    std::cerr << "loadpath: there is no calculator of a " << beyond << "\n  = help: " << there_is(elements).text()
              << "\n";
    return wrong_input;
  }
  std::cerr << "loadpath: there is no element '" << word
            << "'\n  = help: " << did_you_mean(word, elements, there_is(elements)).text() << "\n";
  return wrong_input;
}

}  // namespace

int list(const ListOptions& options) {
  std::vector<const Calculator*> chosen;
  for (const Calculator* c : calculators()) {
    if (options.element.empty() || c->element() == options.element) chosen.push_back(c);
  }
  if (chosen.empty()) return refuse(options.element);
  if (options.json) {
    std::cout << exports::json_of(Calculators(chosen));
    return passed;
  }
  std::vector<std::vector<std::string>> rows;
  rows.reserve(chosen.size());
  for (const Calculator* c : chosen) rows.push_back({c->id, c->title});
  std::cout << terminal::columns(rows) << "\n"
            << terminal::paragraph(
                   "`loadpath describe ID` tells the fields, sources and limits of one, with an example that runs.");
  return passed;
}

}  // namespace loadpath::cli
