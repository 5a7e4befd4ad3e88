// Several inputs of one step that are searched for: against brute force over the candidates, each given as a literal.
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"
#include "tests/lib/project/texts.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string key_with(const std::string& d, const std::string& key, const std::string& l) {
  return "[k]\ncalculator = \"shaft.key\"\ntorque = \"one_way\"\nT = \"400 N*m\"\nl_n = \"70 mm\"\nR_e_1 = \"370 "
         "MPa\"\n"
         "R_e_2 = \"300 MPa\"\nR_e_k = \"420 MPa\"\nd = \"" +
         d + "\"\nkey = \"" + key + "\"\nl = \"" + l + "\"\n";
}

bool is_sound(const std::string& text) {
  for (const char* mode : {"shaft", "hub", "key", "shear", "length", "hub_length", "fit", "depth"}) {
    if (mode_of(solved_as_found(text), "k", mode) != "pass") return false;
  }
  return true;
}

/// The smallest size of R40 of at least d, mm, between 20 and 60.
double next_size(double d) {
  constexpr std::array sizes{20.0, 21.2, 22.4, 23.6, 25.0, 26.5, 28.0, 30.0, 31.5, 33.5,
                             35.5, 37.5, 40.0, 42.5, 45.0, 47.5, 50.0, 53.0, 56.0, 60.0};
  for (const double size : sizes) {
    if (size >= d) return size;
  }
  return 0.0;
}

}  // namespace

TEST_SUITE("nested searches") {
  TEST_CASE("a key and its length: the first row with a length that passes") {
    const project::Project found = solved_as_found(key_with("50 mm", "?", "?"));
    CHECK(found.find("k")->word("key") == "14x9");
    const double l = value(found, "k.l") * 1000.0;
    const auto length = [](double mm) { return std::to_string(static_cast<int>(std::lround(mm))) + " mm"; };
    CHECK(is_sound(key_with("50 mm", "14x9", length(l))));
    for (const int shorter : {36, 40, 45, 50, 56, 63}) {  // a key 14x9 is made from 36 mm on
      if (shorter < l) CHECK_FALSE(is_sound(key_with("50 mm", "14x9", length(shorter))));
    }
  }

  TEST_CASE("a diameter, the key in it and its length: a smaller diameter has no key that passes") {
    const project::Project found = solved_as_found(key_with("?", "?", "?"));
    const double d = value(found, "k.d") * 1000.0;
    REQUIRE(d > 20.0);
    CHECK(next_size(d) == doctest::Approx(d));
    for (const char* smaller : {"20 mm", "22.4 mm", "25 mm", "28 mm"}) {
      if (std::stod(smaller) < d) CHECK(mode_of(solved_as_found(key_with(smaller, "?", "?")), "k", "hub") != "pass");
    }
  }

  TEST_CASE("the diameters of segments in torsion: each the smallest for its own torque") {
    const project::Project found = solved(R"([s]
calculator = "shaft.torsion"
tau_adm = "30 MPa"
torques = [{ x = "0 m", T = "500 N*m" }, { x = "1 m", T = "-300 N*m" }, { x = "2 m", T = "-200 N*m" }]
segments = [{ l = "1 m", d = "?" }, { l = "1 m", d = "?" }]
)");
    const auto least = [](double T) { return std::cbrt(16.0 * T / (std::numbers::pi * 30.0e6)) * 1000.0; };
    CHECK(value(found, "s.segments[1].d") * 1000.0 == doctest::Approx(next_size(least(500.0))));
    CHECK(value(found, "s.segments[2].d") * 1000.0 == doctest::Approx(next_size(least(200.0))));
  }

  TEST_CASE("a load and a size cannot be searched for together") {
    CHECK(
        issues_of("[s]\ncalculator = \"column.buckling\"\nP = \"?\"\nd = \"?\"\nl = \"1 m\"\nends = \"pinned_pinned\"\n"
                  "E = \"210 GPa\"\nR_e = \"355 MPa\"\nmethod = \"johnson\"\nn_st = 3\n")
            .find("cannot be searched for together with") != std::string::npos);
  }
}
