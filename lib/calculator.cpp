#include "lib/calculator.hpp"

#include <algorithm>

namespace loadpath {

const Calculator* find_calculator(Catalogue catalogue, std::string_view id) {
  const auto found = std::find_if(catalogue.begin(), catalogue.end(), [&](const Calculator* c) { return c->id == id; });
  return found == catalogue.end() ? nullptr : *found;
}

const Template* find_template(const Calculator& calculator, std::string_view id) {
  const auto& all = calculator.templates;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Template* t) { return t->id == id; });
  return found == all.end() ? nullptr : *found;
}

}  // namespace loadpath
