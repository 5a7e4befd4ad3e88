#include "calculators/bearing/rolling.hpp"

#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::bearing {

namespace {

using Input = Rolling::Input;
using Result = Rolling::Result;
using Stage = Rolling::Stage;
using Stages = List<Stage, Rolling::most_blocks>;

/// Of a block, with K_A; the axial load is positive in the direction that the bearing carries.
struct Loads {
  Force F_r, F_a;
};
using Spectrum = List<Loads, Rolling::most_blocks>;

constexpr Force none = 0.0 * N.one;

/// Equivalent load of the rotating bearing.
struct Equivalent {
  double x_f = unset<double>, e = unset<double>, Y = unset<double>;
  Force P = unset<Force>;
};

/// e and Y of the manufacturer's table, or by f_0. Y is shown where the formula of the load needs it.
template <class Tracer>
void find_factors(const Input& in, Force F_aK, Equivalent& q, Tracer& trace) {
  q.e = in.e, q.Y = in.Y;
  if (!is_set(in.f_0)) {
    trace.value("e", q.e, "manufacturer's value");
    return;
  }
  STEP_TO(q, x_f, in.f_0 * F_aK / in.C_0, "parameter of e and Y of a deep groove ball bearing, [ISO281]");
  const DeepGroove found = deep_groove_at(x_f);
  q.e = trace.value("e", found.e, "straight between the rows of [ISO281], [Koyo]");
  q.Y = found.Y;
}

/// The equivalent load of an axial load up to e F_rK.
template <class Tracer>
void within_e(const Input& in, Force F_rK, Force F_aK, Equivalent& q, Tracer& trace) {
  if (!has_two_rows(in.kind)) {
    STEP_TO(q, P, F_rK, "F_a ≤ e F_r: radial load only, [ISO281]");
    return;
  }
  const double Y_1 = trace.value("Y_1", in.Y_1, "manufacturer's value");
  STEP_TO(q, P, F_rK + Y_1 * F_aK, "F_a ≤ e F_r: equivalent dynamic load, [ISO281]");
}

/// The equivalent load of an axial load beyond e F_rK.
template <class Tracer>
void beyond_e(const Input& in, Force F_rK, Force F_aK, Equivalent& q, Tracer& trace) {
  const double X = trace.value("X", is_set(in.X) ? in.X : radial_factor(in.kind),
                               is_set(in.X) ? "manufacturer's value" : "of the kind, [ISO281]");
  const double Y =
      trace.value("Y", q.Y, is_set(in.f_0) ? "straight between the rows of [ISO281], [Koyo]" : "manufacturer's value");
  STEP_TO(q, P, X * F_rK + Y * F_aK, "F_a > e F_r: equivalent dynamic load, [ISO281]");
}

/// The equivalent load of F_rK and F_aK, which hold K_A.
template <class Tracer>
Equivalent equivalent(const Input& in, Force F_rK, Force F_aK, Tracer& trace) {
  Equivalent q;
  if (takes_axial_alone(in.kind)) {
    STEP_TO(q, P, F_aK, "a thrust bearing takes axial load only, [ISO281]");
    return q;
  }
  if (takes_radial_alone(in.kind) || F_aK == none) {
    STEP_TO(q, P, F_rK, "radial load only, [ISO281]");
    return q;
  }
  find_factors(in, F_aK, q, trace);
  const double e = q.e;
  STEP(F_e, e * F_rK, "limit of the axial load up to which X = 1, [ISO281]");
  if (F_aK > F_e)
    beyond_e(in, F_rK, F_aK, q, trace);
  else
    within_e(in, F_rK, F_aK, q, trace);
  return q;
}

/// Without a given speed the bearing rotates, and its life is in revolutions.
bool turns(const Stage& s) { return !(s.n <= 0.0 * rpm.one); }

/// The viscosity ratio of a block and its a_ISO, where lubricant and contamination are given.
template <class Tracer>
void modify(const Input& in, Stage& s, Tracer& trace) {
  if (!has_film(in) || !turns(s)) return;
  s.kappa =
      trace.value("kappa", is_set(in.kappa) ? in.kappa : in_si(in.nu / reference_viscosity(s.n, 0.5 * (in.d + in.D))),
                  is_set(in.kappa) ? "viscosity ratio as given"
                                   : "viscosity over that for this speed and pitch diameter, [ISO281-aISO]");
  s.a_ISO =
      trace.value("a_ISO", a_ISO_of(in.kind, s.kappa, in.e_C * in.C_u / s.P), "by kappa and e_C C_u/P, [ISO281-aISO]");
}

/// The loads of a block: its own, or k times those of the step.
template <class Tracer>
Loads loads_of(const Input& in, const Block& b, const Loads& step, Tracer& trace) {
  const double k = trace.value("k", b.k, "loads of the block over those of the step");
  const Force F_rd = step.F_r, F_ad = abs(step.F_a);
  const Force own_F_a = is_set(b.F_a) ? thrust_of_block(in, b) : step.F_a;
  const Force F_rK = is_set(b.F_r) ? trace.value("F_rK", in.K_A * b.F_r, "own radial load of the block, with K_A")
                                   : NAMED_STEP("F_rK", k * F_rd, "radial load of the block");
  const Force F_aK = is_set(b.F_a) ? trace.value("F_aK", in.K_A * abs(own_F_a), "own axial load of the block, with K_A")
                                   : NAMED_STEP("F_aK", k * F_ad, "axial load of the block");
  return {F_rK, own_F_a < none ? -F_aK : F_aK};
}

/// One block for all where none is given.
template <class Tracer>
Stages stages(const Input& in, const Loads& step, const Equivalent& whole, Spectrum& loads, Tracer& trace) {
  Stages all;
  for (std::size_t i = 0; i < in.blocks.size(); ++i) {
    [[maybe_unused]] const auto here = trace.scope("blocks", i);
    const Block& b = in.blocks[i];
    loads.push_back(loads_of(in, b, step, trace));
    const Equivalent q = equivalent(in, loads.back().F_r, abs(loads.back().F_a), trace);
    all.push_back({b.name, b.q, is_set(b.n) ? b.n : in.n, q.e, q.Y, q.P});
    modify(in, all.back(), trace);
  }
  if (in.blocks.empty()) {
    all.push_back({Name(), 1.0, in.n, whole.e, whole.Y, whole.P});
    loads.push_back(step);
    modify(in, all.back(), trace);
  }
  return all;
}

Force largest(const Stages& all) {
  Force P = none;
  for (const Stage& s : all) {
    if (turns(s)) P = std::max(P, s.P);
  }
  return P;
}

Force smallest(const Stages& all) {
  Force P = largest(all);
  for (const Stage& s : all) {
    if (turns(s)) P = std::min(P, s.P);
  }
  return P;
}

/// The largest loads over all blocks, which need not act together, and the largest axial one in turning.
struct Largest {
  Force F_r = none, F_a = none, F_a_turning = none;
};

/// Where blocks have shares of the loads of the step, the formulas show them.
template <class Tracer>
Largest largest_of(const Input& in, const Loads& step, const Stages& all, const Spectrum& loads, Tracer& trace) {
  Largest most;
  double k_max = in.blocks.empty() ? 1.0 : 0.0, k_run = k_max;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Force F_a = abs(loads[i].F_a);
    most.F_r = std::max(most.F_r, loads[i].F_r), most.F_a = std::max(most.F_a, F_a);
    if (turns(all[i])) most.F_a_turning = std::max(most.F_a_turning, F_a);
    const double k = in.blocks.empty() ? 1.0 : in.blocks[i].k;
    k_max = std::max(k_max, k), k_run = turns(all[i]) ? std::max(k_run, k) : k_run;
  }
  if (has_own_loads(in)) {
    trace.value("F_rX", most.F_r, "maximum radial load of the blocks");
    trace.value("F_aX", most.F_a, "maximum axial load of the blocks");
    trace.value("F_aT", most.F_a_turning, "maximum axial load in turning");
    return most;
  }
  trace.value("k_max", k_max, "maximum of the blocks");
  trace.value("k_run", k_run, "maximum of those in which it turns");
  const Force F_rd = step.F_r, F_ad = abs(step.F_a);
  STEP(F_rX, k_max * F_rd, "maximum radial load of the blocks");
  STEP(F_aX, k_max * F_ad, "maximum axial load of the blocks");
  STEP(F_aT, k_run * F_ad, "maximum axial load in turning");
  return {F_rX, F_aX, F_aT};
}

