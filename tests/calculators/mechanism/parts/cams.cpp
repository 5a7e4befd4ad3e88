// Cams in a project: what they come to, what is said where the follower lifts off or a profile cannot be made, and what
// is wrong with a profile.
#include "lib/draw/dxf.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/series.hpp"
#include "tests/lib/project/accounts.hpp"
#include "tests/lib/project/texts.hpp"

#include <algorithm>
#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string valve = R"([valve]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "300 rpm", positions = 360 }
gravity = "9.81 m/s^2"

[valve.ground]
O = ["0 mm", "0 mm"]
T = ["0 mm", "160 mm"]

[valve.links.cam]
points = { O = ["0 mm", "0 mm"] }
angle = "0 deg"

[valve.links.follower]
points = { B = ["0 mm", "0 mm"], H = ["0 mm", "60 mm"] }
origin = ["0 mm", "39 mm"]
angle = "0 deg"
mass = "0.8 kg"

[valve.profiles.lobe]
shape = "sliding"
base = "30 mm"
roller = "10 mm"
segments = [
  { law = "cycloidal", angle = "90 deg", lift = "12 mm" },
  { angle = "40 deg" },
  { law = "3-4-5", angle = "110 deg", lift = "-12 mm" },
  { angle = "120 deg" },
]

[valve.joints]
O = { type = "revolute", links = ["ground", "cam"] }
contact = { type = "cam", links = ["follower", "cam"], points = ["B", "O"], profile = "lobe", direction = "90 deg" }
guide = { type = "prismatic", links = ["follower", "ground"], points = ["H", "O"], direction = "90 deg" }

[valve.springs.spring]
links = ["follower", "ground"]
points = ["H", "T"]
k = "8 N/mm"
free = "75 mm"
)";

/// A flat face that swings about P: pivot 80 mm from the axis, on the left.
const std::string rocker = R"([rocker]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "300 rpm", positions = 360 }
[rocker.ground]
O = ["0 mm", "0 mm"]
P = ["80 mm", "0 mm"]
[rocker.links.cam]
points = { O = ["0 mm", "0 mm"] }
angle = "0 deg"
[rocker.links.arm]
points = { P = ["0 mm", "0 mm"], E = ["90 mm", "0 mm"] }
angle = "158 deg"
[rocker.profiles.lobe]
shape = "swinging_flat"
base = "30 mm"
pivot = "80 mm"
segments = [
  { law = "3-4-5", angle = "100 deg", swing = "15 deg" },
  { angle = "20 deg" },
  { law = "3-4-5", angle = "140 deg", swing = "-15 deg" },
  { angle = "100 deg" },
]
[rocker.joints]
O = { type = "revolute", links = ["ground", "cam"] }
P = { type = "revolute", links = ["ground", "arm"] }
contact = { type = "cam_flat", links = ["arm", "cam"], points = ["P", "O"], profile = "lobe" }
[[rocker.loads]]
link = "arm"
at = "E"
F_x = "0 N"
F_y = "-200 N"
)";

std::string changed(const std::string& part, const std::string& other) { return replaced(valve, part, other); }

/// A rise so steep that the profile is hollow at its foot.
std::string hollow_valve() {
  return replaced(changed("\"90 deg\", lift", "\"60 deg\", lift"), "\"40 deg\"", "\"70 deg\"");
}

/// Message on the valve when a part of it is replaced, after its place.
std::string said(const std::string& part, const std::string& other) {
  const auto issues = told(changed(part, other)).issues;
  REQUIRE(issues.size() == 1);
  return issues[0].key + ": " + issues[0].message.text();
}

account::State state_of(const project::Project& project, const std::string& symbol) {
  const auto* verdict = find_verdict(project, symbol);
  REQUIRE(verdict != nullptr);
  return verdict->state;
}

constexpr double degree = 3.14159265358979323846 / 180.0;

}  // namespace

