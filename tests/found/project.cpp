// Regression tests of complete projects: expressions, warnings, references, reports; faults found in use.
#include "lib/export/json.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/quantity/series.hpp"
#include "lib/report/build/build.hpp"
#include "tests/found/modes.hpp"

#include <algorithm>
#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string engine = R"([m]
calculator = "mechanism.planar"
template = "slider_crank"
r = "60 mm"
l = "200 mm"
crank = { speed = "3000 rpm", positions = 72 }
links.rod = { mass = "0.5 kg" }
links.slider = { mass = "0.4 kg" }
)";
const std::string bar =
    "[rod]\ncalculator = \"column.buckling\"\nl = \"200 mm\"\nd = \"12 mm\"\nends = \"pinned_pinned\"\n"
    "material = \"S355JR\"\nmethod = \"johnson\"\nn_st = 2\nn_t = 2\n";
const std::string cycle = R"([s]
calculator = "fatigue.cycle"
sigma_max = "100 MPa"
sigma_min = "-20 MPa"
others = [{ name = "below", sigma_max = "10 MPa", r = -1 }]
)";

/// Error of a project; empty if none.
std::string refusal(const std::string& text) {
  std::vector<Issue> issues;
  project::Project project = project::read_project(text, "found.toml", catalogue(), issues);
  if (!has_errors(issues)) project::solve(project, issues);
  std::string all;
  for (const Issue& issue : issues) {
    if (issue.severity == Severity::error) all += issue.message.text() + "; " + issue.hint.text() + "\n";
  }
  return all;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string endurance(const std::string& limit) {
  return "[e]\ncalculator = \"fatigue.endurance\"\nR_m = \"600 MPa\"\ngroup = \"carbon-steel\"\nsigma_W = \"" + limit +
         "\"\n";
}

/// A page as it is read, without tags and underscores: subscripts are set as such.
std::string read_from(const std::string& page) {
  std::string text;
  bool in_tag = false;
  for (const char c : page) {
    in_tag = in_tag || c == '<';
    if (!in_tag && c != '_') text += c;
    in_tag = in_tag && c != '>';
  }
  return text;
}

/// A warning in every place that reports a step.
void check_told(const project::Project& project, const std::string& warning) {
  CAPTURE(warning);
  const report::Document document = report::build(project, "found");
  CHECK(contains(exports::json_of(project, "found"), warning));
  CHECK(contains(read_from(report::html(document)), read_from(warning)));
  CHECK(contains(report::markdown(document, "found").text, warning));
}

}  // namespace

