#include "calculators/fatigue/history/history.hpp"

#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/rainflow/counter.hpp"
#include "lib/rainflow/damage.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/cli/process.hpp"
#include "tests/found/modes.hpp"

#include <cmath>
#include <fstream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using namespace loadpath::fatigue;
using namespace loadpath::test;
using In = History::Input;
using test::rel;

History::Result counted(const In& in) {
  for (const auto& rule : History::rules) CHECK_MESSAGE((rule.only_warns || rule.holds(in)), rule.text);
  NoTrace trace;
  return History::evaluate(in, trace);
}

In of_part(double sigma_D, double N_D, double k) {
  In in;
  in.sigma_D = sigma_D * MPa, in.N_D = N_D, in.k = k;
  return in;
}

Varying<Stress> series(const Axis& axis, std::vector<double> MPa_values) {
  for (double& v : MPa_values) v *= 1e6;
  return Varying<Stress>(Value{{dimension_of<Stress>, &axis}, std::move(MPa_values)});
}

/// `periods` of a sine of 100 MPa, 12 positions each.
std::vector<double> sine(int periods, double mean = 0.0) {
  std::vector<double> values;
  for (int i = 0; i < 12 * periods; ++i) values.push_back(mean + 100.0 * std::sin(i * std::numbers::pi / 6.0));
  return values;
}

double value_of(const project::Project& project, const std::string& path) {
  const Value* const value = project.steps.front()->value(path);
  return value == nullptr ? std::nan("") : value->si[0];
}

const std::string part = R"(
sigma_D = "100 MPa"
N_D = 1e6
k = 5
miner = "elementary"
)";

project::Project of_history(const std::string& sigma, const std::string& more = part) {
  return solved_as_found("[h]\ncalculator = \"fatigue.history\"\nsigma = " + sigma + more);
}

/// The texts of all errors of a project.
std::string errors_of(const std::string& text) {
  std::vector<Issue> issues;
  project::Project project = project::read_project(text, "history.toml", catalogue(), issues);
  if (!has_errors(issues)) project::solve(project, issues);
  std::string all;
  for (const Issue& issue : issues) {
    if (issue.severity == Severity::error) all += issue.message.text() + "\n";
  }
  return all;
}
std::string errors_of_history(const std::string& sigma, const std::string& more = part) {
  return errors_of("[h]\ncalculator = \"fatigue.history\"\nsigma = " + sigma + more);
}

}  // namespace

