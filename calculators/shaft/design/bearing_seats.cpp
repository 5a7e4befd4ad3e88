#include "calculators/shaft/design/bearing_seats.hpp"

#include "calculators/shaft/design/model/places.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace loadpath::shaft {

namespace {

/// An end of the cylinder under a bearing, and the diameter behind it; 0 at the end of the shaft.
struct End {
  Length x, d;
};

/// Segments of one diameter in a row are one cylinder.
std::array<End, 2> ends_of_cylinder(const DesignInput& in, std::size_t piece) {
  const Length d = in.pieces[piece].d;
  std::size_t first = piece, last = piece;
  while (first > 0 && thinnest(in.pieces[first - 1]) == d && thickest(in.pieces[first - 1]) == d) --first;
  while (last + 1 < in.pieces.size() && thinnest(in.pieces[last + 1]) == d && thickest(in.pieces[last + 1]) == d)
    ++last;
  const Length none = 0.0 * mm;
  return {End{start_of(in, first), first > 0 ? right_diameter(in.pieces[first - 1]) : none},
          End{start_of(in, last) + in.pieces[last].l, last + 1 < in.pieces.size() ? in.pieces[last + 1].d : none}};
}

Length fillet_at(const DesignInput& in, Length x) {
  const auto found = std::find_if(in.notches.begin(), in.notches.end(), [&](const Notched& notch) {
    return notch.kind == Notch::shoulder && are_one(in, notch.x, x);
  });
  return found == in.notches.end() ? unset<Length> : found->r;
}

}  // namespace

BearingSeat bearing_seat(const DesignInput& in, const Support& support) {
  BearingSeat seat;
  const std::size_t piece = index_of_piece(in, support.x);
  if (support.on == On::taper || is_taper(in.pieces[piece])) return seat;
  seat.d = in.pieces[piece].d;
  const auto [left, right] = ends_of_cylinder(in, piece);
  const Length to_left = support.x - left.x, to_right = right.x - support.x;
  if (!are_one(in, support.x, 0.0 * mm) && !are_one(in, support.x, length_of(in)))
    seat.l = 2.0 * min(to_left, to_right);
  const bool rises_left = left.d > seat.d, rises_right = right.d > seat.d;
  if (!rises_left && !rises_right) return seat;
  const End& shoulder = rises_left && (!rises_right || to_left < to_right) ? left : right;
  seat.r_f = fillet_at(in, shoulder.x), seat.d_f = shoulder.d;
  return seat;
}

}  // namespace loadpath::shaft
