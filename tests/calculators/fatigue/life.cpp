#include "calculators/fatigue/life.hpp"

#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/rainflow/sn_curve.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/lib/project/says.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>

namespace {

using namespace loadpath;
using fatigue::MeanRule;
using L = fatigue::Life;
using test::rel;

constexpr auto life = test::evaluated<L>;

const L::Row& row_of(const L::Result& r, MeanRule rule) {
  for (const auto& row : r.rules) {
    if (row.name.view() == word_of(rule)) return row;
  }
  FAIL("no row of ", word_of(rule));
  return r.rules[0];
}

/// Everything that any rule needs.
L::Input steel() {
  L::Input in;
  in.sigma_a = 100.0 * MPa, in.sigma_m = 80.0 * MPa;
  in.sigma_D = 190.0 * MPa, in.group = L::Group::carbon_steel;
  in.R_m = 690.0 * MPa, in.R_e = 490.0 * MPa, in.sigma_f = 1100.0 * MPa;
  in.S_D = 1.5, in.S_F = 1.5;
  return in;
}

bool says(const std::string& lines, const std::string& words) {
  return test::says("[c]\ncalculator = \"fatigue.life\"\nS_D = 1.5\n" + lines, words);
}

}  // namespace

TEST_SUITE("fatigue.life") {
  TEST_CASE("Bhandari 5.17, Dowling page 458, solutions of Shigley 6-15 and 6-3") {
    L::Input in = steel();
    in.sigma_a = 30.0 * MPa, in.sigma_m = 70.0 * MPa, in.sigma_D = 270.0 * MPa;
    in.R_m = 600.0 * MPa, in.R_e = 450.0 * MPa;
    const auto bhandari = life(in);
    CHECK(std::abs(row_of(bhandari, MeanRule::gerber).n - 5.412003) < 5e-7);
    CHECK(rel(row_of(bhandari, MeanRule::soderberg).n, 3.75) < 1e-12);
    CHECK(std::abs(row_of(bhandari, MeanRule::goodman).n - 4.390244) < 5e-7);
    CHECK(rel(bhandari.n_y, 4.5) < 1e-12);

    L::Input dowling;
    dowling.sigma_a = 450.0 * MPa, dowling.sigma_m = 200.0 * MPa, dowling.group = L::Group::alloy_steel;
    dowling.rule = MeanRule::morrow, dowling.line = L::Line::basquin, dowling.K_D = 1.0;
    dowling.sigma_f = 1758.0 * MPa, dowling.b = -0.0977, dowling.N = 1e5, dowling.S_D = 1.0;
    CHECK(std::abs(life(dowling).N_f - 166e3) < 500);
    CHECK(std::abs(row_of(life(dowling), MeanRule::swt).N - 86.9e3) < 50);
    CHECK(std::abs(in_si(life(dowling).sigma_ar) - 507.8e6) < 5e4);

    in = steel();
    in.sigma_a = 358.5 * MPa, in.sigma_m = unset<Stress>, in.r = -1.0;
    in.sigma_D = 276.0 * MPa, in.R_m = 551.0 * MPa, in.R_e = 413.0 * MPa, in.f = 0.9;
    CHECK(std::abs(life(in).N_f - 45800) < 50);
    CHECK(std::abs(life(in).b_N + 0.084828) < 5e-7);
  }

  TEST_CASE("the load times its safety factor is at the limit of every rule, and so is the remaining amplitude") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.05, 0.8);
    for (int i = 0; i < 200; ++i) {
      L::Input in = steel();
      in.stress = i % 4 == 0 ? Stresses::shear : Stresses::normal;
      in.sigma_a = share(random) * 190.0 * MPa, in.sigma_m = share(random) * 300.0 * MPa;
      in.K_m = 1.0 + share(random);
      in.gamma = 0.3 + 0.8 * share(random);
      const auto r = life(in);
      REQUIRE(r.rules.size() == (in.stress == Stresses::shear ? 7 : 10));
      for (const auto& row : r.rules) {
        const std::string name(row.name.view());
        CAPTURE(name);
        L::Input grown = in;
        grown.sigma_a = row.n * in.sigma_a, grown.sigma_m = row.n * in.sigma_m;
        L::Input swung = in;
        swung.sigma_a = row.sigma_A;
        for (const auto& other : life(grown).rules) {
          if (other.name.view() == name) CHECK(rel(other.n, 1.0) < 1e-9);
          // where yielding limits the Goodman line, the amplitude is a different one
          if (other.name.view() == name && name != "modified-goodman") CHECK(rel(in_si(other.sigma_ar), 190e6) < 1e-9);
        }
        for (const auto& other : life(swung).rules) {
          if (other.name.view() == name && name != "modified-goodman") CHECK(rel(in_si(other.sigma_ar), 190e6) < 1e-9);
        }
      }
    }
  }

  TEST_CASE("without a mean stress all rules agree; compression has no effect, except for FKM where allowed") {
    L::Input in = steel();
    in.sigma_m = 0.0 * MPa;
    for (const auto& row : life(in).rules) CHECK(rel(row.n, 1.9) < 1e-12);
    in.sigma_m = -60.0 * MPa;
    for (const auto& row : life(in).rules) CHECK(rel(row.n, 1.9) < 1e-12);
    in.compression = L::Compression::counted, in.rule = MeanRule::fkm;
    const double M = 0.35 * 0.69 - 0.1;
    CHECK(rel(in_si(life(in).sigma_ar), (100 - M * 60) * 1e6) < 1e-12);
    in.sigma_m = -200.0 * MPa;  // always pressed
    CHECK(rel(in_si(life(in).sigma_ar), 100e6 * (1 - M)) < 1e-12);
    in.compression = L::Compression::ignored, in.stress = Stresses::shear, in.rule = MeanRule::goodman;
    in.sigma_m = -60.0 * MPa;  // shear of either sense lowers the limit
    CHECK(rel(life(in).n, 1 / (100 / 190.0 + 60 / (0.67 * 690))) < 1e-12);
  }

  TEST_CASE("the strength at 1e3 cycles by the fit over R_m in kpsi, by hand; 0.9 below 70") {
    L::Input in = steel();
    in.N = 1e5;
    for (const auto& [S_k, f] :
         {std::pair(60.0, 0.9), std::pair(90.0, 0.86389), std::pair(150.0, 0.79525), std::pair(200.0, 0.776)}) {
      in.R_m = S_k * 6.894757 * MPa;
      CHECK(std::abs(life(in).f - f) < 1e-9);
    }
  }

  TEST_CASE("shear is compared with shear: 0.67 R_m in the finite-life line, R_e over the root of 3 by Soderberg") {
    L::Input in = steel();
    in.stress = Stresses::shear, in.rule = MeanRule::soderberg, in.f = 0.9;
    CHECK(rel(life(in).n, 1 / (100 / 190.0 + 80 * std::sqrt(3.0) / 490)) < 1e-12);
    CHECK(rel(life(in).b_N, -0.113470933974859) < 1e-12);  // -lg(0.9 0.67 690/190)/3
  }

  TEST_CASE("modified Goodman leaves the amplitude of its line up to yielding, and that of yielding beyond") {
    L::Input in = steel();
    in.rule = MeanRule::modified_goodman;
    for (const auto& [sigma_m, sigma_A] : {std::pair(80.0, 190.0 * (1 - 80.0 / 690)), std::pair(450.0, 40.0)}) {
      in.sigma_m = sigma_m * MPa;
      CHECK(rel(in_si(row_of(life(in), MeanRule::modified_goodman).sigma_A), sigma_A * 1e6) < 1e-12);
    }
  }

  TEST_CASE("psi of steels by their strength, half of it in shear; the last field of FKM is constant") {
    L::Input in = steel();
    in.rule = MeanRule::serensen;
    CHECK(rel(in_si(life(in).sigma_ar), (100 + 0.158 * 80) * 1e6) < 1e-12);  // 0.02 + 0.0002 690
    in.K_D = 2.0;
    CHECK(rel(in_si(life(in).sigma_ar), (100 + 0.079 * 80) * 1e6) < 1e-12);
    in.K_D = unset<double>, in.stress = Stresses::shear;
    CHECK(rel(in_si(life(in).sigma_ar), (100 + 0.079 * 80) * 1e6) < 1e-12);
    in = steel();
    in.rule = MeanRule::fkm, in.M = 0.5, in.sigma_a = 10.0 * MPa;
    for (const double sigma_m : {330.0, 400.0}) {
      in.sigma_m = sigma_m * MPa;
      CHECK(rel(in_si(row_of(life(in), MeanRule::fkm).sigma_A), 190e6 * 3.5 / 6.75) < 1e-12);
    }
  }

  TEST_CASE("the fields of FKM meet at their borders") {
    L::Input in = steel();
    in.rule = MeanRule::fkm;
    for (const double r : {0.0, 0.5}) {
      const auto at = [&](double ratio) {
        in.sigma_m = (1 + ratio) / (1 - ratio) * 100.0 * MPa;
        return in_si(life(in).sigma_ar);
      };
      CHECK(rel(at(r + 1e-9), at(r - 1e-9)) < 1e-7);
    }
  }

  TEST_CASE("lines of finite life agree with the curves for counted histories") {
    for (const double amplitude : {200.0, 260.0, 330.0, 500.0}) {
      L::Input in = steel();
      in.sigma_a = amplitude * MPa, in.sigma_m = 0.0 * MPa;
      in.line = L::Line::slope, in.k = 5.0;
      const std::array branches{rainflow::SnCurve::Branch{5.0, 1e6}};
      const auto curve = rainflow::SnCurve::make(rainflow::Measure::amplitude, {190e6, 1e6}, branches);
      REQUIRE(curve);
      CHECK(rel(life(in).N_f, *curve->cycles(amplitude * 1e6)) < 1e-9);
    }
  }

  TEST_CASE("a life and its strength are consistent; the safety factor of that life follows from the strength") {
    for (const auto line : {L::Line::shigley, L::Line::slope, L::Line::basquin}) {
      L::Input in = steel();
      in.sigma_a = 240.0 * MPa;
      in.line = line, in.k = 6.0, in.b = -0.09, in.K_D = 1.6;
      const double N = life(in).N_f;
      REQUIRE(N > 1e3);
      REQUIRE(N < 1e6);
      in.N = N;
      CHECK(rel(life(in).n, 1.0) < 1e-9);
      CHECK(rel(life(in).u_D, 1.5) < 1e-9);
      CHECK(rel(in_si(life(in).sigma_adm), 160e6) < 1e-9);
    }
  }

  TEST_CASE("S_D times the load has the required strength and life") {
    L::Input in = steel();
    const auto r = life(in);
    CHECK(rel(in_si(r.S_req), 1.5 * 100e6 / (1 - 1.5 * 80 / 690.0)) < 1e-12);
    CHECK(std::isinf(r.N_f));
    in.sigma_a = 130.0 * MPa;
    L::Input grown = in;
    grown.sigma_a = 195.0 * MPa, grown.sigma_m = 120.0 * MPa;
    CHECK(rel(life(in).N_S, life(grown).N_f) < 1e-12);
    in.mean = fatigue::MeanStress::constant;
    CHECK(rel(life(in).u_D, 1.5 * 130 / (190 * (1 - 80 / 690.0))) < 1e-12);
  }

  TEST_CASE("a mean stress that breaks the part leaves no amplitude, no life, and only valid numbers") {
    for (const auto& rule : choices_of(MeanRule{})) {
      L::Input in = steel();
      in.rule = rule.value, in.mean = fatigue::MeanStress::constant;
      in.sigma_m = 1200.0 * MPa;
      const auto r = life(in);
      CHECK_FALSE(std::isnan(r.n));
      CHECK_FALSE((is_set(r.u_D) && !std::isfinite(r.u_D)));
      CHECK((!is_set(r.u_D) ? r.x_m >= 1.0 : r.u_D > 0.0));
    }
  }

  TEST_CASE("non-ferrous metals last as long as their limit is stated for") {
    L::Input in = steel();
    in.group = L::Group::wrought_aluminium;
    in.R_m = 470.0 * MPa, in.R_e = 325.0 * MPa, in.sigma_D = 140.0 * MPa, in.f = 0.8, in.N = 1e7;
    in.sigma_a = 100.0 * MPa, in.sigma_m = 0.0 * MPa;
    CHECK(life(in).N_f == 1e8);
    CHECK(in_si(life(in).S_e) > 140e6);
    in.N = 2e8;
    CHECK(life(in).x_D == 2.0);
  }

  TEST_CASE("grey iron is assessed by its tensile strength") {
    L::Input in = steel();
    in.group = L::Group::grey_iron, in.R_e = unset<Stress>, in.R_m = 250.0 * MPa, in.sigma_D = 80.0 * MPa;
    in.K_m = 1.4, in.sigma_a = 20.0 * MPa, in.sigma_m = 40.0 * MPa;
    CHECK(rel(life(in).u_y, 60 / 250.0) < 1e-12);
    CHECK(rel(life(in).n, 1 / (20 / 80.0 + 1.4 * 40 / 250)) < 1e-12);
  }

  TEST_CASE("\"?\" finds the amplitude and the cycles that a referred fatigue limit allows") {
    const auto found = [](const std::string& lines, const std::string& path) {
      std::vector<Issue> issues;
      project::Project project = project::read_project(
          "[bar]\ncalculator = \"fatigue.endurance\"\nR_m = \"690 MPa\"\ngroup = \"carbon-steel\"\nloading = "
          "\"bending\"\nrule = \"shigley\"\n[c]\ncalculator = \"fatigue.life\"\nr = -1\nsigma_D = "
          "\"=bar.sigma_D\"\ngroup = \"carbon-steel\"\nR_m = \"690 MPa\"\nS_D = 1.5\n" +
              lines,
          "case.toml", catalogue(), issues);
      project::solve(project, issues);
      for (const Issue& issue : issues) CHECK_MESSAGE(issue.severity != Severity::error, issue.message.text());
      const Value* const value = project.value(path);
      REQUIRE(value != nullptr);
      return value->si[0];
    };
    CHECK(rel(found("sigma_a = \"?\"\n", "c.sigma_a"), 345e6 / 1.5) < 0.01);
    const double N = found("sigma_a = \"300 MPa\"\nN = \"?\"\n", "c.N");
    L::Input in = steel();
    in.sigma_D = 345.0 * MPa, in.sigma_a = 450.0 * MPa, in.sigma_m = 0.0 * MPa;
    CHECK(rel(N, life(in).N_f) < 0.01);
  }

  TEST_CASE("wrong input is reported") {
    const std::string cycle = "sigma_a = \"100 MPa\"\nsigma_m = \"50 MPa\"\n";
    const std::string rod = cycle + "sigma_D = \"190 MPa\"\ngroup = \"carbon-steel\"\n", R_m = "R_m = \"690 MPa\"\n";
    CHECK(says(rod, "needs the tensile strength"));
    CHECK(says(rod + "rule = \"soderberg\"\n", "needs the yield strength"));
    CHECK(says(rod + R_m + "rule = \"modified-goodman\"\n", "tensile and the yield"));
    CHECK(says(rod + R_m + "rule = \"morrow\"\n", "Morrow"));
    CHECK(says(rod + "rule = \"walker\"\n", "exponent"));
    CHECK(says(rod + "rule = \"fkm\"\n", "fields of FKM"));
    CHECK(says(rod + "rule = \"serensen\"\n", "needs psi"));
    CHECK(says(rod + R_m + "stress = \"shear\"\nrule = \"swt\"\n", "given for normal stresses"));
    CHECK(says(cycle + "sigma_D = \"190 MPa\"\n" + R_m,
               "without it the material is taken as non-ferrous, with no endurance limit"));
    CHECK(says(cycle + "group = \"carbon-steel\"\n" + R_m, "give the fatigue limit"));
    CHECK(says(rod + R_m + "line = \"basquin\"\n", "needs sigma_f, b and K_D"));
    CHECK(says(rod + R_m + "line = \"slope\"\n", "needs its slope k"));
    CHECK(says(rod + "rule = \"swt\"\nN = 1e5\n", "needs R_m"));
    CHECK(says("sigma_a = \"9 MPa\"\nr = -1\nsigma_D = \"400 MPa\"\ngroup = \"carbon-steel\"\nN = 1e5\nf = 0.5\n" + R_m,
               "is not above sigma_D"));
    CHECK(says(cycle + "sigma_D = \"90 MPa\"\ngroup = \"cast-aluminium\"\nN = 1e6\n" + R_m, "fitted for steels"));
    CHECK(says(rod + "R_m = \"180 MPa\"\n", "below the tensile strength"));
    CHECK(says(rod + R_m + "R_e = \"700 MPa\"\n", "the yield strength R_e must not exceed the tensile strength R_m"));
    CHECK(says(rod + R_m + "compression = \"counted\"\n", "only by rule = \"fkm\""));
    CHECK(says(cycle + "sigma_D = \"90 MPa\"\ngroup = \"grey-iron\"\n" + R_m, "does not yield at a notch"));
    CHECK(says(rod + R_m + "S_F = 1.5\n", "needs the yield strength R_e"));
    CHECK(says(rod + R_m + "r = -1\n", "exactly two"));
  }
}
