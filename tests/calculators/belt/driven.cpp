// The driven pulley from a speed or a ratio, and the words that a project may write for it.
#include "calculators/belt/driven.hpp"

#include "tests/calculators/belt/steps.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>

namespace {

using namespace loadpath;
using test::BeltStep;

const std::string wedge = R"(calculator = "belt.v"
section = "SPB"
P = "30 kW"
K_A = 1.3
n_1 = "1460 rpm"
d_1 = "200 mm"
L = "2650 mm"
)";

const std::string flat = R"(calculator = "belt.flat"
P = "15 kW"
n_1 = "1450 rpm"
d_1 = "200 mm"
a = "1200 mm"
mu = 0.4
delta = "2.5 mm"
b = "160 mm"
rho = "1100 kg/m^3"
sigma_adm = "6 MPa"
)";

const std::string pick = R"(calculator = "belt.v_sizing"
P = "11 kW"
K_A = 1.2
n_1 = "1460 rpm"
)";

}  // namespace

TEST_SUITE("belt driven pulley") {
  TEST_CASE("the nearest pulley is that of the smallest ratio to the wanted one") {
    const std::array pulleys{100.0 * mm, 125.0 * mm, 160.0 * mm};
    CHECK(in_si(belt::nearest_pulley(pulleys, 112.0 * mm)) == doctest::Approx(0.125));  // over sqrt(100 125) = 111.8
    CHECK(in_si(belt::nearest_pulley(pulleys, 111.0 * mm)) == doctest::Approx(0.100));
    CHECK(in_si(belt::nearest_pulley(pulleys, 999.0 * mm)) == doctest::Approx(0.160));
  }

  // i = 2 with 1 % slip: d_2 = 2*0.99*200 = 396 mm, of the list 400 mm: i = 400/200/0.99 = 2.0202, 1.01 % more.
  TEST_CASE("a V-belt drive takes a ratio or a speed in place of the driven pulley") {
    for (const char* wanted : {"i = 2\n", "i_set = 2\n", "n_2 = \"730 rpm\"\n", "n_2_set = \"730 rpm\"\n"}) {
      const BeltStep step(wedge + wanted);
      CAPTURE(wanted);
      REQUIRE(step.issues.empty());
      CHECK(step.value("d_2") == doctest::Approx(0.4));
      CHECK(step.value("i_w") == doctest::Approx(2.0));
      CHECK(step.value("i") == doctest::Approx(2.0202).epsilon(1e-4));
      CHECK(step.value("dev_i") == doctest::Approx(0.0101).epsilon(1e-2));
      CHECK(step.value("P_all") == BeltStep(wedge + "d_2 = \"400 mm\"\n").value("P_all"));
    }
  }

  // d_2 = 2.5*0.99*200 = 495 mm, of R20 500 mm.
  TEST_CASE("a flat belt drive takes them too, with a pulley of R20") {
    CHECK(BeltStep(flat + "i = 2.5\n").value("d_2") == doctest::Approx(0.5));
    CHECK(BeltStep(flat + "n_2 = \"580 rpm\"\n").value("i_w") == doctest::Approx(2.5));
    CHECK(BeltStep(flat + "i = 2.5\n").value("R") == BeltStep(flat + "d_2 = \"500 mm\"\n").value("R"));
  }

  TEST_CASE("only one of them may be given, and the error names the fix") {
    for (const std::string& step : {wedge, flat}) {
      const char* const fix = "give one of these: the driven pulley d_2, its speed n_2, the ratio i";
      CHECK(BeltStep(step).says(fix));
      CHECK(BeltStep(step + "d_2 = \"400 mm\"\ni = 2\n").says(fix));
      CHECK(BeltStep(step + "n_2 = \"580 rpm\"\ni = 2\n").says(fix));
    }
    CHECK(BeltStep(pick + "a = \"600 mm\"\n").says("give either the speed n_2 of the driven pulley or the ratio i"));
  }

  TEST_CASE("drives are selected by n_2 or i and a; wanted and actual values are reported") {
    const BeltStep by_speed(pick + "n_2 = \"730 rpm\"\na = \"600 mm\"\n");
    const BeltStep by_ratio(pick + "i = 2\na_set = \"600 mm\"\n");
    const BeltStep as_before(pick + "basis = \"optibelt\"\nn_2_set = \"730 rpm\"\na_set = \"600 mm\"\n");
    for (const BeltStep* step : {&by_speed, &by_ratio, &as_before}) {
      REQUIRE(step->issues.empty());
      CHECK(step->value("i_w") == doctest::Approx(2.0));
      CHECK(step->value("d_2") == as_before.value("d_2"));
      CHECK(step->value("a") == as_before.value("a"));
      CHECK(step->value("n_2") == as_before.value("n_2"));
    }
    CHECK(by_speed.value("a") != 0.6);  // the result, not the wanted distance
  }

  TEST_CASE("a short form and the key that it stands for are the same input") {
    CHECK(BeltStep(pick + "n_2 = \"730 rpm\"\na = \"600 mm\"\na_set = \"600 mm\"\n")
              .says("'a' and 'a_set' are the same input give one of them"));
  }

  TEST_CASE("without a basis the ratings with the most sections apply, and they are named") {
    const BeltStep step(wedge + "d_2 = \"400 mm\"\n");
    REQUIRE(step.issues.empty());
    CHECK(step.value("P_all") == BeltStep(wedge + "basis = \"optibelt\"\nd_2 = \"400 mm\"\n").value("P_all"));
    const auto& results = step.project.steps[0]->account().results;
    const auto rating =
        std::find_if(results.begin(), results.end(), [](const auto& entry) { return entry.path == "rating"; });
    REQUIRE(rating != results.end());
    CHECK(rating->word == "optibelt");
  }
}
