// What must not be told wrongly again of drives: rows of the list of what was found by use.
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

TEST_SUITE("found drive") {
  TEST_CASE("B9: speeds of shafts are told in rad/s, in the line and where it is used") {
    const ExampleStep train("drive.train", "");
    int speeds = 0;
    for (const account::Derived& line : train.project().steps[0]->account().derivation) {
      CHECK(line.step.value.unit != "1/s");
      for (const auto& given : line.step.given) CHECK(given.unit != "1/s");
      speeds += line.step.value.unit == "rad/s" ? 1 : 0;
    }
    CHECK(speeds > 0);
  }
}
