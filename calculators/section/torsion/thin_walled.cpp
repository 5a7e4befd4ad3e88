#include "calculators/section/torsion/thin_walled.hpp"

#include "calculators/section/torsion/cells.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::section {

namespace {

using Input = ThinWalled::Input;
using Result = ThinWalled::Result;

/// Torsion constants of the cells, and of the walls as strips.
template <class Tracer>
void constants(const Input& in, const Flows& flows, Result& r, Tracer& trace) {
  SecondMoment I_B = 0.0 * mm4, I_s = 0.0 * mm4;
  for (std::size_t i = 0; i < flows.size(); ++i) {
    [[maybe_unused]] const auto scope = trace.scope("cells", i);
    const Area A = trace.value("A", area_of(in.cells[i]), "area inside of the middle lines");
    const Area f = trace.value("f", flows[i], "flow over G theta: all cells twist alike, [Bredt], [Megson]");
    STEP(I, 2.0 * A * f, "its part of the torsion constant");
    I_B += I;
  }
  for (std::size_t i = 0; i < in.walls.size(); ++i) {
    [[maybe_unused]] const auto scope = trace.scope("walls", i);
    const ThinWalled::Wall& s = in.walls[i];
    const Length l = trace.value("l", length_of(s), "length of the middle line");
    const double n = trace.value("n", modulus_ratio(in, s), "its shear modulus over that of the section");
    const Length t = trace.value("t", s.t, "thickness");
    STEP(I, n * l * pow<3>(t) / 3.0, "torsion constant of a thin strip");
    I_s += I;
  }
  r.I_B = trace.value("I_B", I_B, "sum over the cells");
  r.I_s = trace.value("I_s", I_s, "sum over the walls");
  STEP_TO(r, I_t, I_B + I_s, "both twist alike");
  STEP_TO(r, r_I, I_t / I_s, "closed against slit open");
}

Area flow_of(const Input& in, const Flows& flows, const Name& cell) {
  const std::size_t i = cell_of(in, cell);
  return i < flows.size() ? flows[i] : 0.0 * mm2;
}

/// Stresses of one wall by the torque, for a torsion constant of the section.
template <class Tracer>
ThinWalled::Loaded load(const Input& in, const Flows& flows, const ThinWalled::Wall& s, const Result& r,
                        Tracer& trace) {
  ThinWalled::Loaded wall;
  wall.name = s.name, wall.l = length_of(s);
  const Area f_c = trace.value("f_c", flow_of(in, flows, s.cell), "flow of its cell over G theta");
  const Area f_b = trace.value("f_b", flow_of(in, flows, s.beside), "flow of the adjacent cell / (G theta)");
  const double n = trace.value("n", modulus_ratio(in, s), "its shear modulus over that of the section");
  STEP_TO(wall, q, in.K_A * in.T * (f_c - f_b) / r.I_t, "shear flow");
  const Length t = trace.value("t", s.t, "thickness");
  STEP_TO(wall, tau_m, abs(q) / t, "mean through the thickness, [Bredt]");
  STEP(tau_t, in.K_A * abs(in.T) * n * t / r.I_t, "at the surface, by its own twist");
  STEP_TO(wall, tau, tau_m + tau_t, "at the surface");
  const Stress tau_all = wall.tau_all = allowable_shear(in, s.tau_adm, trace);
  STEP_TO(wall, u_tau, tau / tau_all, "strength condition, [B19] (3)");
  return wall;
}

/// The largest of the walls; the moduli are those of a torque of 1.
template <class Tracer>
void stresses(const Input& in, const Flows& flows, Result& r, Tracer& trace) {
  r.tau_max = 0.0 * MPa, r.u_tau = 0.0, r.t_max = 0.0 * mm;
  Length t_n = 0.0 * mm, surface = 0.0 * mm;
  for (std::size_t i = 0; i < in.walls.size(); ++i) {
    [[maybe_unused]] const auto scope = trace.scope("walls", i);
    const ThinWalled::Wall& s = in.walls[i];
    r.walls.push_back(load(in, flows, s, r, trace));
    r.tau_max = max(r.tau_max, r.walls.back().tau);
    r.u_tau = larger_use(r.u_tau, r.walls.back().u_tau);
    r.t_max = max(r.t_max, s.t);
    t_n = max(t_n, modulus_ratio(in, s) * s.t);
    const Area flow = flow_of(in, flows, s.cell) - flow_of(in, flows, s.beside);
    surface = max(surface, abs(flow) / s.t + modulus_ratio(in, s) * s.t);
  }
  trace.value("tau_max", r.tau_max, "maximum of the walls");
  trace.value("u_tau", r.u_tau, "maximum of the walls");
  trace.value("e", surface, "maximum stress over G theta");
  const Length e = surface;
  STEP_TO(r, W_t, r.I_t / e, "torque over the maximum stress");
  trace.value("t_n", t_n, "thickest wall, by its shear modulus");
  STEP_TO(r, W_s, r.I_s / t_n, "slit open");
  STEP_TO(r, tau_s, in.K_A * abs(in.T) / W_s, "slit open");
}

/// How thick the walls are for thin ones.
template <class Tracer>
void thinness(const Input& in, Result& r, Tracer& trace) {
  double w = 0.0, w_s = 0.0;
  bool any_free = false;
  for (const ThinWalled::Wall& wall : in.walls) {
    if (is_free(wall)) {
      any_free = true;
      w_s = max(w_s, reduced(wall.t / length_of(wall)));
    }
    for (const Name& name : {wall.cell, wall.beside}) {
      const std::size_t cell = cell_of(in, name);
      if (cell == in.cells.size()) continue;
      w = max(w, reduced(wall.t * perimeter_of(in, cell) / (2.0 * area_of(in.cells[cell]))));
    }
  }
  if (!in.cells.empty()) r.w = trace.value("w", w, "thickness by U/(2 A) of its cell, the maximum");
  if (any_free) r.w_s = trace.value("w_s", w_s, "thickness over length of a free wall, the maximum");
}

}  // namespace

template <class Tracer>
ThinWalled::Result ThinWalled::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const Flows flows = flows_of(in);
  constants(in, flows, r, trace);
  for (std::size_t i = 0; i < flows.size(); ++i) {
    const Area& f = flows[i];
    r.cells.push_back({in.cells[i].name, area_of(in.cells[i]), in.K_A * in.T * f / r.I_t});
  }
  stresses(in, flows, r, trace);
  thinness(in, r, trace);
  if (is_set(in.G)) {
    STEP_TO(r, theta, in.K_A * in.T / (in.G * r.I_t), "angle of twist per unit length");
    if (is_set(in.theta_adm)) {
      STEP_TO(r, u_theta, abs(theta) / in.theta_adm, "stiffness condition, [B19] (8)");
    }
  }
  r.cycle = {Stresses::shear, r.tau_max};
  return r;
}

template ThinWalled::Result ThinWalled::evaluate(const Input&, NoTrace&);
template ThinWalled::Result ThinWalled::evaluate(const Input&, Trace&);

}  // namespace loadpath::section

template const loadpath::Calculator& loadpath::erased<loadpath::section::ThinWalled>();
