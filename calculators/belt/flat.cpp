#include "calculators/belt/flat.hpp"

#include "calculators/belt/figures.hpp"
#include "calculators/belt/shaft_load.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::belt {

namespace {

Pulleys pulleys_of(const Flat::Input& in) { return {in.d_1, in.d_2, in.a, in.L, in.arrangement}; }

template <class Tracer>
void move(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  const auto n_1 = in.n_1;
  const auto d_1 = in.d_1, d_2 = in.d_2;
  const auto epsilon = in.epsilon;
  STEP(i, d_2 / d_1 / (1.0 - epsilon), "transmission ratio with slip, [B40]");
  STEP(n_2, n_1 / i, "speed of the driven pulley");
  STEP(v, n_1 * d_1 / 2.0, "speed of the belt");
  r.i = i, r.n_2 = n_2, r.v = v;
}

template <class Tracer>
void pull(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  const auto K_A = in.K_A, mu = in.mu;
  const auto v = r.v;
  const auto alpha_1 = r.alpha_1, alpha_2 = r.alpha_2;
  if (is_set(in.T_1)) {
    const auto T_1 = in.T_1;
    const auto d_1 = in.d_1;
    STEP(F_t, 2.0 * K_A * T_1 / d_1, "force that the belt carries over");
    r.F_t = F_t;
  } else {
    const auto P = in.P;
    STEP(F_t, K_A * P / v, "force that the belt carries over");
    r.F_t = F_t;
  }
  STEP(m_e, exp(mu * min(alpha_1, alpha_2)), "Euler's condition at the smaller wrap, [B40]; tight over slack");
  r.m_e = m_e;
}

/// The stress that is left for pulling, and the least width.
template <class Tracer>
void size(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  const auto d_1 = in.d_1, d_2 = in.d_2, delta = in.delta;
  const auto sigma_adm = in.sigma_adm;
  const auto rho = in.rho;
  const auto v = r.v;
  const auto F_t = r.F_t;
  const auto m_e = r.m_e;
  r.sigma_b = from_si<Stress>(0.0);
  if (is_set(in.E_b)) {
    const auto E_b = in.E_b;
    STEP(sigma_b, E_b * delta / min(d_1, d_2), "bending around the smaller pulley");
    r.sigma_b = sigma_b;
  } else {
    trace.value("sigma_b", r.sigma_b, "the allowable stress holds for the given pulleys");
  }
  const auto sigma_b = r.sigma_b;
  STEP(sigma_c, rho * v * v, "centrifugal stress");
  STEP(sigma_N, sigma_adm - sigma_b - sigma_c, "left for pulling");
  r.sigma_c = sigma_c, r.sigma_N = sigma_N;
  if (!(sigma_N > from_si<Stress>(0.0))) return;
  STEP(v_opt, sqrt((sigma_adm - sigma_b) / (3.0 * rho)), "largest power where F_t v has its maximum");
  STEP(b_min, F_t / (delta * sigma_N * (1.0 - 1.0 / m_e)), "stress and friction both at their limit, [Shigley-17]");
  r.v_opt = v_opt, r.b_min = b_min;
}

/// The tensions: as they result from the initial tension, or with the least one.
template <class Tracer>
void tighten(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  const auto b = r.b, delta = in.delta;
  const auto rho = in.rho;
  const auto v = r.v;
  const auto F_t = r.F_t;
  const auto m_e = r.m_e, alpha_1 = r.alpha_1, alpha_2 = r.alpha_2;
  STEP(F_c, rho * b * delta * v * v, "turns the belt around, and does not press the pulleys");
  STEP(N_min, F_t / 2.0 * (m_e + 1.0) / (m_e - 1.0), "least mean of the tensions that press, [Shigley-17]");
  const bool fixed = in.tensioning == Flat::Tensioning::fixed;
  const Force lost = fixed ? F_c : 0.0 * F_c;
  trace.value("F_lost", lost,
              fixed ? "on fixed centres the centrifugal part relieves the pulleys" : "the tensioner makes up for it");
  const auto F_lost = lost;
  STEP(S_0_min, N_min + F_lost, "least initial tension at standstill");
  r.S_0 = is_set(in.S_0) ? in.S_0 : S_0_min;
  const auto S_0 = r.S_0;
  trace.value("S_0", S_0, is_set(in.S_0) ? "as given" : "the least one");
  STEP(S_1, S_0 - F_lost + F_c + F_t / 2.0, "tight span");
  STEP(S_2, S_1 - F_t, "slack span");
  r.F_c = F_c, r.S_0_min = S_0_min, r.S_1 = S_1, r.S_2 = S_2;
  if (S_2 > F_c) {
    STEP(mu_req, log((S_1 - F_c) / (S_2 - F_c)) / min(alpha_1, alpha_2), "friction that is used, [Shigley-17]");
    r.mu_req = mu_req;
  }
  STEP(u_S, S_0_min / S_0, "friction condition");
  r.u_S = u_S;
}

template <class Tracer>
void judge(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  const auto b = r.b, delta = in.delta, L = r.L;
  const auto sigma_b = r.sigma_b, sigma_adm = in.sigma_adm;
  const auto S_0 = r.S_0, S_1 = r.S_1, S_2 = r.S_2, F_c = r.F_c;
  const auto gamma = r.gamma;
  const auto v = r.v;
  STEP(sigma_max, S_1 / (b * delta) + sigma_b, "tight span at the smaller pulley");
  STEP(u_sigma, sigma_max / sigma_adm, "strength condition");
  STEP(R_0, 2.0 * S_0 * cos(gamma), "shaft load at standstill");
  r.sigma_max = sigma_max, r.u_sigma = u_sigma, r.R_0 = R_0;
  STEP(N_1, S_1 - F_c, "tight span: what presses the pulley");
  STEP(N_2, S_2 - F_c, "slack span: what presses the pulley");
  const auto load = shaft_load(N_1, N_2, in.arrangement == Arrangement::crossed ? -gamma : gamma, trace);
  r.R_x = load.R_x, r.R_y = load.R_y, r.R = load.R, r.theta_R = load.theta_R;
  STEP(f_B, 2.0 * v / L, "two pulleys bend the belt in each round");
  r.f_B = f_B;
}

template <class Tracer>
void limit_speed(const Flat::Input& in, Flat::Result& r, Tracer& trace) {
  const auto v = r.v;
  const bool synthetic = in.kind == Flat::Kind::synthetic;
  const Speed v_max = (synthetic ? 100.0 : 30.0) * m_per_s;
  trace.value("v_max", v_max, synthetic ? "largest speed of a synthetic belt, [B40]" : "largest speed, [B40]");
  STEP(x_v, v / v_max, "speed over the largest one");
  r.x_v = x_v, r.v_range = v;
}

}  // namespace

