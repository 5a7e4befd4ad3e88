#include "calculators/belt/course.hpp"

#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::belt {

namespace {

using Input = Course::Input;
using Result = Course::Result;
using Pulley = Course::Pulley;

double turn_of(const Input& in) { return in.turns == Course::Turns::ccw ? 1.0 : -1.0; }
/// +1 where the pulley turns counter-clockwise.
double sense_of(const Input& in, const Pulley& p) {
  return p.side == Course::Side::inside ? turn_of(in) : -turn_of(in);
}

using Circles = List<Circle, most_pulleys>;

Circles circles_of(const Input& in) {
  Circles circles;
  for (const Pulley& p : in.pulleys)
    circles.push_back({{in_si(p.x), in_si(p.y)}, in_si(p.d) / 2.0, p.side == Course::Side::outside});
  return circles;
}

/// The place of the pulley that moves; the number of pulleys where none does.
std::size_t moving_one(const Input& in) {
  const auto moves = [](const Pulley& p) { return is_set(p.along); };
  return static_cast<std::size_t>(std::find_if(in.pulleys.begin(), in.pulleys.end(), moves) - in.pulleys.begin());
}

Shift shift_of(const Input& in, const Circles& circles) {
  const std::size_t moving = moving_one(in);
  return shift_for(in_si(in.L), circles, turn_of(in), moving, in.pulleys[moving].along);
}

void move(Circle& circle, double way, double direction) {
  circle.at.x += way * std::cos(direction);
  circle.at.y += way * std::sin(direction);
}

std::string path_of(const Input& in, std::size_t k) {
  return in.pulleys[k].name.empty() ? "pulleys[" + std::to_string(k + 1) + "]"
                                    : "pulleys." + std::string(in.pulleys[k].name.view());
}

bool has_powers(const Input& in) {
  return std::any_of(in.pulleys.begin(), in.pulleys.end(), [](const Pulley& p) { return is_set(p.P); });
}

/// What all pulleys but the first take out of the belt up to one of them, N; from nothing behind the first.
List<Force, most_pulleys> taken_forces(const Input& in, Speed v) {
  List<Force, most_pulleys> taken{0.0 * N};
  for (std::size_t k = 1; k < in.pulleys.size(); ++k)
    taken.push_back(taken.back() + (is_set(in.pulleys[k].P) ? in.pulleys[k].P / v : 0.0 * N));
  return taken;
}

/// The least tension that presses the pulleys behind the first one, with which no pulley slips: at each of them the
/// larger tension is at most e^(mu alpha) times the smaller.
Force least_pressing(const Input& in, const Loop& loop, const List<Force, most_pulleys>& taken) {
  Force least = 0.0 * N;
  const std::size_t count = in.pulleys.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Force before = k == 0 ? taken.back() : taken[k - 1], behind = taken[k];
    const double part = std::exp(-in.mu * loop.wraps[k]);
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
    p.alpha = loop.wraps[k], p.l_s = loop.spans[k].length * m;
    trace.angle("alpha", p.alpha, "wrap between the tangents of both spans");
    trace.value("l_s", p.l_s, "common tangent with the next pulley");
    r.pulleys.push_back(p);
  }
  r.L = loop.length * m;
  trace.value("L", r.L, "spans and arcs, exact");
}

template <class Tracer>
void turn(const Input& in, Result& r, Tracer& trace) {
  const auto n_1 = in.n_1;
  if (!is_set(n_1)) return;
  const auto d_1 = in.pulleys[0].d, L = r.L;
  const double N_p = static_cast<double>(in.pulleys.size());
  trace.value("d_1", d_1, "diameter of the first pulley");
  trace.value("N_p", N_p, "number of pulleys");
  STEP(v, n_1 * d_1 / 2.0, "speed of the belt");
  STEP(f_B, N_p * v / L, "every pulley bends the belt in each round");
  r.v = v, r.f_B = f_B;
  for (std::size_t k = 0; k < r.pulleys.size(); ++k)
    r.pulleys[k].n = sense_of(in, in.pulleys[k]) * 2.0 * v / in.pulleys[k].d;
}

