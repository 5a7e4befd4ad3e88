// Bars drawn at random, of every kind of end, support, part and section that the calculators of columns take, against
// the eigenvalues of finite elements.
#include "calculators/column/effective_length.hpp"
#include "calculators/column/stepped/stepped.hpp"
#include "tests/calculators/column/elements.hpp"
#include "tests/calculators/column/models.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace loadpath;
using namespace loadpath::tests;
using column::EffectiveLength;
using column::Ends;
using column::Stepped;

class Chance {
 public:
  explicit Chance(unsigned seed) : bits_(seed) {}
  double between(double a, double b) { return a + (b - a) * static_cast<double>(bits_()) / 4294967296.0; }
  double of_decades(double a, double b) { return std::exp(between(std::log(a), std::log(b))); }
  int number(int first, int last) {
    return first + static_cast<int>(bits_() % static_cast<unsigned>(last - first + 1));
  }
  bool yes(double share = 0.5) { return between(0.0, 1.0) < share; }

 private:
  std::mt19937 bits_;
};

/// Springs of an end in N/m and N m/rad; infinite: held.
struct Spring {
  double across, turning;
};

/// A uniform bar between springs, on rigid supports, under 1 N.
double critical_force(double l, double EI, Spring start, Spring end, const std::vector<double>& supports, int mode) {
  return extrapolated([&](int refined) {
    std::vector<double> at = supports;
    at.push_back(l);
    Elements bar;
    std::vector<std::size_t> on_support;
    for (const double x : at) {
      const double span = x - bar.x.back();
      bar.add(span, EI, 1.0, 1.0, refined * std::max(4, static_cast<int>(std::ceil(20 * span / l))));
      on_support.push_back(bar.x.size() - 1);
    }
    on_support.pop_back();
    std::vector<bool> is_held(2 * bar.x.size(), false);
    for (const std::size_t node : on_support) is_held[2 * node] = true;
    Matrix stiffness = bending_matrix(bar);
    const auto spring = [&](std::size_t freedom, double rate) {
      if (std::isinf(rate)) {
        is_held[freedom] = true;
      } else {
        stiffness(static_cast<Eigen::Index>(freedom), static_cast<Eigen::Index>(freedom)) += rate;
      }
    };
    const std::size_t last = 2 * bar.x.size() - 2;
    spring(0, start.across), spring(1, start.turning), spring(last, end.across), spring(last + 1, end.turning);
    return critical_factor(stiffness, force_matrix(bar), is_held, mode);
  });
}

std::vector<double> some_supports(Chance& chance, double l, int most) {
  std::vector<double> at;
  const int count = chance.number(0, most);
  for (int i = 0; i < count; ++i) at.push_back(l * (i + chance.between(0.2, 0.8)) / count);
  return at;
}

constexpr double held = column::held;

/// An end of any kind, and its springs.
Spring some_end(Chance& chance, EffectiveLength::End& end, Moment& c, Stiffness& k, double EI, double l) {
  using E = EffectiveLength::End;
  constexpr E kinds[] = {E::pinned, E::fixed, E::guided, E::free, E::elastic, E::elastic, E::elastic};
  end = kinds[chance.number(0, 6)];
  if (end == E::pinned) return {held, 0.0};
  if (end == E::fixed) return {held, held};
  if (end == E::guided) return {0.0, held};
  if (end == E::free) return {0.0, 0.0};
  const bool across = chance.yes();
  Spring spring{held, 0.0};
  if (across) k = from_si<Stiffness>(spring.across = chance.of_decades(0.3, 300.0) * EI / (l * l * l));
  if (!across || chance.yes()) c = from_si<Moment>(spring.turning = chance.of_decades(0.1, 100.0) * EI / l);
  return spring;
}

/// Ends of the cases as springs.
std::pair<Spring, Spring> springs_of(Ends ends) {
  const Spring pin{held, 0.0}, clamp{held, held}, free{0.0, 0.0}, guide{0.0, held};
  switch (ends) {
    case Ends::fixed_free:
      return {clamp, free};
    case Ends::fixed_pinned:
      return {clamp, pin};
    case Ends::fixed_fixed:
      return {clamp, clamp};
    case Ends::fixed_guided:
      return {clamp, guide};
    case Ends::pinned_guided:
      return {pin, guide};
    default:
      return {pin, pin};
  }
}

constexpr Ends all_ends[] = {Ends::pinned_pinned, Ends::fixed_free,   Ends::fixed_pinned,
                             Ends::fixed_fixed,   Ends::fixed_guided, Ends::pinned_guided};

/// The factor of all loads of a column, its weight by 9.81 m/s^2 included.
double stepped_factor(const Stepped::Input& in, int refined) {
  double force = 0.0, l = 0.0;
  const auto weight = [&](const Stepped::Part& part) {
    const double own = in.orientation == Stepped::Orientation::vertical ? in_si(in.rho) * 9.81 : 0.0;
    return own * in_si(part.A) + in_si(part.q);
  };
  for (const Stepped::Part& part : in.parts) {
    force += in_si(part.P) + weight(part) * in_si(part.l);
    l += in_si(part.l);
  }
  Elements bar;
  for (const Stepped::Part& part : in.parts) {
    const double above = force - weight(part) * in_si(part.l);
    const int count = refined * std::max(8, static_cast<int>(std::ceil(24 * in_si(part.l) / l)));
    bar.add(in_si(part.l), in_si(in.E) * in_si(part.I), force, above, count);
    force = above - in_si(part.P);
  }
  std::vector<bool> is_held(2 * bar.x.size(), false);
  const std::size_t last = is_held.size() - 2;
  is_held[0] = true, is_held[1] = in.foot == Stepped::Foot::fixed;
  is_held[last] = in.top == Stepped::Top::pinned || in.top == Stepped::Top::fixed;
  is_held[last + 1] = in.top == Stepped::Top::fixed || in.top == Stepped::Top::guided;
  return critical_factor(bending_matrix(bar), force_matrix(bar), is_held);
}

