#include "lib/account/conclusion.hpp"
#include "lib/project/run/evaluation/providers.hpp"
#include "tests/lib/project/texts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string sized(const std::string& d) { return axle + "T = \"2700 N*m\"\ntau_adm = \"30 MPa\"\n" + d; }

}  // namespace

TEST_SUITE("project search") {
  TEST_CASE("the smallest of the stock that passes every check is taken") {
    const auto project = solved(sized("d = { stock = \"R20\" }\n"));
    const double d = value(project, "axle.d"), least = value(project, "axle.d_min");
    const auto stock = project::stock_values({}, "R20");
    CHECK(d == *std::lower_bound(stock.begin(), stock.end(), least));
    CHECK(account::worst(project::verdicts(project)) == account::State::pass);
  }

  TEST_CASE("a size that is missing is searched for in the field's own stock, like '?'") {
    CHECK(value(solved(sized("")), "axle.d") == doctest::Approx(0.080));
    CHECK(value(solved(sized("d = \"?\"\n")), "axle.d") == doctest::Approx(0.080));
  }

  TEST_CASE("the account states that a size was found, and in which stock") {
    const auto project = solved(sized("d = { stock = \"R20\" }\n"));
    for (const account::Entry& e : project.find("axle")->account().inputs) {
      if (e.path == "d")
        CHECK(e.origin.text.text() == "smallest of R20 with which no assessed mode fails; 71 mm fails: u_tau = 1.281");
    }
  }

  TEST_CASE("a bore is kept when the diameter is rounded up") {
    const auto project = solved(sized("chi = 0.6\n"));
    CHECK(value(project, "axle.d_bore") < 0.6 * value(project, "axle.d"));
    CHECK(value(project, "axle.d_bore") == doctest::Approx(0.6 * value(project, "axle.d_strength")));
  }

  TEST_CASE("of rows that all fail the nearest is one that fits, with the check that it fails") {
    const auto project = solved(
        "[feather]\ncalculator = \"shaft.key\"\nkey = \"?\"\nT = \"3000 N*m\"\ntorque = \"one_way\"\nd = \"40 mm\"\n"
        "l = \"40 mm\"\nl_n = \"45 mm\"\nR_e_1 = \"370 MPa\"\nR_e_2 = \"300 MPa\"\nR_e_k = \"420 MPa\"\nS_F = 1.5\n");
    for (const account::Entry& e : project.find("feather")->account().inputs) {
      if (e.path != "key") continue;  // 12x8 is the section for 38 mm to 44 mm, DIN 6885-1
      CHECK_MESSAGE(e.origin.text.text().find("nearest is 12x8: u_2 = 6.6") != std::string::npos, e.origin.text.text());
      CHECK_MESSAGE(
          e.origin.text.text().find("(hub keyway: bearing pressure / allowable pressure)") != std::string::npos,
          e.origin.text.text());
    }
  }

  TEST_CASE("no size of the stock passes: there is no result, and the nearest one is reported") {
    const auto project = solved(axle + "T = \"1e9 N*m\"\ntau_adm = \"30 MPa\"\nd = { stock = \"shaft\" }\n");
    CHECK(std::isnan(value(project, "axle.d")));
    CHECK(account::worst(project::verdicts(project)) == account::State::not_available);
    const std::string largest = "none passes, nearest is 630 mm: u_tau = ";
    for (const account::Entry& e : project.find("axle")->account().inputs) {
      if (e.path != "d") continue;
      CHECK_MESSAGE(e.origin.text.text().find(largest) != std::string::npos, e.origin.text.text());
      CHECK_MESSAGE(e.origin.text.text().find(", with T = ") != std::string::npos, e.origin.text.text());
    }
  }

  TEST_CASE("a size that needs the result of a step without one waits for it: that step is the cause") {
    const auto project = solved(
        "[bar]\ncalculator = \"shaft.design\"\nR_e = \"490 MPa\"\nE = \"210 GPa\"\nG = \"81 GPa\"\ngroup = "
        "\"carbon-steel\"\nS_F = 1.5\npieces = [{ name = \"a\", l = \"80 mm\", d = \"?\" }, { l = \"120 mm\", d = "
        "\"?\" }]\nsupports = [{ x = \"0 mm\" }, { x = \"200 mm\" }]\nseats = [{ x = \"100 mm\", F_x = "
        "\"=axle.M_max/(1 m)\" }]\n" +
        axle + "T = \"1e9 N*m\"\ntau_adm = \"30 MPa\"\nd = { stock = \"shaft\" }\n");
    std::string causes;
    for (const account::Mode& mode : project::modes(project)) {
      if (mode.subject == account::Subject::search) causes += mode.step;
      if (mode.id == "inputs") CHECK(mode.note.text() == "'seats[1].F_x' is not available: = axle.M_max/(1 m)");
    }
    CHECK(causes == "axle");
    for (const account::Entry& e : project.find("bar")->account().inputs) {
      if (e.path == "pieces.a.d") CHECK(e.origin.text.text() == "'seats[1].F_x' is not available: = axle.M_max/(1 m)");
    }
  }

  TEST_CASE("a candidate that does not fit is listed so, whatever its strength; an open bound reads at least") {
    const auto project = solved(
        "[key]\ncalculator = \"shaft.key\"\nT = \"400 N*m\"\ntorque = \"one_way\"\nd = \"48 mm\"\nd_f = \"70 mm\"\nh_t "
        "= \"10 mm\"\nkey = \"?\"\nl = \"36 mm\"\nl_n = \"40 mm\"\nR_e_1 = \"540 MPa\"\nR_e_2 = \"250 MPa\"\nR_e_k = "
        "\"420 MPa\"\nS_F = 1.5\n");
    std::vector<std::string> fits;
    for (const account::Mode& mode : project::modes(project)) {
      if (mode.subject == account::Subject::search)
        CHECK_MESSAGE(mode.note.text().find("must be at least 1.2") != std::string::npos, mode.note.text());
    }
    for (const account::Entry& e : project.find("key")->account().inputs) {
      for (const account::TriedSize& tried : e.origin.tried) {
        if (tried.fails == "x_d") fits.push_back(tried.name);
        if (tried.name == "14x9") CHECK(tried.reason.text().ends_with("must be at least 1.2"));
      }
    }
    CHECK(std::find(fits.begin(), fits.end(), "10x8") != fits.end());
    CHECK(std::find(fits.begin(), fits.end(), "12x8") != fits.end());
    CHECK(std::find(fits.begin(), fits.end(), "14x9") == fits.end());
  }

  TEST_CASE("no size of the stock satisfies the rules: nothing is taken") {
    CHECK(issues_of(sized("d_bore = \"260 mm\"\nd = { stock = \"bright\" }\n")) ==
          R"(a.toml:5:11: error: the bore must be smaller than the outer diameter of the shaft
5 | d_bore = "260 mm"
  |           ^^^^^^
  = help: d = 200 mm, the largest of bright, was tried last
)");
    CHECK(first_error(axle + "T = \"100 N*m\"\ntau_adm = \"30 MPa\"\nd = { stock = \"bright\" }\n"
                             "segments = [{ l = \"1 m\", d_bore = \"260 mm\" }, { l = \"1 m\" }]\n")
              .starts_with("the bore of a segment must be smaller"));
  }

  TEST_CASE("a part of a given size that fails whatever is found: there is no result, and the reason is told") {
    const std::string fixed = "segments = [{ l = \"100 mm\", d = \"20 mm\" }, { l = \"200 mm\" }]\n";
    const auto project = solved(axle + "T = \"900 N*m\"\ntau_adm = \"40 MPa\"\nd = \"?\"\n" + fixed);
    const auto modes = project::modes(project);
    CHECK(account::conclude(modes).headline == account::Headline::no_solution);
    // 16 T / (pi d^3) = 573 MPa at 20 mm; 40 MPa at 48.6 mm
    const auto search = std::find_if(modes.begin(), modes.end(), [](const auto& mode) { return mode.id == "search"; });
    REQUIRE(search != modes.end());
    const std::string why = search->note.text();
    CHECK_MESSAGE(why.find("none passes, nearest is 50 mm: u_tau = 14.32") != std::string::npos, why);
    CHECK_MESSAGE(why.find("all others fail this too") != std::string::npos, why);
  }

  TEST_CASE("an unknown stock is reported with the nearest one") {
    CHECK(issues_of(sized("d = { stock = \"R41\" }\n")) == R"(a.toml:5:16: error: unknown stock 'R41'
5 | d = { stock = "R41" }
  |                ^^^
  = help: did you mean 'R40'?
)");
  }

  TEST_CASE("a field that has no stock cannot be searched for") {
    const std::string rule = "error: 'l' cannot be searched for\n";
    const std::string help = "  = help: give a value; \"?\" is possible for d, T, P, F\n";
    CHECK(issues_of(sized("l = \"?\"\n")) == "a.toml:5:6: " + rule + "5 | l = \"?\"\n  |      ^\n" + help);
    CHECK(issues_of(sized("l = { stock = \"R20\" }\n")) ==
          "a.toml:5:7: " + rule + "5 | l = { stock = \"R20\" }\n  |       ^^^^^\n" + help);
  }

  TEST_CASE("without a required check any size would pass: none is taken") {
    const std::string pair = "[pair]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 40\n";
    CHECK(issues_of(pair) == R"(a.toml:1:2: error: 'm_n' cannot be sized: no check is active
1 | [pair]
  |  ^^^^
  = help: give m_n, or an input of a check: sigma_adm_1, sigma_adm_2
)");
    CHECK(told(pair + "m_n = \"2 mm\"\n").issues.empty());
  }

  TEST_CASE("a size that passes outside the range of the formulas is not taken: the next size inside it is") {
    const auto project = solved(
        "[pair]\ncalculator = \"gear.pair\"\nz_1 = 21\nz_2 = 60\na_w = \"122 mm\"\nT_1 = \"49.4 N*m\"\nb = \"40 mm\"\n"
        "sigma_adm_1 = \"180 MPa\"\nsigma_adm_2 = \"160 MPa\"\n");
    CHECK(value(project, "pair.m_n") == doctest::Approx(0.003));
    CHECK(account::worst(project::verdicts(project)) == account::State::pass);
  }
}
