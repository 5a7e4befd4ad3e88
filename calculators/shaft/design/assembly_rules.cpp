// Clearance between the components of a shaft, and their assembly over its diameters.
#include "calculators/shaft/design/connections.hpp"
#include "calculators/shaft/design/design.hpp"
#include "calculators/shaft/design/model/places.hpp"

#include <algorithm>

namespace loadpath::shaft {

namespace {

using Input = Design::Input;

/// Along the shaft; without width for a body whose width is unknown. A rim may be wider than its hub.
struct Extent {
  Length from, to;
};
Extent extent_of(const Seat& seat) {
  const Length hub = is_set(seat.b) ? seat.b : 0.0 * mm, rim = is_set(seat.b_r) ? seat.b_r : 0.0 * mm;
  const Length width = max(hub, rim);
  return {seat.x - width / 2.0, seat.x + width / 2.0};
}

bool overlap(const Input& in, const Extent& a, const Extent& b) {
  const Length tolerance = one_place * length_of(in);
  return a.from < a.to && b.from < b.to && std::min(a.to, b.to) - std::max(a.from, b.from) > tolerance;
}

/// A bearing with the narrowest ring that is made for its seat: a bore of 35 mm has 7 mm at least, one of 200 mm 24 mm.
Extent extent_of(const Input& in, const Support& support) {
  const Length d = diameter_under(in, support.x);
  const Length half = max(0.06 * d, min(0.1 * d, 3.5 * mm));
  return {support.x - half, support.x + half};
}

/// The room that a bearing takes from its neighbours: its ring with cover or spacer, or a narrow one of thin section.
Extent room_of(const Input& in, const Support& support) {
  const Length half = 0.15 * diameter_under(in, support.x);
  return {support.x - half, support.x + half};
}

/// Whether a bore of the diameter at x passes over all pieces up to one end of the shaft.
bool can_be_slid_on(const Input& in, Length x) {
  const Length bore = (1.0 + one_place) * diameter_under(in, x);
  const std::size_t own = index_of_piece(in, x);
  const auto passes = [&](std::size_t first, std::size_t last) {
    return std::all_of(in.pieces.begin() + static_cast<std::ptrdiff_t>(first),
                       in.pieces.begin() + static_cast<std::ptrdiff_t>(last),
                       [&](const Piece& piece) { return std::max(piece.d, right_diameter(piece)) <= bore; });
  };
  return passes(0, own) || passes(own + 1, in.pieces.size());
}

/// Whether a bearing sits on the fillet of a shoulder, which runs out on the thinner piece.
bool is_in_fillet(const Input& in, const Support& support) {
  return std::any_of(in.notches.begin(), in.notches.end(), [&](const Notched& notch) {
    if (notch.kind != Notch::shoulder || !is_set(notch.r)) return false;
    const Sides sides = around(in, notch.x).sides;
    const bool from_left = sides.left.d < sides.right.d;
    const Extent fillet = from_left ? Extent{notch.x - notch.r, notch.x} : Extent{notch.x, notch.x + notch.r};
    return sides.left.d != sides.right.d && overlap(in, extent_of(in, support), fillet);
  });
}

/// Whether a bearing protrudes from its end of the shaft.
bool overhangs(const Input& in, const Support& support) {
  const Extent ring = extent_of(in, support);
  const Length tolerance = one_place * length_of(in);
  return ring.from < -tolerance || ring.to > length_of(in) + tolerance;
}

/// The two meshes of an idler: a seat for each load, at one place, of gears with one root circle and tooth depth.
bool is_one_gear(const Input& in, const Seat& a, const Seat& b) {
  const auto equal = [&](Length one, Length other) { return abs(one - other) <= one_place * length_of(in); };
  return a.kind == Mounted::gear && b.kind == Mounted::gear && equal(a.x, b.x) && equal(a.d_f, b.d_f) &&
         equal(a.h_t, b.h_t);
}

bool bodies_overlap(const Input& in) {
  for (std::size_t i = 0; i < in.seats.size(); ++i) {
    const Extent extent = extent_of(in.seats[i]);
    for (std::size_t j = 0; j < i; ++j) {
      if (!is_one_gear(in, in.seats[i], in.seats[j]) && overlap(in, extent, extent_of(in.seats[j]))) return true;
    }
    for (const Support& support : in.supports) {
      if (overlap(in, extent, room_of(in, support))) return true;
    }
  }
  return false;
}

/// A component that is one piece with the shaft ends where the shaft does.
bool integral_one_overhangs(const Input& in) {
  const Extent shaft{0.0 * mm, length_of(in)};
  return std::any_of(in.seats.begin(), in.seats.end(), [&](const Seat& seat) {
    const Extent extent = extent_of(seat);
    const Length tolerance = one_place * shaft.to;
    return seat.integral == Integral::yes && (extent.from < -tolerance || extent.to > shaft.to + tolerance);
  });
}

/// Whether a body reaches beyond the piece at x over another one that stops it.
template <class Stops>
bool reaches(const Input& in, const Extent& body, Length x, const Stops& stops) {
  const std::size_t own = index_of_piece(in, x);
  Extent piece{0.0 * mm, 0.0 * mm};
  for (std::size_t i = 0; i < in.pieces.size(); ++i) {
    piece = {piece.to, piece.to + in.pieces[i].l};
    if (i != own && stops(in.pieces[i]) && overlap(in, body, piece)) return true;
  }
  return false;
}

/// Whether the hub is wider than its piece leaves room for, and would reach over the shoulder of a thicker one.
bool hub_meets_shoulder(const Input& in, const Seat& seat) {
  if (seat.integral == Integral::yes || !is_set(seat.b)) return false;
  const Length bore = (1.0 + one_place) * diameter_under(in, seat.x);
  return reaches(in, {seat.x - seat.b / 2.0, seat.x + seat.b / 2.0}, seat.x,
                 [&](const Piece& piece) { return std::min(piece.d, right_diameter(piece)) > bore; });
}

/// Teeth cut into a shaft end with their piece: a pinion that reaches over a thicker or a thinner one has another shape
/// than the shaft that is assessed.
bool integral_one_leaves_piece(const Input& in, const Seat& seat) {
  if (seat.integral == Integral::no) return false;
  const Length d = diameter_under(in, seat.x);
  const auto differs = [&](const Piece& piece) {
    return abs(piece.d - d) > one_place * d || abs(right_diameter(piece) - d) > one_place * d;
  };
  return reaches(in, extent_of(seat), seat.x, differs);
}

}  // namespace

Applies Design::cannot_be_assembled(const Input& in) {
  const auto is_mounted = [&](const Support& support) { return can_be_slid_on(in, support.x); };
  const auto fits = [&](const Seat& seat) {
    return (seat.integral == Integral::yes || can_be_slid_on(in, seat.x)) && !hub_meets_shoulder(in, seat) &&
           !integral_one_leaves_piece(in, seat);
  };
  const bool is_misplaced = std::any_of(in.supports.begin(), in.supports.end(), [&](const Support& support) {
    return is_in_fillet(in, support) || overhangs(in, support);
  });
  const bool can_be = !bodies_overlap(in) && !integral_one_overhangs(in) && !is_misplaced &&
                      std::all_of(in.supports.begin(), in.supports.end(), is_mounted) &&
                      std::all_of(in.seats.begin(), in.seats.end(), fits);
  return where(!can_be);
}

}  // namespace loadpath::shaft
