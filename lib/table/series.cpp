#include "lib/quantity/unit.hpp"
#include "lib/table/table.hpp"

namespace loadpath::table {

std::vector<double> members_in_si(const Series& series) {
  const auto unit = read_unit(series.unit, 0);
  std::vector<double> si;
  for (const double member : series.members) si.push_back(unit->to_si(member));
  return si;
}

}  // namespace loadpath::table
