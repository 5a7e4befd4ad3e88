// Each condition of the rules for loads and factors of [values] that no step takes.
#include "lib/project/references/machine/left_out.hpp"

#include "lib/project/references/agreement/torques.hpp"
#include "lib/project/references/drives/stated_loads.hpp"
#include "lib/project/references/machine/repetitions.hpp"
#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

void check(const std::string& steps, std::initializer_list<ValuesRow> rows) {
  check_values(&project::loads_left_out, steps, rows);
}

const std::string bearing =
    "[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6309\"\nF_r = \"6 kN\"\nn = \"1200 rpm\"\nL_h = \"3000 h\"\n";

const std::string shaft = "[t]\ncalculator = \"shaft.torsion\"\nT = \"300 N*m\"\nd = \"60 mm\"\ntau_adm = \"40 MPa\"\n";

const std::string shell =
    "[s]\ncalculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"600 mm\"\nsigma_adm = \"140 MPa\"\n";

}  // namespace

TEST_SUITE("project: loads left out") {
  TEST_CASE("a load of a start, a jam or a test, by its name") {
    for (const std::string index : {"start", "starting", "max", "peak", "jam", "stall", "shock", "impact", "brake",
                                    "braking", "overload", "test", "t"})
      check(shaft, {{"T_" + index + " = \"400 N*m\"", "T"}, {"M_" + index + " = \"400 N*m\"", ""}});
    check(shaft, {{"T = \"400 N*m\"", "T"},
                  {"T = \"300 N*m\"", ""},
                  {"T = \"-400 N*m\"", "T"},
                  {"T = \"15000 N*m\"", "T"},
                  {"T = \"15100 N*m\"", ""},
                  {"T_idle = \"400 N*m\"", ""},
                  {"T_design = \"400 N*m\"", "T"},
                  {"T_drum = \"400 N*m\"", "T"},
                  {"T_drum = \"300 N*m\"", ""},
                  {"T_drum_adm = \"400 N*m\"", ""},
                  {"T_motor = \"400 N*m\"", ""},
                  {"T_gate = \"400 N*m\"", "T"},
                  {"T_screws = \"400 N*m\"", ""},
                  {"T_start = \"400 N\"", ""},
                  {"T_start = 400", ""},
                  {"T_start = \"400 J\"", ""},
                  {"start = \"400 N*m\"", ""}});
    const auto train = [](const std::string& P, const std::string& z) {
      return "\n[g]\ncalculator = \"drive.train\"\nn_1 = \"1000 rpm\"\nP = \"" + P +
             "\"\nstages = [{ name = \"gears\", kind = \"gear\", " + z + ", eta = 1 }]\n";
    };
    check(shaft + train("42 kW", "z_1 = 60, z_2 = 20"), {{"T_drum = \"400 N*m\"", ""}});  // 401 and 134 N*m
    check(shaft + train("14 kW", "z_1 = 20, z_2 = 60"), {{"T_drum = \"400 N*m\"", ""}});  // 134 and 401 N*m
    check(shaft + train("13 kW", "z_1 = 20, z_2 = 60"), {{"T_drum = \"400 N*m\"", "T"}});
    check(shell, {{"p_design = \"1.2 MPa\"", "p"}, {"p_max = \"1.2 MPa\"", "p"}, {"p_fill = \"1.2 MPa\"", ""}});
    check(bearing, {{"F_max = \"7 kN\"", "F_r"}, {"F_r = \"7 kN\"", "F_r"}, {"F_r_max = \"7 kN\"", "F_r"}});
    check(example_of("fatigue.life"), {{"sigma_max = \"900 MPa\"", ""}, {"sigma_test = \"900 MPa\"", ""}});
    check("[gate]" + shaft.substr(3), {{"T_gate = \"400 N*m\"", "T"}, {"T_gate_idle = \"400 N*m\"", ""}});
    const std::string pin = example_of("pin.en1993", "gamma_F = 1.4");  // F = 150 kN
    check(pin, {{"F_Ed = \"210 kN\"", ""}, {"F_Ed = \"220 kN\"", "F"}, {"N_total = \"220 kN\"", "F"}});
    const std::string bar = example_of("column.beam_column");
    check(bar, {{"M_z_max = \"25 kN*m\"", "M_z"},
                {"M_y_max = \"55 kN*m\"", ""},
                {"M_y_max = \"65 kN*m\"", "M_y_1"},
                {"N_Ed = \"-700 kN\"", "P"},
                {"N_Ed = \"-600 kN\"", ""},
                {"F_max = \"700 kN\"", "P"}});
    std::string edge = "[edge]" + bar.substr(bar.find(']') + 1);
    edge.replace(edge.find("60 kN*m"), 2, "65");
    check(bar + edge, {{"M_y_max = \"65 kN*m\"", ""}, {"M_y_max = \"70 kN*m\"", "M_y_1"}});
    check(with_lines(bar, "q_z = \"2 kN/m\""), {{"q_wind = \"3 kN/m\"", "q_z"}, {"q_snow = \"2 kN/m\"", ""}});
    const std::string design = example_of("shaft.design");
    check(design, {{"F_thrust = \"400 N\"", "seats"},
                   {"F_thrust = \"250 N\"", ""},
                   {"F_ax_fan = \"400 N\"", "seats"},
                   {"F_ax_adm = \"400 N\"", ""},
                   {"F_r = \"2 kN\"", "seats"},
                   {"F_r = \"600 N\"", ""},
                   {"F_r = \"520 N\"", "seats"},
                   {"F_t = \"1429 N\"", ""}});
    check(example_of("column.buckling"), {{"H_crane = \"20 kN\"", "P"}, {"H_crane = \"20 mm\"", ""}});
    check(design, {{"T_start = \"900 N*m\"", "seats"}});
  }

  TEST_CASE("a factor under the name of an input, or a symbol of another standard") {
    const std::string chain = example_of("chain.roller", "K_A = 1.3");
    check(chain, {{"K_A = 1.4", "K_A"}, {"K_A = 1.3", ""}, {"K_A = 1.2", ""}, {"K_A = \"1.4 mm\"", ""}});
    for (const std::string name :
         {"K_o", "K_O", "k_A", "c_B", "f_B", "service_factor", "application_factor", "overload_factor"})
      check(chain, {{name + " = 1.4", "K_A"}, {name + " = 1.3", ""}});
    check(chain, {{"K_B = 1.4", ""}, {"factor = 1.4", ""}});
    check(example_of("shaft.key", "S_F = 1.5"), {{"S_F = 2", "S_F"}, {"S_F = 1.5", ""}});
    check(example_of("dynamics.inertia"), {{"K_o = 1.4", ""}});
    check(shell, {{"S = 1.5", ""}, {"S = 1.6", "S"}});
    check(example_of("machine.disc", "S ="), {{"S = 1.2", "S"}});
  }

  TEST_CASE("a component under the name of an input that is not given") {
    check(bearing, {{"F_a = \"2 kN\"", "F_a"},
                    {"F_a = \"0 kN\"", ""},
                    {"F_a = 2", ""},
                    {"F_r0 = \"9 kN\"", "F_r0"},
                    {"F_a0 = \"9 kN\"", "F_a0"}});
    check(bearing + "F_a = \"2 kN\"\n", {{"F_a = \"2 kN\"", ""}});
    const std::string mate = "\n[c]" + bearing.substr(3);
    check(bearing + mate + "F_a = \"2 kN\"\n",
          {{"F_a = \"2 kN\"", ""}, {"F_a = \"-2 kN\"", ""}, {"F_a = \"3 kN\"", "F_a"}});
    check(bearing + mate, {{"F_a = \"2 kN\"", "F_a"}});
    check(example_of("pin.lug"), {{"F_a = \"2 kN\"", ""}});
    check(example_of("column.beam_column", "M_z ="),
          {{"M_z = \"5 kN*m\"", "M_z"}, {"q_z = \"5 kN/m\"", "q_z"}, {"q_y = \"5 kN/m\"", "q_y"}});
    check(example_of("column.beam_column", "M_y_1 =\nM_y_2 ="),
          {{"M_y = \"5 kN*m\"", "M_y"}, {"M_y_1 = \"5 kN*m\"", "M_y_1"}});
    check(example_of("column.beam_column", "M_z ="), {{"M_z_1 = \"5 kN*m\"", "M_z_1"}});
    check(example_of("shaft.circlip"), {{"V = \"2 kN\"", ""}});
  }

  TEST_CASE("bending of a shaft that is assessed in torsion only") {
    check(shaft, {{"M_b = \"200 N*m\"", "T"}, {"M_b = \"0 N*m\"", ""}, {"M_b = 200", ""}, {"M_c = \"200 N*m\"", ""}});
    check(shaft + "\n" + example_of("shaft.design"), {{"M_b = \"200 N*m\"", ""}});
    check(shaft + "\n" + example_of("shaft.overhung"), {{"M_b = \"200 N*m\"", ""}});
    check(shaft + "\n" + bearing, {{"M_b = \"200 N*m\"", "T"}});
    check(example_of("shaft.key"), {{"M_b = \"200 N*m\"", ""}});
    check(example_of("shaft.press_fit"), {{"M_b = \"200 N*m\"", "T"}, {"M_b = 200", ""}, {"F_x = \"2 kN\"", ""}});
  }

  TEST_CASE("a component that no mounted part of a shaft has") {
    const std::string design = example_of("shaft.design",
                                          "seats = [{ name = \"hub\", x = \"0 mm\", T = \"50 N*m\", way = \"drives\" "
                                          "}, { name = \"gear\", x = \"100 mm\", T = "
                                          "\"50 N*m\", way = \"takes\" }]");
    for (const std::string name : {"F_x", "F_y", "F_z"})
      check(design, {{name + " = \"2 kN\"", "seats"}, {name + " = \"2 N*m\"", ""}, {name + " = \"0 kN\"", ""}});
    check(design,
          {{"M_b = \"2 N*m\"", "seats"}, {"M_b = \"2 kN\"", ""}, {"F_w = \"2 kN\"", ""}, {"M_w = \"2 N*m\"", ""}});
    check(design + "\n" + example_of("column.beam_column"), {{"F_x = \"2 kN\"", ""}});
  }

  TEST_CASE("a bending load next to a bar that is assessed in compression only") {
    for (const std::string id : {"column.buckling", "column.lightest", "column.stepped"}) {
      const std::string bar = example_of(id), load = id == "column.stepped" ? "parts" : "P";
      for (const std::string name : {"M_b", "M_y", "M_z", "M_y_1", "M_z_1"})
        check(bar, {{name + " = \"2 kN*m\"", load}, {name + " = 2", ""}, {name + " = \"2 kN*s\"", ""}});
      for (const std::string name : {"F_y", "F_z"}) check(bar, {{name + " = \"2 kN\"", load}});
      for (const std::string name : {"q_y", "q_z", "q", "q_wind"})
        check(bar, {{name + " = \"2 kN/m\"", load}, {name + " = \"0 kN/m\"", ""}});
      check(bar, {{"F_w = \"2 kN\"", ""}, {"F_x = \"2 kN\"", ""}});
    }
    const std::string bar = example_of("column.buckling");
    check(bar + "\n" + example_of("column.beam_column"), {{"q = \"2 kN/m\"", ""}});
    check(example_of("pin.lug"), {{"q = \"2 kN/m\"", ""}, {"M_b = \"2 kN*m\"", ""}});
  }
}

