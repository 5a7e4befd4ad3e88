#include "calculators/chain/roller.hpp"

#include "calculators/chain/links.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/format.hpp"

namespace loadpath::chain {

namespace {

using Input = Roller::Input;
using Result = Roller::Result;

/// The closest that the sprockets may stand: their tips touch, about 0.6 p above the half pitch circles.
Length closest(const Input& in) {
  const double pitch_radii = 0.5 / std::sin(pi / in.z_1) + 0.5 / std::sin(pi / in.z_2);
  return (pitch_radii + 0.6) * in.p;
}

/// Links, rounded to the even number that is nearest.
double even(double links) { return 2.0 * std::round(0.5 * links); }

template <class Tracer>
void links(const Input& in, Result& r, Tracer& trace) {
  const auto p = in.p;
  const double z_1 = in.z_1, z_2 = in.z_2;
  const auto a_wanted = in.a;
  if (is_set(a_wanted)) {
    r.X_0 = links_at(a_wanted / p, z_1, z_2);
    trace.value("X_0", r.X_0, "links at the wanted centre distance, exact for circles of z pitches, [ISO10823]");
  }
  r.X = in.X > 0 ? in.X : even(r.X_0);
  const double X = r.X;
  trace.value("X", X, in.X > 0 ? "as given" : "the nearest even number");
  STEP(L, X * p, "length of the chain");
  const double a_p = pitches_of(X, z_1, z_2);
  trace.value("a_p", a_p, "centre distance in pitches that belongs to the links, exact, [ISO10823]");
  STEP(a, a_p * p, "taut; 0.2 to 0.4 % less gives the slack strand its sag");
  r.L = L, r.a_p = a_p, r.a = a, r.odd = std::fmod(X, 2.0);
}

template <class Tracer>
void sprockets(const Input& in, Result& r, Tracer& trace) {
  const auto p = in.p;
  const auto a = r.a;
  const double z_1 = in.z_1, z_2 = in.z_2;
  STEP(i, z_2 / z_1, "mean ratio");
  STEP(d_1, p / sin(pi / z_1), "pitch circle through the pins, [Strokeforge]");
  STEP(d_2, p / sin(pi / z_2), "pitch circle through the pins, [Strokeforge]");
  STEP(alpha_1, pi - 2.0 * asin((d_2 - d_1) / (2.0 * a)), "wrap, [Strokeforge]");
  STEP(alpha_2, 2.0 * pi - alpha_1, "wrap of the other sprocket");
  STEP(delta_1, 1.0 - cos(pi / z_1), "chain speed between the corners of the polygon, [Strokeforge]");
  STEP(delta_2, 1.0 - cos(pi / z_2), "the same at the driven sprocket");
  r.i = i, r.d_1 = d_1, r.d_2 = d_2, r.alpha_1 = alpha_1, r.alpha_2 = alpha_2, r.delta_1 = delta_1, r.delta_2 = delta_2;
  r.z_min = std::min(z_1, z_2);
}

template <class Tracer>
void speeds(const Input& in, Result& r, Tracer& trace) {
  const auto p = in.p;
  const auto n_1 = in.n_1;
  const double z_1 = in.z_1, i = r.i;
  STEP(n_2, n_1 / i, "mean speed");
  STEP(v, z_1 * p * n_1 / (2.0 * pi), "mean speed of the chain");
  r.n_2 = n_2, r.v = v;
  if (in.lubrication == Roller::Lubrication::grease) {
    r.v_share = NAMED_STEP("v_share", v / (6.0 * m_per_s), "up to 6 m/s, [B40]");
  } else {
    r.v_share = NAMED_STEP("v_share", v / (12.0 * m_per_s), "up to 12 m/s in an oil bath, [B40]");
  }
}

template <class Tracer>
Moment torque(const Input& in, Tracer& trace) {
  const auto P = in.P;
  const auto n_1 = in.n_1;
  if (!is_set(P)) return in.T_1;
  STEP(T_1, P / n_1, "torque from the power, nominal");
  return T_1;
}

/// Without the mass of the chain its sag and centrifugal force stay out of the largest pull, which is told.
template <class Tracer>
void pulls(const Input& in, Result& r, Tracer& trace) {
  const auto T_1 = r.T_1;
  const auto p = in.p, a = r.a;
  const auto q = is_set(in.q) ? in.q : 0.0 * kg_per_m;
  const double i = r.i, K_A = in.K_A, K_f = in.K_f, strands = in.strands, z_1 = in.z_1;
  STEP(F_t, 2.0 * pi * T_1 / (z_1 * p), "mean pull: the work of a turn over its z_1 pitches");
  STEP(T_2, T_1 * i, "without losses");
  r.F_t = F_t, r.T_2 = T_2;
  trace.value("q", q, is_set(in.q) ? "mass per length of a strand" : "not given: sag and centrifugal force left out");
  const Acceleration g = 9.81 * m_per_s2;
  trace.value("g", g, "gravity");
  const auto v = is_set(r.v) ? r.v : 0.0 * m_per_s;
  if (!is_set(r.v)) trace.value("v", v, "at rest: no speed is given");
  STEP(F_c, strands * q * v * v, "centrifugal force, [Chain-laws]");
  STEP(F_f, K_f * strands * q * g * a, "pull by the sag of the slack strand, [Vunivere]");
  STEP(F, K_A * F_t + F_c + F_f, "largest pull; the service factor stands here once");
  STEP(F_W, K_A * F_t + 2.0 * F_f, "both strands pull, [Vunivere]; the centrifugal force does not reach the shafts");
  r.F_c = F_c, r.F_f = F_f, r.F = F, r.F_W = F_W;
}

template <class Tracer>
void joints(const Input& in, Result& r, Tracer& trace) {
  const auto A = in.A;
  const auto F_t = r.F_t;
  const auto p_adm = in.p_adm;
  const double K_A = in.K_A, strands = in.strands;
  if (!is_set(A)) return;
  STEP(p_r, K_A * F_t / (strands * A), "pressure of the pin in the bush, [Vunivere]");
  r.p_r = p_r;
  if (!is_set(p_adm)) return;
  STEP(u_p, p_r / p_adm, "pressure in the joints");
  r.u_p = u_p;
}

template <class Tracer>
void breaking(const Input& in, Result& r, Tracer& trace) {
  const bool maker = in.edition == Roller::Edition::maker;
  const Force F_1 = maker ? in.F_uM : in.F_u94;
  const double strands = in.strands, S_min = in.S_min;
  const auto F_t = r.F_t, F_c = r.F_c, F_f = r.F_f, F = r.F;
  if (!is_set(F_1) || !is_set(F)) return;
  trace.value("F_1", F_1, maker ? "one strand, of the maker's list" : "one strand, ISO 606:1994");
  STEP(F_u, strands * F_1, "breaking load of all strands");
  STEP(u_F, F / F_u, "the largest pull may not break the chain, whatever safety is asked for");
  r.F_u = F_u, r.u_F = u_F;
  if (!(F > 0.0 * N)) return;
  STEP(S_stat, F_u / (F_t + F_c + F_f), "no design criterion alone: wear and fatigue decide");
  STEP(S_dyn, F_u / F, "with the service factor");
  r.S_stat = S_stat, r.S_dyn = S_dyn;
  if (!is_set(S_min)) return;
  STEP(u_S, S_min / S_dyn, "safety against breaking");
  r.u_S = u_S;
}

template <class Tracer>
void rating(const Input& in, Result& r, Tracer& trace) {
  const auto P = in.P, P_R = in.P_R;
  const double z_min = r.z_min, K_A = in.K_A;
  if (!is_set(P)) return;
  trace.value("z_min", z_min, "teeth of the smaller sprocket");
  STEP(f_2, pow(19.0 / z_min, 1.08), "tooth factor, [ISO10823]");
  STEP(P_c, P * K_A * f_2, "power for which a rating with 19 teeth is chosen, [ISO10823]");
  r.f_2 = f_2, r.P_c = P_c;
  if (!is_set(P_R)) return;
  STEP(u_P, P_c / P_R, "against the rated power");
  r.u_P = u_P;
}

}  // namespace

bool Roller::sprockets_apart(const Input& in) { return !is_set(in.a) || !is_set(in.p) || in.a > closest(in); }

FieldFault Roller::sprockets_touch(const Input& in) {
  return {"a", say("at {1} the sprockets touch each other", format_quantity(in_si(in.a), mm.symbol)),
          say("give more than {1}; 30 to 50 pitches are usual", format_quantity(in_si(closest(in)), mm.symbol))};
}

bool Roller::links_reach(const Input& in) {
  return in.X == 0 || !is_set(in.p) || pitches_of(in.X, in.z_1, in.z_2) * in.p > closest(in);
}

FieldFault Roller::too_few_links(const Input& in) {
  const double least = std::ceil(links_at(closest(in) / in.p, in.z_1, in.z_2));
  return {"X", say("{1} links do not reach around the sprockets", std::to_string(static_cast<int>(in.X))),
          say("give more than {1}", std::to_string(static_cast<int>(least)))};
}

template <class Tracer>
Roller::Result Roller::evaluate(const Input& in, Tracer& trace) {
  Result r;
  links(in, r, trace);
  sprockets(in, r, trace);
  if (is_set(in.n_1)) speeds(in, r, trace);
  r.T_1 = torque(in, trace);
  if (!is_set(r.T_1)) return r;
  pulls(in, r, trace);
  joints(in, r, trace);
  breaking(in, r, trace);
  rating(in, r, trace);
  return r;
}

template Roller::Result Roller::evaluate(const Input&, NoTrace&);
template Roller::Result Roller::evaluate(const Input&, Trace&);

std::vector<draw::Figure> Roller::figures(const Input&, const Result& r) {
  if (!is_set(r.a)) return {};
  draw::Scheme s;
  const double a = in_si(r.a), r_1 = in_si(r.d_1) / 2.0, r_2 = in_si(r.d_2) / 2.0;
  s.wheels = {{{}, r_1, 0.5 * pi}, {{a, 0.0}, r_2, 0.5 * pi}};
  s.belts.push_back({{}, {a, 0.0}, r_1, r_2});
  s.joints = {{"O1", {}, draw::Scheme::Pin::revolute, true}, {"O2", {a, 0.0}, draw::Scheme::Pin::revolute, true}};
  if (is_set(r.F_W) && r.F_W > 0.0 * N) {
    s.arrows = {{{}, {in_si(r.F_W), 0.0}, "F_W1", false}, {{a, 0.0}, {-in_si(r.F_W), 0.0}, "F_W2", false}};
  }
  return {{"chain", "The pitch circles, the chain and what it pulls on the shafts", std::move(s)}};
}

}  // namespace loadpath::chain

template const loadpath::Calculator& loadpath::erased<loadpath::chain::Roller>();
