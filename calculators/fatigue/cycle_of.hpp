// The characteristics of a stress cycle from any two of them, and why some pairs do not make one: [B20].
#pragma once

#include "calculators/load/stress_cycle.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/text/issue.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace loadpath::fatigue {

/// Two of these are given. The ratio r = sigma_min/sigma_max may be infinite; both infinities are one point.
struct Given {
  Stress sigma_max = unset<Stress>, sigma_min = unset<Stress>, sigma_m = unset<Stress>, sigma_a = unset<Stress>;
  double r = unset<double>;
};

enum class Kind { symmetric, above, below, constant, alternating, tensile, compressive };

template <class Owner>
constexpr auto given_fields() {
  return Fields{Field<Owner, Stress>{&Owner::sigma_max, "sigma_max", MPa, "maximum stress of the cycle, signed"}
                    .load()
                    .may_be_missing(),
                Field<Owner, Stress>{&Owner::sigma_min, "sigma_min", MPa, "minimum stress of the cycle, signed"}
                    .load()
                    .may_be_missing(),
                Field<Owner, Stress>{&Owner::sigma_m, "sigma_m", MPa, "mean stress, signed"}.load().may_be_missing(),
                Field<Owner, Stress>{&Owner::sigma_a, "sigma_a", MPa, "amplitude"}.load().at_least(0).may_be_missing(),
                Field<Owner, double>{&Owner::r, "r", ratio, "stress ratio sigma_min/sigma_max; may be inf"}
                    .may_be_infinite()
                    .may_be_missing()};
}

/// A cycle as it was found; r is infinite where sigma_max is zero.
struct Characteristics {
  Stress sigma_max = unset<Stress>, sigma_min = unset<Stress>, sigma_m = unset<Stress>, sigma_a = unset<Stress>;
  double r = unset<double>;
  Kind kind = Kind::constant;
};

template <class Owner>
constexpr auto cycle_fields() {
  return Fields{
      Field<Owner, Stress>{&Owner::sigma_max, "sigma_max", MPa, "maximum stress of the cycle, signed"},
      Field<Owner, Stress>{&Owner::sigma_min, "sigma_min", MPa, "minimum stress of the cycle, signed"},
      Field<Owner, Stress>{&Owner::sigma_m, "sigma_m", MPa, "mean stress, signed"},
      Field<Owner, Stress>{&Owner::sigma_a, "sigma_a", MPa, "amplitude"},
      Field<Owner, double>{&Owner::r, "r", ratio, "ratio sigma_min/sigma_max; infinite where sigma_max is zero"}
          .may_be_infinite(),
      Choice<Owner, Kind>{&Owner::kind, "kind", "cycle type"}};
}

/// Why two characteristics do not make a cycle, and what would; empty where they do.
struct Objection {
  const char* reason = "";
  const char* remedy = "";
};
int count(const Given& g);
Objection objection(const Given& g);
/// The same for a user, at a field of the cycle that was typed; `place` is before its keys: "others[2].".
FieldFault wrong_count(const Given& g, const std::string& place);
FieldFault unsound(const Given& g, const std::string& place);

/// Rounding of sums must not decide what kind a cycle is.
inline constexpr double same = 1e-9;

inline Kind kind_of(Stress sigma_max, Stress sigma_min) {
  const double high = in_si(sigma_max), low = in_si(sigma_min), size = std::max(std::abs(high), std::abs(low));
  if (high - low <= same * size) return Kind::constant;
  if (std::abs(high + low) <= same * size) return Kind::symmetric;
  if (std::abs(low) <= same * size) return Kind::above;
  if (std::abs(high) <= same * size) return Kind::below;
  return low > 0.0 ? Kind::tensile : high < 0.0 ? Kind::compressive : Kind::alternating;
}

struct Extremes {
  Stress sigma_max, sigma_min;
};

/// From two stresses.
template <class Tracer>
Extremes from_stresses(const Given& g, Tracer& trace) {
  const bool given_min = is_set(g.sigma_min), given_m = is_set(g.sigma_m);
  if (is_set(g.sigma_max)) {
    const Stress sigma_max = trace.value("sigma_max", g.sigma_max, "as given");
    if (given_min) return {sigma_max, trace.value("sigma_min", g.sigma_min, "as given")};
    if (given_m)
      return {sigma_max, NAMED_STEP("sigma_min", 2.0 * g.sigma_m - g.sigma_max, "mean of maximum and minimum, [B20]")};
    return {sigma_max, NAMED_STEP("sigma_min", g.sigma_max - 2.0 * g.sigma_a, "two amplitudes lower, [B20]")};
  }
  if (given_min) {
    const Stress sigma_min = trace.value("sigma_min", g.sigma_min, "as given");
    if (given_m)
      return {NAMED_STEP("sigma_max", 2.0 * g.sigma_m - g.sigma_min, "mean of maximum and minimum, [B20]"), sigma_min};
    return {NAMED_STEP("sigma_max", g.sigma_min + 2.0 * g.sigma_a, "two amplitudes higher, [B20]"), sigma_min};
  }
  STEP(sigma_max, g.sigma_m + g.sigma_a, "[B20]");
  STEP(sigma_min, g.sigma_m - g.sigma_a, "[B20]");
  return {sigma_max, sigma_min};
}

