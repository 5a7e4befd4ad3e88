#include "calculators/shaft/design/connections.hpp"

#include "calculators/shaft/design/turn.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::shaft {

namespace {

using Input = Design::Input;

/// Whether a torque, if any position has one, is more than what the others leave by rounding.
bool turns_something(const Input& in, std::size_t seat) {
  for (std::size_t i = 0; i < positions_of(in); ++i) {
    if (std::abs(in_si(torque_of(in, seat, i))) > 1e-9) return true;
  }
  return false;
}

/// The thinner of two pieces that meet under a seat, and of a taper what its middle has.
Length diameter_under(const Input& in, const Seat& seat) { return around(in, seat.x).sides.thinner().d; }

bool fits(const Input& in, const Seat& seat) {
  if (!is_set(seat.d_c) || is_taper(piece_at(in, seat.x))) return true;
  const Length own = diameter_under(in, seat);
  return abs(seat.d_c - own) <= one_place * own;
}

bool has_rim(const Seat& seat) { return is_set(seat.d_f) && is_set(seat.h_t) && seat.integral == Integral::no; }

template <class Meant>
Applies where_any(const Input& in, const Meant& is_meant) {
  for (std::size_t i = 0; i < in.seats.size(); ++i) {
    if (is_meant(i)) return Applies::yes;
  }
  return Applies::no;
}

/// Whether torque passes between the shaft and what sits there, and they are two pieces.
bool needs_connection(const Input& in, std::size_t seat) {
  return in.seats[seat].integral == Integral::no && turns_something(in, seat);
}

}  // namespace

bool Design::connections_match(const Input& in) {
  return std::all_of(in.seats.begin(), in.seats.end(), [&](const Seat& seat) { return fits(in, seat); });
}

FieldFault Design::other_diameter(const Input& in) {
  for (std::size_t i = 0; i < in.seats.size(); ++i) {
    const Seat& seat = in.seats[i];
    if (fits(in, seat)) continue;
    const auto told = [](Length d) { return format_quantity(in_si(d), mm.symbol); };
    return {place_of("seats", in.seats, i, "d_c"),
            say("its connection is made for a shaft of {1}, and the shaft has {2} there", told(seat.d_c),
                told(diameter_under(in, seat))),
            say("give both the same diameter")};
  }
  return {};
}

Applies Design::lacks_connection(const Input& in) {
  return where_any(in, [&](std::size_t i) { return needs_connection(in, i) && !is_set(in.seats[i].T_c); });
}

Applies Design::has_connection(const Input& in) {
  return where_any(in, [&](std::size_t i) { return needs_connection(in, i) && is_set(in.seats[i].T_c); });
}

Applies Design::bears_rims(const Input& in) {
  return where_any(in, [&](std::size_t i) { return has_rim(in.seats[i]); });
}

template <class Tracer>
void judge_connections(const Input& in, Design::Result& r, Tracer& trace) {
  for (std::size_t i = 0; i < in.seats.size(); ++i) {
    const Seat& seat = in.seats[i];
    Seated& s = r.seats[i];
    [[maybe_unused]] const auto here = trace.scope("seats", i);
    if (is_set(seat.T_c) && needs_connection(in, i)) {
      const Moment T = s.T, T_c = trace.value("T_c", seat.T_c, "torque that the connection is assessed for");
      STEP_TO(s, x_c, abs(T) / T_c, "the connection is assessed for no less");
    }
    if (!has_rim(seat)) continue;
    const Length d = trace.value("d", diameter_under(in, seat), "of the shaft under the gear");
    const Length t_c = trace.value("t_c", is_set(seat.t_c) ? seat.t_c : 0.0 * mm, "depth of the keyway in the gear");
    const Length d_f = trace.value("d_f", seat.d_f, "root circle"), h_t = trace.value("h_t", seat.h_t, "tooth height");
    STEP_TO(s, m_R, ((d_f - d) / 2.0 - t_c) / h_t, "rim over the height of a tooth, as of gear.pair");
  }
}

template void judge_connections(const Input&, Design::Result&, NoTrace&);
template void judge_connections(const Input&, Design::Result&, Trace&);

}  // namespace loadpath::shaft
