#include "calculators/shaft/torsion/torsion.hpp"

#include "calculators/shaft/torsion/parts.hpp"
#include "calculators/shaft/torsion/stretch.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::shaft {

namespace {

/// Takes the magnitude where it is larger. Once something is not available, the largest is not either.
template <class Quantity>
void raise(Quantity& largest, Quantity value) {
  const Quantity size = abs(value);
  if (is_set(largest) && !(size <= largest)) largest = size;
}

/// The larger of two, either of which may be unset.
Length larger_of(Length a, Length b) { return !is_set(a) ? b : !is_set(b) ? a : max(a, b); }

/// Moments and least diameters, stretch by stretch; the largest are those of the shaft.
template <class Tracer>
void size_stretches(const Torsion::Input& in, const Stretches& parts, Torsion::Result& r, Tracer& trace) {
  const Allowed allowed{r.tau_all, in.G, in.theta_adm};
  Moment M_max = 0.0 * N_m.one;
  Length strongest = 0.0 * m.one, stiffest = strongest, open = strongest;
  bool any_open = false;
  for (const shaft::Stretch& part : parts) {
    [[maybe_unused]] const auto scope = trace.scope("segments", r.segments.size());
    const Cylinder& c = part.cylinder;
    const Moment M = trace.value("M", part.M, "internal torque: sum of the torques to the left");
    STEP(M_t, in.K_A * abs(M), "design moment");
    if (is_set(c.chi)) trace.value("chi", c.chi, "bore ratio");
    const Length d_strength = size_by_strength(M_t, c, allowed.tau_all, trace);
    const Length d_stiffness = size_by_stiffness(M_t, c, allowed, trace);
    r.segments.push_back({part.x, c.l, M, M_t, d_strength, d_stiffness});
    raise(M_max, M_t);
    raise(strongest, d_strength);
    raise(stiffest, d_stiffness);
    if (is_set(c.d)) continue;
    any_open = true;
    raise(open, larger_of(d_strength, d_stiffness));
  }
  if (any_open) r.d = open;
  if (is_set(in.d)) r.d = in.d;
  r.M_max = M_max, r.d_strength = strongest, r.d_stiffness = stiffest;
}

template <class Tracer>
void choose_least(const Torsion::Input& in, Torsion::Result& r, Tracer& trace) {
  const bool by_strength = is_set(r.tau_all);
  if (!by_strength && !is_set(in.theta_adm)) return;  // only stresses and twist are required
  if (by_strength) trace.value("d_strength", r.d_strength, "largest value along the shaft");
  if (is_set(in.theta_adm) && !by_strength) {
    trace.value("d_stiffness", r.d_stiffness, "largest value along the shaft");
    STEP_TO(r, d_min, r.d_stiffness, "by stiffness only: no strength is given");
    r.governs = Torsion::Governs::stiffness;
    return;
  }
  if (is_set(in.theta_adm)) {
    trace.value("d_stiffness", r.d_stiffness, "largest value along the shaft");
    STEP_TO(r, D_star, 2.0 * r.tau_all / (in.G * in.theta_adm),
            "below this diameter stiffness governs, above it strength");
  }
  STEP_TO(r, d_min, is_set(r.d_stiffness) ? max(r.d_strength, r.d_stiffness) : r.d_strength,
          "the larger governs, [B19]");
  r.governs = r.d_stiffness > r.d_strength ? Torsion::Governs::stiffness : Torsion::Governs::strength;
}

/// Stresses and twist at the diameters as given, else at the common one; a ratio gives the bore unless it is kept.
template <class Tracer>
void load_stretches(const Torsion::Input& in, const Stretches& parts, Torsion::Result& r, Tracer& trace) {
  Length x = 0.0 * m.one, d_max = x, d_least = unset<Length>;
  Stress tau_max = from_si<Stress>(0.0);
  Twist theta_max = from_si<Twist>(0.0);
  double twist = 0.0, least = 0.0, most = 0.0;
  decltype(1.0 / Moment()) compliance = 0.0 / N_m.one;
  r.sections.push_back({x, twist});
  for (std::size_t i = 0; i < parts.size(); ++i) {
    [[maybe_unused]] const auto scope = trace.scope("segments", i);
    const Cylinder& c = parts[i].cylinder;
    Torsion::Stretch& s = r.segments[i];
    s.d = is_set(c.d) ? c.d : r.d;
    s.d_bore = bore_of(c.d_bore, c.chi, s.d);
    load(s, c.rho, in.G, in.K_A, trace);
    compliance += s.l / s.GI_t;
    raise(d_max, s.d);
    if (!(d_least <= s.d)) d_least = s.d;
    raise(tau_max, s.tau);
    raise(theta_max, s.theta);
    x = s.x + s.l;
    twist += s.phi;
    least = min(least, twist);
    most = max(most, twist);
    if (is_set(x)) r.sections.push_back({x, twist});
  }
  r.d_max = d_max, r.d_s = is_set(in.d_h) ? max(in.d_h, d_max) : d_max;
  r.d_bore = bore_of(in.d_bore, in.chi, r.d), r.tau_max = tau_max, r.theta_max = theta_max;
  constexpr double rounding = 1.001;
  if (d_max > rounding * d_least)
    r.K_ts = trace.value("K_ts", 1.1, "lower bound for shoulders with any fillet, [Peterson]");
  r.phi = twist;
  r.phi_max = is_set(twist) ? most - least : unset<double>;
  if (is_set(compliance))
    r.k_t = trace.value("k_t", 1.0 / compliance, "stretches in series: 1/k_t is the sum of l/(G I_t)");
}

template <class Tracer>
void judge(const Torsion::Input& in, Torsion::Result& r, Tracer& trace) {
  trace.value("tau_max", r.tau_max, "largest value along the shaft");
  if (is_set(r.tau_all)) {
    STEP_TO(r, u_tau, r.tau_max / r.tau_all, "strength condition, [B19] (3)");
  }
  if (is_set(in.theta_adm)) {
    trace.value("theta_max", r.theta_max, "largest value along the shaft");
    STEP_TO(r, u_theta, r.theta_max / in.theta_adm, "stiffness condition, [B19] (8)");
  }
  if (is_set(r.phi)) trace.angle("phi", r.phi, "sum over the stretches, with sign");
  r.F_bend = abs(in.F);
  r.cycle = {Stresses::shear, r.tau_max};
}

}  // namespace

