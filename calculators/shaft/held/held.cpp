#include "calculators/shaft/held/held.hpp"

#include "calculators/shaft/held/bar.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/numerics/magnitude.hpp"

#include <cmath>

namespace loadpath::shaft {

namespace {

using Input = Held::Input;
using Result = Held::Result;
using Flexibilities = List<Flexibility, most_cuts>;

/// Flexibility of a support: zero if rigid, and not required if the end is free.
Yielding yielding_of(End end, Moment c) { return end == End::elastic ? 1.0 / c : from_si<Yielding>(0.0); }

/// The two reactions: by statics where an end is free, else by the rotations, which meet at the second support.
template <class Tracer>
void react(const Input& in, Yielding F, double phi_0, Result& r, Tracer& trace) {
  const Moment Q = trace.value("Q", sum_of_loads(in), "sum of the loads, with the application factor");
  const Yielding f_a = trace.value("f_a", yielding_of(in.end_1, in.c_1), "of the first support: 1/c_1");
  const Yielding f_b = trace.value("f_b", yielding_of(in.end_2, in.c_2), "of the second support: 1/c_2");
  if (in.end_1 == End::free) {
    r.R_1 = trace.value("R_1", 0.0 * N_m, "a free end");
    STEP_TO(r, R_2, -Q, "equilibrium");
    STEP_TO(r, phi_2, -R_2 * f_b, "elastic support");
    STEP_TO(r, phi_1, phi_2 - phi_0, "from there along the bar");
    return;
  }
  if (in.end_2 == End::free) {
    r.R_2 = trace.value("R_2", 0.0 * N_m, "a free end");
    r.R_1 = NAMED_STEP("R_1", -Q, "equilibrium");
    const Moment R_1 = r.R_1;
    STEP_TO(r, phi_1, -R_1 * f_a, "elastic support");
    STEP_TO(r, phi_2, phi_1 + phi_0 - R_1 * F, "along the bar");
    return;
  }
  STEP_TO(r, R_1, (phi_0 - Q * f_b) / (f_a + F + f_b), "the rotations of bar and supports make up for one another");
  STEP_TO(r, R_2, -Q - R_1, "equilibrium");
  STEP_TO(r, phi_1, -R_1 * f_a, "elastic support");
  STEP_TO(r, phi_2, -R_2 * f_b, "elastic support");
}

struct StretchEnd {
  Moment M;
  double phi;  // against its first end
};

template <class Tracer>
StretchEnd end_of(const Slice& s, const Flexibility& f, Moment M_1, Tracer& trace) {
  const Yielding f_0 = f.f_0;
  if (!is_spread(s)) {
    const double phi = NAMED_STEP("phi", M_1 * f_0, "rotation of its second end against its first");
    return {trace.value("M_2", M_1, "no torque along it"), phi};
  }
  const SpreadYielding f_1 = f.f_1;
  const Force m_s = trace.value("m_s", s.m, "torque per length, with the application factor");
  STEP(M_2, M_1 - m_s * s.l, "at its second end");
  return {M_2, NAMED_STEP("phi", M_1 * f_0 - m_s * f_1, "rotation of its second end against its first")};
}

/// Moments and rotations, stretch by stretch.
template <class Tracer>
void along(const Slices& slices, const Flexibilities& flexibilities, Result& r, Tracer& trace) {
  double phi = r.phi_1;
  r.sections.push_back({0.0 * mm, phi});
  Moment M_max = 0.0 * N_m;
  const Moment R_1 = r.R_1;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    [[maybe_unused]] const auto scope = trace.scope("stretches", i);
    const Slice& s = slices[i];
    const Flexibility& f = flexibilities[i];
    const Moment Q = trace.value("Q", s.Q, "loads up to its first end, with the application factor");
    const Moment M_1 = NAMED_STEP("M_1", -R_1 - Q, "the resultant on its right is the opposite of that on its left");
    const auto [M_2, dphi] = end_of(s, f, M_1, trace);
    r.stretches.push_back({s.x, s.l, M_1, M_2, dphi});
    phi += dphi;
    r.sections.push_back({s.x + s.l, i + 1 < slices.size() ? phi : r.phi_2});
    M_max = max(M_max, max(abs(M_1), abs(M_2)));
  }
  r.M_max = trace.value("M_max", M_max, "maximum of the bar");
}

/// Where a function of the place is the largest: at an end of a cylinder; along a cone by search.
template <class Function>
Length worst_place(const Function& f, Length l, bool cone) {
  constexpr int parts = 32, halvings = 40;
  Length best = numerics::exceeds(in_si(f(l)), in_si(f(0.0 * l))) ? l : 0.0 * l;
  if (!cone) return best;
  for (int i = 1; i < parts; ++i) {
    const Length x = l * (static_cast<double>(i) / parts);
    if (numerics::exceeds(in_si(f(x)), in_si(f(best)))) best = x;
  }
  Length step = l / parts;
  for (int i = 0; i < halvings; ++i, step /= 2.0) {
    for (const Length& x : {best - step, best + step}) {
      if (x >= 0.0 * l && x <= l && f(x) > f(best)) best = x;
    }
  }
  return best;
}

/// A member in one stretch: its ring along it, and its modulus.
struct Part {
  const Sleeve* sleeve;  // null: the segment
  Stress G;
};
Ring ring_of(const Input& in, const Slice& s, const Part& part, Length x) {
  return part.sleeve != nullptr ? Ring{part.sleeve->d, part.sleeve->d_bore} : ring_at(in.segments[s.segment], s.a + x);
}

/// A place of a bar where a member is stressed the most so far.
struct Worst {
  std::size_t slice = 0;
  Length from_its_end = 0.0 * mm;
  double strain = -1.0;  // shear strain at the surface
};

Worst worst_of(const Input& in, const Slices& slices, const Result& r, const Sleeve* sleeve, std::size_t segment) {
  Worst worst;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const Slice& s = slices[i];
    if (sleeve != nullptr ? !is_around(*sleeve, s) : s.segment != segment) continue;
    const auto strain = [&](Length x) {
      const Moment M = r.stretches[i].M_1 - s.m * x;
      return in_si(abs(M) / stiffness_at(in, s, x) * ring_of(in, s, {sleeve, {}}, x).d / 2.0);
    };
    const Length x = worst_place(strain, s.l, is_cone(in.segments[s.segment]));
    if (numerics::exceeds(strain(x), worst.strain)) worst = {i, x, strain(x)};
  }
  return worst;
}