bool Flat::clear_of_each_other(const Input& in) {
  return is_set(in.a) == is_set(in.L) || stand_clear(pulleys_of(in));  // the other rule speaks of a and L
}
FieldFault Flat::touching(const Input& in) { return overlap(pulleys_of(in)); }

template <class Tracer>
Flat::Result Flat::evaluate(const Input& in, Tracer& trace) {
  Result r;
  move(in, r, trace);
  const auto course = lay(pulleys_of(in), trace);
  r.a = course.a, r.L = course.L, r.l_s = course.l_s;
  r.gamma = course.gamma, r.alpha_1 = course.alpha_1, r.alpha_2 = course.alpha_2;
  limit_speed(in, r, trace);
  pull(in, r, trace);
  size(in, r, trace);
  r.b = is_set(in.b) ? in.b : r.b_min;
  tighten(in, r, trace);
  judge(in, r, trace);
  return r;
}

template Flat::Result Flat::evaluate(const Input&, NoTrace&);
template Flat::Result Flat::evaluate(const Input&, Trace&);

std::vector<draw::Figure> Flat::figures(const Input& in, const Result& r) {
  return {drive_figure(in.d_1, in.d_2, r.a, in.arrangement)};
}

}  // namespace loadpath::belt

template const loadpath::Calculator& loadpath::erased<loadpath::belt::Flat>();
