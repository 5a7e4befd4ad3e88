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
  STEP_TO(r, v_exi, in.v_Ax * cos(in.phi) + in.v_Ay * sin(in.phi) - in.omega * in.eta, "transport velocity, [B31]");
  STEP_TO(r, v_eeta, in.v_Ay * cos(in.phi) - in.v_Ax * sin(in.phi) + in.omega * in.xi, "transport velocity, [B31]");
  STEP_TO(r, v_e, sqrt(v_exi * v_exi + v_eeta * v_eeta), "magnitude");
  STEP_TO(r, v_r, sqrt(in.v_xi * in.v_xi + in.v_eta * in.v_eta + in.v_zeta * in.v_zeta), "magnitude");
  STEP_TO(r, v_axi, v_exi + in.v_xi, "absolute = transport + relative, [B31]");
  STEP_TO(r, v_aeta, v_eeta + in.v_eta, "absolute = transport + relative, [B31]");
  STEP_TO(r, v, sqrt(v_axi * v_axi + v_aeta * v_aeta + in.v_zeta * in.v_zeta), "magnitude");
  STEP_TO(r, v_x, v_axi * cos(in.phi) - v_aeta * sin(in.phi), "in the fixed axes");
  STEP_TO(r, v_y, v_axi * sin(in.phi) + v_aeta * cos(in.phi), "in the fixed axes");
}

template <class Tracer>
void add_accelerations(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, a_exi, in.a_Ax * cos(in.phi) + in.a_Ay * sin(in.phi) - in.epsilon * in.eta - in.omega * in.omega * in.xi,
          "of a point of the frame, [B28]");
  STEP_TO(r, a_eeta, in.a_Ay * cos(in.phi) - in.a_Ax * sin(in.phi) + in.epsilon * in.xi - in.omega * in.omega * in.eta,
          "of a point of the frame, [B28]");
  STEP_TO(r, a_e, sqrt(a_exi * a_exi + a_eeta * a_eeta), "magnitude");
  STEP_TO(r, a_r, sqrt(in.a_xi * in.a_xi + in.a_eta * in.a_eta + in.a_zeta * in.a_zeta), "magnitude");
  STEP_TO(r, a_cxi, -2.0 * in.omega * in.v_eta,
          "Coriolis: twice omega times the relative velocity, turned on by 90°, [B31]");
  STEP_TO(r, a_ceta, 2.0 * in.omega * in.v_xi,
          "Coriolis: twice omega times the relative velocity, turned on by 90°, [B31]");
  STEP_TO(r, a_c, sqrt(a_cxi * a_cxi + a_ceta * a_ceta), "magnitude");
  STEP_TO(r, a_axi, a_exi + in.a_xi + a_cxi, "absolute = transport + relative + Coriolis, [B31]");
  STEP_TO(r, a_aeta, a_eeta + in.a_eta + a_ceta, "absolute = transport + relative + Coriolis, [B31]");
  STEP_TO(r, a, sqrt(a_axi * a_axi + a_aeta * a_aeta + in.a_zeta * in.a_zeta), "magnitude");
  STEP_TO(r, a_x, a_axi * cos(in.phi) - a_aeta * sin(in.phi), "in the fixed axes");
  STEP_TO(r, a_y, a_axi * sin(in.phi) + a_aeta * cos(in.phi), "in the fixed axes");
}

/// Direction of the Coriolis acceleration, compared with the normal transport acceleration -omega^2 (xi, eta).
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

std::vector<figure::Figure> Compound::figures(const Input& in, const Result& r) {
  const auto turned = [&in](auto along, auto across) {
    const double a = in_si(along), b = in_si(across), c = cos(in.phi), s = sin(in.phi);
    return figure::Point{a * c - b * s, a * s + b * c};
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
  if (std::get<figure::Plans>(plan.content).panels.empty()) return {};
  return {std::move(plan)};
}

}  // namespace loadpath::motion

template const loadpath::Calculator& loadpath::erased<loadpath::motion::Compound>();