/// Load of a shaft from the spans before and behind, without the centrifugal part, which does not press.
template <class Tracer>
void press(const Loop& loop, std::size_t k, Force N_before, Force N_behind, Course::PulleyResult& p, Tracer& trace) {
  const std::size_t before = (k + loop.count - 1) % loop.count;
  const double psi_in = loop.spans[before].direction, psi_out = loop.spans[k].direction, alpha = p.alpha;
  trace.value("N_before", N_before, "what presses the pulley from the span before it, S - F_c");
  trace.value("N_behind", N_behind, "and from the span behind it");
  trace.value("psi_in", psi_in, "direction in which the belt comes, rad");
  trace.value("psi_out", psi_out, "direction in which it leaves, rad");
  STEP(R_x, N_behind * cos(psi_out) - N_before * cos(psi_in), "both spans pull the shaft, along x");
  STEP(R_y, N_behind * sin(psi_out) - N_before * sin(psi_in), "along y");
  STEP(R, sqrt(R_x * R_x + R_y * R_y), "load of the shaft");
  p.R_x = R_x, p.R_y = R_y, p.R = R;
  if (!(N_before > 0.0 * N && N_behind > 0.0 * N)) return;
  STEP(mu_req, abs(log(N_behind / N_before)) / alpha, "friction that is used, [Shigley-17]");
  p.mu_req = mu_req;
}

template <class Tracer>
void tighten(const Input& in, const Loop& loop, Result& r, Tracer& trace) {
  if (!is_set(r.v) || !(has_powers(in) || is_set(in.S_0))) return;
  const auto q = in.q;
  const auto v = r.v;
  const auto taken = taken_forces(in, v);
  STEP(F_c, q * v * v, "turns the belt around, and does not press the pulleys");
  r.F_c = F_c;
  const auto& F_t = taken.back();
  trace.value("F_t", F_t, "force of the driving pulley: what the others take, P / v");
  STEP(P_1, F_t * v, "power of the driving pulley");
  r.P_1 = P_1;
  if (is_set(in.mu)) {
    const auto N_0 = least_pressing(in, loop, taken);
    trace.value("N_0", N_0, "least slack tension with N_large / N_small = e^(mu alpha) nowhere exceeded, [B40]");
    STEP(S_0_min, N_0 + F_c, "least tension of the slack span");
    r.S_0_min = S_0_min;
  }
  r.S_0 = is_set(in.S_0) ? in.S_0 : r.S_0_min;
  const auto S_0 = r.S_0, S_0_min = r.S_0_min;
  if (!is_set(S_0)) return;
  trace.value("S_0", S_0, is_set(in.S_0) ? "as given" : "the least one");
  r.S_max = S_0, r.N_min = S_0 - F_c;
  for (std::size_t k = 0; k < r.pulleys.size(); ++k) {
    [[maybe_unused]] const auto here = trace.scope("pulleys", k);
    const Force before = k == 0 ? S_0 + taken.back() : r.pulleys[k - 1].S;
    const auto& F_k = taken[k];
    trace.value("F_k", F_k, "taken up to this pulley");
    STEP(S, S_0 + F_k, "tension behind it");
    const auto S_before = before;
    const auto d = in.pulleys[k].d;
    const double turn = sense_of(in, in.pulleys[k]);
    trace.value("S_before", S_before, "tension before it");
    trace.value("d", d, "diameter");
    trace.value("turn", turn, "+1 where it turns counter-clockwise");
    STEP(T, turn * (S - S_before) * d / 2.0, "torque of the belt on it");
    r.pulleys[k].S = S, r.pulleys[k].T = T;
    press(loop, k, before - F_c, S - F_c, r.pulleys[k], trace);
    r.S_max = max(r.S_max, S), r.N_min = min(r.N_min, S - F_c);
  }
  if (!is_set(S_0_min)) return;
  r.u_S = 1.0;  // the least tension, be there any
  if (is_set(in.S_0)) r.u_S = NAMED_STEP("u_S", S_0_min / S_0, "friction condition");
}

FieldFault length_fault(const Input& in, const Circles& circles) {
  const Shift shift = shift_of(in, circles);
  const std::string name = path_of(in, moving_one(in));
  if (shift.longest == 0.0)
    return {name, say("wherever '{1}' is along its direction, the belt does not run through these pulleys", name),
            say("list the pulleys in the order in which the belt runs, and say which are outside of it")};
  return {"L",
          say("no place of '{1}' along its direction gives a belt of {2}", name, format_quantity(in_si(in.L), "mm")),
          say("it gives belts from {1} to {2}", format_quantity(shift.shortest, "mm", 6),
              format_quantity(shift.longest, "mm", 6))};
}

}  // namespace

bool Course::tensioner_fits(const Input& in) {
  const auto moving =
      std::count_if(in.pulleys.begin(), in.pulleys.end(), [](const Pulley& p) { return is_set(p.along); });
  return moving == (is_set(in.L) ? 1 : 0);
}

FieldFault Course::wrong_tensioner(const Input& in) {
  const std::size_t moving = moving_one(in);
  if (!is_set(in.L))
    return {path_of(in, moving) + ".along", say("this pulley moves, and the length of the belt is not given"),
            say("give L, or leave out the direction")};
  if (moving == in.pulleys.size())
    return {"L", say("the length of the belt is given, and no pulley moves"),
            say("give one pulley the direction in which it tightens the belt, as in along = \"90 deg\"")};
  return {"pulleys", say("several pulleys move, and one length does not tell where each of them is"),
          say("leave out along of all but one")};
}

