#include "calculators/shaft/design/fatigue.hpp"

#include "calculators/fatigue/din743/fields.hpp"
#include "calculators/fatigue/din743/safety.hpp"
#include "calculators/fatigue/mean_stress.hpp"
#include "calculators/fatigue/peterson.hpp"
#include "calculators/shaft/design/schools.hpp"
#include "lib/numerics/magnitude.hpp"

#include <cmath>
#include <limits>

namespace loadpath::shaft {

namespace {

using fatigue::Endurance;
using Input = DesignInput;

/// The shape factor of a shoulder in torsion, [DIN743] part 2, down to r = 0.03 t: for steps that are higher for their
/// fillet than Peterson's fit.
struct Beyond {
  double K, place;
};
/// The fillet at the end of the fit.
Length highest_fillet(Length h) { return h / fatigue::shoulder_in_torsion.back().high; }
Beyond high_shoulder_in_torsion(Length d, Length D, Length h, Length r_n) {
  constexpr double least = 0.03;  // r/t, [DIN743] part 2
  fatigue::Din743Section section;
  section.notch = fatigue::Notch::shoulder, section.d = d, section.D = D, section.r = r_n;
  NoTrace quiet;
  const double lowest = fatigue::shoulder_in_torsion.front().low;
  return {fatigue::shape_factor(section, fatigue::Stressing::torsion, h, quiet),
          std::log(h / r_n / lowest) / std::log(1.0 / least / lowest)};
}

/// The notch as Peterson has it, and the range that he has it for.
template <class Tracer>
void concentrate(const Notched& notch, const Sides& sides, Length r_n, const Section& p, bool twisted, Safety& s,
                 Tracer& trace) {
  const bool shoulder = notch.kind == Notch::shoulder, fits = shoulder || notch.kind == Notch::groove;
  bool is_high = false;  // beyond Peterson's fit in torsion
  if (fits) {
    const Length D = shoulder ? sides.larger() : p.d + 2.0 * notch.t;
    const Length h = (D - p.d) / 2.0;
    const auto in_bending =
        fatigue::concentration(shoulder ? fatigue::shoulder_in_bending : fatigue::groove_in_bending, h, r_n, D);
    const auto in_torsion = shoulder ? fatigue::concentration(fatigue::shoulder_in_torsion, h, r_n, D)
                                     : fatigue::concentration(fatigue::groove_in_torsion, h, r_n, D);
    s.K_t = in_bending.K, s.K_ts = in_torsion.K;
    is_high = shoulder && in_torsion.place > 1.0;
    const Beyond beyond = is_high ? high_shoulder_in_torsion(p.d, D, h, r_n) : Beyond{in_torsion.K, in_torsion.place};
    if (is_high)
      s.K_ts = std::max(beyond.K, fatigue::concentration(fatigue::shoulder_in_torsion, h, highest_fillet(h), D).K);
    s.x_b = trace.value("x_b", in_bending.place, "position within the fit, [Peterson]");
    if (twisted)
      s.x_t = trace.value(
          "x_t", beyond.place,
          is_high ? "position between h/r of 0.25 and 1/0.03, [DIN743] part 2" : "position within the fit, [Peterson]");
  } else if (is_keyed(notch.kind)) {
    const double k_2 = notch.kind == Notch::two_keyways ? 1.15 : 1.0;
    s.K_t = k_2 * 2.14, s.K_ts = k_2 * 3.0;
  } else {
    s.K_t = notch.K_t, s.K_ts = notch.K_ts;
  }
  const char* const source = fits                          ? "of the net section, [Peterson]"
                             : notch.kind == Notch::keyway ? "end-milled, r = 0.02 d, [Shigley7] table 7-1"
                             : notch.kind == Notch::two_keyways
                                 ? "1.15 of one keyway, as [DIN743] has it; one by [Shigley7] table 7-1"
                                 : "as given";
  trace.value("K_t", s.K_t, source);
  trace.value("K_ts", s.K_ts, is_high ? "of the net section, beyond [Peterson]: [DIN743] part 2" : source);
}

Endurance::Input endurance_of(const Input& in, Length d, Endurance::Loading loading, double K, Length r_n) {
  Endurance::Input e;
  e.R_m = in.R_m, e.group = in.group, e.rule = Endurance::RuleOf::shigley, e.loading = loading;
  e.sigma_W = in.sigma_W, e.school = Endurance::School::marin, e.finish = in.finish;
  e.d = d, e.K_t = K;
  if (K > 1.0 && in.group <= Endurance::Group::cast_steel) e.r_n = r_n;
  if (K > 1.0 && in.group > Endurance::Group::cast_steel) e.q = 1.0;
  return e;
}

/// The limit of the part, and what the notch takes of it in bending and in torsion.
template <class Tracer>
void weaken(const Input& in, Length d, Length r_n, Safety& s, Tracer& trace) {
  NoTrace quiet;
  const auto bending = Endurance::evaluate(endurance_of(in, d, Endurance::Loading::bending, s.K_t, r_n), trace);
  const auto torsion = Endurance::evaluate(endurance_of(in, d, Endurance::Loading::torsion, s.K_ts, r_n), quiet);
  s.K_f = bending.K_f, s.x_d = bending.x_d;
  s.x_n = max(bending.x_n, torsion.x_n), s.x_r = bending.x_r;
  s.K_fs = trace.value("K_fs", torsion.K_f, "in torsion, as fatigue.endurance finds it");
  const Stress sigma_D = bending.sigma_D;
  STEP_TO(s, S_e, s.K_f * sigma_D, "limit without K_f, which is applied to the stress");
}

/// The same where the notch factors are known: the limit is that of the part without its notch.
template <class Tracer>
void weaken_by_factors(const Input& in, Length d, const Notched& notch, const fatigue::Din743Safety& rated, Safety& s,
                       Tracer& trace) {
  NoTrace quiet;
  const auto plain = Endurance::evaluate(endurance_of(in, d, Endurance::Loading::bending, 1.0, d), quiet);
  s.x_d = plain.x_d;
  s.S_e =
      trace.value("S_e", plain.sigma_D, "without the notch, as fatigue.endurance finds it; that is with the stresses");
  const bool typed = notch.kind == Notch::beta;
  const char* const source =
      typed ? "as given" : "beta of the net section, [DIN743] part 2, as fatigue.din743 finds it";
  const auto factor = [&](double given, const char* stress) {
    return typed ? given : fatigue::of_stress(rated, stress, &fatigue::Din743Stress::beta, unset<double>);
  };
  s.K_f = trace.value("K_f", factor(notch.beta_b, "bending"), source);
  s.K_fs = trace.value("K_fs", factor(notch.beta_t, "torsion"), source);
  s.K_t = fatigue::of_stress(rated, "bending", &fatigue::Din743Stress::alpha, unset<double>);
  s.K_ts = fatigue::of_stress(rated, "torsion", &fatigue::Din743Stress::alpha, unset<double>);
}

/// The section as DIN 743 has it; a given notch by its shape factors without any support, on the safe side.
fatigue::Din743Section section_of_din743(const Input& in, const ChangePlace& there, const Sides& sides,
                                         const Section& p, const Safety& s) {
  using Kind = fatigue::Notch;
  fatigue::Din743Section section;
  section.notch = Kind::smooth, section.R_z = in.R_z, section.d = p.d, section.d_bore = p.d_bore;
  if (there.notch == nullptr) return section;
  const Notched& notch = *there.notch;
  section.r = notch.r, section.w = notch.w;
  if (is_groove(notch.kind)) section.D = p.d + 2.0 * notch.t;
  switch (notch.kind) {
    case Notch::shoulder:
      section.notch = Kind::shoulder, section.D = sides.larger();
      break;
    case Notch::groove:
      section.notch = Kind::round_groove;
      break;
    case Notch::rectangular_groove:
      section.notch = Kind::rectangular_groove;
      break;
    case Notch::v_groove:
      section.notch = Kind::v_groove;
      break;
    case Notch::keyway:
      section.notch = Kind::keyway;
      break;
    case Notch::two_keyways:
      section.notch = Kind::two_keyways;
      break;
    case Notch::press_fit:
      section.notch = Kind::press_fit;
      break;
    case Notch::cross_hole:
      section.notch = Kind::cross_hole;
      break;
    case Notch::given:
      section.notch = Kind::alpha, section.alpha_zd = section.alpha_b = s.K_t, section.alpha_t = s.K_ts;
      break;
    case Notch::beta:
      section.notch = Kind::beta, section.beta_zd = section.beta_b = notch.beta_b, section.beta_t = notch.beta_t;
      break;
  }
  return section;
}

/// How many of its ranges the section is outside of.
double outside_of_din743(const fatigue::Din743Safety& rated) {
  static constexpr auto fields = fatigue::din743_results<fatigue::Din743Safety>();
  return ranges_left(rated, fields);
}

/// By DIN 743, with the strengths as they are in this size.
fatigue::Din743Safety rated_by_din743(const Input& in, const ChangePlace& there, const Sides& sides, const Section& p,
                                      const Swings& swings, const Safety& s) {
  fatigue::Din743Steel steel;
  steel.R_m = in.R_m, steel.R_e = in.R_e;
  fatigue::Din743Loads loads;
  loads.F_zd = {swings.N.m, swings.N.a};
  loads.M_b = {abs(swings.M.m), swings.M.a};
  loads.M_t = {abs(swings.T.m), swings.T.a};
  loads.f_max = in.k_max;
  NoTrace quiet;
  return fatigue::din743(steel, section_of_din743(in, there, sides, p, s), loads, quiet);
}

/// Constant loads fixed in space: bending alternates as the shaft rotates, the axial force stays, torsion does both.
Swings standing(const Input& in, const Section& p) {
  Swings all;
  all.M = {p.M, 0.0 * N_m.one};
  all.N = {0.0 * N.one, p.N};
  all.T = {(1.0 - in.r_T) / 2.0 * abs(p.T), (1.0 + in.r_T) / 2.0 * abs(p.T)};
  return all;
}

/// Normal stresses together, and torsion.
struct Stresses {
  Swing<Stress> sigma, tau;
};
template <class Tracer>
Stresses stresses_of(const Input& in, const Section& p, Tracer& trace) {
  STEP(sigma_na, p.sigma_b, "bending alternates as the shaft turns");
  STEP(sigma_nm, abs(p.sigma_n), "axial force is constant");
  STEP(tau_a, (1.0 - in.r_T) / 2.0 * p.tau, "amplitude of torsion");
  STEP(tau_m, (1.0 + in.r_T) / 2.0 * p.tau, "mean of torsion");
  return {{sigma_na, sigma_nm}, {tau_a, tau_m}};
}
template <class Tracer>
Stresses stresses_of(const Section& p, const ChangePlace& there, const Swings& swings, Tracer& trace) {
  trace.angle("theta", swings.theta, "of the point on its circumference that decides, from X where psi is 0");
  const Moment M_a = trace.value("M_a", swings.M.a, "amplitude of bending at that point over a turn");
  const Moment M_m = trace.value("M_m", swings.M.m, "mean");
  const Force N_a = trace.value("N_a", swings.N.a, "amplitude of the force along the shaft");
  const Force N_m = trace.value("N_m", swings.N.m, "mean");
  const Moment T_a = trace.value("T_a", swings.T.a, "amplitude of the torque, by r_T too where that is given");
  const Moment T_m = trace.value("T_m", swings.T.m, "mean");
  trace.value("d_bore", p.d_bore, "bore");
  const auto [A, W, W_t] = moduli_of(p, there.notch, trace);
  STEP(sigma_na, M_a / W + N_a / A, "both maxima at the same time");
  STEP(sigma_nm, abs(M_m) / W + abs(N_m) / A, "pressure counts as pull");
  STEP(tau_a, T_a / W_t, "amplitude of torsion");
  STEP(tau_m, abs(T_m) / W_t, "mean of torsion");
  return {{sigma_na, sigma_nm}, {tau_a, tau_m}};
}

/// [Shigley7] (7-5) to (7-14), as safeties.
template <class Tracer>
void tire(const Input& in, const Stresses& stresses, Safety& s, Tracer& trace) {
  const Stress sigma_na = stresses.sigma.a, sigma_nm = stresses.sigma.m, tau_a = stresses.tau.a, tau_m = stresses.tau.m;
  STEP_TO(s, sigma_a, sqrt(pow<2>(s.K_f * sigma_na) + 3.0 * pow<2>(s.K_fs * tau_a)), "amplitude, [Shigley7] (7-5)");
  STEP_TO(s, sigma_m, sqrt(pow<2>(s.K_f * sigma_nm) + 3.0 * pow<2>(s.K_fs * tau_m)), "mean, [Shigley7] (7-6)");
  if (sigma_a + sigma_m == 0.0 * MPa) {
    s.n_Goodman = s.n_Soderberg = s.n_Gerber = s.n_elliptic = std::numeric_limits<double>::infinity();
    s.u_D = trace.value("u_D", 0.0, "no stress");
    return;
  }
  const Stress S_e = s.S_e;
  s.n_Goodman = fatigue::goodman("n_Goodman", sigma_a, sigma_m, S_e, in.R_m, "Goodman, [Shigley7] (7-7)", trace);
  s.n_Soderberg =
      fatigue::soderberg("n_Soderberg", sigma_a, sigma_m, S_e, in.R_e, "Soderberg, [Shigley7] (7-13)", trace);
  s.n_Gerber = fatigue::gerber("n_Gerber", sigma_a, sigma_m, S_e, in.R_m, "Gerber, [Shigley7] (7-9)", trace);
  s.n_elliptic =
      fatigue::elliptic("n_elliptic", sigma_a, sigma_m, S_e, in.R_e, "ellipse of ASME, [Shigley7] (7-11)", trace);
  const double n_D = in.method == School::goodman     ? NAMED_STEP("n_D", s.n_Goodman, "Goodman decides")
                     : in.method == School::soderberg ? NAMED_STEP("n_D", s.n_Soderberg, "Soderberg decides")
                     : in.method == School::gerber    ? NAMED_STEP("n_D", s.n_Gerber, "Gerber decides")
                     : in.method == School::din743    ? NAMED_STEP("n_D", s.n_DIN743, "DIN 743 decides")
                     : in.method == School::fkm       ? NAMED_STEP("n_D", s.n_FKM, "FKM decides")
                     : in.method == School::serensen  ? NAMED_STEP("n_D", s.n_Serensen, "Serensen decides")
                                                      : NAMED_STEP("n_D", s.n_elliptic, "the ellipse decides");
  STEP_TO(s, u_D, in.S_D / n_D, "fatigue");
}

Stressed stressed_by(const Swings& swings, const Moduli& of) {
  return {{swings.M.a / of.W, abs(swings.M.m) / of.W},
          {swings.N.a / of.A, swings.N.m / of.A},
          {swings.T.a / of.W_t, abs(swings.T.m) / of.W_t}};
}

/// One section by the schools that are not of [Shigley7].
class Rating {
 public:
  Rating(const Input& in, const ChangePlace& there, const Sides& sides, const Section& p)
      : in_(in), there_(there), sides_(sides), p_(p) {}

