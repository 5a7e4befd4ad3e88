#include "calculators/motion/compound.hpp"

#include "calculators/motion/path_figures.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <cmath>

namespace loadpath::motion {

namespace {

using Input = Compound::Input;
using Result = Compound::Result;

template <class Tracer>
void add_velocities(const Input& in, Result& r, Tracer& trace) {
  const auto xi = in.xi, eta = in.eta;
  const auto v_xi = in.v_xi, v_eta = in.v_eta, v_zeta = in.v_zeta, v_Ax = in.v_Ax, v_Ay = in.v_Ay;
  const auto omega = in.omega;
  const auto phi = in.phi;
  STEP(v_exi, v_Ax * cos(phi) + v_Ay * sin(phi) - omega * eta, "transport velocity, [B31]");
  STEP(v_eeta, v_Ay * cos(phi) - v_Ax * sin(phi) + omega * xi, "transport velocity, [B31]");
  STEP(v_e, sqrt(v_exi * v_exi + v_eeta * v_eeta), "magnitude");
  STEP(v_r, sqrt(v_xi * v_xi + v_eta * v_eta + v_zeta * v_zeta), "magnitude");
  STEP(v_axi, v_exi + v_xi, "absolute = transport + relative, [B31]");
  STEP(v_aeta, v_eeta + v_eta, "absolute = transport + relative, [B31]");
  STEP(v, sqrt(v_axi * v_axi + v_aeta * v_aeta + v_zeta * v_zeta), "magnitude");
  STEP(v_x, v_axi * cos(phi) - v_aeta * sin(phi), "in the fixed axes");
  STEP(v_y, v_axi * sin(phi) + v_aeta * cos(phi), "in the fixed axes");
  r.v_exi = v_exi, r.v_eeta = v_eeta, r.v_e = v_e, r.v_r = v_r;
  r.v_axi = v_axi, r.v_aeta = v_aeta, r.v = v, r.v_x = v_x, r.v_y = v_y;
}

template <class Tracer>
void add_accelerations(const Input& in, Result& r, Tracer& trace) {
  const auto xi = in.xi, eta = in.eta;
  const auto v_xi = in.v_xi, v_eta = in.v_eta;
  const auto a_xi = in.a_xi, a_eta = in.a_eta, a_zeta = in.a_zeta, a_Ax = in.a_Ax, a_Ay = in.a_Ay;
  const auto omega = in.omega;
  const auto epsilon = in.epsilon;
  const auto phi = in.phi;
  STEP(a_exi, a_Ax * cos(phi) + a_Ay * sin(phi) - epsilon * eta - omega * omega * xi, "of a point of the frame, [B28]");
  STEP(a_eeta, a_Ay * cos(phi) - a_Ax * sin(phi) + epsilon * xi - omega * omega * eta,
       "of a point of the frame, [B28]");
  STEP(a_e, sqrt(a_exi * a_exi + a_eeta * a_eeta), "magnitude");
  STEP(a_r, sqrt(a_xi * a_xi + a_eta * a_eta + a_zeta * a_zeta), "magnitude");
  STEP(a_cxi, -2.0 * omega * v_eta, "Coriolis: twice omega times the relative velocity, turned on by 90 deg, [B31]");
  STEP(a_ceta, 2.0 * omega * v_xi, "Coriolis: twice omega times the relative velocity, turned on by 90 deg, [B31]");
  STEP(a_c, sqrt(a_cxi * a_cxi + a_ceta * a_ceta), "magnitude");
  STEP(a_axi, a_exi + a_xi + a_cxi, "absolute = transport + relative + Coriolis, [B31]");
  STEP(a_aeta, a_eeta + a_eta + a_ceta, "absolute = transport + relative + Coriolis, [B31]");
  STEP(a, sqrt(a_axi * a_axi + a_aeta * a_aeta + a_zeta * a_zeta), "magnitude");
  STEP(a_x, a_axi * cos(phi) - a_aeta * sin(phi), "in the fixed axes");
  STEP(a_y, a_axi * sin(phi) + a_aeta * cos(phi), "in the fixed axes");
  r.a_exi = a_exi, r.a_eeta = a_eeta, r.a_e = a_e, r.a_r = a_r, r.a_cxi = a_cxi, r.a_ceta = a_ceta, r.a_c = a_c;
  r.a_axi = a_axi, r.a_aeta = a_aeta, r.a = a, r.a_x = a_x, r.a_y = a_y;
}

/// Where the Coriolis acceleration points, beside the normal transport acceleration -omega^2 (xi, eta).
Compound::Sense sense_of(const Input& in, const Result& r) {
  using S = Compound::Sense;
  constexpr double rounding = 1e-9;
  const double normal_xi = -in_si(in.xi), normal_eta = -in_si(in.eta);
  const double product = std::hypot(normal_xi, normal_eta) * in_si(r.a_c);
  if (product == 0.0) return S::none;
  const double cosine = (in_si(r.a_cxi) * normal_xi + in_si(r.a_ceta) * normal_eta) / product;
  if (std::abs(cosine) <= rounding) return S::across;
  if (std::abs(cosine) < 1.0 - rounding) return S::oblique;
  return cosine > 0.0 ? S::along : S::against;
}

}  // namespace

template <class Tracer>
Compound::Result Compound::evaluate(const Input& in, Tracer& trace) {
  Result r;
  add_velocities(in, r, trace);
  add_accelerations(in, r, trace);
  r.sense = sense_of(in, r);
  return r;
}

template Compound::Result Compound::evaluate(const Input&, NoTrace&);
template Compound::Result Compound::evaluate(const Input&, Trace&);

std::vector<draw::Figure> Compound::figures(const Input& in, const Result& r) {
  const auto turned = [&in](auto along, auto across) {
    const double a = in_si(along), b = in_si(across), c = cos(in.phi), s = sin(in.phi);
    return draw::Point{a * c - b * s, a * s + b * c};
  };
  const Vectors velocities{
      "Velocities",
      "m/s",
      {{"v_e", turned(r.v_exi, r.v_eeta)}, {"v_r", turned(in.v_xi, in.v_eta)}, {"v", turned(r.v_axi, r.v_aeta)}}};
  const Vectors accelerations{"Accelerations",
                              "m/s^2",
                              {{"a_e", turned(r.a_exi, r.a_eeta)},
                               {"a_r", turned(in.a_xi, in.a_eta)},
                               {"a_c", turned(r.a_cxi, r.a_ceta)},
                               {"a", turned(r.a_axi, r.a_aeta)}}};
  auto plan = plan_figure({velocities, accelerations});
  if (std::get<draw::Plans>(plan.content).panels.empty()) return {};
  return {std::move(plan)};
}

}  // namespace loadpath::motion

template const loadpath::Calculator& loadpath::erased<loadpath::motion::Compound>();
