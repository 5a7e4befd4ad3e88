#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "lib/report/terminal/terminal.hpp"

#include <algorithm>
#include <iostream>

namespace loadpath::cli {

namespace {

int refuse(const std::string& word) {
  std::vector<std::string> elements;
  for (const Calculator* c : calculators()) {
    if (elements.empty() || elements.back() != c->element()) elements.emplace_back(c->element());
  }
  std::cerr << "loadpath: there is no element '" << word
            << "'\n  = help: " << did_you_mean(word, elements, there_is(elements)).text() << "\n";
  return wrong_input;
}

}  // namespace

int list(const ListOptions& options) {
  std::vector<std::vector<std::string>> rows;
  for (const Calculator* c : calculators()) {
    if (options.element.empty() || c->element() == options.element) rows.push_back({c->id, c->title});
  }
  if (rows.empty()) return refuse(options.element);
  std::cout << terminal::columns(rows) << "\n"
            << terminal::paragraph(
                   "`loadpath describe ID` tells the fields, sources and limits of one, with an example that runs.");
  return passed;
}

}  // namespace loadpath::cli
