#include "calculators/belt/course.hpp"

#include "calculators/belt/course_parts.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/figure/drawing.hpp"

#include <cmath>

namespace loadpath::belt {

namespace {

using Input = Course::Input;
using Result = Course::Result;

void move(Circle& circle, double way, double direction) {
  circle.at.x += way * std::cos(direction);
  circle.at.y += way * std::sin(direction);
}

/// Force taken out of the belt by all pulleys but the first, up to each, N; zero behind the first.
List<Force, most_pulleys> taken_forces(const Input& in, Speed v) {
  List<Force, most_pulleys> taken{0.0 * N};
  for (std::size_t k = 1; k < in.pulleys.size(); ++k)
    taken.push_back(taken.back() + (is_set(in.pulleys[k].P) ? in.pulleys[k].P / v : 0.0 * N));
  return taken;
}

/// Between the belt and a pulley.
double friction(const Input& in, std::size_t k) { return is_set(in.pulleys[k].mu) ? in.pulleys[k].mu : in.mu; }

/// The least tension that presses the pulleys behind the first one, with which no pulley slips: at each of them the
/// larger tension is at most e^(mu alpha) times the smaller.
Force least_pressing(const Input& in, const Loop& loop, const List<Force, most_pulleys>& taken) {
  Force least = 0.0 * N;
  const std::size_t count = in.pulleys.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Force before = k == 0 ? taken.back() : taken[k - 1], behind = taken[k];
    const double part = std::exp(-friction(in, k) * loop.wraps[k]);
    least = max(least, (part * max(before, behind) - min(before, behind)) / (1.0 - part));
  }
  return least;
}

/// The geometry as results.
template <class Tracer>
void lay(const Input& in, const Circles& circles, const Loop& loop, Result& r, Tracer& trace) {
  for (std::size_t k = 0; k < in.pulleys.size(); ++k) {
    [[maybe_unused]] const auto here = trace.scope("pulleys", k);
    Course::PulleyResult p;
    p.name = in.pulleys[k].name;
    p.x = circles[k].at.x * m, p.y = circles[k].at.y * m;
    p.alpha = trace.angle("alpha", loop.wraps[k], "wrap between the tangents of both spans");
    p.l_s = trace.value("l_s", loop.spans[k].length * m, "common tangent with the next pulley");
    r.pulleys.push_back(p);
  }
  r.L = trace.value("L", loop.length * m, "spans and arcs, exact");
}

template <class Tracer>
void turn(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.n_1)) return;
  const auto d_1 = trace.value("d_1", in.pulleys[0].d, "diameter of the first pulley");
  const double N_p = trace.value("N_p", static_cast<double>(in.pulleys.size()), "number of pulleys");
  STEP_TO(r, v, in.n_1 * d_1 / 2.0, "belt speed");
  STEP_TO(r, f_B, N_p * v / r.L, "every pulley bends the belt in each round");
  for (std::size_t k = 0; k < r.pulleys.size(); ++k)
    r.pulleys[k].n = sense_of(in, in.pulleys[k]) * 2.0 * v / in.pulleys[k].d;
}

/// Load of a shaft from the spans before and behind, without the centrifugal part, which does not press.
template <class Tracer>
void press(const Loop& loop, std::size_t k, Force N_before, Force N_behind, Course::PulleyResult& p, Tracer& trace) {
  const std::size_t before = (k + loop.count - 1) % loop.count;
  trace.value("N_before", N_before, "contact part of the tension of the preceding span, S - F_c");
  trace.value("N_behind", N_behind, "and from the span behind it");
  const double psi_in = trace.value("psi_in", loop.spans[before].direction, "direction in which the belt comes, rad");
  const double psi_out = trace.value("psi_out", loop.spans[k].direction, "direction in which it leaves, rad");
  STEP_TO(p, R_x, N_behind * cos(psi_out) - N_before * cos(psi_in), "both spans pull the shaft, along x");
  STEP_TO(p, R_y, N_behind * sin(psi_out) - N_before * sin(psi_in), "along y");
  STEP_TO(p, R, sqrt(R_x * R_x + R_y * R_y), "load of the shaft");
  if (!(N_before > 0.0 * N && N_behind > 0.0 * N)) return;
  STEP_TO(p, mu_req, abs(log(N_behind / N_before)) / p.alpha, "friction that is used, [Shigley-17]");
}

template <class Tracer>
void tighten(const Input& in, const Loop& loop, Result& r, Tracer& trace) {
  if (!is_set(r.v) || !(has_powers(in) || is_set(in.S_0))) return;
  const auto taken = taken_forces(in, r.v);
  STEP_TO(r, F_c, in.q * r.v * r.v, "centrifugal tension; it does not load the pulleys");
  const Force F_t = trace.value("F_t", taken.back(), "force of the driving pulley: sum of the driven ones, P / v");
  STEP_TO(r, P_1, F_t * r.v, "power of the driving pulley");
  if (is_set(in.mu)) {
    const auto N_0 = least_pressing(in, loop, taken);
    trace.value(
        "N_0", N_0,
        "minimum slack side tension with N_large / N_small <= e^(mu alpha) at every pulley, mu of each pulley, [B40]");
    STEP_TO(r, S_0_min, N_0 + F_c, "minimum slack side tension");
  }
  if (!is_set(in.S_0) && !is_set(r.S_0_min)) return;
  STEP_TO(r, S_0, is_set(in.S_0) ? in.S_0 : r.S_0_min, is_set(in.S_0) ? "as given" : "the least one");
  r.S_max = S_0, r.N_min = S_0 - F_c;
  for (std::size_t k = 0; k < r.pulleys.size(); ++k) {
    [[maybe_unused]] const auto here = trace.scope("pulleys", k);
    const Force F_k = trace.value("F_k", taken[k], "taken up to this pulley");
    STEP(S, S_0 + F_k, "tension behind it");
    const Force S_before = k == 0 ? S_0 + F_t : r.pulleys[k - 1].S;
    trace.value("S_before", S_before, "tension before it");
    const Length d = trace.value("d", in.pulleys[k].d, "diameter");
    const double turn = trace.value("turn", sense_of(in, in.pulleys[k]), "+1 where it turns counter-clockwise");
    STEP(T, turn * (S - S_before) * d / 2.0, "torque of the belt on it");
    r.pulleys[k].S = S, r.pulleys[k].T = T;
    press(loop, k, S_before - F_c, S - F_c, r.pulleys[k], trace);
    r.S_max = max(r.S_max, S), r.N_min = min(r.N_min, S - F_c);
  }
  if (is_set(in.S_adm)) {
    STEP_TO(r, u_T, r.S_max / in.S_adm, "strength condition");
  }
  if (!is_set(r.S_0_min)) return;
  if (!is_set(in.S_0)) {
    r.u_S = 1.0;
    return;
  }
  STEP_TO(r, u_S, r.S_0_min / S_0, "friction condition");
}

}  // namespace

