#include "calculators/shaft/design/sections.hpp"

#include "calculators/shaft/design/fatigue.hpp"
#include "calculators/shaft/design/model/places.hpp"
#include "calculators/shaft/design/model/positions.hpp"
#include "calculators/shaft/design/model/turn.hpp"
#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace loadpath::shaft {

namespace {

using Input = DesignInput;
using Result = DesignResult;

/// Where the moment is largest within a piece.
Length place_of_most(const Stations& stations, const Turn& turn, std::size_t piece) {
  std::size_t most = 0;
  double largest = -1.0;
  for (std::size_t s = 0; s < stations.piece.size(); ++s) {
    if (stations.piece[s] != piece) continue;
    for (const std::size_t node : {s, s + 1}) {
      const InternalForces& forces = turn.internal_forces(node, turn.most_bent());
      const double M = std::hypot(forces.M_x, forces.M_y);
      if (numerics::exceeds(M, largest)) largest = M, most = node;
    }
  }
  return from_si<Length>(stations.x[most]);
}

using Changes = List<ChangePlace, most_places>;

/// "key_end_far": a name with more behind it, where there is one.
template <std::size_t more>
Name told_apart(const Name& name, std::string_view apart) {
  if (name.empty()) return name;
  List<char, Name::capacity + more> text(name.view().begin(), name.view().end());
  text.insert(text.end(), apart.begin(), apart.end());
  return std::string_view(text.data(), text.size());
}

/// Name of the taper; the place of lowest fatigue strength is distinguished from the most stressed.
Name name_of(const Input& in, const CriticalPlace& weak) {
  const Name& piece = in.pieces[weak.piece].name;
  return weak.tires ? told_apart<6>(piece, "_tires") : piece;
}

/// At one place the notch comes first, then a named object.
class Gathering {
 public:
  explicit Gathering(const Stations& stations) : stations_(stations) {}
  void add(Length x, const Name& name, const Notched* notch = nullptr) {
    const std::size_t node = stations_.at(x);
    const auto same = std::find_if(all_.begin(), all_.end(), [&](const ChangePlace& t) { return t.node == node; });
    if (same == all_.end()) {
      all_.push_back({node, notch, name});
    } else if (same->name.empty()) {
      same->name = name;
    }
  }
  [[nodiscard]] Changes sorted() {
    std::sort(all_.begin(), all_.end(), [](const ChangePlace& a, const ChangePlace& b) { return a.node < b.node; });
    return all_;
  }

 private:
  const Stations& stations_;
  Changes all_;
};

Changes changes_of(const Input& in, const Stations& stations, const Turn& turn) {
  Gathering gathering(stations);
  for (const Notched& notch : in.notches) gathering.add(notch.x, notch.name, &notch);
  for (const Notched& notch : in.notches) {
    if (const Length end = other_end(in, notch); is_on(in, end))
      gathering.add(end, told_apart<4>(notch.name, "_far"), &notch);
  }
  for (const Seat& seat : in.seats) gathering.add(seat.x, seat.name);
  for (const Support& support : in.supports) gathering.add(support.x, support.name);
  for (const Support& support : in.supports)
    gathering.add(pressure_centre(support), told_apart<7>(support.name, "_centre"));
  Length x = 0.0 * mm;
  gathering.add(x, {});
  for (const Piece& piece : in.pieces) gathering.add(x += piece.l, {});
  for (std::size_t piece = 0; is_set(in.g_angle) && piece < in.pieces.size(); ++piece) {  // it bends most between them
    if (!is_taper(in.pieces[piece])) gathering.add(place_of_most(stations, turn, piece), {});
  }
  for (const CriticalPlace& weak : stations.weakest) gathering.add(from_si<Length>(weak.x), name_of(in, weak));
  return gathering.sorted();
}

Sides sides_of(const Input& in, const Stations& stations, std::size_t node) {
  const std::size_t last = stations.piece.size() - 1;
  const auto side = [&](std::size_t span) {
    const std::size_t piece = stations.piece[span];
    return ring_at(in.pieces[piece], from_si<Length>(stations.x[node]) - start_of(in, piece));
  };
  return {side(node == 0 ? 0 : node - 1), side(std::min(node, last))};
}

template <class Tracer>
void stress(const Input& in, const InternalForces& forces, const Notched* notch, Section& p, Tracer& trace) {
  p.M_x = trace.value("M_x", from_si<Moment>(forces.M_x), "from the beam model");
  p.M_y = trace.value("M_y", from_si<Moment>(forces.M_y), "same, other plane");
  p.V = trace.value("V", from_si<Force>(forces.V), "across the shaft, both planes together");
  p.N = trace.value("N", from_si<Force>(forces.N), "axial: resultant of the forces on the left");
  p.T = trace.value("T", from_si<Moment>(forces.T), "torsional: resultant of the torques on the left");
  STEP_TO(p, M, sqrt(p.M_x * p.M_x + p.M_y * p.M_y), "both planes together");
  const auto [A, W, W_t] = moduli_of(p, notch, trace);
  STEP_TO(p, sigma_b, M / W, "extreme fibre");
  STEP_TO(p, sigma_n, p.N / A, "uniform over the section");
  STEP_TO(p, tau, abs(p.T) / W_t, "at the surface");
  STEP(kappa, 4.0 / 3.0 * (p.d * p.d + p.d * p.d_bore + p.d_bore * p.d_bore) / (p.d * p.d + p.d_bore * p.d_bore),
       "shear at the neutral axis over the mean shear, from Q S / (I b) of a ring");
  STEP(sigma_f, sqrt(pow<2>(sigma_b + abs(sigma_n)) + 3.0 * tau * tau), "extreme fibre, [Mises]");
  STEP(sigma_q, sqrt(sigma_n * sigma_n + 3.0 * pow<2>(tau + kappa * p.V / A)), "neutral axis, [Mises]");
  STEP_TO(p, sigma_v, in.k_max * max(sigma_f, sigma_q), "the larger of the two, at the maximum load");
  if (!is_set(in.S_F)) return;
  STEP_TO(p, u_v, in.S_F * sigma_v / in.R_e, "yield");
}

/// A section and the position of the revolution at which its load is highest.
struct Place {
  const ChangePlace& there;
  Sides sides;
  Length x;
};

template <class Tracer>
Section section_at(const Input& in, const Place& place, const InternalForces& forces, double psi, Tracer& trace) {
  const auto& [there, sides, x] = place;
  Section p;
  p.name = there.name, p.x = x, p.psi = psi;
  p.d = sides.thinner().d, p.d_bore = max(sides.left.d_bore, sides.right.d_bore);
  if (there.notch != nullptr && is_groove(there.notch->kind)) p.d -= 2.0 * there.notch->t;
  trace.value("d", p.d, "smaller adjacent diameter (groove: root diameter)");
  trace.value("d_bore", p.d_bore, "bore");
  if (is_set(psi)) trace.angle("psi", psi, "angle of maximum load");
  stress(in, forces, there.notch, p, trace);
  if (there.notch != nullptr && is_set(there.notch->h)) {
    const Length h = trace.value("h", there.notch->h, "required by the abutting part");
    const Length high = trace.value("high", (sides.larger() - sides.thinner().d) / 2.0, "of the shoulder");
    STEP_TO(p, u_h, h / high, "required / actual shoulder height");
  }
  return p;
}

/// The element with the largest utilisation.
template <class Elements, class Use>
std::size_t governing(const Elements& all, const Use& use) {
  const auto found = std::max_element(all.begin(), all.end(),
                                      [&](const auto& a, const auto& b) { return numerics::exceeds(use(b), use(a)); });
  return static_cast<std::size_t>(found - all.begin());
}

/// All sections of the shaft over its turn.
class Judging {
 public:
  Judging(const Input& in, const Stations& stations, const Turn& turn)
      : in_(in), stations_(stations), turn_(turn), changes_(changes_of(in, stations, turn)) {}

