// References of a step other than numbers: counts, words, rows of tables, lists, records, shared values.
#include "tests/lib/project/solved.hpp"
#include "tests/program.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

namespace {

using namespace loadpath;
using account::State;
using test::contains;
using test::Solved;

const std::string gears =
    "[gears]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = \"2.5 mm\"\nT_1 = \"60 N*m\"\nb = \"25 mm\"\n";
const std::string bar =
    "calculator = \"column.buckling\"\nP = \"100 kN\"\nl = \"3 m\"\nends = \"pinned_pinned\"\nmethod = "
    "\"ec3\"\ngamma_M1 = 1\ngamma_F = 1.4\n";

}  // namespace

TEST_SUITE("references") {
  TEST_CASE("a count follows another, and a sum of counts") {
    const Solved pair(gears +
                      "[next]\ncalculator = \"gear.pair\"\nz_1 = \"=gears.z_2\"\nz_2 = \"=gears.z_1 + 20\"\n"
                      "m_n = \"=gears.m_n\"\n");
    CHECK_MESSAGE(pair.messages().find("next") == std::string::npos, pair.messages());
    CHECK(pair.value("next.z_1") == 57.0);
    CHECK(pair.value("next.z_2") == 40.0);
    CHECK(pair.origin("next", "z_1") == "= gears.z_2");
  }

  TEST_CASE("a value that is not an integer is not a count, and nothing is rounded") {
    const Solved pair(gears + "[next]\ncalculator = \"gear.pair\"\nz_1 = \"=gears.z_2/2\"\nz_2 = 40\nm_n = \"2 mm\"\n");
    CHECK_MESSAGE(contains(pair.messages(), "z_1 = 28.5 is not an integer"), pair.messages());
    const Solved length(gears + "[next]\ncalculator = \"gear.pair\"\nz_1 = \"=gears.m_n\"\nz_2 = 40\nm_n = \"2 mm\"\n");
    CHECK_MESSAGE(contains(length.messages(), "next.z_1: 'z_1' is a plain number, but this expression is a length"),
                  length.messages());
    const Solved few(gears +
                     "[next]\ncalculator = \"gear.pair\"\nz_1 = \"=gears.z_1 - 20\"\nz_2 = 40\nm_n = \"2 mm\"\n");
    CHECK_MESSAGE(contains(few.messages(), "next.z_1: z_1 = 0"), few.messages());
  }

  TEST_CASE("a word of a choice is taken from a choice that has it") {
    const std::string first = "[first]\n" + bar + "section = \"HEA 160\"\nmaterial = \"S235JR\"\n";
    const Solved same(first +
                      "[other]\ncalculator = \"column.buckling\"\nP = \"=first.P\"\nl = \"=first.l\"\n"
                      "ends = \"=first.ends\"\nmethod = \"=first.method\"\ngamma_M1 = 1\ngamma_F = 1.4\n"
                      "section = \"=first.section\"\nmaterial = \"=first.material\"\n");
    REQUIRE_MESSAGE(!has_errors(same.issues), same.messages());
    CHECK(same.word("other.method") == "ec3");
    CHECK(same.word("other.section") == "HEA 160");
    CHECK(same.word("other.material") == "S235JR");
    CHECK(same.value("other.u") == same.value("first.u"));
    const Solved wrong(first + "[other]\n" + bar + "section = \"=first.ends\"\nmaterial = \"S235JR\"\n");
    CHECK_MESSAGE(contains(wrong.messages(), "first.ends = pinned_pinned"), wrong.messages());
    const Solved number(first + "[other]\n" + bar + "section = \"=first.P\"\nmaterial = \"S235JR\"\n");
    CHECK_MESSAGE(
        contains(number.messages(), "other.section: 'section' takes the name of a row, and 'first.P' is a number"),
        number.messages());
  }

  TEST_CASE("words are not numbers to calculate with") {
    const Solved sum("[first]\n" + bar + "section = \"=2*first.section\"\nmaterial = \"S235JR\"\n");
    CHECK_MESSAGE(contains(sum.messages(), "'section' takes the name of a row"), sum.messages());
    const Solved method("[a]\n" + bar +
                        "section = \"HEA 160\"\nmaterial = \"S235JR\"\n[b]\ncalculator = "
                        "\"column.buckling\"\nP = \"1 kN\"\nl = \"1 m\"\nmethod = \"=a.method + 1\"\n");
    CHECK_MESSAGE(contains(method.messages(), "'method' is not a number"), method.messages());
  }

  TEST_CASE("the section found by the search for the lightest is checked by itself") {
    const Solved found(
        "[pick]\ncalculator = \"column.lightest\"\nfamilies = [\"HEA\"]\nP = \"100 kN\"\nl = \"3 m\"\n"
        "ends = \"pinned_pinned\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1.4\nmaterial = \"S235JR\"\n"
        "[check]\n" +
        bar + "section = \"=pick.section\"\nmaterial = \"=pick.material\"\n");
    REQUIRE_MESSAGE(!has_errors(found.issues), found.messages());
    CHECK(found.word("check.section") == found.word("pick.section"));
    CHECK(found.value("check.u") == doctest::Approx(found.value("pick.u")));
    CHECK(found.value("check.u") <= 1.0);
  }

  TEST_CASE("words and lists of a mechanism are written out") {
    const std::string press =
        "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"50 mm\"\n"
        "l = \"200 mm\"\ncrank = { speed = \"60 rpm\", positions = 36 }\n";
    const Solved lists(press +
                       "loads = \"=other.torques\"\n[other]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\n"
                       "torques = [{ x = \"0 mm\", T = \"9 N*m\" }, { x = \"9 mm\", T = \"-9 N*m\" }]\n");
    CHECK_MESSAGE(has_errors(lists.issues), lists.messages());
  }

  TEST_CASE("unknown steps, results and circles are reported") {
    CHECK(contains(Solved("[a]\n" + bar + "section = \"=pik.section\"\nmaterial = \"S235JR\"\n").messages(),
                   "unknown step 'pik'"));
    CHECK(contains(Solved(gears + "[a]\n" + bar + "section = \"=gears.section\"\nmaterial = \"S235JR\"\n").messages(),
                   "'gears' has no result 'section'"));
    const Solved circle("[a]\n" + bar + "section = \"=b.section\"\nmaterial = \"S235JR\"\n[b]\n" + bar +
                        "section = \"=a.section\"\nmaterial = \"S235JR\"\n");
    CHECK(contains(circle.messages(), "circular reference between steps"));
    CHECK_MESSAGE(contains(circle.messages(), "a.section takes b.section (line "), circle.messages());
  }

  TEST_CASE("two bearings take Y of each other: a factor of the row is known before either is solved") {
    const auto one = [](const std::string& name, const std::string& row, const std::string& F_r,
                        const std::string& mate) {
      return "[" + name + "]\ncalculator = \"bearing.rolling\"\nbearing = \"" + row + "\"\nn = \"900 rpm\"\nF_r = \"" +
             F_r + " kN\"\nmate = { " + mate + " }\ncarries = \"" + name + "\"\n";
    };
    const std::string left = one("left", "30208", "4", "F_r = \"3 kN\", Y = \"=right.Y\"");
    const Solved pair(left + one("right", "32308", "3", "F_r = \"4 kN\", Y = \"=left.Y\""));
    REQUIRE_MESSAGE(!has_errors(pair.issues), pair.messages());
    CHECK(pair.value("left.F_ax") == doctest::Approx(0.5 * 4000.0 / 1.6));  // Y of 30208 and of 32308 as tabled
    CHECK(pair.value("right.F_ax") == doctest::Approx(0.5 * 4000.0 / 1.6));
    const Solved sought(left + one("right", "?", "3", "F_r = \"4 kN\", Y = \"=left.Y\""));
    CHECK(has_errors(sought.issues));  // no row yet, and so no Y
  }

  TEST_CASE("the first row that passes is found, and why the one before it fails") {
    const Solved found("[pick]\n" + bar + "section = \"?\"\nmaterial = \"S235JR\"\n");
    REQUIRE_MESSAGE(!has_errors(found.issues), found.messages());
    CHECK(found.value("pick.u") <= 1.0);
    CHECK(!found.word("pick.section").empty());
    const std::string how = found.origin("pick", "section");
    CHECK_MESSAGE(contains(how, "smallest of section with which no assessed mode fails; "), how);
    CHECK_MESSAGE(contains(how, "fails: u = "), how);
    const Solved in_one("[pick]\n" + bar + "section = { stock = \"sections/ipe\" }\nmaterial = \"S235JR\"\n");
    CHECK_MESSAGE(in_one.word("pick.section").starts_with("IPE "), in_one.messages());
    const Solved both("[pick]\n" + bar + "section = \"?\"\nA = \"10 cm^2\"\nmaterial = \"S235JR\"\n");
    CHECK_MESSAGE(contains(both.messages(), "'A' is given, and the section that is searched for gives it too"),
                  both.messages());
    CHECK_MESSAGE(contains(both.messages(), "search by it: section = { where = \"A = 10 cm^2\" }"), both.messages());
    const Solved more("[pick]\n" + bar + "section = { stock = \"sections/ipe\", max = 3 }\nmaterial = \"S235JR\"\n");
    CHECK_MESSAGE(contains(more.messages(), "'max' is not a valid key here"), more.messages());
    const Solved none("[pick]\n" + bar + "section = { stock = \"sections/ip\" }\nmaterial = \"S235JR\"\n");
    CHECK_MESSAGE(contains(none.messages(), "unknown table or kind of section 'sections/ip'"), none.messages());
    const Solved steel("[pick]\n" + bar + "section = \"IPE 200\"\nmaterial = \"?\"\n");
    CHECK_MESSAGE(contains(steel.messages(), "'material' cannot be searched for: its rows have no order"),
                  steel.messages());
  }
}

