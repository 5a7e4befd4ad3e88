// The twist as a sum of sines: (K - x H - x^2 G) a = 0, with K of torsion and warping, G of the moment that bends the
// twisted bar about z, H of the load that moves with the twist; x scales the loads. Each form of a that is not zero
// has one positive x at which it vanishes, so the matrix is positive definite up to the smallest root and never after.
#include "calculators/column/bending/critical_moment.hpp"

#include <array>

namespace loadpath::column {

namespace {

constexpr std::size_t terms = 10;
using Matrix = std::array<std::array<double, terms>, terms>;

bool is_positive_definite(Matrix m) {
  for (std::size_t i = 0; i < terms; ++i) {
    if (!(m[i][i] > 0.0)) return false;
    for (std::size_t j = i + 1; j < terms; ++j) {
      const double share = m[j][i] / m[i][i];
      for (std::size_t k = i; k < terms; ++k) m[j][k] -= share * m[i][k];
    }
  }
  return true;
}

/// Integrals of m(x)^2 sin(j pi x) sin(k pi x) over the bar, by Simpson's rule in halves that end at the kink.
Matrix bent(const Moments& moments, double most) {
  constexpr int steps = 128;
  Matrix sum{};
  for (int i = 0; i <= steps; ++i) {
    const double x = static_cast<double>(i) / steps, m = in_si(moments.at(x)) / most;
    const double weight = (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / (3.0 * steps) * m * m;
    std::array<double, terms> sines{};
    for (std::size_t k = 0; k < terms; ++k) sines[k] = std::sin(static_cast<double>(k + 1) * pi * x);
    for (std::size_t j = 0; j < terms; ++j) {
      for (std::size_t k = 0; k < terms; ++k) sum[j][k] += weight * sines[j] * sines[k];
    }
  }
  return sum;
}

/// +1, 0, -1, 0 of the terms 1, 2, 3, 4: the sine at mid-length.
double at_middle(std::size_t k) { return k % 2 == 1 ? 0.0 : k % 4 == 0 ? 1.0 : -1.0; }

}  // namespace

Moment critical_uniform_moment(const Lateral& s, Length l) {
  const auto across = pi * pi * s.E * s.I_z / (l * l);
  return sqrt(across * (s.G * s.I_t + pi * pi * s.E * s.I_w / (l * l)));
}

Moment critical_moment(const Lateral& s, const Moments& moments, Length z_g) {
  const double l = in_si(moments.l), most = in_si(moments.largest());
  const double across = in_si(s.E) * in_si(s.I_z), torsion = in_si(s.G) * in_si(s.I_t);
  const double warping = in_si(s.E) * in_si(s.I_w), arm = in_si(z_g);
  const double q = std::abs(in_si(moments.q)) / most, F = std::abs(in_si(moments.F)) / most;
  const Matrix G = bent(moments, most);
  const auto reduced = [&](double x) {
    Matrix m{};
    for (std::size_t j = 0; j < terms; ++j) {
      const double n = static_cast<double>(j + 1) * pi / l;
      m[j][j] = (torsion * n * n + warping * n * n * n * n) * l / 2.0 - x * q * arm * l / 2.0;
      for (std::size_t k = 0; k < terms; ++k)
        m[j][k] -= x * (x * l / across * G[j][k] + F * arm * at_middle(j) * at_middle(k));
    }
    return m;
  };
  double low = 0.0, high = in_si(critical_uniform_moment(s, moments.l));
  while (is_positive_definite(reduced(high))) low = high, high *= 2.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (is_positive_definite(reduced(middle)) ? low : high) = middle;
  }
  return from_si<Moment>(0.5 * (low + high));
}

}  // namespace loadpath::column
