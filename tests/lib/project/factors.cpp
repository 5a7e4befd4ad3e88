// Factors travel with loads, and loads that act together travel together.
#include "tests/lib/project/solved.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

namespace {

using namespace loadpath;
using account::State;
using test::contains;
using test::Solved;

std::string chain(const std::string& K_A) {
  return "[chain]\ncalculator = \"chain.roller\"\nchain = \"16B\"\nz_1 = 21\nz_2 = 57\na = \"1 m\"\nP = \"3 kW\"\n"
         "n_1 = \"96 rpm\"\nK_A = " +
         K_A + "\np_adm = \"30 MPa\"\n";
}
std::string end(const std::string& loads) {
  return "[end]\ncalculator = \"shaft.overhung\"\na = \"60 mm\"\nsigma_adm = \"60 MPa\"\n" + loads + "\n";
}
const std::string gears =
    "[gears]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = \"2.5 mm\"\nT_1 = \"60 N*m\"\nb = \"25 mm\"\n";

}  // namespace

TEST_SUITE("factors") {
  TEST_CASE("a service factor that a load includes is not applied again") {
    const Solved twice(chain("1.4") + end("F = \"=chain.F_W\"\nT = \"0 N*m\"\nK_A = 1.3"));
    CHECK_MESSAGE(contains(twice.errors(), "end.K_A: K_A would be applied twice: 'F' includes chain.K_A = 1.4"),
                  twice.errors());
    CHECK(Solved(chain("1.4") + end("F = \"=chain.F_W\"\nT = \"0 N*m\"")).errors().empty());
    CHECK(Solved(chain("1") + end("F = \"=chain.F_W\"\nT = \"0 N*m\"\nK_A = 1.3")).errors().empty());
    CHECK(Solved(chain("1.4") + end("F = \"=chain.F_t\"\nT = \"0 N*m\"\nK_A = 1.3")).errors().empty());
  }

  TEST_CASE("loads with a factor and without it do not act on one part") {
    const Solved unlike(chain("1.4") + end("F = \"=chain.F_W\"\nT = \"=chain.T_2\""));
    CHECK_MESSAGE(contains(unlike.errors(), "end.T: 'F' includes chain.K_A = 1.4, and 'T' does not"), unlike.errors());
    const Solved alike(chain("1.4") + end("F = \"=chain.F_W\"\nT = \"=chain.K_A*chain.T_2\""));
    CHECK_MESSAGE(alike.errors().empty(), alike.errors());
    const Solved without(chain("1.4") + end("F = \"=chain.F_W/chain.K_A\"\nT = \"=chain.T_2\"\nK_A = 1.4"));
    CHECK_MESSAGE(without.errors().empty(), without.errors());
  }

  TEST_CASE("reactions of a mechanism include what its loads include") {
    const auto press = [](const std::string& K_A) {
      return chain("1.4") +
             "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"50 mm\"\nl = \"200 mm\"\n"
             "crank = { speed = \"60 rpm\", positions = 36 }\n"
             "loads = [{ link = \"slider\", at = \"B\", F_x = \"=chain.F_W\", F_y = \"0 N\" }]\n" +
             end("load = \"=press.drive\"\n" + K_A);
    };
    const Solved twice(press("K_A = 1.2"));
    CHECK_MESSAGE(contains(twice.errors(), "K_A would be applied twice"), twice.errors());
    const Solved once(press(""));
    CHECK_MESSAGE(once.errors().empty(), once.errors());
  }

  TEST_CASE("a factor is not applied twice in one expression, nor as its square") {
    const auto errors_of = [](const std::string& F) {
      return Solved(chain("1.4") + end("F = \"=" + F + "\"\nT = \"0 N*m\"")).errors();
    };
    CHECK(contains(errors_of("chain.F_W + chain.F_t"), "'chain.F_W' includes chain.K_A, and 'chain.F_t' does not"));
    CHECK(contains(errors_of("max(chain.F_t, chain.F_W)"), "'chain.F_W' includes chain.K_A, and 'chain.F_t' does not"));
    CHECK(contains(errors_of("chain.K_A*chain.F_W"), "K_A would be applied twice: 'chain.K_A' includes chain.K_A"));
    CHECK(errors_of("chain.F_W + 100 N") == "");
    for (const char* square : {"chain.F_W*chain.F_W/(1 N)", "chain.F_W^2/(1 N)", "chain.F_W/(1 N)*chain.F_W"}) {
      CAPTURE(square);
      CHECK(contains(errors_of(square), "K_A would be applied twice: 'chain.F_W"));
    }
    for (const char* once : {"sqrt(chain.F_W^2 + chain.F_W*chain.F_W)", "chain.F_W*chain.F_W/chain.F_W",
                             "chain.K_A*chain.F_W/chain.K_A", "(1/chain.K_A)*chain.F_W*chain.K_A"}) {
      CAPTURE(once);
      CHECK(errors_of(once) == "");
    }
  }

  TEST_CASE("differing factors are named, common ones are not") {
    const Solved unlike(chain("1.4") + gears + "K_f = 1.5\n" +
                        end("F = \"=max(chain.F_W, gears.K_f*chain.F_W)\"\nT = \"0 N*m\""));
    CHECK_MESSAGE(contains(unlike.errors(), "'gears.K_f*chain.F_W' includes gears.K_f, and 'chain.F_W' does not"),
                  unlike.errors());
  }

  TEST_CASE("factors of one kind are equal where their values are") {
    const auto both = [](const std::string& K_A) {
      return chain("1.4") + gears + "K_A = " + K_A + "\n" + end("F = \"=chain.F_W\"\nT = \"=gears.K_A*gears.T_2\"") +
             "[next]\ncalculator = \"shaft.overhung\"\na = \"60 mm\"\nsigma_adm = \"60 MPa\"\nF = \"=end.F\"\n"
             "T = \"=end.T/gears.K_A\"\n";
    };
    CHECK_MESSAGE(
        contains(Solved(both("1.2")).errors(), "end.F: 'T' includes gears.K_A = 1.2, and 'F' includes chain.K_A = 1.4"),
        Solved(both("1.2")).errors());
    // Of equal ones both names stay: the next step knows them, and to divide by either takes them out.
    CHECK_MESSAGE(contains(Solved(both("1.4")).errors(), "next.T: 'F' includes chain.K_A = 1.4, and 'T' does not"),
                  Solved(both("1.4")).errors());
    CHECK(contains(
        Solved(chain("1.4") + gears + "K_A = 1.2\n" + end("F = \"=chain.F_W + gears.K_A*gears.F_tw\"\nT = \"0 N*m\""))
            .errors(),
        "'chain.F_W' includes chain.K_A, and 'gears.K_A*gears.F_tw' includes gears.K_A"));
  }

  TEST_CASE("moments that a step finds include what its loads include") {
    const auto line = [](const std::string& K_A) {
      return chain("1.4") +
             "[line]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nT = \"=chain.K_A*chain.T_2\"\n" +
             "[bolt]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nT = \"=line.M_max\"\n" + K_A;
    };
    CHECK_MESSAGE(
        contains(Solved(line("K_A = 1.3\n")).errors(), "K_A would be applied twice: 'T' includes chain.K_A = 1.4"),
        Solved(line("K_A = 1.3\n")).errors());
    CHECK_MESSAGE(Solved(line("")).errors().empty(), Solved(line("")).errors());
  }

  TEST_CASE("lists that are taken whole include the factors of their loads") {
    const auto line = [](const std::string& K_A) {
      return chain("1.4") +
             "[line]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nfixed = \"left\"\n"
             "torques = [{ x = \"1 m\", T = \"=chain.K_A*chain.T_2\" }]\n"
             "[next]\ncalculator = \"shaft.torsion\"\ntau_adm = \"40 MPa\"\nfixed = \"left\"\n"
             "torques = \"=line.torques\"\n" +
             K_A;
    };
    CHECK_MESSAGE(
        contains(Solved(line("K_A = 1.3\n")).errors(), "K_A would be applied twice: 'torques' includes chain.K_A"),
        Solved(line("K_A = 1.3\n")).errors());
    CHECK_MESSAGE(Solved(line("")).errors().empty(), Solved(line("")).errors());
  }

  TEST_CASE("a factor that is 1 counts as none, however it is written") {
    const auto own = [](const std::string& K_A) {
      return Solved(chain("1.4") + gears + end("F = \"=chain.F_W\"\nT = \"0 N*m\"\nK_A = \"=" + K_A + "\"")).errors();
    };
    CHECK_MESSAGE(own("max(1, gears.x_1)").empty(), own("max(1, gears.x_1)"));
    CHECK_MESSAGE(own("gears.K_A").empty(), own("gears.K_A"));
    CHECK(contains(own("1.1*gears.K_A"), "K_A would be applied twice"));
  }

  TEST_CASE("a position of a series is not a load, nor is an angle between loads") {
    const auto held = [](const std::string& text) {
      const auto expression = Expression::parse(text);
      REQUIRE(expression);
      const auto factors = expression->factors([](const std::string& path) {
        return path.starts_with("press.") ? Factors{{"chain.K_A", 1.4}} : Factors{};
      });
      REQUIRE(factors);
      return *factors;
    };
    CHECK(held("at(press.drive.M, lever.phi_0)") == Factors{{"chain.K_A", 1.4}});
    CHECK(held("press.F*cos(atan2(press.F_y, press.F_x))") == Factors{{"chain.K_A", 1.4}});
    CHECK(held("abs(lever.x)*peak(press.F)") == Factors{{"chain.K_A", 1.4}});
    CHECK(held("press.F_y/press.F_x") == Factors{});
  }
}

