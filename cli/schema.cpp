#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "lib/io/json.hpp"

#include <iostream>

namespace loadpath::cli {

int schema() {
  std::cout << io::project_schema(catalogue());
  return passed;
}

}  // namespace loadpath::cli
