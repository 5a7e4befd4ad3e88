#include "lib/sweep/point/probit.hpp"

#include "lib/simd/attributes.hpp"
#include "lib/sweep/point/elementary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace loadpath::sweep {

namespace {

constexpr double central = 0.425, near = 5.0;
constexpr std::size_t chunk = 256;

using Coefficients = std::array<double, 8>;

constexpr Coefficients a{3.3871328727963666080, 133.14166789178437745, 1971.5909503065514427, 13731.693765509461125,
                         45921.953931549871457, 67265.770927008700853, 33430.575583588128105, 2509.0809287301226727};
constexpr Coefficients b{1.0,
                         42.313330701600911252,
                         687.18700749205790830,
                         5394.1960214247511077,
                         21213.794301586595867,
                         39307.895800092710610,
                         28729.085735721942674,
                         5226.4952788528545610};
constexpr Coefficients c{1.42343711074968357734,  4.63033784615654529590,   5.76949722146069140550,
                         3.64784832476320460504,  1.27045825245236838258,   .241780725177450611770,
                         .0227238449892691845833, 7.74545014278341407640e-4};
constexpr Coefficients d{1.0,
                         2.05319162663775882187,
                         1.67638483018380384940,
                         .689767334985100004550,
                         .148103976427480074590,
                         .0151986665636164571966,
                         5.47593808499534494600e-4,
                         1.05075007164441684324e-9};
constexpr Coefficients e{6.65790464350110377720,    5.46378491116411436990,   1.78482653991729133580,
                         .296560571828504891230,    .0265321895265761230930,  .00124266094738807843860,
                         2.71155556874348757815e-5, 2.01033439929228813265e-7};
constexpr Coefficients f{1.0,
                         .599832206555887937690,
                         .136929880922735805310,
                         .0148753612908506148525,
                         7.86869131145613259100e-4,
                         1.84631831751005468180e-5,
                         1.42151175831644588870e-7,
                         2.04426310338993978564e-15};

inline double polynomial(const Coefficients& k, double x) {
  double sum = k[7];
  for (std::size_t i = 7; i-- > 0;) sum = sum * x + k[i];
  return sum;
}

inline double in_the_middle(double p) {
  const double q = p - 0.5, r = central * central - q * q;
  return q * polynomial(a, r) / polynomial(b, r);
}

inline bool is_central(double p) { return std::abs(p - 0.5) <= central; }

/// sqrt(-ln of the smaller side), which may be subnormal.
inline double depth(double p) {
  constexpr double ln2_54 = 37.429947750237048;
  const double q = 1.0 - p, side = p < q ? p : q;
  const bool small = side < 0x1p-1000;
  return std::sqrt((small ? ln2_54 : 0.0) - natural_log(small ? side * 0x1p54 : side));
}

inline double in_the_tail(double r) { return polynomial(c, r - 1.6) / polynomial(d, r - 1.6); }
double far_out(double r) { return polynomial(e, r - near) / polynomial(f, r - near); }

/// Three in twenty are in the tails: they are collected, and computed in a loop of their own.
struct Tails {
  std::array<std::size_t, chunk> at;
  std::array<double, chunk> p, r, z;
  std::size_t count = 0;
};

LOADPATH_COLUMNS void middle(const double* p, double* z, Tails& tails, std::size_t n) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    tails.at[count] = i;
    tails.p[count] = p[i];
    count += is_central(p[i]) ? 0 : 1;
  }
  tails.count = count;
  for (std::size_t i = 0; i < n; ++i) z[i] = in_the_middle(p[i]);
}

LOADPATH_COLUMNS void tail(Tails& tails) {
  const std::size_t n = tails.count;
  for (std::size_t i = 0; i < n; ++i) {
    const double r = depth(tails.p[i]);
    tails.r[i] = r;
    tails.z[i] = in_the_tail(r);
  }
}

double with_sign(double size, double p) { return p < 0.5 ? -size : size; }

}  // namespace

double probit(double p) {
  if (is_central(p)) return in_the_middle(p);
  const double r = depth(p);
  return with_sign(r <= near ? in_the_tail(r) : far_out(r), p);
}

void probit(std::span<const double> p, std::span<double> z) {
  Tails tails;
  for (std::size_t first = 0; first < p.size(); first += chunk) {
    middle(p.data() + first, z.data() + first, tails, std::min(chunk, p.size() - first));
    tail(tails);
    for (std::size_t k = 0; k < tails.count; ++k) {
      const double size = tails.r[k] <= near ? tails.z[k] : far_out(tails.r[k]);
      z[first + tails.at[k]] = with_sign(size, tails.p[k]);
    }
  }
}

}  // namespace loadpath::sweep
