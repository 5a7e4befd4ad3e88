#include "calculators/fatigue/life.hpp"

#include "calculators/fatigue/estimate.hpp"
#include "calculators/fatigue/tensile_strength.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::fatigue {

namespace {

using Input = Life::Input;
using Result = Life::Result;
using Row = Life::Row;
using Line = Life::Line;

bool in_shear(const Input& in) { return in.stress == Stresses::shear; }
bool is_grey(const Input& in) { return in.group == Life::Group::grey_iron; }

/// Shear strengths from the tensile strength and from the yield strength.
template <class Tracer>
Stress tensile(const Input& in, Tracer& trace) {
  if (!is_set(in.R_m) || !in_shear(in)) return in.R_m;
  return tensile_in_shear(in.R_m, trace);
}
template <class Tracer>
Stress yielding(const Input& in, Tracer& trace) {
  if (!is_set(in.R_e) || !in_shear(in)) return in.R_e;
  return yield_in_shear(in.R_e, trace);
}

/// Grey iron breaks where others yield.
template <class Tracer>
void first_cycle(const Input& in, Result& r, Tracer& trace) {
  if (is_set(in.R_m)) {
    const Stress S_B = trace.value("S_B", tensile(in, trace), "tensile strength, of shear in shear: that of one cycle");
    STEP(sigma_p, in.stress == Stresses::shear ? max(abs(r.sigma_max), abs(r.sigma_min)) : max(r.sigma_max, 0.0 * MPa),
         "maximum stress; for normal stresses the tensile one");
    STEP_TO(r, x_B, sigma_p / S_B, "maximum stress / tensile strength");
  }
  if (is_set(in.R_e)) {
    r.u_y = part_of_yield(in, r, trace);
  } else if (is_grey(in) && is_set(in.R_m)) {
    STEP_TO(r, u_y, max(abs(r.sigma_max), abs(r.sigma_min)) / in.R_m, "grey iron breaks at its tensile strength");
  } else {
    return;
  }
  const double u_y = r.u_y;
  if (u_y > 0.0) {
    STEP_TO(r, n_y, 1.0 / u_y, "Langer, [Shigley6] (6-49)");
  }
  if (is_set(in.S_F)) {
    STEP_TO(r, u_F, in.S_F * r.u_y, "with its safety");
  }
}

/// Material constants of steels by their strength: the exponent of Walker, psi of Serensen; FKM's of every group.
template <class Tracer>
void sensitivities(const Input& in, Haigh& h, Tracer& trace) {
  const bool known = is_set(in.R_m), steel = known && is_steel(in.group), shear = in_shear(in);
  if (is_set(in.gamma)) h.gamma = in.gamma;
  if (!is_set(in.gamma) && steel && !shear)
    h.gamma = NAMED_STEP("gamma", max(0.8818 - 0.0002 * (in.R_m / MPa), 0.1),
                         "Walker, steels, [Dowling9], not checked against the source");
  if (is_set(in.psi)) h.psi_D = in.psi;
  if (!is_set(in.psi) && steel) {
    h.psi_D = psi_of_steels(shear ? "psi_sigma" : "psi", in.R_m, trace);
    if (shear) h.psi_D = psi_in_shear("psi", h.psi_D, trace);
  }
  if (is_set(h.psi_D)) {
    const double psi = h.psi_D, K_D = trace.value("K_D", is_set(in.K_D) ? in.K_D : 1.0, "specimen over part");
    h.psi_D = NAMED_STEP("psi_D", psi / K_D, "notch, size and surface do not apply to the mean stress, [GOST25504]");
  }
  if (is_set(in.M)) h.M = in.M;
  const FkmRow* const row = fkm_row(in.group);
  if (is_set(in.M) || row == nullptr || !known) return;
  const double a_M = trace.value("a_M", row->a_M, "of the group, [FKM]"), b_M = trace.value("b_M", row->b_M, "[FKM]");
  const double f_W = trace.value("f_W", shear ? row->tau : 1.0, "shear over normal, [FKM]");
  h.M = NAMED_STEP("M", f_W * min(max(a_M * 1e-3 * (in.R_m / MPa) + b_M, 0.0), 0.99),
                   "sensitivity to mean stress, [FKM]");
}

/// Everything but the strength for this life.
template <class Tracer>
Haigh strengths(const Input& in, const Result& r, Tracer& trace) {
  Haigh h;
  h.R_m = tensile(in, trace), h.R_e = yielding(in, trace), h.n_y = r.n_y;
  if (Life::is_ferrous(in)) h.sigma_f = in.sigma_f;  // which fits other metals badly, [Dowling9]
  if (is_set(in.sigma_fB)) h.sigma_f = in.sigma_fB;
  sensitivities(in, h, trace);
  return h;
}

bool applies(const Input& in, const Haigh& h, MeanRule rule) {
  const bool tension_alone = rule == MeanRule::morrow || rule == MeanRule::swt || rule == MeanRule::walker;
  return knows(h, rule) && !(in_shear(in) && tension_alone);
}

double cycles_of_limit(const Input& in) {
  if (is_set(in.N_D)) return in.N_D;
  return Life::is_ferrous(in) ? 1e6 : 1e8;
}

bool fits_f(const Input& in) { return in.line == Line::shigley && !is_set(in.f) && is_steel(in.group); }

template <class Tracer>
double fraction(const Input& in, Tracer& trace) {
  if (is_set(in.f)) return trace.value("f", in.f, "as given");
  return fraction_at_1e3(in.R_m, trace);
}

/// The finite-life line, amplitude = a_N N^b_N over cycles; none where what it needs is not given.
template <class Tracer>
void draw_line(const Input& in, const Haigh& h, Result& r, Tracer& trace) {
  using std::pow;
  const double N_D = trace.value("N_D", cycles_of_limit(in), "number of cycles of the fatigue limit");
  if (in.line == Line::basquin) {
    STEP_TO(r, b_N, in.b, "Basquin");
    STEP_TO(r, a_N, in.sigma_f * pow(2.0, in.b) / in.K_D, "a cycle is two reversals, [Dowling9] (9.22); over K_D");
    return;
  }
  if (in.line == Line::slope) {
    STEP_TO(r, b_N, -1.0 / in.k, "N S^k is constant");
    STEP_TO(r, a_N, in.sigma_D * pow(N_D, 1.0 / in.k), "through the fatigue limit at N_D");
    return;
  }
  if (!is_set(h.R_m) || !(is_set(in.f) || fits_f(in))) return;
  const double f = r.f = fraction(in, trace);
  const Stress S_su = h.R_m;  // in shear that of shear
  const Stress S_3 = in_shear(in) ? NAMED_STEP("S_3", f * S_su, "strength at 1e3 cycles, in shear")
                                  : NAMED_STEP("S_3", f * in.R_m, "strength at 1e3 cycles, [Shigley6]");
  if (!(S_3 > in.sigma_D)) return;
  STEP_TO(r, b_N, -log(S_3 / in.sigma_D) / log(N_D / 1000.0), "straight in logarithms, [Shigley6] (6-15)");
  STEP_TO(r, a_N, S_3 / pow(1000.0, r.b_N), "[Shigley6] (6-14)");
}

/// The line at N cycles, no higher than what breaks at once.
template <class Tracer>
Stress line_at(const Input& in, const Haigh& h, const Result& r, Tracer& trace) {
  using std::pow;
  STEP(S_l, r.a_N * pow(in.N, r.b_N), "strength at N cycles, by the line");
  if (!is_set(h.R_m)) return NAMED_STEP("S_N", S_l, "no tensile strength is given that bounds it");
  const Stress S_1 = trace.value("S_1", h.R_m, "tensile strength, of shear in shear: the strength of one cycle");
  return NAMED_STEP("S_N", min(S_l, S_1), "no line goes above it");
}

/// The fully reversed strength for the required life.
template <class Tracer>
void strength_for_life(const Input& in, const Haigh& h, Result& r, Tracer& trace) {
  const double N_D = cycles_of_limit(in);
  if (!is_set(in.N) || (in.N >= N_D && is_set(in.sigma_D))) {
    STEP_TO(r, S_e, in.sigma_D, is_set(in.N) ? "N is at N_D or beyond" : "endurance limit (infinite life)");
  } else {
    const Stress S_N = line_at(in, h, r, trace);
    r.S_e = is_set(in.sigma_D) ? NAMED_STEP("S_e", max(S_N, in.sigma_D), "not below the fatigue limit")
                               : NAMED_STEP("S_e", S_N, "no fatigue limit is given");
    if (fits_f(in)) r.x_f = trace.value("x_f", in.R_m / fit_of_f_ends, "over 200 kpsi, where the fit of f ends");
  }
  if (!is_set(in.N)) return;
  STEP_TO(r, x_N, 1000.0 / in.N, "low cycles are those of strains");
  if (!Life::is_ferrous(in) || !is_set(in.sigma_D)) r.x_D = trace.value("x_D", in.N / N_D, "N over N_D");
}

/// Cycles that an amplitude of symmetric cycles lasts; none below 1e3, and where no line is known.
template <class Tracer>
double life_at(const Input& in, const Result& r, Stress sigma_ar, Tracer& trace) {
  using std::pow;
  const double N_D = cycles_of_limit(in);
  if (!is_set(sigma_ar)) return unset<double>;
  if (is_set(in.sigma_D) && sigma_ar <= in.sigma_D) {
    return Life::is_ferrous(in) ? trace.value("N", std::numeric_limits<double>::infinity(), "below the fatigue limit")
                                : trace.value("N", N_D, "as far as the fatigue limit is given, N_D");
  }
  NoTrace quiet;
  const bool breaks = sigma_ar > tensile(in, quiet);
  const bool outside = breaks || (fits_f(in) && in.R_m > fit_of_f_ends);
  if (!is_set(r.a_N) || outside || !(sigma_ar > 0.0 * MPa) || pow(sigma_ar / r.a_N, 1.0 / r.b_N) < 1000.0)
    return unset<double>;
  return NAMED_STEP("N", min(pow(sigma_ar / r.a_N, 1.0 / r.b_N), N_D), "by the line, as far as N_D; cycles");
}

/// The mean stress as the rule counts it: tension, or shear of either sense.
template <class Tracer>
Stress counted_mean(const Input& in, const Result& r, MeanRule rule, Tracer& trace) {
  if (in.compression == Life::Compression::counted && rule == MeanRule::fkm && !in_shear(in))
    return trace.value("sigma_m", r.sigma_m, "compression counts, in the fields of FKM");
  const Stress sigma_t = in_shear(in) ? abs(r.sigma_m) : max(r.sigma_m, 0.0 * MPa);
  trace.value("sigma_t", sigma_t, in_shear(in) ? "shear of either sign" : "compressive mean stress is not credited");
  const bool raised = is_set(in.K_m) && rule <= MeanRule::morrow;
  const double K_m = trace.value("K_m", raised ? in.K_m : 1.0, "notch effect on the mean stress");
  return NAMED_STEP("sigma_m", K_m * sigma_t, "as the rule counts it");
}

/// Under their names in normal stresses, which the rules have.
template <class Tracer>
void show_strengths(const Input& in, const Haigh& h, Tracer& trace) {
  if (in_shear(in) && is_set(h.R_m)) trace.value("R_m", h.R_m, "of shear");
  if (in_shear(in) && is_set(h.R_e)) trace.value("R_e", h.R_e, "of shear");
  if (is_set(h.sigma_f)) trace.value("sigma_f", h.sigma_f, "sigma_f', or the true fracture stress where it is given");
}

template <class Tracer>
Row by_rule(const Input& in, const Haigh& h, const Result& r, MeanRule rule, Tracer& trace) {
  Row row;
  row.name = Name(word_of(rule));
  const Swing s{r.sigma_a, row.sigma_m = counted_mean(in, r, rule, trace)};
  show_strengths(in, h, trace);
  row.sigma_ar = equivalent(rule, h, s, trace);
  row.n = load_factor(rule, h, s, row.sigma_ar, trace);
  row.sigma_A = amplitude_left(rule, h, s.sigma_m, trace);
  const Stress sigma_A = row.sigma_A;
  row.n_m = NAMED_STEP("n_m", sigma_A / r.sigma_a, "constant mean stress");
  row.N = life_at(in, r, row.sigma_ar, trace);
  return row;
}

/// The cycle at S_D times the load: the strength that it needs.
Stress required(const Input& in, const Haigh& h, const Result& r, const Row& row) {
  NoTrace quiet;
  const double on_mean = in.mean == MeanStress::proportional ? in.S_D : 1.0;
  return equivalent(in.rule, h, {in.S_D * r.sigma_a, on_mean * row.sigma_m}, quiet);
}

template <class Tracer>
void decide(const Input& in, const Haigh& h, const Row& row, Result& r, Tracer& trace) {
  r.sigma_ar = row.sigma_ar, r.n_m = row.n_m, r.N_f = row.N;
  r.n = trace.value("n", row.n, "governing rule: factor on the total load");
  const Stress sigma_A = trace.value("sigma_A", row.sigma_A, "of the rule that decides: the mean stress stays");
  r.S_req = required(in, h, r, row);
  if (is_set(r.S_req)) trace.value("S_req", r.S_req, "sigma_ar of S_D times the load, by the rule");
  NoTrace quiet;
  r.N_S = life_at(in, r, r.S_req, quiet);
  if (is_set(r.N_S)) trace.value("N_S", r.N_S, "the life at that amplitude, as N at sigma_ar");
  const Stress most = largest_mean(h, in.rule);
  if (is_set(most) && row.sigma_m >= 0.0 * MPa)
    r.x_m = trace.value("x_m", row.sigma_m / most, "mean stress over the one that leaves no amplitude");
  if (in.mean == MeanStress::proportional) {
    STEP_TO(r, sigma_adm, r.n / in.S_D * r.sigma_a, "amplitude that is allowed, at this ratio");
    STEP_TO(r, u_D, in.S_D / r.n, "required / actual safety factor");
    return;
  }
  STEP_TO(r, sigma_adm, sigma_A / in.S_D, "amplitude that is allowed, at this mean stress");
  if (sigma_A > 0.0 * MPa) {
    STEP_TO(r, u_D, in.S_D * r.sigma_a / sigma_A, "amplitude with its safety over what the mean stress leaves");
  }
}

FieldFault missing(const char* path, const char* what, const char* remedy) { return {path, say(what), say(remedy)}; }

// ---- figures

/// Closer together towards its end, where an ellipse falls steeply.
figure::Curve limit_line(const Haigh& h, MeanRule rule, double reach) {
  NoTrace quiet;
  figure::Curve curve{word_of(rule), {}, {}};
  const Stress most = largest_mean(h, rule);
  const double end = is_set(most) ? std::min(reach, in_si(most)) : reach;
  constexpr int points = 48;
  for (int i = 0; i <= points; ++i) {
    const double m = end * std::sin(0.5 * pi * i / points);
    curve.x.push_back(m);
    curve.y.push_back(in_si(amplitude_left(rule, h, from_si<Stress>(m), quiet)));
  }
  return curve;
}

figure::Figure haigh_diagram(const Input& in, const Haigh& h, const Result& r) {
  figure::Plot plot;
  plot.x = {"sigma_m", "mean stress, as it is counted", "MPa"};
  plot.y = {"sigma_a", "amplitude", "MPa"};
  const double m = std::max(0.0, in_si(in_shear(in) ? abs(r.sigma_m) : r.sigma_m)), a = in_si(r.sigma_a);
  double reach = 1.2 * m;
  for (const Stress& R : {h.R_m, h.R_e}) reach = is_set(R) ? std::max(reach, in_si(R)) : reach;
  reach = std::max(reach, in_si(r.S_e));
  for (const auto& rule : choices_of(MeanRule{})) {
    if (applies(in, h, rule.value)) plot.curves.push_back(limit_line(h, rule.value, reach));
  }
  if (is_set(h.R_e)) plot.curves.push_back({"yield", {0.0, in_si(h.R_e)}, {in_si(h.R_e), 0.0}});
  const double grown = std::max(1.0, is_set(r.n) ? r.n : 1.0), left = std::max(1.0, is_set(r.n_m) ? r.n_m : 1.0);
  if (in.mean == MeanStress::proportional) {
    plot.curves.push_back({"load", {0.0, grown * m}, {0.0, grown * a}});
  } else {
    plot.curves.push_back({"load", {m, m}, {0.0, left * a}});
  }
  plot.marks.push_back({m, a, "cycle"});
  return {"haigh", "Haigh diagram: stress cycle, load line, limit curves of the mean stress rules", std::move(plot)};
}

figure::Figure wohler_diagram(const Input& in, const Result& r) {
  const double N_D = cycles_of_limit(in);
  const auto S = [&](double N) { return in_si(r.a_N) * std::pow(N, r.b_N); };
  figure::Plot plot;
  plot.x = {"N", "cycles", "-", true};
  plot.y = {"sigma_ar", "amplitude of symmetric cycles", "MPa", true};
  figure::Curve curve{word_of(in.line), {1e3, N_D}, {S(1e3), S(N_D)}};
  if (is_set(in.sigma_D)) curve.x.push_back(10.0 * N_D), curve.y.push_back(in_si(in.sigma_D));
  plot.curves.push_back(std::move(curve));
  if (is_set(in.sigma_D)) plot.bounds.push_back({in_si(in.sigma_D), "sigma_D"});
  const double N = is_set(in.N) ? in.N : std::isfinite(r.N_f) ? r.N_f : N_D;
  if (is_set(r.sigma_ar)) plot.marks.push_back({N, in_si(r.sigma_ar), "cycle"});
  return {"wohler", "Line of finite life, fatigue limit and the cycle", std::move(plot)};
}

}  // namespace

