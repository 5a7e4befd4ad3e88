#include "calculators/section/properties/outline.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace loadpath::section {

namespace {

constexpr Length none = from_si<Length>(0.0);

struct Vertex {
  Length y, z;
  Length r = none;  // radius of its fillet
};

/// A polygon whose corners are right angles, those with a radius rounded.
Outline rounded(std::initializer_list<Vertex> vertices) {
  constexpr int parts = 4;  // chords of an arc
  Outline outline;
  const auto* all = vertices.begin();
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vertex &at = all[i], &before = all[(i + n - 1) % n], &after = all[(i + 1) % n];
    if (!(at.r > none)) {
      outline.push_back({at.y, at.z});
      continue;
    }
    const auto towards = [&](const Vertex& other) {
      const double y = in_si(other.y - at.y), z = in_si(other.z - at.z), length = std::hypot(y, z);
      return figure::Point{y / length, z / length};
    };
    const figure::Point u = towards(before), v = towards(after);
    const Length centre_y = at.y + at.r * (u.x + v.x), centre_z = at.z + at.r * (u.y + v.y);
    for (int k = 0; k <= parts; ++k) {
      const double c = std::cos(0.5 * pi * k / parts), s = std::sin(0.5 * pi * k / parts);
      outline.push_back({centre_y - at.r * (c * v.x + s * u.x), centre_z - at.r * (c * v.y + s * u.y)});
    }
  }
  return outline;
}

std::vector<figure::Point> loop_of(const Outline& outline) {
  std::vector<figure::Point> loop;
  for (const Place& p : outline) loop.push_back({in_si(p.y), in_si(p.z)});
  return loop;
}

/// A line through the centroid, across the full section and beyond, named at its end.
void add_axis(figure::Scheme& scheme, figure::Point centroid, double angle, const char* name) {
  double low = 0.0, high = 0.0;
  const double c = std::cos(angle), s = std::sin(angle);
  for (const auto& outline : scheme.outlines) {
    for (const figure::Point& p : outline.points) {
      const double reach = (p.x - centroid.x) * c + (p.y - centroid.y) * s;
      low = std::min(low, reach), high = std::max(high, reach);
    }
  }
  const double beyond = 0.15 * (high - low);
  const auto at = [&](double reach) { return figure::Point{centroid.x + c * reach, centroid.y + s * reach}; };
  scheme.paths.push_back({"", {at(low - beyond), at(high + beyond)}});
  scheme.points.push_back({name, at(high + beyond)});
}

}  // namespace

Outline circle(Length d) {
  constexpr int parts = 64;
  Outline outline;
  for (int k = 0; k < parts; ++k) {
    const double phi = 2.0 * pi * k / parts;
    outline.push_back({0.5 * d * std::cos(phi), 0.5 * d * std::sin(phi)});
  }
  return outline;
}

Outline rectangle(Length b, Length h, Length r) {
  const Length y = 0.5 * b, z = 0.5 * h;
  return rounded({{-y, -z, r}, {y, -z, r}, {y, z, r}, {-y, z, r}});
}

Outline i_outline(Length h, Length b, Length t_w, Length t_f, Length r) {
  const Length y = 0.5 * b, z = 0.5 * h, w = 0.5 * t_w, f = z - t_f;
  return rounded({{-y, -z},
                  {y, -z},
                  {y, -f},
                  {w, -f, r},
                  {w, f, r},
                  {y, f},
                  {y, z},
                  {-y, z},
                  {-y, f},
                  {-w, f, r},
                  {-w, -f, r},
                  {-y, -f}});
}

Outline channel_outline(Length h, Length b, Length t_w, Length t_f, Length r) {
  const Length z = 0.5 * h, f = z - t_f;
  return rounded({{none, -z}, {b, -z}, {b, -f}, {t_w, -f, r}, {t_w, f, r}, {b, f}, {b, z}, {none, z}});
}

Outline angle_outline(Length h, Length b, Length t, Length r, Length r_2) {
  return rounded({{none, none}, {b, none}, {b, t, r_2}, {t, t, r}, {t, h, r_2}, {none, h}});
}

Outline tee_outline(Length h, Length b, Length t_w, Length t_f, Length r) {
  const Length y = 0.5 * b, w = 0.5 * t_w;
  return rounded({{-w, -h}, {w, -h}, {w, -t_f, r}, {y, -t_f}, {y, none}, {-y, none}, {-y, -t_f}, {-w, -t_f, r}});
}

Extremes disc(Length d) { return {{none, none, 0.5 * d}}; }

Extremes box(Length b, Length h) { return rounded_box(b, h, none); }

Extremes rounded_box(Length b, Length h, Length r) {
  const Length y = 0.5 * b - r, z = 0.5 * h - r;
  return {{-y, -z, r}, {y, -z, r}, {y, z, r}, {-y, z, r}};
}

Extremes corners_of(const Outline& outline) {
  Extremes extremes;
  for (const Place& p : outline) extremes.push_back({p.y, p.z});
  return extremes;
}

std::vector<figure::Figure> figures(const Sketch& sketch, const Properties& properties) {
  figure::Scheme scheme;
  const figure::Point centroid{in_si(properties.y_S), in_si(properties.z_S)};
  for (const auto* outlines : {&sketch.material, &sketch.holes}) {
    for (const Outline& outline : *outlines) scheme.outlines.push_back({centroid, loop_of(outline)});
  }
  add_axis(scheme, centroid, 0.0, "y");
  add_axis(scheme, centroid, 0.5 * pi, "z");
  constexpr double small_turn = 1e-6;
  if (std::fabs(std::sin(2.0 * properties.alpha)) > small_turn) {
    add_axis(scheme, centroid, properties.alpha, "I_max");
    add_axis(scheme, centroid, properties.alpha + 0.5 * pi, "I_min");
  }
  scheme.points.push_back({"S", centroid});
  const char* caption = sketch.holes.empty() ? "Section with its centroid S and its axes"
                                             : "Section with centroid S and axes; holes are darker";
  return {{"section", caption, scheme}};
}

std::vector<figure::Figure> figures(const Contours& contours, const Properties& properties) {
  Sketch sketch{{contours.outline}, {}};
  if (!contours.hole.empty()) sketch.holes.push_back(contours.hole);
  return figures(sketch, properties);
}

}  // namespace loadpath::section
