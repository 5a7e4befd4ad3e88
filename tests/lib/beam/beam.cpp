// Beams on supports, against closed forms, a double integration of M/EI, equilibrium and superposition.
#include "lib/beam/varying.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace {

using namespace loadpath::beam;
using doctest::Approx;

constexpr double E_I = 5000.0;

Row<Span> spans(std::size_t count, double length, double GA = rigid) {
  return Row<Span>(count, uniform(length / static_cast<double>(count), E_I, GA));
}

Beam beam_of(const Row<Span>& all, const OfSupports<Support>& supports) {
  auto beam = Beam::of(all, supports);
  REQUIRE(beam.has_value());
  return *beam;
}

/// The displacement of a statically determinate beam supported at its first and last node, by integrating M/EI twice
/// in small steps: nothing of the elements in it.
std::vector<double> integrated(const Row<Span>& all, const std::vector<Load>& loads) {
  double length = 0.0, moment = 0.0;
  std::vector<double> x{0.0};
  for (const Span& span : all) x.push_back(length += span.l);
  for (const Load& load : loads) moment += load.F * (length - x[load.node]) - load.M;
  const double at_left = -moment / length;
  constexpr int steps = 4000;
  std::vector<double> v{0.0};
  double slope = 0.0, at = 0.0;
  for (std::size_t s = 0; s < all.size(); ++s) {
    const double h = all[s].l / steps;
    for (int k = 0; k < steps; ++k) {
      const double here = x[s] + (k + 0.5) * h;
      double M = at_left * here;
      for (const Load& load : loads) M += here > x[load.node] ? load.F * (here - x[load.node]) - load.M : 0.0;
      const double curved = M * all[s].bending / all[s].l;
      at += slope * h + curved * h * h / 2.0;
      slope += curved * h;
    }
    v.push_back(at);
  }
  const double tilt = v.back() / length;
  for (std::size_t n = 0; n < v.size(); ++n) v[n] -= tilt * x[n];
  return v;
}

}  // namespace

