#include "calculators/fatigue/endurance.hpp"

#include "calculators/fatigue/estimate.hpp"
#include "calculators/fatigue/marin.hpp"
#include "calculators/fatigue/size_and_surface.hpp"
#include "calculators/fatigue/tensile_strength.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <cmath>

namespace loadpath::fatigue {

namespace {

using Input = Endurance::Input;
using Result = Endurance::Result;
using Loading = Endurance::Loading;
using School = Endurance::School;

/// Neuber's constant in the units of its source: Shigley fits it over kpsi, in root inches.
template <class Tracer>
Length neuber_length(const Input& in, Result& r, Tracer& trace) {
  const double S_k = in_kpsi(in.R_m, trace);
  const double R_top = trace.value("R_top", in.loading == Loading::torsion ? 1500.0 : 1700.0,
                                   "in MPa, to which Neuber's constant was measured; in torsion less, [Shigley6]");
  STEP_TO(r, x_n, (in.R_m / MPa - 340.0) / (R_top - 340.0), "of steels from 340 MPa on, [Shigley6]");
  const double w_a =
      in.loading == Loading::torsion
          ? NAMED_STEP("w_a", 0.190 - 2.51e-3 * S_k + 1.35e-5 * pow<2>(S_k) - 2.67e-8 * pow<3>(S_k),
                       "root of Neuber's constant in root inches, torsion, [Shigley6] (6-35b)")
          : NAMED_STEP("w_a", 0.246 - 3.08e-3 * S_k + 1.51e-5 * pow<2>(S_k) - 2.67e-8 * pow<3>(S_k),
                       "root of Neuber's constant in root inches, bending and tension, [Shigley6] (6-35a)");
  return NAMED_STEP("a_N", pow<2>(w_a) * 25.4 * mm, "Neuber's constant");
}

/// Peterson's; in torsion the same as of a blunter notch.
template <class Tracer>
Length peterson_length(const Input& in, Result& r, Tracer& trace) {
  using std::pow;
  STEP_TO(r, x_n, (in.R_m / MPa - 560.0) / (2070.0 - 560.0),
          "of steels from 560 MPa on; to 2070 MPa (limit set by loadpath)");
  const double c_P =
      trace.value("c_P", in.loading == Loading::torsion ? 0.6 : 1.0, "0.6 in torsion, not checked against the source");
  return NAMED_STEP("a_P", c_P * 0.0254 * mm * pow(2070.0 * MPa / in.R_m, 1.8),
                    "Peterson's constant, not checked against the source");
}

template <class Tracer>
double sensitivity(const Input& in, Result& r, Tracer& trace) {
  if (in.sensitivity == Endurance::Sensitivity::cast_iron)
    return trace.value("q", 0.2, "all grades of cast iron, [Shigley6], not checked against the source");
  if (is_set(in.r_n) && in.sensitivity == Endurance::Sensitivity::peterson) {
    STEP_TO(r, x_r, 0.1 * mm / in.r_n, "sharper notches count as cracks (limit set by loadpath)");
    const Length a_P = peterson_length(in, r, trace);
    return NAMED_STEP("q", 1.0 / (1.0 + a_P / in.r_n), "notch sensitivity, Peterson, not checked against the source");
  }
  if (!is_set(in.r_n))
    return NAMED_STEP("q", is_set(in.q) ? in.q : 1.0, is_set(in.q) ? "as given" : "not applicable without a notch");
  STEP_TO(r, x_r, 0.1 * mm / in.r_n, "sharper notches count as cracks (limit set by loadpath)");
  const Length a_N = neuber_length(in, r, trace);
  return NAMED_STEP("q", 1.0 / (1.0 + sqrt(a_N / in.r_n)), "notch sensitivity, Neuber, [Shigley6] (6-34)");
}

template <class Tracer>
void notch(const Input& in, Result& r, Tracer& trace) {
  if (is_set(in.K_f)) {
    STEP_TO(r, K_f, in.K_f, "as given");
    return;
  }
  const double q = sensitivity(in, r, trace);
  STEP_TO(r, K_f, 1.0 + q * (in.K_t - 1.0), "fatigue notch factor, [Shigley6] (6-32)");
}

/// Size and roughness as DIN 743 has them; Serensen's tables are theirs, term for term.
template <class Tracer>
void size_and_surface(const Input& in, Result& r, Tracer& trace) {
  if (is_set(in.d) && in.loading == Loading::tension) r.x_d = 0.0;
  if (is_set(in.d) && in.loading != Loading::tension) {
    const SizeFactor size = size_factor("epsilon", in.d, "size in bending and torsion, [DIN743]", trace);
    r.x_d = size.x_d, r.epsilon = size.K;
  } else {
    STEP_TO(r, epsilon, is_set(in.epsilon) ? in.epsilon : 1.0,
            is_set(in.epsilon) ? "as given" : "no size effect: tension, or no d given");
  }
  if (!is_set(in.R_z)) {
    STEP_TO(r, beta_F, is_set(in.beta_F) ? in.beta_F : 1.0, is_set(in.beta_F) ? "as given" : "polished: no R_z given");
    return;
  }
  STEP_TO(r, x_Rz, in.R_z / (0.2 * mm), "rougher than a rolled skin (limit set by loadpath)");
  const double K_F = roughness_factor("K_F", in.R_m, in.R_z, "roughness, [DIN743], [GOST25504]", trace);
  if (in.loading == Loading::torsion) {
    STEP_TO(r, beta_F, 0.575 * K_F + 0.425, "roughness in torsion, [DIN743]");
  } else {
    STEP_TO(r, beta_F, K_F, "tension and bending");
  }
}

template <class Tracer>
void serensen(const Input& in, Result& r, Tracer& trace) {
  size_and_surface(in, r, trace);
  STEP_TO(r, K_D, (r.K_f / r.epsilon + 1.0 / r.beta_F - 1.0) / in.beta_V,
          "shape, size and surface together, [GOST25504]");
  STEP_TO(r, sigma_D, r.sigma_m1 / K_D, "fatigue limit of the part");
}

/// Total reduction by the notch and all factors.
template <class Tracer>
void marin(const Input& in, Result& r, Tracer& trace) {
  const double k_a = r.k_a = marin_surface(in, trace);
  r.k_b = marin_size(in, r, trace);
  const double K_D = is_set(in.k_c) || is_set(in.T) || is_set(in.P_s)
                         ? marin_service(in, r, trace)
                         : NAMED_STEP("K_D", r.K_f / (k_a * r.k_b), "shape, size and surface together");
  r.K_D = K_D;
  STEP_TO(r, sigma_D, r.sigma_m1 / K_D, "fatigue limit of the part, the notch counted once");
}

}  // namespace

bool Endurance::rule_fits(const Input& in) { return is_set(in.sigma_W) || covers(in); }

FieldFault Endurance::misfit(const Input& in) {
  switch (in.rule) {
    case RuleOf::textbook:
      return {"rule",
              say("the textbook gives fatigue limits in bending only, for carbon steel, cast iron and "
                  "non-ferrous metals"),
              say("take rule = \"din743\" for steels, \"fkm\" for tension and torsion, or give sigma_W")};
    case RuleOf::din743:
      return {"rule", say("DIN 743 is for steels"), say("take rule = \"fkm\", or give sigma_W")};
    case RuleOf::fkm:
      return {"rule",
              say("FKM gives the limits in tension and torsion; in bending it counts the stress gradient, and "
                  "this group may not be in it"),
              say("take loading = \"tension\", which is on the safe side of bending, or give sigma_W")};
    case RuleOf::shigley:
      return {"rule", say("this rule is for steels"), say("take rule = \"fkm\", or give sigma_W")};
  }
  return {};
}

template <class Tracer>
Endurance::Result Endurance::evaluate(const Input& in, Tracer& trace) {
  Result r;
  if (is_set(in.sigma_W)) {
    STEP_TO(r, sigma_m1, in.sigma_W, "as measured");
  } else {
    estimate(in, r, trace);
  }
  const bool ferrous = in.group < Group::wrought_aluminium;
  r.N_0 = trace.value("N_0", ferrous ? 1e7 : 1e8,
                      ferrous ? "the curve runs level from about here, [B20]"
                              : "non-ferrous: no asymptote, the limit is conventional, [B20]");
  if (is_steel(in.group)) compare_with_steel(in.E, r, "the group is one of steels", trace);
  notch(in, r, trace);
  if (in.school == School::serensen) {
    serensen(in, r, trace);
  } else {
    marin(in, r, trace);
  }
  return r;
}

template Endurance::Result Endurance::evaluate(const Input&, NoTrace&);
template Endurance::Result Endurance::evaluate(const Input&, Trace&);

}  // namespace loadpath::fatigue

template const loadpath::Calculator& loadpath::erased<loadpath::fatigue::Endurance>();
