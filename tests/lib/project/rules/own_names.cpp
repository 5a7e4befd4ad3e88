// Each condition of the rules for loads, strengths and factors that are a part of a value of [values].
#include "lib/project/references/drives/own_names.hpp"

#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string found(const std::string& text, const std::string& step = "") {
  return inputs_found(&project::values_in_part, text, step);
}

std::string shaft(const std::string& T, const std::string& more = "") {
  return "[s]\ncalculator = \"shaft.torsion\"\nd = \"60 mm\"\nmaterial = \"C45E\"\nS = 2\nT = \"" + T + "\"\n" + more;
}

std::string lug(const std::string& F, const std::string& more = "") {
  return "[e]\n" +
         with_lines(
             "calculator = \"pin.lug\"\nF = \"" + F +
                 "\"\nd = \"40 mm\"\nb = \"110 mm\"\na = \"38 mm\"\nt = \"25 mm\"\np_adm = \"90 MPa\"\nmaterial = "
                 "\"S355\"\nS = 2\n",
             more);
}

const std::string torque = "[values]\nT = \"300 N*m\"\nshare = 0.5\n\n";
const std::string force = "[values]\nF = \"40 kN\"\nn = 4\nphi = \"30 deg\"\n\n";
const std::string power = "[values]\nP = \"20 kW\"\nn = \"1000 rpm\"\nl = \"2 m\"\nF = \"2 kN\"\n\n";

}  // namespace

