// Counterweights, masses in points, efficiency, belts and hodographs as a project gives them.
#include "lib/draw/svg.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/series.hpp"
#include "tests/lib/project/accounts.hpp"
#include "tests/lib/project/texts.hpp"

#include <algorithm>
#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string head = "[a]\ncalculator = \"mechanism.planar\"\n";
const std::string turn = "crank = { joint = \"O\", speed = \"100 rad/s\", positions = 36 }\n";

/// A slider-crank; `crank`, `rod`: further fields of the link, `piston`: of the load.
std::string press(const std::string& crank, const std::string& rod, const std::string& load = "") {
  return head + turn + R"(ground = { O = ["0 mm", "0 mm"], G = ["0 mm", "0 mm"], Q = ["400 mm", "0 mm"] }
links.slider = { points = { B = ["0 mm", "0 mm"] }, angle = "0 deg" }
joints.O = { type = "revolute", links = ["crank", "ground"] }
joints.A = { type = "revolute", links = ["crank", "rod"] }
joints.B = { type = "revolute", links = ["rod", "slider"] }
joints.guide = { type = "prismatic", links = ["slider", "ground"], points = ["B", "G"] }
links.crank = { points = { O = ["0 mm", "0 mm"], A = ["50 mm", "0 mm"], S = ["40 mm", "20 mm"] }, angle = "30 deg")" +
         crank + R"( }
links.rod = { points = { A = ["0 mm", "0 mm"], B = ["200 mm", "0 mm"], C = ["80 mm", "0 mm"] }, angle = "-7 deg")" +
         rod + " }\n" + load;
}

const Value& value_of(const project::Project& project, const std::string& path) {
  return entry_of(project, path).value;
}
double number_of(const project::Project& project, const std::string& path) { return value_of(project, path).si[0]; }

const figure::Figure* figure_of(const project::Project& project, const std::string& id) {
  for (const figure::Figure& figure : project.steps[0]->account().figures) {
    if (figure.id == id) return &figure;
  }
  return nullptr;
}

/// Whether its report has this note.
bool says(const project::Project& project, const std::string& note) {
  const auto& blocks = project.steps[0]->account().blocks;
  return std::any_of(blocks.begin(), blocks.end(), [&](const account::Block& block) {
    const auto* paragraph = std::get_if<account::Paragraph>(&block);
    return paragraph != nullptr && paragraph->text.text() == note;
  });
}

/// Message for a text with one error.
void check_said(const std::string& text, const std::string& message) {
  const auto issues = told(text).issues;
  CAPTURE(message);
  REQUIRE(issues.size() == 1);
  CHECK(issues[0].message.text() == message);
}

const std::string rotating = ", mass = \"2 kg\", J = \"0 kg*m^2\", S = \"S\"";  // 80 and 40 kg mm from O

}  // namespace

