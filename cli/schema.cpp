#include <iostream>

#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "lib/io/json.hpp"

namespace loadpath::cli {

int schema() {
  std::cout << io::project_schema(catalogue());
  return passed;
}

}  // namespace loadpath::cli
