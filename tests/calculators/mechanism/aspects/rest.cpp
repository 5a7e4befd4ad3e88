// Friction at rest, self-locking, losses and loaded flanks as a project gives them.
#include "calculators/mechanism/cycle/ranges.hpp"
#include "lib/quantity/series.hpp"
#include "tests/lib/project/accounts.hpp"
#include "tests/lib/project/texts.hpp"

#include <algorithm>
#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// A block of 1 kN on a plane that rises by `angle`, pushed up by a cylinder.
std::string plane(const std::string& angle, const std::string& drive) {
  return R"([a]
calculator = "mechanism.planar"
analysis = "static"
ground = { O = ["0 mm", "0 mm"] }
links.block = { points = { B = ["0 mm", "0 mm"] }, angle = ")" +
         angle + R"(", origin = ["0 mm", "0 mm"] }
joints.G = { type = "prismatic", links = ["block", "ground"], points = ["B", "O"], direction = ")" +
         angle + R"(", mu = 0.3, guide_length = "100 mm", guide_width = "0 mm" }
cylinders.push = { joint = "G")" +
         drive + R"( }
[[a.loads]]
link = "block"
at = "B"
F_y = "-1 kN"
)";
}

const std::string gears = R"([a]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "60 rpm", positions = 72 }
ground = { O = ["0 mm", "0 mm"], C = ["60 mm", "0 mm"] }
links.pinion = { points = { O = ["0 mm", "0 mm"] }, angle = "0 deg" }
links.wheel = { points = { C = ["0 mm", "0 mm"] }, angle = "0 deg" }
joints.O = { type = "revolute", links = ["ground", "pinion"] }
joints.C = { type = "revolute", links = ["ground", "wheel"] }
joints.mesh = { type = "gear", links = ["pinion", "wheel"], points = ["O", "C"], radii = ["20 mm", "40 mm"], efficiency = 0.9 }
loads = [{ link = "wheel", M = "10 N*m", useful = "yes", over = [["0 deg", 1], ["90 deg", 1], ["180 deg", -1], ["270 deg", -1]] }]
)";

const account::Cell* cell_of(const account::Table& table, const std::string& start) {
  for (const auto& row : table.rows) {
    if (text_of(row[0]).starts_with(start)) return &row[1];
  }
  return nullptr;
}

}  // namespace

