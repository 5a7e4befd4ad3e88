#include "calculators/motion/path_figures.hpp"

#include <cmath>

namespace loadpath::motion {

namespace {

constexpr int points = 181;

/// A curve of a number of the state over the range.
template <class Number>
figure::Curve curve(const PointPath& path, double t_1, double t_2, const char* label, Number number) {
  return curve_over(t_1, t_2, points, label, [&](double t) { return number(path.at(t)); });
}

bool lies_between(double t, double t_1, double t_2) { return t_1 <= t && t <= t_2; }

}  // namespace

figure::Plot over_time(const char* symbol, const char* meaning, const char* unit) {
  figure::Plot plot;
  plot.x = {"t", "time", "s"};
  plot.y = {symbol, meaning, unit};
  return plot;
}

figure::Figure path_figure(const PointPath& path, double t, double t_1, double t_2) {
  figure::Scheme scheme;
  figure::Scheme::Path way{"", {}};
  for (int i = 0; i < points; ++i) {
    const PointState s = path.at(t_1 + (t_2 - t_1) * i / (points - 1));
    way.points.push_back({s.r[0], s.r[1]});
  }
  scheme.paths.push_back(std::move(way));
  const PointState now = path.at(t), first = path.at(t_1), last = path.at(t_2);
  scheme.points.push_back({"M_1", {first.r[0], first.r[1]}});
  if (std::hypot(last.r[0] - first.r[0], last.r[1] - first.r[1]) > 1e-9 * path.length(t_1, t_2))
    scheme.points.push_back({"M_2", {last.r[0], last.r[1]}});
  scheme.points.push_back({"M", {now.r[0], now.r[1]}});
  return {"path", "Path in the plane xy, with the start of the range and the point M at the time t", std::move(scheme)};
}

figure::Figure speed_figure(const PointPath& path, double t, double t_1, double t_2) {
  figure::Plot plot = over_time("v", "speed", "m/s");
  plot.curves.push_back(curve(path, t_1, t_2, "v", [](const PointState& s) { return s.speed; }));
  if (lies_between(t, t_1, t_2)) plot.marks.push_back({t, path.at(t).speed, "at t"});
  return {"speed", "Speed over time", std::move(plot)};
}

figure::Figure acceleration_figure(const PointPath& path, double t, double t_1, double t_2) {
  figure::Plot plot = over_time("a", "acceleration and its parts", "m/s^2");
  plot.curves.push_back(curve(path, t_1, t_2, "a", [](const PointState& s) { return s.acceleration; }));
  plot.curves.push_back(curve(path, t_1, t_2, "a_tau", [](const PointState& s) { return s.a_tau; }));
  plot.curves.push_back(curve(path, t_1, t_2, "a_n", [](const PointState& s) { return s.a_n; }));
  if (lies_between(t, t_1, t_2)) plot.marks.push_back({t, path.at(t).acceleration, "at t"});
  return {"acceleration", "Acceleration and its parts along the path over time", std::move(plot)};
}

figure::Figure plan_figure(const std::vector<Vectors>& panels) {
  using Tone = figure::Plan::Tone;
  figure::Plans plans;
  for (const Vectors& vectors : panels) {
    figure::Plan plan;
    plan.title = vectors.title;
    plan.unit = vectors.unit;
    Tone tone = Tone::first;
    for (const auto& [label, tip] : vectors.of) {
      if (std::hypot(tip.x, tip.y) > 0.0) plan.vectors.push_back({{0.0, 0.0}, tip, label, tone});
      tone = tone == Tone::first ? Tone::second : Tone::third;
    }
    if (!plan.vectors.empty()) plans.panels.push_back(std::move(plan));
  }
  return {"vectors", "Velocity and acceleration out of a pole", std::move(plans)};
}

}  // namespace loadpath::motion
