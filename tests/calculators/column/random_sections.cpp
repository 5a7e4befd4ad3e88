// Open sections drawn at random that bend and twist at once, and bars under eccentric forces, against finite elements.
#include "calculators/column/torsional.hpp"
#include "tests/calculators/column/elements.hpp"
#include "tests/calculators/column/models.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace loadpath;
using namespace loadpath::tests;
using column::Ends;

class Dice {
 public:
  explicit Dice(unsigned seed) : bits_(seed) {}
  double between(double a, double b) { return a + (b - a) * static_cast<double>(bits_()) / 4294967296.0; }
  std::size_t below(std::size_t count) { return bits_() % count; }

 private:
  std::mt19937 bits_;
};

/// Freedoms of an end: deflection or twist, slope or warping.
struct Clamps {
  bool start, start_slope, end, end_slope;
};

constexpr std::array all_ends{Ends::pinned_pinned, Ends::fixed_free,   Ends::fixed_pinned,
                              Ends::fixed_fixed,   Ends::fixed_guided, Ends::pinned_guided};
Clamps clamps_of(Ends ends) {
  switch (ends) {
    case Ends::fixed_free:
      return {true, true, false, false};
    case Ends::fixed_pinned:
      return {true, true, true, false};
    case Ends::fixed_fixed:
      return {true, true, true, true};
    case Ends::fixed_guided:
      return {true, true, false, true};
    case Ends::pinned_guided:
      return {true, false, false, true};
    default:
      return {true, false, true, false};
  }
}
bool sways(Ends ends) { return !clamps_of(ends).end; }

/// What bends and twists: second moments about the axis of symmetry and the other, constants of twisting, offset of
/// the shear centre, polar radius about it squared; moduli.
struct Walls {
  double I_s, I_o, I_t, I_w, e, i_2, E;
};

/// Bending about the axis of symmetry and twisting about the shear centre share the axial force, the bending about
/// the other axis does not take part: three fields of deflection, slope, twist and warping.
double critical_force(const Walls& of, double l, Clamps about_s, Clamps about_o, Clamps twist, int elements) {
  Elements bar;
  bar.add(l, 1.0, 1.0, 1.0, elements);
  const Matrix bends = bending_matrix(bar), pushes = force_matrix(bar);
  const Eigen::Index size = bar.freedoms();
  Matrix stiffness = Matrix::Zero(3 * size, 3 * size), forces = stiffness;
  stiffness.block(0, 0, size, size) = of.E * of.I_s * bends;
  stiffness.block(size, size, size, size) = of.E * of.I_w * bends + of.E / 2.6 * of.I_t * pushes;
  stiffness.block(2 * size, 2 * size, size, size) = of.E * of.I_o * bends;
  forces.block(0, 0, size, size) = forces.block(2 * size, 2 * size, size, size) = pushes;
  forces.block(0, size, size, size) = forces.block(size, 0, size, size) = of.e * pushes;
  forces.block(size, size, size, size) = of.i_2 * pushes;
  std::vector<bool> is_held(static_cast<std::size_t>(3 * size), false);
  std::size_t first = 0;
  for (const Clamps& c : {about_s, twist, about_o}) {
    const std::size_t last = first + static_cast<std::size_t>(size) - 2;
    is_held[first] = c.start, is_held[first + 1] = c.start_slope;
    is_held[last] = c.end, is_held[last + 1] = c.end_slope;
    first += static_cast<std::size_t>(size);
  }
  return critical_factor(stiffness, forces, is_held);
}

double rectangle(double b, double h) { return b * h * h * h / 12.0; }

