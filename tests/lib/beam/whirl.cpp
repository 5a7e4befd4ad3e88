// Whirling shafts against closed forms: an overhung disc, a disc in the middle, a bar with its own inertia; and what
// holds of any shaft.
#include "lib/beam/whirl.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace {

using namespace loadpath::beam;
using doctest::Approx;
using std::numbers::pi;

constexpr double E_I = 5000.0;

Beam beam_of(const Row<Span>& all, const OfSupports<Support>& supports) {
  auto beam = Beam::of(all, supports);
  REQUIRE(beam.has_value());
  return *beam;
}

/// A disc at the end of an overhang c beyond two bearings a apart, on a shaft without mass: what a force and a couple
/// on it displace and turn it.
struct Overhung {
  double a, c;
  Inertia disc;
  [[nodiscard]] Whirl whirl() const {
    Row<Inertia> inertias(3);
    inertias[2] = disc;
    return {beam_of({uniform(a, E_I), uniform(c, E_I)}, {{0}, {1}}), inertias};
  }
  [[nodiscard]] double by_force() const { return c * c * (a + c) / (3.0 * E_I); }
  [[nodiscard]] double across() const { return c * (2.0 * a + 3.0 * c) / (6.0 * E_I); }
  [[nodiscard]] double by_couple() const { return (a + 3.0 * c) / (3.0 * E_I); }
  /// The determinant of 1 - flexibility times inertia, which is 0 at a frequency; D: the term in place of w^2 I_d.
  [[nodiscard]] double rest(double w, double D) const {
    const double m = w * w * disc.m;
    return (1.0 - by_force() * m) * (1.0 - by_couple() * D) - across() * across() * m * D;
  }
  /// The squares of critical speeds with the moment of inertia D = I_d - I_p or I_d + I_p; the first is the lower one
  /// that is above zero.
  [[nodiscard]] std::pair<double, double> squares(double D) const {
    const double a_2 = disc.m * D * (by_force() * by_couple() - across() * across());
    const double a_1 = by_force() * disc.m + by_couple() * D, root = std::sqrt(a_1 * a_1 - 4.0 * a_2);
    return {2.0 / (a_1 + root), (a_1 + root) / (2.0 * a_2)};
  }
};

/// Five spans, three supports of which one is elastic, and anything at the nodes.
Whirl random_shaft(std::mt19937& random) {
  std::uniform_real_distribution<double> part(0.1, 1.0);
  Row<Span> spans;
  for (int s = 0; s < 5; ++s) {
    const double l = part(random), EI = 1e5 * part(random);
    spans.push_back(uniform(l, EI, 1e8 * part(random)));
  };
  Row<Inertia> inertias;
  for (int n = 0; n < 6; ++n) {
    const double I_d = 0.5 * part(random);
    inertias.push_back({20.0 * part(random), I_d, 1.9 * part(random) * I_d});
  }
  return {beam_of(spans, {{0}, {2, 1e6 * part(random)}, {4}}), inertias};
}

constexpr auto both = {Sense::forward, Sense::backward};

}  // namespace

