// Rules of shaft.design for notches: fit at their place, distance, and no step without a notch.
#include "calculators/fatigue/peterson.hpp"
#include "calculators/shaft/design/design.hpp"
#include "calculators/shaft/design/model/places.hpp"
#include "calculators/shaft/design/model/positions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>

namespace loadpath::shaft {

namespace {

using Input = Design::Input;

/// Missing or superfluous fields of a notch; empty if none.
Message fault_of_fields(const Notched& notch) {
  using Kind = Notch;
  const Kind kind = notch.kind;
  const bool rounded = kind == Kind::shoulder || kind == Kind::groove || kind == Kind::rectangular_groove;
  if (rounded && !is_set(notch.r)) return say("this notch needs the radius r of its root");
  if (kind == Kind::cross_hole && !is_set(notch.r)) return say("a cross hole needs its radius r");
  const bool cuts = is_groove(kind) || is_keyed(kind) || kind == Kind::beta;
  if (is_groove(kind) && !is_set(notch.t)) return say("a groove has a depth t");
  if (!cuts && is_set(notch.t)) return say("t is the depth of a groove, a keyway or splines");
  if (is_set(notch.l) && !is_keyed(kind)) return say("l is the length of a key");
  if ((kind == Kind::rectangular_groove) != is_set(notch.w)) return say("only a rectangular groove has a width w");
  if ((kind == Kind::given) != is_set(notch.K_t) || is_set(notch.K_t) != is_set(notch.K_ts))
    return say("K_t and K_ts are given together, only with kind = \"given\"");
  if ((kind == Kind::beta) != is_set(notch.beta_b) || is_set(notch.beta_b) != is_set(notch.beta_t))
    return say("beta_b and beta_t are given together, only with kind = \"beta\"");
  if (is_set(notch.h) && kind != Kind::shoulder) return say("h is the minimum height of a shoulder");
  if (is_keyed(kind) && is_set(notch.r))
    return say("K_t of a keyway is that of r = 0.02 d: leave out r, or give kind = \"given\", K_t and K_ts");
  if (const bool rootless = kind == Kind::v_groove || kind == Kind::press_fit; rootless && is_set(notch.r))
    return say("its notch factor does not depend on a radius: leave out r");
  if (kind == Kind::given && notch.K_t > 1.0 && !is_set(notch.r))
    return say("a given notch needs the radius r of its root, for the notch sensitivity");
  return {};
}

/// Fault of the width of a groove, which lies half on each side of its place; empty if none.
Message fault_of_width(const Input& in, const Notched& notch) {
  if (!is_set(notch.w)) return {};
  if (notch.r > notch.t || notch.r > notch.w / 2.0)
    return say("its root radius exceeds the depth of the groove, or half its width");
  const Length from = notch.x - notch.w / 2.0, to = notch.x + notch.w / 2.0, aside = 10.0 * one_place * length_of(in);
  if (from < 0.0 * mm || is_off(in, to) || index_of_piece(in, from + aside) != index_of_piece(in, to - aside))
    return say("a groove of {1} does not lie within its piece at {2}", format(notch.w), format(notch.x));
  const auto inside = [&](const auto& element) { return element.x > from && element.x < to; };
  if (std::any_of(in.seats.begin(), in.seats.end(), inside) ||
      std::any_of(in.supports.begin(), in.supports.end(), inside))
    return say("a component lies within the groove of {1} at {2}", format(notch.w), format(notch.x));
  return {};
}

/// Fault of the fillet of a shoulder, an arc tangent to the thinner side: a radius above the step height ends in an
/// edge, as in the charts, and leaves no face. Empty if none.
Message fault_of_fillet(const Notched& notch, const Around& there) {
  const Length high = (there.sides.larger() - there.sides.thinner().d) / 2.0, r = notch.r;
  if (is_set(notch.h) && r > high)
    return say("its fillet radius {1} exceeds the step height {2}: no face remains for an abutting part", format(r),
               format(high));
  const Length run = r > high ? sqrt(high * (2.0 * r - high)) : r;
  const Length room = there.sides.left.d < there.sides.right.d ? there.before.l : there.after.l;
  if (run > room) return say("its fillet extends {1} along a segment of {2}", format(run), format(room));
  return {};
}

/// Fault of the nominal diameter of a notch, or of its taper; empty if none. A key on a taper is made for a diameter
/// of it.
Message fault_of_size(const Notched& notch, const Around& there) {
  const bool on_taper = is_taper(there.before) && &there.before == &there.after;
  if (on_taper && notch.kind == Notch::press_fit)
    return say("its notch factor is that of a hub pressed on a cylinder: on a taper give beta_b and beta_t");
  if (!is_set(notch.d)) return {};
  if (on_taper && notch.kind == Notch::keyway) {
    const bool among =
        notch.d >= (1.0 - one_place) * thinnest(there.before) && notch.d <= (1.0 + one_place) * thickest(there.before);
    return among ? Message{}
                 : say("the key is for a shaft of {1}, but the shaft tapers from {2} to {3} at x = {4}",
                       format(notch.d), format(there.before.d), format(right_diameter(there.before)), format(notch.x));
  }
  const Length own = there.sides.right.d;
  if (abs(notch.d - own) <= one_place * own) return {};
  return say("the notch is for a shaft of {1}, but the shaft has {2} at x = {3}", format(notch.d), format(own),
             format(notch.x));
}

/// Minimum stress concentration of a fillet of this radius: the chart, at the nearer end of its range if outside, and
/// nothing below it.
double least_concentration(std::span<const fatigue::Fit> fits, Length h, Length r, Length D) {
  if (h < fits.front().low * r) return 1.0;
  return fatigue::concentration(fits, h, max(r, h / fits.back().high), D).K;
}

/// Fatigue notch factor from K_t; unknown for a metal of unknown strength.
double in_fatigue(const Input& in, double K, Length r, fatigue::Endurance::Loading loading) {
  using fatigue::Endurance;
  if (!is_set(in.R_m) || in.group > Endurance::Group::cast_steel) return 1.0;
  Endurance::Input e;
  e.R_m = in.R_m, e.group = in.group, e.loading = loading, e.rule = Endurance::RuleOf::shigley;
  e.school = Endurance::School::marin, e.K_t = K, e.r_n = r;
  NoTrace quiet;
  return Endurance::evaluate(e, quiet).K_f;
}

/// The least factor of a hollow shaft: a bore takes no stress off the fillet around it, but raises the nominal stress.
double of_hollow(double solid, const Around& there) {
  const double q = max(there.sides.left.d_bore, there.sides.right.d_bore) / there.sides.thinner().d;
  return std::min(solid, std::max(1.0 + 1e-9, (1.0 - q * q * q * q) * solid));
}

/// Fault of typed factors at a change of the outer diameter: no step has less than its fillet makes. Charts and tests
/// differ by a tenth or so.
Message fault_of_typed_step(const Input& in, const Notched& notch, const Around& there) {
  const Length d = there.sides.thinner().d, D = there.sides.larger(), r = notch.r;
  if (d == D) return {};
  if (!is_set(r))
    return say("at {1} the diameter changes from {2} to {3}: give the radius r of its fillet, which bounds the factors",
               format(notch.x), format(d), format(D));
  constexpr double scatter_of_charts = 0.9, scatter_of_tests = 0.85;
  const Length h = (D - d) / 2.0;
  double bending = least_concentration(fatigue::shoulder_in_bending, h, r, D);
  double torsion = least_concentration(fatigue::shoulder_in_torsion, h, r, D);
  const bool tested = notch.kind == Notch::beta;
  if (tested) {
    bending = scatter_of_tests * in_fatigue(in, bending, r, fatigue::Endurance::Loading::bending);
    torsion = scatter_of_tests * in_fatigue(in, torsion, r, fatigue::Endurance::Loading::torsion);
  } else {
    bending *= scatter_of_charts, torsion *= scatter_of_charts;
  }
  if (is_bored(in, notch.x)) bending = of_hollow(bending, there), torsion = of_hollow(torsion, there);
  const double own = tested ? notch.beta_b : notch.K_t, own_t = tested ? notch.beta_t : notch.K_ts;
  const auto too_low = [&](const char* key, double value, double least) {
    return say("{1} = {2} at {3}, where a fillet of {4} from {5} to {6} makes {7} at least", key,
               format_number(value, 3), format(notch.x), format(r), format(d), format(D), format_number(least, 3));
  };
  if (own < bending) return too_low(tested ? "beta_b" : "K_t", own, bending);
  if (own_t < torsion) return too_low(tested ? "beta_t" : "K_ts", own_t, torsion);
  return {};
}

/// Fault of a keyway, or splines, in a hollow shaft; empty if none.
Message fault_of_wall(const Input& in, const Notched& notch, const Around& there) {
  const bool keyed = is_keyed(notch.kind);
  if (!is_bored(in, notch.x) || !(keyed || is_set(notch.t))) return {};
  if (!is_set(notch.t)) return say("in a hollow shaft give the keyway depth t, or part = \"=key.notch\"");
  const Length wall = (there.sides.thinner().d - max(there.sides.left.d_bore, there.sides.right.d_bore)) / 2.0;
  const Length left = keyed ? wall - notch.t : wall;
  if (!(left > 0.0 * mm))
    return say("a keyway of {1} cuts through the wall of {2} at {3}", format(notch.t), format(wall), format(notch.x));
  if (left < notch.t)
    return say(
        "{1} of wall remains under a depth of {2} at {3}: no factor is given for so thin a wall: "
        "give K_t, K_ts and r",
        format(left), format(notch.t), format(notch.x));
  return {};
}

/// Whether any torque runs through the shaft next to a place; without torque none is missed.
bool transmits_torque_at(const Input& in, Length x) {
  bool twisted = false;
  for (std::size_t position = 0; position < positions_of(in); ++position) {
    Moment before = 0.0 * N_m.one, behind = before, most = before;
    for (std::size_t i = 0; i < in.seats.size(); ++i) {
      const Moment T = torque_of(in, i, position);
      most = max(most, abs(T));
      if (in.seats[i].x < x && !are_one(in, in.seats[i].x, x)) before += T;
      if (in.seats[i].x < x || are_one(in, in.seats[i].x, x)) behind += T;
    }
    if (most > 0.0 * N_m.one) twisted = true;
    if (max(abs(before), abs(behind)) > 1e-6 * most) return true;
  }
  return !twisted;
}

/// Fault of the place of a hub's end: fits are up to 1.5 d long, so that their ends are nearer to the middle.
Message fault_of_hub(const Input& in, const Notched& notch, Length d) {
  Length nearest = 1.5 * d;
  bool found = false, twists = false;
  const auto meet = [&](Length x, bool is_twisted) {
    if (abs(x - notch.x) > nearest) return;
    nearest = abs(x - notch.x), found = true, twists = is_twisted;
  };
  for (const Support& support : in.supports) meet(support.x, false);
  for (const Seat& seat : in.seats) meet(seat.x, is_set(seat.T) || seat.way == Way::balances);
  if (!found) return say("no mounted component and no bearing near a hub that ends at {1}", format(notch.x));
  if (twists && !transmits_torque_at(in, notch.x))
    return say("the shaft carries no torque at {1}: the governing end of a hub is the one towards the torque",
               format(notch.x));
  return {};
}

/// A key on either side of its end that lies under no component.
Message fault_of_key_end(const Input& in, const Notched& notch) {
  const auto apart = [&](const Seat& seat) { return abs(seat.x - notch.x); };
  const auto near = std::min_element(in.seats.begin(), in.seats.end(),
                                     [&](const Seat& a, const Seat& b) { return apart(a) < apart(b); });
  return say(
      "no mounted component has a key of {1} that ends at {2}: it lies from {3} to {2} or from {2} to {4}, and the "
      "nearest component is at {5}; correct x of the notch, or the key length",
      format(notch.l), format(notch.x), format(notch.x - notch.l), format(notch.x + notch.l), format(near->x));
}

/// Fault of the place of a key's end, or a hub's; empty if none.
Message fault_of_place(const Input& in, const Notched& notch) {
  if (notch.kind == Notch::press_fit) return fault_of_hub(in, notch, around(in, notch.x).sides.thinner().d);
  if (!is_keyed(notch.kind)) return {};
  if (!is_set(notch.l)) {
    if (transmits_torque_at(in, notch.x)) return {};
    return say(
        "the shaft carries no torque at {1}: the governing end of a key is the one towards the torque; give that, or "
        "the key length l",
        format(notch.x));
  }
  if (in.seats.empty()) return {};  // nothing loads it
  const Length end = other_end(in, notch);
  if (!is_set(end)) return fault_of_key_end(in, notch);
  const Length aside = 10.0 * one_place * length_of(in), low = min(notch.x, end) + aside,
               high = max(notch.x, end) - aside;
  if (low - aside < -one_place * length_of(in) || high + aside > (1.0 + one_place) * length_of(in))
    return say("a key from {1} to {2} reaches beyond the shaft, which ends at 0 mm and {3}", format(min(notch.x, end)),
               format(max(notch.x, end)), format(length_of(in)));
  if (index_of_piece(in, max(low, 0.0 * mm)) != index_of_piece(in, min(high, length_of(in) - aside)))
    return say("a key from {1} to {2} does not lie within one piece", format(min(notch.x, end)),
               format(max(notch.x, end)));
  return {};
}

/// "; it changes at 60 mm, 100 mm"; empty for a shaft of one diameter.
std::string steps_of(const Input& in) {
  std::string all;
  find_meeting(in, [&](const Meeting& m) {
    if (m.steps()) all += (all.empty() ? "; it changes at " : ", ") + format(m.x);
    return false;
  });
  return all;
}

/// Fault of a notch where segments meet: a shoulder is where their diameters differ, others are not.
Message fault_of_meeting(const Input& in, const Notched& notch, const Around& there) {
  const bool typed = notch.kind == Notch::given || notch.kind == Notch::beta;
  const auto here = [&](const Meeting& m) { return are_one(in, m.x, notch.x); };
  const bool at_step = find_meeting(in, [&](const Meeting& m) { return here(m) && m.steps(); });
  const bool at_edge = find_meeting(in, [&](const Meeting& m) { return here(m) && m.is_hollow(); });
  if (notch.kind == Notch::shoulder) {
    if (!at_step || there.sides.left.d == there.sides.right.d)
      return say("the diameter does not change at {1}{2}", format(notch.x), steps_of(in));
    return fault_of_fillet(notch, there);
  }
  if (at_step && !typed)
    return say("at {1} the diameter changes: a notch of both has kind = \"given\", K_t and K_ts", format(notch.x));
  if (at_edge && !typed)
    return say("at {1} a taper begins: a notch of both has kind = \"given\", K_t and K_ts", format(notch.x));
  if (typed && at_step) return fault_of_typed_step(in, notch, there);
  if (notch.kind == Notch::beta && is_set(notch.r))
    return say("its notch factor does not depend on a radius: leave out r");
  return {};
}

/// Fault of a notch at its place; empty if none.
Message fault_of(const Input& in, const Notched& notch) {
  if (Message fault = fault_of_fields(notch); !fault.empty()) return fault;
  const bool typed = notch.kind == Notch::given || notch.kind == Notch::beta;
  const Around there = around(in, notch.x);
  const Length d = there.sides.right.d;
  if (!typed && !is_keyed(notch.kind) && is_bored(in, notch.x))
    return say("the charts are for solid shafts: for a bored one give kind = \"given\", K_t and K_ts");
  if (is_groove(notch.kind) && !(2.0 * notch.t < d)) return say("the groove is deeper than the shaft");
  if (Message fault = fault_of_width(in, notch); !fault.empty()) return fault;
  if (notch.kind == Notch::cross_hole && !(notch.r < 0.29 * d)) return say("the hole must be smaller than the section");
  if (has_factors(notch.kind) && !typed && in.group > fatigue::Endurance::Group::cast_steel)
    return say("its notch factor is given for steels only: give kind = \"given\", K_t and K_ts");
  if (Message fault = fault_of_size(notch, there); !fault.empty()) return fault;
  if (Message fault = fault_of_wall(in, notch, there); !fault.empty()) return fault;
  if (Message fault = fault_of_place(in, notch); !fault.empty()) return fault;
  if (notch.r_T < in.r_T)
    return say("its torque falls to {1} of the maximum, and that of the shaft, r_T, to {2}",
               format_number(notch.r_T, 3), format_number(in.r_T, 3));
  return fault_of_meeting(in, notch, there);
}

/// Axial reach of a notch: twice its depth. For a keyway the depth is d/10.
Length reach_of(const Input& in, const Notched& notch) {
  const Length none = 0.0 * mm;
  const Sides sides = around(in, notch.x).sides;
  const Length d = sides.left.d, next = sides.right.d;
  const Length root = is_set(notch.r) ? notch.r : none, deep = is_groove(notch.kind) ? notch.t : none;
  const Length cut = is_keyed(notch.kind) ? 0.1 * d : abs(d - next) / 2.0;
  return 2.0 * max(max(root, deep), cut);
}

/// The stretch that a notch occupies: a keyway from one end of the key to the other, the width of a groove.
struct NotchExtent {
  Length from, to;
};
NotchExtent extent_of(const Input& in, const Notched& notch) {
  if (is_set(notch.w)) return {notch.x - notch.w / 2.0, notch.x + notch.w / 2.0};
  const Length end = other_end(in, notch);
  return is_set(end) ? NotchExtent{min(notch.x, end), max(notch.x, end)} : NotchExtent{notch.x, notch.x};
}

/// Two notches closer than the nearer of their ends dies down; null where there are none.
struct Crowded {
  const Notched* first = nullptr;
  const Notched* second = nullptr;
  Length gap = unset<Length>, reach = unset<Length>;
};
Crowded crowded(const Input& in) {
  for (const Notched& notch : in.notches) {
    const NotchExtent own = extent_of(in, notch);
    for (const Notched& other : in.notches) {
      if (!(notch.x < other.x) || are_one(in, notch.x, other.x)) continue;
      const NotchExtent next = extent_of(in, other);
      if (are_one(in, own.from, next.from) && are_one(in, own.to, next.to)) continue;  // both ends of one key
      const Length gap = max(own.from, next.from) - min(own.to, next.to);
      const Length reach = max(reach_of(in, notch), reach_of(in, other));
      if (gap < reach * (1.0 - one_place)) return {&notch, &other, max(gap, 0.0 * mm), reach};
    }
  }
  return {};
}

/// "'key_end' (43 mm to 79 mm)", "the notch at 80 mm".
std::string name_with_range(const Input& in, const Notched& notch) {
  const NotchExtent extent = extent_of(in, notch);
  const bool is_long = !are_one(in, extent.from, extent.to);
  const std::string range = is_long ? format(extent.from) + " to " + format(extent.to) : format(notch.x);
  return notch.name.empty() ? "the notch at " + range : "'" + std::string(notch.name.view()) + "' (" + range + ")";
}

}  // namespace

bool Design::notches_fit(const Input& in) {
  for (std::size_t i = 0; i < in.notches.size(); ++i) {
    if (!fault_of(in, in.notches[i]).empty()) return false;
    for (std::size_t k = 0; k < i; ++k) {
      if (are_one(in, in.notches[i].x, in.notches[k].x)) return false;
    }
  }
  return true;
}

FieldFault Design::misfit(const Input& in) {
  for (std::size_t i = 0; i < in.notches.size(); ++i) {
    const Message fault = fault_of(in, in.notches[i]);
    if (!fault.empty()) return {place_of("notches", in.notches, i, "kind"), fault, {}};
  }
  return {"notches", say("two notches at the same position"),
          say("a notch in a notch is one given by its K_t and K_ts: kind = \"given\"")};
}

bool Design::notches_apart(const Input& in) { return crowded(in).first == nullptr; }

FieldFault Design::crowd(const Input& in) {
  const Crowded pair = crowded(in);
  if (pair.first == nullptr) return {};
  const auto i = static_cast<std::size_t>(pair.first - in.notches.data());
  return {
      place_of("notches", in.notches, i, "x"),
      say("{1} and {2} are {3} apart, less than {4} (twice the larger depth or radius), and interact: notches are "
          "assessed separately",
          name_with_range(in, *pair.first), name_with_range(in, *pair.second), format(pair.gap), format(pair.reach)),
      say("keep them apart, or replace both with one notch: kind = \"given\" with K_t and K_ts of both together")};
}

bool Design::steps_are_notched(const Input& in) { return bare_step(in).path.empty(); }

FieldFault Design::bare_step(const Input& in) {
  FieldFault fault;
  if (!asks_fatigue(in)) return fault;
  find_meeting(in, [&](const Meeting& m) {
    const bool known = std::any_of(in.notches.begin(), in.notches.end(),
                                   [&](const Notched& notch) { return are_one(in, notch.x, m.x); });
    if (known || !(m.steps() || m.is_hollow())) return false;
    const Sides sides = m.sides();
    const Length d = sides.thinner().d, D = sides.larger();
    const char* const given = "kind = \"given\", K_t = ..., K_ts = ..., r = \"...\" }";
    const bool charted = d != D && !is_bored(in, m.x);
    fault = {"notches",
             m.is_hollow() ? say("at {1} a taper begins in a re-entrant edge without a notch", format(m.x))
             : d == D      ? say("at {1} the bore changes without a notch", format(m.x))
                           : say("at {1} the diameter changes from {2} to {3} without a notch", format(m.x), format(d),
                                 format(D)),
             say("add {1} to notches",
                 "{ x = \"" + format(m.x) + "\", " + (charted ? "kind = \"shoulder\", r = \"...\" }" : given))};
    return true;
  });
  return fault;
}

}  // namespace loadpath::shaft
