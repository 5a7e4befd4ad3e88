// Each condition of the rules that compare an input with the step that it comes from.
#include "lib/project/references/origins.hpp"

#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string found(const std::string& text) { return inputs_found(&project::values_of_others, text); }

std::string shaft(const std::string& name, const std::string& T, const std::string& d = "50 mm") {
  return "\n[" + name + "]\ncalculator = \"shaft.torsion\"\nT = \"" + T + "\"\nd = \"" + d +
         "\"\ntau_adm = \"40 MPa\"\n";
}

}  // namespace

TEST_SUITE("project: values of other steps") {
  TEST_CASE("a connection has the torque of the shaft whose diameter it takes") {
    const auto key = [](const std::string& d, const std::string& T) {
      return example_of("shaft.key", "d = \"" + d + "\"\nT = \"" + T + "\"");
    };
    CHECK(found(key("=sh.d", "450 N*m") + shaft("sh", "450 N*m")).empty());
    CHECK(found(key("=sh.d", "500 N*m") + shaft("sh", "450 N*m")).empty());
    CHECK(found(key("=sh.d", "440 N*m") + shaft("sh", "450 N*m")) == "T");
    CHECK(found(key("=1*sh.d", "440 N*m") + shaft("sh", "450 N*m")).empty());  // a size of its own
    CHECK(found(key("50 mm", "440 N*m") + shaft("sh", "450 N*m")).empty());
    CHECK(found(key("=sh.d", "440 N*m") + shaft("sh", "-450 N*m")) == "T");
    CHECK(found(shaft("next", "400 N*m", "=sh.d") + shaft("sh", "450 N*m")).empty());  // no connection
    const std::string fit = example_of("shaft.press_fit", "d = \"=sh.d\"\nT = \"440 N*m\"");
    CHECK(found(fit + shaft("sh", "450 N*m", "60 mm")) == "T");
  }

  TEST_CASE("the outputs of a shaft share the torque of its input") {
    const auto key = [](const std::string& name, const std::string& T) {
      std::string one = example_of("shaft.key", "d = \"=sh.d\"\nT = \"" + T + "\"");
      return one.replace(1, one.find(']') - 1, name) + "\n";
    };
    const std::string all = shaft("sh", "450 N*m");
    CHECK(found(key("a", "225 N*m") + key("b", "225 N*m") + key("c", "450 N*m") + all).empty());
    CHECK(found(key("a", "225 N*m") + key("b", "160 N*m") + key("c", "450 N*m") + all).empty());  // losses
    CHECK(found(key("a", "225 N*m") + key("b", "150 N*m") + key("c", "450 N*m") + all) == "T");
    CHECK(found(key("a", "225 N*m") + key("b", "225 N*m") + all) == "T");  // nothing drives
    CHECK(found(key("a", "225 N*m") + key("c", "450 N*m") + all) == "T");
  }

  TEST_CASE("a ratio of speeds is that of another step or its reciprocal") {
    const auto motion = [](const std::string& i) {
      return example_of("machine.motion", "i = \"" + i + "\"") +
             "\n[t]\ncalculator = \"drive.train\"\nP = \"5.5 kW\"\nn_1 = \"1450 rpm\"\nstages = [{ name = \"gears\", "
             "kind = \"gear\", z_1 = 20, z_2 = 80, eta = 0.97 }]\n";
    };
    CHECK(found(motion("=abs(t.i)")).empty());
    CHECK(found(motion("=1/abs(t.i)")).empty());
    CHECK(found(motion("=2*abs(t.i)")) == "i");
    CHECK(found(motion("=4 + 0*abs(t.i)")).empty());
    CHECK(found(motion("=5 * (t.n_1/t.n_1)")).empty());  // a speed is not a ratio
  }

  TEST_CASE("a component of a force next to its magnitude") {
    const auto lug = [](const std::string& F) {
      return example_of("pin.lug", "F = \"" + F + "\"") + "\n" + press_of_heavy_rod;
    };
    CHECK(found(lug("=press.joints.B.F")).empty());
    CHECK(found(lug("=press.joints.B.x")) == "F");
    CHECK(found(lug("=press.joints.B.y")).empty());  // a slider without mass: the guide holds the whole force
  }
}
