#include "lib/quantity/format.hpp"
#include "lib/report/appendix.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace loadpath::report {

namespace {

/// The rows of one field over the elements of a list that pass.
struct Passing {
  std::size_t count = 0;
  std::size_t most = 0;  // for utilisations, the row with the largest
  double low = 0.0, high = 0.0;
  bool is_told = false;
};

/// "sections[2].u_v" and "sections.pulley.u_v" -> "sections.u_v"; empty if it is not a field of an element.
std::string field_of(const std::string& path) {
  const std::size_t first = path.find_first_of("[."), last = path.rfind('.');
  return first == std::string::npos || last <= first ? "" : path.substr(0, first) + path.substr(last);
}

const Quantity* passed_value(const Verdict& row) {
  return row.state == State::pass ? std::get_if<Quantity>(&row.value) : nullptr;
}

Verdict one_of(const Verdict& largest, const Passing& all) {
  Verdict row = largest;
  const std::string count = std::to_string(all.count);
  row.note = row.note.empty() ? say("largest of {1}", count) : say("{1}; largest of {2}", row.note, count);
  return row;
}

Verdict range_of(const Verdict& limit, const std::string& field, const Passing& all) {
  Verdict row = limit;
  row.symbol = field;
  row.note = say("all {1}", std::to_string(all.count));
  const std::string& unit = std::get<Quantity>(limit.value).unit;
  if (all.low < all.high) {
    const std::string low = format_quantity(all.low, unit, 4), high = format_quantity(all.high, unit, 4);
    if (low != high) row.value = say("{1} to {2}", low, high);
  }
  return row;
}

}  // namespace

std::vector<Verdict> folded(const std::vector<Verdict>& rows) {
  std::map<std::string, Passing> fields;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string field = field_of(rows[i].symbol);
    const Quantity* const value = passed_value(rows[i]);
    if (field.empty() || value == nullptr) continue;
    Passing& all = fields[field];
    if (all.count++ == 0) all = {1, i, value->si, value->si};
    if (value->si > std::get<Quantity>(rows[all.most].value).si) all.most = i;
    all.low = std::min(all.low, value->si), all.high = std::max(all.high, value->si);
  }
  constexpr std::size_t many = 3;
  std::vector<Verdict> kept;
  for (const Verdict& row : rows) {
    const auto found = fields.find(field_of(row.symbol));
    if (passed_value(row) == nullptr || found == fields.end() || found->second.count < many) {
      kept.push_back(row);
      continue;
    }
    Passing& all = found->second;
    if (std::exchange(all.is_told, true)) continue;
    kept.push_back(row.utilisation ? one_of(rows[all.most], all) : range_of(row, found->first, all));
  }
  return kept;
}

}  // namespace loadpath::report