TEST_SUITE("shaft loads") {
  TEST_CASE("a factor in [values] is that of the step which has it") {
    const auto shared = [](const std::string& loads) {
      return Solved("[values]\nservice = 1.4\n" + chain("\"=values.service\"") + end(loads)).errors();
    };
    const std::string twice = shared("F = \"=values.service*chain.F_t\"\nT = \"=values.service*chain.T_2\"\nK_A = 1.4");
    CHECK_MESSAGE(contains(twice, "K_A would be applied twice"), twice);
    CHECK(shared("F = \"=values.service*chain.F_t\"\nT = \"=values.service*chain.T_2\"") == "");
    CHECK(contains(shared("F = \"=values.service*chain.F_W\"\nT = \"0 N*m\""), "twice"));
  }

  TEST_CASE("the power of a train includes the factors of its torque") {
    const std::string train =
        chain("1.4") +
        "[train]\ncalculator = \"drive.train\"\nT_1 = \"=chain.shaft_2.T\"\nn_1 = \"30 rpm\"\n"
        "stages = [{ kind = \"gear\", z_1 = 20, z_2 = 60 }]\n"
        "[next]\ncalculator = \"chain.roller\"\nchain = \"16B\"\nz_1 = 21\nz_2 = 57\na = \"1 m\"\n"
        "P = \"=train.P_out\"\nn_1 = \"10 rpm\"\np_adm = \"30 MPa\"\nK_A = ";
    CHECK_MESSAGE(contains(Solved(train + "1.4\n").errors(), "K_A would be applied twice"),
                  Solved(train + "1.4\n").errors());
    CHECK(Solved(train + "1\n").errors() == "");
  }

  TEST_CASE("a shaft takes a mounted component whole, with its service factor") {
    const Solved taken(chain("1.4") + end("load = \"=chain.shaft_2\""));
    REQUIRE_MESSAGE(taken.errors().empty(), taken.errors());
    CHECK(taken.value("end.F") == doctest::Approx(taken.value("chain.F_W")));
    CHECK(taken.value("end.T") == doctest::Approx(1.4 * taken.value("chain.T_2")));
    CHECK(taken.mode("end.other_loads").state == State::open);
    const Solved twice(chain("1.4") + end("load = \"=chain.shaft_2\"\nK_A = 1.2"));
    CHECK_MESSAGE(contains(twice.errors(), "K_A would be applied twice"), twice.errors());
  }

  TEST_CASE("a force that is taken without its torque leaves the torque not assessed") {
    const auto other_loads = [](const std::string& source, const std::string& loads) {
      const Solved solved(source + end(loads));
      REQUIRE_MESSAGE(solved.errors().empty(), solved.errors());
      return solved.mode("end.other_loads");
    };
    const account::Mode alone = other_loads(chain("1.4"), "F = \"=chain.F_W\"\nT = \"0 N*m\"");
    CHECK(alone.state == State::not_judged);
    CHECK_MESSAGE(contains(alone.note.text(), "chain.T_1, chain.T_2"), alone.note.text());
    for (const char* torque : {"chain.T_1", "chain.T_2"}) {
      CAPTURE(torque);
      const std::string T = std::string("T = \"=chain.K_A*") + torque + "\"";
      CHECK(other_loads(chain("1.4"), "F = \"=chain.F_W\"\n" + T).state == State::open);
    }
    const std::string belts =
        "[belt]\ncalculator = \"belt.v\"\nbasis = \"optibelt\"\nsection = \"SPB\"\nP = \"30 kW\"\nK_A = 1.2\n"
        "n_1 = \"1460 rpm\"\nd_1 = \"200 mm\"\nd_2 = \"400 mm\"\nL = \"2650 mm\"\n";
    for (const char* F : {"R_0", "R_new", "R", "R_x", "R_y"}) {
      CAPTURE(F);
      const account::Mode mode = other_loads(belts, std::string("F = \"=belt.") + F + "\"\nT = \"0 N*m\"");
      CHECK(mode.state == State::not_judged);
      CHECK_MESSAGE(contains(mode.note.text(), "belt.shaft_1.T, belt.shaft_2.T"), mode.note.text());
    }
    CHECK(other_loads(belts, "F = \"=belt.shaft_2.F\"\nT = \"=belt.shaft_2.T\"").state == State::open);
    for (const char* F : {"F_tw", "F_rw", "F_x1", "F_y1", "F_x2", "F_y2"}) {
      CAPTURE(F);
      const account::Mode mode = other_loads(gears, std::string("F = \"=gears.") + F + "\"\nT = \"0 N*m\"");
      CHECK(mode.state == State::not_judged);
    }
    CHECK(other_loads(gears, "F = \"=sqrt(gears.F_x2^2 + gears.F_y2^2)\"\nT = \"=gears.T_2\"").state == State::open);
  }

  TEST_CASE("a typed value next to a record is kept") {
    const Solved typed(chain("1.4") + end("load = \"=chain.shaft_2\"\nT = \"900 N*m\""));
    REQUIRE_MESSAGE(typed.errors().empty(), typed.errors());
    CHECK(typed.value("end.T") == 900.0);
    REQUIRE(!typed.project.find("end")->remarks().empty());
    const std::string told = typed.project.find("end")->remarks()[0].text();
    CHECK_MESSAGE(told == "taken from chain.shaft_2: F, d_f, b_r; given here and not taken: T", told);
  }

  TEST_CASE("torque and tooth forces of a gear come together, of a helical one including the axial force") {
    const Solved spur(gears + end("load = \"=gears.gear_2\""));
    REQUIRE_MESSAGE(spur.errors().empty(), spur.errors());
    CHECK(spur.value("end.T") == doctest::Approx(60.0 * 57.0 / 20.0));
    // 2 T_1/d_1 = 2 * 60/0.05 at 20 deg: F_t/cos(alpha)
    CHECK(spur.value("end.F") == doctest::Approx(2400.0 / std::cos(20.0 * 3.14159265358979 / 180.0)));
    CHECK(spur.mode("end.other_loads").state == State::open);
    const Solved helical(gears + "beta = \"15 deg\"\n" + end("load = \"=gears.gear_2\""));
    CHECK_MESSAGE(helical.mode("end.other_loads").state == State::not_judged, helical.errors());
    const std::string note = helical.mode("end.other_loads").note.text();
    CHECK_MESSAGE(
        contains(
            note,
            "gears.gear_2.F_z; replace with a step of shaft.design, or assess them separately: accept.other_loads = "),
        note);
    CHECK(helical.mode("end.other_loads").title.text() == "other load components");
    const Solved answered(gears + "beta = \"15 deg\"\n" +
                          end("load = \"=gears.gear_2\"\naccept.other_loads = \"F_z d_w/2 is 12 N*m\""));
    CHECK_MESSAGE(answered.mode("end.other_loads").state == State::accepted, answered.errors());
    const Solved torsion(gears +
                         "[end]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nload = \"=gears.gear_2\"\n");
    REQUIRE_MESSAGE(torsion.errors().empty(), torsion.errors());
    CHECK(torsion.value("end.T") == doctest::Approx(171.0));
    CHECK(torsion.value("end.F") == doctest::Approx(spur.value("end.F")));
  }

  TEST_CASE("loads that a record leaves open are not zero") {
    const std::string unloaded =
        "[gears]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = \"2.5 mm\"\nb = \"25 mm\"\n";
    for (const std::string& shaft :
         {end("load = \"=gears.gear_2\""),
          std::string("[end]\ncalculator = \"shaft.torsion\"\nd = \"5 mm\"\ntau_adm = \"30 MPa\"\nload = "
                      "\"=gears.gear_2\"\n")}) {
      const Solved open(unloaded + shaft);
      REQUIRE_MESSAGE(open.errors().empty(), open.errors());
      CHECK(open.find_mode("end.yield")->state == State::not_available);
      const auto& verdicts = open.project.find("end")->account().verdicts;
      REQUIRE(!verdicts.empty());
      for (const account::Verdict& verdict : verdicts) {
        CHECK(verdict.state == State::not_available);
        CHECK_MESSAGE(contains(verdict.note.text(), "gears.gear_2"), verdict.note.text());
      }
    }
  }

  TEST_CASE("a V-belt that was selected is checked completely, and follows the power") {
    const auto drive = [](const std::string& P) {
      return "[pick]\ncalculator = \"belt.v_sizing\"\nbasis = \"optibelt\"\nP = \"" + P +
             "\"\nK_A = 1.2\nn_1 = \"1460 rpm\"\nn_2_set = \"730 rpm\"\na_set = \"600 mm\"\n"
             "[belt]\ncalculator = \"belt.v\"\ndrive = \"=pick.best\"\n" +
             end("load = \"=belt.shaft_2\"");
    };
    for (const char* P : {"11 kW", "22 kW"}) {
      const Solved whole(drive(P));
      REQUIRE_MESSAGE(whole.errors().empty(), whole.errors());
      CHECK(whole.value("belt.z") == whole.value("pick.z"));
      CHECK(whole.value("belt.R") == doctest::Approx(whole.value("pick.R")));
      CHECK(whole.value("belt.u_P") == doctest::Approx(whole.value("pick.u_P")));
      CHECK(whole.value("end.F") == doctest::Approx(whole.value("pick.R_new")));
    }
    CHECK(Solved(drive("22 kW")).value("end.T") > 1.9 * Solved(drive("11 kW")).value("end.T"));
  }

  TEST_CASE("a record without data for the step, and a value that is not a record, are refused") {
    CHECK(contains(Solved(chain("1.4") + end("load = \"=chain.F_W\"")).errors(),
                   "'load' takes a record, and 'chain.F_W' is a number"));
    CHECK(
        contains(Solved(chain("1.4") + end("load = \"=chain.shaft_3\"")).errors(), "'chain' has no result 'shaft_3'"));
    CHECK(contains(Solved(chain("1.4") + "[belt]\ncalculator = \"belt.v\"\ndrive = \"=chain.shaft_1\"\n").errors(),
                   "provides no input of 'belt'"));
    CHECK(contains(Solved(chain("1.4") + end("load = \"chain\"")).errors(), "'load' takes the record of another step"));
    CHECK(
        contains(Solved(chain("1.4") + end("load = \"chain.shaft_1\"")).messages(), "write load = \"=chain.shaft_1\""));
    CHECK(!contains(Solved(chain("1.4") + end("load = \"=chain.F_W\"")).errors(), "is missing"));
    CHECK(!contains(Solved(chain("1.4") + end("load = \"chain\"")).errors(), "is missing"));
  }
}
