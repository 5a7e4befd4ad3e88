#include "lib/calculator.hpp"

#include <algorithm>

namespace loadpath {

const Calculator* find_calculator(Catalogue catalogue, std::string_view id) {
  const auto found = std::find_if(catalogue.begin(), catalogue.end(), [&](const Calculator* c) { return c->id == id; });
  return found == catalogue.end() ? nullptr : *found;
}

}  // namespace loadpath
