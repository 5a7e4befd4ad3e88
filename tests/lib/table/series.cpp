#include "lib/table/library.hpp"
#include "tests/lib/table/tables.hpp"

#include <algorithm>
#include <cmath>

using namespace loadpath;
using namespace loadpath::table;

namespace {

const Series& series(std::string_view name) {
  const auto found = find_series(built_in(), name);
  REQUIRE_MESSAGE(found, name);
  return **found;
}

struct Next {
  const char* series;
  double least;
  double size;
};

}  // namespace

TEST_SUITE("table") {
  TEST_CASE("the next size is the smallest that is not too small") {
    const Next cases[] = {
        {"R20", 27.35, 28},    {"R40", 27.35, 28},    {"R20", 43.17, 45},   {"R40", 43.17, 45},  {"R40", 96.28, 100},
        {"R20", 28, 28},       {"R40", 31.5, 31.5},   {"R40", 31.51, 33.5}, {"R5", 26, 40},      {"R10", 0.1, 0.1},
        {"R40", 10000, 10000}, {"Ra20", 31.4, 32},    {"shaft", 43.17, 45}, {"shaft", 16.5, 19}, {"shaft", 96.28, 100},
        {"bearing", 52.5, 55}, {"bearing", 20.5, 22}, {"bearing", 31, 32},  {"bright", 17, 18},  {"shaft", 0.001, 6},
        {"R40", 0.0101, 0.1},
    };
    for (const Next& c : cases) {
      CAPTURE(c.series);
      CAPTURE(c.least);
      const auto& members = series(c.series).members;
      const auto size = std::lower_bound(members.begin(), members.end(), c.least);
      REQUIRE(size != members.end());
      CHECK(*size == c.size);
    }
  }

  TEST_CASE("an unknown series names the nearest") {
    const auto unknown = find_series(built_in(), "R21");
    CHECK(unknown.fault().message.text() == "unknown series 'R21'");
    CHECK(unknown.fault().hint.text() == "did you mean 'R20'?");
  }

  TEST_CASE("preferred numbers are at the powers of the root of ten that names them") {
    for (const auto& [name, n] : {std::pair{"R5", 5}, {"R10", 10}, {"R20", 20}, {"R40", 40}}) {
      const auto& members = series(name).members;
      CHECK(members.size() == static_cast<std::size_t>(5 * n + 1));
      for (std::size_t i = 0; i < members.size(); ++i) {
        const double exact = 0.1 * std::pow(10.0, static_cast<double>(i) / n);
        CHECK(std::abs(members[i] / exact - 1.0) < 0.01263);
      }
    }
  }

  TEST_CASE("a coarser series is part of the finer ones") {
    for (const auto& [coarse, fine] : {std::pair{"R5", "R10"}, {"R10", "R20"}, {"R20", "R40"}}) {
      const auto& members = series(fine).members;
      for (const double member : series(coarse).members)
        CHECK(std::binary_search(members.begin(), members.end(), member));
    }
  }

  TEST_CASE("members are the doubles nearest to their decimals, in millimetres and in SI") {
    const Series& R40 = series("R40");
    const auto si = members_in_si(R40);
    CHECK(R40.members[100] == 31.5);
    CHECK(si[100] == 0.0315);
    CHECK(R40.members[2] == 0.112);
    CHECK(R40.members[161] == 1060.0);
    CHECK(si[161] == 1.06);
  }
}
