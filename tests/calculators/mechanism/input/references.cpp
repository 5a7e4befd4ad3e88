// References to inputs of a mechanism, or of its template, as to results.
#include "tests/lib/project/texts.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string press =
    "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"50 mm\"\nl = \"200 mm\"\n"
    "crank = { speed = \"60 rpm\", positions = 12 }\nlinks.rod.mass = \"3 kg\"\n"
    "loads = [{ name = \"cut\", link = \"slider\", at = \"B\", F_x = \"-1 kN\", F_y = \"0 N\" }]\n";

double moment_of(const std::string& expression) {
  return value(solved(press + axle + "T = \"=" + expression + "\"\ntau_adm = \"30 MPa\"\n"), "axle.M_max");
}

}  // namespace

TEST_SUITE("references to a mechanism") {
  TEST_CASE("parameters of its template, masses, loads and lengths") {
    CHECK(moment_of("press.r * 100 N") == doctest::Approx(5.0));
    CHECK(moment_of("press.l * 100 N") == doctest::Approx(20.0));
    CHECK(moment_of("press.links.rod.mass * 1 m^2/s^2") == doctest::Approx(3.0));
    CHECK(moment_of("press.links.rod.J / 1 s^2") == doctest::Approx(3.0 * 0.04 / 12.0));
    CHECK(moment_of("press.links.rod.length * 100 N") == doctest::Approx(20.0));
    CHECK(moment_of("press.links.crank.length * 100 N") == doctest::Approx(5.0));
    CHECK(moment_of("-press.loads.cut.F_x * 1 mm") == doctest::Approx(1.0));
    CHECK(moment_of("press.crank.positions * 1 N*m") == doctest::Approx(12.0));
  }

  TEST_CASE("a length from another step goes through the template to the column of the rod") {
    const std::string rod =
        "[rod]\ncalculator = \"column.buckling\"\nN = \"=press.links.rod.N\"\nl = \"=press.links.rod.length\"\n"
        "d = \"30 mm\"\nends = \"pinned_pinned\"\nmaterial = \"C45E\"\nmethod = \"johnson\"\nn_st = 3\n";
    const std::string text = replaced(press, "l = \"200 mm\"", "l = \"=10*axle.d\"") + axle +
                             "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\nd = \"25 mm\"\n" + rod;
    const auto p = solved(text);
    CHECK(value(p, "rod.l") == doctest::Approx(0.25));
    CHECK(value(p, "press.links.rod.length") == doctest::Approx(0.25));
  }

  TEST_CASE("a field that is not given has no value") {
    const auto said = [](const std::string& path) {
      return first_error(press + axle + "T = \"=" + path + " * 1 N*m\"\ntau_adm = \"30 MPa\"\n");
    };
    CHECK(said("press.links.rod.angle_of_rest") == "'press' has no result 'links.rod.angle_of_rest'");
    CHECK(said("press.crank.duration") == "'press' has no result 'crank.duration'");
  }
}
