// Sine, cosine, tangent, arc tangent and arc cosine, inline, without a branch and the same to the bit on every C
// library: for sweeps, whose loops they let through wide registers.
//
// All within one unit in the last place; the tests hold them against wider numbers. Angles are meant up to 1e5 rad. The
// coefficients interpolate at Chebyshev's points; what rounding loses of a reduced argument goes along as its rest.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace loadpath::numerics {

namespace trigonometry {

/// A number and what rounding has cut off from it.
struct Parted {
  double value, rest;
};

/// a + b; |a| >= |b| is not required.
inline Parted sum_of(double a, double b) {
  const double sum = a + b, of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// The upper half of the digits, whose products are exact.
inline double upper_half(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~std::uint64_t{0x7ffffff});
}

/// By two polynomials, c[0] + c[1] z + ..., whose terms are added in pairs.
template <int n>
double polynomial(const double (&c)[n], double z) {
  const double z2 = z * z;
  double even = c[(n - 1) / 2 * 2], odd = c[n / 2 * 2 - 1];
  for (int k = (n - 1) / 2 * 2 - 2; k >= 0; k -= 2) even = even * z2 + c[k];
  for (int k = n / 2 * 2 - 3; k >= 1; k -= 2) odd = odd * z2 + c[k];
  return even + z * odd;
}

/// An angle from -pi/4 to pi/4 without its quarter turns, of which the last two bits count.
struct Reduced {
  double angle, rest;
  std::uint64_t quarters;
};

inline Reduced reduced(double angle) {
  constexpr double shift = 0x1.8p52;  // a number of this size has no digits behind the point
  constexpr double first = 0x1.921fb544p+0, second = 0x1.0b4611a6p-34, third = 0x1.3198a2e037073p-69;  // of pi/2
  const double shifted = angle * 0.6366197723675814 + shift, n = shifted - shift;
  const Parted rough = sum_of(angle - n * first, -(n * second));  // both products are exact
  const Parted fine = sum_of(rough.value, rough.rest - n * third);
  return {fine.value, fine.rest, std::bit_cast<std::uint64_t>(shifted)};
}

/// Sine and cosine of a reduced angle.
struct Sides {
  double sine, sine_rest, cosine, cosine_rest;
};

inline Sides sides_of(double x, double x_rest) {
  constexpr double of_sine[] = {-0.16666666666666666,   0.008333333333330948,   -0.00019841269836756774,
                                2.7557316101617874e-06, -2.505113165023518e-08, 1.5918115263265974e-10};
  constexpr double of_cosine[] = {0.041666666666666664,    -0.0013888888888887398, 2.480158729876456e-05,
                                  -2.7557317271145144e-07, 2.087614614655861e-09,  -1.1382623647474604e-11};
  const double z = x * x, half = 0.5 * z, whole = 1.0 - half, h = upper_half(x);
  const double cut_off = (h * h - z) + (x - h) * (x + h);  // rounding error of z
  const double sine = x * z * polynomial(of_sine, z) + x_rest * whole;
  const double cosine = ((1.0 - whole) - half) + (z * z * polynomial(of_cosine, z) - (x * x_rest + 0.5 * cut_off));
  const double s = x + sine, c = whole + cosine;
  return {s, (x - s) + sine, c, (whole - c) + cosine};
}

/// With the sign of this bit changed.
inline double with_sign(double x, std::uint64_t bit) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ (bit << 63));
}

/// (asin(s) - s)/(s z), z = s^2 <= 1/4.
inline double arc_over(double z) {
  constexpr double c[] = {0.16666666666666669,  0.0749999999999843,   0.04464285714635991,  0.030381944138170334,
                          0.022372172957091412, 0.0173523923576202,   0.013971218548752051, 0.011479121292946488,
                          0.010323189996124416, 0.005455850831324314, 0.017405496291324245, -0.014859264309819778,
                          0.028762997617254003};
  return polynomial(c, z);
}

