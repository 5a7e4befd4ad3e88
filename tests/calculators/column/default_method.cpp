// A compressed bar without a named method: the method follows from the inputs.
#include "calculators/column/lightest/lightest.hpp"
#include "lib/account/mode.hpp"
#include "tests/calculators/column/models.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace loadpath;
using namespace loadpath::tests;

const std::string post =
    "calculator = \"column.buckling\"\nl = \"3 m\"\nends = \"pinned_pinned\"\nsection = \"HEA 160\"\n"
    "material = \"S235JR\"\n";
const std::string rod =
    "calculator = \"column.buckling\"\nl = \"1 m\"\nends = \"pinned_pinned\"\nE = \"210 GPa\"\nP = \"20 kN\"\n";

double number(const project::Project& p, const std::string& path) {
  const Value* const value = p.value(path);
  return value == nullptr ? NAN : value->si[0];
}

/// The reason of a line of the calculation; empty where there is none.
std::string why_of(const project::Project& p, std::string_view scope, std::string_view symbol) {
  for (const auto& line : p.find("bar")->account().derivation) {
    if (line.element == scope && line.step.symbol == symbol) return line.step.why.text();
  }
  return "";
}

std::string note_of(const project::Project& p, std::string_view id) {
  const account::Modes modes = project::modes(p);
  const auto found = std::find_if(modes.begin(), modes.end(), [&](const account::Mode& m) { return m.id == id; });
  return found == modes.end() ? "" : account::reason(*found).text();
}

}  // namespace

