#include "calculators/shaft/overhung.hpp"

#include "calculators/catalogue.hpp"
#include "calculators/shaft/torsion/torsion.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/slotted_lever.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath;
using test::rel;

shaft::Overhung::Input crank() {
  shaft::Overhung::Input in;
  in.F = 3000.0 * N;
  in.a = 50.0 * mm;
  in.T = 80.0 * N_m;
  in.sigma_adm = 60.0 * MPa;
  return in;
}

constexpr auto solve = test::evaluated<shaft::Overhung>;

project::Project solved(const std::string& text, std::vector<Issue>& issues) {
  project::Project p = project::read_project(text, "case.toml", catalogue(), issues);
  if (!has_errors(issues)) project::solve(p, issues);
  return p;
}

}  // namespace

TEST_SUITE("shaft") {
  TEST_CASE("without an overhang only torsion is left, and Tresca needs the same as torsion with half the stress") {
    shaft::Overhung::Input in = crank();
    in.a = 0.0 * mm;
    in.hypothesis = shaft::Overhung::Hypothesis::tresca;
    shaft::Torsion::Input alone;
    alone.T = in.T;
    alone.tau_adm = 0.5 * in.sigma_adm;
    NoTrace trace;
    CHECK(rel(in_si(solve(in).d_v), in_si(shaft::Torsion::evaluate(alone, trace).d_strength)) < 1e-12);
  }

  TEST_CASE("without a torque only bending is left: d^3 = 32 F a / (pi sigma)") {
    shaft::Overhung::Input in = crank();
    in.T = 0.0 * N_m;
    CHECK(rel(in_si(solve(in).d_v), std::cbrt(32 * 3000 * 0.05 / (pi * 60e6))) < 1e-12);
  }

  TEST_CASE("von Mises never needs more than Tresca") {
    for (const double T : {1.0, 50.0, 150.0, 1000.0}) {
      shaft::Overhung::Input mises = crank();
      mises.T = T * N_m;
      shaft::Overhung::Input tresca = mises;
      tresca.hypothesis = shaft::Overhung::Hypothesis::tresca;
      CHECK(solve(mises).d_v <= solve(tresca).d_v);
      CHECK(solve(mises).sigma_M <= solve(mises).sigma_T);
    }
  }

  TEST_CASE("at the minimum diameter the equivalent stress is the allowable one") {
    for (const double chi : {0.0, 0.4, 0.8}) {
      shaft::Overhung::Input in = crank();
      in.chi = chi;
      CHECK(rel(solve(in).u_v, 1.0) < 1e-12);
    }
  }

  TEST_CASE("signs of force and torque do not matter") {
    shaft::Overhung::Input in = crank();
    in.F = -in.F;
    in.T = -in.T;
    CHECK(in_si(solve(in).d_v) == in_si(solve(crank()).d_v));
  }

  TEST_CASE("the shear at the neutral axis of a solid circle is four thirds of the mean shear") {
    shaft::Overhung::Input in = crank();
    in.T = 0.0 * N_m;
    in.d = 40.0 * mm;
    CHECK(rel(in_si(solve(in).tau_Q), 4.0 / 3.0 * 3000 / (pi / 4 * 0.04 * 0.04)) < 1e-12);
  }

  TEST_CASE("the crank of the slotted lever: 35.93 mm where torsion alone needs 27.35") {
    std::vector<Issue> issues;
    const project::Project p = solved(test::slotted_lever_with_two_shafts(), issues);
    REQUIRE(issues.empty());
    CHECK(std::abs(maximum(*p.value("crank_end.d_v")).value - 0.03593) < 0.5e-5);
    CHECK(std::abs(maximum(*p.value("crank_end.d_t")).value - 0.02735) < 0.5e-5);
    CHECK(std::abs(p.value("crankshaft.d_stiffness")->si[0] - 0.04317) < 0.5e-5);
  }

  TEST_CASE("torsion with the torque of a mechanism whose pin loads the shaft reports that bending is not covered") {
    std::vector<Issue> issues;
    const project::Project p = solved(test::slotted_lever_with_two_shafts(), issues);
    bool said = false;
    for (const auto& v : project::verdicts(p)) {
      said = said || (v.step == "crankshaft" && v.symbol == "F_bend" && v.state == account::State::not_covered);
    }
    CHECK(said);
  }

  TEST_CASE("the strength of C45E follows the resulting size, and beyond the last size nothing is covered") {
    struct Row {
      double d_mm, R_e;
    };
    for (const Row row : {Row{15, 490}, {16, 490}, {17, 430}, {40, 430}, {41, 370}, {100, 370}, {101, NAN}}) {
      CAPTURE(row.d_mm);
      std::vector<Issue> issues;
      const project::Project p =
          solved("[part]\ncalculator = \"shaft.torsion\"\nT = \"10 N*m\"\nmaterial = \"C45E\"\nS = 2\nd = \"" +
                     std::to_string(row.d_mm) + " mm\"\n",
                 issues);
      REQUIRE(issues.empty());
      if (std::isnan(row.R_e)) {
        CHECK(account::worst(project::verdicts(p)) == account::State::not_covered);
      } else {
        CHECK(rel(p.value("part.tau_all")->si[0] * std::sqrt(3.0) * 2, row.R_e * 1e6) < 1e-12);
      }
    }
  }

  TEST_CASE("the bore of the minimum shaft is kept when the diameter is rounded up") {
    std::vector<Issue> issues;
    const project::Project p =
        solved("[part]\ncalculator = \"shaft.torsion\"\nT = \"2700 N*m\"\ntau_adm = \"30 MPa\"\nchi = 0.6\n", issues);
    REQUIRE(issues.empty());
    CHECK(rel(p.value("part.d_bore")->si[0], 0.6 * p.value("part.d_min")->si[0]) < 1e-12);
    CHECK(p.value("part.d")->si[0] > p.value("part.d_min")->si[0]);
    CHECK(p.value("part.u_tau")->si[0] < 1.0);
  }

  TEST_CASE("the same moment in other units gives the same shaft") {
    std::vector<double> sizes;
    for (const std::string T : {"900 N*m", "0.9 kN*m", "900000 N*mm"}) {
      std::vector<Issue> issues;
      sizes.push_back(
          solved("[part]\ncalculator = \"shaft.torsion\"\nT = \"" + T + "\"\ntau_adm = \"30 MPa\"\n", issues)
              .value("part.d_min")
              ->si[0]);
    }
    CHECK(rel(sizes[1], sizes[0]) < 1e-14);
    CHECK(rel(sizes[2], sizes[0]) < 1e-14);
  }
}
