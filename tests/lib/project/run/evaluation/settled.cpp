// Records whose sizes have settled: found again as long as nothing of them has changed.
#include "lib/project/run/evaluation/settled.hpp"

#include <doctest/doctest.h>

using namespace loadpath::project;

TEST_SUITE("project") {
  TEST_CASE("a settled record is found from the size that its search began at, and from its own") {
    SettledRecords records;
    const RecordState part{{1, 2, 3}, "C45E\n"};
    records.add(part, 0.0, 0.04);
    for (const double from : {0.0, 0.04}) {
      const auto found = records.find(part, from);
      REQUIRE(found);
      CHECK(found->size == 0.04);
      CHECK(found->is_newest);
    }
    CHECK_FALSE(records.find(part, 0.02));
    CHECK_FALSE(records.find({{1, 2, 4}, "C45E\n"}, 0.0));
    CHECK_FALSE(records.find({{1, 2, 3}, "S355\n"}, 0.0));
  }

  TEST_CASE("a part and its neighbour are kept, not a third one") {
    SettledRecords records;
    const RecordState part{{1}, ""}, neighbour{{2}, ""}, third{{3}, ""};
    records.add(part, 0.0, 0.04);
    records.add(neighbour, 0.0, 0.03);
    REQUIRE(records.find(part, 0.0));
    CHECK_FALSE(records.find(part, 0.0)->is_newest);
    CHECK(records.find(neighbour, 0.0)->is_newest);
    records.add(third, 0.0, 0.02);
    CHECK_FALSE(records.find(part, 0.0));
    CHECK(records.find(third, 0.0)->is_newest);
  }
}