/// The factor of all blocks: that of one, or the mean by the damage that they do.
template <class Tracer>
void film(const Stages& all, double mean, Result& r, Tracer& trace) {
  double kappa = std::numeric_limits<double>::infinity();
  for (const Stage& s : all) kappa = std::min(kappa, is_set(s.kappa) ? s.kappa : kappa);
  if (!std::isfinite(kappa)) return;
  r.x_k = trace.value("x_k", kappa, "smallest of the blocks");
  const double a_ISO = all.size() == 1 ? all.front().a_ISO : mean;
  if (is_set(a_ISO)) r.a_ISO = trace.value("a_ISO", a_ISO, "mean over the blocks by their damage, [ISO281-aISO]");
}

/// Mean speed and mean load, and the share of each block in the fatigue; of a bearing that runs.
template <class Tracer>
void means(Stages& all, Result& r, Tracer& trace) {
  const double P_max = in_si(largest(all));
  double turns = 0.0, wear = 0.0, damage = 0.0;
  for (Stage& s : all) {
    const double part = s.q * in_si(s.n), load = P_max > 0.0 ? part * std::pow(in_si(s.P) / P_max, r.p) : 0.0;
    s.D = is_set(s.a_ISO) ? load / s.a_ISO : load;
    turns += part, wear += load, damage += s.D;
  }
  for (Stage& s : all) s.D = damage > 0.0 ? s.D / damage : 0.0;
  film(all, wear / damage, r, trace);
  const double P_m = all.size() == 1 ? P_max : P_max * std::pow(wear / turns, 1.0 / r.p);
  if (is_set(turns)) r.n_m = trace.speed("n_m", from_si<AngularSpeed>(turns), "sum of q n over the blocks");
  r.P_m = trace.value("P_m", from_si<Force>(P_m),
                      "mean of P to the power p over the revolutions of the blocks, by linear damage, [SEED-bearings]");
}