TEST_SUITE("project: loads of drives") {
  TEST_CASE("a load of [values] that no drive carries") {  // 3 kW at 96 rpm: 298.4 N*m
    const std::string chain = example_of("chain.roller");
    const auto asked = [](const std::string& steps, std::initializer_list<ValuesRow> rows) {
      check_values(&project::loads_stated_otherwise, steps, rows);
    };
    asked(chain, {{"T_1 = \"400 N*m\"", "P"},    {"T_1 = \"-400 N*m\"", "P"},    {"T_1 = \"300 N*m\"", ""},
                  {"T_1 = \"200 N*m\"", ""},     {"T_1 = \"14800 N*m\"", "P"},   {"T_1 = \"15100 N*m\"", ""},
                  {"T_1 = \"400 J\"", ""},       {"T_1 = \"400 N\"", ""},        {"T_3 = \"400 N*m\"", ""},
                  {"T_2 = \"800 N*m\"", ""},     {"T_2 = \"900 N*m\"", "P"},     {"T = \"800 N*m\"", ""},
                  {"T = \"900 N*m\"", "P"},      {"T_start = \"900 N*m\"", "P"}, {"T_idle = \"900 N*m\"", ""},
                  {"M_start = \"900 N*m\"", ""}, {"T = \"900 N\"", ""},          {"P = \"4 kW\"", ""},
                  {"P_1 = \"4 kW\"", "P"},       {"P_start = \"4 kW\"", ""},     {"P_loss = \"4 kW\"", ""}});
    const auto other = [&](const std::string& P) {
      return chain + "\n" + with_lines(example_of("chain.roller"), "P = \"" + P + "\"").replace(1, 8, "other");
    };
    asked(other("5 kW"), {{"T_1 = \"400 N*m\"", ""}});
    asked(other("3.5 kW"), {{"T_1 = \"400 N*m\"", "P"}});
    asked(other("3.95 kW"), {{"T_1 = \"400 N*m\"", ""}});  // 392.9 N*m
    const std::string motor =
        "\n[m]\ncalculator = \"shaft.torsion\"\nP = \"4 kW\"\nn = \"96 rpm\"\nd = \"60 mm\"\ntau_adm = \"40 MPa\"\n";
    asked(chain + motor, {{"P_1 = \"4 kW\"", "P"}});
    // 60 N*m at a pitch diameter of 60 mm: 2 kN.
    const auto pair = [](const std::string& load) {
      return "[g]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 60\nm_n = \"3 mm\"\nb = \"30 mm\"\n" + load;
    };
    asked(pair("T_1 = \"60 N*m\"\n"), {{"F_t = \"1 N\"", ""},
                                       {"F_t = \"2.02 kN\"", ""},
                                       {"F_t = \"2.1 kN\"", "T_1"},
                                       {"F_t = \"99 kN\"", "T_1"},
                                       {"F_t = \"101 kN\"", ""},
                                       {"F_t = \"2.1 kN*m\"", ""},
                                       {"F_r = \"2.1 kN\"", ""},
                                       {"F_max = \"2.1 kN\"", ""}});
    const std::string by_power = pair("P = \"6.2832 kW\"\nn_1 = \"1000 rpm\"\n");
    asked(by_power, {{"F_max = \"2.1 kN\"", "P"}, {"F_max = \"1.9 kN\"", ""}, {"F_idle = \"2.1 kN\"", ""}});
    const std::string train =  // 36.2 N*m; 140.5 N*m behind the stage
        "[t]\ncalculator = \"drive.train\"\nP = \"5.5 kW\"\nn_1 = \"1450 rpm\"\nstages = [{ name = \"gears\", kind = "
        "\"gear\", z_1 = 20, z_2 = 80, eta = 0.97 }]\n";
    asked(train, {{"T_2 = \"140 N*m\"", ""}, {"T_2 = \"150 N*m\"", "P"}, {"T_1 = \"100 N*m\"", "P"}});
    asked("[g]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 60\nm_n = \"3 mm\"\n", {{"T_1 = \"60 N*m\"", ""}});
  }

  TEST_CASE("gears without a load") {
    const std::string pair = "[g]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 60\nm_n = \"3 mm\"\nb = \"30 mm\"\n";
    const auto asked = [](const std::string& steps, std::initializer_list<ValuesRow> rows) {
      check_values(&project::loads_of_unloaded_gears, steps, rows);
    };
    asked(pair, {{"P = \"3 kW\"", "m_n"},
                 {"P_1 = \"3 kW\"", "m_n"},
                 {"P_start = \"3 kW\"", "m_n"},
                 {"P_loss = \"3 kW\"", ""},
                 {"T = \"30 N*m\"", "m_n"},
                 {"T_1 = \"30 N*m\"", "m_n"},
                 {"T_2 = \"30 N*m\"", "m_n"},
                 {"T_start = \"30 N*m\"", "m_n"},
                 {"T_x = \"30 N*m\"", ""},
                 {"M_start = \"30 N*m\"", ""},
                 {"T = \"30 J\"", ""},
                 {"T = \"0 N*m\"", ""},
                 {"F_t = \"3 kN\"", "m_n"},
                 {"F_r = \"3 kN\"", ""},
                 {"F_t = \"3 mm\"", ""}});
    asked(pair + "\n" + example_of("chain.roller"), {{"T = \"30 N*m\"", ""}});
  }

  TEST_CASE("a power next to a torque") {  // 10 kW at 1000 rpm: 95.5 N*m
    const auto bar = [](const std::string& name, const std::string& T) {
      return "[" + name + "]\ncalculator = \"shaft.torsion\"\nT = \"" + T +
             "\"\nd = \"60 mm\"\ntau_adm = \"40 MPa\"\n\n";
    };
    const auto asked = [](const std::string& steps, std::initializer_list<ValuesRow> rows) {
      check_values(&project::powers_of_torques, steps, rows);
    };
    const std::string power = "P = \"10 kW\"\n";
    asked(bar("s", "50 N*m"), {{power + "n = \"1000 rpm\"", "T"},
                               {power + "n_1 = \"1000 rpm\"", "T"},
                               {power + "n = \"2000 rpm\"", ""},
                               {power + "n = \"16 Hz\"", ""},
                               {"P = \"-10 kW\"\nn = \"1000 rpm\"", "T"},
                               {"P_loss = \"10 kW\"\nn = \"1000 rpm\"", ""},
                               {power, "T"},
                               {"T_max = \"90 N*m\"", ""}});
    asked(bar("s", "94 N*m"), {{power + "n = \"1000 rpm\"", ""}});
    asked(bar("s", "2 N*m"), {{power + "n = \"1000 rpm\"", "T"}});
    asked(bar("s", "1.9 N*m"), {{power + "n = \"1000 rpm\"", ""}});
    const auto fit = [](const std::string& T) {
      return example_of("shaft.press_fit", "n = \"1000 rpm\"\nT = \"" + T + "\"");
    };
    asked(fit("95 N*m"), {{power, ""}, {power + "n = \"100 rpm\"", ""}});  // it has a speed of its own
    asked(fit("50 N*m"), {{power, "T"}});
    asked(bar("s", "50 N*m") + bar("o", "94 N*m"), {{power + "n = \"1000 rpm\"", ""}});
    asked(bar("s", "50 N*m") + bar("o", "90 N*m"), {{power + "n = \"1000 rpm\"", "T"}});
    asked(bar("s", "=o.T") + bar("o", "50 N*m"), {{power + "n = \"1000 rpm\"", ""}});
    asked(with_lines(bar("s", "50 N*m"), "d = \"=o.d\"") + bar("o", "50 N*m"), {{power + "n = \"1000 rpm\"", "T"}});
    asked(bar("s", "50 N*m") + example_of("chain.roller"), {{power + "n = \"1000 rpm\"", ""}});
  }

  TEST_CASE("a load divided by the application factor") {
    const auto asked = [](const std::string& P, const std::string& K_A, std::initializer_list<ValuesRow> rows) {
      check_values(&project::factors_cancelled, example_of("chain.roller", "P = \"=" + P + "\"\nK_A = " + K_A), rows);
    };
    asked("values.P/1.3", "1.3", {{"P = \"3 kW\"", "P"}});
    asked("values.P/1.2", "1.3", {{"P = \"3 kW\"", ""}, {"P = \"3 kW\"\nK_A = 1.2", "P"}});
    asked("values.P/1", "1", {{"P = \"3 kW\"", ""}});
    asked("values.P", "1.3", {{"P = \"3 kW\"", ""}});
    asked("values.P/values.K_A", "\"=values.K_A\"", {{"P = \"3 kW\"\nK_A = 1.3", "P"}});
    for (const std::string name : {"P_design", "P_max", "P_eq", "P_K_A"})
      asked("values." + name + "/1.3", "1.3", {{name + " = \"3 kW\"", ""}});
    asked("values.P_0/1.3", "1.3", {{"P_0 = \"3 kW\"", "P"}});
  }

  TEST_CASE("a connection without the application factor of another step with its torque") {
    const auto key = [](const std::string& lines) {
      return example_of("shaft.key", "T = \"200 N*m\"\nK_A =\nT_max =\n" + lines);
    };
    const auto bar = [](const std::string& T, const std::string& K_A) {
      return "\n[o]\ncalculator = \"shaft.torsion\"\nT = \"" + T +
             "\"\nd = \"60 mm\"\ntau_adm = \"40 MPa\"\nK_A = " + K_A + "\n";
    };
    const auto asked = [](const std::string& text) { return inputs_found(&project::factors_of_torque, text); };
    CHECK(asked(key("") + bar("200 N*m", "1.25")) == "K_A");
    CHECK(asked(key("") + bar("200.1 N*m", "1.25")) == "K_A");
    CHECK(asked(key("") + bar("201 N*m", "1.25")).empty());
    CHECK(asked(key("") + bar("200 N*m", "1")).empty());
    CHECK(asked(key("K_A = 1") + bar("200 N*m", "1.25")).empty());
    CHECK(asked(key("T_max = \"250 N*m\"") + bar("200 N*m", "1.25")).empty());
    CHECK(asked(key("T = \"=o.T\"") + bar("200 N*m", "1")).empty());
    CHECK(asked(key("") + "\n" + example_of("gear.pair", "P =\nT_1 = \"200 N*m\"\nK_A = 1.25")) == "K_A");
    CHECK(asked(key("") + "\n" + example_of("chain.roller", "P =\nP_R =\nT_1 = \"200 N*m\"\nK_A = 1.25")).empty());
    CHECK(asked(with_lines(bar("200 N*m", "1"), "K_A =") + bar("200 N*m", "1.25").replace(2, 1, "r")).empty());
  }

  TEST_CASE("a history that another step counts more often") {
    const auto bar = [](const std::string& name, const std::string& n_req, const std::string& A = "100 mm^2") {
      return "[" + name + "]\n" +
             with_lines(
                 "calculator = \"fatigue.history\"\nsigma_D = \"120 MPa\"\nN_D = 1e6\nk = 5\nmean = \"goodman\"\nR_m "
                 "= \"690 MPa\"\nR_e = \"490 MPa\"\nS_F = 1.5\nsigma = \"=press.links.rod.N/(" +
                     A + ")\"\n",
                 "n_req = " + n_req) +
             "\n";
    };
    const auto asked = [](const std::string& text) {
      return inputs_found(&project::repetitions_of_others, text + press_of_heavy_rod, "a");
    };
    CHECK(asked(bar("a", "1e6") + bar("b", "2e6")) == "n_req");
    CHECK(asked(bar("a", "1e6") + bar("b", "1e6")).empty());
    CHECK(asked(bar("a", "2e6") + bar("b", "1e6")).empty());
    CHECK(asked(bar("a", "500")) == "n_req");
    CHECK(asked(bar("a", "1500")).empty());
  }
}
