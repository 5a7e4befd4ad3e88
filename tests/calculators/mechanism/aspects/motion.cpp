// Assemblies, transmission angles, strokes, relative motion and derivatives as a project gives them.
#include "lib/quantity/series.hpp"
#include "tests/lib/project/accounts.hpp"
#include "tests/lib/project/texts.hpp"

#include <algorithm>
#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string head = "[a]\ncalculator = \"mechanism.planar\"\n";
const std::string drive = "crank = { speed = \"60 rpm\", positions = 72 }\n";
const std::string rocker =
    head + "template = \"four_bar\"\na = \"100 mm\"\nb = \"350 mm\"\nc = \"300 mm\"\nd = \"400 mm\"\n" + drive;
const std::string piston = head + "template = \"slider_crank\"\nr = \"50 mm\"\nl = \"200 mm\"\n" + drive;
const std::string lever = head + R"(crank = { joint = "O", speed = "45 rad/s", start = "-60 deg", positions = 72 }
ground = { O = ["90 mm", "0 mm"], B = ["0 mm", "0 mm"] }
links.crank = { points = { O = ["0 mm", "0 mm"], A = ["30 mm", "0 mm"] }, angle = "-60 deg" }
links.lever = { points = { B = ["0 mm", "0 mm"] }, angle = "-14 deg" }
joints.O = { type = "revolute", links = ["ground", "crank"] }
joints.B = { type = "revolute", links = ["ground", "lever"] }
joints.A = { type = "slot", links = ["crank", "lever"], points = ["A", "B"] }
)";

const Value& value_of(const project::Project& project, const std::string& path) {
  const Value* value = project.steps[0]->value(path);
  CAPTURE(path);
  REQUIRE(value != nullptr);
  return *value;
}

double number_of(const account::Cell& cell) { return std::get<account::Quantity>(cell).si; }

}  // namespace

