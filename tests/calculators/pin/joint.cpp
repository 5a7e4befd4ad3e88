#include "calculators/pin/joint.hpp"

#include "tests/calculators/evaluated.hpp"
#include "tests/found/modes.hpp"
#include "tests/lib/project/texts.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using pin::Joint;

constexpr auto solve = test::evaluated<Joint>;

using test::rel;

/// 50 kN on a pin of 40 mm, an eye of 40 mm between cheeks of 25 mm.
Joint::Input knuckle() {
  Joint::Input in;
  in.F = 50.0 * kN, in.held = Joint::Held::loose, in.d = 40.0 * mm, in.t_1 = 40.0 * mm, in.t_2 = 25.0 * mm;
  return in;
}

/// A force per length that changes evenly from x_0 to x_1; in mm, N.
struct Piece {
  double x_0, x_1, q_0, q_1;
};

/// The largest moment of a beam that these balance on, summed in small steps.
double largest_moment(const std::vector<Piece>& pieces, double l) {
  constexpr int steps = 200000;
  double V = 0.0, M = 0.0, largest = 0.0;
  const double dx = l / steps;
  for (int i = 0; i < steps; ++i) {
    const double x = (i + 0.5) * dx;
    double q = 0.0;
    for (const Piece& p : pieces)
      if (x > p.x_0 && x < p.x_1) q += p.q_0 + (p.q_1 - p.q_0) * (x - p.x_0) / (p.x_1 - p.x_0);
    M += (V + 0.5 * q * dx) * dx;
    V += q * dx;
    largest = std::max(largest, std::abs(M));
  }
  return largest;
}

bool says(const std::string& lines, const std::string& part) {
  std::string all;
  const std::string head = "[k]\ncalculator = \"pin.joint\"\nF = \"1 kN\"\nt_1 = \"20 mm\"\nt_2 = \"10 mm\"\n";
  for (const Issue& i : loadpath::test::told(head + lines).issues)
    all += i.key + ": " + i.message.text() + " | " + i.hint.text() + "\n";
  CAPTURE(all);
  const bool found = all.find(part) != std::string::npos;
  CHECK(found);
  return found;
}

}  // namespace

