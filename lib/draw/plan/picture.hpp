// One plan drawn into a part of the page.
#pragma once

#include "lib/draw/canvas/canvas.hpp"
#include "lib/draw/canvas/labels.hpp"

#include <string>

namespace loadpath::draw {

/// The position and the scales of a plan.
struct PlanFit {
  double scale = 1.0;   // view units per unit of the vectors
  double newton = 0.0;  // view units per newton of the forces at points
  Point origin;         // position of the pole
  Box area;             // title, plan and scale bars

  [[nodiscard]] Point at(Point p) const { return {origin.x + scale * p.x, origin.y - scale * p.y}; }
};

/// The largest plan in a panel at `corner`, with room for its names.
PlanFit fit(const figure::Plan& plan, Point corner, double width, double most_height);

/// Whether a vector and its name are parts of a picture that a script can find.
enum class Findable { no, yes };

void draw_plan(Canvas& canvas, const figure::Plan& plan, const PlanFit& fit, Findable findable = Findable::no);
/// The bars at the foot of the panel.
void draw_plan_scales(Canvas& canvas, const figure::Plan& plan, const PlanFit& fit);

/// For screen readers.
std::string description(const figure::Plan& plan);

}  // namespace loadpath::draw