template <class Tracer>
Course::Result Course::evaluate(const Input& in, Tracer& trace) {
  Result r;
  Circles circles = circles_of(in);
  if (is_set(in.L)) {
    const std::size_t moving = moving_one(in);
    const double way = shift_of(in, circles).way.value_or(unset<double>);
    move(circles[moving], way, in.pulleys[moving].along);
    r.s = trace.value("s", way * m, "shortest travel of the moving pulley to a belt of length L, by bisection");
  }
  const Loop loop = lay_loop(circles, turn_of(in));
  if (loop.flaw != Flaw::none) return r;
  lay(in, circles, loop, r, trace);
  turn(in, r, trace);
  tighten(in, loop, r, trace);
  return r;
}

template Course::Result Course::evaluate(const Input&, NoTrace&);
template Course::Result Course::evaluate(const Input&, Trace&);

namespace {

using figure::Drawing;

/// The displacement of the movable pulley, and its initial position.
void draw_way(const Input& in, const Result& r, Drawing::View& view) {
  if (!is_set(in.L)) return;
  const std::size_t moving = moving_one(in);
  const auto& p = in.pulleys[moving];
  const figure::Point given{in_si(p.x), in_si(p.y)}, there{in_si(r.pulleys[moving].x), in_si(r.pulleys[moving].y)};
  const double reach = 0.8 * in_si(p.d);
  const figure::Point e{reach * std::cos(p.along), reach * std::sin(p.along)};
  view.paths.push_back({{{there.x - e.x, there.y - e.y}, {there.x + e.x, there.y + e.y}}, Drawing::Line::hidden});
  if (std::abs(in_si(r.s)) > 0.05 * in_si(p.d)) {
    view.circles.push_back({given, 0.5 * in_si(p.d), Drawing::Line::hidden});
    view.lengths.push_back({given, there, {"s", in_si(r.s), "mm"}, Drawing::Side::in_place});
  }
}

void draw_pulley(const Input& in, const Result& r, std::size_t k, const Circle& circle, const Loop& loop,
                 Drawing::View& view) {
  const auto& pulley = r.pulleys[k];
  const LoopSpan& before = loop.spans[(k + loop.count - 1) % loop.count];
  view.circles.push_back({circle.at, circle.radius, Drawing::Line::outline, true});
  for (const figure::Point touch : {before.to, loop.spans[k].from})
    view.paths.push_back({{circle.at, touch}, Drawing::Line::thin});
  const auto given = in.pulleys[k].name.view();
  const std::string name = given.empty() ? std::to_string(k + 1) : std::string(given);
  view.names.push_back({circle.at, name, Drawing::Value{"alpha", pulley.alpha, "deg"}});
  Drawing::Turn turn{circle.at, 0.7 * circle.radius, sense_of(in, in.pulleys[k]) > 0.0, 1.5 * pi};
  if (k == 0 && is_set(in.n_1)) turn.value = Drawing::Value{"n_1", in_si(in.n_1), "rpm"};
  view.turns.push_back(std::move(turn));
  if (is_set(pulley.R) && pulley.R > 0.0 * N) {
    view.forces.push_back({circle.at, {in_si(pulley.R_x), in_si(pulley.R_y)}, {"R", in_si(pulley.R), "N"}, false});
  }
}

}  // namespace

std::vector<figure::Figure> Course::figures(const Input& in, const Result& r) {
  if (r.pulleys.empty()) return {};
  Circles circles = circles_of(in);
  for (std::size_t k = 0; k < r.pulleys.size(); ++k) circles[k].at = {in_si(r.pulleys[k].x), in_si(r.pulleys[k].y)};
  const Loop loop = lay_loop(circles, turn_of(in));
  if (loop.flaw != Flaw::none) return {};
  auto drawing = std::make_shared<Drawing>();
  Drawing::View view;
  view.most_height = 420.0;
  for (std::size_t k = 0; k < r.pulleys.size(); ++k) draw_pulley(in, r, k, circles[k], loop, view);
  view.paths.push_back({belt_line(circles, turn_of(in), loop), Drawing::Line::belt, true});
  draw_way(in, r, view);
  drawing->views = {std::move(view)};
  return {
      {"course", "The belt to scale with its wraps, and the loads of the shafts", figure::Drawn(std::move(drawing))}};
}

}  // namespace loadpath::belt

template const loadpath::Calculator& loadpath::erased<loadpath::belt::Course>();