TEST_SUITE("largest values") {
  TEST_CASE("the largest load and the longest bar that pass, to four digits") {
    const std::string strut =
        "[strut]\ncalculator = \"column.buckling\"\nends = \"pinned_pinned\"\nmethod = \"ec3\"\n"
        "gamma_M1 = 1\ngamma_F = 1.4\nsection = \"HEA 160\"\nmaterial = \"S235JR\"\n";
    const Solved load(strut + "P = \"?\"\nl = \"3 m\"\n");
    REQUIRE_MESSAGE(!has_errors(load.issues), load.messages());
    const double P = load.value("strut.P");
    CHECK(load.value("strut.u") <= 1.0);
    CHECK(load.value("strut.u") > 0.999);
    CHECK(contains(load.origin("strut", "P"), "maximum with which no assessed mode fails; 1 % more: u = 1.01"));
    const Solved longest(strut + "P = \"" + std::to_string(P) + " N\"\nl = \"?\"\n");
    REQUIRE_MESSAGE(!has_errors(longest.issues), longest.messages());
    CHECK(longest.value("strut.l") == doctest::Approx(3.0).epsilon(1e-3));
  }

  TEST_CASE("the torque that a shaft transmits, by its own formula; and a search without a limit") {
    const std::string shaft = "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"?\"\nd = \"40 mm\"\n";
    const Solved torque(shaft + "tau_adm = \"30 MPa\"\n");
    REQUIRE_MESSAGE(!has_errors(torque.issues), torque.messages());
    CHECK(torque.value("shaft.T") == doctest::Approx(376.9));  // pi/16 * 0.04^3 * 30e6 = 376.99, rounded down
    CHECK(has_errors(Solved(shaft).issues));
  }

  TEST_CASE("a diameter of a column is searched for on request") {
    const Solved round(
        "[round]\ncalculator = \"column.buckling\"\nP = \"100 kN\"\nl = \"1 m\"\nd = \"?\"\n"
        "ends = \"pinned_pinned\"\nmaterial = \"S235JR\"\nmethod = \"johnson\"\nn_st = 3\n");
    REQUIRE_MESSAGE(!has_errors(round.issues), round.messages());
    CHECK(round.value("round.u") <= 1.0);
    CHECK(contains(round.origin("round", "d"), "smallest of R40 with which no assessed mode fails; "));
  }

  TEST_CASE("a tube of the tables has the curve of cold formed ones where the kind is not given") {
    const std::string tube =
        "[tube]\ncalculator = \"column.buckling\"\nP = \"90 kN\"\nl = \"3 m\"\nends = \"pinned_pinned\"\n"
        "material = \"S355\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1\n";
    const Solved all(tube + "section = \"?\"\n");
    REQUIRE_MESSAGE(!has_errors(all.issues), all.messages());
    CHECK(all.value("tube.u") <= 1.0);
    CHECK_MESSAGE(all.messages().empty(), all.messages());
    const Solved hot(tube + "section = { stock = \"sections/chs\" }\nkind = \"hot_hollow\"\n");
    REQUIRE_MESSAGE(!has_errors(hot.issues), hot.messages());
    CHECK_MESSAGE(hot.messages().empty(), hot.messages());
    const Solved unkind(tube + "section = { stock = \"sections/chs\" }\n");
    CHECK_MESSAGE(unkind.messages().empty(), unkind.messages());
    CHECK(hot.value("tube.A") <= unkind.value("tube.A"));
    CHECK(all.value("tube.A") <= unkind.value("tube.A"));
    const Solved both(tube + "section = \"?\"\nkind = \"hot_hollow\"\n");
    CHECK_MESSAGE(contains(both.errors(), "'kind' is given, and the section that is searched for gives it too"),
                  both.errors());
  }

  TEST_CASE("where no row and no load passes, nothing passes") {
    const std::string bar =
        "[bar]\ncalculator = \"column.buckling\"\nl = \"3 m\"\nends = \"pinned_pinned\"\nmaterial = \"S355\"\n";
    const Solved rows(bar +
                      "P = \"100000 kN\"\nsection = { stock = \"sections/ipe\" }\nmethod = \"ec3\"\n"
                      "gamma_M1 = 1\ngamma_F = 1\n");
    REQUIRE_MESSAGE(!has_errors(rows.issues), rows.messages());
    CHECK(contains(rows.origin("bar", "section"), "none passes"));
    CHECK(rows.mode("bar.buckling").state == State::not_available);
    // lambda = 300 is more than the 200 that are allowed, at every load
    const Solved load(bar + "d = \"40 mm\"\nP = \"?\"\nmethod = \"euler\"\nsigma_P = \"190 MPa\"\nn_st = 3\n");
    REQUIRE_MESSAGE(!has_errors(load.issues), load.messages());
    REQUIRE(load.has("bar.search"));
    CHECK_MESSAGE(contains(load.mode("bar.search").note.text(), "r_lambda = 1.5"), load.messages());
    const Solved bent(
        "[end]\ncalculator = \"shaft.overhung\"\nF = \"90 kN\"\na = \"1 m\"\nT = \"?\"\nd = \"20 mm\"\n"
        "sigma_adm = \"60 MPa\"\n");  // the force by itself is too much
    REQUIRE(bent.has("end.search"));
    CHECK_MESSAGE(contains(bent.mode("end.search").note.text(), "no 'T' passes"), bent.messages());
    const Solved unsafe(bar + "d = \"40 mm\"\nP = \"?\"\nmethod = \"johnson\"\n");
    CHECK_MESSAGE(contains(unsafe.errors(), "n_st"), unsafe.errors());
  }

  TEST_CASE("the found value is reported with the modes that are not assessed") {
    const Solved pulled(
        "[bar]\ncalculator = \"column.buckling\"\nl = \"1 m\"\nends = \"pinned_pinned\"\nmaterial = \"S355\"\n"
        "d = \"?\"\nN = \"25 kN\"\nmethod = \"johnson\"\nn_st = 3\n");
    REQUIRE_MESSAGE(!has_errors(pulled.issues), pulled.messages());
    CHECK_MESSAGE(contains(pulled.origin("bar", "d"), "; not assessed: tension"), pulled.origin("bar", "d"));
  }

  TEST_CASE("a chain is found by its pitch") {
    const Solved chain(
        "[chain]\ncalculator = \"chain.roller\"\nchain = \"?\"\nz_1 = 21\nz_2 = 57\na = \"1 m\"\n"
        "P = \"3 kW\"\nn_1 = \"96 rpm\"\np_adm = \"30 MPa\"\nS_min = 8\n");
    REQUIRE_MESSAGE(!has_errors(chain.issues), chain.messages());
    CHECK(chain.value("chain.u_p") <= 1.0);
    CHECK(chain.value("chain.u_S") <= 1.0);
    CHECK(!chain.word("chain.chain").empty());
  }
}

