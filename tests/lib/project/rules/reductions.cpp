// Each condition of the rules for loads that are less than their series over a cycle, or than the load of another step.
#include "lib/project/references/reductions.hpp"

#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::vector<project::ReducedLoad> reduced(const project::Step& step, const project::Project&) {
  return step.loads().reduced;
}

/// The inputs of the first step that are less than their loads.
std::string less(const std::string& text) { return inputs_found(&reduced, text); }

/// The messages of the first step for them.
std::string messages(const std::string& text) { return messages_of(&reduced, text); }

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A slider-crank that pushes with 2 kN: the torque of the crank and the force of the rod vary over the revolution.
const std::string press =
    "\n[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"50 mm\"\nl = \"200 mm\"\n"
    "crank = { speed = \"60 rpm\", positions = 36 }\n"
    "loads = [{ name = \"F\", link = \"slider\", at = \"B\", F_x = \"-2 kN\", F_y = \"0 N\" }]\n";

std::string section(const std::string& lines) {
  return "[s]\ncalculator = \"fatigue.din743\"\nmaterial = \"C45E\"\nnotch = \"smooth\"\nd = \"40 mm\"\n"
         "R_z = \"6.3 um\"\nf_max = 1.2\n" +
         lines + press;
}

std::string pair(const std::string& amplitude, const std::string& mean) {
  return section("M_ta = \"" + amplitude + "\"\nM_tm = \"" + mean + "\"\n");
}

}  // namespace

