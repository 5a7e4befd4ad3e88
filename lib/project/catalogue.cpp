#include "lib/project/catalogue.hpp"

#include <algorithm>

namespace loadpath::project {

const CatalogueEntry* find_entry(Catalogue catalogue, std::string_view id) {
  const auto found =
      std::find_if(catalogue.begin(), catalogue.end(), [&](const CatalogueEntry& e) { return e.calculator->id == id; });
  return found == catalogue.end() ? nullptr : &*found;
}

Message calculator_meant(const std::string& id, const std::vector<std::string>& ids) {
  const std::size_t point = id.find('.');
  const std::string element = point == std::string::npos ? "" : id.substr(0, point + 1);
  std::vector<std::string> own;  // names behind the element
  for (const std::string& known : ids) {
    if (!element.empty() && known.starts_with(element)) own.push_back(known.substr(element.size()));
  }
  if (own.empty()) return did_you_mean(id, ids, say("`loadpath list` shows all"));
  return did_you_mean(id.substr(element.size()), own, say("`loadpath list {1}` shows all", id.substr(0, point)),
                      element);
}

}  // namespace loadpath::project
