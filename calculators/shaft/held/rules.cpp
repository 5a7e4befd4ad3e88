// Rules of shaft.held beyond the bounds of its fields.
#include "calculators/shaft/held/bar.hpp"
#include "calculators/shaft/held/held.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <string>

namespace loadpath::shaft {

namespace {

constexpr double rounding = 1e-9;

/// Where one member is along the bar, and between which diameters.
struct Place {
  Length from, to;
  Ring ring;
};

bool meet(const Place& a, const Place& b) {
  const Length close = rounding * max(a.ring.d, b.ring.d);
  const bool apart = a.to <= b.from + close || b.to <= a.from + close;
  const bool around = a.ring.d <= b.ring.d_bore + close || b.ring.d <= a.ring.d_bore + close;
  return !apart && !around;
}

Place place_of(const Sleeve& s) { return {s.x, s.x + s.l, {s.d, s.d_bore}}; }

template <class Members>
bool own_strength(const Members& members) {
  return std::all_of(members.begin(), members.end(), [](const auto& s) { return is_set(s.tau_adm); });
}

}  // namespace

bool Held::springs_fit(const Input& in) {
  return (in.end_1 == End::elastic) == is_set(in.c_1) && (in.end_2 == End::elastic) == is_set(in.c_2);
}

bool Held::one_strength(const Input& in) {
  return one_shear_strength(in, own_strength(in.segments) && own_strength(in.sleeves));
}

bool Held::strength_of_own(const Input& in) {
  const auto fits = [](const auto& s) { return !is_set(s.G) || is_set(s.tau_adm); };
  return std::all_of(in.segments.begin(), in.segments.end(), fits) &&
         std::all_of(in.sleeves.begin(), in.sleeves.end(), fits);
}

bool Held::has_moduli(const Input& in) {
  const auto has = [&](const auto& s) { return is_set(modulus(in, s.G)); };
  return std::all_of(in.segments.begin(), in.segments.end(), has) &&
         std::all_of(in.sleeves.begin(), in.sleeves.end(), has);
}

bool Held::walls_stand(const Input& in) {
  const auto is_hollow = [](const Ring& r) { return r.d_bore < r.d; };
  return std::all_of(in.segments.begin(), in.segments.end(),
                     [&](const Segment& s) { return is_hollow(ring_at(s, 0.0 * mm)) && is_hollow(ring_at(s, s.l)); }) &&
         std::all_of(in.sleeves.begin(), in.sleeves.end(), [](const Sleeve& s) { return s.d_bore < s.d; });
}

bool Held::on_bar(const Input& in) {
  const Length end = length_of(in) * (1.0 + rounding);
  return std::all_of(in.torques.begin(), in.torques.end(), [&](const AxialTorque& t) { return t.x <= end; }) &&
         std::all_of(in.sleeves.begin(), in.sleeves.end(), [&](const Sleeve& s) { return s.x + s.l <= end; });
}

FieldFault Held::off_bar(const Input& in) {
  const Length end = length_of(in);
  for (std::size_t i = 0; i < in.torques.size(); ++i) {
    if (in.torques[i].x <= end * (1.0 + rounding)) continue;
    return {"torques[" + std::to_string(i + 1) + "].x",
            say("torque {1} is at {2}, but the bar ends at {3}", std::to_string(i + 1),
                format_quantity(in_si(in.torques[i].x), mm.symbol), format_quantity(in_si(end), mm.symbol)),
            say("x counts from the first end: correct it, or the lengths of the segments")};
  }
  return {"sleeves", say("a sleeve ends beyond the bar, at {1}", format_quantity(in_si(end), mm.symbol)), {}};
}

bool Held::on_cylinders(const Input& in) {
  Length x = 0.0 * mm;
  for (const Segment& s : in.segments) {
    const Length close = rounding * s.l;
    for (const Sleeve& sleeve : in.sleeves) {
      if (is_cone(s) && sleeve.x + close < x + s.l && x + close < sleeve.x + sleeve.l) return false;
    }
    x += s.l;
  }
  return true;
}

bool Held::side_by_side(const Input& in) {
  for (std::size_t i = 0; i < in.sleeves.size(); ++i) {
    const Place own = place_of(in.sleeves[i]);
    Length x = 0.0 * mm;
    for (const Segment& s : in.segments) {
      if (!is_cone(s) && meet(own, {x, x + s.l, {s.d, s.d_bore}})) return false;
      x += s.l;
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (meet(own, place_of(in.sleeves[k]))) return false;
    }
  }
  return true;
}

/// Whether a torque loads it at all.
Applies Held::loaded(const Input& in) {
  const auto acts = [](auto load) { return in_si(load) != 0.0; };
  return where(std::any_of(in.torques.begin(), in.torques.end(), [&](const AxialTorque& t) { return acts(t.T); }) ||
               std::any_of(in.segments.begin(), in.segments.end(), [&](const Segment& s) { return acts(s.m); }));
}

Applies Held::brittle(const Input& in) { return in.behaviour == Behaviour::brittle ? loaded(in) : Applies::no; }
Applies Held::tough(const Input& in) { return in.behaviour == Behaviour::brittle ? Applies::no : loaded(in); }

Applies Held::thin(const Input& in) {
  Applies applies = Applies::no;
  for (const Segment& s : in.segments) {
    for (const Ring& r : {ring_at(s, 0.0 * mm), ring_at(s, s.l)})
      applies = std::max(applies, thin_wall_of(r.d, 0.0, r.d_bore));
  }
  for (const Sleeve& s : in.sleeves) applies = std::max(applies, thin_wall_of(s.d, 0.0, s.d_bore));
  return applies;
}

}  // namespace loadpath::shaft
