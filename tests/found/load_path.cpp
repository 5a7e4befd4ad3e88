// Regression tests of load paths: signs of another meaning, parts of simultaneous loads, loads that vary unseen,
// courses of loads without a value.
#include "tests/lib/project/solved.hpp"

#include <cmath>
#include <string>

using namespace loadpath;
using account::State;
using test::contains;
using test::Solved;

namespace {

const std::string boom = R"([m]
calculator = "mechanism.planar"
positions = 4
ground = { O = ["0 m", "0 m"], A = ["1 m", "0 m"] }
links.boom = { points = { O = ["0 m", "0 m"], B = ["0.5 m", "0.9 m"], S = ["1 m", "1.2 m"] }, angle = "0 deg" }
joints.O = { links = ["boom", "ground"] }
)";

std::string lifted(const std::string& way, const std::string& course) {
  return boom + "loads = [{ link = \"boom\", at = \"S\", F_y = \"-10 kN\"" +
         (course.empty() ? "" : ", course = \"c\"") +
         " }]\ncylinders.C1 = { links = [\"ground\", \"boom\"], points = [\"A\", \"B\"], " + way + " }\n" +
         (course.empty() ? "" : "courses.c = { " + course + " }\n");
}

const std::string rising = "from = \"0.95 m\", to = \"1.2 m\", speed = \"0.1 m/s\"";

std::string crank(const std::string& course) {
  return "[m]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"50 mm\"\nl = \"200 mm\"\n"
         "crank = { speed = \"60 rpm\", positions = 36 }\n"
         "loads = [{ link = \"slider\", at = \"B\", F_x = \"-1 kN\", course = \"c\" }]\ncourses.c = { " +
         course + " }\n";
}

State worst(const Solved& solved) { return account::worst(solved.all); }

}  // namespace

TEST_SUITE("found load path") {
  TEST_CASE("the push of a cylinder is not a tension of its rod") {
    const std::string rod =
        "[rod]\ncalculator = \"column.buckling\"\nd = \"20 mm\"\nl = \"1.2 m\"\nends = \"pinned_pinned\"\nE = \"210 "
        "GPa\"\n"
        "R_e = \"355 MPa\"\nmethod = \"johnson\"\nn_st = 3\nn_t = 2\nlambda_max = 300\nN = \"=";
    CHECK(contains(Solved(lifted(rising, "") + rod + "m.cylinders.C1.F\"\n").errors(), "the sign of 'N' matters"));
    const Solved pushed(lifted(rising, "") + rod + "-m.cylinders.C1.F\"\n");
    REQUIRE_MESSAGE(pushed.errors().empty(), pushed.errors());
    CHECK(pushed.mode("rod.buckling").state == State::fail);
  }

  TEST_CASE("time does not run backwards") {
    const std::string course = "share_of_t = \"exp(t/(1 s))\"";
    const Solved back(lifted("from = \"1.2 m\", to = \"0.95 m\", speed = \"0.1 m/s\"", course));
    CHECK_MESSAGE(contains(back.errors(), "its speed has the other sign"), back.errors());
    const Solved there(lifted("from = \"1.2 m\", to = \"0.95 m\", speed = \"-0.1 m/s\"", course));
    REQUIRE_MESSAGE(there.errors().empty(), there.errors());
    const auto& F = there.project.value("m.cylinders.C1.F")->si;
    CHECK(std::abs(F.back()) > 5.0 * std::abs(F.front()));  // e^2.5 = 12 times the load
  }

  TEST_CASE("a load curve without a value, or with an extreme one, is not covered") {
    for (const char* pole :
         {"share_of_phi = \"1/phi\"", "share_of_phi = \"1/sin(phi)\"", "share_of_t = \"(0.1 s)/t\""}) {
      const Solved solved(crank(pole));
      REQUIRE_MESSAGE(solved.errors().empty(), solved.errors());
      CHECK_MESSAGE(account::rank(worst(solved)) > account::rank(State::open), pole);
    }
    const Solved wave(crank("share_of_phi = \"1 + 0.5*sin(phi)\""));
    REQUIRE_MESSAGE(wave.errors().empty(), wave.errors());
    CHECK(account::rank(worst(wave)) <= account::rank(State::open));
  }

  TEST_CASE("one torque has one verdict, typed or calculated from a power and a speed") {
    const std::string axle = "[axle]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nd = \"40 mm\"\nT = \"";
    const std::string values = "[values]\nP = \"15 kW\"\nn = \"1450 rpm\"\nT = \"=values.P/values.n\"\n";
    for (const std::string& torque : {axle + "98.786 N*m\"\n", axle + "=98.786 N*m\"\n", axle + "=15 kW/(1450 rpm)\"\n",
                                      values + axle + "=values.P/values.n\"\n", values + axle + "=values.T\"\n",
                                      values + axle + "=1*values.T\"\n"}) {
      const Solved solved(torque);
      REQUIRE_MESSAGE(solved.errors().empty(), solved.errors());
      CHECK_MESSAGE(solved.mode("axle.fatigue").state == State::open, torque);
    }
  }

  TEST_CASE("the force of the crank joint comes with the moment of the drive") {
    const Solved end(crank("share_of_phi = \"1 + 0.5*sin(phi)\"") +
                     "[end]\ncalculator = \"shaft.overhung\"\na = \"60 mm\"\nsigma_adm = \"60 MPa\"\nd = \"60 mm\"\n"
                     "T = \"0 N*m\"\nF = \"=m.joints.O.F\"\n");
    REQUIRE_MESSAGE(end.errors().empty(), end.errors());
    CHECK(end.mode("end.other_loads").state == State::not_judged);
    CHECK_MESSAGE(contains(end.mode("end.other_loads").note.text(), "m.drive.M"),
                  end.mode("end.other_loads").note.text());
  }
}
