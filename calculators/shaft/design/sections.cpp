#include "calculators/shaft/design/sections.hpp"

#include "calculators/shaft/design/fatigue.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::shaft {

namespace {

using Input = Design::Input;
using Result = Design::Result;

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

Sides sides_of(const Input& in, const Stations& stations, std::size_t node) {
  const std::size_t last = stations.piece.size() - 1;
  return {in.pieces[stations.piece[node == 0 ? 0 : node - 1]], in.pieces[stations.piece[std::min(node, last)]]};
}

/// Moduli of a section; a cross hole takes a strip off it.
struct Moduli {
  Area A;
  SectionModulus W, W_t;
};
template <class Tracer>
Moduli moduli_of(const Section& p, const Notched* notch, Tracer& trace) {
  if (notch != nullptr && notch->kind == Notch::cross_hole) {
    const Length r = trace.value("r", notch->r, "of the hole");
    STEP(A, pi / 4.0 * p.d * p.d - 2.0 * r * p.d, "net area, [DIN743] part 2 section 5.2.3");
    STEP(W, pi / 32.0 * pow<3>(p.d) - r * p.d * p.d / 3.0, "net modulus in bending, [DIN743] part 2 section 5.2.3");
    STEP(W_t, pi / 16.0 * pow<3>(p.d) - r * p.d * p.d / 3.0, "net modulus in torsion, [DIN743] part 2 section 5.2.3");
    return {A, W, W_t};
  }
  STEP(A, pi / 4.0 * (p.d * p.d - p.d_bore * p.d_bore), "area");
  STEP(W, pi / 32.0 * (pow<4>(p.d) - pow<4>(p.d_bore)) / p.d, "section modulus in bending");
  STEP(W_t, 2.0 * W, "the modulus in torsion is twice that in bending");
  return {A, W, W_t};
}

template <class Tracer>
void stress(const Input& in, const Felt& felt, const Notched* notch, Section& p, Tracer& trace) {
  p.M_x = trace.value("M_x", from_si<Moment>(felt.M_x), "by the elements of the beam");
  p.M_y = trace.value("M_y", from_si<Moment>(felt.M_y), "the same in the other plane");
  const Force V = trace.value("V", from_si<Force>(felt.V), "across the shaft, both planes together");
  p.N = trace.value("N", from_si<Force>(felt.N), "along the shaft: what acts on its left");
  p.T = trace.value("T", from_si<Moment>(felt.T), "around the shaft: what acts on its left");
  STEP_TO(p, M, sqrt(p.M_x * p.M_x + p.M_y * p.M_y), "both planes together");
  const auto [A, W, W_t] = moduli_of(p, notch, trace);
  STEP_TO(p, sigma_b, M / W, "extreme fibre");
  STEP_TO(p, sigma_n, p.N / A, "even over the section");
  STEP_TO(p, tau, abs(p.T) / W_t, "surface");
  STEP(kappa, 4.0 / 3.0 * (p.d * p.d + p.d * p.d_bore + p.d_bore * p.d_bore) / (p.d * p.d + p.d_bore * p.d_bore),
       "shear at the neutral axis over the mean shear, from Q S / (I b) of a ring");
  STEP(sigma_f, sqrt(pow<2>(sigma_b + abs(sigma_n)) + 3.0 * tau * tau), "extreme fibre, [Mises]");
  STEP(sigma_q, sqrt(sigma_n * sigma_n + 3.0 * pow<2>(tau + kappa * V / A)), "neutral axis, [Mises]");
  STEP_TO(p, sigma_v, in.k_max * max(sigma_f, sigma_q), "the larger of both, at the largest load");
  if (!is_set(in.S_F)) return;
  STEP_TO(p, u_v, in.S_F * sigma_v / in.R_e, "yield");
}

template <class Tracer>
Section section_at(const Input& in, const Loaded& loaded, const There& there, const Sides& sides, Tracer& trace) {
  Section p;
  p.name = there.name;
  p.x = from_si<Length>(loaded.stations.x[there.node]);
  p.d = sides.thinner().d, p.d_bore = max(sides.left.d_bore, sides.right.d_bore);
  if (there.notch != nullptr && is_groove(there.notch->kind)) p.d -= 2.0 * there.notch->t;
  trace.value("d", p.d, "the thinner side, of a groove its ground");
  trace.value("d_bore", p.d_bore, "bore");
  stress(in, loaded.felt(there.node), there.notch, p, trace);
  if (there.notch != nullptr && is_set(there.notch->h)) {
    const Length h = trace.value("h", there.notch->h, "asked for, by what is set against the shoulder");
    const Length high = trace.value("high", (sides.larger() - sides.thinner().d) / 2.0, "of the shoulder");
    STEP_TO(p, u_h, h / high, "what is set against it finds its face");
  }
  return p;
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
