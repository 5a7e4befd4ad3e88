#include "lib/report/brief/lists.hpp"

#include "lib/report/brief/derivations.hpp"
#include "lib/report/brief/heights.hpp"
#include "lib/report/brief/results.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace loadpath::report {

namespace {

constexpr std::size_t every_row = std::numeric_limits<std::size_t>::max();

/// As many lists as the height has room for, each whole or with `most` rows that matter most.
std::vector<Panel> in_height(const std::vector<Panel>& lists, double height, std::size_t most) {
  constexpr std::size_t fewest = 5;
  std::vector<Panel> taken;
  for (const Panel& list : lists) {
    const auto& table = std::get<Table>(list.blocks.front());
    for (std::size_t rows = std::min(most, table.rows.size()); rows >= fewest; --rows) {
      Panel part = list;
      part.blocks.front() = most_utilised_rows(table, rows);
      if (height_of_table(part) > height) continue;
      height -= height_of_table(part);
      taken.push_back(std::move(part));
      break;
    }
  }
  return taken;
}

double height_of_tables(const std::vector<Panel>& panels) {
  double height = 0.0;
  for (const Panel& panel : panels) height += height_of_table(panel);
  return height;
}

/// The list that governs, the loads, and the other lists, as far as the height has room.
std::vector<Panel> with_loads(const std::vector<Panel>& lists, const std::vector<Panel>& loads, double height) {
  std::vector<Panel> all = in_height({lists.front()}, height, every_row);
  for (const Panel& load : loads) {
    if (height_of_tables(all) + height_of_table(load) <= height) all.push_back(load);
  }
  const auto others = in_height({lists.begin() + 1, lists.end()}, height - height_of_tables(all), every_row);
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

}  // namespace

Lists lists_of(const project::Project& project, const project::Step& step, const Summary& summary,
               const std::vector<Governing>& rows, double room) {
  constexpr std::size_t most_rows = 6;
  const auto [apart, joined] = list_panels(step, summary.modes);
  const std::vector<Panel> loads = load_panels(step);
  if (apart.empty()) return {in_height(loads, room, every_row), {}};
  std::vector<Panel> page = with_loads(apart, loads, room);
  const bool has_all = page.size() == apart.size() + loads.size();
  if (apart.size() == joined.size() || has_all) return {std::move(page), {}};
  const std::vector<Panel> further = in_height({apart.begin() + 1, apart.end()}, page_height, most_rows);
  const bool has_room = keeps_lines(project, rows, page_height - of_sources, height_of_tables(further));
  if (has_room) return {with_loads({apart.front()}, loads, room), further};
  return {with_loads(joined, loads, room), {}};
}

}  // namespace loadpath::report
