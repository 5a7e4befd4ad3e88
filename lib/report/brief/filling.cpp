#include "lib/report/brief/filling.hpp"

#include "lib/report/brief/derivations.hpp"
#include "lib/report/brief/heights.hpp"
#include "lib/report/brief/names.hpp"
#include "lib/report/columns.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace loadpath::report {

namespace {

constexpr double page_width = 171.0;  // mm, without the gap between columns

bool has_figure(const Band& band) {
  return std::ranges::any_of(band, [](const Stack& stack) {
    return std::ranges::any_of(stack.panels, [](const Panel& panel) {
      return std::ranges::any_of(panel.blocks,
                                 [](const Block& block) { return std::holds_alternative<figure::Figure>(block); });
    });
  });
}

}  // namespace

double height_of_lines(const Band& band) {
  constexpr double heading = 9.0;  // mm
  double height = 0.0;
  for (const Block& block : band.front().panels.front().blocks) {
    if (const auto* const lines = std::get_if<Derivation>(&block)) height += height_of(*lines);
  }
  return height > 0.0 ? heading + height : height_of(band.front().panels.front(), page_width);
}

Table fitting(Table sources, double height) {
  constexpr double letters_in_line = 105.0, of_line = 3.3, gap = 0.9;  // mm
  std::size_t count = 0;
  for (const auto& row : sources.rows) {
    height -= gap + of_line * std::ceil(letters_of(std::get<std::string>(row.back())) / letters_in_line);
    if (height < 0.0) break;
    ++count;
  }
  sources.rows.resize(count);
  for (auto& row : sources.rows) row.back() = with_greek(std::get<std::string>(row.back()));
  sources.caption = {};
  return sources;
}

void fill_first(double free, std::vector<Page>& pages) {
  std::vector<Band>& next = pages[1].bands;
  std::size_t count = 0;
  for (; count < next.size() && !has_figure(next[count]); ++count) {
    free -= std::max(height_of_lines(next[count]), height_of(next[count]));
    if (free < 0.0) break;
  }
  const auto end = next.begin() + static_cast<std::ptrdiff_t>(count);
  std::move(next.begin(), end, std::back_inserter(pages.front().bands));
  next.erase(next.begin(), end);
  if (next.empty()) pages.pop_back();
}

}  // namespace loadpath::report
