// The rule for torques of connections that their title puts on the other shaft of a drive.
#include "lib/project/references/drives/elements.hpp"

#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// A chain of 3 kW from 96 rpm to 35.4 rpm, and a key with this torque and title.
std::string found(const std::string& title, const std::string& T, const std::string& more = "") {
  INFO(title << " " << T);
  std::string key = example_of("shaft.key", "T = \"" + T + "\"\nK_A =");
  key.replace(0, key.find('\n') + 1, "[key]\ntitle = \"" + title + "\"\n");
  return inputs_found(&project::torques_of_other_elements, example_of("chain.roller") + key + more, "key");
}

}  // namespace

TEST_SUITE("project: torques of other elements") {
  TEST_CASE("a connection has the torque of the shaft in its title") {
    CHECK(found("Key of the large sprocket", "=conveyor.P/conveyor.n_1") == "T");
    CHECK(found("Key of the driven sprocket", "=conveyor.shaft_1.T") == "T");
    CHECK(found("Key of the conveyor drum", "=conveyor.shaft_1.T") == "T");
    CHECK(found("Key of the large sprocket", "=conveyor.shaft_2.T").empty());
    CHECK(found("Key of the small sprocket", "=conveyor.shaft_1.T").empty());
    CHECK(found("Key of the small sprocket", "=conveyor.P/(1450 rpm)") == "T");
  }

  TEST_CASE("what explains another torque, or another shaft") {
    CHECK(found("Key of the large sprocket", "=conveyor.shaft_1.T*conveyor.i").empty());
    CHECK(found("Key of the large sprocket", "300 N*m").empty());
    CHECK(found("Key", "=conveyor.shaft_1.T").empty());
    std::string second = example_of("chain.roller");
    second.replace(0, second.find('\n') + 1, "[second]\n");
    CHECK(found("Key of the large sprocket", "=conveyor.shaft_1.T", second).empty());
  }
}