TEST_SUITE("shared values") {
  TEST_CASE("a value that is the whole text is read by the field that takes it") {
    const Solved shared(
        "[values]\nmodule = \"2.5 mm\"\nteeth = 20\nsteel = \"S235JR\"\nheld = \"pinned_pinned\"\n"
        "[gears]\ncalculator = \"gear.pair\"\nz_1 = \"=values.teeth\"\nz_2 = 57\nm_n = \"=values.module\"\n"
        "[a]\ncalculator = \"column.buckling\"\nP = \"100 kN\"\nl = \"3 m\"\nends = \"=values.held\"\n"
        "method = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1.4\nsection = \"HEA 160\"\nmaterial = \"=values.steel\"\n");
    REQUIRE_MESSAGE(!has_errors(shared.issues), shared.messages());
    CHECK(shared.value("gears.z_1") == 20.0);
    CHECK(shared.value("gears.m_n") == doctest::Approx(0.0025));
    CHECK(shared.word("a.ends") == "pinned_pinned");
    CHECK(shared.word("a.material") == "S235JR");
    CHECK(contains(shared.origin("gears", "m_n"), "values.module"));
  }

  TEST_CASE("inside an expression it is a literal") {
    const Solved twice(
        "[values]\nm = \"2.5 mm\"\n[gears]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = "
        "\"=2*values.m\"\n");
    REQUIRE_MESSAGE(!has_errors(twice.issues), twice.messages());
    CHECK(twice.value("gears.m_n") == doctest::Approx(0.005));
    const Solved word(
        "[values]\nm = \"HEA 160\"\n[gears]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = "
        "\"=2*values.m\"\n");
    CHECK_MESSAGE(contains(word.messages(), "'values.m' is not a number or quantity"), word.messages());
    const Solved unit(
        "[values]\nP = \"5,5 KW\"\n[shaft]\ncalculator = \"shaft.torsion\"\nT = \"=values.P/(120 rpm)\"\n"
        "tau_adm = \"30 MPa\"\n");
    CHECK_MESSAGE(contains(unit.messages(), "is not a number or quantity: unknown unit 'KW'"), unit.messages());
    CHECK_MESSAGE(contains(unit.messages(), "did you mean 'kW'?"), unit.messages());
  }

  TEST_CASE("a field accepts 120 1/min as revolutions, an expression does not") {
    const std::string belt =
        "[belt]\ncalculator = \"belt.course\"\npulleys = [{ x = \"0 mm\", y = \"0 mm\", d = \"160 mm\" }, "
        "{ x = \"600 mm\", y = \"0 mm\", d = \"250 mm\" }]\n";
    const std::string shaft = "[shaft]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\n";
    const Solved taken("[values]\nn = \"120 1/min\"\n" + belt + "n_1 = \"=values.n\"\n");
    CHECK_MESSAGE(!has_errors(taken.issues), taken.messages());
    for (const char* n : {"\"120 1/min\"", "{ from = \"100 min^-1\", to = \"120 min^-1\", count = 2 }"}) {
      const Solved used("[values]\nn = " + std::string(n) + "\n" + shaft + "T = \"=5.5 kW/values.n\"\n");
      CHECK_MESSAGE(contains(used.messages(), "is ambiguous: a speed of rotation or a frequency"), used.messages());
      CHECK(contains(used.messages(), "write rpm"));
    }
    const Solved right("[values]\nn = \"120 rpm\"\n" + shaft + "T = \"=5.5 kW/values.n\"\n");
    CHECK_MESSAGE(!has_errors(right.issues), right.messages());
  }

  TEST_CASE("a value may be an expression, a list or another value") {
    const Solved chain("[values]\na = \"=values.b\"\nb = \"=1.4*gears.T_2\"\n" + gears +
                       "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"=values.a\"\ntau_adm = \"30 MPa\"\n");
    REQUIRE_MESSAGE(!has_errors(chain.issues), chain.messages());
    CHECK(chain.value("shaft.T") == doctest::Approx(1.4 * chain.value("gears.T_2")));
    const Solved list(
        "[values]\nall = [\"HEA\", \"HEB\"]\n[pick]\ncalculator = \"column.lightest\"\nfamilies = "
        "\"=values.all\"\nP = \"100 kN\"\nl = \"3 m\"\nends = \"pinned_pinned\"\nmethod = \"ec3\"\n"
        "gamma_M1 = 1\ngamma_F = 1.4\nmaterial = \"S235JR\"\n");
    CHECK_MESSAGE(!has_errors(list.issues), list.messages());
  }

  TEST_CASE("values in values are limited, and a circle through lists is one") {
    std::string doubled = "[values]\na0 = [\"1 mm\"]\n";
    for (int i = 1; i <= 60; ++i) {
      const std::string last = "\"=values.a" + std::to_string(i - 1) + "\"";
      doubled += "a" + std::to_string(i) + " = [" + last + ", " + last + "]\n";
    }
    const auto shaft = [](const std::string& list) {
      return "[shaft]\ncalculator = \"shaft.torsion\"\nd = \"40 mm\"\ntorques = \"=values." + list + "\"\n";
    };
    if (!test::sanitized)
      CHECK_MESSAGE(contains(Solved(doubled + shaft("a20")).errors(), "nested values give too many values"), "2^20");
    CHECK_MESSAGE(contains(Solved(doubled + shaft("a60")).errors(), "nested values give too many values"), "60 deep");
    const Solved circle("[values]\na = [\"=values.b\"]\nb = [\"=values.a\"]\n" + shaft("a"));
    CHECK_MESSAGE(contains(circle.errors(), "values.a -> values.b -> values.a"), circle.errors());
    const Solved unknown("[values]\nn = \"1 rpm\"\n" + shaft("m"));
    CHECK_MESSAGE(contains(unknown.errors(), "unknown value 'm'"), unknown.errors());
    CHECK_MESSAGE(!contains(unknown.messages(), "no step"), unknown.messages());
    CHECK_MESSAGE(!contains(unknown.messages(), "nothing refers"), unknown.messages());
  }

  TEST_CASE("errors in values are reported at their place") {
    CHECK(contains(Solved("[values]\nm = \"2 mm\"\n[gears]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = "
                          "\"=values.n\"\n")
                       .messages(),
                   "unknown value 'n'"));
    CHECK(contains(Solved("[values]\na = \"=values.b\"\nb = \"=values.a\"\n" + gears).messages(),
                   "circular reference between values: values.a -> values.b -> values.a"));
    CHECK(contains(Solved("[values]\n\"1a\" = 3\n" + gears).messages(), "'1a' is not a valid name"));
    CHECK(contains(Solved("values = 3\n" + gears).messages(), "'values' is a table of values"));
    CHECK(contains(Solved("[values]\na = 3\n" + gears).messages(), "nothing refers to 'values.a'"));
    CHECK(contains(Solved("[values]\na = \"3 kg\"\n[gears]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = "
                          "\"=values.a\"\n")
                       .messages(),
                   "gears.m_n"));
  }

  TEST_CASE("a list that is taken whole keeps its series, and its elements their numbers") {
    const std::string crank = R"([press]
calculator = "mechanism.planar"
template = "slider_crank"
r = "50 mm"
l = "200 mm"
crank = { speed = "60 rpm", positions = 12 }
loads = [{ link = "slider", at = "B", F_x = "-10 kN" }]
[line]
calculator = "shaft.torsion"
d = "60 mm"
tau_adm = "60 MPa"
fixed = "left"
torques = { wheel = { x = "0 mm", T = "=press.drive.M" }, other = { x = "1 m", T = "-10 N*m" } }
[same]
calculator = "shaft.torsion"
d = "60 mm"
fixed = "left"
tau_adm = "60 MPa"
torques = "=line.torques"
)";
    const Solved taken(crank);
    REQUIRE_MESSAGE(!has_errors(taken.issues), taken.errors());
    REQUIRE(taken.project.value("same.M_max")->si.size() == 12);
    for (std::size_t i = 0; i < 12; ++i)
      CHECK(taken.project.value("same.M_max")->si[i] == taken.project.value("line.M_max")->si[i]);
    CHECK(taken.value("line.torques[2].x") == 1.0);
    const Solved named(
        "[line]\ncalculator = \"shaft.torsion\"\nT = \"1 N*m\"\ntau_adm = \"60 MPa\"\nsegments = { a = { l = \"1 mm\", "
        "d = \"2 mm\" }, "
        "b = { l = \"1 mm\", d = \"4 mm\", d_bore = \"1 mm\" } }\n"
        "[next]\ncalculator = \"shaft.torsion\"\nT = \"1 N*m\"\ntau_adm = \"60 MPa\"\nd = \"9 mm\"\nd_bore = "
        "\"=line.segments[1].d_bore\"\n");
    CHECK(named.value("line.segments[1].d_bore") != 1e-3);
    CHECK(named.value("line.segments[2].d_bore") == 1e-3);
  }

  TEST_CASE("a length brings no loads with it") {
    const Solved beside(
        gears +
        "[axle]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nd = \"?\"\nload = \"=gears.gear_2\"\n"
        "[neighbour]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nd = \"=axle.d\"\nT = \"10 N*m\"\n");
    REQUIRE_MESSAGE(!has_errors(beside.issues), beside.errors());
    CHECK(beside.project.find("neighbour")->loads().left.empty());
  }

  TEST_CASE("a misspelt record is reported with the intended one") {
    const Solved mistyped(gears +
                          "[axle]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nload = \"=gears.gear_3\"\n");
    CHECK_MESSAGE(contains(mistyped.errors(), "did you mean 'gears.gear_"), mistyped.errors());
  }

  TEST_CASE("what a record cannot give is reported at the record") {
    const Solved wrong(
        "[pick]\ncalculator = \"belt.v_sizing\"\nbasis = \"optibelt\"\nP = \"11 kW\"\nK_A = 1.2\nn_1 = \"1460 rpm\"\n"
        "n_2_set = \"730 rpm\"\na_set = \"600 mm\"\n"
        "[end]\ncalculator = \"shaft.overhung\"\na = \"60 mm\"\nsigma_adm = \"60 MPa\"\nload = \"=pick.best\"\n");
    CHECK_MESSAGE(contains(wrong.errors(), "pick.best"), wrong.errors());
  }

  TEST_CASE("an error of a step causes no others in those that take from it") {
    const std::string taker =
        "[shaft]\ncalculator = \"shaft.torsion\"\nload = \"=gears.gear_1\"\ntau_adm = \"40 MPa\"\n";
    const auto lines = [&](std::string text) {
      const std::string errors = Solved(text + taker).errors();
      return std::count(errors.begin(), errors.end(), '\n');
    };
    CHECK(lines(gears) == 0);
    std::string misspelt = gears, broken = gears;
    CHECK(lines(misspelt.replace(misspelt.find("gear.pair"), 9, "gear.pear")) == 1);
    CHECK(lines(broken.replace(broken.find("z_1 = 20"), 8, "z_1 = \"x\"")) == 1);
    CHECK(contains(Solved("[value]\nT = \"1 N*m\"\n").errors(), "did you mean 'values'?"));
  }

  TEST_CASE("a bearing that the shaft does not have is reported with those that it has") {
    const std::string text =
        "[shaft]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\npieces = [{ l = \"200 mm\", d = \"40 mm\" }]\n"
        "supports = [{ x = \"45 mm\", holds = \"both\" }, { x = \"185 mm\" }]\n"
        "seats = [{ x = \"100 mm\", F_x = \"-1 kN\" }]\nS_F = 1.2\n"
        "[left]\ncalculator = \"bearing.rolling\"\nkind = \"deep_groove_ball\"\nC = \"29.1 kN\"\nC_0 = \"17.9 kN\"\n"
        "f_0 = 14\nn = \"100 rpm\"\nL_h = \"20000 h\"\nload = \"=shaft.bearings";
    CHECK(contains(Solved(text + ".left\"\n").errors(), "'shaft.bearings' has no 'left'; available: [1], [2]"));
    CHECK(Solved(text + "[1]\"\n").errors() == "");
  }

  TEST_CASE("an element that a solved list does not have, and a list without an element, are named") {
    const std::string tubes =
        "[filled]\ncalculator = \"vessel.compound\"\np = \"80 MPa\"\nd_i = \"150 mm\"\nd = \"250 mm\"\n"
        "D = \"300 mm\"\np_c = \"10 MPa\"\nE_1 = \"200 GPa\"\nE_2 = \"200 GPa\"\nnu_1 = 0.3\nnu_2 = 0.3\n"
        "[life]\ncalculator = \"fatigue.life\"\nsigma_min = \"0 MPa\"\nsigma_D = \"200 MPa\"\nR_m = \"500 MPa\"\n"
        "group = \"carbon-steel\"\nS_D = 1.5\n";
    CHECK(contains(Solved(tubes + "sigma_max = \"=filled.states.service.sigma_2i\"\n").errors(),
                   "'filled.states' has no 'service'; available: "));
    CHECK(contains(Solved(tubes + "sigma_max = \"=filled.states\"\n").errors(), "write filled.states.NAME.KEY"));
  }

  TEST_CASE("a force whose sign does not mean tension is not a normal force without a sign") {
    const std::string crank =
        "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"50 mm\"\nl = \"500 mm\"\n"
        "crank = { speed = \"60 rpm\", positions = 12 }\nloads = [{ link = \"slider\", at = \"B\", F_x = \"-12 kN\" "
        "}]\n"
        "[rod]\ncalculator = \"column.buckling\"\nd = \"14 mm\"\nl = \"500 mm\"\nends = \"pinned_pinned\"\nE = \"210 "
        "GPa\"\n"
        "R_e = \"235 MPa\"\nmethod = \"johnson\"\nn_st = 3\nn_t = 2\nN = \"=";
    for (const char* wrong : {"press.joints.A.F", "press.joints.A.x", "2*press.joints.A.F", "press.drive.M/(50 mm)",
                              "sqrt(press.links.rod.N^2)", "max(press.links.rod.N, 0 N)"})
      CHECK_MESSAGE(contains(Solved(crank + wrong + "\"\n").errors(), "the sign of 'N' matters"), wrong);
    for (const char* right : {"press.links.rod.N", "-press.joints.A.F", "0 N + press.joints.A.F",
                              "1.1*press.links.rod.N", "min(press.links.rod.N, 0 N)", "min(press.links.rod.N)"})
      CHECK_MESSAGE(!has_errors(Solved(crank + right + "\"\n").issues), right);
  }
}
