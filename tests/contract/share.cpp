// How much of what can fail the catalogue assesses: the share may only grow.
#include "calculators/catalogue.hpp"
#include "lib/calculator/mode.hpp"

#include <doctest/doctest.h>

#include <cstddef>

using namespace loadpath;

TEST_SUITE("share of failure modes") {
  TEST_CASE("of the declared failure modes the catalogue assesses a share that may only grow") {
    std::size_t declared = 0, assessed = 0;
    for (const Calculator* calculator : calculators()) {
      for (const ModeInfo& mode : calculator->modes) {
        ++declared;
        assessed += is_assessable(mode) ? 1 : 0;
      }
    }
    MESSAGE(assessed, " of ", declared, " failure modes are assessed by some calculator");
    CHECK(assessed >= 419);
    CHECK(100 * assessed >= 60 * declared);
  }
}
