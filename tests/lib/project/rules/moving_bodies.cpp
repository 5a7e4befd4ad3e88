// Each condition of the rules for masses, friction, strokes and springs that only [values] state.
#include "lib/project/references/stated/moving_bodies.hpp"

#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string crank =
    "[comp]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"40 mm\"\nl = \"180 mm\"\ncrank = { "
    "speed = \"720 rpm\", positions = 36 }\nlinks.rod.mass = \"1.4 kg\"\nlinks.rod.J = \"0.01 kg*m^2\"\n";

void check(const std::string& steps, std::initializer_list<ValuesRow> rows) {
  check_values(&project::bodies_stated_only, steps, rows);
}

}  // namespace

TEST_SUITE("project: bodies stated only") {
  TEST_CASE("the mass of a link under each of its names") {
    for (const std::string name : {"rod", "conrod", "con_rod", "connecting_rod", "coupler", "pitman", "connectingrod",
                                   "slider", "piston", "plunger", "ram", "crosshead", "punch", "carriage", "crank"}) {
      for (const std::string& of_link : {"m_" + name, "mass_" + name, name + "_m", name + "_mass"})
        check(crank, {{of_link + " = \"3 kg\"", "links"}});
      check(crank, {{"J_" + name + " = \"3 kg*m^2\"\ninertia_" + name + " = \"3 kg*m^2\"", "links, links"}});
      check(crank,
            {{"m_" + name + " = \"3 mm\"", ""}, {"J_" + name + " = 3", ""}, {"mass" + name + " = \"3 kg\"", ""}});
    }
    check(crank, {{"m_rod = \"1.4 kg\"", ""},
                  {"m_rod = \"1.42 kg\"", ""},
                  {"m_rod = \"1.44 kg\"", "links"},
                  {"m_rod = \"0 kg\"", ""},
                  {"M_ROD = \"-3 kg\"", "links"},
                  {"J_rod = \"0.01 kg*m^2\"", ""},
                  {"J_rod = \"0.02 kg*m^2\"", "links"},
                  {"m_frame = \"240 kg\"", ""}});
  }

  TEST_CASE("friction of the joints") {
    for (const std::string name : {"mu", "friction", "friction_coefficient", "mu_joints", "mu_pins", "mu_guide",
                                   "mu_slider", "mu_A", "mu_B", "B_mu", "friction_B"})
      check(crank, {{name + " = 0.2", "joints"}});
    for (const std::string name : {"coefficient", "mu_belt", "guide"}) check(crank, {{name + " = 0.2", ""}});
    check(crank, {{"mu = 0", ""}, {"mu = \"2 mm\"", ""}});
    const std::string rough = crank + "joints.B.mu = 0.2\njoints.B.pin_radius = \"10 mm\"\n";
    check(rough, {{"mu = 0.2", ""},
                  {"mu_B = 0.2", ""},
                  {"mu_B = 0.21", "joints"},
                  {"mu_A = 0.1", "joints"},
                  {"mu = 0.3", "joints"}});
  }

  TEST_CASE("the stroke of a guide") {
    for (const std::string name : {"stroke", "hub", "travel", "s_hub", "l_hub", "h_hub", "piston_stroke",
                                   "slider_stroke", "ram_travel", "plunger_stroke", "punch_stroke", "carriage_travel",
                                   "table_travel", "work_stroke", "working_stroke", "total_stroke", "full_stroke"})
      check(crank, {{name + " = \"100 mm\"", "joints"}, {name + " = \"80 mm\"", ""}});
    check(crank, {{"d_hub = \"100 mm\"", ""},
                  {"s = \"100 mm\"", ""},
                  {"stroke = \"81 mm\"", ""},
                  {"stroke = \"60 mm\"", "joints"},
                  {"stroke = \"0 mm\"", ""},
                  {"stroke = 100", ""}});
  }

  TEST_CASE("a spring next to a mechanism without one") {
    for (const std::string name : {"k_spring", "springs", "k", "c_spring"})
      check(crank, {{name + " = \"5 N/mm\"", "springs"}, {name + " = \"5 N*m/rad\"", "springs"}, {name + " = 5", ""}});
    check(crank, {{"k_frame = \"5 N/mm\"", ""}, {"k = \"0 N/mm\"", ""}});
    const std::string spring = crank +
                               "springs.return = { links = [\"slider\", \"ground\"], points = [\"B\", \"O\"], k = \"5 "
                               "N/mm\", free = \"300 mm\" }\n";
    check(spring, {{"k_spring = \"6 N/mm\"", ""}});
  }

  TEST_CASE("only a mechanism has them") {
    check(example_of("shaft.torsion"), {{"mu = 0.2\nk_spring = \"5 N/mm\"", ""}});
  }
}
