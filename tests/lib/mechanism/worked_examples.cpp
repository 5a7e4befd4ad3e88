// Worked examples of four texts on machine theory, at the digits that follow from their data.
#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

constexpr double degree = std::numbers::pi / 180.0;

void check(Vec mine, Vec exact) {
  CAPTURE(exact.x);
  CAPTURE(exact.y);
  CHECK(length(mine - exact) <= 2e-9 * length(exact));
}

Pose between(Vec from, Vec to) { return {from.x, from.y, std::atan2(to.y - from.y, to.x - from.x)}; }
double distance(Vec a, Vec b) { return length(b - a); }

// The point of the link whose frame is at `pose` where `global` is now.
Vec on(const Pose& pose, Vec global) { return turn(-pose.phi)(global - Vec{pose.x, pose.y}); }

int bar_between(Model& model, const char* name, Vec from, Vec to) { return add_link(model, name, between(from, to)); }

// Joint of two links at a global point of the stated assembly.
void pin_at(Model& model, const char* name, int i, int j, Vec at) {
  const auto local = [&](int link) {
    return link == ground ? at : on(model.links[static_cast<std::size_t>(link)].pose, at);
  };
  pin(model, name, i, local(i), j, local(j));
}

void load_at(Model& model, const char* name, int link, Vec at, Vec force, double moment = 0.0) {
  load(model, name, link, on(model.links[static_cast<std::size_t>(link)].pose, at), force, moment);
}

// Crank OA and the group of the links 2 to 7; a couple of -10 N m on link 7.
Model crank_with_six_link_group() {
  const Vec o{0.0, 0.0}, h{6.0, 0.0}, e{2.0, 6.0}, g{6.0, 6.0};
  const Vec a{4.0 * std::cos(60.0 * degree), 4.0 * std::sin(60.0 * degree)};
  const Vec b = a + Vec{2.0 * std::cos(30.0 * degree), 2.0 * std::sin(30.0 * degree)};
  const Vec i{b.x, 1.0}, c{b.x, 8.0}, d{0.0, 8.0}, f{8.0, 8.0};
  Model model;
  const int crank = bar_between(model, "1", o, a);
  const int second = bar_between(model, "2", a, b);
  const int third = bar_between(model, "3", i, c);
  const int fourth = bar_between(model, "4", h, i);
  const int fifth = bar_between(model, "5", d, f);
  const int sixth = bar_between(model, "6", e, d);
  const int seventh = bar_between(model, "7", g, f);
  pin_at(model, "O", crank, ground, o);
  pin_at(model, "A", second, crank, a);
  pin_at(model, "B", third, second, b);
  pin_at(model, "I", third, fourth, i);
  pin_at(model, "H", fourth, ground, h);
  pin_at(model, "C", fifth, third, c);
  pin_at(model, "D", fifth, sixth, d);
  pin_at(model, "E", sixth, ground, e);
  pin_at(model, "F", fifth, seventh, f);
  pin_at(model, "G", seventh, ground, g);
  drive_turning(model, "Q", crank);
  load(model, "M", seventh, {}, {}, -10.0);
  return model;
}

