#include "calculators/column/codes/curves.hpp"

#include <cmath>

namespace loadpath::column {

namespace {

/// The place between two at which a rising function is zero.
template <class Function>
double root_between(double low, double high, Function rising) {
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (rising(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double tetmajer_transition(const Material& material) {
  const double a = in_si(material.a_T), b = in_si(material.b_T), c = in_si(material.c_T);
  const double euler = pi * pi * in_si(material.E);
  // The difference times lambda^2 rises from -euler to its first maximum; there or nowhere the curves meet.
  const auto difference = [&](double x) { return x * x * (a + x * (-b + x * c)) - euler; };
  const double square = 9.0 * b * b - 32.0 * a * c;
  const double top = c == 0.0       ? 2.0 * a / (3.0 * b)
                     : square > 0.0 ? (3.0 * b - std::sqrt(square)) / (8.0 * c)
                                    : std::sqrt(euler / a) * 100.0;
  const double high = std::isfinite(top) && top > 0.0 ? top : std::sqrt(euler / a) * 100.0;
  if (!(difference(high) >= 0.0)) return unset<double>;
  return root_between(0.0, high, difference);
}

Stress secant_stress(double lambda, double eta, Stress E, Stress R_e, double eta_0) {
  const double modulus = in_si(E), yield = in_si(R_e);
  const double euler = pi * pi * modulus / (lambda * lambda), most = std::min(yield, euler);
  const auto beyond_yield = [&](double sigma) {
    const double bow = eta_0 > 0.0 ? eta_0 / (1.0 - sigma / euler) : 0.0;  // a straight bar: not 0/0 at Euler's stress
    return sigma * (1.0 + eta / std::cos(0.5 * lambda * std::sqrt(sigma / modulus)) + bow) - yield;
  };
  return from_si<Stress>(root_between(0.0, most, beyond_yield));
}

}  // namespace loadpath::column
