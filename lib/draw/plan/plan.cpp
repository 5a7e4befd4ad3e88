// Plans side by side.
#include "lib/draw/canvas/picture.hpp"
#include "lib/draw/plan/picture.hpp"

namespace loadpath::draw {
namespace {

bool drawable(const figure::Plan& plan) {
  const auto whole = [](const figure::Plan::Vector& v) { return draw::drawable(v.from) && draw::drawable(v.to); };
  const auto drawn = [](const figure::Plan::Trace& t) {
    return std::all_of(t.points.begin(), t.points.end(), [](Point p) { return draw::drawable(p); });
  };
  return std::all_of(plan.vectors.begin(), plan.vectors.end(), whole) &&
         std::all_of(plan.traces.begin(), plan.traces.end(), drawn);
}

}  // namespace

Picture picture(const figure::Plans& plans) {
  constexpr double alone = 330.0, in_row = 210.0, gap = 8.0;
  const std::size_t columns = plans.panels.size() > 1 ? 2 : 1;
  const double width = (view_width - gap * static_cast<double>(columns - 1)) / static_cast<double>(columns);
  Picture out;
  double row_end = 0.0;
  for (std::size_t n = 0; n < plans.panels.size(); ++n) {
    const figure::Plan& plan = plans.panels[n];
    if (n % columns == 0) out.height = row_end + (n == 0 ? 0.0 : gap);
    const double left = static_cast<double>(n % columns) * (width + gap);
    const PlanFit placed = fit(plan, {left, out.height}, width, columns == 1 ? alone : in_row);
    if (drawable(plan)) draw_plan(out.canvas, plan, placed), draw_plan_scales(out.canvas, plan, placed);
    row_end = std::max(row_end, placed.area.bottom);
    out.description += (n == 0 ? "" : ". ") + description(plan);
  }
  out.height = std::max(row_end, 20.0);
  return out;
}

}  // namespace loadpath::draw
