#include "calculators/shaft/held/held.hpp"

#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using shaft::AxialTorque;
using shaft::End;
using shaft::Held;
using shaft::Segment;
using shaft::Sleeve;

constexpr auto solve = test::evaluated<Held>;

using test::rel;

Segment segment(double l, double d, double d_2, double b = 0.0, double b_2 = 0.0, double G = 80.0, double m = 0.0) {
  Segment s;
  s.l = l * mm, s.d = d * mm, s.d_2 = d_2 * mm, s.d_bore = b * mm, s.d_bore_2 = b_2 * mm;
  s.G = G * GPa, s.tau_adm = 100.0 * MPa, s.m = m * N;
  return s;
}
AxialTorque torque(double x, double T) { return {{}, x * mm, T * N_m}; }

Held::Input held(End first, End second) {
  Held::Input in;
  in.end_1 = first, in.end_2 = second;
  return in;
}

/// A bar in thin slices, by nothing but 1/(G I_p) in the middle of each: an independent solution in N, mm, rad.
struct Sliced {
  struct Slice {
    double x, dx, C, d, m;  // C: G I_p of all members
    double M = 0.0;
  };
  std::vector<Slice> slices;
  std::vector<double> phi;  // at their ends
  double R_1 = 0.0, tau_max = 0.0, phi_max = 0.0;

  explicit Sliced(const Held::Input& in, int per_segment = 4000) {
    double x = 0.0;
    for (const Segment& s : in.segments) {
      const double l = s.l / mm, dx = l / per_segment;
      for (int i = 0; i < per_segment; ++i) {
        const double t = (i + 0.5) / per_segment, d = (1 - t) * (s.d / mm) + t * (s.d_2 / mm);
        const double b = (1 - t) * (s.d_bore / mm) + t * (s.d_bore_2 / mm);
        double C = s.G / MPa * pi / 32 * (std::pow(d, 4) - std::pow(b, 4));
        for (const Sleeve& sleeve : in.sleeves) {
          const double at = x + (i + 0.5) * dx, from = sleeve.x / mm;
          if (at > from && at < from + sleeve.l / mm)
            C += sleeve.G / MPa * pi / 32 * (std::pow(sleeve.d / mm, 4) - std::pow(sleeve.d_bore / mm, 4));
        }
        slices.push_back({x + i * dx, dx, C, d, s.m / N});
      }
      x += l;
    }
    const double f_1 = in.end_1 == End::elastic ? 1e-3 / (in.c_1 / N_m_per_rad) : 0.0;
    const double f_2 = in.end_2 == End::elastic ? 1e-3 / (in.c_2 / N_m_per_rad) : 0.0;
    double F = 0.0, D = 0.0, Q = 0.0;
    for (Slice& s : slices) {
      double up = Q;
      for (const AxialTorque& t : in.torques) {
        if (t.x / mm <= s.x + s.dx / 2) up += 1e3 * (t.T / N_m);
      }
      s.M = -(up + s.m * s.dx / 2);
      F += s.dx / s.C, D += s.M * s.dx / s.C;
      Q += s.m * s.dx;
    }
    for (const AxialTorque& t : in.torques) Q += 1e3 * (t.T / N_m);
    R_1 = in.end_1 == End::free ? 0.0 : in.end_2 == End::free ? -Q : (D - Q * f_2) / (f_1 + F + f_2);
    double at = in.end_1 == End::free ? (Q + R_1) * f_2 - (D - R_1 * F) : -R_1 * f_1;
    phi.push_back(at);
    for (Slice& s : slices) {
      s.M -= R_1;
      at += s.M * s.dx / s.C;
      phi.push_back(at);
      phi_max = std::max(phi_max, std::abs(at));
    }
    phi_max = std::max(phi_max, std::abs(phi.front()));
  }
};

}  // namespace