constexpr double half_pi = 1.5707963267948966, half_pi_rest = 6.123233995736766e-17;

}  // namespace trigonometry

/// Both at once.
struct SineCosine {
  double sine, cosine;
};

inline SineCosine sine_cosine(double angle) {
  using namespace trigonometry;
  const Reduced r = reduced(angle);
  const Sides at = sides_of(r.angle, r.rest);
  const bool swapped = (r.quarters & 1) != 0;
  const double s = swapped ? at.cosine : at.sine, c = swapped ? at.sine : at.cosine;
  return {with_sign(s, (r.quarters >> 1) & 1), with_sign(c, ((r.quarters + 1) >> 1) & 1)};
}

inline double sine(double angle) { return sine_cosine(angle).sine; }
inline double cosine(double angle) { return sine_cosine(angle).cosine; }

/// The quotient of the two, with the rests of both and its own.
inline double tangent(double angle) {
  using namespace trigonometry;
  const Reduced r = reduced(angle);
  const Sides at = sides_of(r.angle, r.rest);
  const bool swapped = (r.quarters & 1) != 0;
  const double over = swapped ? at.cosine : at.sine, over_rest = swapped ? at.cosine_rest : at.sine_rest;
  const double under = swapped ? at.sine : at.cosine, under_rest = swapped ? at.sine_rest : at.cosine_rest;
  const double inverse = 1.0 / under, quotient = over * inverse, q = upper_half(quotient), u = upper_half(under);
  const double left = ((over - q * u) - q * (under - u)) - (quotient - q) * under;
  return with_sign(quotient + (left + over_rest - quotient * under_rest) * inverse, r.quarters & 1);
}

inline double arc_tangent(double x) {
  using namespace trigonometry;
  constexpr double c[] = {-0.33333333333333326,  0.19999999999987655, -0.14285714283127662, 0.11111110899049664,
                          -0.0909090014058555,   0.07692086204975024, -0.06663224869084483, 0.05847612444521365,
                          -0.050334165154982353, 0.0378116004846169,  -0.017532295994972764};
  // relative to the angle whose tangent is 0, 1/2, 1, 3/2 or none
  const double a = std::abs(x);
  double over = a, under = 1.0, base = 0.0, base_rest = 0.0;
  const auto beyond = [&](double bound, double o, double u, double b, double rest) {
    const bool yes = a >= bound;
    over = yes ? o : over, under = yes ? u : under, base = yes ? b : base, base_rest = yes ? rest : base_rest;
  };
  beyond(0.4375, 2.0 * a - 1.0, 2.0 + a, 0.4636476090008061, 2.2698777452961687e-17);
  beyond(0.6875, a - 1.0, a + 1.0, 0.7853981633974483, 3.061616997868383e-17);
  beyond(1.1875, a - 1.5, 1.0 + 1.5 * a, 0.982793723247329, 1.3903311031230998e-17);
  beyond(2.4375, -1.0, a, half_pi, half_pi_rest);
  const double t = over / under, z = t * t;
  return std::copysign(base + (t + (t * z * polynomial(c, z) + base_rest)), x);
}

/// NaN beyond 1, as its neighbour.
inline double arc_cosine(double x) {
  using namespace trigonometry;
  const double a = std::abs(x);
  const bool far = a > 0.5;
  const double z = far ? 0.5 * (1.0 - a) : x * x;
  // far from 0 it is twice the arc sine of the root of z
  const double root = std::sqrt(z), r = upper_half(root);
  const double rest = z > 0.0 ? (z - r * r) / (root + r) : 0.0;
  const double arc = 2.0 * (r + (root * z * arc_over(z) + rest));
  const double near_half_pi = half_pi - (x - (half_pi_rest - x * z * arc_over(z)));
  const double behind = 2.0 * half_pi - (arc - 2.0 * half_pi_rest);
  return far ? (x > 0.0 ? arc : behind) : near_half_pi;
}

}  // namespace loadpath::numerics