/// A channel, a tee or an angle of equal legs, of rectangles, in mm; z is the axis along the web.
column::Buckling::Input some_section(Dice& dice) {
  column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
  in.method = column::Method::ec3, in.gamma_M1 = in.gamma_F = 1.0;
  constexpr SectionKind kinds[] = {SectionKind::channel, SectionKind::tee, SectionKind::angle};
  in.kind = kinds[dice.below(3)];
  const double h = dice.between(60, 300), t_w = dice.between(4, 10), t_f = dice.between(5, 14);
  const double b = in.kind == SectionKind::angle ? h : dice.between(40, 0.6 * h + 40);
  double A = 0, I_y = 0, I_z = 0;
  if (in.kind == SectionKind::channel) {
    const double web = h - 2 * t_f;
    A = 2 * b * t_f + web * t_w;
    const double y = (b * b * t_f + web * t_w * t_w / 2) / A;
    I_y = rectangle(b, h) - rectangle(b - t_w, web);
    I_z = 2 * (rectangle(t_f, b) + b * t_f * (b / 2 - y) * (b / 2 - y)) + rectangle(web, t_w) +
          web * t_w * (y - t_w / 2) * (y - t_w / 2);
  } else {
    const double t = in.kind == SectionKind::tee ? t_w : t_f, web = h - t_f;
    A = b * t_f + web * t;
    const double z = (b * t_f * t_f / 2 + web * t * (t_f + web / 2)) / A;
    I_y = rectangle(b, t_f) + b * t_f * (z - t_f / 2) * (z - t_f / 2) + rectangle(t, web) +
          web * t * (t_f + web / 2 - z) * (t_f + web / 2 - z);
    I_z = rectangle(t_f, b) + rectangle(web, t);
  }
  if (in.kind == SectionKind::angle) {
    I_z = I_y;
    const double c = (h * h / 2 + (h - t_f) * t_f / 2) / (2 * h - t_f);  // of the centroid from the back of a leg
    const double product =
        h * t_f * (h / 2 - c) * (t_f / 2 - c) + (h - t_f) * t_f * (t_f / 2 - c) * ((h + t_f) / 2 - c);
    in.I_min = (I_y - std::abs(product)) * mm4.one;
  }
  in.A = A * mm2.one, in.I_y = I_y * mm4.one, in.I_z = I_z * mm4.one;
  in.h = h * mm, in.b = b * mm, in.t_f = t_f * mm;
  in.t_w = (in.kind == SectionKind::angle ? t_f : t_w) * mm;
  in.l = dice.between(0.5, 6.0) * m, in.P = 1.0 * kN;
  return in;
}

Walls walls_of(const column::Buckling::Input& in) {
  const column::Twisting twist = column::twisting_of(in);
  const double I_y = in_si(in.I_y), I_z = in_si(in.I_z), e = in_si(twist.e);
  const bool angle = in.kind == SectionKind::angle, channel = in.kind == SectionKind::channel;
  const double I_s = angle ? I_y + I_z - in_si(in.I_min) : channel ? I_y : I_z;
  return {I_s, I_y + I_z - I_s, in_si(twist.I_t), in_si(twist.I_w), e, (I_y + I_z) / in_si(in.A) + e * e, 210e9};
}

/// Takes z, the sectorial coordinate and the area of every piece of the middle line of a channel, from the tip of its
/// upper flange to that of the lower; the pole lies e outside of the middle of the web.
template <class Take>
void along_walls(const column::Buckling::Input& in, double e, const Take& take) {
  const double b = in_si(in.b) - in_si(in.t_w) / 2, h = in_si(in.h) - in_si(in.t_f);
  const double t_f = in_si(in.t_f), t_w = in_si(in.t_w);
  const std::array<std::array<double, 3>, 4> corners{
      {{b, h / 2, 0}, {0, h / 2, t_f}, {0, -h / 2, t_w}, {b, -h / 2, t_f}}};
  double omega = 0;
  for (std::size_t wall = 1; wall < 4; ++wall) {
    constexpr int steps = 4000;
    const std::array<double, 3>&p = corners[wall - 1], &q = corners[wall];
    const double dy = (q[0] - p[0]) / steps, dz = (q[1] - p[1]) / steps;
    for (int i = 0; i < steps; ++i) {
      const double y = p[0] + (i + 0.5) * dy + e, z = p[1] + (i + 0.5) * dz, grows = y * dz - z * dy;
      take(z, omega + grows / 2, std::hypot(dy, dz) * q[2]);
      omega += grows;
    }
  }
}

