#include "calculators/vessel/thick/compound.hpp"

#include "calculators/vessel/thick/cylinder.hpp"
#include "tests/calculators/vessel/vessel_tests.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

namespace {

using namespace loadpath;
using namespace loadpath::tests;
using vessel::Compound;
using vessel::Hypothesis;
using State = Compound::State;

/// Steel tubes of 100, 200 and 400 mm in diameter.
Compound::Input tubes(double p, double p_c) {
  Compound::Input in;
  in.p = p * MPa, in.p_c = p_c * MPa;
  in.d_i = 100.0 * mm, in.d = 200.0 * mm, in.D = 400.0 * mm;
  in.E_1 = in.E_2 = 210.0 * GPa, in.nu_1 = in.nu_2 = 0.3;
  in.ends = Compound::Ends::open;
  in.R_e_1 = in.R_e_2 = 650.0 * MPa, in.S = 1.5;
  return in;
}

Compound::Result compound(const Compound::Input& in) { return solve<Compound>(in); }

/// Steel inside, bronze outside.
Compound::Input of_two_materials(Compound::Ends ends) {
  Compound::Input in = tubes(250, 50);
  in.ends = ends;
  in.E_2 = 110.0 * GPa, in.nu_2 = 0.34;
  return in;
}

/// The integral of the hoop stress over both walls, from Lamé's sums, N/m.
double hoop_force(const Compound::Input& in, const State& s) {
  const auto wall = [](double low, double high, double inner, double outer) {
    const double B = (inner - outer) / (1.0 / (low * low) - 1.0 / (high * high)), A = inner - B / (low * low);
    return A * (high - low) + B * (1.0 / low - 1.0 / high);
  };
  const double bore = 0.5 * in_si(in.d_i), contact = 0.5 * in_si(in.d), outside = 0.5 * in_si(in.D);
  return wall(bore, contact, in_si(s.sigma_1i), in_si(s.sigma_1a)) +
         wall(contact, outside, in_si(s.sigma_2i), in_si(s.sigma_2a));
}

}  // namespace