TEST_SUITE("mechanism cams") {
  TEST_CASE("a valve: lift, pressure angle and contact force by hand") {
    const auto project = solved(valve);
    const auto& step = *project.steps[0];
    CHECK(account::worst(step.account().verdicts) == account::State::pass);
    CHECK(maximum(*step.value("points.B.y")).value == doctest::Approx(0.052).epsilon(1e-12));
    // tan alpha = s' / (s + 40 mm), largest at 42.610 deg of the rise.
    const Extreme alpha = maximum(*step.value("joints.contact.alpha"));
    CHECK(alpha.value == doctest::Approx(18.493355 * degree).epsilon(1e-5));
    CHECK(alpha.at == doctest::Approx(42.610 * degree).epsilon(1e-3));
    // On the base circle the spring, 15 mm shorter, and the weight.
    CHECK(minimum(*step.value("joints.contact.N")).value == doctest::Approx(8.0 * 15.0 + 0.8 * 9.81).epsilon(1e-9));
    CHECK(find_verdict(project, "hollow_contact") == nullptr);
  }

  // 894.58 rpm from m s'' omega^2 = spring and weight, over both segments.
  TEST_CASE("above a certain speed the follower lifts off, but not out of a groove") {
    CHECK(state_of(solved(changed("300 rpm", "890 rpm")), "contact_contact") == account::State::pass);
    const auto fast = solved(changed("300 rpm", "900 rpm"));
    CHECK(state_of(fast, "contact_contact") == account::State::fail);
    CHECK(find_verdict(fast, "contact_contact")->note.text().starts_with("lifts off between "));
    const std::string groove = changed("profile = \"lobe\"", "holding = \"groove\", profile = \"lobe\"");
    CHECK(find_verdict(solved(replaced(groove, "300 rpm", "900 rpm")), "contact_contact") == nullptr);
  }

  TEST_CASE("an undercut profile and a roller too large for a hollow fail, with the cam angle") {
    const auto undercut =
        solved(changed("base = \"30 mm\"\nroller = \"10 mm\"", "base = \"4 mm\"\nroller = \"28 mm\""));
    CHECK(state_of(undercut, "profile_contact") == account::State::fail);
    CHECK(find_verdict(undercut, "profile_contact")->note.text().starts_with("undercut at a cam angle of 6"));
    const auto hollow = solved(hollow_valve());
    CHECK(state_of(hollow, "hollow_contact") == account::State::pass);
    const auto issues = told(replaced(hollow_valve(), "profile = ", "radius = \"150 mm\", profile = ")).issues;
    REQUIRE(issues.size() == 1);
    CHECK(issues[0].key == "valve.joints.contact.radius");
    CHECK(issues[0].message.text().ends_with("and the roller of 150 mm does not reach into it"));
  }

  TEST_CASE("errors in a cam are reported at their place") {
    CHECK(said("profile = \"lobe\"", "profile = \"lob\"") == "valve.joints.contact.profile: unknown profile 'lob'");
    CHECK(said("profile = \"lobe\", ", "") == "valve.joints.contact: joint 'contact' of type cam needs 'profile'");
    CHECK(said("direction = \"90 deg\" }\ng", "direction = \"90 deg\", mu = 0.1 }\ng") ==
          "valve.joints.contact.mu: the roller of joint 'contact' rolls on its cam, and does not rub");
    CHECK(said("\"O\"], direction", "\"O\"], holding = \"groove\", direction") ==
          "valve.joints.guide.holding: 'holding' belongs to cams, and 'guide' is of type prismatic");
  }

  TEST_CASE("errors in a profile are reported at their place") {
    CHECK(said("law = \"cycloidal\"", "law = \"constant_velocity\"") ==
          "valve.profiles.lobe.segments[1].law: at the ends of a segment with constant velocity the acceleration is "
          "infinite");
    CHECK(said("angle = \"40 deg\"", "angle = \"40 deg\", lift = \"1 mm\"") ==
          "valve.profiles.lobe.segments[2]: a dwell has no 'lift'");
    CHECK(said(", lift = \"-12 mm\"", "") == "valve.profiles.lobe.segments[3]: segment 3 needs 'lift'");
    CHECK(said("lift = \"12 mm\"", "swing = \"12 deg\"") ==
          "valve.profiles.lobe.segments[1].swing: a profile of shape sliding is defined by 'lift'");
    CHECK(said("angle = \"40 deg\"", "angle = \"50 deg\"") ==
          "valve.profiles.lobe.segments: the segments cover 370° of the cam, and must cover a full revolution");
    CHECK(said("\"-12 mm\"", "\"-10 mm\"") ==
          "valve.profiles.lobe.segments: after a revolution the follower is 2 mm away from its initial position");
    CHECK(said("base = \"30 mm\"", "offset = \"45 mm\"\nbase = \"30 mm\"") ==
          "valve.profiles.lobe.offset: the guide passes the cam at 45 mm, and base circle and roller reach 40 mm");
    CHECK(said("base = \"30 mm\"\n", "") == "valve.profiles.lobe: profile 'lobe' of the shape sliding needs base");
    CHECK(said("base = \"30 mm\"", "arm = \"60 mm\"\nbase = \"30 mm\"") ==
          "valve.profiles.lobe.arm: a profile of the shape sliding takes no 'arm'");
  }

  // base angle asin(30 mm / 80 mm) = 22.0243 deg; 3-4-5: half the swing at half the angle.
  TEST_CASE("a rocker with a flat face swings by the law of its profile") {
    const auto project = solved(rocker);
    CHECK(account::worst(project.steps[0]->account().verdicts) == account::State::pass);
    // The bends of the envelope, by differences of neighbouring faces: least at 163.5 deg.
    CHECK(std::get<account::Quantity>(verdict_of(project, "profile_contact").value).si ==
          doctest::Approx(0.02107).epsilon(5e-4));
    const auto& phi = entry_of(project, "links.arm.phi").value;
    const double base = pi - std::asin(30.0 / 80.0);
    CHECK(phi.si[0] == doctest::Approx(base).epsilon(1e-12));
    CHECK(phi.si[50] == doctest::Approx(base - 7.5 * degree).epsilon(1e-12));
    CHECK(phi.si[110] == doctest::Approx(base - 15.0 * degree).epsilon(1e-12));
    CHECK(project.steps[0]->account().sources == std::vector<std::string>{"Trajectories"});
    for (const char* law : {"modified_sine", "modified_trapezoid"}) {
      const auto other =
          solved(replaced(rocker, "\"3-4-5\", angle = \"100", "\"" + std::string(law) + "\", angle = \"100"));
      CHECK(entry_of(other, "links.arm.phi").value.si[50] == doctest::Approx(base - 7.5 * degree).epsilon(1e-12));
      CHECK(other.steps[0]->account().sources.size() == 2);
    }
  }

  TEST_CASE("a swinging face: undercut, and profiles that are not possible") {
    CHECK(state_of(solved(replaced(rocker, "base = \"30 mm\"", "base = \"5 mm\"")), "profile_contact") ==
          account::State::fail);
    const auto said_of = [](const std::string& text) {
      const auto issues = told(text).issues;
      REQUIRE(issues.size() == 1);
      return issues[0].key + ": " + issues[0].message.text();
    };
    CHECK(said_of(replaced(rocker, "pivot = \"80 mm\"", "pivot = \"25 mm\"")) ==
          "rocker.profiles.lobe.pivot: the pivot is 25 mm from the cam's axis, and a face that touches the base circle "
          "passes that axis at 30 mm more than it passes the pivot");
    CHECK(said_of(replaced(rocker, "pivot = \"80 mm\"\n", "")) ==
          "rocker.profiles.lobe: profile 'lobe' of the shape swinging_flat needs pivot");
    CHECK(said_of(replaced(rocker, "pivot = \"80 mm\"", "pivot = \"80 mm\"\narm = \"70 mm\"")) ==
          "rocker.profiles.lobe.arm: a profile of the shape swinging_flat takes no 'arm'");
    const std::string wide = replaced(replaced(rocker, "\"15 deg\"", "\"70 deg\""), "\"-15 deg\"", "\"-70 deg\"");
    CHECK(said_of(wide) ==
          "rocker.profiles.lobe.segments: the face swings to 92.024° from the line between its pivot and the cam's "
          "axis, and touches the cam up to 90°");
    const std::string fast = replaced(replaced(rocker, "\"15 deg\"", "\"40 deg\""),
                                      "\"140 deg\", swing = \"-15 deg\" },\n  { angle = \"100 deg\"",
                                      "\"60 deg\", swing = \"-40 deg\" },\n  { angle = \"180 deg\"");
    CHECK(said_of(fast).starts_with("rocker.profiles.lobe.segments: at a cam angle of "));
    CHECK(said_of(fast).ends_with("° the face swings as fast as the cam turns, or faster, and no profile touches it"));
  }

  TEST_CASE("an error in a template's cam is reported under the parameter") {
    const std::string arm =
        "[a]\ncalculator = \"mechanism.planar\"\ntemplate = \"cam_arm\"\nbase = \"30 mm\"\nroller = \"8 mm\"\n"
        "pivot = \"80 mm\"\narm = \"70 mm\"\ncrank = { speed = \"60 rpm\" }\nsegments = [{ law = \"3-4-5\", angle = "
        "\"180 deg\", swing = \"15 deg\" }, { law = \"3-4-5\", angle = \"180 deg\", swing = \"-15 deg\" }]\n";
    CHECK(told(arm).issues.empty());
    const auto far = told(replaced(arm, "\"80 mm\"", "\"180 mm\"")).issues;
    REQUIRE(far.size() == 1);
    CHECK(far[0].key == "a.arm");
    const auto open = told(replaced(arm, "\"-15 deg\"", "\"-14 deg\"")).issues;
    REQUIRE(open.size() == 1);
    CHECK(open[0].key == "a.segments");
    CHECK(open[0].message.text() == "after a revolution the follower is 1° away from its initial position");
  }

  TEST_CASE("a drawing for other programs has the profile on a layer of its own") {
    figure::Scheme scheme;
    scheme.bodies.push_back({"cam", {{0.0, 0.0}, {0.04, 0.0}}});
    CHECK(draw::dxf_of(scheme).find("cams") == std::string::npos);
    scheme.outlines.push_back({{0.0, 0.0}, {{0.03, 0.0}, {0.0, 0.03}, {-0.03, 0.0}}});
    const std::string dxf = draw::dxf_of(scheme);
    std::size_t lines = 0;
    for (std::size_t at = dxf.find("LINE\n8\ncams\n"); at != std::string::npos;
         at = dxf.find("LINE\n8\ncams\n", at + 1))
      ++lines;
    CHECK(lines == 3);
    CHECK(dxf.find("10\n30\n20\n0\n") != std::string::npos);
  }

  TEST_CASE("a flat face does not fit a hollow profile") {
    const std::string text = replaced(hollow_valve(), "type = \"cam\"", "type = \"cam_flat\"");
    const auto issues = told(text).issues;
    REQUIRE(issues.size() == 1);
    CHECK(issues[0].message.text().starts_with("the profile 'lobe' is hollow at a cam angle of "));
  }
}
