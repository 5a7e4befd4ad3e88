#include "calculators/belt/flat.hpp"

#include "tests/calculators/belt/steps.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath;
using test::BeltStep;
using test::rel;
using test::with;

belt::Flat::Input fan() {
  belt::Flat::Input in;
  in.P = 15e3 * W;
  in.n_1 = 1450.0 * rpm;
  in.d_1 = 200.0 * mm, in.d_2 = 500.0 * mm, in.a = 1200.0 * mm;
  in.mu = 0.4;
  in.delta = 2.5 * mm;
  in.rho = 1100.0 * kg_per_m3;
  in.sigma_adm = 6.0 * MPa;
  return in;
}

/// A motor of 400 kg, 300 mm from a pivot at this distance from the line of centres.
belt::Flat::Input on_pivot(double h_P) {
  belt::Flat::Input in = fan();
  in.K_A = 1.2, in.b = 100.0 * mm;
  in.tensioning = belt::Flat::Tensioning::pivoted_base;
  in.m_m = 400.0 * kg, in.a_G = 300.0 * mm, in.h_P = 1000.0 * h_P * mm;
  return in;
}

constexpr auto solve = test::evaluated<belt::Flat>;

const std::string text = R"(calculator = "belt.flat"
P = "15 kW"
n_1 = "1450 rpm"
d_1 = "200 mm"
d_2 = "500 mm"
a = "1200 mm"
mu = 0.4
delta = "2.5 mm"
b = "160 mm"
rho = "1100 kg/m^3"
sigma_adm = "6 MPa"
)";

}  // namespace