TEST_SUITE("vessel.compound") {
  TEST_CASE("[Bhandari-22] 22.6: tubes of 20, 40 and 60 mm, 100 MPa at the bore of the jacket") {
    Compound::Input in = tubes(0, 100.0 * (3600.0 - 1600.0) / (3600.0 + 1600.0));
    in.d_i = 20.0 * mm, in.d = 40.0 * mm, in.D = 60.0 * mm, in.E_1 = in.E_2 = 207.0 * GPa;
    const auto r = compound(in);
    CHECK(rel(in_si(r.states[0].sigma_2i), 100e6) < 1e-12);
    CHECK(std::abs(in_si(r.U_w_max) - (40.0 - 39.968289) * 1e-3) < 0.5e-9);
  }

  TEST_CASE("[Bhandari-22] 22.8: with 3.615169 MPa both bores have the same hoop stress at 35 MPa") {
    Compound::Input in = tubes(35, 3.615169);
    in.d_i = 50.0 * mm, in.d = 75.0 * mm, in.D = 100.0 * mm, in.E_1 = in.E_2 = 207.0 * GPa;
    const auto r = compound(in);
    CHECK(rel(in_si(r.states[1].sigma_1i), in_si(r.states[1].sigma_2i)) < 1e-6);
    CHECK(std::abs(in_si(r.U_w_max) - (75.0 - 74.991916) * 1e-3) < 0.5e-9);
  }

  TEST_CASE("two materials: contact pressure and axial stresses of finite elements") {
    // linear elements over the radius, 300 to a tube, with one axial strain or none of the axial stress
    const auto closed = compound(of_two_materials(Compound::Ends::closed));
    CHECK(std::abs(closed.q_p * 250.0 - 31.6080) < 2e-3);
    CHECK(std::abs(in_si(closed.states[1].sigma_z1) - 34.3928e6) < 2e2);
    CHECK(std::abs(in_si(closed.states[1].sigma_z2) - 12.2352e6) < 2e2);
    const auto open = compound(of_two_materials(Compound::Ends::open));
    CHECK(std::abs(open.q_p * 250.0 - 32.0652) < 2e-3);
    CHECK(in_si(open.states[1].sigma_z2) == 0.0);
  }

  TEST_CASE("hoop stresses balance the internal pressure, and each other without pressure") {
    for (const auto ends : {Compound::Ends::closed, Compound::Ends::open}) {
      const Compound::Input in = of_two_materials(ends);
      const auto r = compound(in);
      CHECK(std::abs(hoop_force(in, r.states[0])) < 1e-6);
      CHECK(rel(hoop_force(in, r.states[1]), 250e6 * 0.05) < 1e-12);
    }
  }

  TEST_CASE("closed ends: both tubes carry the force on the ends together") {
    const auto r = compound(of_two_materials(Compound::Ends::closed));
    const State& s = r.states[1];
    const double force = in_si(s.sigma_z1) * (0.1 * 0.1 - 0.05 * 0.05) + in_si(s.sigma_z2) * (0.2 * 0.2 - 0.1 * 0.1);
    CHECK(rel(force, 250e6 * 0.05 * 0.05) < 1e-12);
  }

  TEST_CASE("one material: the stress that the pressure adds is that of vessel.thick") {
    vessel::Thick::Input thick;
    thick.p = 250.0 * MPa, thick.R = 50.0 * mm, thick.delta = 150.0 * mm, thick.measured = vessel::Measured::inner;
    thick.R_e = 650.0 * MPa, thick.S = 1.5, thick.r = 100.0 * mm;
    const auto wall = solve<vessel::Thick>(thick);
    for (const auto ends : {Compound::Ends::closed, Compound::Ends::open}) {
      Compound::Input in = tubes(250, 60);
      in.ends = ends;
      const auto r = compound(in);
      const State &rest = r.states[0], &full = r.states[1];
      CHECK(rel(in_si(full.sigma_1i - rest.sigma_1i), in_si(wall.sigma_ti)) < 1e-12);
      CHECK(rel(in_si(full.sigma_1a - rest.sigma_1a), in_si(wall.sigma_tr)) < 1e-12);
      CHECK(rel(in_si(full.sigma_2i - rest.sigma_2i), in_si(wall.sigma_tr)) < 1e-12);
      CHECK(rel(in_si(full.sigma_2a - rest.sigma_2a), in_si(wall.sigma_ta)) < 1e-12);
      if (ends == Compound::Ends::closed) CHECK(rel(in_si(full.sigma_z1), in_si(wall.sigma_z)) < 1e-12);
    }
  }

  TEST_CASE("the optimum: both bores have the same stress, and no other contact pressure or diameter carries more") {
    Compound::Input in = tubes(250, 60);
    in.R_e_1 = 800.0 * MPa;
    const auto r = compound(in);
    in.p_c = r.p_opt;
    const auto best = compound(in);
    CHECK(rel(best.u_1, best.u_2) < 1e-12);
    CHECK(rel(1.5 * 250e6 / in_si(r.p_F), best.u_1) < 1e-12);
    for (const double share : {0.8, 0.95, 1.05, 1.2}) {
      in.p_c = share * r.p_opt;
      CHECK(std::max(compound(in).u_1, compound(in).u_2) > best.u_1);
      Compound::Input other = in;
      other.d = share * r.d_opt;
      CHECK(compound(other).p_F < compound([&] {
                                    Compound::Input at = in;
                                    at.d = r.d_opt;
                                    return at;
                                  }())
                                      .p_F);
    }
  }

  TEST_CASE("every state counts: the loosest fit for the inner tube, the tightest for the outer tube") {
    Compound::Input in = tubes(250, 0);
    in.p_c = unset<Stress>;
    in.U_min = 200.0 * um, in.U_max = 300.0 * um;
    const auto r = compound(in);
    REQUIRE(r.states.size() == 4);
    CHECK(r.sigma_v1 == r.states[3].sigma_v1);
    CHECK(r.sigma_v2 == r.states[1].sigma_v2);
    in.U_max = 1200.0 * um;  // the inner tube is worst at rest
    CHECK(compound(in).sigma_v1 == compound(in).states[0].sigma_v1);
  }

  TEST_CASE("von Mises is below Tresca, and above the root of 3 halves of it") {
    Compound::Input in = of_two_materials(Compound::Ends::closed);
    const auto tresca = compound(in);
    in.hypothesis = Hypothesis::mises;
    const auto mises = compound(in);
    CHECK(mises.sigma_v1 <= tresca.sigma_v1);
    CHECK(mises.sigma_v2 >= std::sqrt(3.0) / 2.0 * tresca.sigma_v2);
  }

  TEST_CASE("a warmer jacket loses its contact pressure: the loss is a failure, and no stress is reported") {
    Compound::Input in = tubes(0, 60);
    in.alpha_1 = in.alpha_2 = 12e-6 * per_kelvin, in.dT_1 = 0.0 * kelvin, in.dT_2 = 40.0 * kelvin;
    const auto warm = compound(in);
    CHECK(rel(in_si(warm.U_T), 0.2 * 12e-6 * 40.0) < 1e-12);
    CHECK(warm.p_min < warm.p_max);
    CHECK(rel(in_si(warm.p_max), 60e6) < 1e-12);  // cold
    in.dT_2 = 100.0 * kelvin;
    const auto loose = compound(in);
    CHECK(loose.u_U > 1.0);
    CHECK(!is_set(loose.u_1));
    in.dT_2 = -40.0 * kelvin;  // a cooler one gains
    CHECK(compound(in).p_max > 60.0 * MPa);
    CHECK(compound(in).u_U == 0.0);
  }

  TEST_CASE("wrong input is refused") {
    const std::string step =
        "calculator = \"vessel.compound\"\np = \"9 MPa\"\nd_i = \"50 mm\"\nd = \"60 mm\"\nD = \"80 mm\"\n"
        "E_1 = \"210 GPa\"\nE_2 = \"210 GPa\"\nnu_1 = 0.3\nnu_2 = 0.3\n";
    CHECK(says(step, "give the interference U_min and U_max, or the contact pressure p_c"));
    CHECK(says(step + "p_c = \"5 MPa\"\nU_min = \"5 um\"\nU_max = \"6 um\"", "not both"));
    CHECK(says(step + "U_min = \"7 um\"\nU_max = \"6 um\"", "must not exceed"));
    CHECK(says(step + "p_c = \"5 MPa\"\ndT_1 = \"20 K\"", "temperature rise of both tubes"));
    CHECK(says(step + "p_c = \"5 MPa\"\nS = 2", "needs the yield strengths"));
    CHECK(says(step + "p_c = \"5 MPa\"\nhypothesis = \"membrane\"", "a thick wall needs a radial stress"));
    CHECK(messages(step + "p_c = \"5 MPa\"").empty());
  }
}
