// Each condition of the rule for a torque at the speed of another shaft.
#include "lib/project/references/drives/taken_powers.hpp"

#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// The loads that are found in a shaft with this title, next to a belt between a motor and a fan.
std::string found(const std::string& title, const std::string& T, const std::string& n_fan = "725 rpm") {
  const std::string values = "[values]\nP = \"7.5 kW\"\nn_motor = \"1450 rpm\"\ni = 2\nn_fan = \"" + n_fan + "\"\n\n";
  const std::string shaft = "[s]\ncalculator = \"shaft.torsion\"\nd = \"60 mm\"\nmaterial = \"C45E\"\nS = 2\n";
  const std::string belt = "\n" + example_of("belt.v_sizing", "n_1 = \"=values.n_motor\"\nn_2_set = \"=values.n_fan\"");
  return inputs_found(&project::torques_of_faster_shafts,
                      values + shaft + "title = \"" + title + "\"\nT = \"" + T + "\"\n" + belt, "s");
}

}  // namespace

TEST_SUITE("project: torques of other shafts") {
  TEST_CASE("the torque of the motor in the step of the fan shaft") {
    CHECK(found("Shaft of the fan", "=values.P/values.n_motor") == "T");
    CHECK(found("Shaft of the fan", "=values.P/values.n_fan").empty());
    CHECK(found("Shaft of the fan", "=values.P/values.n_motor*values.i").empty());
    CHECK(found("Shaft of the fan, at the motor", "=values.P/values.n_motor").empty());
    CHECK(found("Intermediate shaft", "=values.P/values.n_motor").empty());
    CHECK(found("Shaft of the fan", "=values.P/values.n_motor", "1440 rpm").empty());  // slip
    CHECK(found("Shaft of the fan", "=values.P/values.n_motor", "2900 rpm").empty());
  }
}
