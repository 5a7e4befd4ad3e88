#include "calculators/fatigue/multiaxial/multiaxial.hpp"

#include "calculators/fatigue/multiaxial/path.hpp"
#include "calculators/fatigue/multiaxial/planes.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::fatigue {

namespace {

using Input = Multiaxial::Input;
using Result = Multiaxial::Result;
using Criterion = Multiaxial::Criterion;

constexpr double endless = std::numeric_limits<double>::infinity();
StressPath path_of(const Input& in) { return {in.sigma_x, in.sigma_y, in.tau_xy}; }
std::array<const Varying<Stress>*, 3> stresses(const Input& in) { return {&in.sigma_x, &in.sigma_y, &in.tau_xy}; }
Stress pascals(double si) { return from_si<Stress>(si); }

/// A harmless stress has an infinite safety factor.
double safety(Stress limit, Stress stress) { return stress > 0.0 * MPa ? reduced(limit / stress) : endless; }

template <class Tracer>
double told_safety(const char* symbol, const Input& in, Stress equivalent, Tracer& trace) {
  return trace.value(symbol, safety(in.sigma_D, equivalent), "sigma_D over the equivalent amplitude");
}

template <class Tracer>
void yield(const Input& in, const StressPath& path, Result& r, Tracer& trace) {
  const Stress sigma_v1 =
      trace.value("sigma_v1", pascals(largest_mises(path)),
                  "largest root of sigma_x^2 + sigma_y^2 - sigma_x sigma_y + 3 tau_xy^2 along the path, [Mises]");
  STEP_TO(r, sigma_v, in.K_A * sigma_v1, "with the application factor");
  if (!is_set(in.R_e)) return;
  STEP_TO(r, u_y, sigma_v / in.R_e, "yielding at peak equivalent stress");
  r.n_y = trace.value("n_y", 1.0 / u_y, "safety against it");
  if (is_set(in.S_F)) {
    STEP_TO(r, u_F, in.S_F * u_y, "with the safety factor S_F");
  }
}

template <class Tracer>
void findley(const Input& in, const StressPath& path, Result& r, Tracer& trace) {
  STEP(s, 2.0 * in.tau_D / in.sigma_D - 1.0, "from sigma_D (k + sqrt(1 + k^2))/2 = f = tau_D sqrt(1 + k^2)");
  STEP_TO(r, k, s / sqrt(1.0 - pow<2>(s)), "both fatigue limits lie on the criterion, [Findley]");
  STEP(f, in.tau_D * sqrt(1.0 + pow<2>(k)), "its strength");
  const WorstPlane worst = worst_plane(path, k);
  r.theta_F = trace.angle("theta_F", worst.plane.normal.theta, "plane of maximum tau + k sigma");
  r.phi_F = trace.angle("phi_F", worst.plane.normal.phi, "the same, along the surface");
  const Stress tau_F1 =
      trace.value("tau_F1", pascals(worst.plane.tau_a), "radius of the minimum circumscribed circle, on it");
  const Stress sigma_F1 = trace.value("sigma_F1", pascals(worst.plane.sigma_n), "maximum normal stress on it, from 0");
  STEP_TO(r, tau_F, in.K_A * tau_F1, "with the application factor");
  STEP_TO(r, sigma_F, in.K_A * sigma_F1, "with the application factor");
  STEP_TO(r, sigma_eF, (tau_F + k * sigma_F) / f * in.sigma_D, "in symmetric tension the same, [Findley]");
  r.n_F = told_safety("n_F", in, sigma_eF, trace);
  r.e_p = worst.apart;
}

template <class Tracer>
void matake(const Input& in, const StressPath& path, Result& r, Tracer& trace) {
  STEP_TO(r, mu, 2.0 * in.tau_D / in.sigma_D - 1.0, "from sigma_D (1 + mu)/2 = tau_D, [Matake]");
  const WorstPlane worst = plane_of_most_shear(path, mu);
  r.theta_M = trace.angle("theta_M", worst.plane.normal.theta, "plane of maximum tau, of several the most critical");
  r.phi_M = trace.angle("phi_M", worst.plane.normal.phi, "the same, along the surface");
  const Stress tau_M1 =
      trace.value("tau_M1", pascals(worst.plane.tau_a), "radius of the minimum circumscribed circle, on it");
  const Stress sigma_M1 = trace.value("sigma_M1", pascals(worst.plane.sigma_n), "maximum normal stress on it, from 0");
  STEP_TO(r, tau_M, in.K_A * tau_M1, "with the application factor");
  STEP_TO(r, sigma_M, in.K_A * sigma_M1, "with the application factor");
  STEP_TO(r, sigma_eM, (tau_M + mu * sigma_M) / in.tau_D * in.sigma_D, "in symmetric tension the same, [Matake]");
  r.n_M = told_safety("n_M", in, sigma_eM, trace);
  r.e_p = trace.value("e_p", std::max(r.e_p, worst.apart), "the larger one of the two criteria of planes");
}

/// Crossland and Dang Van are criteria of hard metals; towards brittle ones the planes of Findley and Matake remain,
/// which end at the criterion of the largest normal stress.
bool is_hard_at_most(const Input& in) { return in.tau_D <= (Multiaxial::most_of_hard + 1e-9) * in.sigma_D; }

/// Below the ratio of von Mises the weight of the hydrostatic stress would be negative: tension would help.
bool crossland_holds(const Input& in) {
  return std::sqrt(3.0) * in.tau_D >= (1.0 - 1e-9) * in.sigma_D && is_hard_at_most(in);
}

template <class Tracer>
void crossland(const Input& in, const StressPath& path, const DeviatorBall& ball, Result& r, Tracer& trace) {
  const Stress tau_C1 =
      trace.value("tau_C1", pascals(ball.radius), "radius of the minimum circumscribed sphere of the deviators");
  const Stress sigma_H1 =
      trace.value("sigma_H1", pascals(largest_hydrostatic(path)), "maximum hydrostatic stress, from 0");
  STEP_TO(r, tau_C, in.K_A * tau_C1, "with the application factor");
  STEP_TO(r, sigma_H, in.K_A * sigma_H1, "with the application factor");
  if (!crossland_holds(in)) return;
  STEP_TO(r, kappa, max(3.0 * in.tau_D / in.sigma_D - sqrt(3.0), 0.0), "both fatigue limits lie on it, [Crossland]");
  STEP_TO(r, sigma_eC, (tau_C + kappa * sigma_H) / in.tau_D * in.sigma_D, "in symmetric tension the same, [Crossland]");
  r.n_C = told_safety("n_C", in, sigma_eC, trace);
}

template <class Tracer>
void dang_van(const Input& in, const StressPath& path, const DeviatorBall& ball, Result& r, Tracer& trace) {
  if (!is_hard_at_most(in)) return;
  STEP_TO(r, a, 3.0 * in.tau_D / in.sigma_D - 1.5, "both fatigue limits lie on the criterion, [DangVan]");
  const Stress tau_DV1 = trace.value("tau_DV1", pascals(largest_mesoscopic(path, ball, a)),
                                     "maximum along the path: shear stress from the centre of the ball + a sigma_H");
  STEP_TO(r, tau_DV, in.K_A * tau_DV1, "with the application factor");
  STEP_TO(r, sigma_eDV, tau_DV / in.tau_D * in.sigma_D, "in symmetric tension the same, [DangVan]");
  r.n_DV = told_safety("n_DV", in, sigma_eDV, trace);
}

template <class Tracer>
void in_phase(const Input& in, const StressPath& path, Result& r, Tracer& trace) {
  const Stress sigma_va1 = trace.value("sigma_va1", pascals(mises_in_phase(path)),
                                       "of the amplitudes of sigma_x, sigma_y, their difference and tau_xy, [Mises]");
  STEP_TO(r, sigma_va, in.K_A * sigma_va1, "with the application factor");
  r.n_v = told_safety("n_v", in, sigma_va, trace);
}

template <class Tracer>
void decide(const Input& in, Result& r, Tracer& trace) {
  if (in.criterion == Criterion::crossland) {
    STEP_TO(r, x_C, sqrt(3.0) * in.tau_D / in.sigma_D, "below 1 its weight would be negative");
  }
  if (in.criterion == Criterion::crossland || in.criterion == Criterion::dang_van) {
    STEP_TO(r, x_H, in.tau_D / in.sigma_D, "above 0.8 the metal is brittle: Findley or Matake");
    if (!is_set(in.criterion == Criterion::crossland ? r.n_C : r.n_DV)) return;
  }
  r.n = in.criterion == Criterion::findley     ? NAMED_STEP("n", r.n_F, "Findley decides")
        : in.criterion == Criterion::matake    ? NAMED_STEP("n", r.n_M, "Matake decides")
        : in.criterion == Criterion::crossland ? NAMED_STEP("n", r.n_C, "Crossland decides")
        : in.criterion == Criterion::dang_van  ? NAMED_STEP("n", r.n_DV, "Dang Van decides")
        : is_set(r.n_C)  ? NAMED_STEP("n", min(min(r.n_F, r.n_M), min(r.n_C, r.n_DV)), "minimum of all four")
        : is_set(r.n_DV) ? NAMED_STEP("n", min(min(r.n_F, r.n_M), r.n_DV), "minimum of the valid criteria")
                         : NAMED_STEP("n", min(r.n_F, r.n_M), "minimum of both criteria of planes");
  STEP_TO(r, u_D, in.S_D / r.n, "required / actual safety factor");
}

figure::Curve circle(const numerics::Ball<2>& ball, double K_A) {
  figure::Curve curve{"minimum circumscribed circle", {}, {}};
  constexpr int points = 96;
  for (int i = 0; i <= points; ++i) {
    const double angle = 2.0 * pi * i / points;
    curve.x.push_back(K_A * (ball.centre[0] + ball.radius * std::cos(angle)));
    curve.y.push_back(K_A * (ball.centre[1] + ball.radius * std::sin(angle)));
  }
  return curve;
}

}  // namespace

