#include "lib/project/series_choice.hpp"

#include "lib/project/unknown_series.hpp"
#include "tests/lib/project/texts.hpp"

using namespace loadpath;
using namespace loadpath::test;
using project::SeriesChoice;

namespace {

const std::string press = R"([press]
calculator = "mechanism.planar"
template = "slider_crank"
r = "50 mm"
l = "200 mm"
crank = { speed = "60 rpm", positions = 12 }
links.slider.mass = "2 kg"
)";

/// Message for a pattern that chooses nothing; empty where it chooses.
std::string said(const std::string& text, const std::string& pattern) {
  const auto faults = project::unknown_series(SeriesChoice({pattern}), told(text).project);
  return faults.empty() ? "" : faults[0].message.text() + "; " + faults[0].hint.text();
}

bool holds(const std::string& pattern, const std::string& path) { return SeriesChoice({pattern}).holds("press", path); }

}  // namespace

TEST_SUITE("series choice") {
  TEST_CASE("no pattern chooses every series") { CHECK(SeriesChoice().holds("press", "drive.M")); }

  TEST_CASE("a name chooses itself, with its step in front or without") {
    CHECK(holds("drive.M", "drive.M"));
    CHECK(holds("press.drive.M", "drive.M"));
    CHECK_FALSE(holds("drive.M", "drive.M_red"));
    CHECK_FALSE(holds("lever.drive.M", "drive.M"));
    CHECK_FALSE(holds("M", "drive.M"));
    CHECK_FALSE(holds("", "drive.M"));
  }

  TEST_CASE("* matches any characters, none and points among them, ? matches one") {
    CHECK(holds("*", "drive.M"));
    CHECK(holds("links.*.N", "links.rod.N"));
    CHECK(holds("links.*", "links.rod.N"));
    CHECK(holds("*.N", "links.rod.N"));
    CHECK(holds("press.*", "links.rod.N"));
    CHECK(holds("drive.M*", "drive.M"));
    CHECK(holds("points.?.v_*", "points.A.v_x"));
    CHECK(holds("*a*a*", "banana"));
    CHECK_FALSE(holds("*.N", "links.rod.N_front"));
    CHECK_FALSE(holds("points.?.v_x", "points.AB.v_x"));
    CHECK_FALSE(holds("drive.M?", "drive.M"));
    CHECK_FALSE(holds("*a*b*a", "banana"));
  }

  TEST_CASE("several patterns choose all series that one of them matches") {
    const SeriesChoice choice({"drive.M", "links.*.N"});
    CHECK(choice.holds("press", "links.rod.N"));
    CHECK(choice.holds("press", "drive.M"));
    CHECK_FALSE(choice.holds("press", "drive.P"));
  }

  TEST_CASE("a pattern that matches no series is reported with the nearest") {
    CHECK(said(press, "drive.M").empty());
    CHECK(said(press, "press.*.N").empty());
    CHECK(said(press, "drive.m") == "unknown series 'drive.m'; did you mean 'drive.M'?");
    CHECK(said(press, "pres.drive.M") == "unknown series 'pres.drive.M'; did you mean 'press.drive.M'?");
    CHECK(said(press, "link.*.N") == "unknown series 'link.*.N'; did you mean 'links.*.N'?");
    CHECK(said(press, "links.rot*.N") == "unknown series 'links.rot*.N'; did you mean 'links.rod.N'?");
    CHECK(said(press, "joints.*.FF") == "unknown series 'joints.*.FF'; did you mean 'joints.*.F'?");
    CHECK(said(press, "") == "unknown series ''; available: drive.*, joints.*, shafts.*, links.*, points.*, frame.*");
    CHECK(said(press, "zzzzzzzzz") ==
          "unknown series 'zzzzzzzzz'; available: drive.*, joints.*, shafts.*, links.*, points.*, frame.*");
  }

  TEST_CASE("a single value is not a series, and a step without series is reported") {
    CHECK(said(press, "joints.guide.stroke") ==
          "'joints.guide.stroke' is one value, not a series; leave it out: JSON lists every value");
    const std::string shaft = axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\n";
    CHECK(said(shaft, "*") == "'*' is one value, not a series; leave it out: JSON lists every value");
    CHECK(said(shaft, "drive.M") == "unknown series 'drive.M'; every result is one value");
  }
}
