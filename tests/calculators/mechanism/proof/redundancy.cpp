// Mechanisms in a project whose joints hold more than is needed.
#include "tests/lib/project/accounts.hpp"
#include "tests/lib/project/texts.hpp"

#include <algorithm>
#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

// Three parallel cranks of a coupler that carries a weight; E does not lie in line with A and D.
const std::string parallel = R"([bar]
calculator = "mechanism.planar"
crank = { joint = "A", to = "B", speed = "60 rpm", positions = 12 }
gravity = "9.81 m/s^2"
[bar.ground]
A = ["0 mm", "0 mm"]
D = ["150 mm", "0 mm"]
E = ["75 mm", "40 mm"]
[bar.links.a]
points = { A = ["0 mm", "0 mm"], B = ["50 mm", "100 mm"] }
[bar.links.b]
points = { B = ["50 mm", "100 mm"], C = ["200 mm", "100 mm"], F = ["125 mm", "140 mm"], S = ["0 mm", "0 mm"] }
mass = "2 kg"
J = "0 kg*m^2"
S = "S"
[bar.links.c]
points = { C = ["200 mm", "100 mm"], D = ["150 mm", "0 mm"] }
[bar.links.e]
points = { E = ["75 mm", "40 mm"], F = ["125 mm", "140 mm"] }
[bar.joints]
A = { type = "revolute", links = ["ground", "a"] }
B = { type = "revolute", links = ["a", "b"] }
C = { type = "revolute", links = ["b", "c"] }
D = { type = "revolute", links = ["ground", "c"] }
E = { type = "revolute", links = ["ground", "e"] }
F = { type = "revolute", links = ["b", "e"] }
)";

}  // namespace

TEST_SUITE("mechanism held too much in a project") {
  TEST_CASE("a unique reaction is given, a non-unique one never is") {
    const auto project = solved(parallel);
    const Value* effort = project.value("bar.drive.M");
    REQUIRE(effort != nullptr);
    // The weight's centre goes round with the radius of the cranks, at any angle of the crank.
    const double r = std::hypot(0.05, 0.1);
    for (std::size_t k = 0; k < effort->si.size(); ++k) {
      const double angle = effort->signature.axis->at[k];
      CHECK(effort->si[k] == doctest::Approx(2.0 * 9.81 * r * std::cos(angle)).epsilon(1e-9));
    }
    for (const char* path : {"bar.joints.A.F", "bar.joints.F.x", "bar.links.b.M_b"}) {
      const Value* value = project.value(path);
      CAPTURE(path);
      REQUIRE(value != nullptr);
      CHECK(std::all_of(value->si.begin(), value->si.end(), [](double x) { return std::isnan(x); }));
    }
    CHECK_FALSE(std::isnan(value(project, "bar.links.b.omega")));
  }

  TEST_CASE("a hodograph of a non-unique force is not drawn, and that is reported; the report cites why") {
    const auto project = solved(replaced(parallel, "positions = 12 }\n", "positions = 12 }\nhodographs = [\"F\"]\n"));
    const auto& account = project.steps[0]->account();
    const auto told = std::find_if(account.blocks.begin(), account.blocks.end(), [](const account::Block& block) {
      const auto* paragraph = std::get_if<account::Paragraph>(&block);
      return paragraph != nullptr && paragraph->text.text() == "No hodograph of 'F': its force is not unique.";
    });
    CHECK(told != account.blocks.end());
    CHECK(account.sources == std::vector<std::string>{"Wojtyra"});
  }

  TEST_CASE("the report states which joints share which reactions") {
    const auto project = solved(parallel);
    const account::Verdict& said = verdict_of(project, "determinate");
    CHECK(said.state == account::State::not_covered);
    CHECK(said.note.text() ==
          "the joints 'A', 'B', 'C', 'D', 'E', 'F' together constrain one degree of freedom too many: the load sharing "
          "depends on "
          "clearance and elasticity");
    for (const account::Verdict& v : project.steps[0]->account().verdicts) {
      CAPTURE(v.symbol);
      CHECK((v.state == account::State::pass || v.symbol == "determinate"));
    }
  }

  TEST_CASE("friction that depends on a shared reaction is refused") {
    const std::string b = R"(links = ["a", "b"])";
    const std::string text = replaced(parallel, b, b + ", mu = 0.1, pin_radius = \"10 mm\"");
    CHECK(issues_of(text).find("error: friction, tooth or belt forces of joint 'B' depend on its reaction, which is "
                               "not unique: other joints constrain the same freedom") != std::string::npos);
  }

  TEST_CASE("sides do not distinguish such assemblies") {
    const std::string text = replaced(parallel, "gravity =", "sides = [\"C_left\"]\ngravity =");
    CHECK(issues_of(text).find("error: assembly modes do not apply with redundant constraints") != std::string::npos);
  }
}