TEST_SUITE("mechanism rest") {
  TEST_CASE("runs of positions: each by itself, and in a cycle across its end") {
    const std::vector<bool> positions{true, false, true, true, true, false, true, true};
    const auto open = planar::runs_of(positions, true, false);
    REQUIRE(open.size() == 3);
    CHECK(open[1].first == 2);
    CHECK(open[1].last == 4);
    CHECK(open[1].count == 3);
    const auto cyclic = planar::runs_of(positions, true, true);
    REQUIRE(cyclic.size() == 2);
    CHECK(cyclic[0].first == 6);
    CHECK(cyclic[0].last == 0);
    CHECK(cyclic[0].count == 3);
    CHECK(planar::runs_of({true, true}, true, true)[0].count == 2);
    CHECK(planar::runs_of({true, true}, false, true).empty());
  }

  TEST_CASE("a block that jams when it is pushed off centre at rest, and its return") {
    // F = P / (1 - 2 mu h / l) has no positive value.
    const auto jam = solved(block_that_jams(R"({ joint = "rail" })"));
    CHECK(value(jam, "a.cylinders.drive.F_backward") == doctest::Approx(100.0 / (1.0 + 500.0 / 400.0)));
    CHECK(std::isnan(value(jam, "a.cylinders.drive.F_forward")));
    CHECK(text_of(*cell_of(*table_of(jam, "At rest"), "no effort starts it forward")) == "yes");
    const account::Verdict& moves = verdict_of(jam, "moves");
    CHECK(moves.state == account::State::not_covered);
    CHECK(moves.note.text() ==
          "at rest friction acts in either direction, and no effort of the drive starts it forward; state 'impending'");
  }

  TEST_CASE("the force that pushes a block up a plane, that which lets it down, and sliding back beyond arctan mu") {
    for (const double degrees : {10.0, 30.0}) {
      const auto project = solved(plane(std::to_string(degrees) + " deg", ""));
      const double a = degrees * pi / 180.0, up = 1000.0 * (std::sin(a) + 0.3 * std::cos(a));
      const double down = 1000.0 * (std::sin(a) - 0.3 * std::cos(a));
      CHECK(value(project, "a.cylinders.push.F_forward") == doctest::Approx(up));
      CHECK(value(project, "a.cylinders.push.F_backward") == doctest::Approx(down));
      CHECK(value(project, "a.cylinders.push.F") == doctest::Approx(1000.0 * std::sin(a)));
      CHECK(value(project, "a.cylinders.push.F_min") == doctest::Approx(down));
      CHECK(value(project, "a.cylinders.push.F_max") == doctest::Approx(up));
      CHECK(value(project, "a.joints.G.F_max") == doctest::Approx(1000.0 * std::cos(a) * std::hypot(1.0, 0.3)));
      const account::Table* table = table_of(project, "At rest");
      REQUIRE(table != nullptr);
      CHECK(text_of(*cell_of(*table, "at rest without its drive")) == (down <= 0.0 ? "yes" : "no"));
      const account::Cell* mu = cell_of(*table, "coefficient of friction then");
      REQUIRE((mu != nullptr) == (down <= 0.0));
      if (mu != nullptr) CHECK(std::get<account::Quantity>(*mu).si == doctest::Approx(std::tan(a)).epsilon(1e-7));
      const account::Verdict& moves = verdict_of(project, "moves");
      CHECK(moves.state == account::State::not_covered);
      CHECK(moves.note.text().starts_with("at rest friction acts in either direction"));
    }
  }

  TEST_CASE("mixed friction: the coefficient at rest starts a block, a smaller one keeps it moving") {
    const auto mixed = [](const std::string& drive) {
      std::string text = plane("30 deg", drive);
      return text.replace(text.find("mu = 0.3"), 8, "mu = 0.1, mu_s = 0.3, v_s = \"0.2 m/s\"");
    };
    const auto rests = solved(mixed(""));
    CHECK(value(rests, "a.cylinders.push.F_forward") == doctest::Approx(500.0 + 0.3 * 1000.0 * std::cos(pi / 6.0)));
    const auto moves = solved(mixed(", speed = \"0.1 m/s\""));
    CHECK(value(moves, "a.cylinders.push.F") == doctest::Approx(721.494792903854).epsilon(1e-10));
    CHECK(value(moves, "a.cylinders.push.F_forward") == doctest::Approx(value(rests, "a.cylinders.push.F_forward")));
  }

  TEST_CASE("contradictory inputs of mixed friction are refused") {
    const auto said = [](const std::string& friction) {
      std::string text = plane("30 deg", ", speed = \"0.1 m/s\"");
      return issues_of(text.replace(text.find("mu = 0.3"), 8, friction));
    };
    const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
    CHECK(has(said("mu = 0.3, mu_s = 0.1, v_s = \"1 m/s\""), "the coefficient at rest is smaller than mu"));
    CHECK(has(said("mu = 0.1, mu_s = 0.3"), "needs 'v_s'"));
    CHECK(has(said("mu = 0, mu_s = 0.3, v_s = \"1 m/s\""), "needs 'mu'"));
    CHECK(has(said("mu = 0.1, v_s = \"1 m/s\""), "needs 'mu_s'"));
    CHECK(said("mu = 0.1, mu_s = 0.1, v_s = \"1 m/s\"").find("error") == std::string::npos);
  }

  TEST_CASE("a drive at impending motion gives its direction, and a moving one does not") {
    const auto up = solved(plane("10 deg", ", impending = \"forward\""));
    CHECK(value(up, "a.cylinders.push.F") == value(up, "a.cylinders.push.F_forward"));
    CHECK(value(up, "a.cylinders.push.F_min") == value(up, "a.cylinders.push.F_max"));
    CHECK(verdict_of(up, "moves").note.empty());
    const auto down = solved(plane("10 deg", ", impending = \"backward\""));
    CHECK(value(down, "a.cylinders.push.F") == value(down, "a.cylinders.push.F_backward"));
    CHECK(issues_of(plane("10 deg", ", impending = \"forward\", speed = \"1 m/s\""))
              .find("error: 'impending' belongs to a drive at rest, and 'cylinders.push' has a speed\n") !=
          std::string::npos);
  }

  TEST_CASE("a slider-crank: the effort at the dead points of the slide is a range, elsewhere one value") {
    const std::string text = R"([a]
calculator = "mechanism.planar"
template = "slider_crank"
r = "50 mm"
l = "200 mm"
crank = { speed = "60 rpm", positions = 72 }
joints.guide = { mu = 0.1, guide_length = "80 mm", guide_width = "0 mm" }
links.slider.mass = "2 kg"
loads = [{ link = "slider", at = "B", F_x = "-1 kN", F_y = "-500 N" }]
)";
    const auto project = solved(text);
    const Value& least = *project.value("a.joints.guide.F");
    const Value& most = *project.value("a.joints.guide.F_max");
    for (std::size_t k = 0; k < least.si.size(); ++k) {
      CAPTURE(k);
      if (k % 36 == 0) {
        CHECK(least.si[k] < most.si[k]);
      } else {
        CHECK(least.si[k] == most.si[k]);
      }
    }
    const account::Table* table = table_of(project, "Joints at rest");
    REQUIRE(table != nullptr);
    CHECK(text_of(table->rows[0][0]) == "0°");
  }

  TEST_CASE("gears pass on the power times their efficiency, and the flank changes with the sign of the moment") {
    const auto project = solved(gears);
    const Value& drive = *project.value("a.drive.P");
    const Value& lost = *project.value("a.drive.P_loss");
    const Value& useful = *project.value("a.drive.P_useful");
    for (std::size_t k = 0; k < drive.si.size(); ++k) {
      CAPTURE(k);
      CHECK(drive.si[k] == doctest::Approx(useful.si[k] + lost.si[k]));
      CHECK(lost.si[k] >= 0.0);
      const double sent = std::max(drive.si[k], -useful.si[k]), got = std::max(-drive.si[k], useful.si[k]);
      CHECK(got == doctest::Approx(0.9 * sent));
    }
    const account::Table* table = table_of(project, "Loaded flanks");
    REQUIRE(table != nullptr);
    CHECK(text_of(table->rows[0][1]) == "135°, 315°");
  }

  TEST_CASE("a worm and a lift: the report states rest without the drive, and the efficiency of the reversed flow") {
    std::string lift =
        replaced(gears, ", over = [[\"0 deg\", 1], [\"90 deg\", 1], [\"180 deg\", -1], [\"270 deg\", -1]]", "");
    lift = replaced(lift, "efficiency = 0.9", "efficiency = 0.4, efficiency_back = -0.5");
    const auto worm = solved(lift);
    CHECK(text_of(*cell_of(*table_of(worm, "At rest"), "at rest without its drive")) == "at every position");
    // It is at rest everywhere as soon as 1 - efficiency_back, here 1.5, is 1: two thirds of its friction.
    const account::Cell* share = cell_of(*table_of(worm, "At rest"), "the same for every position");
    REQUIRE(share != nullptr);
    CHECK(std::get<account::Quantity>(*share).si == doctest::Approx(2.0 / 3.0).epsilon(1e-6));
    const auto back = solved(
        replaced(replaced(lift, "efficiency = 0.4, efficiency_back = -0.5", "efficiency = 0.8"), "10 N*m", "-10 N*m"));
    const account::Table* power = table_of(back, "Power over the revolution");
    REQUIRE(power != nullptr);
    const account::Cell* eta = cell_of(*power, "efficiency of the reversed flow");
    if (value(back, "a.drive.M") < 0.0) {
      REQUIRE(eta != nullptr);
      CHECK(std::get<account::Quantity>(*eta).si == doctest::Approx(0.8));
    } else {
      CHECK(eta == nullptr);
    }
  }

  TEST_CASE("an efficiency belongs to gears and belts") {
    CHECK(issues_of(replaced(gears, "type = \"revolute\", links = [\"ground\", \"wheel\"]",
                             "type = \"revolute\", links = [\"ground\", \"wheel\"], efficiency = 0.9"))
              .find("error: 'efficiency' belongs to teeth and belts, and 'C' is of type revolute\n") !=
          std::string::npos);
  }
}