  void judge(Result& r) const {
    NoTrace quiet;
    for (std::size_t k = 0; k < changes_.size(); ++k) {
      r.sections.push_back(section(k, quiet));
      if (asks_fatigue(in_)) r.safeties.push_back(safety(k, r.sections.back(), quiet));
    }
  }

  /// At the position of its highest load.
  template <class Tracer>
  Section section(std::size_t k, Tracer& trace) const {
    const std::size_t position = worst_position(k);
    return section_at(in_, place(k), turn_.internal_forces(changes_[k].node, position), turn_.psi(position), trace);
  }
  template <class Tracer>
  Safety safety(std::size_t k, const Section& p, Tracer& trace) const {
    const auto swings = turn_.varies() ? turn_.swings(changes_[k].node, in_.r_T) : std::vector<Swings>();
    return safety_of(in_, changes_[k], place(k).sides, p, swings, trace);
  }

 private:
  [[nodiscard]] Place place(std::size_t k) const {
    const std::size_t node = changes_[k].node;
    return {changes_[k], sides_of(in_, stations_, node), from_si<Length>(stations_.x[node])};
  }

  [[nodiscard]] std::size_t worst_position(std::size_t k) const {
    NoTrace quiet;
    std::size_t worst = 0;
    Stress most = -1.0 * MPa;
    for (std::size_t i = 0; turn_.varies() && i < turn_.positions(); ++i) {
      const InternalForces& forces = turn_.internal_forces(changes_[k].node, i);
      const Stress sigma_v = section_at(in_, place(k), forces, unset<double>, quiet).sigma_v;
      if (numerics::exceeds(in_si(sigma_v), in_si(most))) most = sigma_v, worst = i;
    }
    return worst;
  }

  const Input& in_;
  const Stations& stations_;
  const Turn& turn_;
  Changes changes_;
};

}  // namespace

Section section_within(const Input& in, std::size_t piece, Length x, const InternalForces& forces) {
  NoTrace quiet;
  const Ring ring = ring_at(in.pieces[piece], x - start_of(in, piece));
  const ChangePlace there;
  return section_at(in, {there, {ring, ring}, x}, forces, unset<double>, quiet);
}

template <class Tracer>
void judge_sections(const Input& in, const Stations& stations, const Turn& turn, Result& r, Tracer& trace) {
  const Judging judging(in, stations, turn);
  judging.judge(r);
  if constexpr (Tracer::traces) {
    const std::size_t yields = governing(r.sections, [](const Section& p) { return in_si(p.sigma_v); });
    const std::size_t tires =
        r.safeties.empty() ? yields : governing(r.safeties, [](const Safety& s) { return s.u_D; });
    for (const std::size_t k : {std::min(yields, tires), std::max(yields, tires)}) {
      [[maybe_unused]] const auto here = trace.scope("sections", k);
      judging.section(k, trace);
      if (yields == tires) break;
    }
    if (r.safeties.empty()) return;
    [[maybe_unused]] const auto here = trace.scope("safeties", tires);
    judging.safety(tires, r.sections[tires], trace);
  }
}

template void judge_sections(const Input&, const Stations&, const Turn&, Result&, NoTrace&);
template void judge_sections(const Input&, const Stations&, const Turn&, Result&, Trace&);

}  // namespace loadpath::shaft
