#include "calculators/column/effective_length.hpp"

#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <string>

namespace loadpath::column {

namespace {

using Input = EffectiveLength::Input;
using Result = EffectiveLength::Result;
using End = EffectiveLength::End;

/// The springs of elastic ends over those of the bar.
template <class Tracer>
void compare_springs(const Input& in, Result& r, Tracer& trace) {
  if (is_set(in.c_1)) r.kappa_1 = NAMED_STEP("kappa_1", in.c_1 * in.l / (in.E * in.I), "first end against turning");
  if (is_set(in.k_1)) r.mu_1 = NAMED_STEP("mu_1", in.k_1 * pow<3>(in.l) / (in.E * in.I), "first end across the bar");
  if (is_set(in.c_2)) r.kappa_2 = NAMED_STEP("kappa_2", in.c_2 * in.l / (in.E * in.I), "second end against turning");
  if (is_set(in.k_2)) r.mu_2 = NAMED_STEP("mu_2", in.k_2 * pow<3>(in.l) / (in.E * in.I), "second end across the bar");
}

/// The beams of a joint turn it like a spring: bent in one sense when the frame is braced, in two when it sways.
template <class Tracer>
void take_joints(const Input& in, Result& r, Tracer& trace) {
  const bool sways = in.frame == EffectiveLength::Frame::sway;
  STEP(beams, in.frame == EffectiveLength::Frame::sway ? 6.0 : 2.0,
       sways ? "6 E I/L of beams bent to an S, [AISC-alignment]"
             : "2 E I/L of beams bent to one side, [AISC-alignment]");
  if (in.G_1 > 0.0) r.kappa_1 = NAMED_STEP("kappa_1", beams / in.G_1, "first joint against turning");
  if (in.G_2 > 0.0) r.kappa_2 = NAMED_STEP("kappa_2", beams / in.G_2, "second joint against turning");
}

column::End rigid(End end) {
  return {end == End::free || end == End::guided ? 0.0 : held, end == End::fixed || end == End::guided ? held : 0.0};
}

/// An elastic end: a missing stiffness means free rotation, and no lateral displacement.
column::End end_of(End end, double mu, double kappa) {
  if (end != End::elastic) return rigid(end);
  return {is_set(mu) ? mu : held, is_set(kappa) ? kappa : 0.0};
}

Bar bar_of(const Input& in, const Result& r) {
  Bar bar{end_of(in.end_1, r.mu_1, r.kappa_1), end_of(in.end_2, r.mu_2, r.kappa_2), {}};
  if (is_set(in.G_1)) {
    const bool sways = in.frame == EffectiveLength::Frame::sway;
    const auto turning = [](double kappa) { return is_set(kappa) ? kappa : held; };  // G = 0 is built in
    bar.start = {held, turning(r.kappa_1)};
    bar.end = {sways ? 0.0 : held, turning(r.kappa_2)};
  }
  for (const auto& support : in.supports) bar.supports.push_back(support.x / in.l);
  return bar;
}

/// What holds an end against rigid motion of the bar: across it, and against turning.
struct Hold {
  bool across = false, turning = false;
};

Hold hold_of(End end, Moment c, Stiffness k) {
  if (end != End::elastic) return {rigid(end).across > 0.0, rigid(end).turning > 0.0};
  return {!(k <= 0.0 * N_per_mm), c > 0.0 * N_m_per_rad};  // k omitted is rigid, c omitted a hinge
}

/// A mode above the first.
template <class Tracer>
void add_higher(const Input& in, Result& r, Tracer& trace) {
  if (in.mode < 2) return;
  trace.value("mode", in.mode, "number of the root");
  const double u_n = r.u_n = buckling_parameter(bar_of(in, r), static_cast<int>(in.mode));
  trace.value("u_n", u_n, "root of the characteristic equation of that number, [Wittrick]");
  STEP_TO(r, beta_n, pi / u_n, "the hinged bar that buckles at the same force, [B25]");
  if (!is_set(in.E) || !is_set(in.I)) return;
  STEP_TO(r, N_cr_n, pow<2>(u_n) * in.E * in.I / pow<2>(in.l),
          "critical force of the mode, if the lower ones are prevented");
}

}  // namespace

bool EffectiveLength::ends_or_frame(const Input& in) {
  const bool first = in.end_1 != End::unsaid, second = in.end_2 != End::unsaid;
  const bool frame_1 = is_set(in.G_1), frame_2 = is_set(in.G_2);
  return first == second && frame_1 == frame_2 && first != frame_1;
}

bool EffectiveLength::springs_fit_ends(const Input& in) {
  const auto fits = [](End end, Moment c, Stiffness k) { return (end == End::elastic) == (is_set(c) || is_set(k)); };
  return fits(in.end_1, in.c_1, in.k_1) && fits(in.end_2, in.c_2, in.k_2);
}

bool EffectiveLength::supports_inside(const Input& in) {
  Length before = 0.0 * mm;
  return std::all_of(in.supports.begin(), in.supports.end(), [&](const Support& support) {
    const bool inside = support.x > before && support.x < in.l;
    before = support.x;
    return inside;
  });
}

/// A bar moves as a rigid body unless it is held across at one place, and at a second one or against turning. The
/// joints of a frame hold it always.
bool EffectiveLength::is_held(const Input& in) {
  if (in.end_1 == End::unsaid || in.end_2 == End::unsaid) return true;  // another rule states it
  const Hold first = hold_of(in.end_1, in.c_1, in.k_1), second = hold_of(in.end_2, in.c_2, in.k_2);
  const std::size_t across = (first.across ? 1U : 0U) + (second.across ? 1U : 0U) + in.supports.size();
  return across >= 2 || (across == 1 && (first.turning || second.turning));
}

/// The end that is held less.
FieldFault EffectiveLength::loose_end(const Input& in) {
  const Hold first = hold_of(in.end_1, in.c_1, in.k_1), second = hold_of(in.end_2, in.c_2, in.k_2);
  const bool is_first = !first.across && second.across;
  return {is_first ? "end_1" : "end_2", {}, say("a fixed end is enough; or give pinned ends, springs or supports")};
}

template <class Tracer>
Result EffectiveLength::evaluate(const Input& in, Tracer& trace) {
  Result r;
  if (is_set(in.G_1)) take_joints(in, r, trace);
  compare_springs(in, r, trace);
  const double u = r.u = buckling_parameter(bar_of(in, r));
  trace.value("u", u, "smallest root of the characteristic equation, by the exact stiffness, [Wittrick]");
  if (!is_set(u)) return r;
  STEP_TO(r, beta, pi / u, "the hinged bar that buckles at the same force, [B25]");
  STEP_TO(r, s, beta * in.l, "effective length, [B25]");
  add_higher(in, r, trace);
  if (!is_set(in.E) || !is_set(in.I)) return r;
  STEP_TO(r, N_cr, pow<2>(pi) * in.E * in.I / pow<2>(s), "elastic critical (Euler) load, [B25]");
  return r;
}

template Result EffectiveLength::evaluate(const Input&, NoTrace&);
template Result EffectiveLength::evaluate(const Input&, Trace&);

std::vector<figure::Figure> EffectiveLength::figures(const Input& in, const Result& r) {
  if (!is_set(r.u)) return {};
  Shape shape = buckled_shape(bar_of(in, r), r.u);
  for (double& x : shape.x) x *= in_si(in.l);
  figure::Plot plot;
  plot.x = {"x", "position along the bar", "mm"};
  plot.y = {"w", "deflection / maximum deflection", "-"};
  plot.curves.push_back({"w", std::move(shape.x), std::move(shape.w), false});
  if (is_set(r.u_n)) {
    Shape higher = buckled_shape(bar_of(in, r), r.u_n);
    for (double& x : higher.x) x *= in_si(in.l);
    plot.curves.front().label = "mode 1";
    plot.curves.push_back(
        {"mode " + std::to_string(static_cast<int>(in.mode)), std::move(higher.x), std::move(higher.w), false});
  }
  return {{"buckled-shape", "Buckling mode shape", std::move(plot)}};
}

}  // namespace loadpath::column

template const loadpath::Calculator& loadpath::erased<loadpath::column::EffectiveLength>();
