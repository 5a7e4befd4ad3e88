// Places along a shaft, and how messages name them.
#pragma once

#include "calculators/shaft/design/model/shape.hpp"
#include "lib/quantity/format.hpp"

#include <cstddef>
#include <string>

namespace loadpath::shaft {

inline constexpr double one_place = 1e-6;  // share of the length: closer places count as one

inline bool are_one(const DesignInput& in, Length a, Length b) { return abs(a - b) <= one_place * length_of(in); }

/// Beyond the end of the shaft.
inline bool is_off(const DesignInput& in, Length x) { return !(x <= (1.0 + one_place) * length_of(in)); }

inline bool is_on(const DesignInput& in, Length x) { return x >= 0.0 * mm && !is_off(in, x); }

/// "seats.gear.x", "seats[2].x".
template <class Elements>
std::string place_of(const char* list, const Elements& all, std::size_t i, const char* key) {
  const Name& name = all[i].name;
  return name.empty() ? std::string(list) + "[" + std::to_string(i + 1) + "]." + key
                      : std::string(list) + "." + std::string(name.view()) + "." + key;
}

/// A place where two pieces meet.
struct Meeting {
  Length x;
  const Piece& before;
  const Piece& after;
  [[nodiscard]] Sides sides() const { return {{right_diameter(before), before.d_bore}, {after.d, after.d_bore}}; }
  [[nodiscard]] bool steps() const { return right_diameter(before) != after.d || before.d_bore != after.d_bore; }
  /// Whether the surface has a hollow edge there: how much steeper it is behind the place than before it. Slopes
  /// below 1 : 50 on the diameter are neglected: at a hollow edge stresses grow with the power 0.57 times the angle
  /// of the distance, where a root is d/1000 round by 4 %.
  [[nodiscard]] bool is_hollow() const {
    constexpr double flat = 0.01;
    return !steps() && slope_of(after) - slope_of(before) > flat;
  }
};

/// The ends of the pieces within the shaft, until a call is true.
template <class Found>
bool find_meeting(const DesignInput& in, const Found& found) {
  Length x = 0.0 * mm;
  for (std::size_t i = 0; i + 1 < in.pieces.size(); ++i) {
    x += in.pieces[i].l;
    if (found(Meeting{x, in.pieces[i], in.pieces[i + 1]})) return true;
  }
  return false;
}

inline const Piece& piece_at(const DesignInput& in, Length x) { return in.pieces[index_of_piece(in, x)]; }

/// The pieces on the two sides of a place, the same within one.
struct Around {
  const Piece& before;
  const Piece& after;
  Sides sides;
};
inline Around around(const DesignInput& in, Length x) {
  const Length aside = 10.0 * one_place * length_of(in);
  const std::size_t left = index_of_piece(in, x - aside), right = index_of_piece(in, x + aside);
  const auto ring = [&](std::size_t i) { return ring_at(in.pieces[i], x - start_of(in, i)); };
  return {in.pieces[left], in.pieces[right], {ring(left), ring(right)}};
}

/// The other end of a key: on the side where a seat lies over it, of two the one whose seat it has more in its middle.
/// Unset where it has no length, or no seat.
inline Length other_end(const DesignInput& in, const Notched& notch) {
  if (!is_keyed(notch.kind) || !is_set(notch.l)) return unset<Length>;
  Length found = unset<Length>, nearest = unset<Length>;
  for (const Length& end : {notch.x - notch.l, notch.x + notch.l}) {
    const Length middle = (notch.x + end) / 2.0;
    for (const Seat& seat : in.seats) {
      const Length apart = abs(seat.x - middle);
      if (apart > notch.l / 2.0 + one_place * length_of(in) || apart >= nearest) continue;
      found = end, nearest = apart;
    }
  }
  return found;
}

/// Whether there is a bore on either side.
inline bool is_bored(const DesignInput& in, Length x) {
  const Sides sides = around(in, x).sides;
  return max(sides.left.d_bore, sides.right.d_bore) > 0.0 * mm;
}

inline std::string format(Length x) { return format_quantity(in_si(x), mm.symbol); }

}  // namespace loadpath::shaft
