#include "calculators/vessel/section.hpp"

#include "lib/text/issue.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::vessel {

namespace {

using figure::Drawing;
using figure::Point;
using Points = std::vector<Point>;

double length(Point a) { return std::hypot(a.x, a.y); }
Point unit(Point a) { return {a.x / length(a), a.y / length(a)}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point moved(Point p, Point direction, double by) { return {p.x + by * direction.x, p.y + by * direction.y}; }

Points mirrored(const Points& points) {
  Points other(points.rbegin(), points.rend());
  for (Point& p : other) p.x = -p.x;
  return other;
}

/// The wall as ordered, right of the axis: its two surfaces, and what points out of the vessel at each place.
struct Wall {
  Points inner, outer, normals;
  bool starts_on_axis = false, ends_on_axis = false, ring = false;
};

/// Normals of the meridian that point away from `within` at the place in the middle, and so all along.
Points normals_of(const Points& middle, Point within, bool ring) {
  const std::size_t n = middle.size();
  Points normals;
  for (std::size_t i = 0; i < n; ++i) {
    const Point before = i > 0 ? middle[i - 1] : ring ? middle[n - 2] : middle[0];
    const Point after = i + 1 < n ? middle[i + 1] : ring ? middle[1] : middle[n - 1];
    const Point along = unit(after - before);
    normals.push_back({along.y, -along.x});
  }
  const std::size_t half = n / 2;
  const Point from_within = middle[half] - within;
  const double side = normals[half].x * from_within.x + normals[half].y * from_within.y < 0.0 ? -1.0 : 1.0;
  for (Point& normal : normals) normal = {side * normal.x, side * normal.y};
  return normals;
}

/// On the axis the surfaces of both halves meet: where the line through the next two points of one of them does.
void close_on_axis(Points& surface, bool at_start) {
  if (surface.size() < 3) return;
  Point& end = at_start ? surface.front() : surface.back();
  const Point next = at_start ? surface[1] : surface[surface.size() - 2];
  const Point run = end - next;
  const double t = run.x < 0.0 ? -next.x / run.x : 1.0;
  end = {0.0, next.y + t * run.y};
}

Wall wall_of(const WallInput& in, const WallResult& r, const Section& s) {
  const double delta = in_si(r.delta), delta_c = in_si(r.delta_c);
  // The middle of the carrying wall lies at offset(in) outside of the given surface; the inside of the new wall here:
  const double e = in.measured == Measured::inner   ? in_si(in.c) + 0.5 * delta_c
                   : in.measured == Measured::outer ? -0.5 * delta_c
                                                    : in_si(in.c) + 0.5 * delta_c - 0.5 * delta;
  const double inward = inside_of(in, delta) - e;
  Wall wall;
  wall.ring = s.ring;
  wall.normals = normals_of(s.middle, s.within, s.ring);
  double size = 0.0;
  for (const Point p : s.middle) size = std::max({size, p.x, std::abs(p.y)});
  wall.starts_on_axis = !s.ring && s.middle.front().x < 1e-9 * size;
  wall.ends_on_axis = !s.ring && s.middle.back().x < 1e-9 * size;
  for (std::size_t i = 0; i < s.middle.size(); ++i) {
    wall.inner.push_back(moved(s.middle[i], wall.normals[i], inward));
    wall.outer.push_back(moved(s.middle[i], wall.normals[i], inward + delta));
  }
  for (Points* surface : {&wall.inner, &wall.outer}) {
    if (wall.starts_on_axis) close_on_axis(*surface, true);
    if (wall.ends_on_axis) close_on_axis(*surface, false);
    for (Point& p : *surface) p.x = std::max(p.x, 0.0);
  }
  return wall;
}

/// A surface with its other half, from one free end to the other, or all around.
Points whole(const Points& right, bool starts_on_axis) {
  Points all, left = mirrored(right);
  const Points &first = starts_on_axis ? left : right, &second = starts_on_axis ? right : left;
  all = first;
  all.insert(all.end(), second.begin() + 1, second.end());
  return all;
}

void add_walls(const Wall& wall, Drawing::View& view) {
  const std::string name = say("section of the wall").text();
  if (wall.starts_on_axis && wall.ends_on_axis) {
    view.areas.push_back({whole(wall.outer, false), Drawing::Kind::cut, name, whole(wall.inner, false)});
  } else if (wall.starts_on_axis || wall.ends_on_axis) {
    Points outline = whole(wall.outer, wall.starts_on_axis);
    const Points back = whole(wall.inner, wall.starts_on_axis);
    outline.insert(outline.end(), back.rbegin(), back.rend());
    view.areas.push_back({std::move(outline), Drawing::Kind::cut, name});
  } else if (wall.ring) {
    view.areas.push_back({wall.outer, Drawing::Kind::cut, name, wall.inner});
    view.areas.push_back({mirrored(wall.outer), Drawing::Kind::cut, {}, mirrored(wall.inner)});
  } else {
    Points right = wall.outer;
    right.insert(right.end(), wall.inner.rbegin(), wall.inner.rend());
    view.areas.push_back({right, Drawing::Kind::cut, name});
    view.areas.push_back({mirrored(right), Drawing::Kind::cut});
  }
}

/// A line across where the vessel continues: straight, with a turn on either side of the axis.
Points break_line(double half, double z) {
  const double beyond = 1.06 * half, tooth = 0.05 * half;
  return {{-beyond, z},
          {-0.5 * half - tooth, z},
          {-0.5 * half, z + tooth},
          {-0.5 * half, z - tooth},
          {-0.5 * half + tooth, z},
          {0.5 * half - tooth, z},
          {0.5 * half, z + tooth},
          {0.5 * half, z - tooth},
          {0.5 * half + tooth, z},
          {beyond, z}};
}

/// View of a free end behind the section, or a sign that the vessel continues.
void add_ends(const Wall& wall, const Section& s, Drawing::View& view) {
  for (const bool start : {true, false}) {
    if (wall.ring || (start ? wall.starts_on_axis : wall.ends_on_axis)) continue;
    const Point inner = start ? wall.inner.front() : wall.inner.back();
    const Point outer = start ? wall.outer.front() : wall.outer.back();
    if (start ? s.broken_start : s.broken_end)
      view.paths.push_back({break_line(outer.x, outer.y), Drawing::Line::thin});
    else
      view.paths.push_back({{{-inner.x, inner.y}, inner}, Drawing::Line::outline});
  }
}

/// The inside below a height.
Points filled_to(const Points& inside, double z) {
  Points filled;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const Point from = inside[i], to = inside[(i + 1) % inside.size()];
    if (from.y <= z) filled.push_back(from);
    if ((from.y <= z) != (to.y <= z)) {
      const double t = (z - from.y) / (to.y - from.y);
      filled.push_back({from.x + t * (to.x - from.x), z});
    }
  }
  return filled;
}

void add_liquid(const Wall& wall, double z, Drawing::View& view) {
  Points inside = wall.inner;
  const Points left = mirrored(wall.inner);
  inside.insert(inside.end(), left.begin(), left.end());
  const Points filled = filled_to(inside, z);
  double half = 0.0;
  for (const Point p : filled) {
    if (std::abs(p.y - z) < 1e-9 * (1.0 + std::abs(z))) half = std::max(half, p.x);
  }
  if (filled.size() < 3 || half <= 0.0) return;
  view.areas.push_back({filled, Drawing::Kind::liquid, say("liquid").text()});
  view.surfaces.push_back({{-half, z}, {half, z}});
}

bool lower(Point a, Point b) { return a.y < b.y; }

double widest_of(const Wall& wall) {
  return std::max_element(wall.outer.begin(), wall.outer.end(), [](Point a, Point b) { return a.x < b.x; })->x;
}

double height_of(const Wall& wall) {
  const auto [low, high] = std::minmax_element(wall.outer.begin(), wall.outer.end(), lower);
  return high->y - low->y;
}

/// Arrows on the inside, evenly along it.
void add_pressure(const WallInput& in, const Wall& wall, const Section& s, Drawing::View& view) {
  constexpr int arrows = 7;
  Drawing::Pressure pressure{{}, {"p", in_si(in.p), "MPa"}, s.within};
  std::vector<double> way{0.0};
  for (std::size_t i = 1; i < wall.inner.size(); ++i)
    way.push_back(way.back() + length(wall.inner[i] - wall.inner[i - 1]));
  for (int k = 0; k < arrows; ++k) {
    const double at = way.back() * (k + 0.5) / arrows;
    const auto i = static_cast<std::size_t>(std::lower_bound(way.begin(), way.end(), at) - way.begin());
    if (i == 0 || i >= wall.inner.size()) continue;
    const double t = (at - way[i - 1]) / std::max(way[i] - way[i - 1], 1e-300);
    const Point foot = moved(wall.inner[i - 1], wall.inner[i] - wall.inner[i - 1], t), out = wall.normals[i];
    pressure.arrows.push_back({foot, out});
    pressure.arrows.push_back({{-foot.x, foot.y}, {-out.x, out.y}});
  }
  if (!s.ring) pressure.label.x = 0.4 * widest_of(wall);
  view.pressures.push_back(std::move(pressure));
}

void add_axis(const Wall& wall, Drawing::View& view) {
  const auto [low, high] = std::minmax_element(wall.outer.begin(), wall.outer.end(), lower);
  const double beyond = 0.06 * (high->y - low->y);
  view.paths.push_back({{{0.0, low->y - beyond}, {0.0, high->y + beyond}}, Drawing::Line::centre});
}

Points band(double from, double to, double height) { return {{from, 0.0}, {to, 0.0}, {to, height}, {from, height}}; }

/// A piece of the wall, its inside on the left.
Drawing::View wall_view(const WallInput& in, const WallResult& r, const std::string& radius) {
  const double delta = in_si(r.delta), delta_c = in_si(r.delta_c), c = in_si(in.c);
  const double height = 1.2 * delta, mill = std::max(0.0, delta - c - delta_c);
  // The mill takes from the outside, or, where the outside is what was measured, from the inside, as the middle of the
  // carrying wall has it.
  const double corroded_from = in.measured == Measured::outer ? mill : 0.0;
  const double carries_from = corroded_from + c, carries_to = carries_from + delta_c;
  Drawing::View view;
  view.title = say("the wall, enlarged").text();
  view.share = 0.42;
  view.areas.push_back({band(carries_from, carries_to, height), Drawing::Kind::cut, say("analysis thickness").text()});
  if (c > 0.0)
    view.areas.push_back(
        {band(corroded_from, carries_from, height), Drawing::Kind::lost, say("corrosion allowance").text()});
  const double mill_from = in.measured == Measured::outer ? 0.0 : carries_to;
  if (mill > 1e-9 * delta) {
    view.areas.push_back(
        {band(mill_from, mill_from + mill, height), Drawing::Kind::lost, say("mill undertolerance").text()});
  }
  for (const double x : {0.0, delta}) view.paths.push_back({{{x, 0.0}, {x, height}}, Drawing::Line::outline});
  view.lengths.push_back({{0.0, height}, {delta, height}, {"delta", delta, "mm"}, Drawing::Side::above});
  if (delta_c < delta * (1.0 - 1e-9))
    view.lengths.push_back({{carries_from, 0.0}, {carries_to, 0.0}, {"delta_c", delta_c, "mm"}, Drawing::Side::below});
  if (c > 0.0)
    view.lengths.push_back({{corroded_from, 0.0}, {carries_from, 0.0}, {"c", c, "mm"}, Drawing::Side::below});
  if (in.c_t > 0.0 * mm) {
    view.lengths.push_back(
        {{mill_from, 0.0}, {mill_from + mill, 0.0}, {"c_t", in_si(in.c_t), "mm"}, Drawing::Side::below});
  }
  const double measured = -inside_of(in, delta);
  view.paths.push_back({{{measured, -0.2 * height}, {measured, 1.2 * height}}, Drawing::Line::centre});
  view.names.push_back({{measured, 1.2 * height}, radius, std::nullopt, false});
  Drawing::Pressure pressure{{}, {"p_i", in_si(r.p_i), "MPa"}, {-0.05 * delta, 1.12 * height}};
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) pressure.arrows.push_back({{0.0, share * height}, {1.0, 0.0}});
  view.pressures.push_back(std::move(pressure));
  return view;
}

}  // namespace

