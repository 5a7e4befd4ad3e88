#include "calculators/shaft/design/tapers.hpp"

#include "calculators/shaft/design/fatigue.hpp"
#include "calculators/shaft/design/model/bending.hpp"
#include "calculators/shaft/design/model/positions.hpp"
#include "calculators/shaft/design/model/turn.hpp"
#include "calculators/shaft/design/sections.hpp"
#include "lib/numerics/peak.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::shaft {

namespace {

using Input = DesignInput;

using numerics::Peak;
using Peaks = List<Peak, most_pieces>;

/// The moment between the ends of a span, whose slope is the force across it: a cubic, right for any even load.
double moment_at(const beam::Ends& span, double l, double t) {
  const double a = span.left.M, b = span.right.M, rest = b - a;
  const double bulge = (1.0 - t) * (span.left.V * l - rest) - t * (span.right.V * l - rest);
  return a + t * rest + t * (1.0 - t) * bulge;
}

/// One position of the turn.
class Scan {
 public:
  Scan(const Input& in, const Stations& stations, const Loaded& loaded)
      : in_(in), stations_(stations), loaded_(loaded) {}

  /// Raises a peak to that of a piece: at the ends of its spans, and in the two next to the highest of them.
  template <class Use>
  void raise(Peak& peak, std::size_t piece, const Use& use) const {
    const std::size_t none = stations_.piece.size();
    std::size_t most = none + 1;
    for (std::size_t s = 0; s < none; ++s) {
      if (stations_.piece[s] != piece) continue;
      for (const std::size_t end : {s, s + 1}) {
        if (take(peak, {stations_.x[end], at(s, stations_.x[end], use)})) most = end;
      }
    }
    if (most > none) return;
    for (std::size_t s = most == 0 ? 0 : most - 1; s <= most && s < none; ++s) {
      if (stations_.piece[s] != piece) continue;
      take(peak, numerics::peak_between([&](double x) { return at(s, x, use); }, stations_.x[s], stations_.x[s + 1]));
    }
  }

 private:
  static bool take(Peak& peak, const Peak& other) {
    if (!(other.f > peak.f)) return false;
    peak = other;
    return true;
  }
  /// At a place of a span.
  template <class Use>
  double at(std::size_t s, double place, const Use& use) const {
    const double l = stations_.x[s + 1] - stations_.x[s], t = (place - stations_.x[s]) / l;
    InternalForces forces = loaded_.side(s, t > 0.5);
    forces.M_x = moment_at(loaded_.x.spans[s], l, t), forces.M_y = moment_at(loaded_.y.spans[s], l, t);
    return use(section_within(in_, stations_.piece[s], from_si<Length>(place), forces));
  }

  const Input& in_;
  const Stations& stations_;
  const Loaded& loaded_;
};

double tired(const Input& in, const Section& p, std::span<const Swings> swings) {
  NoTrace quiet;
  const Ring ring{p.d, p.d_bore};
  return safety_of(in, ChangePlace{}, Sides{ring, ring}, p, swings, quiet).u_D;
}

/// Under loads over a revolution, only at the nodes: each has its own amplitudes.
void raise_over_turn(const Input& in, const Stations& stations, const Turn& turn, Peaks& peaks) {
  for (std::size_t n = 1; n < stations.piece.size(); ++n) {
    const std::size_t piece = stations.piece[n];
    if (stations.piece[n - 1] != piece || !is_taper(in.pieces[piece])) continue;
    const InternalForces& forces = turn.internal_forces(n, turn.most_bent());
    const Section p = section_within(in, piece, from_si<Length>(stations.x[n]), forces);
    const Peak here{stations.x[n], tired(in, p, turn.swings(n, in.r_T))};
    if (here.f > peaks[piece].f) peaks[piece] = here;
  }
}

}  // namespace

CriticalPlaces weakest_of_tapers(const Input& in) {
  CriticalPlaces all;
  if (std::none_of(in.pieces.begin(), in.pieces.end(), &is_taper)) return all;
  const auto elastic = elastic_shaft(in);
  if (!elastic) return all;
  const Stations& stations = elastic->stations;
  Peaks yield(in.pieces.size()), fatigue(in.pieces.size());
  Turn turn(in, stations.x.size());
  const bool tires = asks_fatigue(in);
  for (std::size_t position = 0; position < turn.positions(); ++position) {
    const Loaded loaded = loaded_at(in, *elastic, position);
    const Scan scan(in, stations, loaded);
    for (std::size_t i = 0; i < in.pieces.size(); ++i) {
      if (!is_taper(in.pieces[i])) continue;
      scan.raise(yield[i], i, [](const Section& p) { return in_si(p.sigma_v); });
      if (tires && !turn.varies()) scan.raise(fatigue[i], i, [&](const Section& p) { return tired(in, p, {}); });
    }
    turn.take(loaded, loaded.largest_moment());
  }
  if (tires && turn.varies()) raise_over_turn(in, stations, turn, fatigue);
  constexpr double one = 1e-4;  // share of a taper: both are then one place
  for (std::size_t i = 0; i < in.pieces.size(); ++i) {
    const bool apart = std::abs(yield[i].t - fatigue[i].t) > one * in_si(in.pieces[i].l);
    if (yield[i].f > 0.0) all.push_back({yield[i].t, i});
    if (fatigue[i].f > 0.0 && (apart || !(yield[i].f > 0.0))) all.push_back({fatigue[i].t, i, true});
  }
  return all;
}

}  // namespace loadpath::shaft
