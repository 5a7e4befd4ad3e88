#include "lib/export/unit_name.hpp"

#include "lib/quantity/literal.hpp"

#include <algorithm>
#include <array>

namespace loadpath::exports {

std::string unit_name(const Dimension& dimension) {
  constexpr std::array words{"N", "Pa", "N*m", "W", "N/m"};
  static const auto units = [&] {
    std::array<Dimension, words.size()> dimensions;
    std::transform(words.begin(), words.end(), dimensions.begin(),
                   [](auto word) { return parse_unit(word)->dimension; });
    return dimensions;
  }();
  const auto found = std::find(units.begin(), units.end(), dimension);
  return found == units.end() ? si_unit(dimension) : words[static_cast<std::size_t>(found - units.begin())];
}

}  // namespace loadpath::exports