TEST_SUITE("pin joint") {
  TEST_CASE("[Bhandari-4] example 4.5: the pin needs 38.79 mm, and gets 40 mm") {
    Joint::Input in = knuckle();
    in.spread = Joint::Spread::falling, in.sigma_adm = 80.0 * MPa;
    in.d = 38.79 * mm;
    CHECK(rel(solve(in).u_b, 1.0) < 2e-4);
    in.d = 40.0 * mm;
    CHECK(solve(in).u_b < 1.0);
  }

  TEST_CASE("[RM-9]: factors of the first sizing, 1.6, 1.9, 1.1, 1.4, 1.1 and 1.2") {
    struct Row {
      Joint::Held held;
      double t_1, t_2, k;
    };
    for (const Row& row : {Row{Joint::Held::loose, 1.0, 0.5, 1.6}, Row{Joint::Held::loose, 1.6, 0.6, 1.9},
                           Row{Joint::Held::in_fork, 1.0, 0.5, 1.1}, Row{Joint::Held::in_fork, 1.6, 0.6, 1.4},
                           Row{Joint::Held::in_eye, 1.0, 0.5, 1.1}, Row{Joint::Held::in_eye, 1.6, 0.6, 1.2}}) {
      Joint::Input in = knuckle();
      in.held = row.held, in.t_1 = row.t_1 * in.d, in.t_2 = row.t_2 * in.d;
      const double k = std::sqrt(solve(in).sigma_b * in.d * in.d / in.F);
      CHECK(std::abs(k - row.k) < 0.05);
    }
  }

  TEST_CASE("[Gauthmath-21]: 136 kN shear a pin of 15 mm in two sections at 385 MPa") {
    Joint::Input in = knuckle();
    in.F = 136.0 * kN, in.d = 15.0 * mm;
    CHECK(rel(in_si(solve(in).tau_m), 385e6) < 0.001);
  }

  TEST_CASE("the moment of a loose pin is that of its loads, uniform and decreasing, with a gap") {
    Joint::Input in = knuckle();
    in.c = 1.5 * mm;
    const double F = 50e3, a = 25, b = 40, c = 1.5, l = 2 * a + 2 * c + b;
    const Piece eye{a + c, a + c + b, -F / b, -F / b};
    const double even = largest_moment({{0, a, F / 2 / a, F / 2 / a}, eye, {l - a, l, F / 2 / a, F / 2 / a}}, l);
    CHECK(rel(in_si(solve(in).M_b) * 1e3, even) < 1e-4);
    in.spread = Joint::Spread::falling;
    const double falling = largest_moment({{0, a, 0, F / a}, eye, {l - a, l, F / a, 0}}, l);
    CHECK(rel(in_si(solve(in).M_b) * 1e3, falling) < 1e-4);
    CHECK(falling < even);
  }

  TEST_CASE("a fixed pin bends less than a loose one, and one held on one side most") {
    Joint::Input in = knuckle();
    const auto M = [&](Joint::Held held) {
      in.held = held;
      return solve(in).M_b;
    };
    const auto loose = M(Joint::Held::loose);
    CHECK(M(Joint::Held::in_fork) < loose);
    CHECK(M(Joint::Held::in_eye) < loose);
    CHECK(M(Joint::Held::one_side) > loose);
    CHECK(rel(in_si(solve(in).tau_m / (50.0 * kN / (pi / 4.0 * in.d * in.d))), 1.0) < 1e-12);
  }

  TEST_CASE("shear in the neutral axis: 4/3 of the mean of a solid pin, almost twice the mean of a thin tube") {
    Joint::Input in = knuckle();
    CHECK(rel(in_si(solve(in).tau / solve(in).tau_m), 4.0 / 3.0) < 1e-12);
    in.d_i = 39.9 * mm;
    CHECK(rel(in_si(solve(in).tau / solve(in).tau_m), 2.0) < 0.002);
  }

  TEST_CASE("no point of a section has a larger equivalent stress than its extreme fibre or its neutral axis") {
    for (const double sigma : {0.0, 0.5, 1.0, 2.0, 5.0}) {
      const double most = std::max(sigma, std::sqrt(3.0));  // tau is 1 in the neutral axis, and falls as a parabola
      for (int i = 0; i <= 100; ++i) {
        const double y = i / 100.0, bending = sigma * y, shear = 1.0 - y * y;
        CHECK(std::sqrt(bending * bending + 3.0 * shear * shear) <= most + 1e-12);
      }
    }
    Joint::Input in = knuckle();
    CHECK(solve(in).sigma_v == solve(in).sigma_b);
    in.t_1 = 4.0 * mm, in.t_2 = 2.0 * mm;
    CHECK(rel(in_si(solve(in).sigma_v), std::sqrt(3.0) * in_si(solve(in).tau)) < 1e-12);
  }

  TEST_CASE("allowable stresses follow from R_m and the loading, or are typed") {
    Joint::Input in = knuckle();
    in.R_m = 600.0 * MPa, in.loading = pin::Loading::alternating;
    CHECK(rel(solve(in).u_b, solve(in).sigma_b / (90.0 * MPa)) < 1e-12);
    CHECK(rel(solve(in).u_tau, solve(in).tau / (60.0 * MPa)) < 1e-12);
    in.sigma_adm = 100.0 * MPa;
    CHECK(rel(solve(in).u_v, solve(in).sigma_v / (100.0 * MPa)) < 1e-12);
    CHECK(rel(solve(in).u_tau, solve(in).tau / (60.0 * MPa)) < 1e-12);
  }

  TEST_CASE("pressure times speed is that of the sliding seat") {
    Joint::Input in = knuckle();
    in.n = -60.0 * rpm;
    const auto pv = [&](Joint::Held held) {
      in.held = held;
      return in_si(solve(in).pv);
    };
    const double v = 2.0 * pi * 0.02, p_1 = 50e3 / (0.04 * 0.04), p_2 = 25e3 / (0.04 * 0.025);
    CHECK(rel(pv(Joint::Held::in_fork), p_1 * v) < 1e-12);
    CHECK(rel(pv(Joint::Held::in_eye), p_2 * v) < 1e-12);
    CHECK(rel(pv(Joint::Held::loose), p_1 * v) < 1e-12);
  }

  TEST_CASE("missing and contradictory inputs are reported") {
    says("held = \"loose\"\nd = \"20 mm\"\nd_i = \"20 mm\"\n", "the bore must be smaller than the pin");
    says("held = \"in_eye\"\nd = \"20 mm\"\nspread = \"falling\"\n", "needs a loose pin");
    says("held = \"loose\"\nd = \"20 mm\"\nR_m = \"500 MPa\"\n", "give loading");
    says("held = \"loose\"\nd = \"20 mm\"\npv_adm = \"1 MPa*m/s\"\n", "the pv value needs the speed of rotation n");
    says("d = \"20 mm\"\n", "pin support missing: give held = loose");
  }

  TEST_CASE("must not pass: nothing passes without being assessed") {
    using loadpath::test::mode_with;
    for (const char* id : {"bending", "shear", "eye", "fork", "fatigue"})
      CHECK(mode_with("pin.joint", "", id) == "pass");
    CHECK(mode_with("pin.joint", "F = \"-400 kN\"", "bending") == "fail");
    CHECK(mode_with("pin.joint", "loading = \"steady\"", "variation") == "not-judged");  // K_A shows that it varies
    CHECK(mode_with("pin.joint", "loading = \"steady\"\nK_A = 1", "variation") == "open");
    CHECK(mode_with("pin.joint", "p_adm_1 = ", "eye") == "not-judged");
    CHECK(mode_with("pin.joint", "R_m = ", "bending") == "not-judged");
    CHECK(mode_with("pin.joint", "d_i = \"20 mm\"", "oval") == "not-judged");
    CHECK(mode_with("pin.joint", "n = \"20 rpm\"", "wear") == "not-judged");
    CHECK(mode_with("pin.joint", "n = \"20 rpm\"\npv_adm = \"0.1 MPa*m/s\"", "wear") == "fail");
    CHECK(mode_with("pin.joint", "held = \"one_side\"", "wall") == "not-judged");
    CHECK(mode_with("pin.joint", "F = \"0 N\"", "bending") == "none");
  }
}
