// Limits of the transmission angle of dyads and of the arm of the force of a guide.
#include "lib/quantity/format.hpp"
#include "lib/toml/tree.hpp"
#include "tests/lib/project/accounts.hpp"
#include "tests/lib/project/texts.hpp"

#include <algorithm>
#include <cmath>
#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string head = "[a]\ncalculator = \"mechanism.planar\"\n";

std::string rocker(const std::string& limits, const std::string& coupler = "350 mm") {
  return head + "template = \"four_bar\"\na = \"100 mm\"\nb = \"" + coupler +
         "\"\nc = \"300 mm\"\nd = \"400 mm\"\ncrank = { speed = \"60 rpm\", positions = 72 }\n" + limits;
}

/// Between bars of these lengths whose far ends are `apart`, the acute one, rad.
double between(double b, double c, double apart) {
  const double angle = std::acos((b * b + c * c - apart * apart) / (2.0 * b * c));
  return std::min(angle, pi - angle);
}

/// The dyad of text C, 4.6.2, whose force passes its pin at 156.6568841 mm.
std::string guided_dyad(const std::string& guide) {
  std::string text;
  REQUIRE(toml::read_file(std::string(LOADPATH_ROOT) + "/reference/structural-group-2.toml", text));
  text.erase(text.find("[[expect]]"));
  return replaced(text, "direction = \"10 deg\" }", "direction = \"10 deg\", " + guide + " }");
}

const account::Mode& mode_of(const account::Modes& modes, const std::string& id) {
  const auto found = std::find_if(modes.begin(), modes.end(), [&](const auto& mode) { return mode.id == id; });
  REQUIRE(found != modes.end());
  return *found;
}

}  // namespace

