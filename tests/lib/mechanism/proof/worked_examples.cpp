// The worked examples of three texts by every method of the proof, at the digits that follow from their data.
#include "tests/lib/mechanism/proof/methods.hpp"
#include "tests/lib/mechanism/worked_models.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

void check_efforts(const Model& model, const Position& at, const std::vector<double>& exact) {
  for (std::size_t k = 0; k < exact.size(); ++k) {
    for (const EffortBy& by : efforts_by_every_method(model, at, k)) {
      CAPTURE(by.method);
      CHECK(by.effort == doctest::Approx(exact[k]).epsilon(2e-9));
    }
  }
}

using Reactions = std::map<std::string, Vec>;  // by joint

void check_reactions(const Model& model, const Position& at, const Reactions& exact) {
  for (const FoundBy& by : forces_by_every_method(model, at)) {
    CAPTURE(by.method);
    for (std::size_t k = 0; k < model.joints.size(); ++k) {
      const auto known = exact.find(model.joints[k].name);
      if (known == exact.end()) continue;
      CAPTURE(known->first);
      CHECK(length(by.forces.reactions[k].force - known->second) <= 2e-9 * length(known->second));
    }
  }
}

Position position_of(const Solved& solved) {
  REQUIRE(solved.status == Status::closed);
  return solved.at;
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("text A, example 10.1, by every method") {
    for (const bool with_slider : {false, true}) {
      const Model model = slotted_lever(with_slider);
      const Position at = position_of(solve(model, {{-60.0 * degree, 45.0, 0.0}}));
      check_efforts(model, at, {15.14111441});
      const Vec on_slider{174.8345296, 706.5853391};
      check_reactions(model, at, {{"B", {212.55443, 176.7560397}}, {"A", with_slider ? on_slider : -on_slider}});
    }
  }

  TEST_CASE("text A, example 10.1: the driving moment over a revolution by every method") {
    const struct {
      double crank_deg, moment;
    } rows[] = {{-45.0, 13.75554497},  {0.0, 7.2},          {90.0, -6.8643}, {150.0, 60.65372005}, {180.0, -14.4},
                {210.0, -79.81527509}, {285.0, 15.27211539}};
    const Model model = slotted_lever();
    for (const auto& row : rows) {
      CAPTURE(row.crank_deg);
      check_efforts(model, position_of(solve(model, {{row.crank_deg * degree, 45.0, 0.0}})), {row.moment});
    }
  }

  TEST_CASE("text C, structural groups of the second class, by every method") {
    const struct {
      Model model;
      Reactions reactions;
    } groups[] = {
        {group_with_three_turning_pairs(),
         {{"A", {69.38330171, 142.9364326}}, {"B", {-99.38330171, -22.93643264}}, {"C", {100.6166983, 32.06356736}}}},
        {group_with_outer_sliding_pair(),
         {{"A", {305.786083, -97.88373443}},
          {"B", {-320.786083, 137.8837344}},
          {"guide", {-20.78608297, 117.8837344}}}},
        {group_with_inner_sliding_pair(),
         {{"A", {16.15607309, -55.78305755}},
          {"C", {18.84392691, -74.21694245}},
          {"slide", {-41.15607309, 65.78305755}}}}};
    for (const auto& group : groups) check_reactions(group.model, position_of(solve(group.model, {})), group.reactions);
  }

  TEST_CASE("text C, the couple in the guide of a structural group, by every method") {
    const Model model = group_with_outer_sliding_pair();
    for (const FoundBy& by : forces_by_every_method(model, position_of(solve(model, {})))) {
      CAPTURE(by.method);
      CHECK(by.forces.reactions[2].couple == doctest::Approx(-18.75218637).epsilon(1e-8));
    }
  }

  TEST_CASE("text C, 4.6.4: an initial link driven through a coupling, by every method") {
    Model model;
    const int crank = add_link(model, "crank", {0.0, 0.0, 0.0});
    pin(model, "O", crank, {}, ground, {});
    drive_turning(model, "coupling", crank);
    load(model, "R21", crank, {0.02267980607, 0.044560368}, {180.0, -420.0});
    const Position at = position_of(solve_at_rest(model));
    check_efforts(model, at, {17.54638479});
    check_reactions(model, at, {{"O", {-180.0, 420.0}}});
  }

  TEST_CASE("text C, 4.7: Zhukovsky's lever of a slider-crank, and every other method") {
    Model model;
    const double crank_angle = 50.0 * degree, r = 0.12, l = 0.45;
    const Vec a = r * Vec{std::cos(crank_angle), std::sin(crank_angle)};
    const Vec b{a.x + std::sqrt(l * l - a.y * a.y), 0.0};
    const int crank = bar_between(model, "1", {}, a);
    const int rod = bar_between(model, "2", a, b);
    const int slider = add_link(model, "3", {b.x, 0.0, 0.0});
    pin_at(model, "O", crank, ground, {});
    pin_at(model, "A", rod, crank, a);
    pin_at(model, "B", slider, rod, b);
    slide(model, "guide", slider, {}, ground, {});
    drive_turning(model, "M", crank);
    load(model, "2", rod, {0.2, 0.0}, {20.0, -90.0}, 6.0);
    load(model, "3", slider, {}, {-650.0, -30.0});
    check_efforts(model, position_of(solve_at_rest(model)), {-63.32516895});
  }

  TEST_CASE("text D, examples 2, 3 and 5, by every method") {
    const Model model = crank_with_six_link_group();
    const Position at = position_of(solve_at_rest(model));
    check_efforts(model, at, {21.05325475});
    check_reactions(model, at,
                    {{"O", {-9.116326721, -5.263313687}},
                     {"H", {4.60491499, -2.030431284}},
                     {"C", {-4.511411731, -7.29374497}},
                     {"E", {-3.891166619, 3.891166619}},
                     {"G", {8.402578351, 3.402578351}}});
  }

  TEST_CASE("text D, example 4, two cylinders, by every method") {
    const Model model = loader();
    const Position at = position_of(solve_at_rest(model));
    check_efforts(model, at, {50.31336923, -40.0});
    check_reactions(model, at,
                    {{"O", {50.31336923, 0.0}},
                     {"B", {-15.67235307, 40.0}},
                     {"D", {-34.64101615, -20.0}},
                     {"E", {0.0, 20.0}},
                     {"G", {-34.64101615, 0.0}},
                     {"H", {34.64101615, 20.0}}});
  }
}
