// Loads over time, a stroke or by a formula. The moments were recomputed by virtual work: M = -F dx/dphi.
#include "tests/cli/process.hpp"
#include "tests/lib/project/accounts.hpp"
#include "tests/lib/project/texts.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// A slider-crank of 50 and 200 mm with 1 kN against the slider; `load`: further fields of that load.
std::string press(const std::string& load, const std::string& courses) {
  return "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"50 mm\"\nl = \"200 mm\"\n"
         "crank = { speed = \"60 rpm\", positions = 36 }\n"
         "loads = [{ link = \"slider\", at = \"B\", F_x = \"-1 kN\", F_y = \"0 N\"" +
         load + " }]\n" + courses;
}
std::string by_course(const std::string& course) { return press(", course = \"it\"", "courses.it." + course + "\n"); }

double moment(const project::Project& project, int degrees) {
  return entry_of(project, "drive.M").value.si[static_cast<std::size_t>(degrees / 10)];
}

void check_moments(const std::string& text, double at_30, double at_140, double at_250) {
  const auto p = solved(text);
  CHECK(moment(p, 30) == doctest::Approx(at_30).epsilon(1e-9));
  CHECK(moment(p, 140) == doctest::Approx(at_140).epsilon(1e-9));
  CHECK(moment(p, 250) == doctest::Approx(at_250).epsilon(1e-9));
}

}  // namespace

