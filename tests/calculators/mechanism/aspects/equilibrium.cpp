// Positions of equilibrium: printed ones, all of those that a fine static cycle shows, and what is refused.
#include "tests/lib/project/accounts.hpp"
#include "tests/lib/project/texts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

using namespace loadpath;
using namespace loadpath::test;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// A ladder between two guides, held by a spring: [Hibbeler-11-5], drawn at theta = 0.
std::string ladder(const std::string& crank, const std::string& more = "", const std::string& joint = "") {
  return R"([a]
calculator = "mechanism.planar"
analysis = "equilibrium"
gravity = "9.81 m/s^2"
crank = { joint = "A")" +
         crank + R"( }
ground = { C = ["0 m", "0.9 m"], B0 = ["0 m", "0 m"] }
links.top = { points = { A = ["0 m", "0.6 m"] } }
links.bar = { points = { A = ["0 m", "0.6 m"], B = ["0 m", "0 m"] }, mass = "10 kg" }
links.foot = { points = { B = ["0 m", "0 m"] } }
joints.wall = { type = "prismatic", links = ["top", "ground"], points = ["A", "C"], direction = "90 deg")" +
         joint + R"( }
joints.A = { type = "revolute", links = ["bar", "top"] }
joints.B = { type = "revolute", links = ["bar", "foot"] }
joints.floor = { type = "prismatic", links = ["foot", "ground"], points = ["B", "B0"], direction = "0 deg" }
springs.S = { links = ["ground", "top"], points = ["C", "A"], k = "200 N/m", free = "0.3 m" }
)" + more;
}

std::vector<double> series(const project::Project& project, const std::string& path) {
  return entry_of(project, path.substr(path.find('.') + 1)).value.si;
}

/// A four-bar linkage with a heavy coupler, a spring and a load, over all its positions.
std::string four_bar(std::mt19937& random, const std::string& analysis, int positions) {
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  const auto text = [](double value) { return std::to_string(value); };
  std::string s = "[a]\ncalculator = \"mechanism.planar\"\ntemplate = \"four_bar\"\nanalysis = \"" + analysis + "\"\n";
  s += "a = \"" + text(between(30, 60)) + " mm\"\nb = \"" + text(between(140, 180)) + " mm\"\nc = \"" +
       text(between(110, 140)) + " mm\"\nd = \"" + text(between(150, 170)) + " mm\"\n";
  s += "gravity = \"9.81 m/s^2\"\ncrank = { positions = " + std::to_string(positions) + " }\n";
  s += "links.coupler.mass = \"" + text(between(0, 5)) + " kg\"\nlinks.rocker.mass = \"" + text(between(0, 5)) +
       " kg\"\n";
  s += "springs.S = { links = [\"ground\", \"rocker\"], points = [\"O\", \"B\"], k = \"" + text(between(0, 2)) +
       " N/mm\", free = \"" + text(between(50, 200)) + " mm\" }\n";
  s += "[[a.loads]]\nlink = \"crank\"\nM = \"" + text(between(-1, 1)) + " N*m\"\n";
  return s;
}

}  // namespace

