// Projects as texts, with their issues and results.
#pragma once

#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"

#include <doctest/doctest.h>

#include <string>

namespace loadpath::test {

/// A slider-crank in which only the rod has a mass.
inline const std::string press_of_heavy_rod = R"toml([press]
calculator = "mechanism.planar"
template = "slider_crank"
r = "50 mm"
l = "200 mm"
crank = { speed = "600 rpm", positions = 36 }
links.rod.mass = "1 kg"
)toml";

inline const std::string axle = "[axle]\ncalculator = \"shaft.torsion\"\n";

/// A torque that exists only once another step is solved, and is none then; with that step, behind the others.
inline const std::string no_torque = "T = \"=1 N*m/(0*relay.u_tau)\"\n";
inline const std::string relay =
    "[relay]\ncalculator = \"shaft.torsion\"\nT = \"1 N*m\"\nd = \"40 mm\"\ntau_adm = \"30 MPa\"\n";

/// A four-bar driven by a link that cannot make a full revolution: open from about 10 to 170 deg.
inline std::string bar_that_cannot_turn(int positions) {
  return R"([bar]
calculator = "mechanism.planar"
crank = { joint = "A", speed = "60 rpm", positions = )" +
         std::to_string(positions) + R"( }
[bar.ground]
A = ["0 mm", "0 mm"]
D = ["150 mm", "0 mm"]
[bar.links.a]
points = { A = ["0 mm", "0 mm"], B = ["0 mm", "-100 mm"] }
[bar.links.b]
points = { B = ["0 mm", "-100 mm"], C = ["70 mm", "-90 mm"] }
[bar.links.c]
points = { C = ["70 mm", "-90 mm"], D = ["150 mm", "0 mm"] }
[bar.joints]
A = { type = "revolute", links = ["ground", "a"] }
B = { type = "revolute", links = ["a", "b"] }
C = { type = "revolute", links = ["b", "c"] }
D = { type = "revolute", links = ["ground", "c"] }
[[bar.loads]]
link = "c"
M = "5 N*m"
)";
}

/// A slider whose guide jams when it is pushed forward: l / (2 mu) = 400 mm, and the rod pushes at 500 mm. `cylinder`:
/// of the rod.
inline std::string block_that_jams(const std::string& cylinder) {
  return R"([a]
calculator = "mechanism.planar"
ground = { O = ["0 mm", "0 mm"], R = ["0 mm", "500 mm"] }
links.block = { points = { B = ["0 mm", "0 mm"], P = ["-100 mm", "500 mm"] }, angle = "0 deg", origin = ["0 mm", "0 mm"] }
links.rod = { points = { Q = ["0 mm", "0 mm"], E = ["200 mm", "0 mm"] }, angle = "0 deg", origin = ["-300 mm", "500 mm"] }
joints.G = { type = "prismatic", links = ["block", "ground"], points = ["B", "O"], mu = 0.25, guide_length = "200 mm", guide_width = "0 mm" }
joints.rail = { type = "prismatic", links = ["rod", "ground"], points = ["Q", "R"] }
joints.push = { type = "slot", links = ["block", "rod"], points = ["P", "E"], direction = "90 deg" }
loads = [{ link = "block", at = "B", F_x = "-100 N" }]
cylinders.drive = )" +
         cylinder + "\n";
}

struct Told {
  project::Project project;
  std::vector<Issue> issues;
};

/// Read, and solved where that is allowed.
inline Told told(const std::string& text) {
  Told t;
  t.project = project::read_project(text, "a.toml", catalogue(), t.issues);
  if (!has_errors(t.issues)) project::solve(t.project, t.issues);
  return t;
}

/// All issues, as the terminal shows them.
inline std::string issues_of(const std::string& text) {
  return render(told(text).issues, [&](const std::string&) { return text; });
}

/// The first message of an error.
inline std::string first_error(const std::string& text) {
  const std::string told = issues_of(text), error = "error: ";
  const std::size_t from = told.find(error);
  return from == std::string::npos ? told
                                   : told.substr(from + error.size(), told.find('\n', from) - from - error.size());
}

/// The text with another in the place of a part that it has.
inline std::string replaced(std::string text, const std::string& part, const std::string& other) {
  const std::size_t at = text.find(part);
  INFO(part);
  REQUIRE(at != std::string::npos);
  return text.replace(at, part.size(), other);
}

inline project::Project solved(const std::string& text) {
  Told t = told(text);
  INFO(issues_of(text));
  REQUIRE(t.issues.empty());
  return std::move(t.project);
}

/// The value at a path; of a series its first.
inline double value(const project::Project& project, const std::string& path) {
  const Value* found = project.value(path);
  INFO(path);
  REQUIRE(found != nullptr);
  return found->si[0];
}

}  // namespace loadpath::test