bool Course::powers_fit(const Input& in) { return wrong_power(in).message.empty(); }

FieldFault Course::wrong_power(const Input& in) {
  if (in.pulleys.empty()) return {};
  if (is_set(in.pulleys[0].P))
    return {path_of(in, 0) + ".P", say("the first pulley drives, and gives what the others take"),
            say("leave out its power")};
  if (!has_powers(in) && !is_set(in.S_0)) return {};
  if (!is_set(in.n_1))
    return {"n_1", say("powers and tensions need the speed n_1"), say("give n_1, as in \"1450 rpm\"")};
  if (!is_set(in.mu) && !is_set(in.S_0))
    return {"mu", say("the tensions need the friction mu, or the tension S_0 of the slack span"), {}};
  Power sum = 0.0 * W;
  for (const Pulley& p : in.pulleys) sum += is_set(p.P) ? p.P : 0.0 * W;
  if (sum < 0.0 * W)
    return {"pulleys", say("the pulleys give more power than they take: the first one would be driven"),
            say("put the pulley that drives first")};
  return {};
}

bool Course::closes(const Input& in) {
  if (in.pulleys.size() < 2 || !tensioner_fits(in)) return true;  // other rules speak of these
  const Circles circles = circles_of(in);
  return is_set(in.L) ? shift_of(in, circles).way.has_value() : lay_loop(circles, turn_of(in)).flaw == Flaw::none;
}

FieldFault Course::flaw_of(const Input& in) {
  const Circles circles = circles_of(in);
  if (is_set(in.L)) return length_fault(in, circles);
  const Loop loop = lay_loop(circles, turn_of(in));
  if (lay_loop(circles, -turn_of(in)).flaw == Flaw::none)
    return {"turns", say("the pulleys are listed against the way the belt runs"),
            say("turn the first one the other way: turns = \"{1}\"", in.turns == Turns::ccw ? "cw" : "ccw")};
  const std::string at = path_of(in, loop.at), other = path_of(in, loop.other);
  switch (loop.flaw) {
    case Flaw::touching:
      return {at, say("'{1}' and '{2}' touch", at, other), say("move them apart, or make one smaller")};
    case Flaw::untouched:
      return {at, say("the belt does not reach '{1}'", at), say("move it against the belt, or leave it out")};
    case Flaw::through:
      return {at, say("the span behind '{1}' runs through '{2}'", at, other),
              say("list the pulleys in the order in which the belt runs")};
    default:
      return {
          "pulleys", say("the belt would cross itself"),
          say("list the pulleys in the order in which the belt runs; with the first one clockwise, turns = \"cw\"")};
  }
}

template <class Tracer>
Course::Result Course::evaluate(const Input& in, Tracer& trace) {
  Result r;
  Circles circles = circles_of(in);
  if (is_set(in.L)) {
    const std::size_t moving = moving_one(in);
    const double way = shift_of(in, circles).way.value_or(unset<double>);
    move(circles[moving], way, in.pulleys[moving].along);
    r.s = way * m;
    trace.value("s", r.s, "shortest way of the pulley that moves to a belt of the length L, by bisection");
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

std::vector<draw::Figure> Course::figures(const Input& in, const Result& r) {
  Circles circles = circles_of(in);
  draw::Scheme drive;
  for (std::size_t k = 0; k < r.pulleys.size(); ++k) {
    circles[k].at = {in_si(r.pulleys[k].x), in_si(r.pulleys[k].y)};
    draw::Scheme::Wheel pulley;
    pulley.at = circles[k].at, pulley.radius = circles[k].radius;
    drive.wheels.push_back(pulley);
    const auto name = in.pulleys[k].name.view();
    drive.joints.push_back(
        {name.empty() ? std::to_string(k + 1) : std::string(name), circles[k].at, draw::Scheme::Pin::revolute, true});
    if (!is_set(r.pulleys[k].R)) continue;
    drive.arrows.push_back({circles[k].at, {in_si(r.pulleys[k].R_x), in_si(r.pulleys[k].R_y)}, "R"});
  }
  const Loop loop = lay_loop(circles, turn_of(in));
  drive.outlines.push_back({circles[0].at, belt_line(circles, turn_of(in), loop)});
  return {{"course", "The belt to scale, with the loads of the shafts", std::move(drive)}};
}

}  // namespace loadpath::belt

template const loadpath::Calculator& loadpath::erased<loadpath::belt::Course>();
