// Headline jobs as they are typed first: on the shell, without what a textbook has.
#include "tests/cli/process.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace loadpath::test;

namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_SUITE("cli first try") {
  TEST_CASE("a strut of the section tables needs no method") {
    const Ran o = loadpath_with({"column", "buckling", "--section", "HEA 160", "--l", "3 m", "--P", "100 kN", "--ends",
                                 "pinned_pinned", "--material", "S235JR"});
    CHECK(o.code == 0);
    CHECK(holds(o.out + o.error, "gamma_M1 = 1.0, gamma_F = 1"));
  }

  TEST_CASE("buckling is shown before the slenderness limit, which is shown alone without a force") {
    const std::vector<std::string> words{"column", "buckling", "--section",     "HEB 160",    "--l",
                                         "4 m",    "--ends",   "pinned_pinned", "--material", "S235"};
    std::vector<std::string> loaded = words;
    loaded.insert(loaded.end(), {"--P", "300 kN"});
    CHECK(holds(loadpath_with(loaded).out, "Flexural buckling about y and z, utilisation 0.461 (300 / 651 kN)"));
    CHECK(holds(loadpath_with(words).out, "Slenderness limit, utilisation 0.494 (98.8 / 200)"));
    loaded.insert(loaded.end(), {"--n_st", "3"});
    CHECK(holds(loadpath_with(loaded).out, "utilisation 0.976"));  // by the method that takes a safety factor
    loaded.insert(loaded.end(), {"--method", "ec3"});
    CHECK(loadpath_with(loaded).code == 0);  // asked for
  }

  TEST_CASE("a rod without a strength asks for it in at most two lines") {
    const Ran o = loadpath_with(
        {"column", "buckling", "--l", "1 m", "--d", "?", "--ends", "pinned_pinned", "--P", "20 kN", "--E", "210 GPa"});
    CHECK(o.code == 2);
    CHECK(holds(o.error, "give the yield strength R_e, or a material, and the required buckling safety factor n_st"));
    CHECK(std::count(o.error.begin(), o.error.end(), '\n') <= 2);
  }

  TEST_CASE("a shaft takes power and speed") {
    const Ran o =
        loadpath_with({"shaft", "torsion", "--P", "5.5 kW", "--n", "1450 rpm", "--tau_adm", "30 MPa", "--full"});
    CHECK(o.code == 0);
    CHECK(holds(o.out, "T = P / n"));
  }

  TEST_CASE("belts take n_2, i and a as flags as well as n_2_set, i_set and a_set") {
    const std::vector<std::string> words{"belt", "v_sizing", "--P", "11 kW", "--K_A", "1.2", "--n_1", "1460 rpm"};
    const auto with = [&](std::vector<std::string> more) {
      std::vector<std::string> all = words;
      all.insert(all.end(), more.begin(), more.end());
      return loadpath_with(all);
    };
    const Ran by_speed = with({"--n_2", "730 rpm", "--a", "600 mm"});
    CHECK(by_speed.code == 0);
    CHECK(by_speed.out == with({"--n_2_set", "730 rpm", "--a_set", "600 mm"}).out);
    CHECK(with({"--i", "2", "--a", "600 mm"}).code == 0);
  }
}