  /// Whether its factor is that of tests, or is computed as DIN 743 has it: for all schools alike.
  [[nodiscard]] bool by_factors() const { return there_.notch != nullptr && has_factors(there_.notch->kind); }

  /// By DIN 743, where that is asked, or has the factors of the notch.
  [[nodiscard]] fatigue::Din743Safety din743(const Swings& swings, const Safety& s) const {
    return steel() && (by_factors() || is_set(in_.R_z)) ? rated_by_din743(in_, there_, sides_, p_, swings, s)
                                                        : fatigue::Din743Safety{};
  }

  /// Their safeties, and the ranges that the one that decides has left.
  template <class Tracer>
  void rate(const Swings& swings, Safety& s, Tracer& trace) const {
    const fatigue::Din743Safety rated = din743(swings, s);
    const double outside = outside_of_din743(rated);
    const bool asked = steel() && is_set(in_.R_z);
    if (outside == 0.0 && asked) s.n_DIN743 = trace.value("n_DIN743", rated.S_D, "DIN 743, as fatigue.din743 finds it");
    if (in_.method == School::din743 || (by_factors() && there_.notch->kind != Notch::beta)) s.x_DIN = outside;
    if (!asked) return;
    NoTrace quiet;
    const Stressed stressed = stressed_by(swings, moduli_of(p_, there_.notch, quiet));
    other_schools(in_, section_of_din743(in_, there_, sides_, p_, s), stressed, rated, outside, s, trace);
  }

