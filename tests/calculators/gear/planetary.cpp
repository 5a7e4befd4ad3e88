#include "calculators/gear/planetary/planetary.hpp"

#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/lib/project/texts.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

namespace {

using namespace loadpath;
using Member = gear::Planetary::Member;

constexpr auto solve = test::evaluated<gear::Planetary>;

using test::rel;

/// Sun 24, planets 30, ring 84: i_0 = -3.5.
gear::Planetary::Input winch() {
  gear::Planetary::Input in;
  in.z_s = 24, in.z_p = 30, in.z_r = 84;
  in.n_s = 1450.0 * rpm;
  in.T_s = 50.0 * N_m;
  in.eta_0 = 0.97;
  return in;
}

bool says(const std::string& lines, const std::string& part) {
  const std::vector<Issue> issues =
      loadpath::test::told("[g]\ncalculator = \"gear.planetary\"\nz_s = 24\nz_p = 30\nz_r = 84\n" + lines).issues;
  std::string all;
  for (const Issue& i : issues) all += i.key + ": " + i.message.text() + " | " + i.hint.text() + "\n";
  CAPTURE(all);
  const bool found = all.find(part) != std::string::npos;
  CHECK(found);
  return found;
}

}  // namespace

TEST_SUITE("gear planetary") {
  TEST_CASE("the three ways to hold a member have the ratios of superglobalcalculator.com") {
    gear::Planetary::Input in = winch();
    CHECK(rel(solve(in).i, 1.0 + 84.0 / 24.0) < 1e-15);
    CHECK(rel(solve(in).n_c / rpm, 1450.0 / 4.5) < 1e-14);
    in.fixed = Member::carrier;
    CHECK(rel(solve(in).i, -84.0 / 24.0) < 1e-15);
    in.fixed = Member::sun, in.n_s = unset<AngularSpeed>, in.n_r = 100.0 * rpm;
    in.T_s = unset<Moment>;
    CHECK(rel(solve(in).i, 1.0 + 24.0 / 84.0) < 1e-15);
  }

  TEST_CASE("speeds by rolling, not by the formula: the pitch points of a planet move with sun and ring gear") {
    gear::Planetary::Input in = winch();
    in.fixed = Member::none;
    in.n_s = 700.0 * rpm, in.n_r = -130.0 * rpm;
    const auto r = solve(in);
    const double sun = 12.0, planet = 15.0, ring = 42.0;  // radii for m = 1
    const double axis = (r.n_c / rpm) * (sun + planet);
    CHECK(rel(axis - (r.n_p / rpm) * planet, 700.0 * sun) < 1e-12);
    CHECK(rel(axis + (r.n_p / rpm) * planet, -130.0 * ring) < 1e-12);
  }

  TEST_CASE(
      "efficiency with the ring held is (1 - i_0 eta_0)/(1 - i_0) forwards and (1 - i_0/eta_0)^-1 (1 - i_0) back") {
    gear::Planetary::Input in = winch();
    CHECK(rel(solve(in).eta, (1.0 + 3.5 * 0.97) / 4.5) < 1e-14);
    in.T_s = -50.0 * N_m;  // the carrier drives
    CHECK(rel(solve(in).eta, 4.5 / (1.0 + 3.5 / 0.97)) < 1e-14);
    in.fixed = Member::carrier, in.T_s = 50.0 * N_m;
    CHECK(rel(solve(in).eta, 0.97) < 1e-14);
    in.T_s = -50.0 * N_m;
    CHECK(rel(solve(in).eta, 0.97) < 1e-14);
  }

  TEST_CASE("torques are in equilibrium, lost power is positive, and only eta_0 = 1 loses nothing") {
    for (const double n_r : {-900.0, -50.0, 0.0, 100.0, 1450.0, 4000.0}) {
      for (const double T : {-30.0, 30.0}) {
        gear::Planetary::Input in = winch();
        in.fixed = Member::none, in.n_r = n_r * rpm, in.T_s = T * N_m;
        const auto r = solve(in);
        CAPTURE(n_r);
        CHECK(std::abs(in_si(r.T_s + r.T_c + r.T_r)) < 1e-12);
        CHECK(in_si(r.P_loss) >= -1e-9);
        in.eta_0 = 1.0;
        CHECK(std::abs(in_si(solve(in).P_loss)) < 1e-8);
      }
    }
  }

  TEST_CASE("one torque gives the others, whichever one is given") {
    const auto by_sun = solve(winch());
    gear::Planetary::Input in = winch();
    in.T_s = unset<Moment>, in.T_c = by_sun.T_c;
    CHECK(rel(in_si(solve(in).T_s), 50.0) < 1e-13);
    in.T_c = unset<Moment>, in.T_r = by_sun.T_r;
    CHECK(rel(in_si(solve(in).T_s), 50.0) < 1e-13);
  }

  TEST_CASE("a set that turns as a block loses nothing") {
    gear::Planetary::Input in = winch();
    in.fixed = Member::none, in.n_r = in.n_s;
    const auto r = solve(in);
    CHECK(rel(r.n_c / rpm, 1450) < 1e-12);
    CHECK(std::abs(in_si(r.P_loss)) < 1e-9);
  }

  TEST_CASE("assembly: 24/30/84 takes three equally spaced planets, not five; 21/43/108 is coaxial with shift only") {
    gear::Planetary::Input in = winch();
    CHECK(solve(in).spacing == gear::Planetary::Spacing::even);
    CHECK(solve(in).coaxial == gear::Planetary::Coaxial::exact);
    in.N_p = 5;
    CHECK(solve(in).spacing == gear::Planetary::Spacing::uneven);
    in.z_s = 21, in.z_p = 43, in.z_r = 108, in.N_p = 3;
    CHECK(solve(in).coaxial == gear::Planetary::Coaxial::by_shift);
    CHECK(solve(in).z_gap == 1.0);
    CHECK(solve(in).spacing == gear::Planetary::Spacing::even);
  }

  TEST_CASE("a ring gear of 50 with 24 and 30 is not coaxial; without its teeth the coaxial one is found") {
    gear::Planetary::Input in = winch();
    in.z_r = 50;
    CHECK(solve(in).z_gap == -34.0);
    CHECK(solve(in).coaxial == gear::Planetary::Coaxial::none);
    in.z_r = 0;
    CHECK(solve(in).z_r == 84.0);
    CHECK(solve(in).i_0 == -3.5);
    CHECK(solve(in).coaxial == gear::Planetary::Coaxial::exact);
    CHECK(solve(in).q == 36.0);
  }

  TEST_CASE("planets touch when there are too many") {
    gear::Planetary::Input in = winch();
    in.N_p = 4;
    CHECK(rel(solve(in).u_N, 32.0 / (54.0 * std::sin(pi / 4.0))) < 1e-14);
    CHECK(solve(in).u_N < 1.0);
    in.N_p = 6;
    CHECK(solve(in).u_N > 1.0);
    in.N_p = 1;
    CHECK(solve(in).u_N == 0.0);
  }

  TEST_CASE("wrong input is reported") {
    says("", "give one speed if a member is fixed, otherwise two");
    says("n_s = \"100 rpm\"\nn_r = \"5 rpm\"\n", "this member is held");
    says("fixed = \"none\"\nn_s = \"100 rpm\"\n", "give one speed if a member is fixed, otherwise two");
    says("n_s = \"100 rpm\"\nT_s = \"1 N*m\"\nT_c = \"1 N*m\"\n", "give one of T_s, T_c, T_r; the others follow");
    says("n_s = \"100 rpm\"\nN_p = 0\n", "N_p");
    says("n_s = \"100 rpm\"\nN_p = 5\n", "not evenly spaced");
  }
}
