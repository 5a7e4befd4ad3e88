#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "lib/report/terminal/terminal.hpp"

#include <iostream>

namespace loadpath::cli {

int list() {
  std::vector<std::vector<std::string>> rows;
  for (const Calculator* c : calculators()) rows.push_back({c->id, c->title});
  std::cout << terminal::columns(rows)
            << "\n`loadpath describe ID` tells the fields, sources and limits of one, with an example that runs.\n";
  return passed;
}

}  // namespace loadpath::cli