TEST_SUITE("column default method") {
  // HEA 160: A 3877 mm^2, i_z = sqrt(615.6e4/3877) = 39.85 mm, lambda 75.29, lambda_bar = 75.29/93.91 = 0.8017, curve
  // c: Phi = 0.5 (1 + 0.49*0.6017 + 0.6427) = 0.9687, chi = 0.6611, N_b,Rd = 0.6611*3877*235/1.0 = 602.3 kN.
  TEST_CASE("a section of the tables in steel is assessed by EN 1993-1-1 with factors that are named as assumed") {
    std::vector<Issue> issues;
    const project::Project p = solved("[bar]\n" + post + "P = \"100 kN\"\n", issues);
    REQUIRE(issues.size() == 1);
    CHECK(issues[0].severity == Severity::warning);
    CHECK(issues[0].message.text() == "partial factors of EN 1993-1-1 assumed: gamma_M1 = 1.0, gamma_F = 1");
    CHECK(number(p, "bar.P_all") == doctest::Approx(602.3e3).epsilon(1e-3));
    CHECK(number(p, "bar.u") == doctest::Approx(0.1660).epsilon(1e-3));
    CHECK(note_of(p, "buckling") == "u with partial factors of EN 1993-1-1 assumed: gamma_M1 = 1.0, gamma_F = 1");
  }

  TEST_CASE("the national annex has another gamma_M1: only gamma_F is assumed") {
    std::vector<Issue> issues;
    const project::Project p = solved("[bar]\n" + post + "P = \"100 kN\"\ngamma_M1 = 1.1\n", issues);
    REQUIRE(issues.size() == 1);
    CHECK(issues[0].message.text() == "partial factors of EN 1993-1-1 assumed: gamma_F = 1");
    CHECK(number(p, "bar.P_all") == doctest::Approx(602.3e3 / 1.1).epsilon(1e-3));
    CHECK(complaints(post + "P = \"100 kN\"\ngamma_M1 = 1.1\ngamma_F = 1.35\n").empty());
    // a tie: the load factor, no factor of buckling
    CHECK(complaints(post + "N = \"100 kN\"\nn_t = 1.5\n").find("assumed: gamma_F = 1") != std::string::npos);
    CHECK(complaints(post + "N = \"100 kN\"\nn_t = 1.5\ngamma_F = 1.35\n").empty());
  }

  TEST_CASE("a section of the tables without a steel grade needs one") {
    const std::string bare =
        "calculator = \"column.buckling\"\nl = \"3 m\"\nends = \"pinned_pinned\"\nsection = \"HEA 160\"\n"
        "P = \"100 kN\"\nE = \"210 GPa\"\n";
    CHECK(complaints(bare).find("give the yield strength R_e, or a material\n") != std::string::npos);
  }

  // lambda_J = sqrt(2 pi^2 210000/355) = 108.06 (Shigley, the transition of Euler and Johnson). d = 40 mm: lambda =
  // 100, sigma = 355 (1 - 355*100^2/(4 pi^2 210000)) = 203.0 MPa; d = 30 mm: lambda = 133.3, Euler 116.6 MPa.
  TEST_CASE("a plain bar goes by Johnson's parabola when stocky, by Euler when slender, and the trace shows it") {
    std::vector<Issue> issues;
    const project::Project stocky = solved("[bar]\n" + rod + "R_e = \"355 MPa\"\nn_st = 3\nd = \"40 mm\"\n", issues);
    const project::Project slender = solved("[bar]\n" + rod + "R_e = \"355 MPa\"\nn_st = 3\nd = \"30 mm\"\n", issues);
    REQUIRE(issues.empty());
    CHECK(number(stocky, "bar.sigma_cr") == doctest::Approx(203.0e6).epsilon(1e-3));
    CHECK(number(slender, "bar.sigma_cr") == doctest::Approx(116.6e6).epsilon(1e-3));
    CHECK(why_of(stocky, "methods.johnson", "sigma_cr") == "Johnson's parabola, [Johnson]");
    CHECK(why_of(slender, "methods.johnson", "sigma_cr") == "Euler, [B25]");
    CHECK(why_of(slender, "", "sigma_cr").find("as no method is named") != std::string::npos);
  }

  // Euler with n_st = 3: I = 3*20e3*1000^2/(pi^2*210000) = 28949 mm^4, d = (64 I/pi)^(1/4) = 27.7 mm: 28 mm of R40.
  TEST_CASE("the diameter is found without a method") {
    std::vector<Issue> issues;
    const project::Project p = solved("[bar]\n" + rod + "R_e = \"355 MPa\"\nn_st = 3\nd = \"?\"\n", issues);
    REQUIRE(issues.empty());
    CHECK(number(p, "bar.d") == doctest::Approx(0.028));
  }

  TEST_CASE("missing input is reported in one line, also where the size is searched for") {
    for (const char* size : {"d = \"?\"\n", "d = \"40 mm\"\n", "h = \"40 mm\"\nb = \"40 mm\"\n"}) {
      CHECK(complaints(rod + size)
                .find("give the yield strength R_e, or a material, and the required buckling safety factor n_st\n") !=
            std::string::npos);
      CHECK(complaints(rod + size + "R_e = \"355 MPa\"\n").find("give the required buckling safety factor n_st\n") !=
            std::string::npos);
    }
  }

  TEST_CASE("constants of a set mean Tetmajer, a proportional limit alone means Euler") {
    column::Buckling::Input in = bar_of_steel(column::Ends::pinned_pinned);
    in.P = 10.0 * kN;
    CHECK(rel(solve(in).sigma_cr, by(solve(in), "tetmajer").sigma_cr) < 1e-12);
    in.a_T = in.b_T = unset<Stress>;
    CHECK(rel(solve(in).sigma_cr, by(solve(in), "johnson").sigma_cr) < 1e-12);
    in.R_e = unset<Stress>, in.sigma_P = 190.0 * MPa;
    CHECK(rel(solve(in).sigma_cr, by(solve(in), "euler").sigma_cr) < 1e-12);
  }

  TEST_CASE("slenderness needs length, section and ends, and shows no force") {
    std::vector<Issue> issues;
    const project::Project p = solved(
        "[bar]\ncalculator = \"column.buckling\"\nl = \"1 m\"\nd = \"20 mm\"\nends = \"pinned_pinned\"\n", issues);
    REQUIRE(issues.empty());
    CHECK(number(p, "bar.lambda") == doctest::Approx(200.0));
    CHECK(why_of(p, "", "N_cr").empty());
    CHECK(why_of(p, "", "spread").empty());
  }

  TEST_CASE("without a method the lightest section is found by EN 1993-1-1") {
    std::vector<Issue> issues;
    const std::string lightest =
        "[bar]\ncalculator = \"column.lightest\"\nfamilies = [\"HEA\"]\nP = \"600 kN\"\nl = \"3 m\"\n"
        "ends = \"pinned_pinned\"\nmaterial = \"S235\"\n";
    const project::Project assumed = solved(lightest, issues);
    REQUIRE_FALSE(has_errors(issues));
    const project::Project named = solved(lightest + "method = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1\n", issues);
    REQUIRE_FALSE(has_errors(issues));
    CHECK(number(assumed, "bar.P_all") == doctest::Approx(number(named, "bar.P_all")));
    CHECK(number(assumed, "bar.q") == doctest::Approx(number(named, "bar.q")));
  }
}
