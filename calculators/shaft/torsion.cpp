#include "calculators/shaft/torsion.hpp"

#include "calculators/shaft/round_sizing.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>

namespace loadpath::shaft {

namespace {

Length total_length(const Torsion::Input& in) {
  Length sum = 0.0 * m.one;
  for (const auto& s : in.segments) sum += s.l;
  for (const auto& t : in.torques) {
    if (in.segments.empty()) sum = max(sum, t.x);
  }
  return is_set(in.l) ? in.l : sum;
}

Cylinder cylinder_of(const Torsion::Input& in, const Torsion::Segment& s) {
  const bool own_bore = is_set(s.chi) || is_set(s.d_bore);
  return {s.l, is_set(s.d) ? s.d : in.d, own_bore ? s.chi : in.chi, own_bore ? s.d_bore : in.d_bore};
}

Cylinders cylinders_of(const Torsion::Input& in) {
  Cylinders cylinders;
  for (const auto& s : in.segments) cylinders.push_back(cylinder_of(in, s));
  if (cylinders.empty()) cylinders.push_back({total_length(in), in.d, in.chi, in.d_bore});
  return cylinders;
}

Moment given_sum(const Torsion::Input& in) {
  Moment sum = 0.0 * N_m.one;
  for (const auto& t : in.torques) sum += t.T;
  return sum;
}

bool is_beyond(const Torsion::Input& in, const Torsion::Torque& t) {
  return !(t.x <= total_length(in) * (1.0 + 1e-12));
}

/// The torques with the reaction of the end that is held.
Torques torques_of(const Torsion::Input& in) {
  Torques torques;
  for (const auto& t : in.torques) torques.push_back({t.x, t.T});
  const Moment reaction = -given_sum(in);
  if (in.fixed == Torsion::Fixed::left) torques.push_back({0.0 * m.one, reaction});
  if (in.fixed == Torsion::Fixed::right) torques.push_back({total_length(in), reaction});
  return torques;
}

/// The short form: one torque goes through the whole shaft.
Stretches stretches_of_short_form(const Torsion::Input& in) {
  Stretches parts;
  Length x = 0.0 * m.one;
  if (in.segments.empty()) parts.push_back({x, in.T, {in.l, in.d, in.chi, in.d_bore}});
  for (const auto& s : in.segments) {
    parts.push_back({x, in.T, cylinder_of(in, s)});
    x += s.l;
  }
  return parts;
}

/// What sizing and checking of one stretch need beside its moment.
struct Allowed {
  Stress tau_all;
  Stress G;
  Twist theta_adm;
};

constexpr SizingReasons by_strength{"strength, [B19] (4)", "strength of a ring, [B19] (5)",
                                    "strength: the diameter that has W_t with the given bore, [B19] (3)"};

/// The least diameter by strength.
template <class Tracer>
Length size_by_strength(Moment M_t, const Cylinder& c, Stress tau_all, Tracer& trace) {
  STEP(W_t, M_t / tau_all, "section modulus in torsion that strength asks for, [B19] (3)");
  return size_for_modulus("d_strength", W_t, {c.chi, c.d_bore}, by_strength, trace);
}

/// The same by stiffness.
template <class Tracer>
Length size_by_stiffness(Moment M_t, const Cylinder& c, const Allowed& allowed, Tracer& trace) {
  const auto& [tau_all, G, theta_adm] = allowed;
  const Length d_bore = c.d_bore;
  if (!is_set(theta_adm)) return unset<Length>;
  if (is_set(c.chi)) {
    STEP(d_stiffness, sqrt(sqrt(32.0 * M_t / (pi * G * theta_adm * (1.0 - pow<4>(c.chi))))),
         "stiffness of a ring, [B19] (10)");
    return d_stiffness;
  }
  if (is_set(d_bore)) {
    STEP(d_stiffness, sqrt(sqrt(pow<4>(d_bore) + 32.0 * M_t / (pi * G * theta_adm))),
         "stiffness with the given bore, [B19] (8)");
    return d_stiffness;
  }
  STEP(d_stiffness, sqrt(sqrt(32.0 * M_t / (pi * G * theta_adm))), "stiffness, [B19] (9)");
  return d_stiffness;
}

template <class Tracer>
Stress allowable(const Torsion::Input& in, Tracer& trace) {
  if (is_set(in.tau_adm)) {
    STEP(tau_all, in.tau_adm, "as given");
    return tau_all;
  }
  STEP(tau_all, in.R_e / (sqrt(3.0) * in.S), "yielding in shear by the distortion energy hypothesis, [Mises]");
  return tau_all;
}

/// Stress and twist of one stretch at its diameter.
template <class Tracer>
void load(Torsion::Stretch& s, Stress G, double K_A, Tracer& trace) {
  if (s.M_t <= 0.0 * N_m.one && !(s.d > s.d_bore)) {  // no moment has sized it, and none loads it
    s.tau = from_si<Stress>(0.0);
    if (is_set(G)) s.theta = from_si<Twist>(0.0), s.phi = is_set(s.l) ? 0.0 : s.phi;
    trace.value("tau", s.tau, "no moment");
    return;
  }
  STEP(I_t, pi / 32.0 * (pow<4>(s.d) - pow<4>(s.d_bore)), "polar second moment of a ring");
  STEP_TO(s, tau, s.M_t * s.d / (2.0 * I_t), "at the surface, [B19] (2)");
  if (!is_set(G)) return;
  STEP_TO(s, theta, K_A * s.M / (G * I_t), "twist per length, signed, [B19] (7)");
  if (!is_set(s.l)) return;
  STEP_TO(s, phi, theta * s.l, "twist of the stretch");
}

/// Takes the magnitude where it is larger. Once something is not available, the largest is not either.
template <class Quantity>
void raise(Quantity& largest, Quantity value) {
  const Quantity size = abs(value);
  if (is_set(largest) && !(size <= largest)) largest = size;
}

/// Moments and least diameters, stretch by stretch; the largest are those of the shaft.
template <class Tracer>
void size_stretches(const Torsion::Input& in, const Stretches& parts, Torsion::Result& r, Tracer& trace) {
  const Allowed allowed{r.tau_all, in.G, in.theta_adm};
  Moment M_max = 0.0 * N_m.one;
  Length strongest = 0.0 * m.one, stiffest = strongest, open = strongest;
  bool any_open = false;
  for (const shaft::Stretch& part : parts) {
    [[maybe_unused]] const auto scope = trace.scope("segments", r.segments.size());
    const Moment M = part.M;
    const Cylinder& c = part.cylinder;
    trace.value("M", M, "internal moment: the sum of the torques to its left");
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
    raise(open, is_set(d_stiffness) ? max(d_strength, d_stiffness) : d_strength);
  }
  if (any_open) r.d = open;
  if (is_set(in.d)) r.d = in.d;
  r.M_max = M_max, r.d_strength = strongest, r.d_stiffness = stiffest;
}

template <class Tracer>
void choose_least(const Torsion::Input& in, Torsion::Result& r, Tracer& trace) {
  trace.value("d_strength", r.d_strength, "largest of the shaft");
  if (is_set(in.theta_adm)) {
    trace.value("d_stiffness", r.d_stiffness, "largest of the shaft");
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
  Length x = 0.0 * m.one, d_max = x;
  Stress tau_max = from_si<Stress>(0.0);
  Twist theta_max = from_si<Twist>(0.0);
  double twist = 0.0, least = 0.0, most = 0.0;
  r.sections.push_back({x, twist});
  for (std::size_t i = 0; i < parts.size(); ++i) {
    [[maybe_unused]] const auto scope = trace.scope("segments", i);
    const Cylinder& c = parts[i].cylinder;
    Torsion::Stretch& s = r.segments[i];
    s.d = is_set(c.d) ? c.d : r.d;
    s.d_bore = bore_of(c.d_bore, c.chi, s.d);
    load(s, in.G, in.K_A, trace);
    raise(d_max, s.d);
    raise(tau_max, s.tau);
    raise(theta_max, s.theta);
    x = s.x + s.l;
    twist += s.phi;
    least = min(least, twist);
    most = max(most, twist);
    if (is_set(x)) r.sections.push_back({x, twist});
  }
  r.d_max = d_max, r.d_bore = bore_of(in.d_bore, in.chi, r.d), r.tau_max = tau_max, r.theta_max = theta_max;
  r.phi = twist;
  r.phi_max = is_set(twist) ? most - least : unset<double>;
}

template <class Tracer>
void judge(const Torsion::Input& in, Torsion::Result& r, Tracer& trace) {
  trace.value("tau_max", r.tau_max, "largest of the shaft");
  STEP_TO(r, u_tau, r.tau_max / r.tau_all, "strength condition, [B19] (3)");
  if (is_set(in.theta_adm)) {
    trace.value("theta_max", r.theta_max, "largest of the shaft");
    STEP_TO(r, u_theta, r.theta_max / in.theta_adm, "stiffness condition, [B19] (8)");
  }
  if (is_set(r.phi)) trace.angle("phi", r.phi, "sum over the stretches, with sign");
  r.F_bend = abs(in.F);
}

}  // namespace

bool Torsion::torques_close(const Input& in) {
  if (in.fixed != Fixed::none || in.torques.empty()) return true;
  double largest = 0.0;
  for (const auto& t : in.torques) largest = std::max(largest, std::abs(in_si(t.T)));
  return std::abs(in_si(given_sum(in))) <= 1e-6 * largest;
}

FieldFault Torsion::open_sum(const Input& in) {
  const double sum = in_si(given_sum(in));
  return {"torques", say("the torques sum to {1}, not to zero", format_quantity(sum, N_m.symbol)),
          say("add the torque of {1} that is missing, or hold an end: fixed = \"left\" or fixed = \"right\"",
              format_quantity(-sum, N_m.symbol))};
}

bool Torsion::torques_on_shaft(const Input& in) {
  return std::none_of(in.torques.begin(), in.torques.end(), [&](const Torque& t) { return is_beyond(in, t); }) &&
         (in.torques.empty() || total_length(in) > 0.0 * m.one);
}

FieldFault Torsion::torque_off_shaft(const Input& in) {
  const auto off =
      std::find_if(in.torques.begin(), in.torques.end(), [&](const Torque& t) { return is_beyond(in, t); });
  if (off == in.torques.end()) {
    return {"torques", say("all torques act at one place, and the shaft has no length"),
            say("give each torque the place x that it acts at, from the left end")};
  }
  const std::string number = std::to_string(off - in.torques.begin() + 1);
  const std::string name = off->name.empty() ? number : "'" + std::string(off->name.view()) + "'";
  return {off->name.empty() ? "torques[" + number + "].x" : "torques." + std::string(off->name.view()) + ".x",
          say("torque {1} stands at {2}, {3} beyond the end of the shaft at {4}", name,
              format_quantity(in_si(off->x), mm.symbol), format_quantity(in_si(off->x - total_length(in)), mm.symbol),
              format_quantity(in_si(total_length(in)), mm.symbol)),
          in.segments.empty() ? say("x counts from the left end: correct it, or the length l")
                              : say("x counts from the left end: correct it, or the lengths of the segments")};
}

/// Where tau_adm is given no material fills R_e: it was typed, or S stands alone.
FieldFault Torsion::two_safeties(const Input& in) {
  if (is_set(in.R_e)) return {};
  return {
      "S", say("tau_adm already holds the safety, and S would be a second one"),
      say("leave out S; or leave out tau_adm, and S counts against the yield strength R_e, given or of a material")};
}

bool Torsion::bores_fit(const Input& in) {
  return std::all_of(in.segments.begin(), in.segments.end(), [&](const Segment& s) {
    const Length d = is_set(s.d) ? s.d : in.d;
    const Length d_bore = is_set(s.d_bore) || is_set(s.chi) ? s.d_bore : in.d_bore;
    return !(is_set(s.chi) && is_set(s.d_bore)) && !(is_set(d) && is_set(d_bore) && d_bore >= d);
  });
}

template <class Tracer>
Torsion::Result Torsion::evaluate(const Input& in, Tracer& trace) {
  Result r;
  r.tau_all = allowable(in, trace);
  const Stretches parts =
      in.torques.empty() ? stretches_of_short_form(in) : stretches(torques_of(in), cylinders_of(in));
  size_stretches(in, parts, r, trace);
  choose_least(in, r, trace);
  load_stretches(in, parts, r, trace);
  judge(in, r, trace);
  return r;
}

template Torsion::Result Torsion::evaluate(const Input&, NoTrace&);
template Torsion::Result Torsion::evaluate(const Input&, Trace&);

std::vector<draw::Figure> Torsion::figures(const Input&, const Result& r) {
  if (!is_set(r.segments.front().l)) return {};
  draw::Curve moment{"M", {}, {}, true};
  draw::Shaft side;
  for (const Stretch& s : r.segments) {
    for (const double x : {in_si(s.x), in_si(s.x + s.l)}) {
      moment.x.push_back(x);
      moment.y.push_back(in_si(s.M));
    }
    side.parts.push_back({in_si(s.l), in_si(s.d), in_si(s.d_bore)});
  }
  draw::Plot diagram;
  diagram.x = {"x", "place along the shaft", "mm"};
  diagram.y = {"M", "internal moment", "N*m"};
  diagram.curves.push_back(std::move(moment));
  return {{"shaft", "The shaft from the side", std::move(side)},
          {"torque-diagram", "Torque diagram", std::move(diagram)}};
}

}  // namespace loadpath::shaft

template const loadpath::Calculator& loadpath::erased<loadpath::shaft::Torsion>();
