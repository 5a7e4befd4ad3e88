#include "lib/report/brief/filling.hpp"

#include "lib/report/brief/derivations.hpp"
#include "lib/report/brief/heights.hpp"
#include "lib/report/brief/names.hpp"
#include "lib/report/columns.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <string_view>
#include <utility>

namespace loadpath::report {

namespace {

/// With figures, as the style sheet limits them. A single stack is as wide as the page.
double full_height(const Band& band) {
  constexpr double of_figure = 75.0;  // mm
  if (band.size() == 1 && band.front().panels.size() == 1) return height_of_lines(band);
  double highest = 0.0;
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

/// Of a source, which is as wide as the page.
double source_height(const std::vector<Cell>& row) {
  constexpr double letters_in_line = 105.0, of_line = 3.3, gap = 0.9;  // mm
  return gap + of_line * std::ceil(letters_of(std::get<std::string>(row.back())) / letters_in_line);
}

std::size_t rows_that_fit(const Table& sources, double height) {
  std::size_t count = 0;
  for (const auto& row : sources.rows) {
    height -= source_height(row);
    if (height < 0.0) break;
    ++count;
  }
  return count;
}

/// The first "; " that is not within brackets; npos if there is none.
std::size_t remark_of(const std::string& source) {
  int open = 0;
  for (std::size_t i = 0; i + 1 < source.size(); ++i) {
    if (source[i] == '(') ++open;
    if (source[i] == ')') --open;
    if (open == 0 && source.compare(i, 2, "; ") == 0) return i;
  }
  return std::string::npos;
}

/// "DIN 6892:2012: Parallel keys, method C" of a source with what was taken from it, which the appendix has. That it
/// was not checked against the source stays.
std::string without_remarks(const std::string& source) {
  constexpr std::string_view warning = "not checked against";
  const std::size_t end = remark_of(source);
  if (end == std::string::npos) return source;
  const std::string kept = source.substr(0, end);
  const std::size_t clause = source.find(warning, end);
  if (clause == std::string::npos || kept.find(warning) != std::string::npos) return kept;
  return kept + " (" + source.substr(clause, source.find_first_of(".,;)", clause) - clause) + ")";
}

}  // namespace

double height_of_lines(const Band& band) {
  constexpr double below = 1.0, heading = 8.0;  // mm
  const Panel& panel = band.front().panels.front();
  const auto* const sources = panel.blocks.empty() ? nullptr : std::get_if<Table>(&panel.blocks.front());
  if (sources != nullptr && sources->head.empty()) {
    return std::accumulate(sources->rows.begin(), sources->rows.end(), heading,
                           [](double height, const auto& row) { return height + source_height(row); });
  }
  double height = 0.0;
  for (const Block& block : panel.blocks) {
    if (const auto* const lines = std::get_if<Derivation>(&block)) height += below + height_of(*lines);
  }
  return height + height_of(panel, page_width);
}

Table fitting(Table sources, double height) {
  if (rows_that_fit(sources, height) < sources.rows.size()) {
    for (auto& row : sources.rows) row.back() = without_remarks(std::get<std::string>(row.back()));
  }
  sources.rows.resize(rows_that_fit(sources, height));
  for (auto& row : sources.rows) row.back() = with_greek(std::get<std::string>(row.back()));
  sources.caption = {};
  return sources;
}

void fill_first(double free, std::vector<Page>& pages) {
  std::vector<Band>& next = pages[1].bands;
  auto end = next.begin();
  for (; end != next.end() && full_height(*end) <= free; ++end) free -= full_height(*end);
  const bool moves_all = end == next.end(), has_third = pages.size() > 2;
  if (has_third && !moves_all) {
    // Otherwise page 2 would be the emptier.
    double rest = 0.0;
    for (auto band = end; band != next.end(); ++band) rest += full_height(*band);
    for (const Band& band : pages[2].bands) rest += full_height(band);
    if (pages.size() > 3 || rest > page_height) return;
    const auto moved = end - next.begin();
    std::ranges::move(pages[2].bands, std::back_inserter(next));
    pages.pop_back();
    end = next.begin() + moved;
  }
  std::move(next.begin(), end, std::back_inserter(pages.front().bands));
  next.erase(next.begin(), end);
  if (next.empty()) pages.erase(pages.begin() + 1);
}

}  // namespace loadpath::report
