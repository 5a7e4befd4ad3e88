#include "lib/quantity/places.hpp"

#include <doctest/doctest.h>

using loadpath::Places;

TEST_SUITE("places of an axis") {
  TEST_CASE("numbers") {
    Places places{0.5, 1.5};
    places.add(4.0);
    CHECK(places.size() == 3);
    CHECK(places.front() == 0.5);
    CHECK(places[1] == 1.5);
    CHECK(places.back() == 4.0);
    CHECK(places.values() == std::vector{0.5, 1.5, 4.0});
    CHECK(places == Places({0.5, 1.5, 4.0}));
    CHECK(Places().empty());
  }

  TEST_CASE("samples, beyond 32 bits too") {
    constexpr std::uint64_t most = 0xFFFF'FFFF;
    Places places;
    for (const std::uint64_t sample : {std::uint64_t{3}, most}) places.add_sample(sample);
    CHECK(places.numbers().empty());
    CHECK(places.size() == 2);
    CHECK(places.back() == 4294967295.0);
    places.add_sample(most + 1);
    places.add_sample(most + 5);
    CHECK(places.values() == std::vector{3.0, 4294967295.0, 4294967296.0, 4294967300.0});
  }
}