TEST_SUITE("shaft held") {
  TEST_CASE("two words mean a fixed end") {
    const std::string bar =
        "[bar]\ncalculator = \"shaft.held\"\nG = \"80 GPa\"\ntau_adm = \"100 MPa\"\nsegments = [{ l = \"1 m\", d = "
        "\"20 mm\" }]\n"
        "torques = [{ x = \"0.5 m\", T = \"10 N*m\" }]\n";
    const test::Solved held_twice(bar + "end_1 = \"held\"\nend_2 = \"held\"\n");
    const test::Solved fixed_twice(bar + "end_1 = \"fixed\"\nend_2 = \"fixed\"\n");
    REQUIRE_MESSAGE(held_twice.errors().empty(), held_twice.errors());
    CHECK(fixed_twice.errors().empty());
    CHECK(fixed_twice.value("bar.tau_max") == held_twice.value("bar.tau_max"));
    CHECK(fixed_twice.word("bar.end_1") == "held");
  }

  TEST_CASE("[MecMovies-6] M6.20: a hollow steel and a solid brass shaft between two walls") {
    auto in = held(End::held, End::held);
    in.segments = {segment(1500, 50, 50, 40, 40, 75), segment(1000, 50, 50, 0, 0, 40)};
    in.torques = {torque(1500, 1000)};
    const auto r = solve(in);
    CHECK(r.R_1 / N_m == doctest::Approx(-424.63).epsilon(2e-5));
    CHECK(r.R_2 / N_m == doctest::Approx(-575.37).epsilon(2e-5));
    CHECK(r.members[0].tau / MPa == doctest::Approx(29.30).epsilon(2e-4));
    CHECK(r.members[1].tau / MPa == doctest::Approx(23.44).epsilon(2e-4));
    CHECK(r.sections[1].phi == doctest::Approx(0.02344).epsilon(2e-4));
    CHECK(r.phi_2 == 0.0);
  }

  TEST_CASE("[MecMovies-6] M6.22: an aluminium tube bonded to a bronze tube; the core governs") {
    auto in = held(End::held, End::free);
    in.segments = {segment(400, 42, 42, 30, 30, 38)};
    in.sleeves = {{{}, 0.0 * mm, 400.0 * mm, 50.0 * mm, 42.0 * mm, 26.0 * GPa, 100.0 * MPa}};
    in.torques = {torque(400, 1003.8 + 1076.0)};
    const auto r = solve(in);
    CHECK(r.members[0].T / N_m == doctest::Approx(1076.0).epsilon(1e-4));
    CHECK(r.members[1].T / N_m == doctest::Approx(1003.8).epsilon(1e-4));
    CHECK(r.members[0].tau / MPa == doctest::Approx(100).epsilon(1e-4));
    CHECK(r.members[1].tau / MPa == doctest::Approx(81.45).epsilon(1e-4));
    CHECK(r.phi_2 == doctest::Approx(0.05012).epsilon(1e-4));
  }

  TEST_CASE("[Gere-3] 3.8-9: at 30.12 in of a bar whose second half is bored both reactions are the same") {
    const double in_ = 25.4;
    auto in = held(End::held, End::held);
    in.segments = {segment(25 * in_, 3 * in_, 3 * in_), segment(25 * in_, 3 * in_, 3 * in_, 2.4 * in_, 2.4 * in_)};
    const double solid = std::pow(3.0, 4), bored = solid - std::pow(2.4, 4);
    const double x = (75 - 25 * bored / solid) / 2 - 0.0;  // 25/I_s + (x - 25)/I_b = (50 - x)/I_b
    CHECK(x == doctest::Approx(30.12).epsilon(2e-4));
    in.torques = {torque(x * in_, 1000)};
    const auto r = solve(in);
    CHECK(r.R_1 / N_m == doctest::Approx(-500).epsilon(1e-12));
  }

  TEST_CASE("[Gere-3] 3.8-7: the reactions of a stepped shaft go with I_p over the length") {
    auto in = held(End::held, End::held);
    in.segments = {segment(300, 50, 50), segment(500, 40, 40)};
    in.torques = {torque(300, 700)};
    const double a = std::pow(50.0, 4) / 300, b = std::pow(40.0, 4) / 500;
    const auto r = solve(in);
    CHECK(r.R_1 / N_m == doctest::Approx(-700 * a / (a + b)).epsilon(1e-12));
    CHECK(r.R_2 / N_m == doctest::Approx(-700 * b / (a + b)).epsilon(1e-12));
  }

  TEST_CASE("a cone from c to 2 c turns by 7 T L/(12 pi G c^4), the answer of a textbook exercise") {
    auto in = held(End::free, End::held);
    in.segments = {segment(500, 40, 80)};
    in.torques = {torque(0, 1000)};
    CHECK(solve(in).phi_1 == doctest::Approx(7 * 1e6 * 500 / (12 * pi * 80e3 * std::pow(20.0, 4))).epsilon(1e-12));
  }

  TEST_CASE("a torque spread over a bar held at both ends: half to each, and m L^2/(8 G I_p) in the middle") {
    auto in = held(End::held, End::held);
    in.segments = {segment(1000, 50, 50, 0, 0, 80, 2000)};
    const auto r = solve(in);
    const double I = pi / 32 * std::pow(50.0, 4);
    CHECK(r.R_1 / N_m == doctest::Approx(-1000).epsilon(1e-12));
    CHECK(r.phi_max == doctest::Approx(2000.0 * 1e6 / (8 * 80e3 * I)).epsilon(1e-12));
    CHECK(r.x_phi / mm == doctest::Approx(500).epsilon(1e-12));
  }

  TEST_CASE("springs between a wall and a free end: stiff ones hold, the weaker end takes less") {
    auto in = held(End::elastic, End::held);
    in.segments = {segment(800, 50, 50)};
    in.torques = {torque(400, 1000)};
    double last = 0.0;
    for (const double c : {1.0, 1e3, 1e5, 1e7, 1e15}) {
      in.c_1 = c * N_m_per_rad.one;
      const auto r = solve(in);
      CHECK(-(r.R_1 / N_m) > last);
      last = -(r.R_1 / N_m);
      CHECK(r.phi_1 == doctest::Approx(last / c).epsilon(1e-12));
    }
    CHECK(last == doctest::Approx(500).epsilon(1e-9));
  }

  TEST_CASE("a torque at a rigid support is taken by it; torques and steps at one position count once") {
    auto in = held(End::held, End::held);
    in.segments = {segment(300, 50, 50), segment(300, 50, 50)};
    in.torques = {torque(0, 5000), torque(300, 400), torque(300, 600), torque(600, -7000)};
    const auto r = solve(in);
    CHECK(r.R_1 / N_m == doctest::Approx(-5500).epsilon(1e-12));
    CHECK(r.R_2 / N_m == doctest::Approx(6500).epsilon(1e-12));
    CHECK(r.M_max / N_m == doctest::Approx(500).epsilon(1e-12));
    CHECK(r.stretches.size() == 2);
  }

  TEST_CASE("the example, by independent quadrature of 1/(G I_p), all digits") {
    const test::ExampleStep example("shaft.held", "");
    CHECK(example("R_1") == doctest::Approx(-793.781752038296).epsilon(1e-12));
    CHECK(example("phi_max") == doctest::Approx(0.324348264177061 * pi / 180).epsilon(1e-12));
    CHECK(example("phi_2") == doctest::Approx(0.158726734771077 * pi / 180).epsilon(1e-12));
  }

  TEST_CASE("random bars agree with their 4000 slices: reactions, rotations, stress") {
    std::mt19937 random(12);
    const auto draw = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
    for (int round = 0; round < 30; ++round) {
      auto in = held(round % 3 == 0 ? End::elastic : End::held, round % 4 == 0 ? End::elastic : End::held);
      if (round % 5 == 0) in.end_2 = End::free;
      if (round % 7 == 0) in.end_1 = End::free, in.end_2 = End::held;
      if (in.end_1 == End::elastic) in.c_1 = draw(1e3, 1e5) * N_m_per_rad.one;
      if (in.end_2 == End::elastic) in.c_2 = draw(1e3, 1e5) * N_m_per_rad.one;
      for (int k = 0; k < 4; ++k) {
        const double d = draw(30, 80), d_2 = k % 2 == 0 ? d : draw(30, 80), b = k < 2 ? 0.0 : draw(0, 25);
        const double b_2 = k == 3 ? draw(0, 25) : b;
        in.segments.push_back(segment(400, d, d_2, b, b_2, draw(20, 90), draw(-2000, 2000)));
      }
      in.sleeves = {{{}, 100.0 * mm, 200.0 * mm, 120.0 * mm, 85.0 * mm, 50.0 * GPa, 100.0 * MPa}};
      in.torques = {torque(200, draw(-900, 900)), torque(800, draw(-900, 900)), torque(1300, draw(-900, 900))};
      const auto r = solve(in);
      const Sliced sliced(in);
      const double size = std::abs(r.M_max / N_m), turned = r.phi_max;
      CAPTURE(round);
      CHECK(std::abs(r.R_1 / N_m - 1e-3 * sliced.R_1) < 1e-6 * size);
      CHECK(std::abs(r.phi_1 - sliced.phi.front()) < 1e-6 * turned);
      CHECK(std::abs(r.phi_2 - sliced.phi.back()) < 1e-6 * turned);
      CHECK(rel(r.phi_max, sliced.phi_max) < 1e-5);
      double tau = 0.0, theta = 0.0;
      for (std::size_t i = 0; i < sliced.slices.size(); ++i) {
        const auto& s = sliced.slices[i];
        theta = std::max(theta, std::abs(s.M) / s.C);
        if (i / 4000 == 3) tau = std::max(tau, std::abs(s.M) / s.C * s.d / 2 * (in.segments[3].G / MPa));
      }
      CHECK(rel(r.members[3].tau / MPa, tau) < 2e-3);
      CHECK(rel(in_si(r.theta_max), 1e3 * theta) < 2e-3);
    }
  }

  TEST_CASE("along a cone under a distributed torque the largest stress may be inside") {
    auto in = held(End::held, End::free);
    in.segments = {segment(600, 80, 20, 0, 0, 80, 1000)};
    const auto r = solve(in);
    // M = m (l - x), d = 80 - 60 x/l: M/d^3 is the largest where 3 (l - x) 60/l = d, at the free end's side
    double tau = 0.0, at = 0.0;
    for (int i = 0; i <= 600000; ++i) {
      const double x = i * 1e-3, d = 80 - 0.1 * x, t = 16 * 1000 * (600 - x) / (pi * d * d * d);
      if (t > tau) tau = t, at = x;
    }
    CHECK(r.members[0].tau / MPa == doctest::Approx(tau).epsilon(1e-9));
    CHECK(r.members[0].x / mm == doctest::Approx(at).epsilon(1e-4));
    CHECK(at > 400);
    CHECK(at < 590);
  }

  TEST_CASE("a bore in proportion and one almost in proportion give the same cone") {
    auto exact = held(End::held, End::free), close = exact;
    exact.torques = close.torques = {torque(500, 1000)};
    exact.segments = {segment(500, 80, 40, 40, 20)};
    close.segments = {segment(500, 80, 40, 40, 20 + 1e-8)};
    CHECK(rel(solve(close).phi_2, solve(exact).phi_2) < 1e-8);
    exact.segments = {segment(500, 80, 40)};
    close.segments = {segment(500, 80, 40, 1e-4, 1e-4)};
    CHECK(rel(solve(close).phi_2, solve(exact).phi_2) < 1e-12);
  }

  TEST_CASE("an error message for a bar names the reason") {
    const auto fault = [](const std::string& lines) { return test::ExampleStep("shaft.held", lines).fault(); };
    CHECK(fault("end_1 = \"free\"\nend_2 = \"free\"\nc_2 = ")
              .find("at least one end must be fixed; for free ends use shaft.torsion") != std::string::npos);
    CHECK(fault("c_1 = \"1 kN*m/rad\"").find("elastic") != std::string::npos);
    CHECK(fault("tau_adm = \"50 MPa\"").find("one of them") != std::string::npos);
    CHECK(fault("behaviour = ").find("sigma_adm with behaviour") != std::string::npos);
    CHECK(fault("torques = [{ x = \"901 mm\", T = \"1 N*m\" }]").find("the bar ends at 900 mm") != std::string::npos);
    const std::string bush = "l = \"150 mm\", d = \"75 mm\", d_bore = \"60 mm\", G = \"27 GPa\"";
    CHECK(fault("sleeves = [{ x = \"100 mm\", " + bush + " }]").find("another material") != std::string::npos);
    CHECK(fault("sleeves = [{ x = \"200 mm\", " + bush + ", tau_adm = \"30 MPa\" }]").find("cylindrical") !=
          std::string::npos);
    CHECK(fault("sleeves = [{ x = \"800 mm\", " + bush + ", tau_adm = \"30 MPa\" }]").find("beyond") !=
          std::string::npos);
    CHECK(fault("sleeves = [{ x = \"0 mm\", l = \"90 mm\", d = \"75 mm\", d_bore = \"59 mm\" }]")
              .find("two members overlap") != std::string::npos);
    CHECK(fault("segments = [{ l = \"1 m\", d = \"40 mm\", d_2 = \"20 mm\", d_bore = \"20 mm\" }]\nsleeves = \n"
                "torques = ")
              .find("bore must be smaller") != std::string::npos);
  }
}
