#include "lib/quantity/literal.hpp"
#include "lib/table/own/own.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace loadpath::table {

namespace {

const std::vector<std::string> series_keys{"title", "unit", "sizes", "source"};

}  // namespace

void OwnReader::read_series(const Tree::Entry& entry) {
  const std::string key = "tables.series." + entry.key;
  Series series;
  series.table = "own/series";
  series.name = entry.key;
  series.sources = {read_source(entry.value, entry.place, key)};
  for (const Tree::Entry& e : entry.value.entries) {
    if (e.key == "title") series.title = text_of(e, key + ".title");
    if (e.key == "unit") read_unit_of(e, key, series);
    if (e.key == "sizes") series.members = read_members(e.value, key + ".sizes");
    if (std::find(series_keys.begin(), series_keys.end(), e.key) == series_keys.end())
      complain(e.place, key, say("unknown key '{1}'", e.key), did_you_mean(e.key, series_keys, there_is(series_keys)));
  }
  for (const char* needed : {"unit", "sizes"}) {
    if (entry.value.find(needed) == nullptr)
      complain(entry.place, key, say("'{1}' is missing", needed), say("write unit = \"mm\", sizes = [20, 25, 32]"));
  }
  add_series(std::move(series), entry.place, key);
}

/// Sizes to choose from are lengths.
void OwnReader::read_unit_of(const Tree::Entry& entry, const std::string& key, Series& series) {
  series.unit = text_of(entry, key + ".unit");
  if (series.unit.empty()) return;
  const auto unit = parse_unit(series.unit);
  if (!unit) return complain(entry.value.place, key + ".unit", unit.fault().message, unit.fault().hint);
  if (unit->dimension == Dimension::of(1, 0, 0)) return;
  complain(entry.value.place, key + ".unit", say("sizes are lengths, not a {1}", name_of(unit->dimension)),
           say("write a unit like mm or in"));
}

std::vector<double> OwnReader::read_members(const Tree& tree, const std::string& key) {
  std::vector<double> members;
  for (const Tree& item : tree.items) {
    if (item.type == Tree::Type::number && std::isfinite(item.number)) members.push_back(item.number);
  }
  const bool numbers = tree.type == Tree::Type::array && !members.empty() && members.size() == tree.items.size();
  if (!numbers) {
    complain(tree.place, key, say("'{1}' must be an array of numbers", "sizes"),
             say("they are in 'unit': sizes = [20, 25, 32]"));
  } else if (members[0] <= 0.0 || !std::is_sorted(members.begin(), members.end(), std::less_equal<>{})) {
    complain(tree.place, key, say("sizes must be positive and ascending"));
  }
  return members;
}

}  // namespace loadpath::table