template <class Tracer>
void judge_member(const Input& in, const Slices& slices, const Part& part, std::size_t segment, Result& r,
                  Tracer& trace) {
  [[maybe_unused]] const auto scope = trace.scope("members", r.members.size());
  const Worst worst = worst_of(in, slices, r, part.sleeve, segment);
  const Slice& s = slices[worst.slice];
  const Length x = worst.from_its_end;
  const Ring ring = ring_of(in, s, part, x);
  Held::Member member;
  member.name = part.sleeve != nullptr ? part.sleeve->name : in.segments[segment].name;
  member.x = trace.value("x", s.x + x, "where its stress is the largest");
  const Moment M = trace.value("M", r.stretches[worst.slice].M_1 - s.m * x, "total moment of the section there");
  const auto C = trace.value("C", stiffness_at(in, s, x), "sum of G I_p there over the members, which twist alike");
  const Stress G = trace.value("G", part.G, "its shear modulus");
  const Length d = member.d = trace.value("d", ring.d, "its outer diameter");
  const SecondMoment I_p = trace.value("I_p", polar(ring), "its polar second moment of area");
  STEP_TO(member, T, M * G * I_p / C, "its part of the moment");
  STEP_TO(member, tau, G * abs(M) * d / (2.0 * C), "at its surface, [B19] (2)");
  member.tau_all =
      allowable_shear(in, part.sleeve != nullptr ? part.sleeve->tau_adm : in.segments[segment].tau_adm, trace);
  const Stress tau_all = member.tau_all;
  STEP_TO(member, u_tau, tau / tau_all, "strength condition, [B19] (3)");
  r.members.push_back(member);
}

template <class Tracer>
void judge_members(const Input& in, const Slices& slices, Result& r, Tracer& trace) {
  for (std::size_t i = 0; i < in.segments.size(); ++i)
    judge_member(in, slices, {nullptr, modulus(in, in.segments[i].G)}, i, r, trace);
  for (const Sleeve& sleeve : in.sleeves) judge_member(in, slices, {&sleeve, modulus(in, sleeve.G)}, 0, r, trace);
  r.tau_max = 0.0 * MPa, r.u_tau = 0.0;
  for (const Held::Member& member : r.members) {
    r.tau_max = max(r.tau_max, member.tau);
    r.u_tau = larger_use(r.u_tau, member.u_tau);
  }
  trace.value("tau_max", r.tau_max, "maximum of the members");
  trace.value("u_tau", r.u_tau, "maximum of the members");
}

Twist largest_twist(const Input& in, const Slices& slices, const Result& r) {
  Twist largest = from_si<Twist>(0.0);
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const Slice& s = slices[i];
    const auto theta = [&](Length x) -> Twist { return abs(r.stretches[i].M_1 - s.m * x) / stiffness_at(in, s, x); };
    largest = max(largest, theta(worst_place(theta, s.l, is_cone(in.segments[s.segment]))));
  }
  return largest;
}

