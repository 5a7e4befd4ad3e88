// Worked examples of four texts on machine theory, at the digits that follow from their data.
#include "tests/lib/mechanism/worked_models.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

void check(Vec mine, Vec exact) {
  CAPTURE(exact.x);
  CAPTURE(exact.y);
  CHECK(length(mine - exact) <= 2e-9 * length(exact));
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("crank and slotted lever, example 10.1: the one position with round data") {
    for (const bool with_slider : {false, true}) {
      const Solved solved = solve(slotted_lever(with_slider), {{-60.0 * degree, 45.0, 0.0}});
      REQUIRE(solved.status == Status::closed);
      const Position& at = solved.at;
      CHECK(at.velocity[1].phi == doctest::Approx(8.653846154).epsilon(1e-9));
      CHECK(at.acceleration[1].phi == doctest::Approx(249.0463587).epsilon(1e-9));
      CHECK(at.effort[0] == doctest::Approx(15.14111441).epsilon(1e-9));
      check(at.reactions[1].force, {212.55443, 176.7560397});
      CHECK(length(at.reactions[0].force) == doctest::Approx(727.8941916).epsilon(1e-9));
      // On the crank; the text gives the force of the crank on the slider.
      check(at.reactions[2].force, with_slider ? Vec{174.8345296, 706.5853391} : Vec{-174.8345296, -706.5853391});
      if (with_slider) {
        CHECK(length(at.reactions[3].force) == doctest::Approx(727.8941916).epsilon(1e-9));
        CHECK(std::abs(at.reactions[3].couple) < 1e-9);
      }
    }
  }

  TEST_CASE("crank and slotted lever, example 10.1: over a revolution") {
    const struct {
      double crank_deg, M, R12, R03, phi3_deg, omega3, eps3;
    } rows[] = {{-60.0, 15.14111441, 727.8941916, 276.4454436, -13.89788625, 8.653846154, 249.0463587},
                {-45.0, 13.75554497, 554.3875419, 338.5191567, -10.79908049, 9.861894191, 169.4104653},
                {-30.0, 11.81476162, 426.6779221, 385.271923, -7.369259788, 10.65489638, 105.2298597},
                {0.0, 7.2, 240.0, 449.5081783, 0.0, 11.25, 0.0},
                {45.0, -1.132320402, 45.63572914, 553.6656938, 10.79908049, 9.861894191, -169.4104653},
                {90.0, -6.8643, 723.5607514, 894.0499635, 18.43494882, 4.5, -486.0},
                {120.0, 10.2443314, 1806.930216, 1556.483253, 19.10660535, -3.214285714, -858.9558087},
                {150.0, 60.65372005, 2772.894271, 2291.174401, 13.18678543, -14.96996488, -1052.998701},
                {180.0, -14.4, 480.0, 367.5979777, 0.0, -22.5, 0.0},
                {195.0, -77.39664584, 2787.468297, 1344.289568, -7.251444915, -20.31183324, 711.5659202},
                {210.0, -79.81527509, 3648.89934, 1814.0221, -13.18678543, -14.96996488, 1052.998701},
                {240.0, -14.35861712, 2532.622004, 940.9802886, -19.10660535, -3.214285714, 858.9558087},
                {270.0, 12.6243, 1330.718062, 253.8828078, -18.43494882, 4.5, 486.0},
                {285.0, 15.27211539, 974.0224896, 213.2529589, -16.51001517, 6.919515649, 351.7199041}};
    WholeSystem system(slotted_lever());
    REQUIRE(system.assemble() == Status::closed);
    Position at = system.blank();
    for (const auto& row : rows) {
      CAPTURE(row.crank_deg);
      const Drive drive{row.crank_deg * degree, 45.0, 0.0};
      REQUIRE(system.solve({&drive, 1}, at) == Status::closed);
      CHECK(at.effort[0] == doctest::Approx(row.M).epsilon(1e-9));
      CHECK(length(at.reactions[2].force) == doctest::Approx(row.R12).epsilon(1e-9));
      CHECK(length(at.reactions[1].force) == doctest::Approx(row.R03).epsilon(1e-9));
      CHECK(at.pose[1].phi / degree == doctest::Approx(row.phi3_deg).epsilon(1e-9));
      CHECK(at.velocity[1].phi == doctest::Approx(row.omega3).epsilon(1e-9));
      CHECK(at.acceleration[1].phi == doctest::Approx(row.eps3).epsilon(1e-9));
    }
  }

  TEST_CASE("crank and slotted lever, example 10.1: zero work per revolution, the peak in the return stroke") {
    WholeSystem system(slotted_lever());
    REQUIRE(system.assemble() == Status::closed);
    Position at = system.blank();
    constexpr int positions = 3600;
    double sum = 0.0;
    double peak = 0.0;
    double peak_deg = 0.0;
    for (int k = 0; k < positions; ++k) {
      const double crank_deg = -60.0 + 0.1 * k;
      const Drive drive{crank_deg * degree, 45.0, 0.0};
      REQUIRE(system.solve({&drive, 1}, at) == Status::closed);
      sum += at.effort[0];
      if (std::abs(at.effort[0]) <= std::abs(peak)) continue;
      peak = at.effort[0];
      peak_deg = crank_deg;
    }
    CHECK(std::abs(sum / positions) < 1e-9 * std::abs(peak));
    CHECK(peak == doctest::Approx(-86.085).epsilon(1e-5));
    CHECK(peak_deg == doctest::Approx(202.7).epsilon(1e-4));
  }

  TEST_CASE("crank and slotted lever, example 10.1: a load in the working stroke only takes 19.575 J per revolution") {
    WholeSystem system(slotted_lever());
    REQUIRE(system.assemble() == Status::closed);
    Position at = system.blank();
    const Vec force = slotted_lever().loads[0].force;
    constexpr int positions = 3600;
    double work = 0.0;
    for (int k = 0; k < positions; ++k) {
      const double crank_deg = -60.0 + 0.1 * (k + 0.5);
      const bool working = std::cos(crank_deg * degree) > -1.0 / 3.0;  // omega3 > 0
      system.set_load(0, working ? force : Vec{}, 0.0);
      const Drive drive{crank_deg * degree, 45.0, 0.0};
      REQUIRE(system.solve({&drive, 1}, at) == Status::closed);
      work += at.effort[0] * 2.0 * std::numbers::pi / positions;
    }
    CHECK(work == doctest::Approx(19.575).epsilon(1e-4));
  }

  TEST_CASE("structural group with three turning pairs") {
    const Solved solved = solve(group_with_three_turning_pairs(), {});
    REQUIRE(solved.status == Status::closed);
    check(solved.at.reactions[0].force, {69.38330171, 142.9364326});
    check(solved.at.reactions[1].force, {-99.38330171, -22.93643264});
    check(solved.at.reactions[2].force, {100.6166983, 32.06356736});
  }

  TEST_CASE("structural group with an outer sliding pair") {
    const Solved solved = solve(group_with_outer_sliding_pair(), {});
    REQUIRE(solved.status == Status::closed);
    check(solved.at.reactions[0].force, {305.786083, -97.88373443});
    check(solved.at.reactions[1].force, {-320.786083, 137.8837344});
    check(solved.at.reactions[2].force, {-20.78608297, 117.8837344});
    CHECK(solved.at.reactions[2].couple == doctest::Approx(-18.75218637).epsilon(1e-8));
  }

  TEST_CASE("structural group with an inner sliding pair") {
    const Solved solved = solve(group_with_inner_sliding_pair(), {});
    REQUIRE(solved.status == Status::closed);
    check(solved.at.reactions[0].force, {16.15607309, -55.78305755});
    check(solved.at.reactions[1].force, {18.84392691, -74.21694245});
    check(solved.at.reactions[2].force, {-41.15607309, 65.78305755});
    CHECK(solved.at.reactions[2].couple / length(solved.at.reactions[2].force) ==
          doctest::Approx(-0.004188327602).epsilon(1e-6));
  }

  TEST_CASE("crank with a group of six links, example 2: forces and driving moment") {
    const Solved solved = solve_at_rest(crank_with_six_link_group());
    REQUIRE(solved.status == Status::closed);
    CHECK(solved.at.effort[0] == doctest::Approx(21.05325475).epsilon(1e-8));
    check(solved.at.reactions[0].force, {-9.116326721, -5.263313687});
    check(solved.at.reactions[1].force, {-9.116326721, -5.263313687});
    check(solved.at.reactions[2].force, {-9.116326721, -5.263313687});
    check(solved.at.reactions[3].force, {4.60491499, -2.030431284});
    check(solved.at.reactions[4].force, {4.60491499, -2.030431284});
    check(solved.at.reactions[5].force, {-4.511411731, -7.29374497});
    check(solved.at.reactions[6].force, {-3.891166619, 3.891166619});
    check(solved.at.reactions[7].force, {-3.891166619, 3.891166619});
    check(solved.at.reactions[8].force, {8.402578351, 3.402578351});
    check(solved.at.reactions[9].force, {8.402578351, 3.402578351});
  }

  TEST_CASE("crank with a group of six links, example 5: speeds of the links by that of the crank") {
    WholeSystem system(crank_with_six_link_group());
    REQUIRE(system.assemble() == Status::closed);
    Position at = system.blank();
    const Drive drive{system.coordinate(0), 1.0, 0.0};
    REQUIRE(system.solve({&drive, 1}, at) == Status::closed);
    const double ratios[] = {1.0, -1.317548031, 0.583754718, 0.1243679229, 1.052662737, 2.105325475, 2.105325475};
    for (std::size_t k = 0; k < std::size(ratios); ++k) {
      CHECK(at.velocity[k].phi == doctest::Approx(ratios[k]).epsilon(1e-9));
    }
  }

  TEST_CASE("loader with two cylinders, example 4") {
    const Solved solved = solve_at_rest(loader());
    REQUIRE(solved.status == Status::closed);
    const auto& reactions = solved.at.reactions;
    CHECK(solved.at.effort[0] == doctest::Approx(50.31336923).epsilon(1e-9));
    CHECK(solved.at.effort[1] == doctest::Approx(-40.0).epsilon(1e-9));
    check(reactions[0].force, {50.31336923, 0.0});
    check(reactions[2].force, {50.31336923, 0.0});
    check(reactions[3].force, {-15.67235307, 40.0});
    check(reactions[4].force, {-34.64101615, -20.0});
    check(reactions[6].force, {-34.64101615, -20.0});
    check(reactions[7].force, {0.0, 20.0});
    check(reactions[8].force, {-34.64101615, 0.0});
    check(reactions[9].force, {-34.64101615, 0.0});
    check(reactions[10].force, {34.64101615, 20.0});
  }
}
