#include "calculators/vessel/ends/flat.hpp"

#include "calculators/vessel/assess.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::vessel {

namespace {

using Input = FlatEnd::Input;
using Result = FlatEnd::Result;
using Attachment = FlatEnd::Attachment;

template <class Tracer>
Stress allowable_of_code(const Input& in, Tracer& trace) {
  const bool by_steel = is_set(in.R_e) && is_set(in.R_m);
  if (!by_steel) return NAMED_STEP("f", in.sigma_adm, "as given");
  if (!is_set(in.sigma_adm)) return NAMED_STEP("f", min(in.R_e / 1.5, in.R_m / 3.5), "[UG-34], section II part D");
  return NAMED_STEP("f", min(in.sigma_adm, min(in.R_e / 1.5, in.R_m / 3.5)), "as given, at most section II part D");
}

template <class Tracer>
double factor_of_attachment(const Input& in, Tracer& trace) {
  if (is_set(in.C)) return NAMED_STEP("C_e", in.C, "as given");
  if (in.attachment == Attachment::integral) return trace.value("C_e", 0.17, "integral, [UG-34], sketch (b-1)");
  if (in.attachment == Attachment::bolted) return trace.value("C_e", 0.25, "full-face gasket, [UG-34], sketch (p)");
  if (!is_set(in.m_r)) return trace.value("C_e", 0.33, "welded, [UG-34], sketches (e) to (g), m = 1");
  return NAMED_STEP("C_e", max(0.33 * in.m_r, 0.2), "welded, [UG-34], sketches (e) to (g)");
}

/// Pressure that an end of this diameter and thickness carries at the stress f.
template <class Tracer>
Stress pressure_of_plate(const char* symbol, Stress f, double z, double C_e, Length D_c, Length e, Tracer& trace) {
  return NAMED_STEP(symbol, f * z / C_e * pow<2>(e / D_c), "[UG-34] (c)(2), equation 1");
}

template <class Tracer>
void test_of_plate(const Input& in, Result& r, Tracer& trace) {
  if (!is_set(in.p_t)) return;
  NoTrace off;
  const Stress p_w = test_requirements(in, !(in.R_e / 1.5 > in.R_m / 3.5), r, trace);
  const Length new_end = r.delta - in.c_t;
  const Stress p_n = trace.value("p_n", pressure_of_plate("p_n", r.f_test, in.z, r.C_e, in.D_i, new_end, off),
                                 "pressure that the new end bears at f_test, [UG-34]");
  STEP_TO(r, u_t, p_w / p_n, "new end in the test");
}

}  // namespace

template <class Tracer>
FlatEnd::Result FlatEnd::evaluate(const Input& in, Tracer& trace) {
  Result r;
  r.f = allowable_of_code(in, trace);
  r.C_e = factor_of_attachment(in, trace);
  STEP_TO(r, D_c, in.D_i + 2.0 * in.c, "inside diameter, corroded");
  STEP(delta_0, D_c * sqrt(r.C_e * in.p / (r.f * in.z)), "[UG-34] (c)(2), equation 1");
  STEP_TO(r, delta_min, delta_0 + in.c + in.c_t, "with its allowances, each once");
  r.delta = is_set(in.delta) ? in.delta : r.delta_min;
  const Length delta = trace.value("delta", r.delta, "nominal");
  STEP_TO(r, e, delta - in.c - in.c_t, "less corrosion and under-tolerance");
  const double z = trace.value("z", in.z, "efficiency of welds in the end");
  r.p_max = pressure_of_plate("p_max", r.f, z, r.C_e, r.D_c, r.e, trace);
  STEP_TO(r, u_e, in.p / r.p_max, "bending of the end");
  STEP_TO(r, x_e, e / r.D_c, "thin plates become membranes, thick ones are no plates");
  test_of_plate(in, r, trace);
  return r;
}

template FlatEnd::Result FlatEnd::evaluate(const Input&, NoTrace&);
template FlatEnd::Result FlatEnd::evaluate(const Input&, Trace&);

}  // namespace loadpath::vessel

template const loadpath::Calculator& loadpath::erased<loadpath::vessel::FlatEnd>();
