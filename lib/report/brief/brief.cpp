#include "lib/report/brief/brief.hpp"

#include "lib/draw/page.hpp"
#include "lib/report/brief/derivations.hpp"
#include "lib/report/brief/fields.hpp"
#include "lib/report/brief/figures.hpp"
#include "lib/report/brief/filling.hpp"
#include "lib/report/brief/governing.hpp"
#include "lib/report/brief/heights.hpp"
#include "lib/report/brief/inputs.hpp"
#include "lib/report/brief/lists.hpp"
#include "lib/report/brief/names.hpp"
#include "lib/report/brief/results.hpp"
#include "lib/report/brief/sizes.hpp"
#include "lib/report/columns.hpp"
#include "lib/report/numbers/numbers.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace loadpath::report {

namespace {

using project::Project;

constexpr double half = 84.0, other_half = 87.0, narrow = 66.0, wide = 105.0;  // shares of the grid, mm
constexpr double first_page = 266.0, title_height = 47.0;                      // with the verdict below the title, mm
constexpr double size_line = 3.5, sizes_heading = 17.0;                        // of the table of sizes, mm
constexpr std::size_t most_modes = 10;

/// A band of one column over the whole width.
Band across(Panel panel) { return {{1.0, {std::move(panel)}}}; }

/// Builds the pages from one set of choices.
class Pages {
 public:
  Pages(const Project& project, const Summary& summary)
      : project_(project),
        summary_(summary),
        rows_(governing_modes(project, summary, most_modes)),
        main_(main_figures(project, summary)),
        further_(further_figures(project, summary, main_)),
        shafts_(other_shafts(project, summary, main_)) {}

  Brief all();

 private:
  [[nodiscard]] bool is_short() const;
  Page deciding();
  Page checking();
  Band inputs_and_diagrams();
  Band inputs_in_columns();
  void add_diagrams(Page& page);
  bool takes(const Panel& panel);
  void add_recomputing(std::vector<Page>& pages);
  void add_derivations(double height, Page& page) const;
  [[nodiscard]] Panel sizes(std::size_t most_lines) const;
  [[nodiscard]] Panel modes() const;
  [[nodiscard]] Band fields(double room);
  [[nodiscard]] bool is_figure_high() const;
  [[nodiscard]] double figures_height() const;
  [[nodiscard]] bool is_figure_compact() const;
  void add_main(double room, Page& page);
  void add_figure(const StepFigure& figure, bool whole, Panel& panel);
  void name_shaft(const StepFigure& figure, Panel& panel) const;
  void add_lists(const project::Step& step, Page& page);
  void add_shafts(Page& page);
  [[nodiscard]] const project::Step* main_step() const { return main_.empty() ? nullptr : main_.back().step; }