/// Life in revolutions and hours; none if under almost no load it exceeds the range of numbers.
template <class Tracer>
void life(const Input& in, const Stages& all, Result& r, Tracer& trace) {
  const Force P_max = trace.value("P_max", largest(all), "maximum load in running");
  STEP(P_lim, is_set(in.C_0) ? min(0.5 * in.C, in.C_0) : 0.5 * in.C, "beyond, bodies and raceways yield, [ISO281]");
  STEP_TO(r, x_P, P_max / P_lim, "within the validity of the rating life");
  const Force P_m = r.P_m;
  const double p = r.p;
  const AngularSpeed n_m = r.n_m;
  const double a_film = trace.value("a_film", is_set(r.a_ISO) ? r.a_ISO : 1.0,
                                    is_set(r.a_ISO) ? "a_ISO" : "lubricant and contamination are not included");
  const double a_rel = is_set(in.R) ? trace.value("a_rel", a_1_of(in.R), "a_1 of this reliability, [ISO281]") : in.a_1;
  const char* const why = "for reliability, lubricant and contamination";
  const double a_L = is_set(in.R) ? NAMED_STEP("a_L", a_rel * a_film, why) : NAMED_STEP("a_L", in.a_1 * a_film, why);
  if (is_set(in.L_h) || is_set(in.L_m)) {
    const double L_req = is_set(in.L_m)
                             ? trace.value("L_req", in.L_m, "required life in millions of revolutions")
                             : NAMED_STEP("L_req", in.L_h * n_m / (2.0 * pi * 1e6), "millions of revolutions");
    STEP_TO(r, C_req, P_m * pow(L_req / a_L, 1.0 / p), "load rating required for this life, [ISO281]");
    STEP_TO(r, u_L, C_req / in.C, "required / actual load rating");
    r.R_L = trace.value("R_L", reliability_of(L_req * std::pow(in_si(P_m) / in_si(in.C), p) / a_film),
                        "Weibull distribution of the lives, [ISO281]");
  }
  if (!(P_m > 1e-4 * in.C)) return;
  STEP_TO(r, L_10, pow(in.C / P_m, p), "millions of revolutions, 90 %, [ISO281]");
  if (!is_set(n_m)) return;
  STEP_TO(r, L_10h, 2.0 * pi * 1e6 * L_10 / n_m, "at the mean speed");
  STEP_TO(r, L_nh, a_L * L_10h, "with the required reliability, and a_ISO where given");
}

