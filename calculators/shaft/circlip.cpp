#include "calculators/shaft/circlip.hpp"

#include "lib/calculator/calculator_of.hpp"

namespace loadpath::shaft {

namespace {

using Input = Circlip::Input;
using Result = Circlip::Result;

constexpr double q_long = 1.2;  // factor of a shoulder of three depths or more

template <class Tracer>
void groove(const Input& in, Result& r, Tracer& trace) {
  const Force F_d = r.F_d;
  STEP_TO(r, t, (in.d_1 - in.d_2) / 2.0, "depth of the groove");
  STEP_TO(r, x_t, t / in.d_1, "deeper ones weaken the shaft under it");
  STEP(A, pi / 4.0 * (pow<2>(in.d_1) - pow<2>(in.d_2)), "side of the groove");
  const double q = trace.value("q", is_set(in.q) ? in.q : q_long, is_set(in.q) ? "given" : "[DIN471]");
  STEP_TO(r, F_N, in.R_e * A / q, "at yield, [DIN471]");
  STEP_TO(r, u_N, in.S * F_d / F_N, "groove and shoulder");
  if (!is_set(in.q)) {
    STEP_TO(r, x_w, in.w / t, "a shoulder of three depths or more");
  }
}

/// Against a sharp edge F_R; a chamfer bends the ring by a longer arm.
template <class Tracer>
void ring(const Input& in, Result& r, Tracer& trace) {
  const Force F_d = r.F_d;
  if (!is_set(in.c) || (in.c <= 0.0 * mm && !is_set(in.F_R))) return;
  if (in.c <= 0.0 * mm) {
    STEP_TO(r, F_ring, in.F_R, "against a sharp edge");
  } else if (is_set(in.F_Rg) && is_set(in.F_R)) {
    STEP_TO(r, F_ring, min(in.F_Rg * in.g / in.c, in.F_R), "against a chamfer, [DIN471]");
  } else {
    return;
  }
  STEP_TO(r, u_R, in.S * F_d / r.F_ring, "ring");
}

}  // namespace

Applies Circlip::loaded(const Input& in) { return where(abs(in.F_a) > 0.0 * N.one); }

Applies Circlip::turns_round(const Input& in) { return is_set(in.n) ? where(in.n > 0.0 * rpm.one) : Applies::unseen; }

Applies Circlip::varies(const Input& in) { return shown_by(in.K_A > 1.0 || in.n > 0.0 * rpm.one); }

template <class Tracer>
Circlip::Result Circlip::evaluate(const Input& in, Tracer& trace) {
  Result r;
  STEP_TO(r, F_d, in.K_A * abs(in.F_a), "force that counts");
  groove(in, r, trace);
  ring(in, r, trace);
  if (is_set(in.n) && is_set(in.n_abl)) {
    STEP_TO(r, u_n, in.n / in.n_abl, "below the speed at which it opens");
  }
  if (in.d_bore > 0.0 * mm) {
    STEP_TO(r, x_b, r.t / ((in.d_2 - in.d_bore) / 2.0), "a wall as thick as the groove is deep is left");
  }
  r.notch.d = in.d_1, r.notch.t = r.t, r.notch.w = in.m, r.notch.r = in.r;
  return r;
}

template Circlip::Result Circlip::evaluate(const Input&, NoTrace&);
template Circlip::Result Circlip::evaluate(const Input&, Trace&);

}  // namespace loadpath::shaft

template const loadpath::Calculator& loadpath::erased<loadpath::shaft::Circlip>();
