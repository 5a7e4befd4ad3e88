// Regression tests of bars: section values that are impossible next to others, curves and ends that are better than
// those of the section and of a link.
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string link(const std::string& lines) {
  return "[link]\ncalculator = \"link.member\"\nN = \"10 kN\"\nV = \"200 kN\"\nM_b = \"10 N*m\"\nl = \"400 mm\"\n"
         "ends_y = \"pinned_pinned\"\nends_z = \"fixed_fixed\"\nmaterial = \"S355JR\"\nmethod = \"johnson\"\n"
         "n_st = 2\nS = 1.5\n" +
         lines + "\n";
}

std::string strut(const std::string& lines) {
  return "[strut]\ncalculator = \"column.buckling\"\nP = \"100 kN\"\nl = \"1 m\"\nends = \"pinned_pinned\"\n"
         "material = \"S235JR\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1\n" +
         lines + "\n";
}

bool refuses(const std::string& text, const std::string& words) {
  return first_error_of(text).find(words) != std::string::npos;
}

std::string buckling_of(const std::string& text, const char* step = "strut") {
  return mode_of(solved_as_found(text), step, "buckling");
}

/// A rod of a press, taken by its record or by its force alone.
std::string rod_with(const std::string& load, const std::string& ends, const std::string& calculator) {
  return "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"40 mm\"\nl = \"1200 mm\"\n"
         "crank = { speed = \"120 rpm\", positions = 36 }\nlinks.rod.mass = \"2 kg\"\nlinks.slider.mass = \"5 kg\"\n"
         "[rod]\ncalculator = \"" +
         calculator + "\"\n" + load + "\n" + ends +
         "\nmaterial = \"S355JR\"\nmethod = \"johnson\"\nn_st = 3\nn_t = 2\n";
}

}  // namespace

