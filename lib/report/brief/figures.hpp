// The figures of the first pages: the part that decides, and the diagrams below it.
#pragma once

#include "lib/figure/figure.hpp"
#include "lib/report/summary/summary.hpp"

#include <vector>

namespace loadpath::report {

struct StepFigure {
  const project::Step* step;
  const figure::Figure* figure;
};

/// Page 1: the mechanism, if there is one, and the drawn part with the highest utilisation, a shaft before others
/// unless a column governs.
/// Without a drawing, the first curve of the part that governs.
std::vector<StepFigure> main_figures(const project::Project& project, const Summary& summary);
/// Page 2: the diagrams of the main part, then further drawings and curves by falling utilisation.
std::vector<StepFigure> further_figures(const project::Project& project, const Summary& summary,
                                        const std::vector<StepFigure>& main);

/// The drawn shafts that are not on page 1, by falling utilisation.
std::vector<StepFigure> other_shafts(const project::Project& project, const Summary& summary,
                                     const std::vector<StepFigure>& main);

/// Where figures of several steps have the same caption, each names its step.
void name_step(const project::Project& project, const StepFigure& figure, figure::Figure& shown);

/// A figure with marks at the diameters that a search has found.
figure::Figure marked(const StepFigure& figure);
/// A shaft with the widths and outer diameters of its bearings, out of the steps that assess them.
figure::Figure outlined(const project::Project& project, figure::Figure figure, const project::Step& step);
/// A figure as a file of its own shows it: a shaft with marks, hubs, bearings and diagrams.
figure::Figure in_file(const project::Project& project, const StepFigure& figure);
/// A figure as page 1 shows it: a shaft without its diagrams, of several views those in the first row.
figure::Figure in_brief(const figure::Figure& figure);
/// A shaft that has the width of the page gets an end view.
void see_from_end(figure::Figure& figure);
/// Whether page 1 shows all of it.
bool is_brief(const figure::Figure& figure);
/// Whether it is about as high as wide: a mechanism, or a drawn part other than a shaft.
bool is_compact(const figure::Figure& figure);
/// Whether it is a shaft with diagrams, which is narrow and tall.
bool has_diagrams(const figure::Figure& figure);

}  // namespace loadpath::report
