// Records whose sizes have settled: found again as long as nothing of them has changed.
#include "lib/project/run/evaluation/settled.hpp"

#include <doctest/doctest.h>

using namespace loadpath::project;

TEST_SUITE("project") {
  TEST_CASE("a settled record is found as it began, and as it settled") {
    SettledRecords records;
    const RecordState began{{1, 2, 0}, "C45E\n"}, settled{{1, 2, 3}, "C45E\n"};
    records.add(began, settled, {.size = 0.04});
    for (const RecordState& state : {began, settled}) {
      const Settled* const found = records.find(state);
      REQUIRE(found != nullptr);
      CHECK(found->size == 0.04);
    }
    CHECK(records.find({{1, 2, 4}, "C45E\n"}) == nullptr);
    CHECK(records.find({{1, 2, 3}, "S355\n"}) == nullptr);
  }

  TEST_CASE("the parts of a search are kept, and not more and more of them") {
    SettledRecords records;
    for (std::uint64_t part = 0; part < 100; ++part) records.add({{part, 0}, ""}, {{part, 1}, ""}, {});
    CHECK(records.find({{0, 0}, ""}) != nullptr);
    CHECK(records.find({{99, 1}, ""}) != nullptr);
    for (std::uint64_t part = 100; part < 1000; ++part) records.add({{part, 0}, ""}, {{part, 1}, ""}, {});
    CHECK(records.find({{0, 0}, ""}) == nullptr);
    CHECK(records.find({{999, 1}, ""}) != nullptr);
  }
}
