// Each condition of the rules for the parts that a part is mounted on, and for requirements, of [values] that no step
// takes.
#include "lib/project/references/stated/mates.hpp"

#include "lib/project/references/stated/requirements.hpp"
#include "lib/project/references/stated/rows.hpp"
#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

void check(const std::string& steps, std::initializer_list<ValuesRow> rows) {
  check_values(&project::mates_stated_otherwise, steps, rows);
}

void check_required(const std::string& steps, std::initializer_list<ValuesRow> rows) {
  check_values(&project::requirements_stated_otherwise, steps, rows);
}

const std::string ball =
    "[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6208\"\nF_r = \"2 kN\"\nn = \"900 rpm\"\nL_h = \"9000 h\"\n";

}  // namespace

TEST_SUITE("project: mates stated otherwise") {
  TEST_CASE("the shaft of a bearing, a key, a screw or a ring") {
    for (const std::string name : {"d_shaft", "D_shaft", "shaft_d", "shaft_diameter", "d_journal"})
      check(ball, {{name + " = \"45 mm\"", "d"}, {name + " = \"40 mm\"", ""}});
    check(ball, {{"l_shaft = \"45 mm\"", ""}, {"d_housing = \"80 mm\"", ""}, {"d_motor = \"38 mm\"", ""}});
    const std::string key = example_of("shaft.key");
    check(key, {{"d_shaft = \"45 mm\"", "d"}, {"d_motor = \"45 mm\"", "d"}, {"d_motor_shaft = \"50 mm\"", ""}});
    check(example_of("shaft.set_screw"), {{"d_shaft = \"19 mm\"", "d"}, {"d_shaft = \"20 mm\"", ""}});
    check(key + ball, {{"d_shaft = \"40 mm\"", ""}});
    check(example_of("shaft.torsion"), {{"d_shaft = \"45 mm\"", ""}});
  }

  TEST_CASE("the hole and the plates of a pin") {
    const std::string lug = example_of("pin.lug");
    check(lug, {{"d_pin = \"30 mm\"", "d"}, {"d_pin = \"39.9 mm\"", ""}, {"d_hole = \"42 mm\"", ""}});
    check(lug, {{"t_plate = \"30 mm\"", "t"}, {"t_plate = \"40 mm\"", ""}, {"t_paint = \"1 mm\"", ""}});
    const std::string joint = example_of("pin.joint");
    check(joint, {{"t_fork = \"12 mm\"", "t_1"}, {"t_fork = \"16 mm\"", ""}, {"bolt_d = \"20 mm\"", "d"}});
  }

  TEST_CASE("the width of pulleys, sprockets and wheels") {
    check(example_of("belt.synchronous"),
          {{"b_pulley = \"40 mm\"", "b"}, {"b_pulley = \"56 mm\"", ""}, {"b_guard = \"40 mm\"", ""}});
    check(example_of("chain.inverted_tooth"), {{"b_sprocket = \"40 mm\"", "b"}, {"width_sprocket = \"50 mm\"", ""}});
    check(example_of("drive.friction_wheels"), {{"b_wheel = \"50 mm\"", "b"}, {"b_wheel = \"80 mm\"", ""}});
    check(example_of("chain.roller"), {{"b_sprocket = \"10 mm\"", ""}});
  }

  TEST_CASE("the shaft of a ring, a smaller pin in the hole") {
    check(example_of("shaft.circlip"), {{"d_shaft = \"20 mm\"", "d_1"}, {"d_shaft = \"18 mm\"", ""}});
    check(example_of("pin.lug"),
          {{"d_bolt = \"36 mm\"", "d"}, {"d_shackle = \"36 mm\"", "d"}, {"d_hole = \"41 mm\"", ""}});
  }
}

TEST_SUITE("project: requirements stated otherwise") {
  TEST_CASE("an allowable stress with the name of a part") {
    const std::string lug = example_of("pin.lug");
    check_required(lug, {{"p_adm_bush = \"20 MPa\"", "p_adm"},
                         {"p_adm_bush = \"80 MPa\"", ""},
                         {"p_adm_bush = \"90 MPa\"", ""},
                         {"sigma_adm_weld = \"60 MPa\"", "sigma_adm"},
                         {"p_admission = \"20 MPa\"", ""},
                         {"p_adm = \"20 MPa\"", ""}});
    const std::string joint = example_of("pin.joint", "p_adm_2 = \"60 MPa\"");
    check_required(joint, {{"p_adm_bush = \"70 MPa\"", ""}, {"p_adm_bush = \"50 MPa\"", "p_adm_2"}});
    check_required(lug + joint, {{"p_adm_bush = \"60 MPa\"", ""}});
  }

  TEST_CASE("a required safety factor") {
    const std::string rod = example_of("column.buckling");
    for (const std::string ending : {"min", "req", "required", "target"})
      check_required(rod, {{"n_st_" + ending + " = 4", "n_st"}, {"n_st_" + ending + " = 3", ""}});
    check_required(rod, {{"n_st_test = 4", ""}, {"n_st = 4", ""}});
  }

  TEST_CASE("a value outside of the range of a step") {
    const std::string fit = example_of("vessel.compound");
    check_required(fit, {{"U = \"150 um\"", "U_min"},
                         {"U = \"260 um\"", ""},
                         {"U = \"300 um\"", "U_max"},
                         {"U = 150", ""},
                         {"V = \"150 um\"", ""}});
  }

  TEST_CASE("the longest time of a run-up") {
    check_required(example_of("machine.run_up", "t_adm = \"12 s\""),
                   {{"t_start_max = \"1 s\"", "t_adm"}, {"t_start = \"1 s\"", ""}});
  }
}

TEST_SUITE("project: names of steps") {
  TEST_CASE("sizes and loads with the name of the step") {
    std::string pin = example_of("pin.joint");
    pin.replace(0, pin.find(']'), "[bolt");
    check_values(&project::rows_stated_otherwise, pin,
                 {{"d_bolt = \"20 mm\"", "d"},
                  {"d_bolt = \"30 mm\"", ""},
                  {"F_bolt = \"20 kN\"", "F"},
                  {"F_bolt = \"10 kN\"", ""},
                  {"d_rivet = \"20 mm\"", ""},
                  {"R_m_bolt = \"800 MPa\"", ""}});
  }
}
