#include "lib/sweep/point/distribution.hpp"

#include "lib/simd/attributes.hpp"
#include "lib/sweep/point/elementary.hpp"
#include "lib/sweep/point/probit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <type_traits>

namespace loadpath::sweep {

namespace {

using std::numbers::pi, std::numbers::sqrt2;

// ---- values to probabilities: p, and q = 1 - p where it may be known better ----------------------------------------

inline double value(const Uniform& law, double p, double) {
  const double x = law.min + (law.max - law.min) * p;
  return x < law.max ? x : law.max;
}

inline double value(const Triangular& law, double p, double q) {
  const double breadth = law.max - law.min, rise = law.mode - law.min, fall = law.max - law.mode;
  const double rising = law.min + std::sqrt(p * breadth * rise), falling = law.max - std::sqrt(q * breadth * fall);
  return p * breadth < rise ? rising : falling;
}

/// By t = -ln(1 - p).
inline double value(const Weibull& law, double t) {
  return law.location + law.scale * exponential(natural_log(t) / law.shape);
}

inline double value(const Weibull& law, double p, double q) {
  return value(law, p < 0.5 ? log_of_survival(p) : -natural_log(q));
}

/// The transformation of a column of probabilities: `at(p)` for each.
template <class At>
LOADPATH_COLUMNS void each(const double* p, double* x, std::size_t n, const At& at) {
  for (std::size_t i = 0; i < n; ++i) x[i] = at(p[i]);
}

struct Sides {
  double p, q;
};
/// The two sides of a standard normal variable.
Sides sides(double z) {
  const double smaller = 0.5 * std::erfc(std::min(std::abs(z), 37.0) / sqrt2);
  return z < 0.0 ? Sides{smaller, 1.0 - smaller} : Sides{1.0 - smaller, smaller};
}

// ---- refusals -------------------------------------------------------------------------------------------------------

Message refusal_of(const Normal& law) { return law.sd > 0.0 ? Message{} : say("the standard deviation must be > 0"); }
Message refusal_of(const Uniform& law) { return law.min < law.max ? Message{} : say("min must be below max"); }

Message refusal_of(const Triangular& law) {
  if (!(law.min < law.max)) return say("min must be below max");
  return law.min <= law.mode && law.mode <= law.max ? Message{} : say("the mode must lie between min and max");
}

Message refusal_of(const Lognormal& law) {
  if (!(law.mean > 0.0)) return say("the mean of a lognormal distribution must be > 0");
  return law.sd > 0.0 ? Message{} : say("the standard deviation must be > 0");
}

Message refusal_of(const Weibull& law) {
  if (!(law.scale > 0.0)) return say("the scale of a Weibull distribution must be > 0");
  return law.shape > 0.0 ? Message{} : say("the shape of a Weibull distribution must be > 0");
}

std::array<double, 3> parameters(const Law& law) {
  return std::visit(
      [](const auto& of) -> std::array<double, 3> {
        using Of = std::decay_t<decltype(of)>;
        if constexpr (std::is_same_v<Of, Uniform>)
          return {of.min, of.max, 0.0};
        else if constexpr (std::is_same_v<Of, Triangular>)
          return {of.min, of.mode, of.max};
        else if constexpr (std::is_same_v<Of, Weibull>)
          return {of.scale, of.shape, of.location};
        else
          return {of.mean, of.sd, 0.0};
      },
      law);
}

// ---- densities and moments -----------------------------------------------------------------------------------------

double normal_density(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * pi); }

double density_of(const Triangular& law, double x) {
  const double breadth = law.max - law.min;
  if (x < law.min || x > law.max) return 0.0;
  if (x < law.mode) return 2.0 * (x - law.min) / (breadth * (law.mode - law.min));
  return law.mode < law.max ? 2.0 * (law.max - x) / (breadth * (law.max - law.mode)) : 2.0 / breadth;
}

double cumulative_of(const Triangular& law, double x) {
  const double breadth = law.max - law.min, below = x - law.min, above = law.max - x;
  if (below <= 0.0) return 0.0;
  if (above <= 0.0) return 1.0;
  return x < law.mode ? below * below / (breadth * (law.mode - law.min))
                      : 1.0 - above * above / (breadth * (law.max - law.mode));
}

double density_of(const Weibull& law, double x) {
  const double ratio = (x - law.location) / law.scale;
  if (ratio < 0.0) return 0.0;
  return law.shape / law.scale * std::pow(ratio, law.shape - 1.0) * std::exp(-std::pow(ratio, law.shape));
}

double cumulative_of(const Weibull& law, double x) {
  const double ratio = (x - law.location) / law.scale;
  return ratio > 0.0 ? -std::expm1(-std::pow(ratio, law.shape)) : 0.0;
}

double mean_of(const Weibull& law) { return law.location + law.scale * std::tgamma(1.0 + 1.0 / law.shape); }

double sd_of(const Weibull& law) {
  const double first = std::tgamma(1.0 + 1.0 / law.shape), second = std::tgamma(1.0 + 2.0 / law.shape);
  return law.scale * std::sqrt(second - first * first);
}

double sd_of(const Triangular& law) {
  const double rise = law.mode - law.min, fall = law.max - law.mode;
  return std::sqrt((rise * rise + rise * fall + fall * fall) / 18.0);
}

}  // namespace

