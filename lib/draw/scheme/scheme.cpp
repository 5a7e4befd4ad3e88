#include "lib/draw/canvas/thin.hpp"
#include "lib/draw/scheme/parts.hpp"
#include "lib/draw/scheme/picture.hpp"

#include <array>

namespace loadpath::draw {

std::vector<Point> SchemePicture::outline(const figure::Scheme::Body& body) const {
  std::vector<Point> points;
  for (const Point p : body.points) points.push_back(at(p));
  return convex_hull(points);
}

void SchemePicture::draw_guides() {
  for (std::size_t n = 0; n < scheme_.guides.size(); ++n) {
    const auto& guide = scheme_.guides[n];
    Point from = at(guide.from), to = at(guide.to);
    if (from.x > to.x) std::swap(from, to);
    if (guide.fixed && carries_block(guide)) {
      const Point below = (0.5 * block_width + 1.0) * across(unit(to - from));
      from = from + below, to = to + below;
    }
    carried(carrier(&figure::Motion::guides, n), guide.from, [&, from = from, to = to] {
      canvas_.line(guide.fixed ? "outline" : "rail", from, to);
      if (guide.fixed) hatch(canvas_, from, to);
    });
    labels_.keep_off({from, to}, guide.fixed ? 5.0 : 2.0);
  }
}

void SchemePicture::draw_paths() {
  for (const auto& path : scheme_.paths) {
    std::vector<Point> points;
    for (const Point p : path.points) points.push_back(at(p));
    points = thin(points);
    canvas_.polyline("light dash", points);
    for (const Point p : path.positions) canvas_.circle("dot", at(p), 1.7);
    labels_.keep_off(points, 1.0, 0.1);
  }
}

void SchemePicture::draw_bodies() {
  for (std::size_t k = 0; k < scheme_.bodies.size(); ++k) {
    std::vector<Point> points = outline(scheme_.bodies[k]);
    if (points.size() < 2) continue;
    const int link = static_cast<int>(k);
    carried({link, link}, scheme_.bodies[k].points.front(),
            [&] { points.size() == 2 ? canvas_.line("bar", points[0], points[1]) : canvas_.polygon("plate", points); });
    if (points.size() > 2) points.push_back(points.front());
    labels_.keep_off(points, 3.0);
  }
}

/// Downwards, or the side that is freest of links and forces.
Point SchemePicture::support_direction(const figure::Scheme::Joint& joint) const {
  struct Side {
    Point direction;
    double reluctance;
  };
  constexpr std::array<Side, 4> sides{{{{0, 1}, 0.0}, {{1, 0}, 0.3}, {{-1, 0}, 0.3}, {{0, -1}, 0.4}}};
  std::vector<Point> taken;
  const auto take = [&](Point to) {
    if (length(to - at(joint.at)) > 1.0) taken.push_back(unit(to - at(joint.at)));
  };
  for (const auto& body : scheme_.bodies) {
    const bool joined = std::any_of(body.points.begin(), body.points.end(),
                                    [&](Point p) { return length(at(p) - at(joint.at)) < 1.0; });
    for (const Point p : body.points) joined ? take(at(p)) : void();
  }
  for (const auto& arrow : scheme_.arrows) {
    if (length(at(arrow.at) - at(joint.at)) < 1.0) take(fit_.tip(arrow));
  }
  Point best{0.0, 1.0};
  double most = -1e9;
  for (const Side& side : sides) {
    double nearest = 1.2;  // wider than this is free enough
    for (const Point t : taken) nearest = std::min(nearest, std::acos(std::clamp(dot(t, side.direction), -1.0, 1.0)));
    if (nearest - side.reluctance > most) most = nearest - side.reluctance, best = side.direction;
  }
  return best;
}

void SchemePicture::draw_supports() {
  for (std::size_t n = 0; n < scheme_.joints.size(); ++n) {
    const auto& joint = scheme_.joints[n];
    if (joint.pin == figure::Scheme::Pin::slider) {
      carried(carrier(&figure::Motion::joints, n), joint.at, [&] { draw_block(joint); });
    } else if (joint.pin == figure::Scheme::Pin::welded) {
      carried(carrier(&figure::Motion::joints, n), joint.at, [&] { draw_weld(joint); });
    } else if (joint.fixed) {
      const Point direction = support_direction(joint);
      support(canvas_, at(joint.at), direction);
      labels_.keep_off(Box::around(at(joint.at) + 13.0 * direction, 26.0, 26.0));
    }
  }
}

bool SchemePicture::lies_on(Point p, const figure::Scheme::Guide& guide) const {
  return std::fabs(cross(unit(at(guide.to) - at(guide.from)), at(p) - at(guide.from))) < 1.0;
}

bool SchemePicture::carries_block(const figure::Scheme::Guide& guide) const {
  return std::any_of(scheme_.joints.begin(), scheme_.joints.end(), [&](const figure::Scheme::Joint& joint) {
    return joint.pin == figure::Scheme::Pin::slider && lies_on(joint.at, guide);
  });
}

void SchemePicture::draw_block(const figure::Scheme::Joint& joint) {
  const double angle = std::isfinite(joint.angle) ? joint.angle : 0.0;
  Point direction{std::cos(angle), -std::sin(angle)};
  if (direction.x < 0.0) direction = -1.0 * direction;
  const Point centre = at(joint.at);
  const auto corners = block(centre, direction);
  const bool guided =
      std::any_of(scheme_.guides.begin(), scheme_.guides.end(),
                  [&](const figure::Scheme::Guide& guide) { return guide.fixed && lies_on(joint.at, guide); });
  if (joint.fixed && !guided) {
    const Point below = centre + (0.5 * block_width + 1.0) * across(direction), half = 1.3 * block_length * direction;
    canvas_.line("outline", below - half, below + half);
    hatch(canvas_, below - half, below + half);
    labels_.keep_off({below - half, below + half}, 6.0);
  }
  canvas_.polygon("pin", corners);
  labels_.keep_off({corners[0], corners[1], corners[2], corners[3], corners[0]}, 2.0);
}

void SchemePicture::draw_pins() {
  for (std::size_t n = 0; n < scheme_.joints.size(); ++n) {
    const auto& joint = scheme_.joints[n];
    const figure::Motion::Carried by{carrier(&figure::Motion::joints, n).place, -1};
    if (joint.pin == figure::Scheme::Pin::revolute)
      carried(by, joint.at, [&] { canvas_.circle("pin", at(joint.at), pin_radius); });
    labels_.keep_off(Box::around(at(joint.at), 2.0 * pin_radius, 2.0 * pin_radius));
  }
  for (std::size_t n = 0; n < scheme_.points.size(); ++n) {
    const Point place = scheme_.points[n].at;
    carried(carrier(&figure::Motion::points, n), place, [&] { canvas_.circle("solid", at(place), 3.0); });
    labels_.keep_off(Box::around(at(place), 7.0, 7.0));
  }
}

/// The direction free for the arc of a couple: at the support of its joint.
Point SchemePicture::couple_opening(Point p) const {
  for (const auto& joint : scheme_.joints) {
    const bool supported = joint.fixed && joint.pin == figure::Scheme::Pin::revolute;
    if (supported && length(at(joint.at) - at(p)) < 1.0) return support_direction(joint);
  }
  return {0.0, 1.0};
}

void SchemePicture::draw_forces() {
  for (std::size_t n = 0; n < scheme_.arrows.size(); ++n) {
    const auto& a = scheme_.arrows[n];
    force_group("data-force", n, [&] { arrow(canvas_, a.load ? 1 : 0, at(a.at), fit_.tip(a)); });
    labels_.keep_off({at(a.at), fit_.tip(a)}, 3.0);
  }
}

void SchemePicture::draw_couples() {
  for (std::size_t n = 0; n < scheme_.moments.size(); ++n) {
    const auto& moment = scheme_.moments[n];
    const Point centre = at(moment.at), opening = couple_opening(moment.at);
    if (motion_ == nullptr) {
      couple(canvas_, centre, opening, moment.value > 0.0);
    } else {  // both directions occur, one is shown
      const std::string place = text_of(motion_->couples[n].carried, centre);
      for (const bool positive : {true, false}) {
        const bool shown = positive == (moment.value > 0.0);
        canvas_.begin_group({{"data-couple", std::to_string(n) + (positive ? " +" : " -")},
                             {"data-carried", place},
                             {"visibility", shown ? "visible" : "hidden"}});
        couple(canvas_, centre, opening, positive);
        canvas_.end_group();
      }
    }
    labels_.keep_off(ring(centre, couple_radius), 2.0);
  }
}

Picture SchemePicture::drawn() {
  draw_guides();
  draw_paths();
  draw_belts();
  draw_racks();
  draw_outlines();
  draw_wheels();
  draw_springs();
  draw_bodies();
  draw_supports();
  draw_forces();
  draw_couples();
  draw_pins();
  label_moments();
  label_points();
  label_forces();
  label_bodies();
  label_springs();
  draw_scales();
  return {std::move(canvas_), fit_.height, description()};
}

Picture picture(const figure::Scheme& scheme) {
  const figure::Scheme kept = without_gaps(scheme);
  return SchemePicture(kept, fit(kept)).drawn();
}

Picture picture(const figure::Motion& motion) { return picture(motion.still); }

}  // namespace loadpath::draw