TEST_SUITE("project: loads over a cycle") {
  TEST_CASE("the amplitude and the midrange of one series, together") {
    const std::string swing = "amplitude(press.drive.M)", middle = "midrange(press.drive.M)";
    CHECK(less(pair("=" + swing, "=" + middle)).empty());
    CHECK(less(pair("=" + swing + "/2", "=" + middle + "/2")).empty());
    CHECK(less(pair("=" + swing, "0 N*m")) == "M_ta");
    CHECK(less(pair("0 N*m", "=" + middle)) == "M_tm");
    CHECK(less(pair("=" + middle, "=" + swing)) == "M_ta, M_tm");
    CHECK(less(pair("=" + swing, "=mean(press.drive.M)")) == "M_ta, M_tm");
    CHECK(less(pair("=max(press.drive.M)", "=" + middle)) == "M_ta, M_tm");
    CHECK(less(pair("=0.5*" + swing, "=" + middle)) == "M_ta, M_tm");
    for (const std::string& one : {pair("=" + swing, "0 N*m"), pair("0 N*m", "=" + middle)})
      CHECK(has(messages(one), "use amplitude(press.drive.M) and midrange(press.drive.M) for the pair"));
  }

  TEST_CASE("the maximum and the minimum of one series, together") {
    const auto bar = [](const std::string& largest, const std::string& least, const std::string& more = "") {
      return "[s]\n" +
             with_lines(
                 "calculator = \"fatigue.cycle\"\nsigma_D = \"120 MPa\"\nR_e = "
                 "\"490 MPa\"\nS_F = 1.5\nS_D = 1.5\nsigma_max = \"" +
                     largest + "\"\nsigma_min = \"" + least + "\"\n",
                 more) +
             press;
    };
    const std::string most = "=max(press.links.rod.N)/(100 mm^2)", least = "=min(press.links.rod.N)/(100 mm^2)";
    CHECK(less(bar(most, least)).empty());
    CHECK(less(bar(most, "-500 MPa")) == "sigma_max");
    CHECK(less(bar("500 MPa", least)) == "sigma_min");
    CHECK(less(bar("=amplitude(press.links.rod.N)/(100 mm^2)", "-500 MPa")) == "sigma_max");
    CHECK(has(messages(bar(most, "-500 MPa")), "give the maximum and minimum stress"));
    CHECK(!has(messages(bar("=0.5*" + most.substr(1), "0 MPa")), "load over the cycle"));
  }

  TEST_CASE("a load of a step without a cycle is the series itself") {
    const auto shaft = [](const std::string& T, const std::string& more = "") {
      return "[s]\ncalculator = \"shaft.torsion\"\nd = \"60 mm\"\ntau_adm = \"40 MPa\"\nT = \"" + T + "\"\n" + more +
             press;
    };
    CHECK(less(shaft("=press.drive.M")).empty());
    CHECK(less(shaft("=-press.drive.M")).empty());
    CHECK(less(shaft("=peak(press.drive.M)")).empty());
    CHECK(less(shaft("=0.9*press.drive.M")).empty());
    CHECK(less(shaft("=0.8*press.drive.M")) == "T");
    CHECK(less(shaft("=0.8*peak(press.drive.M)")) == "T");
    for (const std::string of : {"max", "min", "mean", "rms", "amplitude", "midrange"})
      CHECK_MESSAGE(less(shaft("=" + of + "(press.drive.M)")) == "T", of);
    CHECK(has(messages(shaft("=mean(press.drive.M)")),
              "T is mean(press.drive.M), less than the load over the cycle: write =press.drive.M"));
    CHECK(less(shaft("=mean(press.drive.M)", "because.T = \"sheet 4\"\n")).empty());
    CHECK(less(shaft("=0.8*press.drive.M", "because.T = \"sheet 4\"\n")).empty());
  }

  TEST_CASE("a value that comes from a reduced load is less, too") {
    const auto next = [](const std::string& T) {
      return "[next]\ncalculator = \"shaft.torsion\"\nd = \"60 mm\"\ntau_adm = \"40 MPa\"\nT = "
             "\"=s.T\"\n\n[s]\ncalculator "
             "= \"shaft.torsion\"\nd = \"60 mm\"\ntau_adm = \"40 MPa\"\nT = \"" +
             T + "\"\n" + press;
    };
    CHECK(less(next("=press.drive.M")).empty());
    CHECK(less(next("=mean(press.drive.M)")) == "T");
    CHECK(has(messages(next("=mean(press.drive.M)")),
              "T depends on 's.T', which is less than a load over its cycle: see there"));
  }

  TEST_CASE("the largest speed, where wear or life depends on it") {
    const auto bearing = [](const std::string& n) {
      return "[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6309\"\nF_r = \"6 kN\"\nL_h = \"3000 h\"\nn = \"" + n +
             "\"\n" + press;
    };
    CHECK(less(bearing("=peak(press.links.rod.omega)")).empty());
    CHECK(less(bearing("=rms(press.links.rod.omega)")) == "n");
    CHECK(has(messages(bearing("=rms(press.links.rod.omega)")), "less than the speed over the cycle"));
  }

  TEST_CASE("the amplitude that another step has of its cycle, in its place only") {
    const auto both = [](const std::string& sigma_a, const std::string& sigma_m) {
      return example_of("fatigue.combined", "sigma_a = \"" + sigma_a + "\"\nsigma_m = \"" + sigma_m + "\"") +
             "\n[filling]\ncalculator = \"fatigue.cycle\"\nsigma_max = \"=max(press.links.rod.N)/(100 "
             "mm^2)\"\nsigma_min = "
             "\"=min(press.links.rod.N)/(100 mm^2)\"\nsigma_D = \"190 MPa\"\nR_e = \"490 MPa\"\nS_F = 1.5\nS_D = "
             "1.5\n" +
             press;
    };
    CHECK(less(both("=filling.sigma_a", "=filling.sigma_m")).empty());
    CHECK(less(both("=0.5*filling.sigma_a", "=filling.sigma_m")) == "sigma_a");
    CHECK(less(both("=filling.sigma_a", "=filling.sigma_a")) == "sigma_m");
  }

  TEST_CASE("a load that another step computes, by a number") {
    const std::string gears =
        "\n[g]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 60\nm_n = \"3 mm\"\nb = \"30 mm\"\nT_1 = \"60 N*m\"\nK_A = "
        "1.5\n";
    const auto shaft = [&](const std::string& T, const std::string& more = "") {
      return "[s]\ncalculator = \"shaft.torsion\"\nd = \"60 mm\"\ntau_adm = \"40 MPa\"\nT = \"" + T + "\"\n" + more +
             gears;
    };
    CHECK(less(shaft("=g.T_2")).empty());
    CHECK(less(shaft("=0.9*g.T_2")).empty());
    CHECK(less(shaft("=0.8*g.T_2")) == "T");
    CHECK(less(shaft("=g.T_2/3")) == "T");
    CHECK(less(shaft("=g.T_2/g.z_2*g.z_1")).empty());  // by two counts: the other shaft
    CHECK(less(shaft("=g.T_1*g.z_2/g.z_1")).empty());
    CHECK(less(shaft("=2*g.T_2")).empty());
  }
}