template <class Tracer>
void running(const Input& in, Stages& all, Result& r, Tracer& trace) {
  means(all, r, trace);
  life(in, all, r, trace);
  const Force P_low = trace.value("P_low", smallest(all), "minimum load in running");
  const double c = trace.value("c", has_balls(in.kind) ? 0.01 : 0.02, has_balls(in.kind) ? "balls" : "rollers");
  STEP(P_need, is_set(in.P_min) ? in.P_min : c * in.C,
       is_set(in.P_min) ? "manufacturer's value" : "rule of thumb, [SKF-rolling]");
  // Below a rule of thumb it may still roll: preloaded, or by the formula of the manufacturer.
  if (is_set(in.P_min) || P_low >= (1.0 - 1e-9) * P_need) {
    STEP_TO(r, x_min, P_low / P_need, "rolls, and does not skid");
  }
  if (!is_set(in.n_max) || !is_set(Rolling::highest_speed(in))) return;
  const AngularSpeed n_top = trace.speed("n_top", Rolling::highest_speed(in), "highest speed");
  STEP_TO(r, u_n, n_top / in.n_max, "compared with the manufacturer's value");
}

/// The largest load at rest, in running or in a shock.
template <class Tracer>
void at_rest(const Input& in, const Thrust& thrust, Force F_rX, Force F_aX, Result& r, Tracer& trace) {
  STEP(F_r00, is_set(in.F_r0) ? in.F_r0 : 0.0 * N, "radial, at rest or in a shock");
  const Force F_a00 = trace.value("F_a00", abs(thrust.F_a0), "axial at the same time");
  if (takes_axial_alone(in.kind)) {
    STEP_TO(r, P_0, max(F_aX, F_a00), "a thrust bearing takes axial load only, [ISO76]");
  } else {
    const bool axial = Rolling::has_axial(in);
    const double X_0 = trace.value("X_0", static_radial_factor(in.kind), "of the kind, [ISO76]");
    const double Y_k = static_axial_factor(in.kind);
    const double Y_0 = trace.value("Y_0",
                                   is_set(in.Y_0) ? in.Y_0
                                   : !axial       ? 0.0
                                                  : Y_k,
                                   is_set(in.Y_0) ? "manufacturer's value"
                                   : axial        ? "of the kind, [ISO76]"
                                                  : "without an axial load");
    if (!is_set(Y_0)) return;
    STEP(P_0r, max(F_rX, X_0 * F_rX + Y_0 * F_aX), "in running, [ISO76]");
    STEP(P_00, max(F_r00, X_0 * F_r00 + Y_0 * F_a00), "at rest or in a shock, [ISO76]");
    STEP_TO(r, P_0, max(P_0r, P_00), "the larger");
  }
  if (!is_set(in.s_0)) return;
  STEP_TO(r, u_0, in.s_0 * r.P_0 / in.C_0, "no dents of more than 1/10000 of a ball or roller, [ISO76]");
}

/// Axial load beyond the kind: in the wrong direction, or more than half of the radial load on ribs.
Force refused(Kind kind, Force F_r, Force F_a) {
  if (takes_radial_alone(kind)) return abs(F_a);
  Force over = none;
  if (takes_one_way(kind)) over = std::max(over, -F_a);
  if (bears_on_ribs(kind)) over = std::max(over, abs(F_a) - 0.5 * F_r);
  return over;
}

