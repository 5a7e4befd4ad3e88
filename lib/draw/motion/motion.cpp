#include "lib/draw/motion/motion.hpp"

#include "lib/draw/canvas/svg_writer.hpp"
#include "lib/draw/motion/data.hpp"
#include "lib/draw/scheme/picture.hpp"
#include "lib/text/issue.hpp"

namespace loadpath::draw {
namespace {

constexpr double plan_width = 260.0, plan_height = 240.0, plan_room = 32.0, plan_bar = 28.0;

figure::Plan plan_at(const figure::Motion& motion, const figure::Motion::LinkPlan& of, std::size_t frame) {
  figure::Plan plan{"", "N", {}};
  Point end;
  for (const auto& side : of.sides) {
    const Point next = end + side.sense * motion.forces[side.force].values[frame];
    plan.vectors.push_back({end, next, side.label, side.tone});
    end = next;
  }
  return plan;
}

Box extent(const figure::Motion& motion, const figure::Motion::LinkPlan& of, std::size_t frame) {
  Box box;
  Point end;
  for (const auto& side : of.sides) {
    end = end + side.sense * motion.forces[side.force].values[frame];
    box.include({end.x, end.y, end.x, end.y});
  }
  return box;
}

/// One scale for all frames; the polygon is centred in each frame.
PlanFit plan_fit(const figure::Motion& motion, const figure::Motion::LinkPlan& plan) {
  double width = 1e-300, height = 1e-300;
  for (std::size_t k = 0; k < motion.axis.si.size(); ++k) {
    const Box box = extent(motion, plan, k);
    width = std::max(width, box.width()), height = std::max(height, box.height());
  }
  PlanFit fit;
  fit.scale = std::min((plan_width - 2.0 * plan_room) / width, (plan_height - 2.0 * plan_room) / height);
  const Point centre = extent(motion, plan, motion.shown).centre();
  fit.origin = Point{0.5 * plan_width, 0.5 * plan_height} - fit.scale * Point{centre.x, -centre.y};
  fit.area = {0.0, 0.0, plan_width, plan_height + plan_bar};
  return fit;
}

std::string plan_picture(const figure::Motion& motion, const std::vector<PlanFit>& fits) {
  Canvas canvas;
  std::string words;
  for (std::size_t k = 0; k < fits.size(); ++k) {
    const figure::Plan plan = plan_at(motion, motion.plans[k], motion.shown);
    const bool shown = k == motion.shown_plan;
    canvas.begin_group({{"data-plan", std::to_string(k)}, {"visibility", shown ? "visible" : "hidden"}});
    draw_plan(canvas, plan, fits[k], Findable::yes);
    draw_plan_scales(canvas, plan, fits[k]);
    canvas.end_group();
    if (shown) words = description(plan);
  }
  const std::string title = say("Force plan of the link {1}", plain(motion.plans[motion.shown_plan].link)).text();
  return svg_part({std::move(canvas), plan_height + plan_bar, words, plan_width}, title);
}

}  // namespace

MotionPictures motion_pictures(const figure::Figure& figure) {
  const auto& motion = std::get<figure::Motion>(figure.content);
  const Fit placed = fit(motion);
  const Picture drawn = SchemePicture(motion.still, placed, &motion).drawn();
  std::vector<PlanFit> fits;
  for (const auto& plan : motion.plans) fits.push_back(plan_fit(motion, plan));
  MotionPictures out;
  out.scheme = svg_part(drawn, say(figure.caption).text());
  if (!fits.empty()) out.plan = plan_picture(motion, fits);
  out.data = motion_data(motion, placed, fits);
  return out;
}

}  // namespace loadpath::draw
