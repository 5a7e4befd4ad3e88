#include "calculators/shaft/design/torsion.hpp"

#include "calculators/shaft/design/model/positions.hpp"
#include "calculators/shaft/design/model/turn.hpp"
#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace loadpath::shaft {

namespace {

using Input = DesignInput;
using Result = DesignResult;

/// Ends of pieces and places of discs, each once, from left to right.
using Places = List<double, most_pieces + 1 + most_seats>;
Places places_of(const Input& in) {
  Places all{0.0};
  Length end = 0.0 * mm;
  for (const Piece& piece : in.pieces) all.push_back(in_si(end += piece.l));
  const double finest = 1e-6 * all.back();  // share of the length: closer places are one
  for (const Seat& seat : in.seats) all.push_back(std::min(in_si(seat.x), in_si(end)));
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end(), [&](double a, double b) { return b - a <= finest; }), all.end());
  return all;
}

std::size_t nearest(const Places& places, Length x) {
  const auto away = [&](double place) { return std::abs(place - in_si(x)); };
  const auto found =
      std::min_element(places.begin(), places.end(), [&](double a, double b) { return away(a) < away(b); });
  return static_cast<std::size_t>(found - places.begin());
}

/// How often something comes, against the speeds at which it meets a natural frequency.
template <class Tracer>
Harmonic harmonic_of(const Input& in, const beam::Swing& swing, const Order& order, const Result& r, Tracer& trace) {
  const AngularSpeed n = r.n;
  Harmonic o;
  o.name = order.name, o.h = trace.value("h", order.h, "times in a turn");
  const std::size_t count = std::max<std::size_t>(swing.below(order.h * in_si(n)), 1);  // rigid-body rotation
  const AngularSpeed above = count == 1 ? r.n_T : from_si<AngularSpeed>(swing.natural(count));
  o.n_above = trace.speed("n_above", above / order.h, "next higher natural frequency / h");
  o.n_below = trace.speed("n_below", from_si<AngularSpeed>(swing.natural(count - 1)) / order.h,
                          "the next lower one / h; rigid-body rotation is at 0");
  STEP(q_above, o.n_above / n, "ratio of the next higher critical speed to n");
  if (count < 2) {
    STEP_TO(o, u_h, in.k_n / q_above, "below the lowest natural frequency, with its margin");
    return o;
  }
  STEP(q_below, n / o.n_below, "ratio of n to the next lower critical speed");
  STEP_TO(o, u_h, in.k_n / min(q_above, q_below), "between two natural frequencies, with its margin from both");
  return o;
}

/// The largest amplitude with which the torque of a seat varies k times over all positions.
double swing_of_torque(const Input& in, std::size_t k) {
  const std::size_t n = positions_of(in);
  double largest = 0.0;
  for (std::size_t seat = 0; seat < in.seats.size(); ++seat) {
    std::complex<double> sum = 0.0;
    for (std::size_t i = 0; i < n; ++i)
      sum += in_si(torque_of(in, seat, i)) *
             std::polar(1.0, -2.0 * pi * static_cast<double>(k) * static_cast<double>(i) / static_cast<double>(n));
    largest = std::max(largest, 2.0 / static_cast<double>(n) * std::abs(sum));
  }
  return largest;
}

double largest_torque(const Input& in) {
  double largest = 0.0;
  for (std::size_t i = 0; i < positions_of(in); ++i) {
    for (std::size_t seat = 0; seat < in.seats.size(); ++seat)
      largest = std::max(largest, std::abs(in_si(torque_of(in, seat, i))));
  }
  return largest;
}

constexpr std::array<const char*, most_orders> harmonic_names{"torque_1", "torque_2",  "torque_3",  "torque_4",
                                                              "torque_5", "torque_6",  "torque_7",  "torque_8",
                                                              "torque_9", "torque_10", "torque_11", "torque_12"};

/// Orders of the varying torque: its harmonics of 1 % of the largest torque and more.
template <class Judge>
void for_each_harmonic(const Input& in, const Judge& judge) {
  constexpr double noticeable = 0.01;
  const double turns = std::abs(turns_of(in));
  if (!torque_varies(in) || turns == 0.0) return;
  const double least = noticeable * largest_torque(in);
  for (std::size_t k = 1; k <= most_orders; ++k) {
    const double h = static_cast<double>(k) / turns;
    if (h != 1.0 && swing_of_torque(in, k) >= least) judge(Order{harmonic_names[k - 1], h});
  }
}

/// All orders, the rotation itself first.
template <class Judge>
void for_each_order(const Input& in, const Judge& judge) {
  judge(Order{"turning", 1.0});
  for (const Order& order : in.orders) judge(order);
  for_each_harmonic(in, judge);
}

}  // namespace

std::optional<beam::Swing> swing_of(const Input& in) {
  const bool known = is_set(in.rho) && is_set(in.G) &&
                     std::all_of(in.seats.begin(), in.seats.end(), [](const Seat& s) { return is_set(s.J); });
  if (!known) return std::nullopt;
  const Places places = places_of(in);
  beam::Swing::Rods rods;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) add_rods(in, places[i], places[i + 1], rods);
  beam::Swing::Discs discs;
  for (const Seat& s : in.seats)
    discs.push_back({nearest(places, s.x), in_si(s.J), is_set(s.k_T) ? in_si(s.k_T) : beam::rigid});
  return beam::Swing(rods, discs);
}

Applies resonance_on_the_way(const Input& in) {
  const AngularSpeed n = speed_of(in);
  if (!is_set(n)) return Applies::no;
  const auto swing = swing_of(in);
  if (!swing) return Applies::unseen;
  bool passes = false;
  for_each_order(in, [&](const Order& order) { passes = passes || swing->below(order.h * in_si(n)) > 1; });
  return where(passes);
}

template <class Tracer>
void judge_torsion(const Input& in, Result& r, Tracer& trace) {
  const auto swing = swing_of(in);
  if (!swing) return;
  r.n_T = trace.speed("n_T", from_si<AngularSpeed>(swing->natural(1)), "Holzer: discs and pieces on free ends");
  if (!is_set(r.n)) return;
  NoTrace quiet;
  for_each_order(in, [&](const Order& order) { r.harmonics.push_back(harmonic_of(in, *swing, order, r, quiet)); });
  const auto worst = std::max_element(r.harmonics.begin(), r.harmonics.end(), [](const Harmonic& a, const Harmonic& b) {
    return numerics::exceeds(b.u_h, a.u_h);
  });
  [[maybe_unused]] const auto here = trace.scope("harmonics", static_cast<std::size_t>(worst - r.harmonics.begin()));
  harmonic_of(in, *swing, {worst->name, worst->h}, r, trace);
}

template void judge_torsion(const Input&, Result&, NoTrace&);
template void judge_torsion(const Input&, Result&, Trace&);

}  // namespace loadpath::shaft
