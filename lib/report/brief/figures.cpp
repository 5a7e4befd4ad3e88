#include "lib/report/brief/figures.hpp"

#include "lib/figure/chart.hpp"
#include "lib/figure/drawing.hpp"
#include "lib/report/numbers/numbers.hpp"

#include <algorithm>
#include <cctype>
#include <memory>
#include <string_view>

namespace loadpath::report {

namespace {

using project::Project;
using project::Step;

bool moves(const figure::Figure& figure) { return std::holds_alternative<figure::Motion>(figure.content); }
bool is_mechanism(const figure::Figure& figure) {
  const auto* const scheme = std::get_if<figure::Scheme>(&figure.content);
  return scheme != nullptr && !scheme->bodies.empty();
}
bool is_shaft(const figure::Figure& figure) { return std::holds_alternative<figure::Shaft>(figure.content); }
bool is_part(const figure::Figure& figure) {
  return is_shaft(figure) || std::holds_alternative<figure::Drawn>(figure.content);
}
bool is_curve(const figure::Figure& figure) {
  return std::holds_alternative<figure::Plot>(figure.content) ||
         std::holds_alternative<figure::Charted>(figure.content);
}

/// A column or leg that governs is drawn with its ends and its buckled shape, before any shaft.
bool is_of_column(const Step& step) { return std::string_view(step.input().calculator->id).starts_with("column."); }

/// The steps by falling utilisation of their components.
std::vector<const Step*> by_utilisation(const Project& project, const Summary& summary) {
  std::vector<const Step*> steps;
  for (const auto& step : project.steps) steps.push_back(step.get());
  const auto used = [&](const Step* step) {
    const auto found = std::ranges::find(summary.components, component_name(*step), &Component::name);
    return found == summary.components.end() || !(found->utilisation() >= 0.0) ? -1.0 : found->utilisation();
  };
  std::ranges::stable_sort(steps, [&](const Step* a, const Step* b) { return used(a) > used(b); });
  return steps;
}

template <class Meant>
StepFigure first_of(const std::vector<const Step*>& steps, const Meant& is_meant) {
  for (const Step* step : steps) {
    for (const figure::Figure& figure : step->account().figures) {
      if (is_meant(figure)) return {step, &figure};
    }
  }
  return {nullptr, nullptr};
}

/// Of the diameters of a shaft from left to right, which a search has found.
std::vector<bool> found_diameters(const Step& step) {
  std::vector<bool> found;
  for (const account::Entry& entry : step.account().inputs) {
    const bool is_part = entry.path == "d" || entry.path.starts_with("pieces") || entry.path.starts_with("segments");
    if (is_part && (entry.path == "d" || entry.path.ends_with(".d"))) found.push_back(entry.origin.searched);
  }
  return found;
}

const account::Entry* input_of(const Step& step, std::string_view path) {
  const auto& inputs = step.account().inputs;
  const auto found = std::ranges::find(inputs, path, &account::Entry::path);
  return found == inputs.end() || found->value.si.empty() ? nullptr : &*found;
}

/// "left" of "= shaft.bearings.left.x", "2" of "= shaft.bearings[2].x": the bearing of the shaft that a step assesses.
std::string assessed_bearing(const Step& step, const std::string& shaft) {
  const account::Entry* const x = input_of(step, "x");
  if (x == nullptr) return {};
  const std::string text = x->origin.text.text(), list = "= " + shaft + ".bearings";
  if (!text.starts_with(list) || text.size() == list.size()) return {};
  const std::size_t begin = list.size() + 1;
  return text.substr(begin, text.find_first_of("].", begin) - begin);
}

/// The rows of the bearings, which follow from the loads of the shaft, have their widths and outer diameters.
void outline_bearings(const Project& project, const Step& of, figure::Shaft& shaft) {
  for (const auto& step : project.steps) {
    if (!std::string_view(step->input().calculator->id).starts_with("bearing.")) continue;
    const std::string name = assessed_bearing(*step, of.input().name);
    const auto bearing = std::ranges::find(shaft.bearings, name, &figure::Shaft::Bearing::label);
    const account::Entry* const B = input_of(*step, "B");
    const account::Entry* const D = input_of(*step, "D");
    if (name.empty() || bearing == shaft.bearings.end() || B == nullptr || D == nullptr) continue;
    bearing->outline.width = B->value.si.front(), bearing->outline.diameter = D->value.si.front();
    if (const auto row = step->input().rows.find("bearing"); row != step->input().rows.end())
      bearing->type = row->second.text;
  }
}

/// The views in the first row of a drawing.
std::size_t first_row(const figure::Drawing& drawing) {
  double share = 0.0;
  std::size_t count = 0;
  for (const auto& view : drawing.views) {
    share += view.share;
    if (count > 0 && share > 1.0 + 1e-9) break;
    ++count;
  }
  return count;
}

}  // namespace

std::vector<StepFigure> main_figures(const Project& project, const Summary& summary) {
  const std::vector<const project::Step*> steps = by_utilisation(project, summary);
  std::vector<StepFigure> main;
  StepFigure mechanism = first_of(steps, moves);
  if (mechanism.figure == nullptr) mechanism = first_of(steps, is_mechanism);
  if (mechanism.figure != nullptr) main.push_back(mechanism);
  StepFigure part = first_of(steps, is_part);
  const bool is_column = part.figure != nullptr && is_of_column(*part.step);
  const StepFigure shaft = first_of(steps, is_shaft);
  if (shaft.figure != nullptr && !is_column) part = shaft;
  if (part.figure != nullptr) main.push_back(part);
  if (main.empty()) {
    if (const StepFigure curve = first_of(steps, is_curve); curve.figure != nullptr) main.push_back(curve);
  }
  return main;
}

std::vector<StepFigure> further_figures(const Project& project, const Summary& summary,
                                        const std::vector<StepFigure>& main) {
  std::vector<StepFigure> diagrams, parts, curves;
  for (const project::Step* step : by_utilisation(project, summary)) {
    for (const figure::Figure& figure : step->account().figures) {
      const bool is_main = std::ranges::find(main, &figure, &StepFigure::figure) != main.end();
      const bool is_of_main = std::ranges::find(main, step, &StepFigure::step) != main.end();
      if (is_main && is_brief(figure)) continue;
      if (is_main && has_diagrams(figure))
        diagrams.push_back({step, &figure});
      else if (is_part(figure) && is_brief(figure) && !is_main)
        parts.push_back({step, &figure});
      else if (is_curve(figure))
        curves.insert(is_of_main ? curves.begin() : curves.end(), {step, &figure});
    }
  }
  parts.insert(parts.end(), curves.begin(), curves.end());
  diagrams.insert(diagrams.end(), parts.begin(), parts.end());
  return diagrams;
}

std::vector<StepFigure> other_shafts(const Project& project, const Summary& summary,
                                     const std::vector<StepFigure>& main) {
  std::vector<StepFigure> all;
  for (const project::Step* step : by_utilisation(project, summary)) {
    for (const figure::Figure& figure : step->account().figures) {
      const bool is_main = std::ranges::find(main, &figure, &StepFigure::figure) != main.end();
      if (has_diagrams(figure) && !is_main) all.push_back({step, &figure});
    }
  }
  return all;
}

void name_step(const project::Project& project, const StepFigure& figure, figure::Figure& shown) {
  const auto is_alike = [&](const auto& other) {
    return std::ranges::any_of(other->account().figures, [&](const figure::Figure& of_other) {
      return other.get() != figure.step && of_other.caption == figure.figure->caption;
    });
  };
  if (shown.caption.empty() || std::ranges::none_of(project.steps, is_alike)) return;
  std::string caption = say(shown.caption).text();
  caption.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(caption.front())));
  shown.caption = say("{1}: {2}", capitalised(component_name(*figure.step)), caption).text();
}