TEST_SUITE("belt flat") {
  TEST_CASE("at the minimum width with the minimum tension, stress and friction are both at their limit") {
    for (const auto arrangement : {belt::Arrangement::open, belt::Arrangement::crossed}) {
      belt::Flat::Input in = fan();
      in.arrangement = arrangement;
      in.E_b = 80.0 * MPa;
      const auto r = solve(in);
      CHECK(rel(r.u_sigma, 1.0) < 1e-12);
      CHECK(rel(r.u_S, 1.0) < 1e-12);
      CHECK(rel(r.mu_req, in.mu) < 1e-12);
    }
  }

  TEST_CASE("tight and slack side differ by the transmitted force, and add up to their sum at standstill") {
    belt::Flat::Input in = fan();
    in.b = 160.0 * mm;
    in.S_0 = 900.0 * N;
    const auto r = solve(in);
    CHECK(rel(in_si(r.S_1 - r.S_2), in_si(r.F_t)) < 1e-12);
    CHECK(rel(in_si(r.S_1 + r.S_2), 1800.0) < 1e-12);
    in.tensioning = belt::Flat::Tensioning::constant_force;
    const auto pulled = solve(in);
    CHECK(rel(in_si(pulled.S_1 + pulled.S_2), 1800.0 + 2 * in_si(pulled.F_c)) < 1e-12);
    CHECK(pulled.S_0_min < r.S_0_min);
  }

  TEST_CASE("on a pivoted base the moments of both spans about the pivot balance that of the weight") {
    for (const double h_P : {0.3, -0.3, 0.12}) {
      CAPTURE(h_P);
      belt::Flat::Input in = on_pivot(h_P);
      in.x_P = 50.0 * mm;
      const auto r = solve(in);
      // The arms by the tangent points of the spans, about the pivot.
      const double gamma = std::asin(0.15 / 1.2), side = h_P > 0.0 ? 1.0 : -1.0;
      const auto arm = [&](double span) {
        const double x = -0.1 * std::sin(gamma) - 0.05, y = span * 0.1 * std::cos(gamma) - h_P;
        return side * (x * span * std::sin(gamma) - y * std::cos(gamma));
      };
      CHECK(rel(in_si(r.a_1), arm(1.0)) < 1e-12);
      CHECK(rel(in_si(r.a_2), arm(-1.0)) < 1e-12);
      const double moment = in_si((r.S_1 - r.F_c) * r.a_1 + (r.S_2 - r.F_c) * r.a_2);
      CHECK(rel(moment, 400 * 9.81 * 0.3) < 1e-12);
      CHECK(rel(in_si(r.S_0 * (r.a_1 + r.a_2)), 400 * 9.81 * 0.3) < 1e-12);
      CHECK(rel(in_si(r.S_1 + r.S_2 - 2.0 * r.F_c), in_si(2.0 * r.S_0) + r.k_S * in_si(r.F_t)) < 1e-12);
    }
  }

  TEST_CASE("a pivot on the side of the tight span tensions with the load, and reversed rotation slackens the belt") {
    const auto r = solve(on_pivot(0.3));
    CHECK(rel(in_si(r.S_0_min), 937.7585231045796) < 1e-12);
    CHECK(rel(in_si(r.m_min), 189.6846973980073) < 1e-12);
    CHECK(rel(r.k_S, 0.3359684204526465) < 1e-12);
    CHECK(!is_set(r.u_Sr));
    belt::Flat::Input in = on_pivot(0.3);
    in.rotation = belt::Flat::Rotation::both;
    const auto both = solve(in), reversed = solve(on_pivot(-0.3));
    CHECK(rel(in_si(both.S_0r), 1336.025541206925) < 1e-12);
    CHECK(rel(both.u_Sr, reversed.u_S) < 1e-12);
    CHECK(rel(in_si(both.S_1r), in_si(reversed.S_1)) < 1e-12);
    CHECK(rel(in_si(both.sigma_max), in_si(r.sigma_max)) < 1e-12);  // the tight span of the tensioning direction
  }

  TEST_CASE("the shafts carry the larger load of both directions of rotation") {
    for (const double h_P : {0.3, -0.3}) {
      CAPTURE(h_P);
      belt::Flat::Input in = on_pivot(h_P);
      in.rotation = belt::Flat::Rotation::both;
      const auto both = solve(in), tensioning = solve(on_pivot(0.3));
      CHECK(rel(in_si(both.R), in_si(tensioning.R)) < 1e-12);
      CHECK(rel(in_si(both.shaft_1.F), in_si(tensioning.shaft_1.F)) < 1e-12);
    }
  }

  TEST_CASE("at the minimum mass friction is used in full; a pivot between the spans needs less") {
    belt::Flat::Input in = on_pivot(0.3);
    in.m_m = solve(in).m_min;
    CHECK(rel(solve(in).u_S, 1.0) < 1e-12);
    CHECK(rel(solve(in).mu_req, in.mu) < 1e-12);
    CHECK(rel(in_si(solve(on_pivot(0.09)).m_min), 28.70965846601358) < 1e-12);
    CHECK(in_si(solve(on_pivot(0.05)).S_0_min) == 0.0);  // it grips at any load
    CHECK(solve(on_pivot(0.05)).u_S == 0.0);
  }

  TEST_CASE("incomplete and contradictory inputs of a pivoted base are refused") {
    const std::string base = "tensioning = \"pivoted_base\"\nm_m = \"400 kg\"\na_G = \"300 mm\"\n";
    const auto has = [](const std::string& lines, const char* part) { return BeltStep(text + lines).says(part); };
    CHECK(has(base, "needs its mass m_m and the distances a_G and h_P"));
    CHECK(has("m_m = \"400 kg\"\n", "belong to a pivoted base"));
    CHECK(has("rotation = \"both\"\n", "rotation and x_P belong to a pivoted base"));
    CHECK(has(base + "h_P = \"300 mm\"\nS_0 = \"900 N\"\n", "leave out S_0"));
    CHECK(has(base + "h_P = \"0 mm\"\n", "a pivot on the line of centres"));
  }

  TEST_CASE("the service factor acts once: forces and width increase by it") {
    const auto one = solve(fan());
    belt::Flat::Input in = fan();
    in.K_A = 1.4;
    const auto r = solve(in);
    CHECK(rel(in_si(r.F_t / one.F_t), 1.4) < 1e-12);
    CHECK(rel(in_si(r.b_min / one.b_min), 1.4) < 1e-12);
    CHECK(rel(in_si(r.R / one.R), 1.4) < 1e-12);
  }

  TEST_CASE("power and torque are two ways to give one load") {
    belt::Flat::Input in = fan();
    in.P = unset<Power>;
    in.T_1 = 15e3 / (1450 * pi / 30) * N_m;
    CHECK(rel(in_si(solve(in).F_t), in_si(solve(fan()).F_t)) < 1e-12);
  }

  TEST_CASE("slip slows the driven pulley and does not change the tensions") {
    belt::Flat::Input in = fan();
    in.epsilon = 0.02;
    const auto r = solve(in), straight = solve(fan());
    CHECK(rel(in_si(r.n_2), 1450 * pi / 30 * 200 / 500 * 0.98) < 1e-12);
    CHECK(in_si(r.S_1) == in_si(straight.S_1));
  }

  TEST_CASE("more friction, more wrap or less speed never needs more width") {
    double last = 1e9;
    for (const double mu : {0.1, 0.2, 0.4, 0.8}) {
      belt::Flat::Input in = fan();
      in.mu = mu;
      const double b = in_si(solve(in).b_min);
      CHECK(b < last);
      last = b;
    }
    belt::Flat::Input crossed = fan();
    crossed.arrangement = belt::Arrangement::crossed;
    CHECK(solve(crossed).b_min < solve(fan()).b_min);
  }

  TEST_CASE("the power that a width transmits is largest at v_opt") {
    const auto at = [](double v) {
      belt::Flat::Input in = fan();
      in.n_1 = 2.0 * v * m_per_s / in.d_1;
      in.E_b = 80.0 * MPa;
      return in_si(in.P / solve(in).b_min);
    };
    belt::Flat::Input in = fan();
    in.E_b = 80.0 * MPa;
    const double v = in_si(solve(in).v_opt);
    CHECK(at(v) > at(0.98 * v));
    CHECK(at(v) > at(1.02 * v));
  }

  TEST_CASE("the shaft load on equal pulleys is the sum of the pulls, along the line of centres") {
    belt::Flat::Input in = fan();
    in.d_2 = in.d_1;
    const auto r = solve(in);
    CHECK(rel(in_si(r.R), in_si(r.S_1 + r.S_2 - 2.0 * r.F_c)) < 1e-12);
    CHECK(in_si(r.R_y) == 0.0);
  }

  TEST_CASE("both shafts are pulled to each other by the larger pull of standstill and running") {
    belt::Flat::Input in = fan();
    in.b = 160.0 * mm, in.S_0 = 900.0 * N;
    const double gamma = std::asin(0.15 / 1.2);
    const auto fixed = solve(in);  // centrifugal force relieves the pulleys in running
    in.tensioning = belt::Flat::Tensioning::constant_force;
    const auto pulled = solve(in);  // and here it does not: the lean of the tight span comes on top
    const double F_t = 15e3 / (1450 * pi / 30 * 0.1);
    for (const auto& load : {fixed.shaft_1, fixed.shaft_2}) {
      CHECK(rel(in_si(load.F), 1800.0 * std::cos(gamma)) < 1e-12);
      CHECK(rel(in_si(load.F_x), 1800.0 * std::cos(gamma)) < 1e-12);
      CHECK(in_si(load.F_y) == 0.0);
    }
    for (const auto& load : {pulled.shaft_1, pulled.shaft_2}) {
      CHECK(rel(in_si(load.F_x), 1800.0 * std::cos(gamma)) < 1e-12);
      CHECK(rel(in_si(load.F_y), F_t * std::sin(gamma)) < 1e-12);
      CHECK(rel(in_si(load.F), std::hypot(in_si(load.F_x), in_si(load.F_y))) < 1e-12);
    }
  }

  TEST_CASE("the shaft load leans to the tight side of the smaller driving pulley, and away from it when crossed") {
    CHECK(solve(fan()).R_y > 0.0 * N);
    belt::Flat::Input in = fan();
    in.arrangement = belt::Arrangement::crossed;
    CHECK(solve(in).R_y < 0.0 * N);
  }

  TEST_CASE("the torques about the driving pulley agree with the power: (S_1 - S_2) v is the design power") {
    belt::Flat::Input in = fan();
    in.K_A = 1.3;
    const auto r = solve(in);
    CHECK(rel(in_si((r.S_1 - r.S_2) * r.v), 1.3 * 15e3) < 1e-12);
  }

  TEST_CASE("speeds outside the range of the belt type are not covered, on both sides") {
    CHECK(BeltStep(text).worst() == account::State::pass);
    CHECK(BeltStep(with(text, "n_1", "\"2900 rpm\"")).worst() == account::State::not_covered);
    CHECK(BeltStep(with(with(text, "n_1", "\"2900 rpm\""), "kind", "\"synthetic\"")).value("x_v") < 1.0);
    CHECK(BeltStep(with(text, "n_1", "\"470 rpm\"")).value("v_range") < 5.0);
    CHECK(BeltStep(with(text, "n_1", "\"470 rpm\"")).worst() != account::State::pass);
  }

  TEST_CASE("where bending and centrifugal stress leave nothing there is no width, and the report says so") {
    const BeltStep fast(with(with(text, "b", ""), "sigma_adm", "\"0.2 MPa\""));
    CHECK(fast.worst() != account::State::pass);
    CHECK(std::isnan(fast.value("b_min")));
    CHECK(fast.value("sigma_N") < 0.0);
  }

  TEST_CASE("an initial tension that is too low for the friction fails") {
    CHECK(BeltStep(with(text, "S_0", "\"300 N\"")).worst() == account::State::fail);
    CHECK(BeltStep(with(text, "S_0", "\"1200 N\"")).worst() == account::State::pass);
  }

  TEST_CASE("the life is that of the S-N curve at the maximum stress, with two bends per revolution of the belt") {
    belt::Flat::Input in = fan();
    in.K_A = 1.2, in.b = 100.0 * mm, in.E_b = 40.0 * MPa;
    in.sigma_f = 9.0 * MPa, in.m_f = 6.0;
    const auto r = solve(in);  // by another program
    CHECK(rel(in_si(r.sigma_max), 7672049.388083873) < 1e-12);
    CHECK(rel(r.N_B, 26060738.427795988) < 1e-12);
    CHECK(rel(in_si(r.L_h) / 3600.0, 838.6763834480031) < 1e-12);
    in.sigma_f = r.sigma_max;
    CHECK(rel(solve(in).N_B, 1e7) < 1e-12);
    CHECK(BeltStep(with(with(text, "sigma_f", "\"9 MPa\""), "m_f", "6")).says("needs the bending modulus E_b"));
    CHECK(BeltStep(with(text, "m_f", "6")).says("needs both the fatigue strength sigma_f and the exponent m_f"));
    CHECK(BeltStep(with(text, "L_req", "\"1000 h\"")).says("needs the S-N curve of the belt"));
  }

  TEST_CASE("a quarter-turn drive has the spans, wraps and forces of tangents in space from an independent program") {
    belt::Flat::Input in = fan();
    in.arrangement = belt::Arrangement::quarter_turn;
    in.K_A = 1.2, in.a = 1500.0 * mm, in.b = 100.0 * mm;
    const auto r = solve(in);
    CHECK(rel(in_si(r.L), 4.195445400218905) < 1e-12);
    CHECK(rel(r.alpha_1, 3.2747289811414406) < 1e-12);
    CHECK(rel(r.alpha_2, 3.4718900084190465) < 1e-12);
    CHECK(rel(r.beta_1, 0.13313632755164687) < 1e-9);
    CHECK(rel(r.beta_2, 0.3302973548292537) < 1e-9);
    CHECK(rel(in_si(r.S_0), 1094.2318556332161) < 1e-10);
    CHECK(rel(in_si(r.R), 2040.0019361164661) < 1e-9);
    CHECK(rel(in_si(r.R_0), 2154.0391087644366) < 1e-9);
    const auto &one = r.shaft_1, &two = r.shaft_2;  // standstill is the larger
    CHECK(rel(in_si(one.F_x), 2119.6325756454) < 1e-9);
    CHECK(rel(in_si(one.F_y), 145.25201623449692) < 1e-9);
    CHECK(rel(in_si(one.F_z), 354.88600723239443) < 1e-9);
    CHECK(two.F_x == one.F_x);
    CHECK(two.F_y == one.F_z);
    CHECK(two.F_z == one.F_y);
    // The approximation of handbooks: two hypotenuses and two half circumferences.
    const double handbook = pi / 2 * 0.7 + std::hypot(1.5, 0.2) + std::hypot(1.5, 0.5);
    CHECK(rel(in_si(r.L), handbook) < 5e-4);
  }

  TEST_CASE("wrong input is reported") {
    CHECK(BeltStep(with(text, "a", "")).says("give either the centre distance a or the belt length L"));
    CHECK(BeltStep(with(text, "L", "\"3500 mm\"")).says("give either the centre distance a or the belt length"));
    CHECK(BeltStep(with(text, "a", "\"300 mm\"")).says("the pulleys would touch: their centres are 300 mm apart"));
    CHECK(BeltStep(with(text, "a", "\"300 mm\"")).says("350 mm"));
    CHECK(BeltStep(with(with(text, "a", ""), "L", "\"1500 mm\"")).says("a belt of 1500 mm is too short"));
    CHECK(BeltStep(with(text, "T_1", "\"10 N*m\"")).says("give either P or T_1"));
    CHECK(BeltStep(with(text, "P", "")).says("give either P or T_1"));
    CHECK(BeltStep(with(text, "delta", "\"150 mm\"")).says("thinner than half of the smaller pulley"));
    CHECK(!BeltStep(with(text, "mu", "0")).issues.empty());
    CHECK(!BeltStep(with(text, "epsilon", "1")).issues.empty());
    CHECK(!BeltStep(with(text, "arrangement", "\"twisted\"")).issues.empty());
  }

  TEST_CASE("the same drive in inches and horsepower") {
    const std::string inches =
        with(with(with(text, "d_1", "\"7.874015748031496 in\""), "P", "\"20.11533134341972 hp\""), "rho",
             "\"0.03973984206 lb/in^3\"");
    CHECK(rel(BeltStep(inches).value("S_1"), BeltStep(text).value("S_1")) < 1e-6);
  }
}