TEST_SUITE("mechanism design") {
  TEST_CASE("a counterweight balances all of a rotating mass") {
    const auto project =
        solved(press(rotating, "") + "counterweights.w = { link = \"crank\", at = \"O\", radius = \"50 mm\" }\n");
    CHECK(number_of(project, "counterweights.w.mr") == doctest::Approx(std::hypot(0.08, 0.04)).epsilon(1e-9));
    CHECK(number_of(project, "counterweights.w.angle") == doctest::Approx(std::atan2(-0.04, -0.08)).epsilon(1e-9));
    CHECK(number_of(project, "counterweights.w.m") == doctest::Approx(std::hypot(1.6, 0.8)).epsilon(1e-9));
    const double force = std::hypot(0.08, 0.04) * 1e4;
    CHECK(number_of(project, "frame.F_rms") == doctest::Approx(force).epsilon(1e-9));
    CHECK(number_of(project, "frame.F_peak") == doctest::Approx(force).epsilon(1e-9));
    CHECK(number_of(project, "frame.F_rms_balanced") < 1e-9 * force);
    CHECK(number_of(project, "frame.F_peak_balanced") < 1e-9 * force);
    CHECK(value_of(project, "frame.F_balanced").si.size() == 36);
  }

  TEST_CASE("in a stated direction it balances the component in it") {
    const std::string text = "counterweights.w = { link = \"crank\", at = \"O\", direction = \"180 deg\" }\n";
    const auto rms = solved(press(rotating, "") + text);
    CHECK(number_of(rms, "counterweights.w.mr") == doctest::Approx(0.08).epsilon(1e-9));
    CHECK(number_of(rms, "frame.F_rms_balanced") == doctest::Approx(0.04e4).epsilon(1e-9));
    // Without a radius it has no mass, and the moment after balancing is not known.
    CHECK(std::isnan(number_of(rms, "counterweights.w.m")));
    CHECK(entry_of(rms, "counterweights.w.m").missing.text() == "neither its mass nor its radius is given");
    CHECK(std::isnan(number_of(rms, "frame.M_peak_balanced")));
    CHECK(entry_of(rms, "frame.M_peak_balanced").missing.text() ==
          "a counterweight without radius has no moment of inertia: give its radius");
  }

  TEST_CASE("the smallest peak is below the peak of the smallest root mean square") {
    const std::string heavy = press(rotating, ", mass = \"1 kg\", J = \"0 kg*m^2\", S = \"C\"") +
                              "counterweights.w = { link = \"crank\", at = \"O\" }\n";
    const auto rms = solved(heavy), peak = solved(heavy + "balance = \"peak\"\n");
    CHECK(number_of(rms, "frame.F_rms_balanced") < number_of(peak, "frame.F_rms_balanced"));
    CHECK(number_of(rms, "frame.F_peak_balanced") > number_of(peak, "frame.F_peak_balanced"));
  }

  TEST_CASE("wrong counterweights are reported") {
    const std::string sound = press(rotating, "");
    check_said(sound + "counterweights.w = { link = \"crnk\", at = \"O\" }\n", "unknown link 'crnk'");
    check_said(sound + "counterweights.w = { link = \"crank\", at = \"B\" }\n", "the link 'crank' has no point 'B'");
    check_said(sound + "counterweights.w = { link = \"ground\", at = \"O\" }\n",
               "a counterweight on the ground does not move");
    check_said(sound + "counterweights.w = { link = \"rod\", at = \"A\" }\n",
               "the point 'A' of 'rod' moves: a counterweight there needs its mass");
    check_said(sound + "counterweights.w = { link = \"rod\", at = \"A\", mass = \"1 kg\", radius = \"9 mm\" }\n",
               "with a mass the arm of 'w' follows from the balance, and 'radius' has no effect");
    check_said(sound + "analysis = \"static\"\ncounterweights.w = { link = \"crank\", at = \"O\" }\n",
               "counterweights balance inertia, and the analysis is static");
    std::string at = sound;
    const std::string positions = "positions = 36";
    at.replace(at.find(positions), positions.size(), "at = [\"0 deg\", \"90 deg\"]");
    check_said(at + "counterweights.w = { link = \"crank\", at = \"O\" }\n",
               "counterweights need a full revolution of a crank, and there is none");
  }

  TEST_CASE("a rod reduced to two masses is one with their moment of inertia; with three it is unchanged") {
    const std::string rod = ", mass = \"3 kg\", S = \"C\", J = ";
    const std::string points = ", mass_points = [\"A\", \"B\"]";
    // 3 kg at 80 of 200 mm: 1.8 kg at A, 1.2 kg at B.
    const auto two = solved(press("", rod + "\"0.02 kg*m^2\", masses = \"two_points\"" + points));
    const auto same = solved(press("", rod + "\"0.0288 kg*m^2\""));
    const auto three = solved(press("", rod + "\"0.02 kg*m^2\", masses = \"three_points\"" + points));
    const auto whole = solved(press("", rod + "\"0.02 kg*m^2\""));
    for (const char* path : {"drive.M", "joints.A.F", "joints.O.x"}) {
      const double size = std::abs(largest(value_of(same, path)).value);
      for (std::size_t k = 0; k < 36; ++k) {
        CHECK(std::abs(value_of(two, path).si[k] - value_of(same, path).si[k]) <= 1e-10 * size);
        CHECK(value_of(three, path).si[k] == value_of(whole, path).si[k]);
      }
    }
  }

  TEST_CASE("wrong point masses are reported") {
    const std::string rod = ", mass = \"3 kg\", J = \"0.02 kg*m^2\", masses = \"two_points\"";
    check_said(press("", rod), "the mass of 'rod' is reduced to points, and they are not named");
    check_said(press("", ", mass = \"3 kg\", mass_points = [\"A\", \"B\"]"),
               "'mass_points' has no effect: the mass of 'rod' is as given");
    check_said(press("", rod + ", S = \"C\", mass_points = [\"A\", \"Q\"]"), "the link 'rod' has no point 'Q'");
    check_said(press("", rod + ", S = \"C\", mass_points = [\"A\", \"A\"]"),
               "a mass is reduced to two different points, and both are 'A'");
    check_said(press("", rod + ", S = \"B\", mass_points = [\"A\", \"C\"]"),
               "the mass centre of 'rod' does not lie between 'A' and 'C'");
    check_said(press("", ", masses = \"two_points\", mass_points = [\"A\", \"B\"]"),
               "the link 'rod' has no mass to reduce to points");
  }

  TEST_CASE("efficiency: useful work over the work of the drive, or the reason for none") {
    const std::string rubbing = "joints.O = { type = \"revolute\", links = [\"crank\", \"ground\"]";
    const auto with_friction = [&](std::string text) {
      return text.insert(text.find(rubbing) + rubbing.size(), ", mu = 0.1, pin_radius = \"20 mm\"");
    };
    // Pushes back while the piston goes out, towards x.
    const std::string half =
        "loads = [{ link = \"slider\", at = \"B\", F_x = \"-1 kN\", F_y = \"0 N\", useful = \"yes\", over = "
        "[[\"0 deg\", 0], [\"180 deg\", 0], [\"190 deg\", 1], [\"350 deg\", 1]] }]\n";
    const std::string even = "loads = [{ link = \"slider\", at = \"B\", F_x = \"-1 kN\", F_y = \"0 N\"";
    const auto smooth = solved(press("", "", half));
    CHECK(number_of(smooth, "drive.efficiency") == doctest::Approx(1.0).epsilon(1e-9));
    CHECK(entry_of(smooth, "drive.efficiency").missing.empty());
    CHECK(entry_of(smooth, "drive.efficiency_back").missing.text() == "the drive moves the load, see drive.efficiency");
    const auto rough = solved(with_friction(press("", "", half)));
    const double useful = mean(value_of(rough, "drive.P_useful")), whole = mean(value_of(rough, "drive.P")),
                 lost = mean(value_of(rough, "drive.P_loss"));
    CHECK(number_of(rough, "drive.efficiency") == doctest::Approx(useful / whole).epsilon(1e-12));
    CHECK(useful + lost == doctest::Approx(whole).epsilon(1e-9));
    CHECK(number_of(rough, "drive.efficiency") < 1.0);

    std::string pulling = half;
    pulling.replace(pulling.find("-1 kN"), 5, "1 kN");
    const auto driven = solved(with_friction(press("", "", pulling)));
    CHECK(std::isnan(number_of(driven, "drive.efficiency")));
    CHECK(number_of(driven, "drive.efficiency_back") ==
          doctest::Approx(mean(value_of(driven, "drive.P")) / mean(value_of(driven, "drive.P_useful"))));
    CHECK(number_of(driven, "drive.efficiency_back") < 1.0);

    const auto none = solved(press("", "", even + ", useful = \"yes\" }]\n"));
    CHECK(entry_of(none, "drive.efficiency").missing.text() == "no mean power");
    const auto unmarked = solved(with_friction(press("", "", even + " }]\n")));
    CHECK(entry_of(unmarked, "drive.efficiency").missing.text() == "no load is marked useful");

    // A load along the motion and a gear that lets nothing back: both push, or, turned the other way, neither.
    const auto worm = [&](const char* moment, const char* back) {
      return solved(head + turn + R"(ground = { O = ["0 mm", "0 mm"], C = ["110 mm", "0 mm"] }
links.worm = { points = { O = ["0 mm", "0 mm"] }, angle = "0 deg" }
links.wheel = { points = { C = ["0 mm", "0 mm"] }, angle = "0 deg" }
joints.O = { type = "revolute", links = ["worm", "ground"] }
joints.C = { type = "revolute", links = ["wheel", "ground"] }
joints.mesh = { type = "gear", links = ["worm", "wheel"], points = ["O", "C"], radii = ["10 mm", "100 mm"], efficiency = 0.4, efficiency_back = )" +
                    back + " }\nloads = [{ link = \"wheel\", useful = \"yes\", M = \"" + moment + "\" }]\n");
    };
    const auto locked = worm("-100 N*m", "-0.5");
    CHECK(number_of(locked, "drive.P") > 0.0);
    CHECK(number_of(locked, "drive.P_useful") < 0.0);
    CHECK(entry_of(locked, "drive.efficiency").missing.text() == "drive and useful loads both supply power");
    CHECK(number_of(worm("100 N*m", "-0.5"), "drive.efficiency") == doctest::Approx(0.4).epsilon(1e-9));
  }

  TEST_CASE("spans of a belt: their difference carries the moment, the slack one has its tension") {
    const auto drive = [](const std::string& type) {
      return solved(
          head + turn + R"(ground = { O = ["0 mm", "0 mm"], Q = ["300 mm", "0 mm"] }
links.small = { points = { O = ["0 mm", "0 mm"] }, angle = "0 deg" }
links.large = { points = { Q = ["0 mm", "0 mm"] }, angle = "0 deg", origin = ["300 mm", "0 mm"] }
joints.O = { type = "revolute", links = ["small", "ground"] }
joints.Q = { type = "revolute", links = ["large", "ground"] }
joints.belt = { type = ")" +
          type + R"(", links = ["small", "large"], points = ["O", "Q"], radii = ["50 mm", "100 mm"], slack = "100 N" }
loads = [{ link = "large", M = "-20 N*m" }]
)");
    };
    const double open = std::asin(50.0 / 300.0), crossed = std::asin(150.0 / 300.0);
    const auto belt = drive("belt");
    CHECK(number_of(belt, "joints.belt.S_tight") == doctest::Approx(300.0).epsilon(1e-9));
    CHECK(number_of(belt, "joints.belt.S_slack") == doctest::Approx(100.0).epsilon(1e-9));
    CHECK(number_of(belt, "joints.belt.wrap") == doctest::Approx(pi - 2.0 * open).epsilon(1e-12));
    CHECK(number_of(belt, "joints.belt.wrap_second") == doctest::Approx(pi + 2.0 * open).epsilon(1e-12));
    const auto other = drive("crossed_belt");
    CHECK(number_of(other, "joints.belt.S_tight") == doctest::Approx(300.0).epsilon(1e-9));
    CHECK(number_of(other, "joints.belt.S_slack") == doctest::Approx(100.0).epsilon(1e-9));
    CHECK(number_of(other, "joints.belt.wrap") == doctest::Approx(pi + 2.0 * crossed).epsilon(1e-12));
    CHECK(number_of(other, "joints.belt.wrap_second") == doctest::Approx(pi + 2.0 * crossed).epsilon(1e-12));
  }

  TEST_CASE("the rounding error of a zero is a zero, and that of a constant a constant") {
    const auto project =
        solved(press(rotating, "", "loads = [{ link = \"slider\", at = \"B\", F_x = \"-1 kN\", F_y = \"0 N\" }]\n"));
    for (const char* path : {"points.B.y", "points.B.v_y", "points.B.a_y", "joints.guide.h", "links.slider.phi"}) {
      CAPTURE(path);
      CHECK(is_constant(value_of(project, path)));
      CHECK(value_of(project, path).si[7] == 0.0);
    }
    CHECK(is_constant(value_of(project, "links.crank.omega")));
    CHECK(is_constant(value_of(project, "frame.F")));
    CHECK_FALSE(is_constant(value_of(project, "points.B.x")));
  }

  TEST_CASE("hodographs of the pins with the largest forces, and of those that are named") {
    const std::string load = "loads = [{ link = \"slider\", at = \"B\", F_x = \"-1 kN\", F_y = \"0 N\" }]\n";
    const auto all = solved(press("", "", load));
    const figure::Figure* figure = figure_of(all, "hodograph-A");
    REQUIRE(figure != nullptr);
    const auto& plans = std::get<figure::Plans>(figure->content);
    REQUIRE(plans.panels.size() == 3);
    CHECK(plans.panels[0].title == "A: crank on rod, in the axes of rod");
    for (const figure::Plan& panel : plans.panels) {
      REQUIRE(panel.traces.size() == 1);
      REQUIRE(panel.traces[0].points.size() == 37);  // closed
      CHECK(panel.traces[0].marks.size() == 12);     // every 30 degrees, the governing one among them or next to them
      for (std::size_t k = 0; k < 36; ++k) {
        const figure::Point f = panel.traces[0].points[k];
        CHECK(std::hypot(f.x, f.y) == doctest::Approx(value_of(all, "joints.A.F").si[k]).epsilon(1e-12));
      }
    }
    // A rod without mass takes no force across.
    for (const figure::Point f : plans.panels[0].traces[0].points) CHECK(std::abs(f.y) < 1e-9);
    for (std::size_t k = 0; k < 36; ++k)
      CHECK(plans.panels[2].traces[0].points[k].x == doctest::Approx(value_of(all, "joints.A.x").si[k]).epsilon(1e-12));

    const auto named = solved(press("", "", load) + "hodographs = [\"guide\"]\n");
    CHECK(figure_of(named, "hodograph-guide") != nullptr);
    CHECK(figure_of(named, "hodograph-A") == nullptr);
    check_said(press("", "", load) + "hodographs = [\"gide\"]\n", "unknown joint 'gide'");
    check_said(press("", "", load) + "hodographs = [\"A\", \"A\"]\n", "the joint 'A' is named twice");
  }

  TEST_CASE("a requested hodograph that cannot be drawn is reported") {
    const std::string note = "No hodograph of 'A': it has no force at any position.";
    CHECK(says(solved(press("", "") + "hodographs = [\"A\"]\n"), note));
    CHECK_FALSE(says(solved(press("", "")), note));
    const std::string load = "loads = [{ link = \"slider\", at = \"B\", F_x = \"-1 kN\", F_y = \"0 N\" }]\n";
    CHECK_FALSE(says(solved(press("", "", load) + "hodographs = [\"A\"]\n"), note));
    const std::string still = replaced(press("", "", load), "positions = 36", "at = [\"30 deg\"]");
    CHECK(says(solved(still + "hodographs = [\"A\"]\n"), "No hodographs: they need more than one position."));
  }

  TEST_CASE("a range that is not a cycle is not called one") {
    const std::string load = "loads = [{ link = \"slider\", at = \"B\", F_x = \"-1 kN\", F_y = \"0 N\" }]\n";
    const auto turned = solved(press("", "", load));
    CHECK(table_of(turned, "Extreme values over the cycle") != nullptr);
    const auto given =
        solved(replaced(press("", "", load), "positions = 36", "at = [\"30 deg\", \"40 deg\", \"60 deg\"]"));
    CHECK(table_of(given, "Extreme values over the cycle") == nullptr);
    CHECK(table_of(given, "Extremes over the positions") != nullptr);
    CHECK(figure_of(given, "reactions")->caption == "Forces in the joints over the positions");
  }

  TEST_CASE("a report cites its sources") {
    const auto cited = [](const project::Project& project) { return project.steps[0]->account().sources; };
    CHECK(cited(solved(press("", ""))).empty());
    const std::string tolerance =
        "tolerances.r = { link = \"crank\", point = \"O\", to = \"A\", t = \"0.1 mm\" }\n"
        "accuracy.end = { of = \"x\", point = \"B\" }\n";
    CHECK(cited(solved(press("", "") + tolerance)) == std::vector<std::string>{"NIST", "Torkia"});
  }

  TEST_CASE("springs, dampers and welds are drawn as such") {
    const auto project = solved(
        press("", "") +
        R"(springs.s = { links = ["slider", "ground"], points = ["B", "Q"], k = "5 N/mm", free = "80 mm", c = "10 N*s/m" }
springs.turn = { links = ["crank", "ground"], k_turn = "2 N*m/rad" }
links.arm = { points = { C = ["0 mm", "0 mm"], E = ["0 mm", "60 mm"] }, angle = "-7 deg" }
joints.C = { type = "rigid", links = ["rod", "arm"] }
)");
    const auto& scheme = std::get<figure::Scheme>(figure_of(project, "first-position")->content);
    REQUIRE(scheme.springs.size() == 1);
    CHECK(scheme.springs[0].pulls);
    CHECK(scheme.springs[0].damps);
    CHECK(scheme.springs[0].to.x == doctest::Approx(0.4));
    REQUIRE(scheme.coils.size() == 1);
    CHECK_FALSE(scheme.coils[0].damps);
    CHECK(std::count_if(scheme.joints.begin(), scheme.joints.end(),
                        [](const auto& j) { return j.pin == figure::Scheme::Pin::welded; }) == 1);
    for (const figure::Figure& figure : project.steps[0]->account().figures)
      CHECK(draw::svg(figure).find("nan") == std::string::npos);
  }

  TEST_CASE("a shaft sized by a torque that is zero somewhere takes the largest") {
    const auto project =
        solved(press("", "", "loads = [{ link = \"slider\", at = \"B\", F_x = \"-1 kN\", F_y = \"0 N\" }]\n") +
               "[b]\ncalculator = \"shaft.torsion\"\nT = \"= a.drive.M\"\ntau_adm = \"20 MPa\"\n");
    CHECK(value_of(project, "drive.M").si[0] == 0.0);
    const Value *d = project.steps[1]->value("d_min"), *u = project.steps[1]->value("u_tau");
    REQUIRE(d != nullptr);
    REQUIRE(u != nullptr);
    CHECK(d->si[0] == 0.0);
    CHECK(u->si[0] == 0.0);
    const double T = std::abs(value_of(project, "drive.M").si[5]);
    CHECK(d->si[5] == doctest::Approx(std::cbrt(16.0 * T / (pi * 20e6))).epsilon(1e-12));
    CHECK(std::isfinite(maximum(*d).value));
  }
}