Message refusal(const Law& law) {
  for (const double parameter : parameters(law)) {
    if (!std::isfinite(parameter)) return say("the parameters of a distribution must be numbers");
  }
  Message refused = std::visit([](const auto& of) { return refusal_of(of); }, law);
  if (!refused.empty()) return refused;
  const Distribution made(law);
  for (const double reached : {made.of_normal(-37.0), made.of_normal(37.0), made.mean(), made.sd()}) {
    if (!(std::abs(reached) < 1e300)) return say("these parameters give values outside the range of numbers");
  }
  return {};
}

Distribution::Distribution(const Law& law) : law_(law) {
  if (const auto* of = std::get_if<Lognormal>(&law)) {
    const double ratio = of->sd / of->mean, variance = std::log1p(ratio * ratio);
    log_mean_ = std::log(of->mean) - 0.5 * variance;
    log_sd_ = std::sqrt(variance);
  }
}

double Distribution::quantile(double p) const {
  double x = 0.0;
  quantile({&p, 1}, {&x, 1});
  return x;
}

void Distribution::quantile(std::span<const double> p, std::span<double> x) const {
  if (std::holds_alternative<Normal>(law_) || std::holds_alternative<Lognormal>(law_)) {
    probit(p, x);
    of_normal(x, x);
  } else if (const auto* even = std::get_if<Uniform>(&law_)) {
    each(p.data(), x.data(), p.size(), [law = *even](double u) { return value(law, u, 1.0 - u); });
  } else if (const auto* triangle = std::get_if<Triangular>(&law_)) {
    each(p.data(), x.data(), p.size(), [law = *triangle](double u) { return value(law, u, 1.0 - u); });
  } else {
    each(p.data(), x.data(), p.size(), [law = std::get<Weibull>(law_)](double u) { return value(law, u, 1.0 - u); });
  }
}

double Distribution::of_normal(double z) const {
  double x = 0.0;
  of_normal({&z, 1}, {&x, 1});
  return x;
}

void Distribution::of_normal(std::span<const double> z, std::span<double> x) const {
  if (const auto* normal = std::get_if<Normal>(&law_)) {
    each(z.data(), x.data(), z.size(), [law = *normal](double at) { return law.mean + law.sd * at; });
  } else if (std::holds_alternative<Lognormal>(law_)) {
    each(z.data(), x.data(), z.size(),
         [mean = log_mean_, sd = log_sd_](double at) { return exponential(mean + sd * at); });
  } else {
    const auto through = [&](const auto& law) {
      for (std::size_t i = 0; i < z.size(); ++i) {
        const Sides at = sides(z[i]);
        x[i] = value(law, at.p, at.q);
      }
    };
    if (const auto* even = std::get_if<Uniform>(&law_)) through(*even);
    if (const auto* triangle = std::get_if<Triangular>(&law_)) through(*triangle);
    if (const auto* weibull = std::get_if<Weibull>(&law_)) through(*weibull);
  }
}

double Distribution::density(double x) const {
  if (const auto* of = std::get_if<Normal>(&law_)) return normal_density((x - of->mean) / of->sd) / of->sd;
  if (const auto* of = std::get_if<Uniform>(&law_)) return x < of->min || x > of->max ? 0.0 : 1.0 / (of->max - of->min);
  if (const auto* of = std::get_if<Triangular>(&law_)) return density_of(*of, x);
  if (const auto* of = std::get_if<Weibull>(&law_)) return density_of(*of, x);
  return x > 0.0 ? normal_density((std::log(x) - log_mean_) / log_sd_) / (log_sd_ * x) : 0.0;
}

double Distribution::cumulative(double x) const {
  if (const auto* of = std::get_if<Normal>(&law_)) return sides((x - of->mean) / of->sd).p;
  if (const auto* of = std::get_if<Uniform>(&law_)) return std::clamp((x - of->min) / (of->max - of->min), 0.0, 1.0);
  if (const auto* of = std::get_if<Triangular>(&law_)) return cumulative_of(*of, x);
  if (const auto* of = std::get_if<Weibull>(&law_)) return cumulative_of(*of, x);
  return x > 0.0 ? sides((std::log(x) - log_mean_) / log_sd_).p : 0.0;
}

double Distribution::mean() const {
  if (const auto* of = std::get_if<Normal>(&law_)) return of->mean;
  if (const auto* of = std::get_if<Uniform>(&law_)) return 0.5 * of->min + 0.5 * of->max;
  if (const auto* of = std::get_if<Triangular>(&law_)) return (of->min + of->mode + of->max) / 3.0;
  if (const auto* of = std::get_if<Weibull>(&law_)) return mean_of(*of);
  return std::get<Lognormal>(law_).mean;
}

double Distribution::sd() const {
  if (const auto* of = std::get_if<Normal>(&law_)) return of->sd;
  if (const auto* of = std::get_if<Uniform>(&law_)) return (of->max - of->min) / std::sqrt(12.0);
  if (const auto* of = std::get_if<Triangular>(&law_)) return sd_of(*of);
  if (const auto* of = std::get_if<Weibull>(&law_)) return sd_of(*of);
  return std::get<Lognormal>(law_).sd;
}

}  // namespace loadpath::sweep
