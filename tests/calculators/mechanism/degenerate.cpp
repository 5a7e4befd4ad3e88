// Degenerate sizes: links without length, springs without direction, lists without items, tolerances as wide as their
// dimension; and messages for a mechanism that does not close, jams or has no forces.
#include "lib/quantity/format.hpp"
#include "tests/lib/project/accounts.hpp"
#include "tests/lib/project/texts.hpp"

#include <algorithm>
#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// A slider-crank of 50 mm and 200 mm, with more lines.
std::string press(const std::string& more) {
  return R"([press]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "60 rpm", positions = 12 }
ground = { O = ["0 mm", "0 mm"], G = ["0 mm", "0 mm"] }
links.crank = { points = { O = ["0 mm", "0 mm"], A = ["50 mm", "0 mm"] }, angle = "30 deg" }
links.rod = { points = { A = ["0 mm", "0 mm"], B = ["200 mm", "0 mm"] }, angle = "-7 deg" }
links.slider = { points = { B = ["0 mm", "0 mm"] }, angle = "0 deg", mass = "2 kg" }
joints.O = { type = "revolute", links = ["crank", "ground"] }
joints.A = { type = "revolute", links = ["crank", "rod"] }
joints.B = { type = "revolute", links = ["rod", "slider"] }
joints.guide = { type = "prismatic", links = ["slider", "ground"], points = ["B", "G"] }
loads = [{ link = "slider", at = "B", F_x = "-1 kN", F_y = "0 N" }]
)" + more;
}

std::string said_of(const std::string& part, const std::string& other) {
  return issues_of(replaced(press(""), part, other));
}

/// A block that a cylinder pushes from -50 mm to 50 mm over the foot of its spring, at the sixth of eleven positions.
std::string over_its_spring(const std::string& free, const std::string& friction = "") {
  return R"([block]
calculator = "mechanism.planar"
positions = 11
ground = { G = ["0 mm", "0 mm"] }
links.ram = { points = { B = ["0 mm", "0 mm"] }, angle = "0 deg" }
joints.guide = { type = "prismatic", links = ["ram", "ground"], points = ["B", "G"])" +
         friction + R"( }
springs.back = { links = ["ram", "ground"], points = ["B", "G"], k = "2 N/mm", free = ")" +
         free + R"(" }
cylinders.push = { joint = "guide", speed = "1 m/s", from = "-50 mm", to = "50 mm" }
)";
}

/// Crank angle in the table of the drive.
std::string crank_angle_of(const project::Project& project) {
  for (const account::Block& block : project.steps[0]->account().input_blocks) {
    const auto* table = std::get_if<account::Table>(&block);
    if (table == nullptr || table->caption.text() != "Drive") continue;
    for (const auto& row : table->rows) {
      if (std::get<Message>(row[0]).text() == "crank angle") return std::get<Message>(row[1]).text();
    }
  }
  return {};
}

}  // namespace

