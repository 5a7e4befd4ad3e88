// Tolerances and clearance in a project: errors against the closed form of the slider-crank, and messages for wrong
// input.
#include "lib/quantity/series.hpp"
#include "tests/lib/project/texts.hpp"

#include <array>
#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

constexpr double r = 0.05, l = 0.2, F = 1000.0;

const std::string press = R"(
[press]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "60 rpm", start = "20 deg", positions = 8 }
ground = { O = ["0 mm", "0 mm"], G = ["0 mm", "0 mm"] }
links.crank = { points = { O = ["0 mm", "0 mm"], A = ["50 mm", "0 mm"] }, angle = "30 deg" }
links.rod = { points = { A = ["0 mm", "0 mm"], B = ["200 mm", "0 mm"] }, angle = "-7 deg" }
links.slider = { points = { B = ["0 mm", "0 mm"], T = ["30 mm", "0 mm"] }, angle = "0 deg" }
joints.O = { type = "revolute", links = ["crank", "ground"] }
joints.A = { type = "revolute", links = ["crank", "rod"] }
joints.B = { type = "revolute", links = ["rod", "slider"] }
joints.guide = { type = "prismatic", links = ["slider", "ground"], points = ["B", "G"] }
loads = [{ link = "slider", at = "B", F_x = "-1 kN", F_y = "0 N" }]
)";
const std::string crank_and_rod =
    "tolerances.crank = { link = \"crank\", point = \"O\", to = \"A\", t = \"0.02 mm\" }\n"
    "tolerances.rod = { link = \"rod\", point = \"A\", to = \"B\", t = \"0.05 mm\", sigmas = 2 }\n";
const std::string of_piston = "accuracy.place = { of = \"x\", point = \"B\" }\n";

double root(double crank, double rod, double phi) { return std::sqrt(rod * rod - std::pow(crank * std::sin(phi), 2)); }
/// Crank moment against the load, by the principle of virtual work.
double moment(double crank, double rod, double phi) {
  const double s = std::sin(phi), c = std::cos(phi);
  return -F * (crank * s + crank * crank * s * c / root(crank, rod, phi));
}

const Value& value_of(const project::Project& project, const std::string& path) {
  const Value* value = project.steps[0]->value(path);
  CAPTURE(path);
  REQUIRE(value != nullptr);
  return *value;
}

template <class Check>
void at_every_position(const project::Project& project, const std::string& name, const Check& check) {
  const Value &worst = value_of(project, "accuracy." + name + ".worst"),
              &statistical = value_of(project, "accuracy." + name + ".statistical");
  REQUIRE(worst.si.size() == 8);
  for (std::size_t k = 0; k < worst.si.size(); ++k) check(worst.signature.axis->at[k], worst.si[k], statistical.si[k]);
}

}  // namespace