TEST_SUITE("mechanism motion") {
  TEST_CASE("a zero in the tables of the motion is a zero, and a direction is given in one way") {
    for (const char* crank : {"start = \"-90.1 deg\", positions = 361", "start = \"-90 deg\"", "start = \"0 deg\""}) {
      CAPTURE(crank);
      const auto project = solved(replaced(piston, "positions = 72", crank));
      int numbers = 0;
      for (const char* title : {"Strokes", "Instantaneous centres"}) {
        const account::Table* table = table_of(project, title);
        REQUIRE(table != nullptr);
        for (const auto& row : table->rows) {
          for (const account::Cell& cell : row) {
            const auto* q = std::get_if<account::Quantity>(&cell);
            if (q == nullptr) continue;
            CHECK((q->si == 0.0 || std::abs(q->si) > 1e-9));
            ++numbers;
          }
        }
      }
      CHECK(numbers >= 15);
    }
  }

  TEST_CASE("an assembly is chosen by the side of a dyad, and the report lists them all") {
    const auto stated = solved(rocker), other = solved(rocker + "sides = [\"B_right\"]\n");
    const account::Table* table = table_of(stated, "Assembly modes at the first position");
    REQUIRE(table != nullptr);
    REQUIRE(table->rows.size() == 2);
    CHECK(text_of(table->rows[0][0]) == "B_left");
    CHECK(text_of(table->rows[0][1]) == "yes");
    CHECK(text_of(table->rows[1][0]) == "B_right");
    CHECK(text_of(table->rows[1][1]) == "–");
    CHECK(value_of(stated, "points.B.y").si[0] == doctest::Approx(-value_of(other, "points.B.y").si[0]));
    CHECK(text_of(table_of(other, "Assembly modes")->rows[0][0]) == "B_right");
  }

  TEST_CASE("a side that no group has, and sides that exclude each other") {
    const auto wrong = told(rocker + "sides = [\"B_rigth\"]\n").issues;
    REQUIRE(wrong.size() == 1);
    CHECK(wrong[0].message.text() == "no group has the side 'B_rigth'");
    CHECK(wrong[0].hint.text() == "did you mean 'B_right'?");
    const auto both = told(rocker + "sides = [\"B_right\", \"B_left\"]\n").issues;
    REQUIRE(both.size() == 1);
    CHECK(both[0].message.text() == "no assembly has all these sides");
    CHECK(both[0].hint.text() == "available: B_left; B_right");
  }

  TEST_CASE("a parallelogram passes change points in its flat positions, and that is not covered") {
    const auto flat = solved(head + R"(crank = { joint = "O", speed = "60 rpm", start = "31 deg", positions = 72 }
ground = { O = ["0 mm", "0 mm"], C = ["400 mm", "0 mm"] }
links.crank = { points = { O = ["0 mm", "0 mm"], A = ["100 mm", "0 mm"] }, angle = "31 deg" }
links.coupler = { points = { A = ["0 mm", "0 mm"], B = ["400 mm", "0 mm"] }, angle = "0 deg" }
links.rocker = { points = { C = ["0 mm", "0 mm"], B = ["100 mm", "0 mm"] }, angle = "31 deg" }
joints.O = { type = "revolute", links = ["ground", "crank"] }
joints.A = { type = "revolute", links = ["crank", "coupler"] }
joints.B = { type = "revolute", links = ["coupler", "rocker"] }
joints.C = { type = "revolute", links = ["ground", "rocker"] }
)");
    const auto& verdicts = flat.steps[0]->account().verdicts;
    const auto found =
        std::find_if(verdicts.begin(), verdicts.end(), [](const auto& v) { return v.symbol == "assembly"; });
    REQUIRE(found != verdicts.end());
    CHECK(found->state == account::State::not_covered);
    CHECK(text_of(found->value) == "passed 2 times");
    CHECK(found->note.text() == "change point: direction of motion not determined by the drive: B at 180°, B at 360°");
    const account::Table* table = table_of(flat, "Mobility and conditioning");
    REQUIRE(table != nullptr);
    CHECK(text_of(table->rows[2][0]) == "positions that were followed in small steps; first at 171°");
    const auto plain = solved(rocker);
    CHECK(table_of(plain, "Mobility and conditioning")->rows.size() == 4);
    const auto& sound = plain.steps[0]->account().verdicts;
    CHECK(std::none_of(sound.begin(), sound.end(), [](const auto& v) { return v.symbol == "assembly"; }));
  }

  TEST_CASE("the smallest transmission angle of a four-bar is where crank and frame are in line") {
    const auto project = solved(rocker);
    const double gamma = std::acos((0.35 * 0.35 + 0.3 * 0.3 - 0.3 * 0.3) / (2.0 * 0.35 * 0.3));
    CHECK(minimum(value_of(project, "joints.B.gamma")).value == doctest::Approx(gamma));
    const account::Table* table = table_of(project, "Transmission angles");
    REQUIRE(table != nullptr);
    REQUIRE(table->rows.size() == 1);
    CHECK(text_of(table->rows[0][0]) == "B");
    CHECK(text_of(table->rows[0][1]) == "left: of the line from A to C");
    CHECK(number_of(table->rows[0][2]) == doctest::Approx(gamma));
    CHECK(text_of(table->rows[0][4]) == "–");
  }

  TEST_CASE("a transmission angle below 40°, and below 30°, is reported") {
    const auto remark = [](const char* coupler) {
      const auto project = solved(replaced(rocker, "b = \"350 mm\"", coupler));
      return text_of(table_of(project, "Transmission angles")->rows[0][4]);
    };
    CHECK(remark("b = \"210 mm\"") == "below 30°");
    CHECK(remark("b = \"290 mm\"") == "–");
    CHECK(remark("b = \"220 mm\"") == "below 40°: light loads only");
  }

  TEST_CASE("teeth have their pressure angle at every position") {
    const auto gears = solved(head + R"(crank = { joint = "O", speed = "60 rpm", positions = 12 }
ground = { O = ["0 mm", "0 mm"], C = ["60 mm", "0 mm"] }
links.pinion = { points = { O = ["0 mm", "0 mm"] }, angle = "0°" }
links.wheel = { points = { C = ["0 mm", "0 mm"] }, angle = "0°" }
joints.O = { type = "revolute", links = ["ground", "pinion"] }
joints.C = { type = "revolute", links = ["ground", "wheel"] }
joints.mesh = { type = "gear", links = ["pinion", "wheel"], points = ["O", "C"], radii = ["20 mm", "40 mm"] }
)");
    const account::Table* table = table_of(gears, "Transmission angles");
    REQUIRE(table != nullptr);
    CHECK(text_of(table->rows[0][1]) == "teeth, pressure angle 20°");
    CHECK(number_of(table->rows[0][2]) == doctest::Approx(70.0 * pi / 180.0));
    CHECK(value(gears, "a.links.wheel.swing") == doctest::Approx(pi));
    CHECK(value(gears, "a.links.wheel.dphi") == doctest::Approx(-0.5));
    CHECK(table_of(gears, "Assemblies") == nullptr);
  }

  TEST_CASE("strokes: the piston's 2 r, the rocker's swing angle, a lever's quick return") {
    CHECK(value(solved(piston), "a.joints.guide.stroke") == doctest::Approx(0.1));
    const auto angle = [](double reach) { return std::acos((0.16 + 0.09 - reach * reach) / 0.24); };
    const auto four_bar = solved(rocker);
    CHECK(value_of(four_bar, "links.rocker.swing").si[0] == doctest::Approx(angle(0.45) - angle(0.25)));
    CHECK(value_of(four_bar, "links.crank.swing").si[0] == doctest::Approx(2.0 * pi));
    CHECK_FALSE(value_of(four_bar, "links.rocker.swing").is_series());
    const double half = std::asin(1.0 / 3.0);
    const auto slotted = solved(lever);
    const account::Table* table = table_of(slotted, "Strokes");
    REQUIRE(table != nullptr);
    CHECK(text_of(table->rows[0][0]) == "lever");
    CHECK(number_of(table->rows[0][1]) == doctest::Approx(-half));
    CHECK(number_of(table->rows[0][3]) == doctest::Approx(half));
    CHECK(number_of(table->rows[0][5]) == doctest::Approx(2.0 * half));
    CHECK(number_of(table->rows[0][6]) == doctest::Approx((pi + 2.0 * half) / (pi - 2.0 * half)));
  }

  TEST_CASE("where the mechanism does not close, a stroke is not available") {
    const auto project = solved(bar_that_cannot_turn(72));
    const Value& swing = value_of(project, "links.c.swing");
    REQUIRE(swing.si.size() == 1);
    CHECK(std::isnan(swing.si[0]));
  }

  TEST_CASE("the pin in a slot: position, relative velocity, Coriolis acceleration 2 omega v_r") {
    const auto project = solved(lever);
    const auto& omega = value_of(project, "links.lever.omega").si;
    const auto& v_r = value_of(project, "joints.A.v_r").si;
    const auto& a_C = value_of(project, "joints.A.a_C").si;
    for (std::size_t k = 0; k < omega.size(); ++k) CHECK(a_C[k] == doctest::Approx(2.0 * omega[k] * v_r[k]));
    CHECK(value_of(project, "joints.A.s").si[0] == doctest::Approx(std::hypot(0.105, 0.03 * std::sqrt(0.75))));
    CHECK(minimum(value_of(project, "joints.A.gamma")).value == doctest::Approx(pi / 2.0));
    CHECK(value_of(project, "joints.A.stroke").si[0] == doctest::Approx(0.06));
  }

  TEST_CASE("derivatives do not depend on the speed of the crank, and exist at standstill") {
    const auto fast = solved(rocker), still = solved(replaced(rocker, "60 rpm", "0 rpm"));
    const double speed = 2.0 * pi;
    for (const char* path : {"links.rocker.dphi", "links.coupler.d2phi", "points.B.dx", "points.B.dy"}) {
      const auto &a = value_of(fast, path).si, &b = value_of(still, path).si;
      REQUIRE(a.size() == 72);
      for (std::size_t k = 0; k < a.size(); ++k) CHECK(a[k] == doctest::Approx(b[k]));
    }
    CHECK(value_of(fast, "links.rocker.omega").si[5] ==
          doctest::Approx(speed * value_of(fast, "links.rocker.dphi").si[5]));
    CHECK(value_of(fast, "points.B.v_x").si[5] == doctest::Approx(speed * value_of(fast, "points.B.dx").si[5]));
  }

  TEST_CASE("instantaneous centres at the first position, of a piston at infinity") {
    const auto project = solved(replaced(piston, "speed = \"60 rpm\"", "speed = \"60 rpm\", start = \"30 deg\""));
    const account::Table* table = table_of(project, "Instantaneous centres");
    REQUIRE(table != nullptr);
    CHECK(table->rows.size() == 6);
    const auto& last = table->rows.back();
    CHECK(text_of(last[0]) == "slider");
    CHECK(text_of(last[1]) == "ground");
    CHECK(text_of(last[2]) == "at infinity, towards 90°");
  }

  TEST_CASE("other steps take a swing angle as one value") {
    const auto project = solved(rocker + "[b]\ncalculator = \"shaft.torsion\"\n" +
                                "T = \"=100 N*m * a.links.rocker.swing\"\ntau_adm = \"30 MPa\"\nd = \"60 mm\"\n");
    CHECK(value(project, "b.T") == doctest::Approx(100.0 * value(project, "a.links.rocker.swing")));
  }

  TEST_CASE("a change point that is hit is reported, and positions beyond it are solved") {
    const std::string parallel = R"([par]
calculator = "mechanism.planar"
crank = { joint = "O1", speed = "60 rpm", positions = 72, start = "90 deg" }
gravity = "10 m/s^2"
ground = { O1 = ["0 mm", "0 mm"], O2 = ["100 mm", "0 mm"] }
[par.links]
c1 = { points = { O1 = ["0 mm", "0 mm"], A1 = ["50 mm", "0 mm"] }, angle = "90 deg" }
c2 = { points = { O2 = ["0 mm", "0 mm"], A2 = ["50 mm", "0 mm"] }, angle = "90 deg" }
bar = { points = { A1 = ["0 mm", "0 mm"], A2 = ["100 mm", "0 mm"], S = ["50 mm", "0 mm"] }, angle = "0 deg", mass = "5 kg", J = "0 kg*m^2", S = "S" }
[par.joints]
O1 = { links = ["c1", "ground"] }
O2 = { links = ["c2", "ground"] }
A1 = { links = ["c1", "bar"] }
A2 = { links = ["c2", "bar"] }
)";
    const auto project = solved(parallel);
    const Value* effort = project.value("par.drive.M");
    for (std::size_t k = 0; k < 72; ++k) {
      const double angle = effort->signature.axis->at[k];
      CAPTURE(k);
      if (k == 18 || k == 54) {
        CHECK(std::isnan(effort->si[k]));
      } else {
        CHECK(effort->si[k] == doctest::Approx(5.0 * 10.0 * 0.05 * std::cos(angle)).epsilon(1e-9));
      }
    }
    const auto& verdicts = project.steps[0]->account().verdicts;
    CHECK(verdicts[0].note.text() ==
          "change point at 180°, 360°: the drive does not determine the motion there; choose other positions, "
          "crank = { "
          "start = \"92.5°\" }");
    const auto beside = solved(replaced(parallel, "90 deg\" }\ngravity", "92.5 deg\" }\ngravity"));
    CHECK(beside.steps[0]->account().verdicts[0].state == account::State::pass);
  }
}
