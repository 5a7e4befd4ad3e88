// Regression tests of messages on drives: faults found in use.
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

TEST_SUITE("found drive") {
  TEST_CASE("B9: speeds of shafts are shown in rad/s, in the line and where they are used") {
    const ExampleStep train("drive.train", "");
    int speeds = 0;
    for (const account::Derived& line : train.project().steps[0]->account().derivation) {
      CHECK(line.step.value.unit != "1/s");
      for (const auto& given : line.step.given) CHECK(given.unit != "1/s");
      speeds += line.step.value.unit == "rad/s" ? 1 : 0;
    }
    CHECK(speeds > 0);
  }

  TEST_CASE("stages are checked by the steps that take their size and load, the drive as the worst of them") {
    const std::string train =
        "[train]\ncalculator = \"drive.train\"\nP = \"11 kW\"\nn_1 = \"730 rpm\"\nstages = [{ name = \"first\", z_1 = "
        "21, "
        "z_2 = 84, m_n = \"3 mm\" }, { z_1 = 20, z_2 = 60, m_n = \"4 mm\" }]\n";
    const auto loaded = [](const std::string& name, const char* stage, const std::string& shaft, const std::string& T,
                           const char* b) {
      const std::string of = std::string("\"=train.stages") + stage;
      return "[" + name + "]\ncalculator = \"gear.pair\"\nz_1 = " + of + ".z_1\"\nz_2 = " + of + ".z_2\"\nm_n = " + of +
             ".m_n\"\nb = \"" + b + "\"\nT_1 = \"=abs(train." + T + ")\"\nn_1 = \"=abs(train.shafts[" + shaft +
             "].n)\"\nK_f = 1.5\nsigma_adm_1 = \"260 MPa\"\nsigma_adm_2 = \"260 MPa\"\n[rating_" + name +
             "]\ncalculator = \"gear.rating\"\nmesh = \"=" + name +
             ".mesh\"\nplace = \"middle\"\ngrade = 6\nmaterial_1 = \"case\"\nquality_1 = \"MQ\"\nH_1 = 700\nmaterial_2 "
             "= "
             "\"case\"\nquality_2 = \"MQ\"\nH_2 = 700\nS_Hmin = 1.1\nS_Fmin = 1.5\n";
    };
    const auto pair = [&](const std::string& name, const char* stage, const std::string& shaft, const char* b) {
      return loaded(name, stage, shaft, "shafts[" + shaft + "].T", b);
    };
    const std::string first = pair("a", ".first", "1", "60 mm"), second = pair("b", "[2]", "2", "80 mm");
    const auto strength = [&](const std::string& pairs) {
      return mode_of(solved_as_found(train + pairs), "train", "strength");
    };
    CHECK(strength("") == "open");
    CHECK(strength(first) == "open");
    CHECK(strength(first + second) == "pass");
    CHECK(strength(first + pair("b", "[2]", "2", "8 mm")) == "fail");
    const auto first_by = [&](const char* T) { return strength(loaded("a", ".first", "1", T, "60 mm") + second); };
    CHECK(first_by("T_1") == "pass");
    CHECK(first_by("T_out/train.i") == "open");  // of the other end
    const auto last_by = [&](const char* T) { return strength(first + loaded("b", "[2]", "2", T, "80 mm")); };
    CHECK(last_by("T_out/train.stages[2].i") == "pass");
    CHECK(last_by("T_1") == "open");
    CHECK(last_by("T_1*4") == "open");  // of the other end, whatever the ratio
    CHECK(last_by("P_loss*1 s") == "open");
  }

  TEST_CASE("bevel and worm stages are checked by the steps of their gears") {
    const std::string train =
        "[train]\ncalculator = \"drive.train\"\nP = \"3 kW\"\nn_1 = \"1400 rpm\"\nstages = [{ name = \"bevel\", kind = "
        "\"bevel\", z_1 = 20, z_2 = 40, m_n = \"4 mm\", eta = 0.96 }, { name = \"worm\", kind = \"worm\", z_1 = 2, z_2 "
        "= "
        "40, eta = 0.85 }]\n";
    const std::string bevel =
        "[bevel]\ncalculator = \"gear.bevel\"\nz_1 = \"=train.stages.bevel.z_1\"\nz_2 = \"=train.stages.bevel.z_2\"\n"
        "m_et = \"=train.stages.bevel.m_n\"\nb = \"28 mm\"\nx_1 = 0.3\nh_fP = 1.188\nP = \"=train.shafts[1].P\"\nn_1 = "
        "\"=train.shafts[1].n\"\nK_A = 1.25\nQ_v = 8\nI = 0.083\nJ_1 = 0.244\nJ_2 = 0.2\nH_B1 = 300\nH_B2 = 280\nL_h = "
        "\"10000 h\"\nS_Hmin = 1.1\nS_Fmin = 1.5\n";
    const auto worm = [](const char* sigma_adm) {
      return "[worm]\ncalculator = \"gear.worm\"\nz_1 = \"=train.stages.worm.z_1\"\nz_2 = "
             "\"=train.stages.worm.z_2\"\nm_x = \"6 mm\"\nd_1 = \"60 mm\"\nb_2 = \"40 mm\"\nP = "
             "\"=train.shafts[2].P\"\nn_1 = \"=train.shafts[2].n\"\nK_A = 1.25\ncasting = \"centrifugal\"\nS_Wmin = "
             "1\nA_h = \"0.6 m^2\"\ndT_adm = \"60 K\"\nsigma_adm = \"" +
             std::string(sigma_adm) + " MPa\"\n";
    };
    const auto strength = [&](const std::string& gears) {
      return mode_of(solved_as_found(train + gears), "train", "strength");
    };
    CHECK(strength(bevel) == "open");
    CHECK(strength(bevel + worm("100")) == "pass");
    CHECK(strength(bevel + worm("60")) == "fail");  // 81 MPa
  }

  TEST_CASE("a stage of crossed helical gears is checked by the step of its gears") {
    const std::string train =
        "[train]\ncalculator = \"drive.train\"\nP = \"0.25 kW\"\nn_1 = \"1000 rpm\"\nstages = [{ name = \"screw\", "
        "kind "
        "= \"crossed\", z_1 = 20, z_2 = 40, m_n = \"2 mm\", eta = 0.88 }]\n";
    const auto strength = [&](const std::string& C_adm) {
      const std::string gears =
          "[screw]\ncalculator = \"gear.crossed\"\nz_1 = \"=train.stages.screw.z_1\"\nz_2 = "
          "\"=train.stages.screw.z_2\"\nm_n = \"=train.stages.screw.m_n\"\nbeta_1 = \"45 deg\"\nbeta_2 = \"45 "
          "deg\"\nb_1 = \"20 mm\"\nb_2 = \"20 mm\"\nmu = 0.06\nP = \"=train.shafts[1].P\"\nn_1 = "
          "\"=train.shafts[1].n\"\nK_A = 1.25\nC_adm = \"" +
          C_adm + " MPa\"\n";
      return mode_of(solved_as_found(train + gears), "train", "strength");
    };
    CHECK(mode_of(solved_as_found(train), "train", "strength") == "open");
    CHECK(strength("2") == "pass");
    CHECK(strength("0.5") == "fail");  // 0.84 MPa
  }

  TEST_CASE("A13: a shaft that takes a chain's pull with K_A takes no torque without K_A") {
    const auto faults = [](const std::string& loads) {
      const std::string text = R"([chain]
calculator = "chain.roller"
chain = "16B"
z_1 = 21
z_2 = 57
a = "1 m"
P = "3 kW"
n_1 = "96 rpm"
K_A = 1.4
p_adm = "30 MPa"

[train]
calculator = "drive.train"
P = "3 kW"
n_1 = "1440 rpm"
stages = [{ kind = "chain", z_1 = 17, z_2 = 51, eta = 0.96 }]

[end]
calculator = "shaft.overhung"
a = "60 mm"
sigma_adm = "60 MPa"
)" + loads;
      std::vector<Issue> issues;
      project::Project project = project::read_project(text, "found.toml", catalogue(), issues);
      if (!has_errors(issues)) project::solve(project, issues);
      std::erase_if(issues, [](const Issue& issue) { return issue.severity != Severity::error; });
      return render(issues, [&](const std::string&) { return text; });
    };
    const std::string mixed = faults("F = \"=chain.F_W\"\nT = \"=train.T_out\"\n");
    CHECK_MESSAGE(mixed.find("'F' includes chain.K_A = 1.4, and 'T' does not") != std::string::npos, mixed);
    CHECK(faults("load = \"=chain.shaft_1\"\n") == "");
    CHECK(faults("F = \"=chain.F_W\"\nT = \"=chain.K_A*train.T_out\"\n") == "");
  }
}