/// The axial load of a kind, its direction and its size.
template <class Tracer>
void axial(const Input& in, const Thrust& thrust, const Spectrum& loads, const Largest& most, Result& r,
           Tracer& trace) {
  const Force F_a0 = thrust.F_a0, F_r0 = is_set(in.F_r0) ? in.F_r0 : none;
  Force over = bears_on_ribs(in.kind) ? refused(in.kind, 2.0 * abs(F_a0), F_a0) : refused(in.kind, F_r0, F_a0);
  for (const Loads& load : loads) over = std::max(over, refused(in.kind, load.F_r, load.F_a));
  r.F_ao =
      trace.value("F_ao", over, "wrong direction, or no ribs; on ribs more than half the radial load, [SKF-rolling]");
  const Force F_rX = most.F_r, F_aX = most.F_a;
  r.F_ro = trace.value("F_ro", takes_axial_alone(in.kind) ? std::max(F_rX, F_r0) : none, "on a thrust bearing");
  if (Rolling::has_axial_bound(in) == Applies::yes && (is_set(in.F_a_adm) || is_set(in.C_0))) {
    if (bears_on_ribs(in.kind) && !is_set(in.F_a_adm)) return;
    STEP(F_aa, is_set(in.F_a_adm) ? in.F_a_adm : 0.5 * in.C_0,
         is_set(in.F_a_adm) ? "manufacturer's value" : "of a deep groove ball bearing, [SKF-rolling]");
    const Force F_a_all = trace.value("F_a_all", std::max(F_aX, abs(F_a0)), "maximum axial load");
    STEP_TO(r, u_a, F_a_all / F_aa, "against the allowed one");
  }
}

template <class Tracer>
void by_itself(const Input& in, const Thrust& thrust, const Spectrum& loads, Force F_rK, Force F_aK, Result& r,
               Tracer& trace) {
  if (!at_an_angle(in.kind) || !(F_rK > 1e-9 * in.C)) return;
  STEP_TO(r, F_i, in.c_i * F_rK / in.Y, "half of the rollers carry the load, [LYC-bearings]");
  const Force F_a_way = trace.value("F_a_way", thrust.F_a > none ? F_aK : none, "axial load that presses into it");
  STEP_TO(r, x_i, F_a_way / F_i, "the mating bearing holds against it, so that it is never less");
  for (const Loads& load : loads) {
    if (load.F_r > 1e-9 * in.C)
      r.x_i = std::min(r.x_i, std::max(in_si(load.F_a), 0.0) / in_si(in.c_i * load.F_r / in.Y));
  }
  if (r.x_i < x_i) trace.value("x_i", r.x_i, "the smallest of the blocks");
}

}  // namespace

template <class Tracer>
Rolling::Result Rolling::evaluate(const Input& in, Tracer& trace) {
  Result r;
  r.p = trace.value("p", has_balls(in.kind) ? 3.0 : 10.0 / 3.0, has_balls(in.kind) ? "balls" : "rollers");
  STEP(F_rd, in.K_A * in.F_r, "radial load");
  const Thrust shared = thrust(in, trace);
  const Force F_ax = shared.F_a;
  r.F_ax = F_ax;
  STEP(F_ad, in.K_A * abs(F_ax), "axial load");
  const Force F_rK = trace.value("F_rK", F_rd, "load as given"), F_aK = trace.value("F_aK", F_ad, "load as given");
  const Equivalent q = equivalent(in, F_rK, F_aK, trace);
  r.x_f = q.x_f, r.e = q.e, r.Y = q.Y, r.P = q.P;
  if (has_mate(in) && !is_set(r.Y)) r.Y = trace.value("Y", in.Y, "manufacturer's value");
  Spectrum loads;
  const Loads whole{F_rd, F_ax < none ? -F_ad : F_ad};
  Stages all = stages(in, whole, q, loads, trace);
  const Largest most = largest_of(in, whole, all, loads, trace);
  const Force F_aT = most.F_a_turning;
  if (is_set(in.f_0) && (is_set(r.x_f) || F_aT > none)) {
    r.x_f = NAMED_STEP("x_f", in.f_0 * F_aT / in.C_0, "of the maximum axial load in turning");
  }
  if (runs(in) == Applies::yes) running(in, all, r, trace);
  if (!in.blocks.empty()) r.blocks = all;
  at_rest(in, shared, most.F_r, most.F_a, r, trace);
  axial(in, shared, loads, most, r, trace);
  by_itself(in, shared, loads, F_rK, F_aK, r, trace);
  pressure_centre(in, r, trace);
  seat(in, r, trace);
  return r;
}

template Rolling::Result Rolling::evaluate(const Input&, NoTrace&);
template Rolling::Result Rolling::evaluate(const Input&, Trace&);

}  // namespace loadpath::bearing

template const loadpath::Calculator& loadpath::erased<loadpath::bearing::Rolling>();
