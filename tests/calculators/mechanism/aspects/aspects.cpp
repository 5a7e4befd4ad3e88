// Declarations of the results of a mechanism, for all aspects.
#include "calculators/mechanism/aspects.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace loadpath;
using namespace loadpath::planar;

TEST_SUITE("mechanism aspects") {
  TEST_CASE("an aspect that gives results lists them, and one that lists some gives them") {
    for (const Aspect* aspect : all_aspects()) CHECK((aspect->list == nullptr) == (aspect->add_outputs == nullptr));
  }

  TEST_CASE("no result is documented twice for the same objects") {
    std::set<std::string> seen;
    for (const ResultPattern& p : result_patterns())
      CHECK(seen.insert(std::string(p.path) + " " + p.unit + " " + p.where).second);
  }
}