  const Project& project_;
  const Summary& summary_;
  std::vector<Governing> rows_;
  std::vector<StepFigure> main_, further_, shafts_;  // shafts_: those that are not yet on a page
  ShownFigures shown_;
  std::vector<Panel> lists_left_;     // those of page 3
  std::optional<Panel> assumptions_;  // where page 1 has no room for them
  double rest_ = 0.0;                 // height left on the page, mm
  bool are_diagrams_shown_ = false;   // on page 1
};

/// Whether one page holds all: a step of which few formulas govern.
bool Pages::is_short() const {
  constexpr double unlimited = 1e6, most_height = 60.0;  // mm
  if (project_.steps.size() != 1) return false;
  double height = 0.0;
  for (const Panel& panel : governing_derivations(project_, rows_, unlimited).panels) {
    for (const Block& block : panel.blocks) {
      if (const auto* const lines = std::get_if<Derivation>(&block)) height += height_of(*lines);
    }
  }
  return height > 0.0 && height <= most_height;
}

void Pages::add_figure(const StepFigure& figure, bool whole, Panel& panel) {
  figure::Figure shown = whole ? marked(figure) : in_brief(outlined(project_, marked(figure), *figure.step));
  name_step(project_, figure, shown);
  panel.blocks.emplace_back(std::move(shown));
  if (whole || is_brief(*figure.figure)) shown_.insert(figure.figure);
}

Panel Pages::sizes(std::size_t most_lines) const {
  Panel panel{has_sizes(project_) ? say("Chosen sizes") : say("Main results"), {}, {}};
  Table table = sizes_table(project_, summary_, most_lines);
  if (!table.rows.empty()) panel.blocks.emplace_back(std::move(table));
  return panel;
}

Panel Pages::modes() const {
  return {say("Governing failure modes"),
          share_shown(summary_, rows_.size()),
          {governing_table(project_, rows_, titles_fit(project_, summary_))}};
}

/// Where there are several shafts, the caption on page 1 says which it is, and why.
void Pages::name_shaft(const StepFigure& figure, Panel& panel) const {
  if (shafts_.empty() || !has_diagrams(*figure.figure)) return;
  auto& shown = std::get<figure::Figure>(panel.blocks.back());
  shown.caption = say("{1} with its loads and bearing reactions: of {2} shafts the one with the highest utilisation; "
                      "the others follow",
                      capitalised(component_name(*figure.step)), std::to_string(shafts_.size() + 1))
                      .text();
}

/// The shafts that are not on page 1, two in a row, as far as the page has room.
void Pages::add_shafts(Page& page) {
  constexpr double of_row = 52.0, heading = 8.0;  // mm
  while (!shafts_.empty() && rest_ >= of_row + heading) {
    Band band;
    for (const double share : {half, other_half}) {
      if (shafts_.empty()) break;
      const StepFigure figure = shafts_.front();
      shafts_.erase(shafts_.begin());
      Panel panel{say("{1}", capitalised(component_name(*figure.step))), {}, {}};
      add_figure(figure, false, panel);
      band.push_back({share, {std::move(panel)}});
    }
    rest_ -= of_row + heading;
    page.bands.push_back(std::move(band));
  }
}

/// Whether the style sheet gives the figure of page 1 more height: where the table of sizes is short.
bool Pages::is_figure_high() const {
  constexpr std::size_t most_rows = 10, most_lines = 40;
  return !is_figure_compact() && !is_short() && sizes_table(project_, summary_, most_lines).rows.size() <= most_rows;
}

/// What the figures of page 1 take, as the style sheet limits them.
double Pages::figures_height() const {
  constexpr double of_one = 69.0, of_several = 78.0, higher = 10.0;
  if (main_.empty()) return 0.0;
  if (main_.size() == 1 && is_figure_high()) return of_one + higher;
  return main_.size() > 1 ? of_several : of_one;
}

/// Whether page 1 has a single figure, about as high as wide. It would be too small in the width of the page: the table
/// of sizes is set at its side.
bool Pages::is_figure_compact() const { return main_.size() == 1 && is_compact(*main_.front().figure); }

/// Figures, sizes and governing modes, in a height.
void Pages::add_main(double room, Page& page) {
  constexpr double least_lines = 8.0;
  constexpr std::size_t most_next = 3;
  Band figures;
  for (const StepFigure& figure : main_) {
    Panel panel;
    add_figure(figure, false, panel);
    if (main_.size() == 1) see_from_end(std::get<figure::Figure>(panel.blocks.back()));
    name_shaft(figure, panel);
    figures.push_back({figures.empty() ? half : other_half, {std::move(panel)}});
  }
  Panel governing = modes();
  Panel chosen = sizes(static_cast<std::size_t>(std::max(least_lines, (room - sizes_heading) / size_line)));
  const bool has_sizes = !chosen.blocks.empty(), has_modes = !rows_.empty();
  if (has_sizes) {
    const bool below_modes = has_modes && height_of(governing, wide) < height_of(chosen, narrow);
    for (Block& note : next_size_notes(summary_, most_next))
      (below_modes ? governing : chosen).blocks.push_back(std::move(note));
  }
  if (has_sizes && is_figure_compact()) {
    figures.push_back({other_half, {std::move(chosen)}});
    page.bands.push_back(std::move(figures));
    if (has_modes) page.bands.push_back(across(std::move(governing)));
    return;
  }
  if (!figures.empty()) page.bands.push_back(std::move(figures));
  Band band;
  if (has_sizes) band.push_back({narrow, {std::move(chosen)}});
  if (has_modes) band.push_back({wide, {std::move(governing)}});
  if (!band.empty()) page.bands.push_back(std::move(band));
}

/// What is not decided, in a height. The assumptions are in the column with more room; if it has too little, below.
Band Pages::fields(double room) {
  Band all{{half, {outside_scope(summary_), not_assessed(summary_)}},
           {other_half, {accepted_by_user(summary_, project_), not_considered(summary_)}}};
  const double left = height_of({all[0]}), right = height_of({all[1]});
  Stack& shorter = left <= right ? all[0] : all[1];
  Panel assumed = assumptions(project_);
  if (std::min(left, right) + height_of(assumed, shorter.share) <= room || is_short())
    shorter.panels.push_back(std::move(assumed));
  else
    assumptions_ = std::move(assumed);
  return all;
}

Page Pages::deciding() {
  constexpr double most_sizes = 88.0;  // mm
  Page page;
  page.is_numbered = false;
  const double room = first_page - title_height - figures_height();
  const auto lines = static_cast<double>(fewest_lines(project_, summary_));
  const double needed = is_figure_compact() ? 0.0 : std::min(most_sizes, sizes_heading + size_line * lines);
  Band undecided = fields(room - std::max(height_of(modes(), wide), needed));
  add_main(room - height_of(undecided), page);
  rest_ = room - height_of(undecided) - std::max(height_of(modes(), wide), needed);
  page.bands.push_back(std::move(undecided));
  const double of_estimates = is_figure_high() ? 25.0 : 8.0;  // mm; estimated heights are above the real ones
  if (assumptions_ && height_of(*assumptions_, half + other_half) <= rest_ + of_estimates) {
    rest_ -= height_of(*assumptions_, half + other_half);
    page.bands.push_back(across(std::move(*assumptions_)));
    assumptions_.reset();
  }
  if (!is_short()) add_diagrams(page);
  return page;
}

/// Two diagrams side by side at the foot of page 1, where few modes and fields would leave it half empty.
void Pages::add_diagrams(Page& page) {
  // Compact figures are lower than the most that they may take; a single diagram is wider, thus higher.
  constexpr double of_two = 60.0, of_one = 65.0, lower = 30.0;  // mm
  const double room = rest_ + (is_figure_compact() ? lower : 0.0);
  if (further_.empty() || has_diagrams(*further_.front().figure) || room < (further_.size() > 1 ? of_two : of_one))
    return;
  const std::size_t count = std::min<std::size_t>(2, further_.size());
  Band band;
  for (std::size_t i = 0; i < count; ++i) {
    Panel panel{i == 0 ? say("Diagrams") : Message(), {}, {}};
    add_figure(further_[i], true, panel);
    band.push_back({i == 0 ? half : other_half, {std::move(panel)}});
  }
  further_.erase(further_.begin(), further_.begin() + static_cast<std::ptrdiff_t>(count));
  page.bands.push_back(std::move(band));
  are_diagrams_shown_ = true;
}

/// The inputs in two columns, where page 1 has all diagrams.
Band Pages::inputs_in_columns() {
  constexpr double of_column = 135.0;  // mm
  Panel left{say("Input data"), {}, {inputs_table(project_, rows_, 2.0 * of_column)}};
  Panel right{say("Input data, continued"), {}, {std::get<Table>(left.blocks.front())}};
  auto& first = std::get<Table>(left.blocks.front()).rows;
  auto& second = std::get<Table>(right.blocks.front()).rows;
  second.clear();
  while (!first.empty() && height_of(left, half) > height_of(right, other_half)) {
    second.insert(second.begin(), first.back());
    first.pop_back();
  }
  Band band{{half, {std::move(left)}}};
  if (!second.empty()) band.push_back({other_half, {std::move(right)}});
  rest_ = page_height - height_of(band);
  return band;
}

/// Inputs at the left, at the right the diagrams.
Band Pages::inputs_and_diagrams() {
  constexpr double next_to_others = 128.0, alone = 90.0, heading = 8.0, caption = 10.0;  // mm
  if (are_diagrams_shown_ && further_.empty()) return inputs_in_columns();
  const bool has_tall = !further_.empty() && has_diagrams(*further_.front().figure);
  const std::size_t per_row = has_tall ? 1 : 2;
  const double height = has_tall ? heading + other_half * draw::proportion(*further_.front().figure) + caption
                        : further_.size() > 1 ? next_to_others
                                              : alone;
  Panel inputs{say("Input data"), {}, {inputs_table(project_, rows_, height)}};
  Panel figures{say("Diagrams"), {}, {}};
  for (std::size_t i = 0; i < std::min(per_row, further_.size()); ++i) add_figure(further_[i], true, figures);
  constexpr double of_estimates = 10.0;  // mm; the height of a shaft with its diagrams is no estimate
  rest_ = page_height - height + (has_tall ? of_estimates : 0.0);
  Band band{{half, {std::move(inputs)}}};
  if (!figures.blocks.empty()) band.push_back({other_half, {std::move(figures)}});
  return band;
}

/// Takes the height of a table, if there is as much left on the page.
bool Pages::takes(const Panel& panel) {
  const double height = height_of_table(panel);
  if (height > rest_) return false;
  rest_ -= height;
  return true;
}

void Pages::add_lists(const project::Step& step, Page& page) {
  Lists lists = lists_of(project_, step, summary_, rows_, rest_);
  for (Panel& panel : lists.checking) {
    rest_ -= height_of_table(panel);
    page.bands.push_back(across(std::move(panel)));
  }
  lists_left_ = std::move(lists.recomputing);
}

Page Pages::checking() {
  constexpr std::size_t most_results = 40;
  Page page;
  page.bands.push_back(inputs_and_diagrams());
  if (assumptions_) {
    rest_ -= height_of(*assumptions_, half + other_half);
    page.bands.push_back(across(std::move(*assumptions_)));
  }
  if (const project::Step* const step = main_step()) add_lists(*step, page);
  add_shafts(page);
  std::vector<Panel> results = result_panels(project_, summary_, main_step(), most_results);
  for (std::size_t i = 0; i < results.size(); i += 2) {
    const bool has_two = i + 1 < results.size();
    const auto rows = [&](std::size_t k) { return std::get<Table>(results[k].blocks.front()).rows.size(); };
    if (!takes(results[has_two && rows(i + 1) > rows(i) ? i + 1 : i])) continue;
    Band band{{half, {std::move(results[i])}}};
    if (has_two) band.push_back({other_half, {std::move(results[i + 1])}});
    page.bands.push_back(std::move(band));
  }
  return page;
}

constexpr double real_share = 0.94;  // of the estimated height of lines, at most

void Pages::add_derivations(double height, Page& page) const {
  constexpr double heading = 8.0;  // mm
  Derivations derivations = governing_derivations(project_, rows_, height - of_sources);
  for (Panel& panel : derivations.panels) page.bands.push_back(across(std::move(panel)));
  Table sources = fitting(citations(derivations.sources), height - real_share * derivations.height - heading);
  if (!sources.rows.empty())
    page.bands.push_back(
        across({say("References"), say("named on this page; all sources: appendix"), {std::move(sources)}}));
}

/// After the shafts and the lists for which page 2 had no room. Derivations begin on page 2 if it is half empty, or if
/// all fit there.
void Pages::add_recomputing(std::vector<Page>& pages) {
  constexpr double half_empty = 0.38 * page_height, reserve = 12.0;  // mm
  const double left = shafts_.empty() && lists_left_.empty() ? rest_ : 0.0;
  rest_ = page_height;
  Page page, derived;
  add_shafts(page);
  for (Panel& list : lists_left_) {
    rest_ -= height_of_table(list);
    page.bands.push_back(across(std::move(list)));
  }
  add_derivations(rest_, derived);
  double all = 0.0;
  for (const Band& band : derived.bands) all += height_of_lines(band);
  const double free = real_share * all + reserve <= left ? all : left >= half_empty ? left : 0.0;
  double used = 0.0;
  for (Band& band : derived.bands) {
    used += height_of_lines(band);
    const bool fits = page.bands.empty() && used <= free;
    (fits ? pages.back() : page).bands.push_back(std::move(band));
  }
  if (!page.bands.empty()) pages.push_back(std::move(page));
}

/// The contents of the appendix, at the end of the last page.
Band appendix_note() {
  const Message contents =
      say("Appendix of the full report: all failure modes, load path, inputs, formulas and results of every step, "
          "references.");
  return across({{}, {}, {Paragraph{contents, Paragraph::Tone::note}}});
}

Brief Pages::all() {
  constexpr double rest_of_page = 110.0, lower = 30.0, reserve = 8.0;  // mm; compact figures are lower than the most
  std::vector<Page> pages{deciding()};
  const double free = rest_ + (is_figure_compact() ? lower : 0.0) - reserve;
  if (is_short()) {
    add_derivations(rest_of_page, pages.front());
  } else {
    pages.push_back(checking());
    add_recomputing(pages);
    if (project_.steps.size() == 1 && !are_diagrams_shown_) fill_first(free, pages);
  }
  pages.back().bands.push_back(appendix_note());
  return {std::move(pages), std::move(shown_)};
}

}  // namespace

Brief brief_of(const Project& project, const Summary& summary) { return Pages(project, summary).all(); }

}  // namespace loadpath::report
