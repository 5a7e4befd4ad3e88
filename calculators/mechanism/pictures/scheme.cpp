#include "calculators/mechanism/pictures/scheme.hpp"

#include "calculators/mechanism/cycle/point_motion.hpp"
#include "calculators/mechanism/cycle/rounding.hpp"
#include "calculators/mechanism/pictures/forces.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar {

namespace {

using figure::Motion;
using figure::Scheme;
using mechanism::JointKind;
using mechanism::Position;
using mechanism::Vec;

bool has_pin(JointKind kind) { return kind == JointKind::revolute || kind == JointKind::rigid; }
bool has_rack(JointKind kind) { return kind == JointKind::rack || kind == JointKind::rolling_on_line; }

/// The points of a link that joints and loads use, each once, in the order of the joints.
std::vector<Vec> used_points(const mechanism::Model& model, const Extents& extents, int link) {
  std::vector<Vec> points;
  const auto add = [&](Vec at) {
    const bool known =
        std::any_of(points.begin(), points.end(), [&](Vec q) { return mechanism::length(q - at) == 0.0; });
    if (!known) points.push_back(at);
  };
  for (const auto& j : model.joints) {
    if (j.i == link) add(j.point_i);
    if (j.j == link && !has_line(j.kind) && !has_rack(j.kind)) add(j.point_j);
  }
  for (std::size_t n = 0; n < model.loads.size(); ++n) {
    if (model.loads[n].link == link && extents.loads_push[n]) add(model.loads[n].point);
  }
  for (const auto& s : model.springs) {
    if (s.kind == mechanism::Spring::Kind::turning) continue;
    if (s.i == link) add(s.point_i);
    if (s.j == link) add(s.point_j);
  }
  return points;
}

class Drawing {
 public:
  Drawing(const mechanism::Model& model, const Position& at, const Extents& extents,
          const std::vector<TracedPoint>& points, Shown shown)
      : model_(model),
        at_(at),
        extents_(extents),
        points_(points),
        moving_(shown == Shown::moving),
        rounding_(rounding_at(at)) {
    for (std::size_t k = 0; k < model.links.size(); ++k) add_body(k);
    for (std::size_t n = 0; n < model.joints.size(); ++n) {
      add_joint(n);
      add_reaction(n);
    }
    for (const mechanism::Spring& spring : model.springs) add_spring(spring);
    for (std::size_t n = 0; n < model.loads.size(); ++n) add_load(n);
    for (const TracedPoint& p : points) add_point(p);
    for (std::size_t d = 0; d < model.drivers.size(); ++d) add_drive(d);
  }
  [[nodiscard]] Motion&& taken() { return std::move(motion_); }

 private:
  Scheme& scheme() { return motion_.still; }

  figure::Point middle_of_body(int link) { return middle_of(scheme().bodies[static_cast<std::size_t>(link)].points); }

  /// From the first point of the links to the farthest.
  double size() {
    double most = 0.0;
    const figure::Point* first = nullptr;
    for (const auto& body : scheme().bodies) {
      for (const auto& p : body.points) {
        if (first == nullptr) first = &p;
        most = std::max(most, std::hypot(p.x - first->x, p.y - first->y));
      }
    }
    return most;
  }

  void add_body(std::size_t k) {
    const int link = static_cast<int>(k);
    Scheme::Body body{model_.links[k].name, {}};
    for (const Vec own : used_points(model_, extents_, link)) body.points.push_back(point(on_paper(at_, link, own)));
    for (const TracedPoint& p : points_) {  // a mass centre may lie anywhere, other points belong to the link's shape
      const bool is_centre = model_.links[k].mass > 0.0 && mechanism::length(p.at - model_.links[k].centre) == 0.0;
      if (p.link == link && !is_centre) body.points.push_back(point(on_paper(at_, link, p.at)));
    }
    scheme().bodies.push_back(std::move(body));
  }

  void add_joint(std::size_t n) {
    const mechanism::Joint& j = model_.joints[n];
    if (has_pin(j.kind) || has_line(j.kind)) add_pin(n);
    if (has_line(j.kind)) add_guide(n);
    if (has_rack(j.kind)) add_rack(j);
    if (j.kind == JointKind::cam) return add_cam(n);
    if (has_pin(j.kind) || has_line(j.kind)) return;
    add_wheel(j.i, j.point_i, j.radius_i);
    if (has_rack(j.kind)) return;
    add_wheel(j.j, j.point_j, j.radius_j);
    if (j.kind == JointKind::belt) {
      scheme().belts.push_back({point(on_paper(at_, j.i, j.point_i)), point(on_paper(at_, j.j, j.point_j)),
                                std::abs(j.radius_i), std::abs(j.radius_j), j.radius_i * j.radius_j < 0.0});
    }
  }

