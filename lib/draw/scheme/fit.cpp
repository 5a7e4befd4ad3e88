#include "lib/draw/scheme/fit.hpp"

#include <limits>

namespace loadpath::draw {
namespace {

constexpr double margin = 4.0, scale_bars = 34.0, least_height = 110.0, most_height = 400.0;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A point of the mechanism and the room around it, in view units, for its sign and label.
struct Sign {
  Point at;
  double room = 0.0;
};

template <class Items>
Items with_place(const Items& items) {
  Items kept;
  for (const auto& item : items) {
    if (drawable(item.at)) kept.push_back(item);
  }
  return kept;
}

std::vector<Point> drawable_points(const std::vector<Point>& points) {
  std::vector<Point> kept;
  for (const Point p : points) {
    if (drawable(p)) kept.push_back(p);
  }
  return kept;
}

std::vector<Sign> signs(const figure::Scheme& scheme) {
  std::vector<Sign> all;
  const auto add = [&](const std::vector<Point>& points, double room) {
    for (const Point p : points) all.push_back({p, room});
  };
  for (const auto& body : scheme.bodies) add(body.points, 12.0);
  for (const auto& path : scheme.paths) add(path.points, 2.0);
  for (const auto& guide : scheme.guides) add({guide.from, guide.to}, 8.0);
  for (const auto& joint : scheme.joints) all.push_back({joint.at, joint.fixed ? 28.0 : 24.0});
  for (const auto& point : scheme.points) all.push_back({point.at, 22.0});
  for (const auto& moment : scheme.moments) all.push_back({moment.at, 40.0});
  for (const auto& arrow : scheme.arrows) all.push_back({arrow.at, 4.0});
  for (const auto& rack : scheme.racks) add({rack.from, rack.to}, 14.0);
  for (const auto& outline : scheme.outlines) add(outline.points, 4.0);
  for (const auto& spring : scheme.springs) add({spring.from, spring.to}, 12.0);
  for (const auto& coil : scheme.coils) all.push_back({coil.at, 24.0});
  for (const auto& wheel : scheme.wheels) {
    const double r = std::fabs(wheel.radius);
    for (const Point corner : {Point{r, 0.0}, Point{-r, 0.0}, Point{0.0, r}, Point{0.0, -r}})
      all.push_back({wheel.at + corner, 4.0});
  }
  return all;
}

Box extent(const std::vector<Sign>& signs, double scale) {
  Box box{infinite, infinite, -infinite, -infinite};
  for (const Sign& s : signs) box.include(Box::around({scale * s.at.x, -scale * s.at.y}, 2.0 * s.room, 2.0 * s.room));
  return box;
}

double extent_in_metres(const std::vector<Sign>& signs) {
  Box box{infinite, infinite, -infinite, -infinite};
  for (const Sign& s : signs) box.include({s.at.x, s.at.y, s.at.x, s.at.y});
  const double size = std::max(box.width(), box.height());
  return size > 1e-100 ? size : 1.0;
}

double largest_scale(const std::vector<Sign>& signs, double first) {
  double low = 0.0, high = first;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    const Box box = extent(signs, middle);
    const bool fits = box.width() <= view_width - 2.0 * margin && box.height() <= most_height - 2.0 * margin;
    (fits ? low : high) = middle;
  }
  return low;
}

}  // namespace

figure::Scheme without_gaps(const figure::Scheme& scheme) {
  figure::Scheme kept;
  for (const auto& body : scheme.bodies) kept.bodies.push_back({body.name, drawable_points(body.points)});
  for (const auto& path : scheme.paths)
    kept.paths.push_back({path.name, drawable_points(path.points), drawable_points(path.positions)});
  for (const auto& guide : scheme.guides) {
    if (drawable(guide.from) && drawable(guide.to)) kept.guides.push_back(guide);
  }
  for (const auto& arrow : with_place(scheme.arrows)) {
    if (drawable(arrow.force) && length(arrow.force) > 1e-100) kept.arrows.push_back(arrow);
  }
  for (const auto& moment : with_place(scheme.moments)) {
    if (drawable(moment.value) && moment.value != 0.0) kept.moments.push_back(moment);
  }
  kept.joints = with_place(scheme.joints);
  kept.points = with_place(scheme.points);
  for (const auto& wheel : with_place(scheme.wheels)) {
    if (drawable(wheel.radius)) kept.wheels.push_back(wheel);
  }
  for (const auto& outline : with_place(scheme.outlines)) {
    kept.outlines.push_back({outline.at, drawable_points(outline.points), outline.fixed});
  }
  for (const auto& belt : scheme.belts) {
    if (drawable(belt.from) && drawable(belt.to)) kept.belts.push_back(belt);
  }
  for (const auto& rack : scheme.racks) {
    if (drawable(rack.from) && drawable(rack.to)) kept.racks.push_back(rack);
  }
  for (const auto& spring : scheme.springs) {
    if (drawable(spring.from) && drawable(spring.to)) kept.springs.push_back(spring);
  }
  kept.coils = with_place(scheme.coils);
  return kept;
}

