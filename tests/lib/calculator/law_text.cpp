// Laws that read themselves when their text is set.
#include "lib/calculator/law_text.hpp"

#include "lib/quantity/units.hpp"

#include <doctest/doctest.h>

namespace {

using namespace loadpath;

inline constexpr Law::Variable time_variable{"t", sec.dimension()};
using LengthLaw = LawOf<mm, time_variable>;

}  // namespace

TEST_SUITE("laws as typed") {
  TEST_CASE("a text is read when it is set, and copies share what was read") {
    LengthLaw law;
    CHECK(law.empty());
    CHECK(law.law() == nullptr);
    CHECK(law.fault() == nullptr);
    law = "3 m + 2 m*t/(1 s)";
    REQUIRE(law.law() != nullptr);
    CHECK(law.view() == "3 m + 2 m*t/(1 s)");
    CHECK(law.law()->at(2.0).value == doctest::Approx(7.0));
    const LengthLaw copy = law;
    CHECK(copy.law() == law.law());
  }

  TEST_CASE("a text that is not a law of its quantity is kept with the reason") {
    const LengthLaw law = "3 N*t/(1 s)";
    CHECK(law.law() == nullptr);
    CHECK(law.view() == "3 N*t/(1 s)");
    REQUIRE(law.fault() != nullptr);
    CHECK(law.fault()->message.text() == "the law gives the kind 'force', and 'length' is expected");
  }
}