bool Multiaxial::in_step(const Input& in) {
  const Axis* first = nullptr;
  for (const Varying<Stress>* stress : stresses(in)) {
    if (!stress->is_series()) continue;
    const Axis* axis = stress->series->signature.axis;
    if (first == nullptr) first = axis;
    const bool of_files = axis->step.empty() && first->step.empty() && axis->at.size() == first->at.size();
    if (axis != first && !of_files) return false;
  }
  return true;
}

bool Multiaxial::varies(const Input& in) {
  const auto all = stresses(in);
  return std::any_of(all.begin(), all.end(), [](const Varying<Stress>* stress) {
    if (!stress->is_series() || stress->series->si.empty()) return false;
    const auto [least, largest] = std::minmax_element(stress->series->si.begin(), stress->series->si.end());
    return *largest > *least;
  });
}

bool Multiaxial::fine_enough(const Input& in) {
  const auto all = stresses(in);
  return std::all_of(all.begin(), all.end(), [](const Varying<Stress>* stress) {
    return !stress->is_series() || resolves_extremes(*stress->series);
  });
}

template <class Tracer>
Multiaxial::Result Multiaxial::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const StressPath path = path_of(in);
  r.samples = static_cast<double>(path.size());
  yield(in, path, r, trace);
  STEP_TO(r, x_D, in.tau_D / in.sigma_D, "0.5 by Tresca, 0.577 by von Mises, above 0.8 of brittle metals");
  compare_cycles(in, r, trace);
  if (x_D < 0.5 - 1e-9) return r;
  const DeviatorBall ball = deviator_ball(path);
  findley(in, path, r, trace);
  matake(in, path, r, trace);
  crossland(in, path, ball, r, trace);
  dang_van(in, path, ball, r, trace);
  in_phase(in, path, r, trace);
  decide(in, r, trace);
  return r;
}

template Multiaxial::Result Multiaxial::evaluate(const Input&, NoTrace&);
template Multiaxial::Result Multiaxial::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Multiaxial::figures(const Input& in, const Result& r) {
  if (!is_set(r.theta_F)) return {};
  const StressPath path = path_of(in);
  const PlaneView view({r.theta_F, r.phi_F});
  figure::Plot plot;
  plot.x = {"tau_1", "shear stress towards the inside", "MPa"};
  plot.y = {"tau_2", "shear stress along the surface", "MPa"};
  figure::Curve way{"path", {}, {}};
  for (std::size_t i = 0; i <= path.size(); ++i) {
    const auto shear = view.shear(path.at(i % path.size()));
    way.x.push_back(in.K_A * shear[0]), way.y.push_back(in.K_A * shear[1]);
  }
  plot.curves = {std::move(way), circle(shear_circle(path, view), in.K_A)};
  return {{"plane", "Shear stress on the Findley plane with its minimum circumscribed circle", std::move(plot)}};
}

}  // namespace loadpath::fatigue

template const loadpath::Calculator& loadpath::erased<loadpath::fatigue::Multiaxial>();