TEST_SUITE("beam") {
  TEST_CASE("a force in the middle of two supports: F l^3/48 E I, and F l/4 G A of shear") {
    const std::vector<Load> load{{1, -1000.0, 0.0}};
    const LoadedBeam slender = beam_of(spans(2, 2.0), {{0}, {2}}).bend(load);
    CHECK(slender.nodes[1].v == Approx(-1000.0 * 8.0 / 48.0 / E_I));
    CHECK(slender.nodes[0].slope == Approx(-1000.0 * 4.0 / 16.0 / E_I));
    CHECK(slender.reactions[0] == Approx(500.0));
    CHECK(slender.spans[0].right.M == Approx(500.0));
    CHECK(slender.spans[0].left.V == Approx(500.0));
    CHECK(slender.spans[1].right.V == Approx(-500.0));
    const LoadedBeam stout = beam_of(spans(2, 2.0, 1e5), {{0}, {2}}).bend(load);
    CHECK(stout.nodes[1].v == Approx(-1000.0 * 8.0 / 48.0 / E_I - 1000.0 * 2.0 / 4.0 / 1e5));
  }

  TEST_CASE("a uniform load over three supports: 3/8, 10/8, 3/8 of a span, and -q l^2/8 at the middle support") {
    const Row<Span> all = spans(4, 4.0);
    const std::vector<OfEnds> q(4, even(all.front(), -600.0));
    const LoadedBeam bent = beam_of(all, {{0}, {2}, {4}}).bend({}, q);
    CHECK(bent.reactions[0] == Approx(450.0));
    CHECK(bent.reactions[1] == Approx(1500.0));
    CHECK(bent.reactions[2] == Approx(450.0));
    CHECK(bent.spans[1].right.M == Approx(-600.0 * 4.0 / 8.0));
  }

  // A cone from 20 to 40 mm, 1 m long and held at its large end: a force on its small end F l^3/(3 E I) d_2/d, a couple
  // M l/(3 E I) (d_2/d) (1 + d_2/d + (d_2/d)^2), with I of the large end.
  TEST_CASE("a span of varying section is integrated, in one part or in many") {
    const auto section = [](double x) { return std::array{std::pow(0.02 + 0.02 * x, 4.0), rigid}; };
    const double EI = std::pow(0.04, 4.0);
    const std::array<double, 3> even{1.0, 0.0, 0.0}, like_section{1.0, 2.0, 1.0};
    for (const int parts : {2, 3, 8}) {
      std::vector<double> cuts;
      for (int k = 0; k <= parts; ++k) cuts.push_back(static_cast<double>(k) / parts);
      const Span cone = varying(cuts, section, Spread(even)).span;
      const double arm = cone.centre, turned = cone.bending, shifted = cone.shifting;
      CHECK(shifted + arm * arm * turned == Approx(2.0 / (3.0 * EI)).epsilon(1e-10));
      CHECK(turned == Approx(14.0 / (3.0 * EI)).epsilon(1e-10));
    }
    const Span straight = uniform(2.0, E_I, 1e5);
    const std::vector<double> whole{0.0, 2.0};
    const auto same = [](double) { return std::array{E_I, 1e5}; };
    const Varying one = varying(whole, same, Spread({-600.0, 0.0, 0.0}));
    CHECK(one.span.bending == Approx(straight.bending).epsilon(1e-14));
    CHECK(one.span.centre == Approx(straight.centre).epsilon(1e-14));
    CHECK(one.span.shifting == Approx(straight.shifting).epsilon(1e-14));
    for (std::size_t i = 0; i < 4; ++i)
      CHECK(one.along[i] == Approx(loadpath::beam::even(straight, -600.0)[i]).epsilon(1e-12));
    // a load that grows from nothing, q l/2 in all: 3/20, 7/20 of q l at the ends that are held, q l^2/30 and q l^2/20
    const Varying grown = varying(
        whole,
        [](double) {
          return std::array{E_I, rigid};
        },
        Spread({0.0, 300.0, 0.0}));
    CHECK(grown.along[0] == Approx(0.15 * 600.0 * 2.0));
    CHECK(grown.along[1] == Approx(600.0 * 4.0 / 30.0));
    CHECK(grown.along[2] == Approx(0.35 * 600.0 * 2.0));
    CHECK(grown.along[3] == Approx(-600.0 * 4.0 / 20.0));
    CHECK(Spread(like_section).force(1.0) == Approx(1.0 + 1.0 + 1.0 / 3.0));
  }

  TEST_CASE("an overhang, a couple and a spring") {
    const Beam beam = beam_of(spans(3, 3.0), {{0, 2e5}, {2}});
    const LoadedBeam bent = beam.bend(std::vector<Load>{{3, -100.0, 40.0}});
    CHECK(bent.reactions[0] == Approx(-(100.0 * 1.0 - 40.0) / 2.0));
    CHECK(bent.reactions[0] + bent.reactions[1] == Approx(100.0));
    CHECK(bent.nodes[0].v == Approx(-bent.reactions[0] / 2e5));
    CHECK(bent.spans[2].left.M == Approx(-60.0));
    CHECK(bent.spans[2].right.M == Approx(40.0));
  }

  TEST_CASE("an unstable system is not a beam") {
    CHECK_FALSE(Beam::of(spans(3, 3.0), {{1}}).has_value());
    CHECK_FALSE(Beam::of(spans(3, 3.0), {{1}, {1, 5e6}}).has_value());
    CHECK_FALSE(Beam::of(spans(3, 3.0), {}).has_value());
  }

  TEST_CASE("random stepped beams bend as M/EI integrates, balance, and superpose") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> part(0.05, 0.4), stiff(1e3, 1e6), force(-5e3, 5e3);
    for (int k = 0; k < 40; ++k) {
      Row<Span> all;
      for (int s = 0; s < 6; ++s) all.push_back(uniform(part(random), stiff(random)));
      const std::vector<Load> one{{2, force(random), 0.0}, {4, force(random), force(random)}};
      const std::vector<Load> two{{1, force(random), force(random)}, {5, force(random), 0.0}};
      std::vector<Load> both = one;
      both.insert(both.end(), two.begin(), two.end());
      const Beam beam = beam_of(all, {{0}, {6}});
      const LoadedBeam a = beam.bend(one), b = beam.bend(two), sum = beam.bend(both);
      const std::vector<double> expected = integrated(all, both);
      double size = 0.0, forces = 0.0;
      for (const double v : expected) size = std::max(size, std::abs(v));
      for (const Load& load : both) forces += load.F;
      for (std::size_t n = 0; n < expected.size(); ++n) {
        CHECK(std::abs(sum.nodes[n].v - expected[n]) < 1e-6 * size);
        CHECK(std::abs(a.nodes[n].v + b.nodes[n].v - sum.nodes[n].v) < 1e-12 * size);
      }
      CHECK(sum.reactions[0] + sum.reactions[1] == Approx(-forces).epsilon(1e-9));
    }
  }

  TEST_CASE("the first frequency of a uniform bar, and its bounds") {
    constexpr double mass = 12.0, length = 1.5;
    constexpr std::size_t count = 60;
    std::vector<double> masses(count + 1, mass * length / count);
    masses.front() = masses.back() = mass * length / count / 2.0;
    const Frequencies found = frequencies(beam_of(spans(count, length), {{0}, {count}}), masses);
    const double exact = std::numbers::pi * std::numbers::pi * std::sqrt(E_I / (mass * std::pow(length, 4.0)));
    CHECK(found.lowest == Approx(exact).epsilon(1e-5));
    CHECK(found.rayleigh >= found.lowest);
    CHECK(found.rayleigh == Approx(exact).epsilon(0.005));
    CHECK(found.dunkerley < found.lowest);
    // Of each mass alone 48 EI/(m l^3) and so on: the sum of 1/w^2 is m l^4/(90 E I) for the uniform bar.
    CHECK(found.dunkerley == Approx(std::sqrt(90.0 * E_I / (mass * std::pow(length, 4.0)))).epsilon(1e-3));
  }

  TEST_CASE("a symmetric beam on three supports vibrates antisymmetrically, lower than when bent by its weights") {
    std::vector<double> masses(41, 0.0);
    masses[10] = masses[30] = 5.0;
    const Frequencies found = frequencies(beam_of(spans(40, 2.0), {{0}, {20}, {40}}), masses);
    CHECK(found.lowest == Approx(std::sqrt(48.0 * E_I / 5.0)));  // each field by itself: 48 E I/l^3, l = 1 m
    CHECK(found.rayleigh > 1.4 * found.lowest);
    CHECK(found.dunkerley < found.lowest);
  }

  TEST_CASE("one mass: the three methods agree; no mass: no frequency") {
    std::vector<double> masses(3, 0.0);
    const Beam beam = beam_of(spans(2, 2.0), {{0}, {2}});
    CHECK(frequencies(beam, masses).lowest == 0.0);
    masses[1] = 25.0;
    const Frequencies found = frequencies(beam, masses);
    const double exact = std::sqrt(48.0 * E_I / (25.0 * 8.0));
    CHECK(found.lowest == Approx(exact));
    CHECK(found.rayleigh == Approx(exact));
    CHECK(found.dunkerley == Approx(exact));
  }
}
