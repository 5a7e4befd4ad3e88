#include "calculators/shaft/design/sections.hpp"

#include "calculators/fatigue/din743_fields.hpp"
#include "calculators/fatigue/din743_safety.hpp"
#include "calculators/fatigue/peterson.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::shaft {

namespace {

using fatigue::Endurance;
using Input = Design::Input;
using Result = Design::Result;

/// What changes at a place; no notch: null.
struct There {
  std::size_t node = 0;
  const Notched* notch = nullptr;
  Name name;
};

/// Where the moment is largest within a piece.
Length place_of_most(const Loaded& loaded, std::size_t piece) {
  std::size_t most = 0;
  double largest = -1.0;
  for (std::size_t s = 0; s < loaded.stations.piece.size(); ++s) {
    if (loaded.stations.piece[s] != piece) continue;
    for (const std::size_t node : {s, s + 1}) {
      const Felt felt = loaded.felt(node);
      const double M = std::hypot(felt.M_x, felt.M_y);
      if (M > largest) largest = M, most = node;
    }
  }
  return from_si<Length>(loaded.stations.x[most]);
}

using Changes = List<There, most_places>;

/// Of what stands at one place the notch comes first, then what has a name.
Changes changes_of(const Input& in, const Loaded& loaded) {
  Changes all;
  const auto add = [&](Length x, const Name& name, const Notched* notch) {
    const std::size_t node = loaded.stations.at(x);
    const auto same = std::find_if(all.begin(), all.end(), [&](const There& t) { return t.node == node; });
    if (same == all.end()) {
      all.push_back({node, notch, name});
    } else if (same->name.empty()) {
      same->name = name;
    }
  };
  for (const Notched& notch : in.notches) add(notch.x, notch.name, &notch);
  for (const Seat& seat : in.seats) add(seat.x, seat.name, nullptr);
  for (const Support& support : in.supports) add(support.x, support.name, nullptr);
  Length x = 0.0 * mm;
  add(x, {}, nullptr);
  for (const Piece& piece : in.pieces) add(x += piece.l, {}, nullptr);
  if (is_set(in.g_angle)) {  // weight bends most between them
    for (std::size_t piece = 0; piece < in.pieces.size(); ++piece) add(place_of_most(loaded, piece), {}, nullptr);
  }
  std::sort(all.begin(), all.end(), [](const There& a, const There& b) { return a.node < b.node; });
  return all;
}

/// The piece on each side of a node; the same at the ends of the shaft.
struct Sides {
  const Piece& left;
  const Piece& right;
  [[nodiscard]] const Piece& thinner() const { return left.d < right.d ? left : right; }
  [[nodiscard]] Length larger() const { return max(left.d, right.d); }
};
Sides sides_of(const Input& in, const Stations& stations, std::size_t node) {
  const std::size_t last = stations.piece.size() - 1;
  return {in.pieces[stations.piece[node == 0 ? 0 : node - 1]], in.pieces[stations.piece[std::min(node, last)]]};
}

template <class Tracer>
void stress(const Input& in, const Felt& felt, Section& p, Tracer& trace) {
  p.M_x = trace.value("M_x", from_si<Moment>(felt.M_x), "by the elements of the beam");
  p.M_y = trace.value("M_y", from_si<Moment>(felt.M_y), "the same in the other plane");
  const Force V = trace.value("V", from_si<Force>(felt.V), "across the shaft, both planes together");
  p.N = trace.value("N", from_si<Force>(felt.N), "along the shaft: what acts on its left");
  p.T = trace.value("T", from_si<Moment>(felt.T), "around the shaft: what acts on its left");
  STEP_TO(p, M, sqrt(p.M_x * p.M_x + p.M_y * p.M_y), "both planes together");
  STEP(A, pi / 4.0 * (p.d * p.d - p.d_bore * p.d_bore), "area");
  STEP(W, pi / 32.0 * (pow<4>(p.d) - pow<4>(p.d_bore)) / p.d, "section modulus in bending");
  STEP_TO(p, sigma_b, M / W, "extreme fibre");
  STEP_TO(p, sigma_n, p.N / A, "even over the section");
  STEP_TO(p, tau, abs(p.T) / (2.0 * W), "surface; the modulus in torsion is twice that in bending");
  STEP(kappa, 4.0 / 3.0 * (p.d * p.d + p.d * p.d_bore + p.d_bore * p.d_bore) / (p.d * p.d + p.d_bore * p.d_bore),
       "shear at the neutral axis over the mean shear, from Q S / (I b) of a ring");
  STEP(sigma_f, sqrt(pow<2>(sigma_b + abs(sigma_n)) + 3.0 * tau * tau), "extreme fibre, [Mises]");
  STEP(sigma_q, sqrt(sigma_n * sigma_n + 3.0 * pow<2>(tau + kappa * V / A)), "neutral axis, [Mises]");
  STEP_TO(p, sigma_v, in.k_max * max(sigma_f, sigma_q), "the larger of both, at the largest load");
  if (!is_set(in.S_F)) return;
  STEP_TO(p, u_v, in.S_F * sigma_v / in.R_e, "yield");
}

/// The notch as Peterson has it, and the range that he has it for.
template <class Tracer>
void concentrate(const Notched& notch, const Sides& sides, Length r_n, const Section& p, Safety& s, Tracer& trace) {
  const bool shoulder = notch.kind == Notch::shoulder, fits = shoulder || notch.kind == Notch::groove;
  if (fits) {
    const Length D = shoulder ? sides.larger() : p.d + 2.0 * notch.t;
    const Length h = (D - p.d) / 2.0;
    const auto in_bending =
        fatigue::concentration(shoulder ? fatigue::shoulder_in_bending : fatigue::groove_in_bending, h, r_n, D);
    const auto in_torsion = shoulder ? fatigue::concentration(fatigue::shoulder_in_torsion, h, r_n, D)
                                     : fatigue::concentration(fatigue::groove_in_torsion, h, r_n, D);
    s.K_t = in_bending.K, s.K_ts = in_torsion.K;
    s.x_b = trace.value("x_b", in_bending.place, "place within the fit, [Peterson]");
    if (abs(p.T) > 0.0 * N_m.one) s.x_t = trace.value("x_t", in_torsion.place, "place within the fit, [Peterson]");
  } else if (notch.kind == Notch::keyway) {
    s.K_t = 2.14, s.K_ts = 3.0;
  } else {
    s.K_t = notch.K_t, s.K_ts = notch.K_ts;
  }
  const char* const source = fits                          ? "of the net section, [Peterson]"
                             : notch.kind == Notch::keyway ? "end-milled, r = 0.02 d, [Shigley7] table 7-1"
                                                           : "as given";
  trace.value("K_t", s.K_t, source);
  trace.value("K_ts", s.K_ts, source);
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
  s.x_n = max(bending.x_n, torsion.x_n);
  s.K_fs = trace.value("K_fs", torsion.K_f, "in torsion, as fatigue.endurance finds it");
  const Stress sigma_D = bending.sigma_D;
  STEP_TO(s, S_e, s.K_f * sigma_D, "the notch stands with the stresses");
}

/// The section as DIN 743 has it; a given notch by its shape factors without any support, on the safe side.
fatigue::Din743Section section_of_din743(const Input& in, const There& there, const Sides& sides, const Section& p,
                                         const Safety& s) {
  using Kind = fatigue::Notch;
  fatigue::Din743Section section;
  section.notch = Kind::smooth, section.R_z = in.R_z, section.d = p.d, section.d_bore = p.d_bore;
  if (there.notch == nullptr) return section;
  const Notched& notch = *there.notch;
  section.r = notch.r;
  switch (notch.kind) {
    case Notch::shoulder:
      section.notch = Kind::shoulder, section.D = sides.larger();
      break;
    case Notch::groove:
      section.notch = Kind::round_groove, section.D = p.d + 2.0 * notch.t;
      break;
    case Notch::keyway:
      section.notch = Kind::keyway;
      break;
    case Notch::given:
      section.notch = Kind::alpha, section.alpha_zd = section.alpha_b = s.K_t, section.alpha_t = s.K_ts;
      break;
  }
  return section;
}

/// How many of its ranges the section is outside of.
double outside_of_din743(const fatigue::Din743Safety& rated) {
  const auto is_outside = [&](const auto& field) {
    if constexpr (requires { field.role == Role::limit&& field.bounds.holds(rated.*field.at); })
      return field.role == Role::limit && !std::isnan(rated.*field.at) && !field.bounds.holds(rated.*field.at);
    else
      return false;
  };
  return std::apply([&](const auto&... field) { return (0.0 + ... + (is_outside(field) ? 1.0 : 0.0)); },
                    fatigue::din743_results<fatigue::Din743Safety>());
}

/// By DIN 743, with the strengths as they are in this size; none outside of its ranges.
template <class Tracer>
void rate_by_din743(const Input& in, const There& there, const Sides& sides, const Section& p, Safety& s,
                    Tracer& trace) {
  if (!is_set(in.R_z) || in.group > Endurance::Group::cast_steel) return;
  fatigue::Din743Steel steel;
  steel.R_m = in.R_m, steel.R_e = in.R_e;
  fatigue::Din743Loads loads;
  loads.F_zd = {p.N, 0.0 * N.one};
  loads.M_b = {0.0 * N_m.one, p.M};
  loads.M_t = {(1.0 + in.r_T) / 2.0 * abs(p.T), (1.0 - in.r_T) / 2.0 * abs(p.T)};
  loads.f_max = in.k_max;
  NoTrace quiet;
  const auto rated = fatigue::din743(steel, section_of_din743(in, there, sides, p, s), loads, quiet);
  const double outside = outside_of_din743(rated);
  if (outside == 0.0) s.n_DIN743 = trace.value("n_DIN743", rated.S_D, "DIN 743, as fatigue.din743 finds it");
  if (in.method == School::din743) s.x_DIN = outside;
}

/// [Shigley7] (7-5) to (7-14), as safeties: bending alternates, the force along the shaft stays, torsion does both.
template <class Tracer>
void tire(const Input& in, const Section& p, Safety& s, Tracer& trace) {
  STEP(tau_a, (1.0 - in.r_T) / 2.0 * p.tau, "amplitude of torsion");
  STEP(tau_m, (1.0 + in.r_T) / 2.0 * p.tau, "mean of torsion");
  STEP_TO(s, sigma_a, sqrt(pow<2>(s.K_f * p.sigma_b) + 3.0 * pow<2>(s.K_fs * tau_a)), "amplitude, [Shigley7] (7-5)");
  STEP_TO(s, sigma_m, sqrt(pow<2>(s.K_f * p.sigma_n) + 3.0 * pow<2>(s.K_fs * tau_m)), "mean, [Shigley7] (7-6)");
  if (sigma_a + sigma_m == 0.0 * MPa) {
    s.n_Goodman = s.n_Soderberg = s.n_Gerber = s.n_elliptic = std::numeric_limits<double>::infinity();
    s.u_D = trace.value("u_D", 0.0, "no stress");
    return;
  }
  STEP_TO(s, n_Goodman, 1.0 / (sigma_a / s.S_e + sigma_m / in.R_m), "Goodman, [Shigley7] (7-7)");
  STEP_TO(s, n_Soderberg, 1.0 / (sigma_a / s.S_e + sigma_m / in.R_e), "Soderberg, [Shigley7] (7-13)");
  STEP(q_m, 2.0 * sigma_m * s.S_e / in.R_m, "mean stress, as the parabola counts it");
  STEP_TO(s, n_Gerber, 2.0 * s.S_e / (sigma_a + sqrt(sigma_a * sigma_a + q_m * q_m)), "Gerber, [Shigley7] (7-9)");
  STEP_TO(s, n_elliptic, 1.0 / sqrt(pow<2>(sigma_a / s.S_e) + pow<2>(sigma_m / in.R_e)),
          "ellipse of ASME, [Shigley7] (7-11)");
  const double n_D = in.method == School::goodman     ? NAMED_STEP("n_D", s.n_Goodman, "Goodman decides")
                     : in.method == School::soderberg ? NAMED_STEP("n_D", s.n_Soderberg, "Soderberg decides")
                     : in.method == School::gerber    ? NAMED_STEP("n_D", s.n_Gerber, "Gerber decides")
                     : in.method == School::din743    ? NAMED_STEP("n_D", s.n_DIN743, "DIN 743 decides")
                                                      : NAMED_STEP("n_D", s.n_elliptic, "the ellipse decides");
  STEP_TO(s, u_D, in.S_D / n_D, "fatigue");
}

template <class Tracer>
Section section_at(const Input& in, const Loaded& loaded, const There& there, const Sides& sides, Tracer& trace) {
  Section p;
  p.name = there.name;
  p.x = from_si<Length>(loaded.stations.x[there.node]);
  p.d = sides.thinner().d, p.d_bore = max(sides.left.d_bore, sides.right.d_bore);
  if (there.notch != nullptr && there.notch->kind == Notch::groove) p.d -= 2.0 * there.notch->t;
  trace.value("d", p.d, "the thinner side, of a groove its ground");
  trace.value("d_bore", p.d_bore, "bore");
  stress(in, loaded.felt(there.node), p, trace);
  return p;
}

template <class Tracer>
Safety safety_of(const Input& in, const There& there, const Sides& sides, const Section& p, Tracer& trace) {
  Safety s;
  s.name = p.name, s.x = p.x;
  const bool own = there.notch != nullptr && is_set(there.notch->r);
  const Length r_n = own ? there.notch->r : 0.02 * p.d;
  trace.value("d", p.d, "of the section");
  trace.value("r_n", r_n, own ? "of the notch" : "0.02 d, of a keyway; of no account without a notch");
  trace.value("sigma_b", p.sigma_b, "of the section");
  trace.value("sigma_n", p.sigma_n, "of the section");
  trace.value("tau", p.tau, "of the section");
  if (there.notch != nullptr) concentrate(*there.notch, sides, r_n, p, s, trace);
  weaken(in, p.d, r_n, s, trace);
  rate_by_din743(in, there, sides, p, s, trace);
  tire(in, p, s, trace);
  return s;
}

/// The element with the largest utilisation.
template <class Elements, class Use>
std::size_t governing(const Elements& all, const Use& use) {
  const auto found =
      std::max_element(all.begin(), all.end(), [&](const auto& a, const auto& b) { return use(a) < use(b); });
  return static_cast<std::size_t>(found - all.begin());
}

}  // namespace

