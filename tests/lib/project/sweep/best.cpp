// The best machine against all machines, values that are sought against closed forms, influence against derivatives.
#include "lib/project/sweep/studies/best.hpp"

#include "lib/project/solving/read_project.hpp"
#include "lib/project/sweep/studies/influence.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/sweep/best.hpp"
#include "lib/sweep/statistics/values.hpp"
#include "tests/lib/project/solved.hpp"
#include "tests/lib/project/sweep/swept.hpp"
#include "tests/parts.hpp"
#include "tests/tries.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <span>
#include <string>

using namespace loadpath;
using doctest::Approx;
using test::contains;
using test::Swept;

namespace {

const std::string tube =
    "[strut]\ncalculator = \"column.buckling\"\nmethod = \"ec3\"\ncurve_y = \"c\"\ncurve_z = \"c\"\nl = \"1.5 "
    "m\"\nends = "
    "\"pinned_pinned\"\ngamma_M1 = 1\ngamma_F = 1\nE = \"210 GPa\"\nR_e = \"260 MPa\"\naccept = { local = \"thick "
    "enough\" "
    "}\n";
const std::string sizes =
    "d = { each = \"R20\", from = \"30 mm\", to = \"60 mm\" }\nd_bore = { from = \"20 mm\", to = \"50 mm\", step = \"5 "
    "mm\" "
    "}\n";
const std::string area = "(strut.d^2 - strut.d_bore^2)";

project::ReadAgain reader(const std::string& text) {
  return [text] {
    std::vector<Issue> issues;
    return project::read_project(text, "part.toml", catalogue(), issues, project::Ranges::taken);
  };
}

project::Placed asked(const std::string& text) { return {text, {"--asked", 1, 1, 1}}; }

project::SweepSettings drawn(std::uint64_t samples) {
  project::SweepSettings settings;
  settings.samples = samples;
  return settings;
}

}  // namespace