/// Of a channel, from the middle line of its web.
double centroid_from_middle(const column::Buckling::Input& in) {
  const double b = in_si(in.b), t_f = in_si(in.t_f), t_w = in_si(in.t_w), web = in_si(in.h) - 2 * t_f;
  return (b * b * t_f + web * t_w * t_w / 2) / (2 * b * t_f + web * t_w) - t_w / 2;
}

double smallest(const column::Buckling::Result& r) {
  return std::min({in_si(r.N_crTF), in_si(r.axes[0].N_cr), in_si(r.axes[1].N_cr)});
}

}  // namespace

TEST_SUITE("column random sections") {
  TEST_CASE("bending and twisting with ends of one kind: the smallest eigenvalue of a hundred open sections") {
    Dice dice(21);
    int twisting = 0;
    for (int number = 0; number < 100; ++number) {
      column::Buckling::Input in = some_section(dice);
      in.ends = all_ends[dice.below(all_ends.size())];
      const double beta = column::length_factor(in.ends, column::Basis::exact);
      in.l_T = beta * in.l;
      CAPTURE(number);
      const column::Buckling::Result r = solve(in);
      const Clamps clamps = clamps_of(in.ends);
      const Walls walls = walls_of(in);
      const double force = extrapolated(
          [&](int refined) { return critical_force(walls, in_si(in.l), clamps, clamps, clamps, 6 * refined); });
      CHECK(rel(smallest(r), force) < 2e-5);
      twisting += in_si(r.N_crTF) < 0.999 * std::min(in_si(r.axes[0].N_cr), in_si(r.axes[1].N_cr));
    }
    CHECK(twisting > 40);
  }

  TEST_CASE("with ends that differ for bending and twisting it is a lower bound, at most a tenth below") {
    Dice dice(22);
    double lowest = 1.0;
    for (int number = 0; number < 100; ++number) {
      column::Buckling::Input in = some_section(dice);
      in.ends_y = all_ends[dice.below(all_ends.size())];
      in.ends_z = in.kind == SectionKind::angle ? in.ends_y : all_ends[dice.below(all_ends.size())];
      CAPTURE(number);
      const bool loose = sways(in.ends_y) || sways(in.ends_z);
      const Clamps twist = clamps_of(loose ? Ends::fixed_free : Ends::pinned_pinned);
      const bool about_y = in.kind == SectionKind::channel;
      const Clamps about_s = clamps_of(about_y ? in.ends_y : in.ends_z),
                   about_o = clamps_of(about_y ? in.ends_z : in.ends_y);
      const Walls walls = walls_of(in);
      const double force = extrapolated(
          [&](int refined) { return critical_force(walls, in_si(in.l), about_s, about_o, twist, 6 * refined); });
      const double ratio = smallest(solve(in)) / force;
      CHECK(ratio < 1.0 + 2e-5);
      lowest = std::min(lowest, ratio);
    }
    CHECK(lowest > 0.9);
  }

  TEST_CASE("shear centre and warping constant of channels, by integration of the sectorial coordinate") {
    Dice dice(23);
    for (int number = 0; number < 20; ++number) {
      const column::Buckling::Input in = some_section(dice);
      if (in.kind != SectionKind::channel) continue;
      double A = 0, I_y = 0, I_wz = 0, mean = 0, I_w = 0;
      along_walls(in, 0.0, [&](double z, double w, double dA) { A += dA, I_y += z * z * dA, I_wz += w * z * dA; });
      const double e = std::abs(I_wz / I_y);  // of the shear centre from the middle line of the web, outwards
      along_walls(in, e, [&](double, double w, double dA) { mean += w * dA / A; });
      along_walls(in, e, [&](double, double w, double dA) { I_w += (w - mean) * (w - mean) * dA; });
      const column::Twisting twist = column::twisting_by_walls(in);
      CHECK(rel(in_si(twist.e), e + centroid_from_middle(in)) < 1e-5);
      CHECK(rel(in_si(twist.I_w), I_w) < 1e-5);
    }
  }
}

