#include "calculators/shaft/held/bar.hpp"

#include "lib/numerics/quadrature.hpp"

#include <algorithm>

namespace loadpath::shaft {

namespace {

constexpr double rounding = 1e-12;  // share of the length of the bar: places that are closer count as one

using Cuts = List<Length, 1 + 2 * most_cuts>;

Cuts cuts_of(const HeldTypes::Input& in) {
  Cuts cuts{0.0 * mm};
  for (const Segment& s : in.segments) cuts.push_back(cuts.back() + s.l);
  const Length end = cuts.back();
  for (const Sleeve& s : in.sleeves) cuts.insert(cuts.end(), {s.x, s.x + s.l});
  for (const AxialTorque& t : in.torques) cuts.push_back(t.x);
  std::sort(cuts.begin(), cuts.end());
  const auto close = [&](Length a, Length b) { return b - a <= rounding * end; };
  cuts.erase(std::unique(cuts.begin(), cuts.end(), close), cuts.end());
  while (close(cuts.back(), end)) cuts.pop_back();
  cuts.push_back(end);
  return cuts;
}

Moment torques_up_to(const HeldTypes::Input& in, Length x) {
  Moment sum = 0.0 * N_m;
  for (const AxialTorque& t : in.torques) {
    if (t.x <= x) sum += t.T;
  }
  return in.K_A * sum;
}

}  // namespace

Length length_of(const HeldTypes::Input& in) {
  Length sum = 0.0 * mm;
  for (const Segment& s : in.segments) sum += s.l;
  return sum;
}

Moment sum_of_loads(const HeldTypes::Input& in) {
  Moment sum = 0.0 * N_m;
  for (const AxialTorque& t : in.torques) sum += t.T;
  for (const Segment& s : in.segments) sum += s.m * s.l;
  return in.K_A * sum;
}

Slices slices_of(const HeldTypes::Input& in) {
  const Cuts cuts = cuts_of(in);
  const Length tolerance = rounding * length_of(in);
  Slices slices;
  std::size_t segment = 0;
  Length start = 0.0 * mm;
  Moment spread = 0.0 * N_m;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Length x = cuts[i], l = cuts[i + 1] - x;
    while (segment + 1 < in.segments.size() && x + tolerance >= start + in.segments[segment].l)
      start += in.segments[segment++].l;
    const Force m = in.K_A * in.segments[segment].m;
    slices.push_back({x, l, segment, max(x - start, 0.0 * mm), torques_up_to(in, x + tolerance) + spread, m});
    spread += m * l;
  }
  return slices;
}

Ring ring_at(const Segment& s, Length from_its_end) {
  const double t = std::min(reduced(from_its_end / s.l), 1.0);
  const Length d_2 = is_set(s.d_2) ? s.d_2 : s.d, d_bore_2 = is_set(s.d_bore_2) ? s.d_bore_2 : s.d_bore;
  return {(1.0 - t) * s.d + t * d_2, (1.0 - t) * s.d_bore + t * d_bore_2};
}

bool is_around(const Sleeve& sleeve, const Slice& s) {
  const Length middle = s.x + s.l / 2.0;
  return sleeve.x < middle && middle < sleeve.x + sleeve.l;
}

TorsionalStiffness stiffness_at(const HeldTypes::Input& in, const Slice& s, Length from_its_end) {
  const Segment& segment = in.segments[s.segment];
  TorsionalStiffness C = modulus(in, segment.G) * polar(ring_at(segment, s.a + from_its_end));
  for (const Sleeve& sleeve : in.sleeves) {
    if (is_around(sleeve, s)) C += modulus(in, sleeve.G) * polar({sleeve.d, sleeve.d_bore});
  }
  return C;
}

Flexibility integrated(const HeldTypes::Input& in, const Slice& s) {
  const double l = in_si(s.l);
  const auto yielding = [&](double x) { return 1.0 / in_si(stiffness_at(in, s, from_si<Length>(x))); };
  return {from_si<Yielding>(numerics::integral(yielding, 0.0, l)),
          from_si<SpreadYielding>(numerics::integral([&](double x) { return x * yielding(x); }, 0.0, l))};
}

}  // namespace loadpath::shaft