// Cylinder 1 with rod 2 lifts the arm 3 about B; cylinder 4 with rod 5 turns the bucket 8 by the lever 6 and the bar 7.
Model loader() {
  const double root3 = std::sqrt(3.0);
  const Vec o{0.0, 0.0}, a{0.8 * root3, 0.0}, b{0.8 * root3, 1.2}, g{2.0 * root3, 2.0}, h{2.0 * root3, 1.2};
  const Vec f{g.x - 1.6, 2.0};
  const Vec e = f + (0.8 / std::sin(60.0 * degree)) * Vec{0.5, -0.5 * root3};
  const Vec d = e + 0.4 * root3 * Vec{-0.5, 0.5 * root3};
  const Vec c{0.0, d.y - d.x / root3};
  const Vec m{2.8 * root3, 2.0};
  Model model;
  const int first = bar_between(model, "1", o, a);
  const int second = bar_between(model, "2", o, a);
  const int third = add_link(model, "3", {b.x, b.y, 0.0});
  const int fourth = bar_between(model, "4", c, d);
  const int fifth = bar_between(model, "5", c, d);
  const int sixth = bar_between(model, "6", e, d);
  const int seventh = bar_between(model, "7", f, g);
  const int eighth = bar_between(model, "8", h, g);
  pin_at(model, "O", first, ground, o);
  slide(model, "cylinder 1", second, {distance(o, a), 0.0}, first, {});
  pin_at(model, "A", third, second, a);
  pin_at(model, "B", third, ground, b);
  pin_at(model, "C", fourth, ground, c);
  slide(model, "cylinder 2", fifth, {distance(c, d), 0.0}, fourth, {});
  pin_at(model, "D", sixth, fifth, d);
  pin_at(model, "E", sixth, third, e);
  pin_at(model, "F", seventh, sixth, f);
  pin_at(model, "G", eighth, seventh, g);
  pin_at(model, "H", eighth, third, h);
  drive_sliding(model, "Q1", 1);
  drive_sliding(model, "Q2", 5);
  load_at(model, "P", eighth, m, {0.0, -20.0});
  return model;
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

  TEST_CASE("crank and slotted lever, example 10.1: over a turn") {
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

  TEST_CASE("crank and slotted lever, example 10.1: the work per turn is zero, the peak is in the return stroke") {
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

  TEST_CASE("crank and slotted lever, example 10.1: a load in the working stroke only pays 19.575 J per turn") {
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
    Model model;
    const Vec a{0.1, 0.05}, b{0.42, 0.31}, c{0.8, -0.04};
    const int second = bar_between(model, "2", a, b);
    const int third = bar_between(model, "3", c, b);
    pin_at(model, "A", second, ground, a);
    pin_at(model, "B", second, third, b);
    pin_at(model, "C", third, ground, c);
    load_at(model, "F2", second, {0.25, 0.2}, {30.0, -120.0}, 4.0);
    load_at(model, "F3", third, {0.6, 0.16}, {-200.0, -55.0}, -7.5);
    const Solved solved = solve(model, {});
    REQUIRE(solved.status == Status::closed);
    check(solved.at.reactions[0].force, {69.38330171, 142.9364326});
    check(solved.at.reactions[1].force, {-99.38330171, -22.93643264});
    check(solved.at.reactions[2].force, {100.6166983, 32.06356736});
  }

  TEST_CASE("structural group with an outer sliding pair") {
    Model model;
    const Vec a{0.06, 0.08}, b{0.33, -0.02};
    const int second = bar_between(model, "2", a, b);
    const int third = add_link(model, "3", {b.x, b.y, 10.0 * degree});
    pin_at(model, "A", second, ground, a);
    pin_at(model, "B", second, third, b);
    slide(model, "guide", third, {}, ground, b, 10.0 * degree, 10.0 * degree);
    load_at(model, "F2", second, {0.17, 0.05}, {15.0, -40.0}, -1.2);
    load_at(model, "F3", third, {0.3508618237, 0.03444983298}, {-300.0, 20.0}, 2.0);
    const Solved solved = solve(model, {});
    REQUIRE(solved.status == Status::closed);
    check(solved.at.reactions[0].force, {305.786083, -97.88373443});
    check(solved.at.reactions[1].force, {-320.786083, 137.8837344});
    check(solved.at.reactions[2].force, {-20.78608297, 117.8837344});
    CHECK(solved.at.reactions[2].couple == doctest::Approx(-18.75218637).epsilon(1e-8));
  }

  TEST_CASE("structural group with an inner sliding pair") {
    Model model;
    const Vec a{0.25, 0.18};
    const double guide = 0.5590546111;
    const int second = add_link(model, "2", {a.x, a.y, guide});
    const int third = add_link(model, "3", {0.0, 0.0, guide});
    pin_at(model, "A", second, ground, a);
    pin(model, "C", third, {}, ground, {});
    slide(model, "slide", second, {}, third, on(model.links[1].pose, a));
    load_at(model, "F2", second, {0.26, 0.195}, {25.0, -10.0}, 0.8);
    load_at(model, "F3", third, {0.1123385287, 0.04669105881}, {-60.0, 140.0}, 5.0);
    const Solved solved = solve(model, {});
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

  TEST_CASE("crank with a group of six links, example 5: speeds of the links by the crank's") {
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
