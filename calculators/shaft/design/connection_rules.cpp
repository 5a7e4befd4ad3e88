// Rules of shaft.design for connections, and the failure modes that they bring.
#include "calculators/shaft/design/connections.hpp"
#include "calculators/shaft/design/design.hpp"
#include "calculators/shaft/design/model/places.hpp"
#include "calculators/shaft/design/model/positions.hpp"
#include "calculators/shaft/parts/notch_factors.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace loadpath::shaft {

namespace {

using Input = Design::Input;

/// Whether the component is slid onto the shaft, so that its forces act outside of it.
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

/// Contradiction of a connection at its mounted component: its key and reason; empty if none.
struct Contradiction {
  const char* key = "";
  Message message = {};
};

Contradiction other_bore(const Input& in, const Seat& seat) {
  if (!is_set(seat.b_c)) return {};
  const Length own = around(in, seat.x).sides.thinner().d_bore;
  if (abs(seat.b_c - own) <= one_place * diameter_under(in, seat)) return {};
  return {"b_c", say("its connection is calculated for a shaft with a bore of {1}, and the shaft has one of {2} there",
                     format_quantity(in_si(seat.b_c), mm.symbol), format_quantity(in_si(own), mm.symbol))};
}

/// A key, a spline, an interference fit lies on one diameter of the shaft, and outside its bearings.
Contradiction no_room(const Input& in, const Seat& seat) {
  if (!is_set(seat.l_c) || is_taper(piece_at(in, seat.x))) return {};
  const Length slack = one_place * length_of(in), left = seat.x - seat.l_c / 2.0, right = seat.x + seat.l_c / 2.0;
  const auto text_of = [](Length x) { return format_quantity(in_si(x), mm.symbol, 5); };
  const std::string name = seat.name.empty() ? "a component" : "'" + std::string(seat.name.view()) + "'";
  const std::string range = text_of(left) + " to " + text_of(right);
  if (left < -slack || right > length_of(in) + slack)
    return {"l_c", say("the connection of {1}, {2}, reaches beyond the end of the shaft", name, range)};
  const Length own = diameter_under(in, seat);
  for (const Length& end : {left + 20.0 * slack, right - 20.0 * slack}) {
    if (abs(around(in, end).sides.thinner().d - own) > one_place * own)
      return {"l_c", say("the connection of {1}, {2}, reaches beyond its segment of the shaft", name, range)};
  }
  const auto covers = [&](const Support& support) { return support.x > left + slack && support.x < right - slack; };
  const auto covered = std::find_if(in.supports.begin(), in.supports.end(), covers);
  if (covered != in.supports.end())
    return {"l_c", say("the connection of {1}, {2}, overlaps the bearing at {3}", name, range, text_of(covered->x))};
  return {};
}

Contradiction other_sense(const Input& in, const Seat& seat) {
  constexpr double ripple = 0.05;
  if (!is_set(seat.r_c) || !is_set(in.r_T) || in.r_T >= seat.r_c - ripple) return {};
  return {"r_c", say("its connection is assessed for a torque of r = {1} at least, and the shaft has r_T = {2}",
                     format_number(seat.r_c, 3), format_number(in.r_T, 3))};
}

/// Steels yield below their tensile strength; that of the shaft depends on the diameter of each segment.
Contradiction other_strength(const Input& in, const Seat& seat) {
  if (!is_set(seat.R_c) || !is_set(in.R_m) || seat.R_c <= in.R_m) return {};
  const auto text_of = [](Stress R) { return format_quantity(in_si(R), MPa.symbol); };
  return {"R_c", say("its connection is calculated with a shaft of R_e = {1}, and the shaft has R_m = {2}",
                     text_of(seat.R_c), text_of(in.R_m))};
}

/// A component that is one piece with the shaft has no bore and no connection, and its teeth lie outside the shaft.
Contradiction two_pieces(const Input& in, const Seat& seat) {
  if (seat.integral == Integral::no) return {};
  const Length d = diameter_under(in, seat);
  if (is_set(seat.d_f) && d > seat.d_f * (1.0 + 1e-6))
    return {
        "d_f",
        say("the root diameter {1} of the teeth lies inside the shaft, whose segment there has {2}: give the segment "
            "under the teeth their root diameter",
            format_quantity(in_si(seat.d_f), mm.symbol, 5), format_quantity(in_si(d), mm.symbol, 5))};
  if (is_set(seat.bore))
    return {"bore", say("a bore of {1} contradicts integral = true (one piece with the shaft)",
                        format_quantity(in_si(seat.bore), mm.symbol))};
  if (is_set(seat.T_c)) return {"T_c", say("a connection contradicts integral = true (one piece with the shaft)")};
  return {};
}

/// The bore matches the shaft, and hub and keyway lie within the root circle.
Contradiction other_hub(const Input& in, const Seat& seat) {
  const auto text_of = [](Length d) { return format_quantity(in_si(d), mm.symbol); };
  const Length d = diameter_under(in, seat), cut = is_set(seat.t_c) ? seat.t_c : 0.0 * mm;
  const bool is_splined = seat.fastening == Fastening::spline;
  if (!is_splined && !is_taper(piece_at(in, seat.x)) && !bore_fits(seat.bore, d))
    return {"bore", say("its bore is {1}, but the shaft diameter there is {2}", text_of(seat.bore), text_of(d))};
  if (is_set(seat.d_f) && seat.d_f <= d + 2.0 * cut)
    return {"d_f",
            say("shaft diameter {1} and keyway of the hub reach the root diameter {2}", text_of(d), text_of(seat.d_f))};
  if (seat.D_c > 1.000001 * seat.d_f)
    return {"D_c", say("its connection is calculated with a hub diameter of {1}, but the root diameter is {2}",
                       text_of(seat.D_c), text_of(seat.d_f))};
  return {};
}

Contradiction inconsistency_of(const Input& in, std::size_t i) {
  const Seat& seat = in.seats[i];
  if (const Contradiction misfit = two_pieces(in, seat); *misfit.key != '\0') return misfit;
  if (seat.integral == Integral::no) {
    if (const Contradiction misfit = other_hub(in, seat); *misfit.key != '\0') return misfit;
  }
  if (!needs_connection(in, i)) return {};
  for (const Contradiction& misfit :
       {other_bore(in, seat), no_room(in, seat), other_sense(in, seat), other_strength(in, seat)}) {
    if (*misfit.key != '\0') return misfit;
  }
  return {};
}

/// Whether this type of connection makes such a notch, or its factors are typed.
bool is_made_by(Fastening fastening, Notch kind) {
  if (kind == Notch::given || kind == Notch::beta) return true;
  switch (fastening) {
    case Fastening::key:
      return is_keyed(kind);
    case Fastening::two_keys:
      return kind == Notch::two_keyways;
    case Fastening::spline:
      return false;
    case Fastening::press_fit:
      return kind == Notch::press_fit;
    case Fastening::pin:
      return kind == Notch::cross_hole;
    default:
      return is_keyed(kind) || kind == Notch::press_fit || kind == Notch::cross_hole;
  }
}

/// Whether a notch lies under the hub, or as far outside of it as a keyway runs out: a fifth of the diameter.
bool is_under(const Notched& notch, const Seat& seat) {
  const Length run_out = is_set(seat.d_c) ? 0.2 * seat.d_c : 0.0 * mm;
  const bool has_width = is_set(seat.b) && seat.b > 0.0 * mm;
  const Length reach = has_width ? seat.b / 2.0 + run_out : is_set(seat.l_c) ? seat.l_c : seat.d_c;
  return abs(notch.x - seat.x) <= reach * (1.0 + one_place);
}

/// Whether a notch of a connection lies under the hub.
bool has_notch(const Input& in, const Seat& seat) {
  return std::any_of(in.notches.begin(), in.notches.end(), [&](const Notched& notch) {
    return is_made_by(seat.fastening, notch.kind) && is_under(notch, seat);
  });
}

/// Whether typed notch factors under a hub are lower than those of its connection.
bool is_too_mild(const Input& in, const Notched& notch, const Seat& seat) {
  const bool is_typed = notch.kind == Notch::given || notch.kind == Notch::beta;
  const Sides sides = around(in, notch.x).sides;
  const bool at_step = sides.left.d != sides.right.d;  // bounded by its fillet
  if (!is_typed || at_step || !is_set(in.R_m) || !is_under(notch, seat)) return false;
  const NotchFactors least = least_factors(seat.fastening, in.R_m);
  const bool is_beta = notch.kind == Notch::beta;
  return (is_beta ? notch.beta_b : notch.K_t) < least.bending || (is_beta ? notch.beta_t : notch.K_ts) < least.torsion;
}

Length width_of(const Seat& seat) { return is_set(seat.b) && seat.b > 0.0 * mm ? seat.b : seat.b_r; }

/// A keyway that is short enough for its hub, but reaches beyond it; null if there is none.
struct Outside {
  const Notched* notch = nullptr;
  const Seat* seat = nullptr;
  Length from = unset<Length>, to = unset<Length>;
};
Outside keyway_outside(const Input& in) {
  const Length slack = one_place * length_of(in);
  for (const Notched& notch : in.notches) {
    const Length end = other_end(in, notch);
    if (!is_set(end)) continue;
    const Length from = min(notch.x, end), to = max(notch.x, end), middle = (from + to) / 2.0;
    const auto apart = [&](const Seat& seat) { return abs(seat.x - middle); };
    const auto hub = std::min_element(in.seats.begin(), in.seats.end(),
                                      [&](const Seat& a, const Seat& b) { return apart(a) < apart(b); });
    const bool is_keyed_hub = needs_connection(in, static_cast<std::size_t>(hub - in.seats.begin())) &&
                              is_made_by(hub->fastening, notch.kind);
    if (!is_keyed_hub || !(notch.l <= width_of(*hub) + slack)) continue;
    if (apart(*hub) > (width_of(*hub) - notch.l) / 2.0 + slack) return {&notch, &*hub, from, to};
  }
  return {};
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
  for (std::size_t i = 0; i < in.seats.size(); ++i) {
    const Seat& seat = in.seats[i];
    if (!is_around(in, seat) || !fits(in, seat) || *inconsistency_of(in, i).key != '\0') return false;
  }
  return true;
}

FieldFault Design::other_diameter(const Input& in) {
  for (std::size_t i = 0; i < in.seats.size(); ++i) {
    const Seat& seat = in.seats[i];
    const auto text_of = [](Length d) { return format_quantity(in_si(d), mm.symbol); };
    if (!is_around(in, seat)) {
      return {place_of("seats", in.seats, i, "d_w"),
              say("its forces act at a diameter of {1}, and the shaft has {2} there", text_of(seat.d_w),
                  text_of(diameter_under(in, seat))),
              say("a component integral with the shaft needs integral = true")};
    }
    if (const Contradiction misfit = inconsistency_of(in, i); fits(in, seat) && *misfit.key != '\0')
      return {place_of("seats", in.seats, i, misfit.key), misfit.message, {}};
    if (fits(in, seat)) continue;
    return {place_of("seats", in.seats, i, "d_c"),
            say("its connection is made for a shaft of {1}, and the shaft has {2} there", text_of(seat.d_c),
                text_of(diameter_under(in, seat))),
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

Applies Design::pushes_hubs(const Input& in) {
  return where_any(in, [&](std::size_t i) {
    const Seat& seat = in.seats[i];
    double most = 0.0;
    for (std::size_t k = 0; k < positions_of(in); ++k) most = std::max(most, std::abs(in_si(seat.F_z.at(k))));
    return most > 0.0 && is_set(seat.F_c) && needs_connection(in, i) && in_si(seat.F_c) < in.K_A * most * (1.0 - 1e-6);
  });
}

/// A connection given as a record: if fatigue is assessed, its end is a notch.
Applies Design::lacks_notch(const Input& in) {
  if (!asks_fatigue(in)) return Applies::no;
  return where_any(in, [&](std::size_t i) {
    return needs_connection(in, i) && is_set(in.seats[i].d_c) && !has_notch(in, in.seats[i]);
  });
}

Applies Design::has_mild_notch(const Input& in) {
  if (!asks_fatigue(in)) return Applies::no;
  return where_any(in, [&](std::size_t i) {
    return needs_connection(in, i) && std::any_of(in.notches.begin(), in.notches.end(), [&](const Notched& notch) {
             return is_too_mild(in, notch, in.seats[i]);
           });
  });
}

/// A connection longer than its hub, or a keyway beyond it.
Applies Design::has_long_hub(const Input& in) {
  if (!keyways_in_hubs(in)) return Applies::yes;
  return where_any(in, [&](std::size_t i) {
    const Seat& seat = in.seats[i];
    return needs_connection(in, i) && is_set(seat.l_c) && seat.l_c > 1.000001 * width_of(seat);
  });
}

bool Design::keyways_in_hubs(const Input& in) { return keyway_outside(in).notch == nullptr; }

FieldFault Design::keyway_beyond_hub(const Input& in) {
  const Outside outside = keyway_outside(in);
  if (outside.notch == nullptr) return {};
  const Seat& hub = *outside.seat;
  const Length half = width_of(hub) / 2.0;
  const auto i = static_cast<std::size_t>(outside.notch - in.notches.data());
  return {place_of("notches", in.notches, i, "x"),
          say("the keyway from {1} to {2} reaches beyond {3}, from {4} to {5}", format(outside.from),
              format(outside.to), hub.name.empty() ? "its hub" : "the hub '" + std::string(hub.name.view()) + "'",
              format(hub.x - half), format(hub.x + half)),
          say("correct x of the notch, x or b of the component, or confirm a hub that is longer on this side: "
              "accept.hub_length = \"...\"")};
}

/// Pulleys and sprockets are rarely made in one piece with the shaft.
Applies Design::has_turned_pulley(const Input& in) {
  return where_any(in, [&](std::size_t i) {
    const Seat& seat = in.seats[i];
    return seat.integral == Integral::yes && (seat.kind == Mounted::pulley || seat.kind == Mounted::sprocket);
  });
}

Applies Design::has_fast_fit(const Input& in) {
  return where_any(
      in, [&](std::size_t i) { return needs_connection(in, i) && is_set(in.seats[i].n_c) && is_set(speed_of(in)); });
}

Applies Design::bears_rims(const Input& in) {
  return where_any(in, [&](std::size_t i) { return has_rim(in.seats[i]); });
}

}  // namespace loadpath::shaft