  /// The profile on link j, and what of link i touches it: a roller about a pin, a face.
  void add_cam(std::size_t n) {
    constexpr int corners = 180;
    const mechanism::Joint& j = model_.joints[n];
    const mechanism::Turn turned = mechanism::turn(j.direction);
    Scheme::Outline outline{point(on_paper(at_, j.j, j.point_j)), {}, j.j == mechanism::ground};
    for (int k = 0; k < corners; ++k) {
      const Vec flank = j.profile->flank(2.0 * pi * k / corners);
      outline.points.push_back(point(on_paper(at_, j.j, j.point_j + turned(flank))));
    }
    scheme().outlines.push_back(std::move(outline));
    motion_.outlines.push_back({j.j, j.j});
    if (j.contact == mechanism::CamContact::round) {
      if (j.radius_i > 0.0) add_wheel(j.i, j.point_i, j.radius_i);
      return add_pin(n);
    }
    const Vec along = face_of(j, at_), foot = on_paper(at_, j.i, j.point_i);
    const auto [from, to] = extents_.strokes[n];
    const double margin = 0.3 * (to - from) + 0.05 * size();
    scheme().racks.push_back({point(foot + (from - margin) * along), point(foot + (to + margin) * along), false, true,
                              j.i == mechanism::ground});
    motion_.racks.push_back({j.i, j.i});
  }

  void add_pin(std::size_t n) {
    const mechanism::Joint& j = model_.joints[n];
    const bool slides = has_line(j.kind), cam = j.kind == JointKind::cam;
    const bool fixed = !cam && (j.i == mechanism::ground || j.j == mechanism::ground);
    const Scheme::Pin pin = slides                       ? Scheme::Pin::slider
                            : j.kind == JointKind::rigid ? Scheme::Pin::welded
                                                         : Scheme::Pin::revolute;
    const Vec place = on_paper(at_, j.i, j.point_i);
    const double angle = pin == Scheme::Pin::welded ? angle_between(j, place) : angle_of(at_, j.j) + j.direction;
    scheme().joints.push_back({j.name, point(place), pin, fixed && !slides, angle});
    motion_.joints.push_back({fixed && !slides ? mechanism::ground : j.i, j.j});
  }

  /// Half-way between the two links of a weld, as they go off from it; the ground goes nowhere.
  double angle_between(const mechanism::Joint& j, Vec place) {
    Vec sum;
    for (const int link : {j.i, j.j}) {
      if (link == mechanism::ground) continue;
      const figure::Point middle = middle_of_body(link);
      const Vec off = Vec{middle.x, middle.y} - place;
      if (mechanism::length(off) > 0.0) sum = sum + (1.0 / mechanism::length(off)) * off;
    }
    return std::atan2(sum.y, sum.x);
  }

  void add_point(const TracedPoint& p) {
    const bool is_joint = std::any_of(model_.joints.begin(), model_.joints.end(), [&](const auto& j) {
      return (j.i == p.link && mechanism::length(j.point_i - p.at) == 0.0) ||
             (j.j == p.link && mechanism::length(j.point_j - p.at) == 0.0);
    });
    if (is_joint) return;
    scheme().points.push_back({p.name, point(on_paper(at_, p.link, p.at))});
    motion_.points.push_back({p.link, p.link});
  }

  /// The line of a guide or slot over the stroke and from its own point, and a little beyond either.
  void add_guide(std::size_t n) {
    const mechanism::Joint& j = model_.joints[n];
    const Vec start = on_paper(at_, j.j, j.point_j), along = line_of(j, at_);
    const bool fixed = j.j == mechanism::ground;
    // A slot begins at its link's own pin; where a fixed guide begins is of no meaning.
    const double from = fixed ? extents_.strokes[n].from : std::min(0.0, extents_.strokes[n].from);
    const double to = fixed ? extents_.strokes[n].to : std::max(0.0, extents_.strokes[n].to);
    const double margin = std::max(0.2 * (extents_.strokes[n].to - extents_.strokes[n].from), 0.1 * size());
    const double before = !fixed && from == 0.0 ? 0.0 : margin, after = !fixed && to == 0.0 ? 0.0 : margin;
    scheme().guides.push_back({point(start + (from - before) * along), point(start + (to + after) * along), fixed});
    motion_.guides.push_back({j.j, j.j});
  }

  /// The line that a wheel rolls on, as far to both sides as the wheel is large.
  void add_rack(const mechanism::Joint& j) {
    const Vec along = line_of(j, at_), centre = on_paper(at_, j.i, j.point_i);
    const Vec foot = centre - j.radius_i * mechanism::normal(along), half = 2.5 * std::abs(j.radius_i) * along;
    scheme().racks.push_back({point(foot - half), point(foot + half), j.kind == JointKind::rack, j.radius_i > 0.0,
                              j.j == mechanism::ground});
    motion_.racks.push_back({j.j, j.j});
  }

