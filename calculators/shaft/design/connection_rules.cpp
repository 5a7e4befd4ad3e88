// What shaft.design asks of connections, and which modes of failure they bring.
#include "calculators/shaft/design/connections.hpp"
#include "calculators/shaft/design/design.hpp"
#include "calculators/shaft/design/model/places.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>

namespace loadpath::shaft {

namespace {

using Input = Design::Input;

/// Of what is slid onto the shaft the forces act outside of it.
bool is_around(const Input& in, const Seat& seat) {
  const bool is_known = is_set(seat.d_w) && seat.d_w > 0.0 * mm && seat.integral == Integral::no;
  return !is_known || seat.d_w > diameter_under(in, seat);
}

/// Whether the connection is made for the shaft there. That of a taper is made for a diameter of it.
bool fits(const Input& in, const Seat& seat) {
  if (!is_set(seat.d_c) || is_taper(piece_at(in, seat.x))) return true;
  const Length own = diameter_under(in, seat);
  return abs(seat.d_c - own) <= one_place * own;
}

template <class Meant>
Applies where_any(const Input& in, const Meant& is_meant) {
  for (std::size_t i = 0; i < in.seats.size(); ++i) {
    if (is_meant(i)) return Applies::yes;
  }
  return Applies::no;
}

}  // namespace

bool Design::connections_match(const Input& in) {
  return std::all_of(in.seats.begin(), in.seats.end(),
                     [&](const Seat& seat) { return is_around(in, seat) && fits(in, seat); });
}

FieldFault Design::other_diameter(const Input& in) {
  for (std::size_t i = 0; i < in.seats.size(); ++i) {
    const Seat& seat = in.seats[i];
    const auto told = [](Length d) { return format_quantity(in_si(d), mm.symbol); };
    if (!is_around(in, seat)) {
      return {place_of("seats", in.seats, i, "d_w"),
              say("its forces act at a diameter of {1}, and the shaft has {2} there", told(seat.d_w),
                  told(diameter_under(in, seat))),
              say("what is one piece with the shaft is integral = true")};
    }
    if (fits(in, seat)) continue;
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

}  // namespace loadpath::shaft