TEST_SUITE("mechanism accuracy") {
  TEST_CASE("lengths of crank and rod: worst case and statistical error of the piston position by hand") {
    at_every_position(solved(press + crank_and_rod + of_piston), "place", [](double phi, double worst, double error) {
      const double s = std::sin(phi), by_r = (std::cos(phi) - r * s * s / root(r, l, phi)) * 2e-5,
                   by_l = l / root(r, l, phi) * 5e-5;
      CHECK(worst == doctest::Approx(std::abs(by_r) + by_l).epsilon(1e-9));
      CHECK(error == doctest::Approx(3.0 * std::hypot(by_r / 3.0, by_l / 2.0)).epsilon(1e-9));
    });
  }

  TEST_CASE("the effort of the drive follows the derivative of the closed form") {
    const std::string wanted = "accuracy.M = { of = \"drive\" }\n";
    at_every_position(solved(press + crank_and_rod + wanted), "M", [](double phi, double worst, double) {
      const double h = 1e-6;
      const double by_r = (moment(r + h, l, phi) - moment(r - h, l, phi)) / (2.0 * h) * 2e-5;
      const double by_l = (moment(r, l + h, phi) - moment(r, l - h, phi)) / (2.0 * h) * 5e-5;
      CHECK(worst == doctest::Approx(std::abs(by_r) + std::abs(by_l)).epsilon(1e-6));
    });
  }

  TEST_CASE("a point that is not a joint follows its own coordinate, and nothing else does") {
    const auto project =
        solved(press + "tolerances.T = { of = \"x\", link = \"slider\", point = \"T\", t = \"0.1 mm\" }\n" + of_piston +
               "accuracy.tool = { of = \"x\", point = \"T\" }\n");
    at_every_position(project, "tool",
                      [](double, double worst, double) { CHECK(worst == doctest::Approx(1e-4).epsilon(1e-12)); });
    at_every_position(project, "place", [](double, double worst, double) { CHECK(worst == 0.0); });
  }

  TEST_CASE("a bearing on the ground, the angle of the crank, a mass without influence at rest") {
    const auto project =
        solved(press + "tolerances.O = { of = \"y\", link = \"ground\", point = \"O\", t = \"0.1 mm\" }\n" + of_piston);
    at_every_position(project, "place", [](double phi, double worst, double) {
      CHECK(worst == doctest::Approx(std::abs(r * std::sin(phi)) / root(r, l, phi) * 1e-4).epsilon(1e-9));
    });
    const auto turned = solved(press + "tolerances.O = { of = \"drive\", joint = \"O\", t_angle = \"0.1 deg\" }\n" +
                               "accuracy.crank = { of = \"angle\", link = \"crank\" }\n");
    at_every_position(turned, "crank", [](double, double worst, double) {
      CHECK(worst == doctest::Approx(0.1 * pi / 180.0).epsilon(1e-12));
    });
    const auto heavy =
        solved(press + "tolerances.m = { of = \"mass\", link = \"slider\", t_mass = \"1 kg\" }\n" + of_piston);
    at_every_position(heavy, "place", [](double, double worst, double) { CHECK(worst == 0.0); });
  }

  TEST_CASE("clearance in a pin counts half its diameter along the rod, in either direction") {
    std::string text = press + "accuracy.place = { of = \"x\", point = \"B\", link = \"slider\" }\n";
    const std::string pin = "links = [\"rod\", \"slider\"]";
    text.insert(text.find(pin) + pin.size(), ", clearance = \"0.1 mm\"");
    at_every_position(solved(text), "place", [](double phi, double worst, double error) {
      CHECK(worst == doctest::Approx(0.5e-4 * l / root(r, l, phi)).epsilon(1e-9));
      CHECK(error == doctest::Approx(worst).epsilon(1e-12));
    });
  }

  TEST_CASE("a relative tolerance of a coefficient of friction is the same as its half width") {
    std::string text = press + "accuracy.M = { of = \"drive\" }\n";
    const std::string pin = "joints.A = { type = \"revolute\"";
    text.insert(text.find(pin) + pin.size(), ", mu = 0.2, pin_radius = \"10 mm\"");
    const auto half = solved(text + "tolerances.mu = { of = \"mu\", joint = \"A\", t_part = 0.01 }\n");
    const auto whole = solved(text + "tolerances.mu = { of = \"mu\", joint = \"A\", t_part = 0.02 }\n");
    const Value &a = value_of(half, "accuracy.M.worst"), &b = value_of(whole, "accuracy.M.worst");
    for (std::size_t k = 0; k < a.si.size(); ++k) {
      CHECK(a.si[k] > 0.0);
      CHECK(b.si[k] == doctest::Approx(2.0 * a.si[k]).epsilon(1e-9));
    }
  }

  TEST_CASE("the report names the dimension that contributes most") {
    const auto project = solved(press + crank_and_rod + of_piston);
    const account::Table* found = nullptr;
    for (const account::Block& block : project.steps[0]->account().blocks) {
      const auto* table = std::get_if<account::Table>(&block);
      if (table != nullptr && table->caption.text() == "Errors due to tolerances and clearance") found = table;
    }
    REQUIRE(found != nullptr);
    REQUIRE(found->rows.size() == 1);
    CHECK(std::get<Message>(found->rows[0][0]).text() == "place: position of B along x");
    CHECK(std::get<Message>(found->rows[0][5]).text().starts_with("rod, 7"));
  }

  TEST_CASE("wrong tolerances and outputs are reported") {
    struct Wrong {
      std::string text, message;
    };
    const std::string good = crank_and_rod + of_piston;
    const std::array wrong{
        Wrong{crank_and_rod, "the tolerances have no effect: no output is named under 'accuracy'"},
        Wrong{of_piston, "no tolerance or clearance is given, so outputs have no error"},
        Wrong{good + "tolerances.x = { link = \"rod\", point = \"A\", t = \"1 mm\" }\n",
              "the tolerance 'x' of length needs 'to'"},
        Wrong{good + "tolerances.x = { link = \"rdo\", point = \"A\", to = \"B\", t = \"1 mm\" }\n",
              "unknown link 'rdo'"},
        Wrong{good + "tolerances.x = { link = \"rod\", point = \"A\", to = \"C\", t = \"1 mm\" }\n",
              "the link 'rod' has no point 'C'"},
        Wrong{good + "tolerances.x = { link = \"rod\", point = \"A\", to = \"A\", t = \"1 mm\" }\n",
              "'A' is measured from itself"},
        Wrong{good + "tolerances.x = { link = \"rod\", point = \"A\", to = \"B\" }\n",
              "the tolerance 'x' needs its half width 't'"},
        Wrong{good + "tolerances.x = { link = \"rod\", point = \"A\", to = \"B\", t_angle = \"1 deg\" }\n",
              "'t_angle' is not a valid tolerance of length"},
        Wrong{good + "tolerances.x = { of = \"mass\", link = \"rod\", t_mass = \"1 g\", t_part = 0.1 }\n",
              "the tolerance 'x' has two half widths"},
        Wrong{good + "tolerances.x = { of = \"mass\", link = \"ground\", t_mass = \"1 g\" }\n",
              "the ground does not move: its mass has no effect"},
        Wrong{good + "tolerances.x = { of = \"radius\", joint = \"A\", t = \"1 mm\" }\n",
              "the joint 'A' of type revolute has no radius"},
        Wrong{good + "tolerances.x = { of = \"mu\", joint = \"A\", t_part = 0.1 }\n",
              "the joint 'A' of type revolute has no mu"},
        Wrong{good + "tolerances.x = { of = \"drive\", joint = \"A\", t = \"1 mm\" }\n", "the joint 'A' has no drive"},
        Wrong{good + "tolerances.x = { of = \"rate\", spring = \"s\", t_part = 0.1 }\n", "unknown spring 's'"},
        Wrong{good + "tolerances.x = { of = \"mass\", link = \"rod\", joint = \"A\", t_part = 0.1 }\n",
              "a tolerance of mass has no 'joint'"},
        Wrong{good + "accuracy.x = { of = \"x\" }\n", "the output 'x' of kind x needs 'point'"},
        Wrong{good + "accuracy.x = { of = \"y\", point = \"Q\" }\n", "unknown moving point 'Q'"},
        Wrong{good + "accuracy.x = { of = \"y\", point = \"T\", link = \"rod\" }\n", "the link 'rod' has no point 'T'"},
        Wrong{good + "accuracy.x = { of = \"y\", point = \"O\", link = \"ground\" }\n",
              "a point of the ground does not move"},
        Wrong{good + "accuracy.x = { of = \"angle\", link = \"ground\" }\n", "the ground does not turn"},
        Wrong{good + "accuracy.x = { of = \"force\" }\n", "the output 'x' of kind force needs 'joint'"},
        Wrong{good + "accuracy.x = { of = \"drive\", joint = \"B\" }\n", "the joint 'B' has no drive"}};
    for (const Wrong& w : wrong) {
      const auto issues = told(press + w.text).issues;
      CAPTURE(w.message);
      REQUIRE(issues.size() == 1);
      CHECK(issues[0].message.text() == w.message);
      CHECK(issues[0].place.line > 0);
    }
    std::string text = press;
    const std::string guide = "points = [\"B\", \"G\"]";
    const auto of_guide = told(text.insert(text.find(guide), "clearance = \"0.1 mm\", ") + of_piston).issues;
    REQUIRE(of_guide.size() == 1);
    CHECK(of_guide[0].message.text() ==
          "'clearance' belongs to pins: revolute joints, and 'guide' is of type prismatic");
  }
}
