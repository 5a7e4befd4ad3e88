#include "lib/quantity/format.hpp"
#include "lib/quantity/unit.hpp"
#include "lib/table/table.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::table {

namespace {

constexpr double rounding = 1e-12;  // relative, of a computed size

}  // namespace

Outcome<double> at_or_above(const Series& series, double number) {
  const auto& members = series.members;
  const auto found = std::lower_bound(members.begin(), members.end(), number * (1.0 - rounding));
  if (!std::isnan(number) && found != members.end()) return *found;
  const auto text = [&](double x) { return format_exact(x) + " " + pretty_unit(series.unit); };
  return Fault{0, 1, say("no size of {1} is {2} or more", series.name, text(number)),
               say("the largest is {1}", text(members.back()))};
}

std::vector<double> members_in_si(const Series& series) {
  const auto unit = read_unit(series.unit, 0);
  std::vector<double> si;
  for (const double member : series.members) si.push_back(unit->to_si(member));
  return si;
}

}  // namespace loadpath::table