/// The largest rotation: at a section, or inside of a stretch where the moment passes through zero.
void largest_rotation(const Input& in, const Slices& slices, Result& r) {
  r.phi_max = 0.0, r.x_phi = 0.0 * mm;
  const auto raise = [&](Length x, double phi) {
    if (std::abs(phi) > r.phi_max) r.phi_max = std::abs(phi), r.x_phi = x;
  };
  for (const Held::Section& section : r.sections) raise(section.x, section.phi);
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const Held::Stretch& s = r.stretches[i];
    if (in_si(s.M_1) * in_si(s.M_2) >= 0.0) continue;
    const Length x = s.M_1 / slices[i].m;
    raise(s.x + x, r.sections[i].phi + rotation_over(in, slices[i], x, s.M_1));
  }
}

double steepest(const Input& in) {
  double s = 0.0;
  for (const Segment& segment : in.segments) {
    const Ring first = ring_at(segment, 0.0 * mm), second = ring_at(segment, segment.l);
    s = max(s, reduced(abs(second.d - first.d) / (2.0 * segment.l)));
    s = max(s, reduced(abs(second.d_bore - first.d_bore) / (2.0 * segment.l)));
  }
  return s;
}

/// Whether the diameter jumps between two parts, or where a sleeve ends.
bool has_shoulders(const Input& in) {
  constexpr double rounding = 1.001;
  for (std::size_t i = 1; i < in.segments.size(); ++i) {
    const Segment& before = in.segments[i - 1];
    const Length d_1 = is_set(before.d_2) ? before.d_2 : before.d, d_2 = in.segments[i].d;
    if (max(d_1, d_2) > rounding * min(d_1, d_2)) return true;
  }
  return !in.sleeves.empty();
}

template <class Tracer>
void judge(const Input& in, const Slices& slices, Result& r, Tracer& trace) {
  r.d_s = 0.0 * mm;
  for (const Segment& s : in.segments) r.d_s = max(r.d_s, max(s.d, is_set(s.d_2) ? s.d_2 : s.d));
  for (const Sleeve& s : in.sleeves) r.d_s = max(r.d_s, s.d);
  judge_members(in, slices, r, trace);
  const Twist theta_max = r.theta_max = trace.value("theta_max", largest_twist(in, slices, r), "maximum of the bar");
  if (is_set(in.theta_adm)) {
    STEP_TO(r, u_theta, theta_max / in.theta_adm, "stiffness condition, [B19] (8)");
  }
  largest_rotation(in, slices, r);
  const double phi_max = trace.angle("phi_max", r.phi_max, "maximum of the bar, in either direction");
  if (is_set(in.phi_adm)) {
    STEP_TO(r, u_phi, phi_max / in.phi_adm, "stiffness condition");
  }
  if (const double slope = steepest(in); slope > 0.0)
    r.s_max = trace.value(
        "s_max", slope,
        "half the difference of the diameters over the length; the exact cone of 10 degrees is close, [Foeppl]");
  if (has_shoulders(in)) r.K_ts = trace.value("K_ts", 1.1, "lower bound for shoulders with any fillet, [Peterson]");
  r.cycle = {Stresses::shear, r.tau_max};
}

/// Flexibility of the bar, stretch by stretch and in total.
struct BarFlexibility {
  Flexibilities flexibilities;
  Yielding F = from_si<Yielding>(0.0);
  double phi_0 = 0.0;
};

template <class Tracer>
BarFlexibility flexibility_of(const Input& in, const Slices& slices, Tracer& trace) {
  BarFlexibility whole;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    [[maybe_unused]] const auto scope = trace.scope("stretches", i);
    const Flexibility f = flexibility(in, slices[i], trace);
    whole.flexibilities.push_back(f);
    whole.F += f.f_0;
    whole.phi_0 -= reduced(slices[i].Q * f.f_0 + slices[i].m * f.f_1);
  }
  return whole;
}

}  // namespace

template <class Tracer>
Held::Result Held::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const Slices slices = slices_of(in);
  const BarFlexibility whole = flexibility_of(in, slices, trace);
  trace.value("F", whole.F, "rotation over the full bar per unit moment: sum over the intervals");
  trace.angle("phi_0", whole.phi_0, "rotation of its second end against its first by the loads, without R_1");
  react(in, whole.F, whole.phi_0, r, trace);
  along(slices, whole.flexibilities, r, trace);
  judge(in, slices, r, trace);
  return r;
}

template Held::Result Held::evaluate(const Input&, NoTrace&);
template Held::Result Held::evaluate(const Input&, Trace&);

}  // namespace loadpath::shaft

template const loadpath::Calculator& loadpath::erased<loadpath::shaft::Held>();
