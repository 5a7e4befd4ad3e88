// Every wrong input of column.buckling and what is said of it, as a project reads it.
#include "tests/calculators/column/models.hpp"

#include <doctest/doctest.h>

namespace {

using namespace loadpath;
using namespace loadpath::tests;

const std::string rod =
    "calculator = \"column.buckling\"\nl = \"900 mm\"\nends = \"pinned_pinned\"\nE = \"210 GPa\"\nR_e = \"235 MPa\"\n";

bool says(const std::string& lines, std::string_view words) {
  const std::string said = complaints(lines);
  INFO(said);
  const bool found = said.find(words) != std::string::npos;
  CHECK(found);
  return found;
}

}  // namespace

TEST_SUITE("column buckling faults") {
  TEST_CASE("correct input gives no message") {
    CHECK(complaints(rod + "d = \"40 mm\"\nmethod = \"johnson\"\nn_st = 2\nP = \"10 kN\"\n").empty());
  }

  TEST_CASE("force, section and ends are given once and completely") {
    says(rod + "d = \"40 mm\"\nmethod = \"johnson\"\nP = \"1 kN\"\nN = \"-1 kN\"\n",
         "give the force as N, positive in tension, or as P, positive in compression, not both");
    says(rod + "method = \"johnson\"\n", "the section is not given");
    says(rod + "method = \"johnson\"\nA = \"10 cm^2\"\n", "with the area A both axes need I or i");
    says(rod + "method = \"johnson\"\nI_y = \"10 cm^4\"\n", "I or i is given, but not the area A");
    says(rod + "method = \"johnson\"\nd = \"40 mm\"\nb = \"20 mm\"\n", "the bar is one of them");
    says(rod + "method = \"johnson\"\nd = \"40 mm\"\nd_bore = \"40 mm\"\n",
         "the bore d_bore must be smaller than d; give both");
    says(rod + "method = \"johnson\"\nA = \"10 cm^2\"\nI_y = \"100 cm^4\"\ni_y = \"20 mm\"\ni_z = \"20 mm\"\n",
         "I and i of an axis must satisfy I = A i^2; give one of them");
    says(
        "calculator = \"column.buckling\"\nl = \"900 mm\"\nE = \"210 GPa\"\nR_e = \"235 MPa\"\nd = \"40 mm\"\n"
        "method = \"johnson\"\n",
        "give the end conditions");
    says(rod + "d = \"40 mm\"\nmethod = \"johnson\"\nends_y = \"fixed_free\"\nbeta_y = 2\n",
         "give the ends of an axis or its factor beta, not both");
    const std::string soft =
        "calculator = \"column.buckling\"\nl = \"900 mm\"\nends = \"pinned_pinned\"\nd = \"40 mm\"\n";
    CHECK(complaints(soft).empty());  // only its slenderness
    says(soft + "R_e = \"235 MPa\"\nmethod = \"johnson\"\nn_st = 2\nP = \"10 kN\"\n",
         "give a material, or the modulus E");
    says(rod + "d = \"40 mm\"\nmethod = \"johnson\"\nP = \"-1 kN\"\n", "P = -1 kN: must be >= 0 kN");
  }

  TEST_CASE("SP 16 needs the kind of section") {
    says(rod + "d = \"40 mm\"\nmethod = \"sp16\"\nn_st = 2\nP = \"10 kN\"\n",
         "the method 'sp16' needs the kind of section");
  }

  TEST_CASE("supports must lie between the ends, in order") {
    says(rod + "d = \"40 mm\"\nmethod = \"johnson\"\nsupports_z = [[\"900 mm\"]]\n",
         "bar.supports_z[1].x: supports must lie between the ends of the bar, 0 and 900 mm, in order");
    says(rod + "d = \"40 mm\"\nmethod = \"johnson\"\nsupports_y = [[\"500 mm\"], [\"400 mm\"]]\n",
         "bar.supports_y[2].x");
    says(rod + "d = \"40 mm\"\nmethod = \"johnson\"\nbeta_z = 1\nsupports_z = [[\"400 mm\"]]\n",
         "the effective length with supports is computed exactly from the ends: omit beta of that axis and use "
         "beta_basis = \"exact\"");
  }

  TEST_CASE("a method names the input that is missing") {
    says(rod + "d = \"40 mm\"\nmethod = \"euler\"\n", "the method 'euler' needs the proportional limit sigma_P");
    says(rod + "d = \"40 mm\"\nmethod = \"tetmajer\"\n", "the method 'tetmajer' needs a Tetmajer set");
    says(rod + "d = \"40 mm\"\nmethod = \"secant\"\n", "the method 'secant' needs the eccentricity e_y or e_z");
    says(rod + "A = \"10 cm^2\"\nI_y = \"100 cm^4\"\nI_z = \"100 cm^4\"\nmethod = \"ec3\"\n",
         "the method 'ec3' needs the buckling curves");
    CHECK(complaints(rod + "d = \"40 mm\"\nd_bore = \"20 mm\"\nmethod = \"ec3\"\n").empty());  // curve c of a tube
    says(rod + "d = \"40 mm\"\nmethod = \"ec3\"\nkind = \"solid\"\nP = \"1 kN\"\n",
         "partial factors of EN 1993-1-1 assumed: gamma_M1 = 1.0, gamma_F = 1");
    says(rod + "d = \"40 mm\"\nmethod = \"ec3\"\nkind = \"solid\"\nP = \"1 kN\"\ngamma_M1 = 1\n",
         "partial factors of EN 1993-1-1 assumed: gamma_F = 1");
    says(rod + "d = \"40 mm\"\nmethod = \"johnson\"\nP = \"1 kN\"\n", "needs the required buckling safety factor n_st");
  }

  TEST_CASE("where no method is named, missing input is reported in one line with one alternative") {
    column::Buckling::Input in = bar_of_steel(column::Ends::pinned_pinned);
    in.a_T = in.b_T = unset<Stress>, in.n_st = unset<double>, in.P = 10.0 * kN;
    const FieldFault safety = column::Buckling::missing_for_method(in);
    CHECK(safety.message.text() == "give the required buckling safety factor n_st");
    CHECK(safety.hint.text() == "or use a code that includes it: method = \"ec3\" or \"aisc\"");
    in.R_e = unset<Stress>;
    const FieldFault strength = column::Buckling::missing_for_method(in);
    CHECK(strength.message.text() ==
          "give the yield strength R_e, or a material, and the required buckling safety factor n_st");
    CHECK(strength.hint.text().find("loadpath tables columns/tetmajer") != std::string::npos);
    in.method = column::Method::secant;
    CHECK(column::Buckling::missing_for_method(in).hint.empty());
  }

  TEST_CASE("a steel code assesses no other material") {
    const std::string iron = rod + "d = \"40 mm\"\nkind = \"solid\"\nmaterial_class = \"cast_iron\"\n";
    says(iron + "method = \"aisc\"\n", "the method 'aisc' is for steel, not for material_class = \"cast_iron\"");
    says(iron + "method = \"ec3\"\n", "the method 'ec3' is for steel");
    CHECK(complaints(rod + "d = \"40 mm\"\nmaterial_class = \"cast_iron\"\nmethod = \"johnson\"\n").empty());
  }

  TEST_CASE("an eccentricity has one axis and one fibre") {
    const std::string rolled = rod + "A = \"10 cm^2\"\ni_y = \"30 mm\"\ni_z = \"30 mm\"\nmethod = \"secant\"\n";
    says(rolled + "e_y = \"5 mm\"\n", "an eccentricity or a bow needs the distance of the extreme fibre");
    says(rolled + "e_y = \"5 mm\"\ne_z = \"5 mm\"\nc_y = \"50 mm\"\nc_z = \"50 mm\"\n",
         "the secant formula covers an eccentricity or a bow about one axis only");
  }

  TEST_CASE("the set of another material is refused; a deviating modulus of the same material is reported") {
    const std::string made = rod + "d = \"40 mm\"\nmethod = \"tetmajer\"\nP = \"1 kN\"\nn_st = 5\n";
    const std::string iron = made + "tetmajer = \"grey_iron\"\n";
    const std::string near = made + "a_T = \"310 MPa\"\nb_T = \"1.14 MPa\"\nE_T = \"190 GPa\"\n";
    says(iron, "the set of Tetmajer-Yasinsky was given with E = 100 GPa, not 210 GPa");
    says(near, "the set of Tetmajer-Yasinsky was given with E = 190 GPa, not 210 GPa");
    std::vector<Issue> issues;
    static_cast<void>(solved("[bar]\n" + near, issues));
    CHECK_FALSE(has_errors(issues));
    static_cast<void>(solved("[bar]\n" + iron, issues));
    CHECK(has_errors(issues));
  }

  TEST_CASE("departures from common practice give a warning, and the bar is still computed") {
    const std::string made = rod + "d = \"40 mm\"\nmethod = \"tetmajer\"\nP = \"1 kN\"\n";
    CHECK(complaints(made + "tetmajer = \"St37\"\nn_st = 2\nmaterial_class = \"steel\"\n").empty());
    says(made + "tetmajer = \"St37\"\nn_st = 1.6\nmaterial_class = \"steel\"\n",
         "n_st = 1.6 is unusual for this class of material");
    says(made + "tetmajer = \"St50\"\nn_st = 2\n",
         "at its published limit 89 the set is 6.9 % above Euler's hyperbola");
    std::vector<Issue> issues;
    const project::Project p =
        solved("[bar]\n" + made + "tetmajer = \"St37\"\nn_st = 1.6\nmaterial_class = \"steel\"\n", issues);
    REQUIRE(issues.size() == 1);
    CHECK(issues[0].severity == Severity::warning);
    CHECK(p.value("bar.u") != nullptr);
  }

  TEST_CASE("a set that does not exist is reported with the nearest") {
    says(rod + "d = \"40 mm\"\nmethod = \"tetmajer\"\ntetmajer = \"St38\"\n", "no tetmajer 'St38' in the tables");
  }

  TEST_CASE("Euler below its limit is not covered, and no number is given") {
    std::vector<Issue> issues;
    const project::Project p =
        solved("[bar]\n" + rod + "d = \"60 mm\"\nmethod = \"euler\"\nsigma_P = \"190 MPa\"\nn_st = 2\nP = \"10 kN\"\n",
               issues);
    REQUIRE(issues.empty());
    CHECK(account::worst(project::verdicts(p)) == account::State::not_covered);
    CHECK(std::isnan(p.value("bar.P_all")->si[0]));
  }

  TEST_CASE("grey iron has no yield strength: the material gives E, the set the stress from lambda_0 on") {
    std::vector<Issue> issues;
    const project::Project p = solved(
        "[bar]\ncalculator = \"column.buckling\"\nl = \"900 mm\"\nends = \"pinned_pinned\"\nmaterial = \"GJL-200\"\n"
        "tetmajer = \"grey_iron\"\nd = \"60 mm\"\nmethod = \"tetmajer\"\nn_st = 5\nP = \"10 kN\"\n",
        issues);
    REQUIRE(issues.empty());
    CHECK(rel(p.value("bar.sigma_cr")->si[0], (776.0 - 12.0 * 60.0 + 0.053 * 3600.0) * 1e6) < 1e-9);
  }

  TEST_CASE("a link of a mechanism is a column: its force over the revolution, tension positive") {
    const std::string link = "[bar]\n" + rod + "d = \"40 mm\"\nmethod = \"johnson\"\nn_st = 2\n";
    std::vector<Issue> issues;
    CHECK(solved(link + "N = \"5 kN\"\n", issues).value("bar.u")->si[0] == 0.0);
    CHECK(issues.empty());
  }
}
