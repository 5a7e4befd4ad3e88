#include "calculators/shaft/design/whirl.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::shaft {

namespace {

using Input = DesignInput;
using Result = DesignResult;
using beam::Sense;

template <class Tracer>
MassMoment I_d_of(const Seat& s, Tracer& trace) {
  if (is_set(s.I_d)) return s.I_d;
  const MassMoment I_p = trace.value("I_p", s.I_p, "of the seat");
  const Mass m_s = trace.value("m_s", s.mass, "of the seat");
  const Length b = trace.value("b", s.b, "of the seat");
  return NAMED_STEP("I_d", I_p / 2.0 + m_s * b * b / 12.0, "a body of revolution with even mass along b");
}

/// Masses and moments of inertia at the nodes: half of each span, and what sits there.
beam::Row<beam::Inertia> inertias_of(const Input& in, const Elastic& elastic) {
  const beam::Row<double> masses = masses_of(in, elastic);
  beam::Row<beam::Inertia> all(masses.size());
  for (std::size_t n = 0; n < all.size(); ++n) all[n].m = masses[n];
  for (std::size_t s = 0; s + 1 < all.size(); ++s) {
    const Stretch& stretch = elastic.stretches[s];
    all[s].I_d += stretch.left_I_d, all[s].I_p += 2.0 * stretch.left_I_d;
    all[s + 1].I_d += stretch.right_I_d, all[s + 1].I_p += 2.0 * stretch.right_I_d;
  }
  NoTrace quiet;
  for (const Seat& seat : in.seats) {
    if (!is_set(seat.I_p)) continue;
    beam::Inertia& at = all[elastic.stations.at(seat.x)];
    at.I_d += in_si(I_d_of(seat, quiet)), at.I_p += in_si(seat.I_p);
  }
  return all;
}

/// Where a search starts: a little above what is like it.
double above(double like) {
  constexpr double little = 1.05, anywhere = 256.0;
  return like > 0.0 ? little * like : anywhere;
}

AngularSpeed per_second(double omega) { return from_si<AngularSpeed>(omega / (2.0 * pi)); }

constexpr std::array<const char*, most_whirls> names{"first", "second", "third"};

template <class Tracer>
WhirlMode whirled(std::size_t i, const beam::Whirl& whirl, AngularSpeed n, double like, Tracer& trace) {
  [[maybe_unused]] const auto here = trace.scope("whirls", i);
  const auto natural = [&](const char* symbol, Sense sense, double spin, const char* why) {
    return trace.value(symbol, per_second(whirl.natural(i, sense, spin, above(like))), why);
  };
  const auto critical = [&](const char* symbol, Sense sense, const char* why) {
    return trace.speed(symbol, from_si<AngularSpeed>(whirl.critical(i, sense, above(like))), why);
  };
  WhirlMode w;
  w.name = names[i];
  w.f_0 = natural("f_0", Sense::forward, 0.0, "K - w^2 M = 0, where it does not turn");
  if (is_set(w.f_0)) like = 2.0 * pi * in_si(w.f_0);
  w.n_F = critical("n_F", Sense::forward, "K - w^2 (M - G) = 0, as fast as it turns");
  w.n_B = critical("n_B", Sense::backward, "K - w^2 (M + G) = 0, as fast as it turns");
  if (!is_set(n)) return w;
  w.f_F = natural("f_F", Sense::forward, in_si(n), "K + w n G - w^2 M = 0");
  w.f_B = natural("f_B", Sense::backward, in_si(n), "K - w n G - w^2 M = 0");
  return w;
}

/// One frequency over the speed, each looked for where the last was.
figure::Curve branch(const beam::Whirl& whirl, std::size_t i, Sense sense, double fastest) {
  constexpr int parts = 16;        // of a curve that bends little
  constexpr double finest = 1e-6;  // more cannot be seen
  figure::Curve curve{std::to_string(i + 1) + (sense == Sense::forward ? " forward" : " backward"), {}, {}};
  double near = unset<double>;
  for (int k = 0; k <= parts; ++k) {
    curve.x.push_back(fastest * k / parts);
    near = whirl.natural(i, sense, curve.x.back(), above(near), finest);
    curve.y.push_back(near / (2.0 * pi));
  }
  return curve;
}

}  // namespace

std::optional<beam::Whirl> whirl_of(const Input& in, const Elastic& elastic) {
  const auto& seats = in.seats;
  const bool known = is_set(in.rho) &&
                     std::all_of(seats.begin(), seats.end(), [](const Seat& s) { return is_set(s.mass); }) &&
                     std::any_of(seats.begin(), seats.end(), [](const Seat& s) { return is_set(s.I_p); });
  if (!known) return std::nullopt;
  return beam::Whirl(elastic.beam, inertias_of(in, elastic));
}

template <class Tracer>
void judge_whirl(const Input& in, const Elastic& elastic, Result& r, Tracer& trace) {
  const auto whirl = whirl_of(in, elastic);
  if (!whirl) return;
  for (std::size_t i = 0; i < in.seats.size(); ++i) {
    [[maybe_unused]] const auto here = trace.scope("seats", i);
    if (is_set(in.seats[i].I_p)) I_d_of(in.seats[i], trace);
  }
  double like = in_si(r.n_c);
  for (std::size_t i = 0; i < static_cast<std::size_t>(in.whirl_modes); ++i) {
    r.whirls.push_back(whirled(i, *whirl, r.n, like, trace));
    like = 2.0 * pi * in_si(r.whirls.back().f_0);
  }
  r.n_F = trace.speed("n_F", r.whirls.front().n_F, "the first with discs that turn: unbalance excites forward whirl");
}

std::optional<figure::Figure> campbell(const Input& in, const Elastic& elastic, const Result& r) {
  constexpr double far_below = 0.5;  // of the first critical speed: no branch comes near the speed
  if (!is_set(r.n) || !is_set(r.n_F) || (in.whirl_modes <= 1 && r.n < far_below * r.n_F)) return std::nullopt;
  const auto whirl = whirl_of(in, elastic);
  if (!whirl) return std::nullopt;
  const double n = in_si(r.n), fastest = 1.25 * std::max(n, in_si(r.n_F));
  double highest = in_si(per_second(fastest));
  figure::Plot plot({"n", "speed of the shaft", "rpm"}, {"f", "frequency of whirl", "Hz"});
  const figure::Curve turning{"once in a turn", {0.0, fastest}, {0.0, highest}};
  for (std::size_t i = 0; i < most_whirls; ++i) {
    const double rest = whirl->natural(i, Sense::forward, 0.0), met = whirl->critical(i, Sense::forward, above(rest));
    if (i > 0 && !(rest < 2.0 * fastest)) break;
    for (const Sense sense : {Sense::forward, Sense::backward}) {
      plot.curves.push_back(branch(*whirl, i, sense, fastest));
      for (const double f : plot.curves.back().y) highest = std::max(highest, f);
    }
    if (met <= fastest) plot.marks.push_back({met, in_si(per_second(met)), "critical"});
  }
  plot.curves.push_back(turning);
  plot.curves.push_back({"n", {n, n}, {0.0, highest}});
  return figure::Figure("whirl", "Campbell diagram: whirl frequencies against speed, with the unbalance line",
                        std::move(plot));
}

template void judge_whirl(const Input&, const Elastic&, Result&, NoTrace&);
template void judge_whirl(const Input&, const Elastic&, Result&, Trace&);

}  // namespace loadpath::shaft
