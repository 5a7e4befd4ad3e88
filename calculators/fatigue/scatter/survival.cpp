#include "calculators/fatigue/scatter/survival.hpp"

#include "lib/calculator/calculator_of.hpp"
#include "lib/numerics/quantile.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::fatigue {

namespace {

using Input = Survival::Input;
using Result = Survival::Result;

/// Both scatters as far as they are known.
template <class Tracer>
void scatters(const Input& in, Result& r, Tracer& trace) {
  using std::pow;
  if (is_set(in.T_S)) {
    STEP_TO(r, T_S, in.T_S, "as given");
  } else if (is_set(in.k)) {
    STEP_TO(r, T_S, pow(in.T_N, 1.0 / in.k), "along the line, N S^k = const");
  }
  if (is_set(in.T_N)) {
    STEP_TO(r, T_N, in.T_N, "as given");
  } else if (is_set(in.k)) {
    STEP_TO(r, T_N, pow(in.T_S, in.k), "along the line, N S^k = const");
  }
}

}  // namespace

bool Survival::has_scatter(const Input& in) {
  const bool both = is_set(in.k) && (is_set(in.T_S) || is_set(in.T_N));
  return (!is_set(in.sigma_0) || is_set(in.T_S) || both) && (!is_set(in.N_0) || is_set(in.T_N) || both);
}

template <class Tracer>
Survival::Result Survival::evaluate(const Input& in, Tracer& trace) {
  using std::pow;
  Result r;
  scatters(in, r, trace);
  const double z_90 = trace.value("z_90", numerics::normal_quantile(0.9), "standard normal deviate of 90 %");
  const double z_P = trace.value("z_P", numerics::normal_quantile(in.P), "standard normal quantile of P");
  const double z_0 = trace.value("z_0", numerics::normal_quantile(in.P_0), "standard normal quantile of P_0");
  STEP_TO(r, z, z_P - z_0, "standard deviations between them");
  if (is_set(r.T_S)) {
    STEP_TO(r, s_S, log(r.T_S) / log(10.0) / (2.0 * z_90), "log-normal, 10 % to 90 %, [ISO12107]");
    STEP_TO(r, f_S, pow(10.0, -z * s_S), "more survive at a lower strength");
  }
  if (is_set(r.T_N)) {
    STEP_TO(r, s_N, log(r.T_N) / log(10.0) / (2.0 * z_90), "log-normal, 10 % to 90 %, [ISO12107]");
    STEP_TO(r, f_N, pow(10.0, -z * s_N), "more survive a shorter life");
  }
  if (is_set(in.sigma_0)) {
    STEP_TO(r, sigma_P, r.f_S * in.sigma_0, "strength at P");
  }
  if (is_set(in.N_0)) {
    STEP_TO(r, N_P, r.f_N * in.N_0, "life at P");
  }
  if (is_set(in.sigma_0) && is_set(in.N_0) && is_set(in.k)) {
    STEP_TO(r, N_D, r.N_P * pow(r.f_S, -in.k), "the moved line at the moved strength");
  }
  STEP_TO(r, x_P, min(min(in.P, 1.0 - in.P), min(in.P_0, 1.0 - in.P_0)), "tails are not tested");
  return r;
}

template Survival::Result Survival::evaluate(const Input&, NoTrace&);
template Survival::Result Survival::evaluate(const Input&, Trace&);

}  // namespace loadpath::fatigue

template const loadpath::Calculator& loadpath::erased<loadpath::fatigue::Survival>();