TEST_SUITE("the best machine" * test::by_case) {
  TEST_CASE("is the one with the minimum of all that pass") {
    for (const char* load : {"20 kN", "40 kN", "70 kN"}) {
      const std::string text = tube + sizes + "P = \"" + load + "\"\n";
      const Swept all(text, {"a = " + area, "strut.passes"});
      double least = INFINITY;
      for (std::size_t i = 0; i < all.column("a").size(); ++i) {
        if (all.column("strut.passes")[i] == 1.0) least = std::min(least, all.column("a")[i]);
      }
      std::vector<Issue> issues;
      const auto best = project::find_best({reader(text)}, {asked(area), false, {}, {}, {}}, drawn(10), issues);
      REQUIRE(best);
      CHECK(best->optimum.allowed);
      CHECK(best->optimum.scope == sweep::Optimum::Scope::every_point);
      CHECK(best->optimum.candidates == all.column("a").size());
      CHECK(best->optimum.outputs[0] == least);
    }
  }

  TEST_CASE("of continuous sizes lies on the governing bound") {
    const std::string text =
        "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"500 N*m\"\ntau_adm = \"30 MPa\"\nd = { from = \"20 mm\", to = "
        "\"90 "
        "mm\" }\n";
    std::vector<Issue> issues;
    const auto best = project::find_best({reader(text)}, {asked("shaft.d"), false, {}, {}, {}}, drawn(10), issues);
    REQUIRE(best);
    CHECK(best->optimum.allowed);
    CHECK(best->point[0] == Approx(std::cbrt(16.0 * 500.0 / (M_PI * 30e6))).epsilon(1e-5));
    const auto bounded = project::find_best(
        {reader(text)},
        {asked("shaft.tau_max"), false, {asked("shaft.d <= 60 mm"), asked("every mode passes")}, {}, {}}, drawn(10),
        issues);
    REQUIRE(bounded);
    CHECK(bounded->point[0] == Approx(0.06).epsilon(1e-5));
  }

  TEST_CASE("with a probability over what is uncertain") {
    const std::string text =
        "[shaft]\ncalculator = \"shaft.torsion\"\nT = { mean = \"500 N*m\", sd = \"50 N*m\" }\ntau_adm = \"30 MPa\"\nd "
        "= { "
        "from = \"20 mm\", to = \"90 mm\" }\n";
    std::vector<Issue> issues;
    const auto best = project::find_best({reader(text)}, {asked("shaft.d"), false, {}, 0.99, {}},
                                         drawn(test::sanitized ? 4000 : 20000), issues);
    REQUIRE(best);
    const double T_99 = 500.0 + 2.326347874 * 50.0;
    CHECK(best->point[1] == Approx(std::cbrt(16.0 * T_99 / (M_PI * 30e6))).epsilon(test::sanitized ? 6e-3 : 2e-3));
  }

  TEST_CASE("and its neighbours have the figures of the sweep over all designs to the bit") {
    for (const char* sampling : {"random", "latin"}) {
      const std::string text =
          "[project.sweep]\nsamples = 50\nseed = 7\nsampling = \"" + std::string(sampling) +
          "\"\ncorrelations = [{ of = [\"shaft.T\", \"shaft.tau_adm\"], r = 0.5 }]\n[shaft]\ncalculator = "
          "\"shaft.torsion\"\nT = { mean = \"500 N*m\", sd = \"50 N*m\" }\ntau_adm = { mean = \"30 MPa\", sd = \"2 "
          "MPa\" }\nd = [\"48 mm\", \"46 mm\", \"44 mm\"]\nd_bore = [\"5 mm\", \"0 mm\", \"10 mm\"]\n";
      const std::string u = "shaft.tau_max/shaft.tau_adm";
      const Swept all(text, {"u = " + u});
      std::vector<Issue> issues;
      const auto best = project::find_best({reader(text)}, {asked(u), true, {asked("shaft.d >= 46 mm")}, 0.9, {}},
                                           reader(text)().sweep, issues);
      REQUIRE(best);
      const auto check = [&](double d, double d_bore, double found) {
        sweep::Values samples;
        for (std::size_t i = 0; i < all.column("u").size(); ++i) {
          if (all.input("shaft.d")[i] == d && all.input("shaft.d_bore")[i] == d_bore)
            samples.add(std::span(&all.column("u")[i], 1));
        }
        CHECK(samples.count() == 50);
        CHECK(samples.quantile(1.0 - 0.9) == found);
      };
      check(best->optimum.point[0], best->optimum.point[1], best->optimum.outputs[0]);
      CHECK(best->optimum.neighbours.size() >= 3);
      for (const auto& near : best->optimum.neighbours) check(near.point[0], near.point[1], near.outputs[0]);
    }
  }

  TEST_CASE("between the ends of a range has the samples of a sweep at its size") {
    const auto shaft = [](const std::string& d) {
      return "[shaft]\ncalculator = \"shaft.torsion\"\nT = { mean = \"500 N*m\", sd = \"50 N*m\" }\ntau_adm = \"30 "
             "MPa\"\nd_bore = [\"0 mm\", \"5 mm\"]\nd = " +
             d + "\n";
    };
    const std::string text = shaft("{ from = \"20 mm\", to = \"90 mm\" }");
    std::vector<Issue> issues;
    const auto best = project::find_best({reader(text)}, {asked("shaft.d"), false, {}, 0.9, {}}, drawn(100), issues);
    REQUIRE(best);
    const Swept at("[project.sweep]\nsamples = 100\n" + shaft("\"" + format_number(1e3 * best->point[2], 17) + " mm\""),
                   {"u = shaft.utilisation"});
    sweep::Values samples;
    const std::size_t first = best->point[1] == 0.0 ? 0 : 100;
    samples.add(std::span(at.column("u")).subspan(first, 100));
    CHECK(samples.quantile(0.9) == Approx(best->optimum.outputs[1]).epsilon(1e-12));
  }

  TEST_CASE("of a mechanism: Hoeken's linkage, the straightest path of a point") {
    const std::string text =
        "[values]\nb = { from = \"21 mm\", to = \"30 mm\" }\n[bar]\ncalculator = \"mechanism.planar\"\ntemplate = "
        "\"four_bar\"\na = \"10 mm\"\nb = \"=values.b\"\nc = \"=values.b\"\nd = \"20 mm\"\n"
        "crank = { speed = \"60 rpm\", at = [{ angle = \"100 deg\" }, { angle = \"140 deg\" }, { angle = \"180 deg\" "
        "}, "
        "{ angle = \"220 deg\" }, { angle = \"260 deg\" }] }\n"
        "[bar.links.coupler.points]\nK = [\"=2*values.b\", \"0 mm\"]\n";
    std::vector<Issue> issues;
    const auto best = project::find_best(
        {reader(text)}, {asked("range(bar.points.K.y)"), false, {asked("range(bar.points.K.x) >= 30 mm")}, {}, {}},
        drawn(10), issues);
    REQUIRE(best);
    CHECK(best->optimum.allowed);
    CHECK(best->point[0] == Approx(25.0513e-3).epsilon(1e-5));  // of 90,000 lengths, by the circles through A and C
    CHECK(best->optimum.outputs[0] == Approx(7.8219e-5).epsilon(1e-3));
  }

  TEST_CASE("of machines whose verdicts have no utilisation is compared by the verdicts alone") {
    const std::string text =
        "[bar]\ncalculator = \"mechanism.planar\"\ntemplate = \"four_bar\"\na = \"10 mm\"\nb = [\"21 mm\", \"25 "
        "mm\", \"2 mm\"]\nc = \"25 mm\"\nd = \"20 mm\"\ncrank.speed = \"60 rpm\"\n"
        "crank.at = [{ angle = \"100 deg\" }, { angle = \"180 deg\" }]\n";
    for (const std::optional<double> quantile : {std::optional<double>(), std::optional<double>(0.9)}) {
      std::vector<Issue> issues;
      const auto best = project::find_best({reader(text)}, {asked("min(bar.joints.B.gamma)"), true, {}, quantile, {}},
                                           drawn(10), issues);
      REQUIRE(best);
      CHECK(best->optimum.allowed);
      CHECK(best->optimum.candidates == 3);
      CHECK(best->point[0] == Approx(0.021));
    }
  }

  TEST_CASE("a neighbour that is an invalid design states the reason") {
    const std::string text = tube + "d = [\"45 mm\", \"50 mm\"]\nd_bore = [\"20 mm\", \"50 mm\"]\nP = \"20 kN\"\n";
    std::vector<Issue> issues;
    const project::BestRequest wanted{asked(area), false, {asked("strut passes")}, {}, {}};
    const auto best = project::find_best({reader(text)}, wanted, drawn(10), issues);
    REQUIRE(best);
    REQUIRE(best->optimum.allowed);
    REQUIRE(best->reasons.size() == best->optimum.neighbours.size());
    std::size_t none = 0;
    for (std::size_t i = 0; i < best->reasons.size(); ++i) {
      const std::string why = best->reasons[i].text();
      CHECK(why.empty() == std::isfinite(best->optimum.neighbours[i].outputs[1]));
      if (why.empty()) continue;
      ++none;
      CHECK_MESSAGE(why.starts_with("invalid design: strut.d"), why);
      CHECK_MESSAGE(contains(why, "bore"), why);
    }
    CHECK(none == 1);
    const auto blocks = report::best_blocks(*best);
    const auto& table = std::get<report::Table>(blocks.back());
    const auto told = std::count_if(table.rows.begin(), table.rows.end(), [](const auto& row) {
      return contains(std::get<Message>(row.back()).text(), "invalid design: ");
    });
    CHECK(told == 1);
  }

  TEST_CASE("for a target value") {
    const std::string text =
        "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"500 N*m\"\ntau_adm = \"30 MPa\"\nd = { from = \"20 mm\", to = "
        "\"90 "
        "mm\" }\n";
    std::vector<Issue> issues;
    const auto sought = project::seek_value({reader(text)}, asked("shaft.tau_max = 20 MPa"), issues);
    REQUIRE(sought);
    REQUIRE(sought->sought.solutions.size() == 1);
    CHECK(sought->sought.solutions[0].at == Approx(std::cbrt(16.0 * 500.0 / (M_PI * 20e6))).epsilon(1e-12));
    const auto none = project::seek_value({reader(text)}, asked("shaft.tau_max = 1 Pa"), issues);
    REQUIRE(none);
    CHECK(none->sought.solutions.empty());
    CHECK(none->sought.nearest == Approx(0.09));
    CHECK_FALSE(project::seek_value({reader(text)}, asked("shaft.tau_max = 30 mm"), issues));
    CHECK(contains(issues.back().message.text(), "shaft.tau_max"));
  }

  TEST_CASE("scattered inputs are never chosen: a tolerance, and a range between two bounds") {
    for (const std::string bore :
         {"{ value = \"20 mm\", tolerance = \"2 mm\" }", "{ min = \"18 mm\", max = \"22 mm\" }"}) {
      const std::string text =
          "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"500 N*m\"\ntau_adm = \"30 MPa\"\n"
          "d = [\"45 mm\", \"50 mm\", \"60 mm\"]\nd_bore = " +
          bore + "\n";
      std::vector<Issue> issues;
      const auto best = project::find_best({reader(text)}, {asked("shaft.d"), false, {}, {}, {}}, drawn(10), issues);
      REQUIRE(best);
      REQUIRE(best->chosen.size() == 1);
      CHECK(best->inputs[best->chosen[0]].name == "shaft.d");
      CHECK(best->point[1] == Approx(0.020));
    }
  }

  TEST_CASE("a range without steps is for searches alone") {
    const std::string text =
        "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"500 N*m\"\ntau_adm = \"30 MPa\"\n"
        "d = { from = \"40 mm\", to = \"60 mm\" }\n";
    std::vector<Issue> issues;
    project::Project project = reader(text)();
    const auto plan = project::plan_sweep(project, project.sweep, issues);
    CHECK(issues.empty());
    project::refuse_open_ranges(plan, issues);
    REQUIRE(issues.size() == 1);
    CHECK(contains(issues[0].message.text(), "needs the values of 'shaft.d'"));
  }

  TEST_CASE("the inputs that a result depends on: tau = 16 T/(pi d^3)") {
    const std::string text =
        "[shaft]\ncalculator = \"shaft.torsion\"\nT = { mean = \"500 N*m\", sd = \"5 %\" }\ntau_adm = \"30 MPa\"\nd = "
        "{ mean "
        "= \"50 mm\", sd = \"1 %\" }\n";
    std::vector<Issue> issues;
    project::Project project = reader(text)();
    project.sweep.results.push_back(asked("shaft.tau_max"));
    const auto plan = project::plan_sweep(project, project.sweep, issues);
    const auto influence = project::find_influence({reader(text)}, plan, project.sweep, 4000, issues);
    REQUIRE(influence);
    REQUIRE(influence->inputs.size() == 2);
    CHECK(influence->slopes.at(0, 0).elasticity == Approx(1.0).epsilon(1e-6));
    CHECK(influence->slopes.at(0, 1).elasticity == Approx(-3.0).epsilon(1e-6));
    double share_of_T = 0.0;
    for (const auto& line : influence->budgets[0].lines) {
      if (influence->inputs[line.input].name == "shaft.T") share_of_T = line.share;
    }
    CHECK(share_of_T == Approx(25.0 / 34.0).epsilon(1e-6));
    CHECK(influence->sobol[0].inputs[0].first == Approx(25.0 / 34.0).epsilon(0.1));
    project.sweep.correlations.push_back({asked("shaft.T"), asked("shaft.d"), 0.6});
    CHECK_FALSE(project::find_influence({reader(text)}, plan, project.sweep, 4000, issues));
    CHECK(contains(issues.back().message.text(), "Sobol indices assume independent inputs"));
    CHECK(project::find_influence({reader(text)}, plan, project.sweep, 0, issues));
  }

  TEST_CASE("fewer samples than the probability needs are a warning that states what they show") {
    CHECK(project::samples_needed(0.95) == 59.0);  // Wilks 1941, one-sided limits of 95 % confidence
    CHECK(project::samples_needed(0.99) == 299.0);
    CHECK(project::shown_by(299) >= 0.99);
    CHECK(project::shown_by(298) < 0.99);
    const std::string text = tube + sizes + "P = { mean = \"40 kN\", sd = \"4 kN\" }\n";
    const auto warns = [&](std::uint64_t samples, std::optional<double> quantile) {
      std::vector<Issue> issues;
      const auto best = project::find_best({reader(text)}, {asked(area), false, {asked("strut passes")}, quantile, {}},
                                           drawn(samples), issues);
      REQUIRE(best);
      const auto blocks = report::best_blocks(*best);
      return std::any_of(blocks.begin(), blocks.end(), [](const report::Block& block) {
        const auto* const paragraph = std::get_if<report::Paragraph>(&block);
        return paragraph != nullptr && contains(paragraph->text.text(), "99 % needs 299: --samples 299");
      });
    };
    CHECK(warns(100, 0.99));
    CHECK_FALSE(warns(299, 0.99));
    CHECK_FALSE(warns(100, std::nullopt));
  }

  TEST_CASE("a neighbour names its mode that is not assessed") {
    const std::string text =  // 600 MPa are more than C45E has; 10 mm yield by any strength
        "[a]\ncalculator = \"shaft.torsion\"\nmaterial = \"C45E\"\ntau_adm = \"600 MPa\"\nT = \"200 N*m\"\n"
        "d = [\"10 mm\", \"12 mm\", \"34 mm\"]\n";
    std::vector<Issue> issues;
    const auto best = project::find_best({reader(text)}, {asked("a.d"), false, {}, {}, {}}, drawn(10), issues);
    REQUIRE(best);
    CHECK_FALSE(best->optimum.allowed);
    REQUIRE(best->reasons.size() == 1);
    CHECK_MESSAGE(contains(best->reasons[0].text(), "is not assessed"), best->reasons[0].text());
  }

  TEST_CASE("an objective and a requirement may have a name") {
    const std::string text = tube + sizes + "P = \"40 kN\"\n";
    const auto find = [&](const std::string& objective, const std::string& demand) {
      std::vector<Issue> issues;
      auto best =
          project::find_best({reader(text)}, {asked(objective), false, {asked(demand)}, {}, {}}, drawn(10), issues);
      CHECK(issues.empty());
      REQUIRE(best);
      return std::move(*best);
    };
    const project::Best plain = find(area, "strut passes");
    for (const std::string demand : {"strut passes", "well = strut passes"}) {
      const project::Best named = find("A = " + area, demand);
      CHECK(named.objective == "A");
      CHECK(named.optimum.outputs[0] == plain.optimum.outputs[0]);
      CHECK(named.optimum.point == plain.optimum.point);
    }
    const project::Best bound = find("A = " + area, "thin = strut.d <= 50 mm");
    CHECK(bound.optimum.outputs == find(area, "strut.d <= 50 mm").optimum.outputs);
  }

  TEST_CASE("a demand holds for every sign of its sides") {
    const std::string text = tube + "d = { from = \"37 mm\", to = \"43 mm\", step = \"1 mm\" }\nP = \"20 kN\"\n";
    const auto end = [&](const std::string& demand, bool maximise) {  // over 40 mm
      std::vector<Issue> issues;
      const auto best =
          project::find_best({reader(text)}, {asked("strut.d"), maximise, {asked(demand)}, {}, {}}, drawn(10), issues);
      CHECK(issues.empty());
      REQUIRE(best);
      CHECK(best->optimum.allowed);
      return std::lround(1e3 * best->optimum.outputs[0]) - 40;
    };
    struct Case {
      std::string demand;
      long least, most;
    };
    const std::string x = "strut.d - 40 mm", minus_x = "40 mm - strut.d";
    for (const Case& c : {Case{x + " >= 0.5 mm", 1, 3}, Case{x + " <= 0.5 mm", -3, 0}, Case{x + " >= -1.5 mm", -1, 3},
                          Case{x + " <= -1.5 mm", -3, -2}, Case{x + " >= 0 mm", 0, 3}, Case{x + " <= 0 mm", -3, 0},
                          Case{"-1.5 mm <= " + x, -1, 3}, Case{"0.5 mm >= " + x, -3, 0},
                          Case{x + " <= " + minus_x, -3, 0}, Case{x + " >= " + minus_x, 0, 3}}) {
      CAPTURE(c.demand);
      CHECK(end(c.demand, false) == c.least);
      CHECK(end(c.demand, true) == c.most);
    }
  }

  TEST_CASE("invalid requests are reported") {
    const std::string text = tube + sizes + "P = \"40 kN\"\n";
    const auto fault = [&](const std::string& objective, const std::vector<project::Placed>& such_that) {
      std::vector<Issue> issues;
      CHECK_FALSE(project::find_best({reader(text)}, {asked(objective), false, such_that, {}, {}}, drawn(10), issues));
      return issues.empty() ? std::string() : issues.front().message.text() + " = " + issues.front().hint.text();
    };
    CHECK(contains(fault("strut.m", {}), "strut"));
    CHECK(contains(fault("A = strut.m", {}), "strut"));
    CHECK(contains(fault("= strut.d", {}), "a name is missing"));
    CHECK(contains(fault("A =", {}), "a result is expected"));
    CHECK(contains(fault("strut.d <= 5 mm", {}), "not a comparison"));
    CHECK(contains(fault("strut.d", {asked("strut.lambda small")}), "is not a constraint"));
    CHECK(contains(fault("strut.d", {asked("strut.d <= 5 kg")}), "different dimensions"));
    CHECK(contains(fault("strut.d", {asked("strut.d >= 5 kg")}), "both sides of 'strut.d >= 5 kg' have different"));
    CHECK(contains(fault("strut.d", {asked("strut.d >= strut.R_e")}), "different dimensions"));
    CHECK(contains(fault("strut.d", {asked("strut.utilisation <= 0")}), "above zero"));
    CHECK(contains(fault("strut.d", {asked("axle passes")}), "axle"));
    std::vector<Issue> issues;
    auto parallel = drawn(10);
    parallel.zip = {{asked("strut.d")}, {asked("strut.d"), asked("strut.d_bore")}};
    CHECK_FALSE(project::find_best({reader(text)}, {asked("strut.d"), false, {}, {}, {}}, parallel, issues));
    CHECK(contains(issues.front().message.text(), "'strut.d' and 'strut.d_bore' vary in parallel (zip)"));
    issues.clear();
    CHECK_FALSE(project::seek_value({reader(text)}, asked("strut.lambda = 90"), issues));
    CHECK(contains(issues.front().message.text(), "exactly one input must have a range"));
  }
}