TEST_SUITE("whirl") {
  TEST_CASE("an overhung disc: critical speeds by the quadratic of its two degrees of freedom") {
    for (const double I_p : {0.0, 0.3, 0.49, 0.51, 0.8, 1.0}) {
      const Overhung overhung{0.7, 0.4, {30.0, 0.5, I_p}};
      const Whirl whirl = overhung.whirl();
      CAPTURE(I_p);
      CHECK(whirl.critical(0, Sense::forward) == Approx(std::sqrt(overhung.squares(0.5 - I_p).first)).epsilon(1e-10));
      const auto backward = overhung.squares(0.5 + I_p);
      CHECK(whirl.critical(0, Sense::backward) == Approx(std::sqrt(backward.first)).epsilon(1e-10));
      CHECK(whirl.critical(1, Sense::backward) == Approx(std::sqrt(backward.second)).epsilon(1e-10));
      // A flat disc has no second one forward: it rights itself, the faster the more.
      CHECK(whirl.below(1e9, Sense::forward) == (I_p < 0.5 ? 2 : 1));
      if (I_p < 0.5) {
        CHECK(whirl.critical(1, Sense::forward) ==
              Approx(std::sqrt(overhung.squares(0.5 - I_p).second)).epsilon(1e-10));
      } else {
        CHECK(std::isnan(whirl.critical(1, Sense::forward)));
      }
    }
  }

  TEST_CASE("an overhung disc at a speed: the determinant of both degrees of freedom vanishes at each frequency") {
    const Overhung overhung{0.7, 0.4, {30.0, 0.5, 0.9}};
    const Whirl whirl = overhung.whirl();
    for (const double spin : {0.0, 50.0, 400.0, 5000.0}) {
      for (const Sense sense : both) {
        for (const std::size_t i : {0u, 1u}) {
          const double w = whirl.natural(i, sense, spin), with = sense == Sense::forward ? 1.0 : -1.0;
          const auto rest = [&](double at) { return overhung.rest(at, 0.5 * at * at - with * 0.9 * spin * at); };
          CHECK(rest(w * (1.0 - 1e-9)) * rest(w * (1.0 + 1e-9)) < 0.0);
        }
        CHECK(whirl.below(1e12, sense, spin) == 2);
      }
    }
  }

  // Tiwari, lectures on rotor dynamics at NPTEL, module 5: a cantilever with I_d = m l^2/3 has frequencies of 0.74 and
  // 2.73 times the root of 3 E I/(m l^3); Den Hartog's quadratic gives 0.7321 and 2.7321.
  TEST_CASE("a cantilever with a disc, as in lecture notes") {
    const double m = 12.0, unit = std::sqrt(3.0 * E_I / m);
    const Whirl whirl = Overhung{1e-5, 1.0, {m, m / 3.0, 0.0}}.whirl();
    CHECK(whirl.natural(0, Sense::forward, 0.0) / unit == Approx(std::sqrt(3.0) - 1.0).epsilon(1e-4));
    CHECK(whirl.natural(1, Sense::forward, 0.0) / unit == Approx(std::sqrt(3.0) + 1.0).epsilon(1e-4));
  }

  TEST_CASE("a disc in the middle does not tilt in the first mode, and only tilts in the second") {
    Row<Inertia> inertias(3);
    const Beam beam = beam_of({uniform(0.5, E_I), uniform(0.5, E_I)}, {{0}, {2}});
    for (const double I_p : {0.0, 0.2, 0.39}) {
      inertias[1] = {25.0, 0.2, I_p};
      const Whirl whirl(beam, inertias);
      for (const Sense sense : both) {
        const double D = sense == Sense::forward ? 0.2 - I_p : 0.2 + I_p;
        CHECK(whirl.critical(0, sense) == Approx(std::sqrt(48.0 * E_I / 25.0)).epsilon(1e-10));
        CHECK(whirl.natural(0, sense, 777.0) == Approx(std::sqrt(48.0 * E_I / 25.0)).epsilon(1e-10));
        if (D > 0.0) CHECK(whirl.critical(1, sense) == Approx(std::sqrt(12.0 * E_I / D)).epsilon(1e-10));
      }
      const double f = whirl.natural(1, Sense::forward, 300.0), b = whirl.natural(1, Sense::backward, 300.0);
      CHECK(f * b == Approx(12.0 * E_I / 0.2).epsilon(1e-9));  // of 0.2 w^2 -+ I_p 300 w - 12 E I = 0
      CHECK(f - b == Approx(I_p * 300.0 / 0.2).epsilon(1e-7));
    }
  }

  TEST_CASE("a bar with its own inertia: k^4 E I over rho A - rho I k^2, and rho A + 3 rho I k^2") {
    constexpr double mass = 12.0, own = 0.02, length = 1.5;
    constexpr std::size_t count = 120;
    const double l = length / count;
    Row<Inertia> inertias(count + 1, Inertia{mass * l, own * l, 2.0 * own * l});
    for (Inertia* end : {&inertias.front(), &inertias.back()}) *end = {mass * l / 2.0, own * l / 2.0, own * l};
    const Whirl whirl(beam_of(Row<Span>(count, uniform(l, E_I)), {{0}, {count}}), inertias);
    for (std::size_t i = 0; i < 3; ++i) {
      const double k = (static_cast<double>(i) + 1.0) * pi / length, square = k * k * k * k * E_I;
      CHECK(whirl.critical(i, Sense::forward) == Approx(std::sqrt(square / (mass - own * k * k))).epsilon(1e-5));
      CHECK(whirl.critical(i, Sense::backward) == Approx(std::sqrt(square / (mass + 3.0 * own * k * k))).epsilon(1e-5));
      CHECK(whirl.natural(i, Sense::forward, 0.0) == Approx(std::sqrt(square / (mass + own * k * k))).epsilon(1e-5));
    }
  }

  TEST_CASE("point masses whirl at the same frequency at any speed, that of the beam at rest") {
    std::vector<double> masses(41, 0.0);
    Row<Inertia> inertias(41);
    for (std::size_t n = 0; n < 41; ++n) inertias[n].m = masses[n] = 0.3 + 0.1 * std::sin(static_cast<double>(n));
    const Beam beam = beam_of(Row<Span>(40, uniform(0.05, E_I, 1e7)), {{4}, {33, 5e5}});
    const double lowest = frequencies(beam, masses).lowest;
    const Whirl whirl(beam, inertias);
    for (const Sense sense : both) {
      CHECK(whirl.critical(0, sense) == Approx(lowest).epsilon(1e-9));
      CHECK(whirl.natural(0, sense, 1e4) == Approx(lowest).epsilon(1e-9));
    }
  }

  TEST_CASE("any shaft: forward above rest above backward, further apart with speed, equal to it where critical") {
    std::mt19937 random(19);
    for (int k = 0; k < 30; ++k) {
      const Whirl whirl = random_shaft(random);
      for (std::size_t i = 0; i < 4; ++i) {
        const double rest = whirl.natural(i, Sense::forward, 0.0);
        CHECK(whirl.natural(i, Sense::backward, 0.0) == Approx(rest).epsilon(1e-9));
        double forward = rest, backward = rest;
        for (const double spin : {100.0, 1000.0, 1e4}) {
          const double f = whirl.natural(i, Sense::forward, spin), b = whirl.natural(i, Sense::backward, spin);
          CHECK(f >= forward * (1.0 - 1e-12));
          CHECK(b <= backward * (1.0 + 1e-12));
          forward = f, backward = b;
        }
        for (const Sense sense : both) {
          const double met = whirl.critical(i, sense);
          if (std::isnan(met)) continue;
          CHECK(whirl.natural(i, sense, met) == Approx(met).epsilon(1e-9));
          CHECK((sense == Sense::forward ? met >= rest * (1.0 - 1e-12) : met <= rest * (1.0 + 1e-12)));
          CHECK(whirl.below(met * (1.0 - 1e-6), sense) == i);
          CHECK(whirl.below(met * (1.0 + 1e-6), sense) == i + 1);
        }
      }
      CHECK(std::isnan(whirl.natural(12, Sense::forward, 100.0)));  // 6 nodes, 2 held: 10 freedoms
    }
  }

  TEST_CASE("a disc of immense inertia clamps the shaft; nothing whirls without mass") {
    Row<Inertia> inertias(4);
    const Row<Span> spans{uniform(0.5, E_I), uniform(0.5, E_I), uniform(0.3, E_I)};
    inertias[1] = {25.0, 0.0, 0.0}, inertias[3] = {1e14, 1e14, 2e14};
    const Whirl clamped(beam_of(spans, {{0}, {2}}), inertias);
    CHECK(clamped.critical(0, Sense::forward) < 1e-4);
    // Held at the left, clamped at the right beyond a support that nothing lets turn: between hinge and that.
    CHECK(clamped.critical(1, Sense::forward) > std::sqrt(48.0 * E_I / 25.0));
    CHECK(clamped.critical(1, Sense::forward) < std::sqrt(768.0 / 7.0 * E_I / 25.0));
    const Whirl bare(beam_of(spans, {{0}, {2}}), Row<Inertia>(4));
    CHECK(std::isnan(bare.critical(0, Sense::forward)));
    CHECK(bare.below(1e12, Sense::backward, 1e3) == 0);
  }
}
