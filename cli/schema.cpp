#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "lib/export/json.hpp"

#include <iostream>

namespace loadpath::cli {

int schema() {
  std::cout << exports::project_schema(calculators());
  return passed;
}

}  // namespace loadpath::cli
