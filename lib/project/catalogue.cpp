#include "lib/project/catalogue.hpp"

#include <algorithm>

namespace loadpath::project {

const CatalogueEntry* find_entry(Catalogue catalogue, std::string_view id) {
  const auto found =
      std::find_if(catalogue.begin(), catalogue.end(), [&](const CatalogueEntry& e) { return e.calculator->id == id; });
  return found == catalogue.end() ? nullptr : &*found;
}

}  // namespace loadpath::project
