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

/// With figures, as the style sheet limits them.
double full_height(const Band& band) {
  constexpr double of_figure = 75.0;  // mm
  double highest = std::max(height_of_lines(band), height_of(band));
  for (const Stack& stack : band) {
    double height = 0.0;
    for (const Panel& panel : stack.panels) {
      height += height_of(panel, stack.share);
      height += of_figure * static_cast<double>(std::ranges::count_if(panel.blocks, [](const Block& block) {
                  return std::holds_alternative<figure::Figure>(block);
                }));
    }
    highest = std::max(highest, height);
  }
  return highest;
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

void refill(double free, std::vector<Page>& pages) {
  constexpr double page_height = 252.0;  // mm
  std::vector<Band> bands;
  for (std::size_t i = 1; i < pages.size(); ++i) std::ranges::move(pages[i].bands, std::back_inserter(bands));
  pages.resize(1);
  for (Band& band : bands) {
    const double height = full_height(band);
    if (height > free) {
      pages.emplace_back();
      free = page_height;
    }
    free -= height;
    pages.back().bands.push_back(std::move(band));
  }
}

}  // namespace loadpath::report