TEST_SUITE("found project") {
  TEST_CASE("A4: the peak of a signed force is not a valid force of a bar") {
    CHECK(contains(refusal(engine + bar + "N = \"=peak(m.links.rod.N)\"\n"), "the sign of 'N' matters"));
    CHECK(refusal(engine + bar + "N = \"=min(m.links.rod.N)\"\n").empty());
    const project::Project project = solved_as_found(engine + bar + "N = \"=min(m.links.rod.N)\"\n");
    CHECK(project.value("rod.u")->si[0] > 0.0);
  }

  TEST_CASE("A25: an expression is refused wherever a literal is refused") {
    const auto wheel = [](const std::string& omega) {
      return refusal(
          "[w]\ncalculator = \"machine.flywheel\"\nM_of_phi = \"400 N*m*cos(2*phi)\"\ndelta = 0.02\nomega = \"" +
          omega + "\"\n");
    };
    for (const char* omega : {"50 Hz", "=50 Hz", "=3000/(1 min)"}) CHECK(contains(wheel(omega), "angular velocity"));
    CHECK(wheel("=2*(50 rpm)").empty());
    const auto slope = [](const std::string& alpha) {
      return refusal("[s]\ncalculator = \"dynamics.work\"\nm = \"10 kg\"\ns = \"2 m\"\nalpha = " + alpha + "\n");
    };
    CHECK(contains(slope("12"), "angle"));
    CHECK(contains(slope("\"=12\""), "takes a value of angle"));
    CHECK(contains(slope("\"=asin(sin(30))\""), "'sin' needs an angle"));
    CHECK(slope("\"=asin(sin(30 deg))\"").empty());
  }

  TEST_CASE("A26: a warning is in report, JSON and Markdown") {
    const std::string chain =
        "[c]\ncalculator = \"chain.roller\"\nchain = \"08B\"\nz_1 = 19\nz_2 = 57\nn_1 = \"100 rpm\"\nP = \"0.5 kW\"\n"
        "a = \"500 mm\"\n";
    check_told(solved_as_found(chain + "K_A = 2.5\n"), "K_A = 2.5 is unusual");
    const std::string shaft =
        "[s]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nT = { mean = \"100 N*m\", sd = ";
    check_told(solved_as_found(shaft + "\"5 N*m\" }\n"), "middle value");
  }

  TEST_CASE("A30: a name that a list of results does not have is refused, a place leaves the step not available") {
    CHECK(contains(refusal(cycle + endurance("=20*s.others.missing.sigma_a/(1 MPa)*(1 MPa)")),
                   "'s.others' has no 'missing'; available: below"));
    const std::string beyond = cycle + endurance("=20*s.others[7].sigma_a/(1 MPa)*(1 MPa)");
    CHECK(refusal(beyond) == "");
    CHECK(mode_of(solved_as_found(beyond), "e", "inputs") == "not-available");
  }

  TEST_CASE("C8: compared cycles have names, and are referred to by them") {
    for (const char* limit :
         {"=20*s.others.below.sigma_a/(1 MPa)*(1 MPa)", "=20*s.others[1].sigma_a/(1 MPa)*(1 MPa)"}) {
      CAPTURE(limit);
      const project::Project project = solved_as_found(cycle + endurance(limit));
      CHECK(mode_of(project, "e", "inputs") == "none");
      CHECK(project.value("e.sigma_m1")->si[0] == doctest::Approx(200e6));
    }
  }

  TEST_CASE("B2: a mechanism without a force has a report") {
    const std::string light = engine.substr(0, engine.find("links.rod"));
    CHECK(contains(report::html(report::build(solved_as_found(light), "found")), "</html>"));
    const std::string stands = light.substr(0, light.find("crank ="));  // nor a speed: arrows of nothing
    CHECK(contains(report::html(report::build(solved_as_found(stands), "found")), "</html>"));
  }

  TEST_CASE("B4: the angle of a crank that turns clockwise is continuous at half a turn") {
    std::string backwards = engine;
    backwards.replace(backwards.find("3000 rpm"), 8, "-300 rpm");
    const project::Project project = solved_as_found(backwards);
    const Value& phi = *project.value("m.links.crank.phi");
    const auto [least, most] = std::minmax_element(phi.si.begin(), phi.si.end());
    CHECK((*most - *least) / deg.one == doctest::Approx(355.0));
  }

  TEST_CASE("B8: a limit over a series gives the position of its largest value, and the derivation that of the check") {
    const project::Project project = solved_as_found(engine + bar + "N = \"=m.links.rod.N\"\n");
    const Value& x_t = *project.value("rod.x_t");
    REQUIRE(x_t.is_series());
    CHECK(maximum(x_t).value > 0.1);
    for (const account::Verdict& row : project::verdicts(project)) {
      if (row.symbol == "x_t") CHECK(std::get<account::Quantity>(row.value).si == doctest::Approx(maximum(x_t).value));
    }
    const account::Account& account = project.find("rod")->account();
    CHECK(contains(account.governing.text(), "where the governing check is largest"));
  }

  TEST_CASE("C1: a range in a project names the command that runs over it") {
    const std::string said = refusal(
        "[s]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nT = { from = \"1 N*m\", to = \"5 N*m\", count = "
        "5 }\n");
    CHECK(contains(said, "these are 5 values"));
  }

  TEST_CASE("C1, C2: words of the shell are valid step names in a file") {
    for (const char* name : {"init", "watch", "completion", "man", "why", "sweep", "run", "shaft", "gear", "motion"}) {
      CAPTURE(name);
      CHECK(
          refusal("[" + std::string(name) + "]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nT = \"1 N*m\"\n")
              .empty());
    }
  }

  TEST_CASE("a part whose loads are all zero has passed nothing") {
    const auto state = [](const std::string& calculator, const std::string& lines) {
      return mode_with(calculator, lines, "load");
    };
    CHECK(state("shaft.torsion", "torques = \nT = \"0 N*m\"") == "not-judged");
    CHECK(state("shaft.torsion", "torques = \nT = \"1 N*m\"") == "none");
    CHECK(state("link.member", "N = \"0 kN\"\nV = \"0 kN\"\nM_b = \"0 N*m\"") == "not-judged");
    CHECK(state("link.member", "N = \"0 kN\"\nV = \"0 kN\"\nM_b = \"1 N*m\"") == "none");
    CHECK(state("shaft.key", "T = \"0 N*m\"") == "not-judged");
  }
}