TEST_SUITE("project: values in part") {
  TEST_CASE("a torque by a bare number") {
    for (const std::string T : {"=0.5*values.T", "=values.T/2", "=values.T/4", "=0.84*values.T"})
      CHECK_MESSAGE(found(torque + shaft(T)) == "T", T);
    for (const std::string T : {"=values.T", "=0.85*values.T", "=values.share*values.T", "=2*values.T", "=0*values.T",
                                "=values.T*cos(60 deg)", "=values.T*sin(30 deg)", "=values.T*tan(20 deg)"})
      CHECK_MESSAGE(found(torque + shaft(T)).empty(), T);
    const std::string rest = shaft("=values.T/2").replace(1, 1, "r");
    CHECK(found(torque + shaft("=values.T/2") + "\n" + rest).empty());  // two halves
    CHECK(found(torque + shaft("=values.T/4") + "\n" + rest) == "T");
    CHECK(found(torque + shaft("=values.T/4") + "\n" + shaft("=values.T").replace(1, 1, "r")) == "T");
  }

  TEST_CASE("a force that two equal parts share") {
    for (const std::string F : {"=values.F/2", "=0.5*values.F", "=values.F*0.5", "=values.F / 2"})
      CHECK_MESSAGE(found(force + lug(F)).empty(), F);
    for (const std::string F :
         {"=values.F/4", "=0.3*values.F", "=values.F/2.5", "=values.F/20", "=0.25*values.F", "=values.F/2/2"})
      CHECK_MESSAGE(found(force + lug(F)) == "F", F);
    for (const std::string F : {"=values.F/values.n", "=values.F*sin(values.phi)/2*0 + values.F"})
      CHECK_MESSAGE(found(force + lug(F)).empty(), F);
  }

  TEST_CASE("a product of values by a bare number") {
    CHECK(found(power + shaft("=values.P/values.n/1.5")) == "T");
    CHECK(found(power + shaft("=values.P/values.n")).empty());
    CHECK(found(power + shaft("=0.9*values.P/values.n")).empty());
    CHECK(found(power + shaft("=0.2*values.F*values.l")).empty());  // the moment of a beam
    const std::string named = "[values]\nP = \"20 kW\"\nn = \"1000 rpm\"\nT = \"=0.5*values.P/values.n\"\n\n";
    CHECK(found(named + shaft("=values.T")).empty());
    const std::string rest = "\n" + shaft("=values.P/values.n/2").replace(1, 1, "r");
    CHECK(found(power + shaft("=values.P/values.n/2") + rest).empty());
    CHECK(found(power + shaft("=values.P/values.n/2")) == "T");
  }

  TEST_CASE("strengths, factors and pressures under their own names") {
    const std::string strengths = "[values]\nR_e = \"300 MPa\"\nK_A = 1.5\nS = 2\n\n";
    const auto with_strength = [&](const std::string& lines) {
      return found(
          strengths + "[s]\n" +
          with_lines("calculator = \"shaft.torsion\"\nd = \"60 mm\"\nR_e = \"300 MPa\"\nS = 2\nT = \"300 N*m\"\n",
                     lines));
    };
    CHECK(with_strength("R_e = \"=1.2*values.R_e\"") == "R_e");
    CHECK(with_strength("R_e = \"=values.R_e\"").empty());
    CHECK(with_strength("R_e = \"=0.8*values.R_e\"").empty());
    CHECK(with_strength("S = \"=0.8*values.S\"") == "S");
    CHECK(with_strength("S = \"=1.2*values.S\"").empty());
    const std::string pressures = "[values]\np = \"1 MPa\"\n\n";
    const auto wall = [&](const std::string& p) {
      return found(pressures + "[v]\ncalculator = \"vessel.cylinder\"\np = \"" + p +
                   "\"\nR = \"600 mm\"\nsigma_adm = \"140 MPa\"\n");
    };
    CHECK(wall("=0.8*values.p") == "p");
    CHECK(wall("=1.2*values.p").empty());
    CHECK(wall("=values.p").empty());
  }

  TEST_CASE("teeth explain no share of a power") {
    const std::string worm = example_of("gear.worm", "P = \"=0.5*values.P\"");  // of two threads
    CHECK(found("[values]\nP = \"0.6 kW\"\n\n" + worm) == "P");
    const std::string losses = example_of("gear.worm", "P = \"=0.95*values.P\"");
    CHECK(found("[values]\nP = \"0.6 kW\"\n\n" + losses).empty());
  }

  TEST_CASE("the length of a column by a bare number") {
    const std::string height = "[values]\nh = \"4 m\"\nn = 2\nlower = \"2 m\"\n\n";
    const auto column = [](const std::string& l) { return example_of("column.buckling", "l = \"" + l + "\""); };
    CHECK(found(height + column("=values.h/2")) == "l");
    CHECK(found(height + column("=0.25*values.h")) == "l");
    CHECK(found(height + column("=0.9*values.h")).empty());
    CHECK(found(height + column("=values.h/values.n")).empty());
    CHECK(found(height + column("=values.lower")).empty());
    std::string upper = column("=values.h/2");
    upper.replace(0, upper.find(']'), "[upper");
    CHECK(found(height + column("=values.h/2") + upper).empty());
  }

  TEST_CASE("a computed speed under the name of another one") {
    const std::string speeds = "[values]\nn_1 = \"1000 rpm\"\ni = 3\nslip = 0.98\n\n";
    const auto drive = [](const std::string& n) { return example_of("chain.roller", "n_1 = \"" + n + "\""); };
    CHECK(found(speeds + drive("=values.n_1*values.i")) == "n_1");
    CHECK(found(speeds + drive("=values.n_1/values.i")).empty());  // of a later stage
    CHECK(found(speeds + drive("=values.n_1*values.slip")).empty());
    CHECK(found(speeds + drive("=values.n_1")).empty());
    std::string first = example_of("gear.worm", "n_1 = \"=values.n_1\"");
    first.replace(0, first.find(']'), "[first");
    CHECK(found(speeds + drive("=values.n_1*values.i") + first).empty());
  }

  TEST_CASE("a speed that is a part of another one by a bare number") {
    const std::string speed = "[values]\nn = \"1000 rpm\"\ni = 4\n\n";
    const auto bearing = [&](const std::string& n) {
      return found(speed + "[b]\ncalculator = \"bearing.rolling\"\nbearing = \"6309\"\nF_r = \"6 kN\"\nn = \"" + n +
                   "\"\nL_h = \"3000 h\"\n");
    };
    CHECK(bearing("=values.n/60") == "n");
    CHECK(bearing("=0.5*values.n") == "n");
    CHECK(bearing("=values.n").empty());
    CHECK(bearing("=0.9*values.n").empty());
    CHECK(bearing("=values.n/values.i").empty());
    CHECK(bearing("=2*values.n").empty());
  }
}