TEST_SUITE("courses") {
  TEST_CASE("without a load curve the load is constant") {
    check_moments(press("", ""), -30.455447256929, -25.903286517368, 42.851539553183);
  }
  TEST_CASE("a load over the stroke follows the position of the slide") {
    const std::string course = "over_stroke = [[\"150 mm\", 0], [\"250 mm\", 1]]";
    check_moments(by_course(course), -27.937579250474, -2.3568204404747, 11.699233925168);
    check_moments(by_course(course) + "courses.it.stroke_of = \"guide\"\n", -27.937579250474, -2.3568204404747,
                  11.699233925168);
    check_moments(by_course("share_of_s = \"(150 mm)/s\""), -18.898223651100, -24.421927564670, 36.253053185028);
  }
  TEST_CASE("a load by a formula of the crank angle") {
    check_moments(by_course("share_of_phi = \"0.5 - 0.5*cos(phi)\""), -2.0401281244057, -22.873177606259,
                  28.753814629330);
  }
  TEST_CASE("a load over the time") {
    check_moments(by_course("share_of_t = \"exp(-t/(2 s))\""), -29.212543920390, -21.325966372707, 30.280966631847);
    const auto p = solved(by_course("over_time = [[\"0 s\", 0], [\"0.5 s\", 1], [\"1 s\", 0]]"));
    CHECK(moment(p, 30) == doctest::Approx(-30.455447256929 / 6.0).epsilon(1e-9));
  }
  TEST_CASE("beyond the points of a load curve its mechanism is not covered") {
    const auto p = solved(by_course("over_stroke = [[\"160 mm\", 0], [\"250 mm\", 1]]"));
    CHECK(verdict_of(p, "course_it").state == account::State::not_covered);
    const auto whole = solved(by_course("over_stroke = [[\"150 mm\", 0], [\"250 mm\", 1]]"));
    CHECK(verdict_of(whole, "course_it").state == account::State::pass);
  }
  TEST_CASE("a thousand factors over the crank angle are as good as three") {
    std::string shares;
    for (int k = 0; k < 1000; ++k)
      shares += (k == 0 ? "[\"" : ", [\"") + std::to_string(0.36 * k) + " deg\", " + std::to_string(k % 7) + "]";
    CHECK(told(press(", over = [" + shares + "]", "")).issues.empty());
  }
  TEST_CASE("rows may be in a file next to the project") {
    const Desk desk;
    desk.put("p.toml", by_course("over_stroke = { file = \"diagram.csv\" }"));
    const std::string inside = by_course("over_stroke = [[\"15 cm\", 0], [\"20 cm\", 0.4], [\"25 cm\", 1]]");
    desk.put("inside.toml", inside);
    for (const char* rows :
         {"s [cm], share\n15, 0 # empty\n20, 0.4\n\n25, 1\n", "share; s [mm]\n0; 150\n0.4; 200\n1; 250\n",
          "s\tshare [-]\n15 cm\t0\n20 cm\t0.4\n25 cm\t1\n"}) {
      desk.put("diagram.csv", rows);
      const Ran ran = desk.run({"run", "p.toml"}), same = desk.run({"run", "inside.toml"});
      CHECK(ran.error == "");
      CHECK(ran.out == same.out);
    }
  }
  TEST_CASE("a file of rows is not overwritten by an output") {
    const Desk desk;
    const std::string rows = "s [cm], share\n15, 0\n20, 0.4\n25, 1\n";
    desk.put("p.toml", by_course("over_stroke = { file = \"diagram.csv\" }"));
    desk.put("diagram.csv", rows);
    const Ran ran = desk.run({"run", "p.toml", "--csv", "./diagram.csv"});
    CHECK(ran.code == 2);
    CHECK(ran.error.find("'./diagram.csv' is read by the project: nothing is written") != std::string::npos);
    CHECK(desk.get("diagram.csv") == rows);
  }
  TEST_CASE("errors in a file of rows are reported") {
    const Desk desk;
    desk.put("p.toml", by_course("over_stroke = { file = \"diagram.csv\" }"));
    const auto said = [&](const std::string& rows) {
      desk.put("diagram.csv", rows);
      return desk.run({"run", "p.toml"}).error;
    };
    CHECK(desk.run({"run", "p.toml"}).error.find("file 'diagram.csv' does not exist or cannot be read") !=
          std::string::npos);
    CHECK(said("s [mm], share\n").find("'diagram.csv' has no rows") != std::string::npos);
    CHECK(said("s [mm], share\n150, 0\n250\n").find("line 3 of 'diagram.csv' does not have as many cells") !=
          std::string::npos);
    CHECK(said("s [mm], part\n150, 0\n250, 1\n").find("'part' is not a valid key here") != std::string::npos);
    CHECK(said("s [kg], share\n150, 0\n250, 1\n").find("a mass") != std::string::npos);
  }
  TEST_CASE("a list without an upper bound still refuses what fills the memory") {
    const Desk desk;
    std::string rows = "s [mm], share\n";
    for (int k = 0; k <= 100000; ++k) rows += std::to_string(k) + ", 1\n";
    desk.put("diagram.csv", rows);
    desk.put("p.toml", by_course("over_stroke = { file = \"diagram.csv\" }"));
    CHECK(desk.run({"run", "p.toml"}).error.find("at most 100000 over_stroke; there are 100001") != std::string::npos);
  }
  TEST_CASE("what a load curve cannot express is reported") {
    CHECK(first_error(by_course("stroke_of = \"guide\"")) ==
          "a load curve has its shares in one of five forms, and 'it' in none");
    CHECK(first_error(by_course("over_stroke = [[\"250 mm\", 0], [\"150 mm\", 1]]")) ==
          "the places of 'over_stroke' must increase");
    CHECK(first_error(by_course("over_time = [[\"0 s\", 1]]")) == "one point is not a load curve");
    CHECK(first_error(by_course("over_stroke = [[\"0 mm\", 0], [\"1 m\", 1]]\ncourses.it.stroke_of = \"A\"")) ==
          "'A' is not a cylinder, prismatic joint or slot");
    CHECK(first_error(press(", course = \"ti\"", "courses.it.share_of_phi = \"phi\"\n")) == "unknown load curve 'ti'");
    CHECK(first_error(press("", "courses.it.share_of_phi = \"1 - 0.1*phi\"\n")) == "no load follows the course 'it'");
    CHECK(first_error(replaced(by_course("share_of_t = \"exp(-t/(2 s))\""), "speed = \"60 rpm\", ", "")) ==
          "'it' is a function of time, but the motion is not given over time");
  }
}
