// The mechanism that moves in a report, in a real browser: it moves, and the numbers under it are those of --json.
#include "lib/draw/motion/motion.hpp"
#include "lib/draw/motion/numbers.hpp"
#include "tests/browser/browser.hpp"
#include "tests/cli/process.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

namespace json = boost::json;

/// The page after its scripts have run.
std::string opened(const Desk& desk, const std::string& browser, const std::string& page) {
  const std::string root = "$([ \"$(id -u)\" = 0 ] && echo --no-sandbox)";  // its sandbox refuses root
  const Ran ran =
      desk.shell("timeout 600 '" + browser + "' --headless " + root +
                 " --disable-gpu --disable-quic --no-first-run --disable-background-networking "
                 "--disable-component-update --disable-sync --user-data-dir=\"$PWD/profile\" --dump-dom 'file://" +
                 desk.folder().string() + "/" + page + "'");
  REQUIRE(ran.code == 0);
  return ran.out;
}

std::string after(const std::string& text, const std::string& mark, char end) {
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) return "no " + mark;
  const std::size_t from = at + mark.size();
  return text.substr(from, text.find(end, from) - from);
}

std::string number_shown(const std::string& page, std::size_t n) {
  return after(page, "data-number=\"" + std::to_string(n) + "\">", '<');
}

std::vector<double> column(const json::value& of) {
  std::vector<double> values;
  for (const json::value& v : of.as_array()) values.push_back(v.to_number<double>());
  return values;
}

/// The step of the mechanism as --json gives it.
json::object lever(const std::string& text) { return json::parse(text).at("steps").as_array().at(0).as_object(); }

/// The first path from `mark` on, with what moves it.
std::string drawn_at(const std::string& page, const std::string& mark) {
  const std::size_t at = page.find(mark);
  REQUIRE(at != std::string::npos);
  return page.substr(at, page.find("\"></path>", at) - at);
}

}  // namespace

TEST_SUITE("moving report in a browser") {
  TEST_CASE("the mechanism moves with the slider, and the numbers below are those of --json at that angle") {
    const std::string chromium = browser_there();
    if (chromium.empty()) {
      MESSAGE("skipped: no Chromium");
      return;
    }
    const Desk desk;
    const Ran ran =
        desk.run({"run", LOADPATH_ROOT "/examples/slotted-lever/project.toml", "--json", "--report", "r.html"});
    REQUIRE(ran.code == 0);
    const json::object step = lever(ran.out);
    const auto angles = column(step.at("axes").as_object().begin()->value().at("at"));
    std::vector<std::string> drawn;
    for (const std::string degrees : {"-60", "90", "203"}) {
      CAPTURE(degrees);
      const std::string page = opened(desk, chromium, "r.html#position=" + degrees);
      CHECK(after(page, "data-axis=\"\">", '<') == draw::printed(degrees));
      const auto at = static_cast<std::size_t>(
          std::find_if(angles.begin(), angles.end(),
                       [&](double a) { return std::abs(a * 57.29577951308232 - std::stod(degrees)) < 1e-6; }) -
          angles.begin());
      REQUIRE(at < angles.size());
      std::size_t n = 0;
      for (const char* path : {"drive.M", "joints.O.F", "joints.B.F", "joints.A.F"}) {
        CAPTURE(path);
        const auto& result = step.at("results").at(path);
        const figure::Motion::Number number{"", "", result.at("unit").as_string().c_str(), column(result.at("values"))};
        CHECK(number_shown(page, n++) == draw::printed(draw::number_text(number, at)));
      }
      CHECK(page.find("aria-valuetext=\"" + degrees + "°\"") != std::string::npos);
      const std::string plan = page.substr(page.find("data-plan=\"1\" visibility=\"visible\""));
      drawn.push_back(drawn_at(page, "data-carried=\"0 0"));
      drawn.push_back(drawn_at(page, "data-force=\"2\""));
      drawn.push_back(drawn_at(plan, "data-side=\"1\""));
    }
    for (std::size_t i = 0; i < 3; ++i) {  // a part, an arrow, a side of the force plan
      CHECK(drawn[i] != drawn[i + 3]);
      CHECK(drawn[i + 3] != drawn[i + 6]);
    }
  }

  TEST_CASE("without scripts the page is a picture with its numbers, and has no dead controls") {
    const Desk desk;
    REQUIRE(desk.run({"run", LOADPATH_ROOT "/examples/slotted-lever/project.toml", "--report", "r.html"}).code == 0);
    const std::string page = desk.get("r.html");
    CHECK(page.find("<div class=controls hidden>") != std::string::npos);
    CHECK(after(page, "data-axis>", '<') == "203");
    const std::string chromium = browser_there();
    if (chromium.empty()) {
      MESSAGE("skipped: no Chromium");
      return;
    }
    const std::string run = opened(desk, chromium, "r.html");
    CHECK(after(run, "<div class=\"controls\"", '>').empty());
    CHECK(after(run, "data-axis=\"\">", '<') == "203");
  }

  TEST_CASE("a point of a sweep is described in the page as in the line of its table") {
    const std::string chromium = browser_there();
    if (chromium.empty()) {
      MESSAGE("skipped: no Chromium");
      return;
    }
    const Desk desk;
    desk.put("a.toml",
             "[shaft]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nd = { from = \"30 mm\", to = \"60 mm\", "
             "count = 7 }\nT = { from = \"100 N*m\", to = \"400 N*m\", count = 4 }\n");
    REQUIRE(desk.run({"sweep", "a.toml", "--quiet", "--report", "r.html", "--csv", "r.csv"}).code == 0);
    CHECK(desk.get("r.html").find("<div class=readout hidden>") != std::string::npos);
    const std::string page = opened(desk, chromium, "r.html#point=13");  // 45 mm, 200 N*m
    CHECK(page.find("<div class=\"readout\">") != std::string::npos);
    CHECK(after(page, "data-readout=\"0\">", '<') == "45");
    CHECK(after(page, "data-readout=\"1\">", '<') == "200");
    CHECK(after(page, "data-verdict=\"\">", '<') == "passes");
    CHECK(page.find("loadpath run a.toml --point <span data-point=\"\">13</span>") != std::string::npos);
    CHECK(desk.get("r.csv").find("\n13,45.00000000000001,200,pass,") != std::string::npos);
    const double u = 16.0 * 200.0 / (3.14159265358979 * std::pow(0.045, 3)) / 30e6;
    CHECK(std::stod(after(page, "data-readout=\"2\">", '<')) == doctest::Approx(u).epsilon(1e-4));
  }
}
