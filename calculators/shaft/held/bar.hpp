// The bar of shaft.held, divided where it, its load or its members change, and the flexibility of each stretch.
#pragma once

#include "calculators/shaft/held/types.hpp"
#include "lib/calculator/trace.hpp"

#include <cstddef>

namespace loadpath::shaft {

using TorsionalStiffness = decltype(Stress() * SecondMoment());
using Yielding = decltype(1.0 / Moment());             // rotation by a moment
using SpreadYielding = decltype(Length() / Moment());  // by a torque per length

/// Between two neighbouring cuts.
struct Slice {
  Length x, l;
  std::size_t segment;
  Length a;  // from the first end of its segment
  Moment Q;  // sum of the loads up to and at its first end, with the service factor
  Force m;   // torque per length, with the service factor
};
using Slices = List<Slice, most_cuts>;

Length length_of(const HeldTypes::Input& in);
Slices slices_of(const HeldTypes::Input& in);
/// All loads on the bar, with the service factor.
Moment sum_of_loads(const HeldTypes::Input& in);

Ring ring_at(const Segment& s, Length from_its_end);
bool is_around(const Sleeve& sleeve, const Slice& s);
inline Stress modulus(const HeldTypes::Input& in, Stress own) { return is_set(own) ? own : in.G; }
/// Stiffness of the full section, at a place of a stretch.
TorsionalStiffness stiffness_at(const HeldTypes::Input& in, const Slice& s, Length from_its_end);

/// The rotation over a stretch by a moment of 1, and by a torque per length of 1 that its second end holds.
struct Flexibility {
  Yielding f_0;
  SpreadYielding f_1;
};

inline constexpr SpreadYielding no_spread = from_si<SpreadYielding>(0.0);
/// Whether a torque is distributed over it; otherwise f_1 is not required.
inline bool is_spread(const Slice& s) { return in_si(s.m) != 0.0; }

/// Integrals of 1/(G I_p) and of x/(G I_p) over a cone whose bore is not in proportion.
Flexibility integrated(const HeldTypes::Input& in, const Slice& s);

template <class Tracer>
Flexibility of_cylinders(const HeldTypes::Input& in, const Slice& s, Tracer& trace) {
  const auto C = trace.value("C", stiffness_at(in, s, 0.0 * mm), "sum of G I_p over the members, which twist alike");
  STEP(f_0, s.l / C, "rotation by a moment of 1, [B19] (7)");
  if (!is_spread(s)) return {f_0, no_spread};
  STEP(f_1, s.l * s.l / (2.0 * C), "rotation by a torque per length of 1");
  return {f_0, f_1};
}

template <class Tracer>
Flexibility of_cone(const HeldTypes::Input& in, const Slice& s, Tracer& trace) {
  const Segment& segment = in.segments[s.segment];
  const Ring first = ring_at(segment, s.a), second = ring_at(segment, s.a + s.l);
  const double chi = trace.value("chi", reduced(first.d_bore / first.d), "bore over diameter");
  constexpr double same = 1e-12;
  if (std::abs(chi - reduced(second.d_bore / second.d)) > same) {
    const Flexibility found = integrated(in, s);
    trace.value("f_0", found.f_0, "integral of 1/(G I_p) along the cone");
    trace.value("f_1", found.f_1, "integral of x/(G I_p) along the cone");
    return found;
  }
  const Stress G = trace.value("G", modulus(in, segment.G), "shear modulus");
  const Length d_a = trace.value("d_a", first.d, "diameter at its first end");
  const Length d_e = trace.value("d_e", second.d, "diameter at its second end");
  STEP(f_0, 32.0 * s.l * (d_a * d_a + d_a * d_e + d_e * d_e) / (3.0 * pi * G * (1.0 - pow<4>(chi)) * pow<3>(d_a * d_e)),
       "integral of 1/(G I_p) along the cone");
  if (!is_spread(s)) return {f_0, no_spread};
  STEP(f_1, 16.0 * s.l * s.l * (2.0 * d_a + d_e) / (3.0 * pi * G * (1.0 - pow<4>(chi)) * pow<2>(d_a * d_e) * d_e),
       "integral of x/(G I_p) along the cone");
  return {f_0, f_1};
}

template <class Tracer>
Flexibility flexibility(const HeldTypes::Input& in, const Slice& s, Tracer& trace) {
  return is_cone(in.segments[s.segment]) ? of_cone(in, s, trace) : of_cylinders(in, s, trace);
}

/// How far a section of a stretch turns against its first end.
inline double rotation_over(const HeldTypes::Input& in, Slice s, Length l, Moment M_1) {
  NoTrace trace;
  s.l = l;
  const Flexibility f = flexibility(in, s, trace);
  return reduced(M_1 * f.f_0 - s.m * f.f_1);
}

}  // namespace loadpath::shaft