Stepped::Input some_column(Chance& chance) {
  Stepped::Input in;
  in.foot = chance.yes(0.6) ? Stepped::Foot::fixed : Stepped::Foot::pinned;
  in.top = static_cast<Stepped::Top>(chance.number(in.foot == Stepped::Foot::fixed ? 0 : 1, 3));
  in.orientation = chance.yes(0.7) ? Stepped::Orientation::vertical : Stepped::Orientation::horizontal;
  in.E = chance.between(70.0, 210.0) * GPa, in.rho = from_si<Density>(chance.between(2700.0, 7850.0));
  const int count = chance.number(1, 5);
  for (int i = 0; i < count; ++i) {
    Stepped::Part part;
    const double d = chance.between(0.05, 0.2), wall = chance.between(0.0, 0.9);  // tubes
    part.l = chance.between(0.5, 6.0) * m;
    part.A = from_si<Area>(pi / 4 * d * d * (1 - wall * wall));
    part.I = from_si<SecondMoment>(pi / 64 * std::pow(d, 4) * (1 - std::pow(wall, 4)));
    part.P = (chance.yes(0.6) || count == 1 ? chance.between(1.0, 100.0) : 0.0) * kN;
    part.q = (chance.yes(0.4) ? chance.between(0.0, 10.0) : 0.0) * N_per_mm;
    in.parts.push_back(part);
  }
  return in;
}

}  // namespace

TEST_SUITE("column random bars") {
  TEST_CASE("springs, all kinds of ends, supports and modes: the eigenvalues of a hundred bars") {
    Chance chance(11);
    int bars = 0, elastic = 0, supported = 0, swaying = 0;
    while (bars < 100) {
      EffectiveLength::Input in;
      const double l = chance.of_decades(0.2, 20.0), E = chance.between(70e9, 210e9), I = chance.of_decades(1e-9, 1e-4);
      in.l = from_si<Length>(l), in.E = from_si<Stress>(E), in.I = from_si<SecondMoment>(I);
      const Spring start = some_end(chance, in.end_1, in.c_1, in.k_1, E * I, l);
      const Spring end = some_end(chance, in.end_2, in.c_2, in.k_2, E * I, l);
      const std::vector<double> supports = some_supports(chance, l, 3);
      for (const double x : supports) in.supports.push_back({from_si<Length>(x)});
      const int mode = chance.number(1, 3);
      in.mode = Whole(mode);
      if (!EffectiveLength::is_held(in)) continue;
      ++bars;
      elastic += is_set(in.c_1) || is_set(in.c_2) || is_set(in.k_1) || is_set(in.k_2);
      supported += !supports.empty(), swaying += start.across < held || end.across < held;
      CAPTURE(bars);
      const auto r = test::evaluated<EffectiveLength>(in);
      CHECK(rel(in_si(r.N_cr), critical_force(l, E * I, start, end, supports, 1)) < 5e-6);
      if (mode > 1) CHECK(rel(in_si(r.N_cr_n), critical_force(l, E * I, start, end, supports, mode)) < 3e-5);
    }
    CHECK(std::min({elastic, supported, swaying}) > 40);
  }

  TEST_CASE("parts, loads at the steps and self-weight: the eigenvalues of a hundred columns") {
    Chance chance(12);
    for (int number = 0; number < 100; ++number) {
      const Stepped::Input in = some_column(chance);
      CAPTURE(number);
      const double factor = extrapolated([&](int refined) { return stepped_factor(in, refined); });
      CHECK(rel(test::evaluated<Stepped>(in).alpha_cr, factor) < 5e-6);
    }
  }

  TEST_CASE("each axis by its own ends and supports: the eigenvalues of a hundred flat bars") {
    Chance chance(13);
    for (int number = 0; number < 100; ++number) {
      column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
      const double l = chance.between(0.5, 5.0), b = chance.between(0.02, 0.1), h = chance.between(0.02, 0.1);
      in.l = from_si<Length>(l), in.b = from_si<Length>(b), in.h = from_si<Length>(h), in.P = 1.0 * kN;
      in.ends_y = all_ends[chance.number(0, 5)], in.ends_z = all_ends[chance.number(0, 5)];
      const std::vector<double> at_y = some_supports(chance, l, 2), at_z = some_supports(chance, l, 3);
      for (const double x : at_y) in.supports_y.push_back({from_si<Length>(x)});
      for (const double x : at_z) in.supports_z.push_back({from_si<Length>(x)});
      CAPTURE(number);
      const auto [start_y, end_y] = springs_of(in.ends_y);
      const auto [start_z, end_z] = springs_of(in.ends_z);
      const column::Buckling::Result r = solve(in);
      const double EI_y = 210e9 * b * h * h * h / 12, EI_z = 210e9 * h * b * b * b / 12;
      CHECK(rel(in_si(r.axes[0].N_cr), critical_force(l, EI_y, start_y, end_y, at_y, 1)) < 5e-6);
      CHECK(rel(in_si(r.axes[1].N_cr), critical_force(l, EI_z, start_z, end_z, at_z, 1)) < 5e-6);
    }
  }
}
