#include "calculators/fatigue/cycle_of.hpp"

namespace loadpath::fatigue {

namespace {

constexpr Stress zero = from_si<Stress>(0.0);

Objection of_stresses(const Given& g) {
  if (is_set(g.sigma_max) && is_set(g.sigma_min) && g.sigma_max < g.sigma_min) {
    return {"sigma_max is below sigma_min", "stresses are signed: swap them"};
  }
  if (is_set(g.sigma_max) && is_set(g.sigma_m) && g.sigma_max < g.sigma_m) {
    return {"sigma_max is below the mean", "stresses count with their sign"};
  }
  if (is_set(g.sigma_min) && is_set(g.sigma_m) && g.sigma_min > g.sigma_m) {
    return {"sigma_min is above the mean", "stresses count with their sign"};
  }
  NoTrace off;
  const Extremes e = from_stresses(g, off);
  if (e.sigma_max == zero && e.sigma_min == zero) return {"both stresses are zero: no cycle", ""};
  return {};
}

Objection of_max(Stress sigma_max, double r) {
  if (std::isinf(r)) {
    return {"for infinite r sigma_max is zero and does not determine the cycle",
            "give sigma_min, sigma_m or sigma_a with r"};
  }
  if (sigma_max > zero && r > 1.0) return {"with r > 1 both stresses are compressions: sigma_max must be negative", ""};
  if (sigma_max < zero && r < 1.0) return {"a negative sigma_max needs r >= 1: sigma_min is a larger compression", ""};
  return {};
}

Objection of_min(Stress sigma_min, double r) {
  if (r == 0.0) {
    return {"for r = 0 sigma_min is zero and does not determine the cycle",
            "give sigma_max, sigma_m or sigma_a with r"};
  }
  if (sigma_min == zero) return {"sigma_min = 0 occurs only at r = 0", "give sigma_max in place of r"};
  const bool tension = sigma_min > zero;
  if (tension && !(r > 0.0 && r <= 1.0)) return {"a positive sigma_min needs 0 < r <= 1: sigma_max is larger", ""};
  if (!tension && r > 0.0 && r < 1.0) return {"a negative sigma_min needs r < 0 or r >= 1, or an infinite r", ""};
  return {};
}

Objection of_mean(Stress sigma_m, double r) {
  if (r == -1.0) {
    return {"a fully reversed cycle, r = −1, has no mean stress: sigma_m does not determine the cycle",
            "give sigma_max, sigma_min or sigma_a with r"};
  }
  if (sigma_m == zero) return {"a mean stress of zero occurs only at r = −1", "give sigma_a in place of sigma_m"};
  if (sigma_m > zero && !(r > -1.0 && r <= 1.0)) return {"a positive mean stress needs -1 < r <= 1", ""};
  if (sigma_m < zero && r > -1.0 && r < 1.0)
    return {"a negative mean stress needs r < -1 or r >= 1, or an infinite r", ""};
  return {};
}

Objection of_amplitude(Stress sigma_a, double r) {
  if (r == 1.0) {
    return {"a static stress, r = 1, has no amplitude: sigma_a does not determine the cycle",
            "give sigma_max or sigma_m with r"};
  }
  if (sigma_a == zero) return {"an amplitude of zero occurs only at r = 1", "give sigma_m in place of sigma_a"};
  return {};
}

}  // namespace

int count(const Given& g) {
  return is_set(g.sigma_max) + is_set(g.sigma_min) + is_set(g.sigma_m) + is_set(g.sigma_a) + is_set(g.r);
}

namespace {

/// A typed field of the cycle, as the position of the message.
std::string typed(const Given& g) {
  if (is_set(g.r)) return "r";
  if (is_set(g.sigma_min)) return "sigma_min";
  return is_set(g.sigma_max) ? "sigma_max" : is_set(g.sigma_a) ? "sigma_a" : "sigma_m";
}

}  // namespace

Objection objection(const Given& g) {
  if (count(g) != 2) return {};  // another rule says so
  if (!is_set(g.r)) return of_stresses(g);
  if (is_set(g.sigma_max)) return of_max(g.sigma_max, g.r);
  if (is_set(g.sigma_min)) return of_min(g.sigma_min, g.r);
  return is_set(g.sigma_m) ? of_mean(g.sigma_m, g.r) : of_amplitude(g.sigma_a, g.r);
}

FieldFault wrong_count(const Given& g, const std::string& place) {
  const int n = count(g);
  return {n == 0 ? "" : place + typed(g),
          say("a cycle needs exactly two of sigma_max, sigma_min, sigma_m, sigma_a and r; given here: {1}",
              std::to_string(n)),
          n < 2 ? say("give one more value that determines the cycle") : say("leave the rest out")};
}

FieldFault unsound(const Given& g, const std::string& place) {
  const Objection o = objection(g);
  return {place + typed(g), say(o.reason), *o.remedy == '\0' ? Message{} : say(o.remedy)};
}

}  // namespace loadpath::fatigue