/// From one stress where r is infinite: sigma_max is zero.
template <class Tracer>
Extremes from_infinite_ratio(const Given& g, Tracer& trace) {
  const Stress sigma_max = trace.value("sigma_max", 0.0 * MPa, "zero, for r is infinite, [B20]");
  if (is_set(g.sigma_min)) return {sigma_max, trace.value("sigma_min", g.sigma_min, "as given")};
  if (is_set(g.sigma_m))
    return {sigma_max, NAMED_STEP("sigma_min", 2.0 * g.sigma_m, "mean of maximum and minimum, [B20]")};
  return {sigma_max, NAMED_STEP("sigma_min", -2.0 * g.sigma_a, "two amplitudes below zero, [B20]")};
}

/// From one stress and the ratio.
template <class Tracer>
Extremes from_ratio(const Given& g, Tracer& trace) {
  const auto r = g.r;
  if (std::isinf(r)) return from_infinite_ratio(g, trace);
  if (is_set(g.sigma_min)) {
    trace.value("sigma_min", g.sigma_min, "as given");
    return {NAMED_STEP("sigma_max", g.sigma_min / r, "by the ratio, [B20]"), g.sigma_min};
  }
  if (is_set(g.sigma_max)) {
    trace.value("sigma_max", g.sigma_max, "as given");
    return {g.sigma_max, NAMED_STEP("sigma_min", r * g.sigma_max, "by the ratio, [B20]")};
  }
  if (is_set(g.sigma_m)) {
    STEP(sigma_max, 2.0 * g.sigma_m / (1.0 + r), "mean and ratio, [B20]");
    STEP(sigma_min, r * sigma_max, "by the ratio, [B20]");
    return {sigma_max, sigma_min};
  }
  STEP(sigma_max, 2.0 * g.sigma_a / (1.0 - r), "amplitude and ratio, [B20]");
  STEP(sigma_min, r * sigma_max, "by the ratio, [B20]");
  return {sigma_max, sigma_min};
}

template <class Tracer>
Characteristics cycle_of(const Given& g, Tracer& trace) {
  const auto [high, low] = is_set(g.r) ? from_ratio(g, trace) : from_stresses(g, trace);
  const Stress sigma_max = high, sigma_min = low;
  STEP(sigma_m, (sigma_max + sigma_min) / 2.0, "mean stress, [B20]");
  STEP(sigma_a, (sigma_max - sigma_min) / 2.0, "amplitude, [B20]");
  const Kind kind = kind_of(sigma_max, sigma_min);
  Characteristics c{sigma_max, sigma_min, sigma_m, sigma_a, std::numeric_limits<double>::infinity(), kind};
  if (kind == Kind::below) {
    trace.value("r", c.r, "infinite: sigma_max is zero, [B20]");
    return c;
  }
  STEP_TO(c, r, sigma_min / sigma_max, "ratio of the cycle, [B20]");
  return c;
}

/// The largest stress over the yield strength R_e; of shear stresses by the distortion-energy theory.
template <class Input, class Tracer>
double part_of_yield(const Input& in, const Characteristics& r, Tracer& trace) {
  STEP(k, in.stress == Stresses::shear ? sqrt(3.0) : 1.0,
       in.stress == Stresses::shear ? "shear by the distortion-energy theory, [Mises]" : "normal");
  return NAMED_STEP("u_y", k * max(abs(r.sigma_max), abs(r.sigma_min)) / in.R_e, "no yielding at the first load");
}

constexpr auto choices_of(Kind) {
  return std::array{
      ChoiceName<Kind>{Kind::symmetric, "symmetric", "r = −1: fully reversed"},
      ChoiceName<Kind>{Kind::above, "pulsating-above", "r = 0: pulsating tension"},
      ChoiceName<Kind>{Kind::below, "pulsating-below", "r infinite: pulsating compression"},
      ChoiceName<Kind>{Kind::constant, "static", "r = 1: static"},
      ChoiceName<Kind>{Kind::alternating, "asymmetric-alternating", "r < 0: alternating, with a mean stress"},
      ChoiceName<Kind>{Kind::tensile, "asymmetric-above", "0 < r < 1: fluctuating tension"},
      ChoiceName<Kind>{Kind::compressive, "asymmetric-below", "r > 1: fluctuating compression"}};
}

}  // namespace loadpath::fatigue
