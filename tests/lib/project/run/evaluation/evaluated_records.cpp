// Records that were evaluated: found again as long as nothing of them has changed.
#include "lib/project/run/evaluation/evaluated_records.hpp"

#include <doctest/doctest.h>

using namespace loadpath::project;

TEST_SUITE("project") {
  TEST_CASE("the result of an evaluated record is found with the same values and rows only") {
    EvaluatedRecords records;
    records.add({{1, 2, 3}, "C45E\n"}, {});
    CHECK(records.find({{1, 2, 3}, "C45E\n"}) != nullptr);
    CHECK(records.find({{1, 2, 4}, "C45E\n"}) == nullptr);
    CHECK(records.find({{1, 2, 3}, "S355\n"}) == nullptr);
  }

  TEST_CASE("the parts of a search are kept, and not more and more of them") {
    EvaluatedRecords records;
    for (std::uint64_t part = 0; part < 100; ++part) records.add({{part}, ""}, {});
    CHECK(records.find({{0}, ""}) != nullptr);
    CHECK(records.find({{99}, ""}) != nullptr);
    for (std::uint64_t part = 100; part < 2000; ++part) records.add({{part}, ""}, {});
    CHECK(records.find({{0}, ""}) == nullptr);
    CHECK(records.find({{1999}, ""}) != nullptr);
  }
}