namespace {

/// The corners of all signs that have the same room: as good as all of them, and few.
std::vector<Sign> corners(const std::vector<Sign>& signs) {
  std::vector<std::pair<double, Box>> boxes;
  for (const Sign& s : signs) {
    const Box at{s.at.x, s.at.y, s.at.x, s.at.y};
    const auto same = std::find_if(boxes.begin(), boxes.end(), [&](const auto& b) { return b.first == s.room; });
    same == boxes.end() ? boxes.push_back({s.room, at}) : same->second.include(at);
  }
  std::vector<Sign> kept;
  for (const auto& [room, box] : boxes) {
    kept.push_back({{box.left, box.top}, room});
    kept.push_back({{box.right, box.bottom}, room});
  }
  return kept;
}

/// The largest arrow takes a fixed share of the drawing.
constexpr double arrow_share = 0.25;

Fit fit(std::vector<Sign> all, const std::vector<figure::Scheme::Arrow>& arrows) {
  if (all.empty()) return {1.0, 1.0, {}, least_height};
  const double size = extent_in_metres(all);
  double strongest = 0.0;
  for (const auto& arrow : arrows) strongest = std::max(strongest, length(arrow.force));
  const double metres_per_newton = strongest > 0.0 ? arrow_share * size / strongest : 0.0;
  for (const auto& arrow : arrows) all.push_back({arrow.at + metres_per_newton * arrow.force, 24.0});
  all = corners(all);

  Fit result;
  result.scale = largest_scale(all, view_width / size);
  result.newton = metres_per_newton * result.scale;
  const Box box = extent(all, result.scale);
  const double drawing = std::max(box.height() + 2.0 * margin, least_height);
  result.origin = Point{0.5 * view_width, 0.5 * drawing} - box.centre();
  result.height = drawing + scale_bars;
  return result;
}

/// A point of the still scheme at another frame.
Point moved(const figure::Motion& motion, figure::Motion::Carried by, Point at, std::size_t frame) {
  if (by.place < 0) return at;
  const auto& poses = motion.links[static_cast<std::size_t>(by.place)].poses;
  const figure::Motion::Pose &from = poses[motion.shown], &to = poses[frame];
  const Point arm = at - from.at, e = along(to.phi - from.phi);
  return to.at + Point{e.x * arm.x - e.y * arm.y, e.y * arm.x + e.x * arm.y};
}

}  // namespace

Fit fit(const figure::Scheme& scheme) { return fit(signs(scheme), scheme.arrows); }

Fit fit(const figure::Motion& motion) {
  std::vector<Sign> all = signs(motion.still);
  std::vector<figure::Scheme::Arrow> arrows;
  const figure::Scheme& still = motion.still;
  for (std::size_t k = 0; k < motion.axis.si.size(); ++k) {
    const auto add = [&](figure::Motion::Carried by, Point at, double room) {
      all.push_back({moved(motion, by, at, k), room});
    };
    for (std::size_t n = 0; n < still.bodies.size(); ++n) {
      for (const Point p : still.bodies[n].points) add({static_cast<int>(n), -1}, p, 12.0);
    }
    for (std::size_t n = 0; n < still.joints.size(); ++n) add(motion.joints[n], still.joints[n].at, 24.0);
    for (std::size_t n = 0; n < still.guides.size(); ++n) {
      for (const Point p : {still.guides[n].from, still.guides[n].to}) add(motion.guides[n], p, 3.0);
    }
    for (std::size_t n = 0; n < still.outlines.size(); ++n) {
      for (const Point p : still.outlines[n].points) add(motion.outlines[n], p, 4.0);
    }
    for (std::size_t n = 0; n < motion.still.arrows.size(); ++n) {
      const auto& force = motion.forces[n];
      const Point at =
          force.places.empty() ? moved(motion, force.carried, motion.still.arrows[n].at, k) : force.places[k];
      arrows.push_back({at, force.values[k], "", false});
    }
  }
  return fit(all, arrows);
}

}  // namespace loadpath::draw