template <class Tracer>
void judge_sections(const Input& in, const Loaded& loaded, Result& r, Tracer& trace) {
  NoTrace quiet;
  const Changes changes = changes_of(in, loaded);
  for (const There& there : changes) {
    const Sides sides = sides_of(in, loaded.stations, there.node);
    r.sections.push_back(section_at(in, loaded, there, sides, quiet));
    if (Design::asks_fatigue(in)) r.safeties.push_back(safety_of(in, there, sides, r.sections.back(), quiet));
  }
  {
    const std::size_t yields = governing(r.sections, [](const Section& p) { return in_si(p.sigma_v); });
    [[maybe_unused]] const auto here = trace.scope("sections", yields);
    section_at(in, loaded, changes[yields], sides_of(in, loaded.stations, changes[yields].node), trace);
  }
  if (r.safeties.empty()) return;
  const std::size_t tires = governing(r.safeties, [](const Safety& s) { return s.u_D; });
  [[maybe_unused]] const auto here = trace.scope("safeties", tires);
  safety_of(in, changes[tires], sides_of(in, loaded.stations, changes[tires].node), r.sections[tires], trace);
}

template void judge_sections(const Input&, const Loaded&, Result&, NoTrace&);
template void judge_sections(const Input&, const Loaded&, Result&, Trace&);

}  // namespace loadpath::shaft