double inside_of(const WallInput& in, double delta) {
  return in.measured == Measured::inner ? 0.0 : in.measured == Measured::outer ? -delta : -0.5 * delta;
}

figure::Figure section_figure(const WallInput& in, const WallResult& r, const Section& s) {
  const Wall wall = wall_of(in, r, s);
  auto drawing = std::make_shared<Drawing>();
  Drawing::View view = s.dimensioned;
  add_walls(wall, view);
  if (s.surface) add_liquid(wall, *s.surface, view);
  add_ends(wall, s, view);
  add_axis(wall, view);
  add_pressure(in, wall, s, view);
  if (s.governing) {
    view.names.push_back({*s.governing, "", Drawing::Value{"sigma_v", in_si(r.sigma_v), "MPa"}});
  }
  const bool flat = s.ring || 1.5 * height_of(wall) < 2.0 * widest_of(wall);
  view.share = flat ? 1.0 : 0.58;
  view.note = say(s.governing ? "walls to scale; dot: governing location" : "walls to scale").text();
  Drawing::View enlarged = wall_view(in, r, s.radius);
  if (flat) enlarged.share = 0.6, enlarged.most_height = 250.0;
  drawing->views = {std::move(view), std::move(enlarged)};
  return {"section", "Section of the vessel through its axis, and its wall", figure::Drawn(std::move(drawing))};
}

}  // namespace loadpath::vessel