Applies Life::varies(const Input& in) {
  NoTrace quiet;
  const bool known = two_given(in) && sound(in);
  return where(!known || cycle_of(in, quiet).kind != Kind::constant);
}

bool Life::rule_has_all(const Input& in) { return lacking(in).path.empty(); }

FieldFault Life::lacking(const Input& in) {
  NoTrace quiet;
  if (in_shear(in) && (in.rule == MeanRule::morrow || in.rule == MeanRule::swt || in.rule == MeanRule::walker))
    return missing("rule", "this rule is given for normal stresses", "take goodman, gerber, elliptic, fkm or serensen");
  if (knows(strengths(in, Result{}, quiet), in.rule)) return {};
  switch (in.rule) {
    case MeanRule::soderberg:
    case MeanRule::elliptic:
      return missing("R_e", "the mean stress rule needs the yield strength R_e",
                     "give R_e, a material, or another rule");
    case MeanRule::modified_goodman:
      return missing("R_e", "the rule needs the tensile and the yield strength", "give them, or a material");
    case MeanRule::morrow:
      return missing("sigma_f", "Morrow's rule needs the fatigue strength coefficient, or the true fracture stress",
                     "give sigma_f, or sigma_fB; of non-ferrous metals sigma_fB");
    case MeanRule::walker:
      return missing("gamma", "Walker's rule needs its exponent; of steels it follows from R_m", "give gamma");
    case MeanRule::fkm:
      return missing("M", "the fields of FKM need M, or R_m of a group that FKM has", "give M");
    case MeanRule::serensen:
      return missing("psi", "Serensen's rule needs psi; of steels it follows from R_m", "give psi");
    default:
      return missing("R_m", "the mean stress rule needs the tensile strength R_m", "give it, or a material");
  }
}