TEST_SUITE("mechanism limits of force transmission") {
  TEST_CASE("without a limit the transmission angle is only shown") {
    const auto project = solved(rocker(""));
    CHECK(find_verdict(project, "transmission_B") == nullptr);
    const account::Modes& modes = project.steps[0]->account().modes;
    CHECK(std::none_of(modes.begin(), modes.end(), [](const auto& mode) { return mode.id == "transmission"; }));
  }

  TEST_CASE("a four-bar: the smallest angle is where crank and frame are in line, against the limit") {
    const auto good = solved(rocker("gamma_min = \"40 deg\"\n"));
    const account::Verdict& passed = verdict_of(good, "transmission_B");
    CHECK(std::get<account::Quantity>(passed.value).si == doctest::Approx(between(0.35, 0.3, 0.3)).epsilon(1e-12));
    CHECK(passed.bound.text() == "at least 40°");
    CHECK(passed.state == account::State::pass);
    CHECK(mode_of(good.steps[0]->account().modes, "transmission").state == account::State::pass);

    const auto flat = solved(rocker("gamma_min = \"40 deg\"\n", "220 mm"));
    const account::Verdict& failed = verdict_of(flat, "transmission_B");
    const double least = between(0.22, 0.3, 0.5);
    REQUIRE(least < between(0.22, 0.3, 0.3));
    CHECK(std::get<account::Quantity>(failed.value).si == doctest::Approx(least).epsilon(1e-12));
    CHECK(failed.state == account::State::fail);
    CHECK(failed.note.text() == format_quantity(least, "deg", 4) + " at 180° (a: crank angle)");
    CHECK(mode_of(flat.steps[0]->account().modes, "transmission").state == account::State::fail);
  }

  TEST_CASE("exactly at the limit it passes") {
    const std::string least = format_exact(between(0.35, 0.3, 0.3) * 180.0 / pi) + " deg";
    CHECK(verdict_of(solved(rocker("gamma_min = \"" + least + "\"\n")), "transmission_B").state ==
          account::State::pass);
  }

  TEST_CASE("the limit of a joint replaces that of the mechanism") {
    const auto own = solved(rocker("gamma_min = \"40 deg\"\njoints.B.gamma_min = \"30 deg\"\n", "220 mm"));
    CHECK(verdict_of(own, "transmission_B").bound.text() == "at least 30°");
    const auto alone = solved(rocker("joints.B.gamma_min = \"60 deg\"\n"));
    CHECK(verdict_of(alone, "transmission_B").state == account::State::fail);
  }

  TEST_CASE("a slider-crank: arc cosine of r/l") {
    const auto project = solved(head +
                                "template = \"slider_crank\"\nr = \"50 mm\"\nl = \"200 mm\"\ngamma_min = "
                                "\"75 deg\"\ncrank = { speed = \"60 rpm\", positions = 72 }\n");
    const account::Verdict& v = verdict_of(project, "transmission_B");
    CHECK(std::get<account::Quantity>(v.value).si == doctest::Approx(std::acos(0.25)).epsilon(1e-12));
    CHECK(v.state == account::State::pass);
  }

  TEST_CASE("a limit without a transmission angle is refused") {
    CHECK(issues_of(rocker("joints.B.gamma_min = \"2 deg\"\n")).find("gamma_min") != std::string::npos);  // jams
    CHECK(issues_of(rocker("joints.A.gamma_min = \"40 deg\"\n"))
              .find("error: joint 'A' has no transmission angle: it is not the inner joint of a dyad") !=
          std::string::npos);
    CHECK(issues_of(rocker("joints.A.gamma_min = \"40 deg\"\n")).find("joints with a transmission angle: 'B'") !=
          std::string::npos);
    const std::string yoke = head +
                             "template = \"scotch_yoke\"\nr = \"25 mm\"\ngamma_min = \"40 deg\"\ncrank = { "
                             "speed = \"60 rpm\", positions = 12 }\n";
    CHECK(issues_of(yoke).find("error: no joint of the mechanism has a transmission angle") != std::string::npos);
    CHECK(issues_of(guided_dyad("gamma_min = \"100 deg\"")).find("gamma_min") != std::string::npos);
  }

  TEST_CASE("text C, 4.6.2: the arm of the force of a guide, h = 0.1566568841 m") {
    const auto far = solved(guided_dyad("guide_length = \"80 mm\", h_max = \"40 mm\""));
    const account::Verdict& v = verdict_of(far, "arm_guide");
    CHECK(std::get<account::Quantity>(v.value).si == doctest::Approx(0.1566568841).epsilon(1e-9));
    CHECK(v.bound.text() == "up to 40 mm");
    CHECK(v.state == account::State::fail);
    CHECK(v.note.text() == "1.96 of the guide length");
    CHECK(mode_of(far.steps[0]->account().modes, "jamming").state == account::State::fail);
    // (4.20): beyond half the length the edges press on opposite faces.
    CHECK(value(far, "group.joints.guide.N_front") * value(far, "group.joints.guide.N_back") < 0.0);

    const auto near = solved(guided_dyad("guide_length = \"320 mm\", h_max = \"160 mm\""));
    CHECK(verdict_of(near, "arm_guide").state == account::State::pass);
    CHECK(mode_of(near.steps[0]->account().modes, "jamming").state == account::State::pass);
    CHECK(value(near, "group.joints.guide.N_front") * value(near, "group.joints.guide.N_back") > 0.0);
    CHECK(find_verdict(solved(guided_dyad("guide_length = \"80 mm\"")), "arm_guide") == nullptr);
  }

  TEST_CASE("only a sliding pair has a guide") {
    const std::string text = replaced(guided_dyad("mu = 0"), "links = [\"link3\", \"link2\"] }",
                                      "links = [\"link3\", \"link2\"], h_max = \"40 mm\" }");
    CHECK(issues_of(text).find("error: 'h_max' belongs to prismatic joints, and 'B' is of type revolute") !=
          std::string::npos);
  }

  TEST_CASE("a guide that carries only a couple has no arm within any length") {
    // A couple on a block that is driven along its guide.
    const std::string couple = head + R"(analysis = "static"
ground.O = ["0 mm", "0 mm"]
links.block.points = { O = ["0 mm", "0 mm"] }
joints.rail = { type = "prismatic", links = ["block", "ground"], points = ["O", "O"], h_max = "1 m" }
cylinders.push = { joint = "rail", speed = "1 m/s" }
loads = [{ link = "block", M = "5 N*m" }]
)";
    const auto project = solved(couple);
    CHECK(text_of(verdict_of(project, "arm_rail").value) == "a couple without a force");
    CHECK(verdict_of(project, "arm_rail").state == account::State::fail);
  }
}