TEST_SUITE("found sections") {
  TEST_CASE("the shear area cannot exceed the area, and of an I the web with its fillets") {
    CHECK(refuses(link("h = \"40 mm\"\nb = \"20 mm\"\nA_v = \"5000 mm^2\""), "cannot exceed the area"));
    CHECK(refuses(link("d = \"30 mm\"\nA_v = \"720 mm^2\""), "cannot exceed the area"));
    CHECK(first_error_of(link("h = \"40 mm\"\nb = \"20 mm\"\nA_v = \"530 mm^2\"")).empty());
    const auto shear = [](const std::string& lines) {
      return mode_of(solved_as_found(link("section = \"IPE 300\"\n" + lines)), "link", "shear");
    };
    CHECK(shear("") == "pass");
    CHECK(shear("A_v = \"2568 mm^2\"") == "pass");
    CHECK(shear("A_v = \"5000 mm^2\"") == "not-judged");
    CHECK(shear("A_v = \"5000 mm^2\"\nbecause.A_v = \"flanges cut out\"") == "pass");
  }

  TEST_CASE("walls, fibres and second moments are those of one section") {
    const std::string tube = "kind = \"hot_hollow\"\nh = \"100 mm\"\nb = \"100 mm\"\nA = \"1840 mm^2\"\n";
    const std::string of_tube = tube + "t_w = \"5 mm\"\nI_z = \"2.79e6 mm^4\"\nI_y = ";
    CHECK(first_error_of(strut(of_tube + "\"2.79e6 mm^4\"")).empty());
    CHECK(refuses(strut(of_tube + "\"3.5e6 mm^4\""), "1.15 times that of its walls"));
    CHECK(refuses(strut(tube + "t_w = \"52 mm\"\nI_y = \"2e6 mm^4\"\nI_z = \"2e6 mm^4\""), "half the width"));
    const std::string bare =
        "A = \"2000 mm^2\"\nI_y = \"3e6 mm^4\"\nI_z = \"1e6 mm^4\"\ncurve_y = \"c\"\ncurve_z = \"c\"\n";
    CHECK(refuses(strut(bare + "c_y = \"10 mm\""), "radius of gyration"));
    CHECK(first_error_of(strut(bare + "c_y = \"60 mm\"")).empty());
    CHECK(refuses(strut(bare + "I_min = \"2e6 mm^4\""), "I_min cannot exceed"));
    CHECK(refuses(strut("d = \"40 mm\"\nkind = \"hot_hollow\""), "is solid"));
    CHECK(refuses(strut("h = \"40 mm\"\nb = \"40 mm\"\nkind = \"rolled_I\"\nt_f = \"5 mm\""), "is solid"));
  }

  TEST_CASE("the extreme fibre of an unsymmetric section is no nearer than half its side") {
    const std::string tee =
        "P = \"10 kN\"\nmethod = \"secant\"\nn_st = 2\ngamma_M1 = \ngamma_F = \nkind = \"tee\"\nh = \"100 mm\"\n"
        "b = \"100 mm\"\nt_w = \"10 mm\"\nt_f = \"10 mm\"\nA = \"1900 mm^2\"\nI_y = \"1.8e6 mm^4\"\n"
        "I_z = \"8.4e5 mm^4\"\ne_y = \"20 mm\"\nd = \nends = \"pinned_pinned\"\nl = \"1 m\"\nsigma_P = \n";
    const ExampleStep near("column.buckling", tee + "c_y = \"32 mm\""),
        half("column.buckling", tee + "c_y = \"50 mm\"");
    REQUIRE(near.fault().empty());
    CHECK(near("axes.y.eta") == half("axes.y.eta"));
  }

  TEST_CASE("a buckling curve better than that of the table needs a reason, however the section is given") {
    const std::string bold = "curve_y = \"a0\"\ncurve_z = \"a0\"\n", table = "curve_y = \"c\"\ncurve_z = \"c\"\n";
    const std::string why = "because = { curve_y = \"tests\", curve_z = \"tests\" }\n";
    const std::string box = "A = \"1500 mm^2\"\nI_y = \"1e6 mm^4\"\nI_z = \"1e6 mm^4\"\n";
    for (const char* const section :
         {"d = \"40 mm\"\n", "h = \"40 mm\"\nb = \"40 mm\"\n", "section = \"HEA 160\"\n", "section = \"UPN 200\"\n",
          "A = \"1600 mm^2\"\nI_y = \"213333 mm^4\"\n"
          "I_z = \"213333 mm^4\"\n"}) {
      CHECK_MESSAGE(buckling_of(strut(section + bold)) == "not-judged", section);
      CHECK_MESSAGE(buckling_of(strut(section + table)) != "not-judged", section);
      CHECK_MESSAGE(buckling_of(strut(section + bold + why)) != "not-judged", section);
    }
    CHECK(buckling_of(strut(box + bold)) == "not-judged");  // no section of S235 has it
    CHECK(buckling_of(strut(box + "curve_y = \"a\"\ncurve_z = \"a\"\n")) == "pass");
    const std::string taken =
        "[other]\ncalculator = \"column.buckling\"\nl = \"1 m\"\nends = \"pinned_pinned\"\n"
        "E = \"210 GPa\"\nd = \"40 mm\"\nmethod = \"johnson\"\nR_e = \"235 MPa\"\ncurve_y = \"a0\"\n";
    CHECK(mode_of(solved_as_found(taken + strut("d = \"40 mm\"\ncurve_z = \"c\"\ncurve_y = \"=other.curve_y\"")),
                  "strut", "typed_values") == "not-judged");
  }

  TEST_CASE("a grade of steel has its yield strength") {
    const std::string hollow = "section = \"SHS 60x4\"\nkind = \"hot_hollow\"\ngrade = \"S460\"\n";
    CHECK(refuses(strut(hollow), "a yield strength of at least 400 MPa"));
    CHECK(first_error_of(strut(hollow + "because.R_e = \"certificate\"\nR_e = \"460 MPa\"")).empty());
    CHECK(!ExampleStep("column.lightest", "grade = \"S460\"").fault().empty());
  }

  TEST_CASE("a calculated effective length factor may be small, a typed one needs a reason") {
    const std::string found =
        "[ends]\ncalculator = \"column.effective_length\"\nl = \"1 m\"\nend_1 = \"pinned\"\n"
        "end_2 = \"pinned\"\nsupports = [[\"200 mm\"], [\"400 mm\"], [\"600 mm\"], [\"800 mm\"]]\n";
    const std::string solid = "d = \"40 mm\"\ncurve_y = \"c\"\ncurve_z = \"c\"\n";
    const auto with = [&](const std::string& beta) {
      std::string text = strut(solid + "beta_y = " + beta + "\nbeta_z = " + beta);
      return text.replace(text.find("ends = \"pinned_pinned\"\n"), 23, "");
    };
    CHECK(buckling_of(found + with("\"=ends.beta\"")) == "pass");
    CHECK(buckling_of(with("0.2")) == "not-judged");
    CHECK(buckling_of(with("0.2") + "because = { beta_y = \"guided\", beta_z = \"guided\" }\n") == "pass");
    CHECK(buckling_of("[values]\nbeta = 0.2\n" + with("\"=values.beta\"")) == "not-judged");
    CHECK(buckling_of(with("0.7")) == "pass");
  }

  TEST_CASE("a link of a mechanism turns on its joints about one axis") {
    const std::string size = "d = \"25 mm\"\n", taken = size + "load = \"=press.links.rod\"",
                      force = size + "N = \"=press.links.rod.N\"\nl = \"1200 mm\"";
    for (const std::string& load : {taken, force}) {
      const auto state = [&](const std::string& ends) {
        return buckling_of(rod_with(load, ends, "column.buckling"), "rod");
      };
      CHECK(state("ends = \"pinned_pinned\"") == "pass");
      CHECK(state("ends = \"fixed_fixed\"") == "not-judged");
      CHECK(state("ends = \"fixed_fixed\"\nbecause.ends = \"welded to both\"") == "pass");
      CHECK(state("ends_y = \"pinned_pinned\"\nends_z = \"fixed_fixed\"") == "pass");
      CHECK(state("ends_y = \"fixed_fixed\"\nends_z = \"pinned_pinned\"") == "pass");
      CHECK(state("ends_y = \"fixed_pinned\"\nends_z = \"fixed_fixed\"") == "not-judged");
      CHECK(state("beta_y = 0.6\nbeta_z = 0.6") == "not-judged");
      CHECK(state("beta_y = 1\nbeta_z = 0.6") == "pass");
    }
    const std::string lightest =
        "families = [\"CHS\"]\nkind = \"hot_hollow\"\nN = \"=min(press.links.rod.N)\"\nl = \"1200 mm\"\nbecause.N = "
        "\"the largest compression\"";
    CHECK(buckling_of(rod_with(lightest, "ends = \"fixed_fixed\"", "column.lightest"), "rod") == "not-judged");
    CHECK(buckling_of(rod_with(lightest, "ends = \"pinned_pinned\"", "column.lightest"), "rod") == "pass");
  }
}