bool Life::line_has_all(const Input& in) { return lacking_of_line(in).path.empty(); }

FieldFault Life::lacking_of_line(const Input& in) {
  if (in.line == Line::basquin && !(is_set(in.sigma_f) && is_set(in.b) && is_set(in.K_D)))
    return missing("b", "Basquin's line needs sigma_f, b and K_D", "K_D of fatigue.endurance; 1 of a smooth specimen");
  if (in.line == Line::slope && !is_set(in.k))
    return missing("k", "this line needs its slope k", "FKM has 5, in shear 8");
  if (in.line == Line::basquin && is_set(in.sigma_D) && is_set(in.N) && in.N < cycles_of_limit(in) &&
      in.sigma_f * std::pow(2.0 * in.N, in.b) / in.K_D < in.sigma_D)
    return missing("b", "Basquin's line is below sigma_D at N: they are not of one part", "both hold the same K_D");
  if (in.line != Line::shigley || !is_set(in.N) || in.N >= cycles_of_limit(in)) return {};
  if (!is_set(in.R_m)) return missing("R_m", "the finite-life line needs R_m", "give it, or line = \"slope\" with k");
  if (!is_set(in.f) && !is_steel(in.group))
    return missing("f", "the strength at 1e3 cycles is fitted for steels", "give f, or line = \"slope\" with k");
  NoTrace quiet;
  Result r;
  draw_line(in, strengths(in, r, quiet), r, quiet);
  if (!is_set(r.a_N)) return missing("f", "the strength at 1e3 cycles f R_m is not above sigma_D", "a line falls");
  return {};
}

