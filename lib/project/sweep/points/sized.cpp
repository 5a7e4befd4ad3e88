#include "lib/project/sweep/points/sized.hpp"

#include "lib/table/rows.hpp"
#include "lib/table/table.hpp"

#include <algorithm>
#include <limits>

namespace loadpath::project {

Sized::Sized(const Provided& provided, std::size_t offset) : field_(provided.path), offset_(offset) {
  for (const auto& value : table::values_by_size(provided.entry, provided.field->provider.column))
    classes_.push_back({value.size_max, value.value.si});
}

bool Sized::is_one(const Provided& provided) {
  return *provided.field->provider.size != '\0' && !table::kind_of(*provided.entry.row, *provided.field) &&
         !table::values_by_size(provided.entry, provided.field->provider.column).empty();
}

double Sized::at(double size) const {
  const auto covering =
      std::find_if(classes_.begin(), classes_.end(), [&](const Class& c) { return size <= c.size_max; });
  return covering == classes_.end() ? std::numeric_limits<double>::quiet_NaN() : covering->si;
}

void Sized::fill(std::span<const double> sizes, std::size_t positions) {
  si_.resize(sizes.size() * positions);
  for (std::size_t point = 0; point < sizes.size(); ++point)
    std::fill_n(si_.begin() + static_cast<std::ptrdiff_t>(point * positions), positions, at(sizes[point]));
}

}  // namespace loadpath::project