  /// The one of all amplitudes under which the section lasts least.
  [[nodiscard]] const Swings& weakest(std::span<const Swings> all, const Safety& prepared) const {
    NoTrace quiet;
    const Swings* found = all.data();
    double most = -1.0;
    for (const Swings& swings : all) {
      Safety s = prepared;
      if (in_.method >= School::din743) rate(swings, s, quiet);
      tire(in_, stresses_of(p_, there_, swings, quiet), s, quiet);
      if (std::isnan(s.u_D) || numerics::exceeds(s.u_D, most)) most = s.u_D, found = &swings;
    }
    return *found;
  }

 private:
  [[nodiscard]] bool steel() const { return in_.group <= Endurance::Group::cast_steel; }

  const Input& in_;
  const ChangePlace& there_;
  const Sides& sides_;
  const Section& p_;
};

/// Context of the section, reported before its notch.
template <class Tracer>
void trace_section(const Section& p, Length r_n, bool own, bool turns, Tracer& trace) {
  trace.value("d", p.d, "of the section");
  trace.value("r_n", r_n, own ? "of the notch" : "0.02 d, as of a keyway; no effect without a notch");
  if (!turns) return;
  trace.value("sigma_b", p.sigma_b, "of the section");
  trace.value("sigma_n", p.sigma_n, "of the section");
  trace.value("tau", p.tau, "of the section");
}

}  // namespace

template <class Tracer>
Safety safety_of(const Input& in, const ChangePlace& there, const Sides& sides, const Section& p,
                 std::span<const Swings> swings, Tracer& trace) {
  const Rating rating(in, there, sides, p);
  Safety s;
  s.name = p.name, s.x = p.x;
  const bool own = there.notch != nullptr && is_set(there.notch->r), is_steady = swings.empty();
  const Length r_n = own ? there.notch->r : 0.02 * p.d;
  const Swings some = is_steady ? standing(in, p) : swings.front();
  const bool twisted = some.T.a + abs(some.T.m) > 0.0 * N_m.one;
  trace_section(p, r_n, own, is_steady, trace);
  if (there.notch == nullptr) trace.value("K_t", s.K_t, "no notch");
  if (there.notch != nullptr && !rating.by_factors()) concentrate(*there.notch, sides, r_n, p, twisted, s, trace);
  if (rating.by_factors())
    weaken_by_factors(in, p.d, *there.notch, rating.din743(some, s), s, trace);
  else
    weaken(in, p.d, r_n, s, trace);
  const Swings decides = is_steady ? some : rating.weakest(swings, s);
  s.theta = decides.theta;
  rating.rate(decides, s, trace);
  tire(in, is_steady ? stresses_of(in, p, trace) : stresses_of(p, there, decides, trace), s, trace);
  return s;
}

template Safety safety_of(const Input&, const ChangePlace&, const Sides&, const Section&, std::span<const Swings>,
                          NoTrace&);
template Safety safety_of(const Input&, const ChangePlace&, const Sides&, const Section&, std::span<const Swings>,
                          Trace&);

}  // namespace loadpath::shaft
