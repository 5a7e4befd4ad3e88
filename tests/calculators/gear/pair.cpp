#include "calculators/gear/pair.hpp"

#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace {

using namespace loadpath;

constexpr auto solve = test::evaluated<gear::Pair>;

using test::rel;

gear::Pair::Input pair_of(int z_1, int z_2, double m_n_mm) {
  gear::Pair::Input in;
  in.z_1 = z_1, in.z_2 = z_2, in.m_n = m_n_mm * mm;
  return in;
}

gear::Pair::Input helical() {
  gear::Pair::Input in = pair_of(20, 57, 2.5);
  in.beta = 12.0 * deg.one;
  in.x_1 = 0.3;
  in.a_w = 100.0 * mm;
  in.b = 28.0 * mm;
  in.T_1 = 60.0 * N_m;
  return in;
}

/// The free length between the tips of wheel and ring, from the derivation.
double tips_of(const gear::Pair::Input& in) {
  Trace trace;
  gear::Pair::evaluate(in, trace);
  for (const Line& line : trace.lines()) {
    if (std::string_view(line.symbol) == "f_t") return line.si;
  }
  return unset<double>;
}

/// The messages of a step with these lines.
std::string issues_of(const std::string& lines) {
  std::vector<Issue> issues;
  project::Project p =
      project::read_project("[g]\ncalculator = \"gear.pair\"\n" + lines, "g.toml", catalogue(), issues);
  if (issues.empty()) project::solve(p, issues);
  std::string all;
  for (const Issue& i : issues) all += i.key + ": " + i.message.text() + " | " + i.hint.text() + "\n";
  return all;
}

bool says(const std::string& lines, const std::string& part) {
  const std::string all = issues_of(lines);
  CAPTURE(all);
  const bool found = all.find(part) != std::string::npos;
  CHECK(found);
  return found;
}

}  // namespace