TEST_SUITE("mechanism degenerate") {
  TEST_CASE("a link with its only two pins at one place moves nothing") {
    CHECK(said_of("A = [\"50 mm\", \"0 mm\"]", "A = [\"0 mm\", \"0 mm\"]") ==
          R"(a.toml:5:26: error: points O and A of 'crank' coincide: it moves nothing
5 | links.crank = { points = { O = ["0 mm", "0 mm"], A = ["0 mm", "0 mm"] }, angle = "30 deg" }
  |                          ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  = help: move them apart, or join its neighbours by one pin and leave 'crank' out
)");
    CHECK(said_of("B = [\"200 mm\", \"0 mm\"]", "B = [\"0 mm\", \"0 mm\"]")
              .starts_with("a.toml:6:24: error: points A and B of 'rod' coincide: it moves nothing\n"));
  }

  TEST_CASE("a wheel on the pin of another link is not such a link") {
    CHECK(issues_of(press(R"(links.wheel = { points = { A = ["0 mm", "0 mm"] }, angle = "0 deg" }
joints.A2 = { type = "revolute", links = ["crank", "wheel"], points = ["A", "A"] }
joints.mesh = { type = "gear", links = ["ground", "wheel"], points = ["O", "A"], radii = ["30 mm", "20 mm"] }
)"))
              .empty());
  }

  TEST_CASE("a spring with both ends on one pin has no direction") {
    CHECK(issues_of(
              press("springs.s = { links = [\"crank\", \"ground\"], points = [\"O\", \"O\"], k = \"2 N/mm\", free = "
                    "\"10 mm\" }\n")) ==
          R"(a.toml:13:13: error: both ends of spring 's' are in one place: it has no direction to act in
13 | springs.s = { links = ["crank", "ground"], points = ["O", "O"], k = "2 N/mm", free = "10 mm" }
   |             ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
   = help: attach its ends to points that move apart; a spring that turns about a pin has k_turn, c_turn
)");
    const std::string other_end =
        "springs.s = { links = [\"crank\", \"ground\"], points = [\"A\", \"O\"], k = \"2 N/mm\", "
        "free = \"10 mm\" }\n";
    CHECK(issues_of(press(other_end)).empty());
  }

  TEST_CASE("where the ends of a spring meet its force has no direction, elsewhere it has one") {
    for (const char* const friction : {"", ", mu = 0.1, guide_length = \"60 mm\", guide_width = \"0 mm\""}) {
      CAPTURE(friction);
      const auto project = solved(over_its_spring("20 mm", friction));
      const auto& entry = entry_of(project, "cylinders.push.F");
      // 50 mm is 30 mm beyond the free length: 60 N back to the foot, on either side of it. The guide carries nothing.
      CHECK(entry.value.si.front() == doctest::Approx(-60.0).epsilon(1e-9));
      CHECK(entry.value.si.back() == doctest::Approx(60.0).epsilon(1e-9));
      CHECK(std::isnan(entry.value.si[5]));
      CHECK(entry.missing.text() ==
            "the ends of spring 'back' coincide at some positions, and its force has no direction there");
      CHECK(std::isnan(entry_of(project, "springs.back.F").value.si[5]));
      CHECK(entry_of(project, "joints.guide.s").value.si[5] == doctest::Approx(0.0));
      const account::Verdict& directed = verdict_of(project, "directed_back");
      CHECK(directed.state == account::State::fail);
      CHECK(directed.note.text() == "they coincide at 0 mm");
      const auto& verdicts = project.steps[0]->account().verdicts;
      const auto moves =
          std::find_if(verdicts.begin(), verdicts.end(), [](const auto& v) { return v.symbol == "moves"; });
      CHECK((moves == verdicts.end() || moves->state == account::State::pass));
    }
  }

  TEST_CASE("a spring without a free length has no force where its ends meet") {
    const auto project = solved(over_its_spring("0 mm"));
    const auto& force = entry_of(project, "cylinders.push.F");
    CHECK(force.value.si.back() == doctest::Approx(100.0).epsilon(1e-9));
    CHECK(std::abs(force.value.si[5]) <= 1e-9);
    CHECK(force.missing.empty());
  }

  TEST_CASE("a crank that cannot revolve: what to do, and why its results are missing") {
    const auto bar = solved(bar_that_cannot_turn(36));
    const std::string note = verdict_of(bar, "closes").note.text();
    INFO(note);
    CHECK(note.find("the parts of joint '") != std::string::npos);
    CHECK(note.find("' come no closer than ") != std::string::npos);
    CHECK(
        note.ends_with("; the crank does not turn round: change the lengths, or give it angles where the mechanism "
                       "closes, crank = { at = [...] }"));
    CHECK(entry_of(bar, "drive.M").missing.text() == "the mechanism does not close at every position");
    CHECK(entry_of(solved(press("")), "drive.M").missing.empty());
  }

  TEST_CASE("the limit of the crank is given to a hundredth of a degree, however far apart the positions are") {
    // Coupler and rocker in line: law of cosines. The crank angle is that of its own x axis, 90 deg ahead of AB.
    const double b = std::hypot(70.0, 10.0), c = std::hypot(80.0, 90.0), a = 100.0, d = 150.0;
    const double stretched = std::acos((a * a + d * d - (b + c) * (b + c)) / (2.0 * a * d)) * 180.0 / pi;
    const auto text = [](double at) { return format_number(0.01 * std::round(100.0 * at), 9) + "°"; };
    const std::string stops = "not between " + text(90.0 + stretched) + " and " + text(450.0 - stretched) + ": ";
    for (const int positions : {36, 37, 72, 100, 360}) {
      CAPTURE(positions);
      const std::string note = verdict_of(solved(bar_that_cannot_turn(positions)), "closes").note.text();
      CAPTURE(note);
      CHECK(note.starts_with(stops));
    }
  }

  TEST_CASE("a cylinder that is longer or shorter than its links can reach") {
    // A is 500 mm from P, and O 1000 mm.
    const auto lift = [](const char* from, const char* to) {
      return std::string("[a]\ncalculator = \"mechanism.planar\"\nanalysis = \"static\"\npositions = 24\n") +
             "ground = { O = [\"0 mm\", \"0 mm\"], P = [\"1 m\", \"0 mm\"] }\n"
             "links.boom.points = { P = [\"1 m\", \"0 mm\"], A = [\"700 mm\", \"400 mm\"] }\n"
             "joints.P = { links = [\"boom\", \"ground\"] }\n"
             "cylinders.C = { links = [\"ground\", \"boom\"], points = [\"O\", \"A\"], from = \"" +
             from + "\", to = \"" + to + "\" }\nloads = [{ link = \"boom\", M = \"1 N*m\" }]\n";
    };
    const auto note = [&](const char* from, const char* to) {
      return verdict_of(solved(lift(from, to)), "closes").note.text();
    };
    CHECK(note("800 mm", "1600 mm").starts_with("not above 1500 mm: "));
    CHECK(note("900 mm", "450 mm").starts_with("not below 500 mm: "));
    CHECK(note("400 mm", "1600 mm").starts_with("not below 500 mm and above 1500 mm: "));
  }

  TEST_CASE("where friction jams the mechanism, the forces are missing for this reason") {
    const auto jam = solved(block_that_jams(R"({ joint = "rail", impending = "forward" })"));
    CHECK(entry_of(jam, "cylinders.drive.F").missing.text() == "friction jams the mechanism");
    CHECK(entry_of(jam, "links.block.phi").missing.empty());
  }

  TEST_CASE("an empty list is an error") {
    for (const char* const list : {"hodographs", "sides"}) {
      CHECK(issues_of(press(std::string(list) + " = []\n")) ==
            "a.toml:13:" + std::to_string(std::string(list).size() + 4) + ": error: '" + list + "' is empty\n13 | " +
                list + " = []\n   | " + std::string(std::string(list).size() + 3, ' ') +
                "^^\n   = help: give what it lists, or leave it out\n");
    }
    CHECK(said_of("positions = 12", "at = []").starts_with("a.toml:3:47: error: 'crank.at' is empty\n"));
    CHECK(said_of("positions = 12", "law = []").starts_with("a.toml:3:48: error: 'crank.law' is empty\n"));
    CHECK(said_of("F_y = \"0 N\" }]", "F_y = \"0 N\", over = [] }]")
              .starts_with("a.toml:12:74: error: 'loads[1].over' is empty\n"));
  }

  TEST_CASE("a tolerance is narrower than its dimension") {
    const std::string place = "accuracy.place = { of = \"x\", point = \"B\" }\n";
    CHECK(issues_of(press(place + "tolerances.c = { link = \"crank\", point = \"O\", to = \"A\", t = \"50 mm\" }\n")) ==
          R"(a.toml:14:62: error: the tolerance 'c', 50 mm, is not smaller than its length, 50 mm
14 | tolerances.c = { link = "crank", point = "O", to = "A", t = "50 mm" }
   |                                                              ^^^^^
   = help: the half width must be smaller; check its unit
)");
    CHECK(issues_of(press(place + "tolerances.c = { link = \"crank\", point = \"O\", to = \"A\", t = \"49 mm\" }\n"))
              .find("not smaller") == std::string::npos);
    CHECK(first_error(press(place + "tolerances.m = { of = \"mass\", link = \"slider\", t_mass = \"3 kg\" }\n")) ==
          "the tolerance 'm', 3 kg, is not smaller than its mass, 2 kg");
  }

  TEST_CASE("fields that a kind of output does not take") {
    const std::string tolerance = "tolerances.c = { link = \"crank\", point = \"O\", to = \"A\", t = \"1 mm\" }\n";
    CHECK(issues_of(press(tolerance + "accuracy.x = { of = \"drive\", point = \"B\" }\n")) ==
          R"(a.toml:14:39: error: an output of kind drive has no 'point'
14 | accuracy.x = { of = "drive", point = "B" }
   |                                       ^
   = help: leave it out
)");
    CHECK(first_error(press(tolerance + "accuracy.x = { of = \"x\", point = \"B\", joint = \"O\" }\n")) ==
          "an output of kind x has no 'joint'");
  }

  TEST_CASE("the report states the reference line of the crank angle") {
    CHECK(crank_angle_of(solved(press(""))) == "from the x axis to crank's own x axis");
    CHECK(crank_angle_of(solved(replaced(press(""), "joint = \"O\"", "joint = \"O\", to = \"A\""))) ==
          "from the x axis to point A of crank");
  }
}