namespace {

/// Largest deflection and moment of a bar under F with a moment F e at each end that may turn, and a bow of e_0.
struct LoadedBeam {
  double deflection, moment;
};
LoadedBeam bent(double EI, double l, Ends ends, double F, double e, double e_0) {
  constexpr int count = 48;
  Elements bar;
  bar.add(l, EI, 1.0, 1.0, count);
  const Matrix bends = bending_matrix(bar), system = bends - F * force_matrix(bar);
  const Eigen::Index size = bar.freedoms();
  const Clamps c = clamps_of(ends);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(size), bow = load;
  if (!c.start_slope) load(1) += F * e;
  if (!c.end_slope) load(size - 1) -= ends == Ends::fixed_free ? -F * e : F * e;
  const double part = ends == Ends::pinned_pinned ? pi : pi / 2;  // of a half wave, over the bar
  for (Eigen::Index i = 0; i <= count; ++i) {
    const double a = part * static_cast<double>(i) / count;
    const bool foot = ends == Ends::fixed_free;
    bow(2 * i) = e_0 * (foot ? 1 - std::cos(a) : std::sin(a));
    bow(2 * i + 1) = e_0 * part / l * (foot ? std::sin(a) : std::cos(a));
  }
  load += F * force_matrix(bar) * bow;
  const std::vector<std::pair<Eigen::Index, bool>> ties{
      {0, c.start}, {1, c.start_slope}, {size - 2, c.end}, {size - 1, c.end_slope}};
  Matrix held = system;
  for (const auto& [freedom, tied] : ties) {
    if (!tied) continue;
    held.row(freedom).setZero(), held.col(freedom).setZero();
    held(freedom, freedom) = 1.0, load(freedom) = 0.0;
  }
  const Eigen::VectorXd v = deflected(held, load);
  LoadedBeam most{0, 0};
  const double h = l / count;
  for (Eigen::Index i = 0; i < count; ++i) {
    const double curvature = (-6 * v(2 * i) - 4 * h * v(2 * i + 1) + 6 * v(2 * i + 2) - 2 * h * v(2 * i + 3)) / (h * h);
    most.deflection = std::max(most.deflection, std::abs(v(2 * i + 2)));
    most.moment = std::max(most.moment, std::abs(EI * curvature));
  }
  return most;
}

}  // namespace

TEST_SUITE("column random eccentric bars") {
  TEST_CASE("deflection under an eccentric force and with a bow: a hundred bars by finite elements") {
    Dice dice(24);
    for (int number = 0; number < 100; ++number) {
      constexpr std::array ends{Ends::pinned_pinned, Ends::fixed_free, Ends::pinned_guided, Ends::fixed_pinned};
      column::Buckling::Input in = bar_of_steel(ends[dice.below(ends.size())]);
      const double l = dice.between(0.4, 3.0), b = dice.between(0.04, 0.1), h = dice.between(0.02, 0.039);
      in.l = from_si<Length>(l), in.b = from_si<Length>(b), in.h = from_si<Length>(h);
      const double EI = 210e9 * b * h * h * h / 12, beta = column::length_factor(in.ends, column::Basis::exact);
      const double F = dice.between(0.02, 0.95) * pi * pi * EI / (beta * beta * l * l);
      const bool held = in.ends == Ends::fixed_pinned;
      const double e = dice.between(0.0005, 0.01), e_0 = held ? 0.0 : dice.between(0.0, 0.004);
      in.method = column::Method::secant, in.e_y = from_si<Length>(e), in.e_0y = from_si<Length>(e_0);
      in.P = from_si<Force>(F);
      CAPTURE(number);
      const column::AxisResult y = solve(in).axes[0];
      const LoadedBeam elements = bent(EI, l, in.ends, F, e, e_0);
      if (held) {  // the hinged bar of the effective length is an upper bound of one whose fixed end carries a part
        CHECK(F * (e + in_si(y.w)) > 0.999 * elements.moment);
      } else {
        CHECK(rel(in_si(y.w), elements.deflection) < 2e-5);
      }
    }
  }
}