TEST_SUITE("fatigue.history") {
  TEST_CASE("three stresses in turn, by the problem of a textbook") {
    In in = of_part(280, 1e6, 3.0 / std::log10(594.0 / 280.0));
    in.miner = History::MinerRule::original;
    in.blocks = {
        {{}, 350.0 * MPa, 0.0 * MPa, 0.85}, {{}, 400.0 * MPa, 0.0 * MPa, 0.12}, {{}, 500.0 * MPa, 0.0 * MPa, 0.03}};
    CHECK(rel(counted(in).Z, 62731.118105) < 1e-10);  // [Bhandari5] example 5.11
  }

  TEST_CASE("a sine has one life, however it is counted") {
    Axis open;
    open.quantity = "sample", open.unit = "-", open.at = std::vector<double>(120);
    for (const auto counting : {History::Counting::four_point, History::Counting::hcm, History::Counting::astm}) {
      for (const auto residue : {History::Residue::repeated, History::Residue::half_cycles}) {
        In in = of_part(100, 1e6, 5);
        in.sigma = series(open, sine(10)), in.counting = counting, in.residue = residue;
        if (!History::hcm_repeats(in)) continue;
        const auto r = counted(in);
        // Ten periods; as a history that ends its last quarter to zero, and its first, are of half the range.
        const double least = residue == History::Residue::repeated ? 10e-6 : 9.5e-6;
        CHECK(r.D_elementary >= least * (1.0 - 1e-9));
        CHECK(r.D_elementary <= 10.1e-6);
      }
    }
  }

  TEST_CASE("one revolution repeats: its cycle is complete, and may start anywhere") {
    Axis turn;
    turn.quantity = "crank angle";
    turn.period = 2.0 * std::numbers::pi, turn.speed = 10.0 * std::numbers::pi;
    std::vector<double> values;
    for (int i = 0; i < 36; ++i) {
      turn.at.add(i * std::numbers::pi / 18.0);
      values.push_back(100.0 * std::sin(turn.at.back()));
    }
    In in = of_part(50, 1e6, 5);
    for (int shift = 0; shift < 36; ++shift) {
      in.sigma = series(turn, values);
      const auto r = counted(in);
      CHECK(r.n == 1.0);
      CHECK(rel(r.D_elementary, 32e-6) < 1e-12);
      CHECK(rel(in_si(r.L), 0.2 / 32e-6) < 1e-9);  // five turns a second
      std::rotate(values.begin(), values.begin() + 1, values.end());
    }
    in.residue = History::Residue::half_cycles;
    CHECK(!History::may_be_left(in));
  }

  TEST_CASE("each factor acts once, as a power of the slope") {
    In in = of_part(100, 1e6, 5);
    in.miner = History::MinerRule::elementary;
    in.blocks = {{{}, 80.0 * MPa, 30.0 * MPa, 1000}};
    in.mean = History::Means::goodman, in.R_m = 600.0 * MPa, in.R_e = 400.0 * MPa;
    const auto plain = counted(in);
    CHECK(rel(plain.D, 1e-3 * std::pow(0.8 / (1.0 - 30.0 / 600.0), 5)) < 1e-12);
    in.S_D = 1.2;
    CHECK(rel(counted(in).D / plain.D, std::pow(1.2, 5)) < 1e-12);
    in.S_D = 1.0, in.K_A = 1.2;
    const double ratio = 1.2 * (1.0 - 30.0 / 600.0) / (1.0 - 36.0 / 600.0);
    CHECK(rel(counted(in).D / plain.D, std::pow(ratio, 5)) < 1e-12);
    CHECK(rel(counted(in).u_y, 1.2 * 110.0 / 400.0) < 1e-12);
  }

  TEST_CASE("shear has its own strengths for its mean stress") {
    In in = of_part(110, 1e6, 5);
    in.stress = Stresses::shear, in.mean = History::Means::soderberg, in.R_m = 690.0 * MPa, in.R_e = 490.0 * MPa;
    in.blocks = {{{}, 60.0 * MPa, -200.0 * MPa, 1}};
    CHECK(rel(counted(in).S_1 / MPa, 60.0 / (1.0 - 200.0 * std::sqrt(3.0) / 490.0)) < 1e-12);
    CHECK(rel(counted(in).u_y, 260.0 * std::sqrt(3.0) / 490.0) < 1e-12);
    CHECK(rel(counted(in).x_B, 260.0 / (0.67 * 690.0)) < 1e-12);
    in.mean = History::Means::goodman;
    CHECK(rel(counted(in).S_1 / MPa, 60.0 / (1.0 - 200.0 / (0.67 * 690.0))) < 1e-12);
    in.mean = History::Means::morrow;
    CHECK(!History::mean_suits(in));
  }

  TEST_CASE("Miner's rules for small cycles are in the order of their damage") {
    In in = of_part(100, 1e6, 6);
    in.blocks = {{{}, 150.0 * MPa, 0.0 * MPa, 100}, {{}, 80.0 * MPa, 0.0 * MPa, 1e5}, {{}, 55.0 * MPa, 0.0 * MPa, 1e6}};
    const auto r = counted(in);
    CHECK(r.D_original < r.D_consistent);
    CHECK(r.D_consistent < r.D_elementary);
    CHECK(r.D_original < r.D_modified);
    CHECK(r.D_modified < r.D_elementary);
    CHECK(rel(r.D_original, 100e-6 * std::pow(1.5, 6)) < 1e-12);
    CHECK(rel(r.D_modified, 100e-6 * std::pow(1.5, 6) + 0.1 * std::pow(0.8, 11) + std::pow(0.55, 11)) < 1e-12);
  }

  TEST_CASE("a long history has the damage of its count, and other rules only on request") {
    Axis axis;
    std::vector<double> values;
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal(0.0, 30.0);
    for (int i = 0; i < 200'000; ++i) values.push_back(normal(random));
    axis.at = std::vector<double>(values.size());
    In in = of_part(100, 1e6, 5);
    in.sigma = series(axis, values), in.residue = History::Residue::half_cycles;
    in.miner = History::MinerRule::elementary;
    const auto curve = *rainflow::SnCurve::make(rainflow::Measure::amplitude, {100e6, 1e6},
                                                std::vector<rainflow::SnCurve::Branch>{{5.0}});
    rainflow::DamageSum sum(curve);
    rainflow::LargestShares shares(curve, 10);
    rainflow::Consumers both({&sum, &shares});
    rainflow::Counter counter({}, both);
    REQUIRE(!counter.feed(in.sigma.series->si));
    counter.finish();
    const auto alone = counted(in);
    CHECK(rel(alone.D, *sum.total()) < 1e-12);
    CHECK(alone.n == sum.cycles());
    for (std::size_t i = 0; i < 10; ++i) {
      CHECK(rel(2.0 * in_si(alone.worst[i].sigma_a), shares.shares()[i].cycle.range) < 1e-12);
      CHECK(rel(alone.worst[i].share, shares.shares()[i].damage / *sum.total()) < 1e-9);
    }
    CHECK(!is_set(alone.D_modified));
    in.other_rules = History::OtherRules::yes;
    const auto compared = counted(in);
    CHECK(compared.D == alone.D);
    CHECK(compared.D_original < compared.D_modified);
    CHECK(compared.D_consistent > 0.0);
    CHECK(compared.D_LZ > 0.0);
    in.other_rules = History::OtherRules::no, in.miner = History::MinerRule::original;
    const auto original = counted(in);
    CHECK(rel(original.D, compared.D_original) < 1e-12);
    CHECK(rel(original.x_O, 1.0 - compared.D_original / compared.D_modified) < 1e-9);
    CHECK(!is_set(original.D_LZ));
  }

  TEST_CASE("details: nothing fails at the constant amplitude limit, and the limit drops with one larger cycle") {
    In in;
    in.curve = History::Curve::en1993, in.sigma_C = 71.0 * MPa;
    in.blocks = {{{}, 26.0 * MPa, 0.0 * MPa, 1e6}};
    auto r = counted(in);
    CHECK(r.D == 0.0);
    CHECK(std::isinf(r.Z));
    in.blocks.push_back({{}, 30.0 * MPa, 0.0 * MPa, 1});
    r = counted(in);
    CHECK(rel(r.D, 1e6 / 5e6 * std::pow(52.0 / 52.31324728069349, 5) + std::pow(60.0 / 71.0, 3) / 2e6) < 1e-9);
    in.stress = Stresses::shear, in.sigma_C = 100.0 * MPa;
    CHECK(rel(counted(in).D, 1e6 / 2e6 * std::pow(0.52, 5) + std::pow(0.6, 5) / 2e6) < 1e-9);
  }

  TEST_CASE("a file may have any length: forms, columns, units") {
    const test::Desk desk;
    const auto& folder = desk.folder();
    const std::vector<double> values{0, 1.5, 0.5, 3, -2, 1, -1, 2.5, 0};
    std::ofstream csv(folder / "gauge.csv");
    csv << "t;S1;S2\n";
    std::ofstream f64(folder / "gauge.f64", std::ios::binary);
    for (std::size_t i = 0; i < values.size(); ++i) {
      csv << i << ";0;" << values[i] << "\n";
      f64.write(reinterpret_cast<const char*>(&values[i]), sizeof(double));
    }
    csv.close(), f64.close();
    const std::string path = folder.string() + "/gauge";
    const auto typed = of_history(R"({ values = [0, 1.5, 0.5, 3, -2, 1, -1, 2.5, 0], unit = "60 MPa" })");
    const double D = value_of(typed, "D");
    CHECK(D > 0.0);
    CHECK(value_of(of_history("{ file = \"" + path + ".csv\", column = \"S2\", unit = \"60 MPa\" }"), "D") == D);
    CHECK(value_of(of_history("{ file = \"" + path + ".csv\", column = 3, unit = \"0.06 GPa\" }"), "D") == D);
    CHECK(value_of(of_history("{ file = \"" + path + ".f64\", unit = \"60 MPa\" }"), "D") == D);
    CHECK(errors_of_history("{ file = \"" + path + ".csv\", column = \"S3\", unit = \"MPa\" }").size() > 0);
    CHECK(errors_of_history("{ file = \"" + path + ".csv\", column = \"S2\", unit = \"kN\" }").find("'kN' is no") == 0);
    CHECK(errors_of_history("{ file = \"" + path + ".csv\", column = \"S2\" }").size() > 0);
    std::ofstream(folder / "comma.csv") << "t,S\n0,00,310,5\n0,05,-290,2\n";
    std::ofstream(folder / "unit.csv") << "S\n0 ksi\n60 ksi\n";
    for (const char* name : {"comma", "unit"})
      CHECK(errors_of_history("{ file = \"" + folder.string() + "/" + name + ".csv\", column = \"S\", unit = \"MPa\" }")
                .find("columns, but the first line has") != std::string::npos);
    CHECK(errors_of_history("{ file = \"" + path + ".bin\", unit = \"MPa\" }").size() > 0);
    CHECK(errors_of_history("{ file = \"/dev/zero\", unit = \"MPa\", form = \"f64\" }")
              .find("file '/dev/zero' does not exist") == 0);
    CHECK(errors_of_history("{ values = [1, \"2\"], unit = \"MPa\" }").size() > 0);
    CHECK(errors_of_history("{ values = [1, 2], unit = \"MPa\", column = 1 }").size() > 0);
  }

  TEST_CASE("the account of a step has its history without a copy") {
    const auto project = of_history(R"({ values = [0, 10, -20, 0], unit = "MPa" })");
    const Value* const series = project.value("h.sigma");
    REQUIRE(series != nullptr);
    CHECK(series->si == std::vector<double>{0.0, 10e6, -20e6, 0.0});
    for (const auto& entry : project.find("h")->account().inputs) {
      if (entry.path != "sigma") continue;
      CHECK(&entry.values() == series);
      CHECK(entry.value.is_series());
      CHECK(entry.value.si.empty());
    }
  }

  TEST_CASE("the worst cycle is reported at its place in the file") {
    const auto project = of_history(R"({ values = [0, 10, 9, 10, 4, 4, 20, -30, 5, 0], unit = "10 MPa" })");
    CHECK(value_of(project, "worst[1].from") == 6.0);
    CHECK(value_of(project, "worst[1].to") == 7.0);
    CHECK(rel(value_of(project, "worst[1].sigma_a"), 250e6) < 1e-12);
  }

  TEST_CASE("classes: the matrix, range pairs and level crossings of the history of ASTM, counted by hand") {
    // -2 1 -3 5 -1 3 -4 4 -2 in classes of 1: one cycle of 3 to -1 or back, the rest half cycles
    const auto p = of_history(R"({ values = [-2, 1, -3, 5, -1, 3, -4, 4, -2], unit = "10 MPa" })",
                              part + "counting = \"astm\"\nresidue = \"half-cycles\"\nclasses = 9\nK_A = 2\n");
    const auto& step = *p.steps.front();
    double cycles = 0.0;
    for (int i = 1; const Value* n = step.value("matrix[" + std::to_string(i) + "].n"); ++i) cycles += n->si[0];
    CHECK(cycles == 4.0);
    CHECK(value_of(p, "range_pairs[1].n") == 0.5);  // range 9
    CHECK(value_of(p, "range_pairs[2].n") == 1.0);  // range 8
    CHECK(value_of(p, "range_pairs[4].n") == 0.5);  // range 6
    CHECK(value_of(p, "range_pairs[6].n") == 1.5);  // range 4
    CHECK(value_of(p, "range_pairs[7].n") == 0.5);  // range 3
    CHECK(value_of(p, "range_pairs[9].n_least") == 4.0);
    CHECK(rel(value_of(p, "range_pairs[1].to"), 180e6) < 1e-9);
    // the level 0 between the classes: up at -2 to 1, -3 to 5, -1 to 3, -4 to 4
    CHECK(std::abs(value_of(p, "crossings[5].sigma")) < 1.0);
    CHECK(value_of(p, "crossings[5].up") == 4.0);
    CHECK(value_of(p, "crossings[5].down") == 4.0);
    CHECK(std::isnan(value_of(of_history(R"({ values = [0, 3, -2], unit = "10 MPa" })"), "matrix[1].n")));
    CHECK(errors_of("[h]\ncalculator = \"fatigue.history\"\nblocks = [{ sigma_a = \"50 MPa\", n = 10 }]\nclasses = 4" +
                    part)
              .find("classes sort the cycles of a series") != std::string::npos);
  }

  TEST_CASE("missing input does not pass") {
    CHECK(mode_with("fatigue.history", "n_req = ", "fatigue") == "not-judged");
    CHECK(mode_with("fatigue.history", "mean = \"none\"", "mean") == "not-judged");
    CHECK(mode_with("fatigue.history", "n_req = 1e9", "fatigue") == "fail");
    CHECK(mode_with("fatigue.history", "R_e = \nS_F = ", "yield") == "not-judged");
    CHECK(mode_with("fatigue.history", "S_F = 3", "yield") == "fail");
    CHECK(mode_with("fatigue.history", "", "fatigue") == "pass");
    CHECK(mode_with("fatigue.history", "blocks = [{ sigma_a = \"1 MPa\", sigma_m = \"700 MPa\", n = 1 }]", "fatigue") ==
          "fail");
    // Above the knee at 1e3 cycles another curve holds.
    CHECK(mode_with("fatigue.history", "sigma_D = \"40 MPa\"\nblocks = [{ sigma_a = \"180 MPa\", n = 1 }]",
                    "fatigue") == "not-covered");
  }

  TEST_CASE("a history of a mechanism: one complete revolution") {
    const auto project = solved_as_found(R"P([press]
calculator = "mechanism.planar"
template = "toggle_press"
r = "40 mm"
l = "215 mm"
b = "180 mm"
f = "180 mm"
x_C = "260 mm"
y_C = "170 mm"
crank = { speed = "30 rpm", positions = 360 }
links.ram.mass = "40 kg"
loads = [{ name = "F", link = "ram", at = "D", F_x = "0 N", F_y = "8 kN" }]

[rod]
calculator = "fatigue.history"
sigma = "=press.links.rod.N/(100 mm^2)"
sigma_D = "60 MPa"
N_D = 1e6
k = 5
)P");
    const project::Step& rod = *project.find("rod");
    const auto si = [&](const char* path) { return rod.value(path)->si[0]; };
    CHECK(rel(si("sigma_max"), maximum(*project.find("press")->value("links.rod.N")).value / 1e-4) < 1e-12);
    CHECK(rel(si("sigma_min"), minimum(*project.find("press")->value("links.rod.N")).value / 1e-4) < 1e-12);
    CHECK(si("n") >= 1.0);
    CHECK(rel(si("L"), si("Z") * 2.0) < 1e-9);  // 30 turns a minute
  }

  TEST_CASE("nothing passes that is left out of the count") {
    const std::string more = part + "n_req = 1\n";
    const std::string wave = R"({ values = [-80, 90, -60, 70, -80], unit = "MPa" })";
    CHECK(mode_of(of_history(wave, more), "h", "fatigue") == "pass");
    CHECK(mode_of(of_history(wave, more + "gate = \"10 MPa\""), "h", "fatigue") == "pass");
    CHECK(mode_of(of_history(wave, more + "gate = \"140 MPa\""), "h", "fatigue") == "not-covered");
    CHECK(mode_of(of_history(wave, more + "residue = \"ignored\""), "h", "residue") == "not-judged");
    CHECK(mode_of(of_history(wave, more + "residue = \"half-cycles\""), "h", "residue") == "none");
  }

  TEST_CASE("contradictory rules are refused") {
    CHECK(errors_of_history("\"40 MPa\"").find("not a load history") != std::string::npos);
    CHECK(errors_of_history(R"({ values = [50], unit = "MPa" })").find("has one value") != std::string::npos);
    CHECK(errors_of_history(R"({ values = [0, 300], unit = "MPa" })",
                            part + "counting = \"hcm\"\nresidue = \"half-cycles\"")
              .find("repeat the history") != std::string::npos);
    CHECK(errors_of_history("\"40 MPa\"\nblocks = [{ sigma_a = \"3 MPa\", n = 2 }]")
              .find("give either the stress sigma") != std::string::npos);
    CHECK(errors_of_history("{ values = [0, 9], unit = \"MPa\" }", "\nk = 5").find("needs sigma_D, N_D and k") !=
          std::string::npos);
    CHECK(errors_of_history("{ values = [0, 9], unit = \"MPa\" }", part + "sigma_C = \"71 MPa\"").size() > 0);
    CHECK(errors_of_history("{ values = [0, 9], unit = \"MPa\" }", part + "mean = \"goodman\"").size() > 0);
  }
}
