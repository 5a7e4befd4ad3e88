// Internal forces of links: bars by hand, and invariants of every link.
#include "lib/mechanism/studies/member.hpp"

#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;

MemberLoads loads_of(const Model& model, std::size_t link, const Position& at, MassLine mass = MassLine::lumped) {
  Member member = member_of(model, link);
  member.mass = mass;
  MemberLoads loads(model, member);
  loads.take(at, false);
  return loads;
}

/// A beam of 2 m on a pin and a slide, 12 kg.
Model beam() {
  Model model;
  model.gravity = {0.0, -10.0};
  const int bar = add_bar(model, "beam", {}, 2.0, 12.0);
  pin(model, "A", bar, {}, ground, {});
  slot(model, "B", bar, {2.0, 0.0}, ground, {2.0, 0.0});
  return model;
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("a simple beam: its own weight and a load in the middle") {
    Model model = beam();
    const Solved own = solve_at_rest(model);
    REQUIRE(own.status == Status::closed);
    const auto uniform = loads_of(model, 0, own.at, MassLine::uniform).peaks();
    CHECK(uniform.M.M == doctest::Approx(120.0 * 2.0 / 8.0));
    CHECK(uniform.M.x == doctest::Approx(1.0));
    CHECK(std::abs(uniform.V.V) == doctest::Approx(60.0));
    load(model, "P", 0, {0.5, 0.0}, {300.0, -400.0});
    const auto lumped = loads_of(model, 0, solve_at_rest(model).at).peaks();
    CHECK(lumped.M.M == doctest::Approx(0.5 * (300.0 + 60.0)));
    CHECK(lumped.M.x == doctest::Approx(0.5));
    CHECK(lumped.N.N == doctest::Approx(300.0));
  }

  TEST_CASE("a bar that rotates about its end is stretched by m omega^2 l / 2") {
    Model model;
    const int bar = add_bar(model, "bar", {}, 0.8, 3.0);
    pin(model, "O", bar, {}, ground, {});
    pin(model, "tip", add_link(model, "knob", {0.8, 0.0, 0.0}), {}, bar, {0.8, 0.0});
    drive_turning(model, "motor", bar);
    slide(model, "guide", 1, {}, bar, {0.8, 0.0});
    model.joints.erase(model.joints.begin() + 1);
    drive_sliding(model, "hold", 1);
    const Solved solved = solve(model, {{0.4, 20.0, 0.0}, {0.0, 0.0, 0.0}});
    REQUIRE(solved.status == Status::closed);
    const auto peaks = loads_of(model, 0, solved.at, MassLine::uniform).peaks();
    CHECK(peaks.N.N == doctest::Approx(3.0 * 400.0 * 0.4).epsilon(1e-12));
    CHECK(peaks.N.x == doctest::Approx(0.0));
    CHECK(std::abs(peaks.M.M) <= 1e-9);
  }

  TEST_CASE("every link: the diagrams close at the end, whatever its mass distribution") {
    for (const Model& model : {slider_crank(), four_bar(), six_bar(), slotted_lever(), class_three()}) {
      const Solved solved = solve(model, {{1.1, 60.0, 300.0}});
      REQUIRE(solved.status == Status::closed);
      for (std::size_t k = 0; k < model.links.size(); ++k) {
        CAPTURE(model.links[k].name);
        Member member = member_of(model, k);
        if (member.length() == 0.0) continue;
        for (const MassLine mass : {MassLine::lumped, MassLine::uniform}) {
          const MemberLoads loads = loads_of(model, k, solved.at, mass);
          const auto peaks = loads.peaks();
          const double size = 1.0 + std::abs(peaks.N.N) + std::abs(peaks.V.V);
          const SectionForces& left_over = loads.stations().back();
          CHECK(std::abs(left_over.N) <= 1e-11 * size);
          CHECK(std::abs(left_over.V) <= 1e-11 * size);
          CHECK(std::abs(left_over.M) <= 1e-11 * size);
          for (int s = 0; s <= 50; ++s) {
            const SectionForces here = loads.at(member.length() * s / 50.0);
            CHECK(std::abs(here.M) <= std::abs(peaks.M.M) * (1.0 + 1e-9) + 1e-9);
            CHECK(std::abs(here.N) <= std::abs(peaks.N.N) * (1.0 + 1e-9) + 1e-9);
          }
        }
      }
    }
  }

  TEST_CASE("a massless bar between two pins carries only an axial force") {
    Model model = four_bar();
    model.links[1].mass = model.links[1].inertia = 0.0;
    const Solved solved = solve(model, {{0.7, 20.0, 0.0}});
    const auto peaks = loads_of(model, 1, solved.at).peaks();
    CHECK(std::abs(peaks.N.N) == doctest::Approx(length(solved.at.reactions[1].force)).epsilon(1e-12));
    CHECK(std::abs(peaks.M.M) <= 1e-9);
    CHECK(is_uniform(model, member_of(model, 0)));
    CHECK_FALSE(is_uniform(slotted_lever(), member_of(slotted_lever(), 1)));
  }
}