  void add_wheel(int link, Vec own, double radius) {
    const Vec centre = on_paper(at_, link, own);
    const auto same = [&](const Scheme::Wheel& w) {
      return std::hypot(w.at.x - centre.x, w.at.y - centre.y) < 1e-9 * std::abs(radius) &&
             std::abs(w.radius) == std::abs(radius);
    };
    if (std::any_of(scheme().wheels.begin(), scheme().wheels.end(), same)) return;
    scheme().wheels.push_back({point(centre), radius, angle_of(at_, link), link == mechanism::ground});
    motion_.wheels.push_back({link, link});
  }

  void add_spring(const mechanism::Spring& spring) {
    const bool pulls = spring.rate > 0.0, damps = spring.damping > 0.0;
    if (spring.kind == mechanism::Spring::Kind::linear) {
      scheme().springs.push_back({spring.name, point(on_paper(at_, spring.i, spring.point_i)),
                                  point(on_paper(at_, spring.j, spring.point_j)), pulls, damps});
      motion_.springs.push_back({spring.i, spring.j});
      if (spring.i == mechanism::ground) add_anchor(spring.point_i);
      if (spring.j == mechanism::ground) add_anchor(spring.point_j);
      return;
    }
    const auto joint = joint_between(spring.i, spring.j);
    if (joint == model_.joints.end()) return;  // two links far from each other: there is no place for it
    scheme().coils.push_back({spring.name, point(on_paper(at_, joint->i, joint->point_i)), pulls, damps});
    motion_.coils.push_back({joint->i, joint->j});
  }

  /// Support of the end of a spring on the ground, unless there is a joint.
  void add_anchor(Vec place) {
    const auto same = [&](const Scheme::Joint& j) { return j.fixed && j.at.x == place.x && j.at.y == place.y; };
    if (std::any_of(scheme().joints.begin(), scheme().joints.end(), same)) return;
    scheme().joints.push_back({"", point(place), Scheme::Pin::revolute, true, 0.0});
    motion_.joints.push_back({});
  }

  [[nodiscard]] std::vector<mechanism::Joint>::const_iterator joint_between(int i, int j) const {
    return std::find_if(model_.joints.begin(), model_.joints.end(), [&](const auto& joint) {
      return joint.kind == JointKind::revolute && std::minmax(joint.i, joint.j) == std::minmax(i, j);
    });
  }

  void add_reaction(std::size_t n) {
    const Vec force = -at_.reactions[n].force;
    const bool is_known = std::isfinite(force.x) && std::isfinite(force.y);  // where it jams no force is
    if (!moving_ && !(is_known && mechanism::length(force) > rounding_.force)) return;
    const mechanism::Joint& j = model_.joints[n];
    scheme().arrows.push_back({point(at_.reactions[n].at), point(force), "R_" + j.name, false});
    motion_.forces.push_back({{}, {}, {j.i, -1}});
  }

  void add_load(std::size_t n) {
    const mechanism::Load& l = model_.loads[n];
    const mechanism::LoadNow& now = at_.loads[n];
    const Vec force = mechanism::global_force(l, now.force, mechanism::turn(angle_of(at_, l.link)));
    const Vec place = on_paper(at_, l.link, l.point);
    if (mechanism::length(force) > 0.0 || (moving_ && extents_.loads_push[n])) {
      scheme().arrows.push_back({point(place), point(force), l.name.empty() ? "F" : l.name, true});
      motion_.forces.push_back({{}, {}, {l.link, -1}});
    }
    if (now.moment == 0.0 && !(moving_ && extents_.loads_turn[n])) return;
    // A couple without a point belongs to the full link.
    const bool has_place = extents_.loads_push[n] || mechanism::length(l.point) > 0.0;
    const figure::Point seat = has_place ? point(place) : middle_of_body(l.link);
    scheme().moments.push_back({seat, now.moment, l.name.empty() ? "M" : l.name});
    motion_.couples.push_back({{}, {l.link, -1}});
  }

  void add_drive(std::size_t d) {
    const mechanism::Driver& driver = model_.drivers[d];
    if (driver.kind != mechanism::Driver::Kind::rotary) return;
    const auto joint = joint_between(driver.i, driver.j);
    const bool negligible = !(std::abs(at_.effort[d]) > rounding_.moment) && !moving_;
    if (joint == model_.joints.end() || negligible) return;
    scheme().moments.push_back({point(on_paper(at_, joint->i, joint->point_i)), at_.effort[d], "M"});
    motion_.couples.push_back({{}, {joint->i == mechanism::ground ? mechanism::ground : joint->i, -1}});
  }

  const mechanism::Model& model_;
  const Position& at_;
  const Extents& extents_;
  const std::vector<TracedPoint>& points_;
  bool moving_;
  Rounding rounding_;
  Motion motion_;
};

}  // namespace

Motion scheme_at(const mechanism::Model& model, const Position& at, const Extents& extents,
                 const std::vector<TracedPoint>& points, Shown shown) {
  return Drawing(model, at, extents, points, shown).taken();
}

}  // namespace loadpath::planar