template <class Tracer>
Torsion::Result Torsion::evaluate(const Input& in, Tracer& trace) {
  Result r;
  r.tau_all = allowable_shear(in, unset<Stress>, trace);
  if (is_set(in.P)) static_cast<void>(torque_of(in, trace));  // reported here, used by stretches_of
  const Stretches parts = stretches_of(in);
  size_stretches(in, parts, r, trace);
  choose_least(in, r, trace);
  load_stretches(in, parts, r, trace);
  judge(in, r, trace);
  return r;
}

template Torsion::Result Torsion::evaluate(const Input&, NoTrace&);
template Torsion::Result Torsion::evaluate(const Input&, Trace&);

namespace {

/// The shear stress over the radius, of the most stressed stretch that has a radius rho.
void add_distribution(const Torsion::Result& r, std::vector<figure::Figure>& figures) {
  const Torsion::Stretch* most = nullptr;
  for (const Torsion::Stretch& s : r.segments) {
    if (is_set(s.tau_rho) && (most == nullptr || s.tau > most->tau)) most = &s;
  }
  if (most == nullptr) return;
  const double inner = in_si(most->d_bore) / 2.0, outer = in_si(most->d) / 2.0, tau = in_si(most->tau);
  figure::Plot plot;
  plot.x = {"rho", "distance from the axis", "mm"};
  plot.y = {"tau", "shear stress", "MPa"};
  plot.curves.push_back({"tau", {inner, outer}, {tau * inner / outer, tau}, true});
  figures.push_back({"stress-distribution", "Shear stress over the radius", std::move(plot)});
}

}  // namespace

std::vector<figure::Figure> Torsion::figures(const Input& in, const Result& r) {
  if (!is_set(r.segments.front().l)) return {};
  figure::Curve moment{"M", {}, {}, true};
  figure::Shaft side;
  for (const Stretch& s : r.segments) {
    for (const double x : {in_si(s.x), in_si(s.x + s.l)}) {
      moment.x.push_back(x);
      moment.y.push_back(in_si(s.M));
    }
    side.parts.push_back({in_si(s.l), in_si(s.d), in_si(s.d_bore)});
  }
  for (const auto& t : in.torques) side.torques.push_back({in_si(t.x), in_si(t.T), std::string(t.name.view())});
  if (in.fixed != Fixed::none) {
    const AppliedTorque reaction = torques_of(in).back();
    side.torques.push_back({in_si(reaction.x), in_si(reaction.T), "reaction"});
  }
  figure::Plot diagram;
  diagram.x = {"x", "position along the shaft", "mm"};
  diagram.y = {"M", "internal moment", "N*m"};
  diagram.curves.push_back(std::move(moment));
  std::vector<figure::Figure> figures{{"shaft", "Side view of the shaft", std::move(side)},
                                      {"torque-diagram", "Torque diagram", std::move(diagram)}};
  add_distribution(r, figures);
  return figures;
}

}  // namespace loadpath::shaft

template const loadpath::Calculator& loadpath::erased<loadpath::shaft::Torsion>();
