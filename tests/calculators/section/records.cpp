// Sections as records: a column or a link takes the walls with the area and the second moments.
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

using namespace loadpath;
using test::mode_of;
using test::Solved;
using test::solved_as_found;

std::string section(const std::string& shape, const std::string& inputs) {
  return "[part]\ncalculator = \"section." + shape + "\"\n" + inputs + "\n";
}

std::string column(const std::string& inputs) {
  return "[bar]\ncalculator = \"column.buckling\"\nP = \"40 kN\"\nl = \"3 m\"\nends = \"pinned_pinned\"\n"
         "E = \"210 GPa\"\nR_e = \"235 MPa\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1\n" +
         inputs + "\n";
}

const std::string taken = "section = \"=part.section\"";

double utilisation(const std::string& text) { return Solved(text).value("bar.u"); }

}  // namespace

TEST_SUITE("section records") {
  TEST_CASE("a record of a shape gives the same as its typed dimensions") {
    const std::string I = "h = \"200 mm\"\nb = \"200 mm\"\nt_w = \"9 mm\"\nt_f = \"15 mm\"\nr = \"18 mm\"\n";
    const double from_record = utilisation(section("I", I + "fabrication = \"rolled\"") + column(taken));
    // HEB 200 of the tables: A = 7810 mm2, I_y = 56.96e6, I_z = 20.03e6 mm4
    const double typed = utilisation(
        column(I + "kind = \"rolled_I\"\nA = \"7808 mm^2\"\nI_y = \"56.96e6 mm^4\"\nI_z = \"20.03e6 mm^4\""));
    CHECK(from_record == doctest::Approx(typed).epsilon(2e-3));
    CHECK(from_record == doctest::Approx(utilisation(column("section = \"HEB 200\""))).epsilon(2e-3));
  }

  TEST_CASE("a round bar, a rectangle: the same as without a record") {
    CHECK(utilisation(section("circle", "d = \"60 mm\"") + column(taken)) ==
          doctest::Approx(utilisation(column("d = \"60 mm\""))).epsilon(1e-9));
    CHECK(utilisation(section("rectangle", "h = \"80 mm\"\nb = \"50 mm\"") + column(taken)) ==
          doctest::Approx(utilisation(column("h = \"80 mm\"\nb = \"50 mm\""))).epsilon(1e-9));
  }

  TEST_CASE("a section whose manufacture is not stated has the less favourable curve") {
    const std::string tube = "d = \"88.9 mm\"\nt = \"4 mm\"\n";
    const double open = utilisation(section("ring", tube) + column(taken));
    const double hot = utilisation(section("ring", tube + "fabrication = \"hot_finished\"") + column(taken));
    const double cold = utilisation(section("ring", tube + "fabrication = \"cold_formed\"") + column(taken));
    CHECK(open == doctest::Approx(cold).epsilon(1e-12));
    CHECK(hot < cold);
    CHECK(cold == doctest::Approx(utilisation(column("section = \"CHS 88.9x4\""))).epsilon(5e-3));
  }

  TEST_CASE("thin walls are assessed for local buckling, and fail beyond class 3") {
    const auto local = [](const std::string& t) {
      return mode_of(
          solved_as_found(section("hollow", "h = \"200 mm\"\nb = \"200 mm\"\nt = \"" + t + "\"") + column(taken)),
          "bar", "local");
    };
    CHECK(local("10 mm") == "pass");        // (200 - 30)/10 = 17 below 42
    CHECK(local("2 mm") == "not-covered");  // 97 above 42: class 4
  }

  TEST_CASE("with A and I alone the walls are not assessed, nor with a section of free shape") {
    const std::string box = section("hollow", "h = \"200 mm\"\nb = \"200 mm\"\nt = \"10 mm\"");
    std::string bar =
        column("A = \"=part.A\"\nI_y = \"=part.I_y\"\nI_z = \"=part.I_z\"\ncurve_y = \"c\"\ncurve_z = \"c\"");
    CHECK(mode_of(solved_as_found(box + bar), "bar", "local") == "not-judged");
    const std::string polygon = section(
        "polygon",
        "points = [[\"0 mm\", \"0 mm\"], [\"80 mm\", \"0 mm\"], [\"80 mm\", \"60 mm\"], [\"0 mm\", \"60 mm\"]]\n"
        "holes = [{ points = [[\"5 mm\", \"5 mm\"], [\"75 mm\", \"5 mm\"], [\"75 mm\", \"55 mm\"], "
        "[\"5 mm\", \"55 mm\"]] }]");
    bar = column(taken + "\ncurve_y = \"c\"\ncurve_z = \"c\"");
    CHECK(mode_of(solved_as_found(polygon + bar), "bar", "local") == "not-judged");
  }

  TEST_CASE("inclined principal axes: the bar buckles about the minimum axis") {
    const std::string angle = section("angle", "h = \"100 mm\"\nb = \"100 mm\"\nt = \"10 mm\"\nr = \"12 mm\"");
    const Solved bar(angle + column(taken));
    CHECK(bar.value("bar.I_min") == doctest::Approx(bar.value("part.I_min")));
    CHECK(bar.value("bar.u") == doctest::Approx(utilisation(column("section = \"L 100x100x10\""))).epsilon(0.02));
  }

  TEST_CASE("a dimension next to the record that contradicts it is another section") {
    const std::string bar = section("circle", "d = \"60 mm\"") + column(taken + "\nd = \"80 mm\"");
    CHECK(test::contains(test::first_error_of(bar), "d = 80 mm contradicts 'part.section.d', which has 60 mm"));
    CHECK(test::contains(test::first_error_of(section("circle", "d = \"60 mm\"") + column("section = \"=part.d\"")),
                         "takes the name of a row"));
  }

  TEST_CASE("a link takes a record like a column") {
    const std::string link =
        "[bar]\ncalculator = \"link.member\"\nN = \"-18 kN\"\nV = \"0.4 kN\"\nM_b = \"60 N*m\"\n"
        "l = \"400 mm\"\nends_y = \"pinned_pinned\"\nends_z = \"fixed_fixed\"\nE = \"210 GPa\"\n"
        "R_e = \"355 MPa\"\nmethod = \"johnson\"\nn_st = 3\nS = 1.5\n";
    const Solved from_record(section("rectangle", "h = \"40 mm\"\nb = \"20 mm\"") + link + taken);
    const Solved typed(link + "h = \"40 mm\"\nb = \"20 mm\"");
    for (const char* const value : {"bar.u", "bar.u_y", "bar.u_Q", "bar.u_p", "bar.u_i"})
      CHECK(from_record.value(value) == doctest::Approx(typed.value(value)).epsilon(1e-9));
  }

  TEST_CASE("no row of the tables is without the values that a method needs") {
    const Solved found(column("section = { stock = \"sections/chs\" }"));
    CHECK(found.value("bar.u") < 1.0);
    for (const Issue& issue : found.issues) CHECK_MESSAGE(issue.severity != Severity::error, issue.message.text());
  }
}
