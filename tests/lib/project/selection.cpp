#include "lib/project/selection.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace loadpath;

namespace {

std::string steps_of(const std::string& text, const char* calculator) {
  std::vector<Issue> issues;
  const toml::Tree part = project::part_for(toml::read_toml(text, "a.toml", issues), calculator);
  REQUIRE(issues.empty());
  std::string names;
  for (const auto& entry : part.entries) names += (names.empty() ? "" : " ") + entry.key;
  return names;
}

const std::string text = R"toml([project]
title = "x"
[shaft_a]
calculator = "shaft.torsion"
T = "=peak(press.drive.M)"
[press]
calculator = "mechanism.planar"
r = "=sized.d / 2"
links = { rod = { points = [["=arm.l", "0 mm"]] } }
[sized]
calculator = "shaft.overhung"
T = "=other.T"
[other]
calculator = "no.such"
[arm]
l = "3 mm"
[[expect]]
value = "press.drive.M"
)toml";

}  // namespace

TEST_SUITE("part of a project") {
  TEST_CASE("the steps of a calculator are selected with all that they refer to, in the order of the file") {
    CHECK(steps_of(text, "mechanism.planar") == "project press sized other arm");
    CHECK(steps_of(text, "shaft.torsion") == "project shaft_a press sized other arm");
    CHECK(steps_of(text, "shaft.overhung") == "project sized other");
  }

  TEST_CASE("where no step runs the calculator nothing is left") { CHECK(steps_of(text, "gear.spur").empty()); }

  TEST_CASE("steps that refer to one another in a circle end it") {
    CHECK(steps_of("[a]\ncalculator = \"x\"\nT = \"=b.T\"\n[b]\nT = \"=a.T\"\n", "x") == "a b");
  }

  TEST_CASE("a text that is not an expression refers to nothing") {
    CHECK(steps_of("[a]\ncalculator = \"x\"\nT = \"=b.(T\"\n[b]\nT = 3\n", "x") == "a");
  }
}
