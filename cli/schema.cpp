#include "cli/commands.hpp"
#include "lib/text/embedded.hpp"

#include <iostream>

namespace loadpath::cli {

int schema() {
  std::cout << embedded::schema().front().text;
  return passed;
}

}  // namespace loadpath::cli