template <class Tracer>
Life::Result Life::evaluate(const Input& in, Tracer& trace) {
  Result r;
  static_cast<Characteristics&>(r) = cycle_of(in, trace);
  first_cycle(in, r, trace);
  if (r.kind == Kind::constant) return r;
  if (in.group <= Group::cast_steel) compare_with_steel(in.E, r, "the group is one of steels", trace);
  Haigh h = strengths(in, r, trace);
  draw_line(in, h, r, trace);
  strength_for_life(in, h, r, trace);
  h.S_e = r.S_e;
  Row deciding;
  for (const auto& rule : choices_of(MeanRule{})) {
    if (!applies(in, h, rule.value)) continue;
    [[maybe_unused]] const auto here = trace.scope("rules", r.rules.size());
    r.rules.push_back(by_rule(in, h, r, rule.value, trace));
    if (rule.value == in.rule) deciding = r.rules[r.rules.size() - 1];
  }
  decide(in, h, deciding, r, trace);
  return r;
}

template Life::Result Life::evaluate(const Input&, NoTrace&);
template Life::Result Life::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Life::figures(const Input& in, const Result& r) {
  if (r.kind == Kind::constant) return {};
  NoTrace quiet;
  Haigh h = strengths(in, r, quiet);
  h.S_e = r.S_e;
  std::vector<figure::Figure> all{haigh_diagram(in, h, r)};
  if (is_set(r.a_N)) all.push_back(wohler_diagram(in, r));
  return all;
}

}  // namespace loadpath::fatigue

template const loadpath::Calculator& loadpath::erased<loadpath::fatigue::Life>();