TEST_SUITE("gear pair") {
  TEST_CASE("teeth that no profile shift can make have no bending stress and no figure") {
    gear::Pair::Input in = helical();
    in.m_n = 1.0 * mm;
    const auto far = solve(in);
    CHECK(far.x_2 > 100.0);
    CHECK_FALSE(is_set(far.sigma_F1));
    CHECK_FALSE(is_set(far.sigma_F2));
    CHECK(gear::Pair::figures(in, far).empty());
    in = pair_of(5, 2000, 1.0);
    in.x_1 = in.x_2 = 3.0, in.b = 10.0 * mm, in.T_1 = 1.0 * N_m;
    in.a_w = 0.945 * 1002.5 * mm;  // so close that the tips are shortened to nothing
    const auto none = solve(in);
    CHECK(none.q_a < 0.0);
    CHECK_FALSE(is_set(none.sigma_F1));
  }

  TEST_CASE("a strength of running gears without a tooth finish: no velocity factor, which is reported") {
    const std::string runs =
        "z_1 = 20\nz_2 = 57\nm_n = \"2.5 mm\"\nb = \"28 mm\"\nT_1 = \"60 N*m\"\nsigma_adm_1 = \"200 MPa\"\n"
        "n_1 = \"1450 rpm\"\n";
    CHECK(says(runs, "the tooth finish is not stated"));
    CHECK(issues_of(runs + "cutting = \"hobbed\"\n").empty());
  }

  TEST_CASE("an independent computation by bisection and by intersecting the line of action agrees to ten digits") {
    const auto r = solve(helical());
    CHECK(rel(r.alpha_wt / deg.one, 22.746235473563463) < 1e-10);
    CHECK(rel(r.x_0, 0.6755442269150281) < 1e-10);
    CHECK(rel(r.k, 0.035657129218654604) < 1e-9);
    CHECK(rel(r.d_a1 / mm, 57.43874409715819) < 1e-10);
    CHECK(rel(r.d_a2 / mm, 152.38297025674854) < 1e-10);
    CHECK(rel(r.eps_alpha, 1.462942221534522) < 1e-10);
  }

  TEST_CASE("a ring gear of 24 teeth with a pinion of 16 and the shift of [KHK-internal]") {
    gear::Pair::Input in = pair_of(16, 24, 3);
    in.mesh = gear::Mesh::internal;
    in.x_2 = -0.516;
    in.shortening = gear::Shortening::none;
    const auto r = solve(in);
    CHECK(rel(r.a_w / mm, 13.19995222789809) < 1e-10);
    CHECK(rel(r.alpha_wt / deg.one, 31.32091716585931) < 1e-10);
    CHECK(rel(r.d_a2 / mm, 69.096) < 1e-12);
    CHECK(rel(r.eps_alpha, 1.6592491236642055) < 1e-10);
    CHECK(r.f_int > 0.0);
  }

  TEST_CASE("the free length between the tips of pinion and ring gear is that of the drawn circles") {
    gear::Pair::Input in = pair_of(16, 24, 3);
    in.mesh = gear::Mesh::internal;
    in.x_2 = -0.516;
    in.shortening = gear::Shortening::none;
    const auto r = solve(in);
    // Centres on the x axis, the ring's in the origin, the wheel's at a_w; the tip circles cross above the axis.
    const double a = r.a_w / mm, r_1 = 0.5 * r.d_a1 / mm, r_2 = 0.5 * r.d_a2 / mm;
    const double x = (a * a + r_2 * r_2 - r_1 * r_1) / (2.0 * a), y = std::sqrt(r_2 * r_2 - x * x);
    const auto inv = [](double alpha) { return std::tan(alpha) - alpha; };
    const auto behind = [&](double d_b, double d_a) { return inv(std::acos(d_b / d_a)) - inv(r.alpha_wt); };
    // From the pitch point a flank's tip lags by the difference of its involutes, and goes on to the crossing.
    const double wheel = std::atan2(y, x - a) + behind(r.d_b1 / mm, r.d_a1 / mm);
    const double ring = std::atan2(y, x) + behind(r.d_b2 / mm, r.d_a2 / mm);
    const double apart = (wheel * 16.0 / 24.0 - ring) * r_2 / 3.0;
    REQUIRE(apart < 10.0);
    CHECK(std::abs(std::min(apart, r.f_int) - r.f_int) < 1e-9);
    CHECK(std::abs(tips_of(in) - apart) < 1e-9);
  }

  TEST_CASE("profile shifts give the centre distance, and the centre distance the shifts") {
    gear::Pair::Input in = pair_of(17, 43, 4);
    in.beta = 15.0 * deg.one;
    in.x_1 = 0.4, in.x_2 = 0.1;
    const auto forth = solve(in);
    in.a_w = forth.a_w, in.x_2 = unset<double>;
    CHECK(std::abs(solve(in).x_2 - 0.1) < 1e-12);
  }

  TEST_CASE("geometry scales with the module") {
    const auto small = solve(pair_of(19, 40, 1)), large = solve(pair_of(19, 40, 6));
    CHECK(rel(large.a_w / small.a_w, 6) < 1e-12);
    CHECK(rel(large.W_1 / small.W_1, 6) < 1e-12);
    CHECK(rel(large.eps_alpha, small.eps_alpha) < 1e-12);
  }

  TEST_CASE("gears with equal teeth and without shift share everything equally") {
    const auto r = solve(pair_of(30, 30, 2));
    CHECK(r.d_a1 == r.d_a2);
    CHECK(rel(in_si(r.g_f), in_si(r.g_a)) < 1e-12);
    CHECK(rel(r.a_w / mm, 60) < 1e-12);
  }

  TEST_CASE("a gear with a rack is the limit of a mate with ever more teeth") {
    gear::Pair::Input rack = pair_of(20, 0, 3);
    rack.mesh = gear::Mesh::rack;
    rack.x_1 = 0.2;
    gear::Pair::Input large = pair_of(20, 4000, 3);
    large.x_1 = 0.2;
    CHECK(rel(solve(large).eps_alpha, solve(rack).eps_alpha) < 2e-3);
    CHECK(rel(solve(rack).a_w / mm, 30.6) < 1e-12);
  }

  TEST_CASE("base-tangent lengths: 15.321 mm over 3 teeth of m 2, z 20 (machinecalcs.com); one more tooth adds p_b") {
    gear::Pair::Input in = pair_of(20, 40, 2);
    in.k_W1 = 3;
    const auto r = solve(in);
    CHECK(std::abs(r.W_1 / mm - 15.321) < 5e-4);
    in.k_W1 = 4;
    CHECK(rel((solve(in).W_1 - r.W_1) / mm, 2 * pi * std::cos(pi / 9)) < 1e-12);
    in.k_W1 = 0;
    CHECK(solve(in).k_W1 == 3.0);
  }

  TEST_CASE("tooth thickness 17.8918 mm for m 10, z 12, x 0.3 ([SDP-SI] table 10-1)") {
    gear::Pair::Input in = pair_of(12, 40, 10);
    in.x_1 = 0.3;
    CHECK(std::abs(solve(in).s_n1 / mm - 17.8918) < 5e-5);
  }

  TEST_CASE("undercut begins between 17 and 18 teeth without shift, and 16 are reported as not covered") {
    CHECK(solve(pair_of(18, 60, 2)).x_min1 < 0.0);
    CHECK(solve(pair_of(17, 60, 2)).x_min1 > 0.0);
    CHECK(solve(pair_of(17, 60, 2)).x_free > -0.02);
    CHECK(solve(pair_of(16, 60, 2)).x_free < -0.02);
  }

  TEST_CASE("a large shift makes the tip pointed") {
    gear::Pair::Input in = pair_of(10, 60, 2);
    in.x_1 = 0.5;
    CHECK(solve(in).s_a > 0.2);
    in.x_1 = 1.1;
    CHECK(solve(in).s_a < 0.2);
  }

  TEST_CASE("a ring gear with few teeth more than its pinion interferes with it away from the line of action") {
    gear::Pair::Input in = pair_of(60, 66, 2);
    in.mesh = gear::Mesh::internal;
    CHECK(solve(in).f_int < -0.3);
    // There the tips pass each other; what is left is the tip of the ring in the fillet of the wheel: by hand
    // (sqrt(98^2 - 93.969^2) - 40 sin 20 deg - 60 sin 20 deg + 2/sin 20 deg)/2.
    in.z_2 = 100;
    CHECK(std::abs(solve(in).f_int + 0.2689) < 1e-4);
  }

  TEST_CASE("backlash: a smaller centre distance jams, a larger one and thinner teeth give backlash") {
    gear::Pair::Input in = pair_of(20, 40, 3);
    in.x_2 = 0.0;
    in.a_w = 90.0 * mm;
    CHECK(std::abs(in_si(solve(in).j_bn)) < 1e-15);
    in.a_w = 89.9 * mm;
    CHECK(solve(in).j_bn < 0.0 * mm);
    in.a_w = 90.1 * mm;
    const auto r = solve(in);
    CHECK(rel(r.j_bn / mm, 2 * 0.1 * std::sin(r.alpha_wt)) < 0.02);
    const double involutes = std::tan(r.alpha_wt) - r.alpha_wt - std::tan(pi / 9) + pi / 9;
    CHECK(rel(r.j_bn / mm, 180 * std::cos(pi / 9) * involutes) < 1e-9);  // between flanks of the same base circles
    gear::Pair::Input thin = pair_of(20, 40, 3);
    thin.A_s1 = -0.06 * mm, thin.A_s2 = -0.04 * mm;
    CHECK(rel(solve(thin).j_bn / mm, 0.1 * std::cos(pi / 9)) < 1e-12);
  }

  TEST_CASE("the tooth forces: equilibrium, and directions that follow torque, rotation and hand") {
    gear::Pair::Input in = helical();
    const auto r = solve(in);
    CHECK(rel(in_si(r.F_y1) * in_si(r.d_w1) / 2.0, -60.0) < 1e-12);
    CHECK(r.F_x1 < 0.0 * N);
    CHECK(r.F_z1 > 0.0 * N);  // right hand, driving counter-clockwise: the thumb of the right hand
    CHECK(in_si(r.F_x1 + r.F_x2) == 0.0);
    const double normal = std::hypot(std::hypot(in_si(r.F_x1), in_si(r.F_y1)), in_si(r.F_z1));
    CHECK(rel(normal, in_si(r.F_bn)) < 1e-12);
    in.hand = gear::Hand::left;
    CHECK(solve(in).F_z1 == -r.F_z1);
    in.hand = gear::Hand::right, in.turns = gear::Turns::cw;
    CHECK(solve(in).F_y1 == -r.F_y1);
    CHECK(solve(in).F_z1 == -r.F_z1);
    in.turns = gear::Turns::ccw, in.T_1 = -60.0 * N_m;  // gear 1 is driven
    CHECK(solve(in).F_y1 == -r.F_y1);
    CHECK(solve(in).F_x1 == r.F_x1);
  }

  TEST_CASE("each shaft takes its forces in its own frame: external gears push apart, a ring gear pulls together") {
    for (const auto mesh : {gear::Mesh::external, gear::Mesh::internal}) {
      gear::Pair::Input in = pair_of(20, 57, 2.5);  // d_w1 = 50 mm, d_w2 = 142.5 mm: 2400 N at 20 deg
      in.mesh = mesh, in.T_1 = 60.0 * N_m, in.K_A = 1.25;
      const bool ring = mesh == gear::Mesh::internal;
      const auto r = solve(in);
      const double radial = 1.25 * 2400.0 * std::tan(20.0 * pi / 180.0);
      CHECK(rel(in_si(r.gear_1.F_x), ring ? radial : -radial) < 1e-12);
      CHECK(rel(in_si(r.gear_2.F_x), ring ? radial : -radial) < 1e-12);
      // About axis 1, which turns counter-clockwise, the teeth brake; about axis 2 they drive: a wheel against the
      // rotation of gear 1, a ring with it. The pitch point lies toward the mate, but beyond axis 1 in a ring.
      CHECK(rel((ring ? -1.0 : 1.0) * 0.025 * in_si(r.gear_1.F_y), -75.0) < 1e-12);
      CHECK(rel(0.07125 * in_si(r.gear_2.F_y), (ring ? 1.0 : -1.0) * 75.0 * 57.0 / 20.0) < 1e-12);
      CHECK(in_si(r.gear_1.F_z) == 0.0);
      for (const ShaftLoad& load : {r.gear_1, r.gear_2})
        CHECK(rel(in_si(load.F), std::hypot(in_si(load.F_x), in_si(load.F_y))) < 1e-12);
    }
    const auto r = solve(helical());
    CHECK(r.gear_1.F_z > 0.0 * N);
    CHECK(in_si(r.gear_1.F_z + r.gear_2.F_z) == 0.0);
    CHECK(in_si(r.gear_1.F_x - r.gear_2.F_x) == 0.0);
    CHECK(in_si(r.gear_1.F_y - r.gear_2.F_y) == 0.0);
  }

  TEST_CASE("each factor of the bending stress acts once") {
    gear::Pair::Input in = helical();
    const auto one = solve(in);
    in.K_A = 2.0;
    CHECK(rel(solve(in).sigma_F1 / one.sigma_F1, 2) < 1e-15);
    CHECK(solve(in).F_t == one.F_t);
    in.K_A = 1.0, in.K_f = 1.6;
    CHECK(rel(solve(in).sigma_F2 / one.sigma_F2, 1.6) < 1e-15);
    in.K_f = 1.0, in.cutting = gear::Cutting::milled, in.n_1 = 1450.0 * rpm;
    const auto fast = solve(in);
    CHECK(rel(fast.sigma_F1 / one.sigma_F1, 1.0 + fast.v / m_per_s / 6.1) < 1e-14);
  }

  TEST_CASE("a power is a torque at a speed, and an idler's teeth carry 0.7") {
    gear::Pair::Input in = helical();
    in.sigma_adm_1 = 150.0 * MPa;
    const auto torque = solve(in);
    in.T_1 = unset<Moment>, in.n_1 = 1000.0 * rpm, in.P = 60.0 * N_m.one * in.n_1;
    CHECK(rel(solve(in).sigma_F1 / torque.sigma_F1, 1) < 1e-14);
    in.idler = gear::Idler::gear_1;
    CHECK(rel(solve(in).u_F1, torque.u_F1 / 0.7) < 1e-14);
  }

  TEST_CASE("wrong input is reported") {
    says("z_1 = 20\nm_n = \"2 mm\"\n", "two gears, or a gear and a ring gear, need z_2; a rack has no number of teeth");
    says("mesh = \"internal\"\nz_1 = 40\nz_2 = 30\nm_n = \"2 mm\"\n",
         "a ring gear must have more teeth than its mating gear");
    says("mesh = \"rack\"\nz_1 = 40\nx_2 = 0.2\nm_n = \"2 mm\"\n", "only the position a_w");
    says("z_1 = 20\nz_2 = 40\nm_n = \"2 mm\"\na_w = \"50 mm\"\n", "give more than 56.3816 mm");
    says("z_1 = 20\nz_2 = 20\nm_n = \"2 mm\"\nx_1 = -0.9\n", "closer than their base circles allow");
    says("z_1 = 20\nz_2 = 40\nm_n = \"2 mm\"\nP = \"3 kW\"\n", "a power needs the speed n_1");
    says("z_1 = 20\nz_2 = 40\nm_n = \"2 mm\"\nP = \"3 kW\"\nT_1 = \"3 N*m\"\nn_1 = \"900 rpm\"\n", "not both");
    says("z_1 = 20\nz_2 = 40\nm_n = \"2 mm\"\nsigma_adm_1 = \"100 MPa\"\n", "needs a load");
    says("z_1 = 20\nz_2 = 40\nm_n = \"2 mm\"\ncutting = \"cast\"\n", "the velocity factor needs the speed");
    says("z_1 = 20\nz_2 = 40\nm_n = \"2 mm\"\nb = \"20 mm\"\npsi_m = 10\n", "as b or as psi_m");
    says("z_1 = 3\nz_2 = 40\nm_n = \"2 mm\"\n", "z_1");
    says("z_1 = 20\nz_2 = 40\nm_n = \"-2 mm\"\n", "must be > 0 mm");
    says("z_1 = 20\nz_2 = 40\nm_n = \"2 mm\"\nk_W1 = 25\n",
         "the number of spanned teeth must be less than that of the gear");
  }
}