figure::Figure marked(const StepFigure& of) {
  figure::Figure figure = *of.figure;
  auto* const shaft = std::get_if<figure::Shaft>(&figure.content);
  if (shaft == nullptr) return figure;
  const std::vector<bool> found = found_diameters(*of.step);
  if (found.size() != shaft->parts.size()) return figure;  // its parts are none of a list
  for (std::size_t i = 0; i < found.size(); ++i) shaft->parts[i].is_sized = found[i];
  return figure;
}

figure::Figure outlined(const Project& project, figure::Figure figure, const project::Step& step) {
  if (auto* const shaft = std::get_if<figure::Shaft>(&figure.content)) outline_bearings(project, step, *shaft);
  return figure;
}

figure::Figure in_file(const Project& project, const StepFigure& of) { return outlined(project, marked(of), *of.step); }

figure::Figure in_brief(const figure::Figure& figure) {
  figure::Figure brief = figure;
  if (auto* const shaft = std::get_if<figure::Shaft>(&brief.content)) {
    if (!shaft->diagrams.empty()) brief.caption = "Shaft with its loads and bearing reactions";
    shaft->diagrams.clear();
    shaft->places.clear();
  }
  constexpr std::string_view of_screen = " and the force polygon of a link";  // on paper there is none
  if (moves(figure) && brief.caption.ends_with(of_screen))
    brief.caption.resize(brief.caption.size() - of_screen.size());
  if (const auto* const drawn = std::get_if<figure::Drawn>(&figure.content)) {
    figure::Drawing drawing = **drawn;
    // "The pair in the transverse plane, and its teeth in mesh": the last view is left out.
    const std::size_t shown = first_row(drawing), last = brief.caption.rfind(", and ");
    if (shown < drawing.views.size() && last != std::string::npos) brief.caption.resize(last);
    drawing.views.resize(shown);
    brief.content = std::make_shared<const figure::Drawing>(std::move(drawing));
  }
  return brief;
}

void see_from_end(figure::Figure& figure) {
  if (auto* const shaft = std::get_if<figure::Shaft>(&figure.content)) shaft->seen_from_end = true;
}

bool is_brief(const figure::Figure& figure) {
  if (const auto* const drawn = std::get_if<figure::Drawn>(&figure.content))
    return first_row(**drawn) == (*drawn)->views.size();
  return !has_diagrams(figure);
}

bool is_compact(const figure::Figure& figure) {
  return moves(figure) || is_mechanism(figure) || std::holds_alternative<figure::Drawn>(figure.content);
}

bool has_diagrams(const figure::Figure& figure) {
  const auto* const shaft = std::get_if<figure::Shaft>(&figure.content);
  return shaft != nullptr && !shaft->diagrams.empty();
}

}  // namespace loadpath::report