TEST_SUITE("mechanism equilibrium") {
  TEST_CASE("a ladder and a spring: printed positions, stiffness and stability") {
    const auto turn = solved(ladder(", positions = 72"));
    const auto at = series(turn, "a.equilibrium.phi");
    REQUIRE(at.size() == 4);
    const double theta = std::acos(1.0 - 98.1 / (2.0 * 200.0 * 0.6));  // printed 53.8 deg
    CHECK(std::abs(at[0]) < 1e-9);
    CHECK(at[1] == doctest::Approx(theta));
    CHECK(at[2] == doctest::Approx(180.0 * degree));
    CHECK(at[3] == doctest::Approx(360.0 * degree - theta));
    const auto k = series(turn, "a.equilibrium.k");
    CHECK(k[0] == doctest::Approx(-29.43).epsilon(1e-5));  // printed -29.4
    CHECK(k[1] == doctest::Approx(46.9).epsilon(2e-3));    // printed
    CHECK(value(turn, "a.equilibrium.stable") == doctest::Approx(theta));
    const account::Table* table = table_of(turn, "Positions of equilibrium");
    REQUIRE(table != nullptr);
    CHECK(text_of(table->rows[0][1]) == "unstable");
    CHECK(text_of(table->rows[1][1]) == "stable");
    for (const double M : series(turn, "a.drive.M")) CHECK(std::abs(M) < 1e-8);
  }

  TEST_CASE("only the given range is searched, and a load moves the position") {
    const auto part = solved(ladder(R"(, at = ["10 deg", "80 deg"])"));
    CHECK(series(part, "a.equilibrium.phi").size() == 1);
    CHECK(series(part, "a.joints.B.F").size() == 1);
    const auto loaded = solved(ladder(R"(, at = ["10 deg", "80 deg"])", R"([[a.loads]]
link = "top"
at = "A"
F_y = "-50 N"
F_x = "0 N"
)"));
    // k (l - l cos(theta)) = W/2 + 50 N
    const double theta = std::acos(1.0 - (49.05 + 50.0) / (200.0 * 0.6));
    CHECK(series(loaded, "a.equilibrium.phi")[0] == doctest::Approx(theta));
  }

  TEST_CASE("random linkages: as many positions as sign changes of a static cycle of 3,600, at the same places") {
    std::mt19937 random(7);
    int found = 0;
    for (int n = 0; n < 25; ++n) {
      CAPTURE(n);
      std::mt19937 same = random;
      const auto fine = solved(four_bar(same, "static", 3600));
      const auto M = series(fine, "a.drive.M");
      std::vector<double> zeros;
      for (std::size_t k = 0; k < M.size(); ++k) {
        const double next = M[(k + 1) % M.size()];
        if (M[k] == 0.0 || M[k] * next < 0.0)
          zeros.push_back((static_cast<double>(k) + (M[k] == 0.0 ? 0.0 : M[k] / (M[k] - next))) * 0.1 * degree);
      }
      const auto project = told(four_bar(random, "equilibrium", 48)).project;
      if (zeros.empty()) {
        CHECK(project.value("a.equilibrium.phi") == nullptr);
        continue;
      }
      const auto at = series(project, "a.equilibrium.phi");
      REQUIRE(at.size() == zeros.size());
      for (std::size_t k = 0; k < at.size(); ++k) CHECK(std::abs(at[k] - zeros[k]) < 1e-5);
      const auto stiffness = series(project, "a.equilibrium.k");
      for (std::size_t k = 0; k < at.size(); ++k) CHECK(stiffness[k] * stiffness[(k + 1) % at.size()] < 0.0);
      found += static_cast<int>(at.size());
    }
    CHECK(found > 30);
  }

  TEST_CASE("a linkage that cannot revolve is searched on both sides of its gap") {
    const std::string bar =
        replaced(replaced(bar_that_cannot_turn(72), "speed = \"60 rpm\", ", ""), "calculator = \"mechanism.planar\"\n",
                 "calculator = \"mechanism.planar\"\nanalysis = \"equilibrium\"\n");
    const std::string heavy =
        replaced(bar, "D = [\"150 mm\", \"0 mm\"] }\n[bar.joints]",
                 "D = [\"150 mm\", \"0 mm\"] }\n[[bar.springs]]\nname = \"S\"\nlinks = "
                 "[\"ground\", \"c\"]\nk_turn = \"30 N*m/rad\"\nfree_angle = \"0 deg\"\n[bar.joints]");
    const Told found = told(heavy);
    REQUIRE(found.issues.empty());
    // The moment of the spring on its link balances the load, 5 N m: at one angle of the link, in each assembly
    // reached.
    const auto at = series(found.project, "bar.equilibrium.phi");
    CHECK(!at.empty());
    for (const double M : entry_of(found.project, "drive.M").value.si) CHECK(std::abs(M) < 1e-6);
  }

  TEST_CASE("no position, no load, friction, a speed, two drives: reported, and nothing is solved") {
    CHECK(issues_of(ladder(R"(, at = ["60 deg", "90 deg"])")).find("no position of equilibrium: it needs at least") !=
          std::string::npos);
    CHECK(issues_of(ladder(R"(, speed = "60 rpm")")).find("the crank is at rest") != std::string::npos);
    CHECK(issues_of(ladder(", positions = 72", "", R"(, mu = 0.1, guide_length = "100 mm", guide_width = "0 mm")"))
              .find("with friction") != std::string::npos);
    CHECK(issues_of(ladder(R"(, at = ["50 deg"])")).find("between several positions") != std::string::npos);
    std::string weightless = ladder(", positions = 72");
    weightless.replace(weightless.find("gravity = \"9.81 m/s^2\"\n"), 23, "");
    weightless.erase(weightless.find("springs.S"));
    CHECK(issues_of(weightless).find("equilibrium at every position") != std::string::npos);
  }
}
