// Points by columns: mechanisms, series, sizes that are found. Each has the bits of the machine alone, and what takes
// no ordinary course is solved as one.
#include "calculators/mechanism/step.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/project/run/calculator_step.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/project/sweep/variants.hpp"
#include "tests/lib/project/sweep/swept.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

using namespace loadpath;
using test::Swept;

/// A rod whose method covers some diameters, between others that it does not cover.
struct Gapped {
  static constexpr auto id = "test.gapped", synonyms = "";
  static constexpr auto title = "A rod whose method has gaps";
  static constexpr auto scope = "Stress of a square rod, for some diameters.";
  static constexpr auto source = "[B19]";
  static constexpr auto example = "[rod]\ncalculator = \"test.gapped\"\nF = \"10 kN\"\n";
  struct Input {
    Force F = unset<Force>;
    Length d = unset<Length>;
  };
  static constexpr Fields inputs{Field{&Input::F, "F", N, "force"}.load(),
                                 Field{&Input::d, "d", mm, "diameter"}.positive().searched("R10").may_be_missing()};
  struct Result {
    Stress sigma = unset<Stress>;
    double u = unset<double>, x = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::sigma, "sigma", MPa, "stress"},
      Field{&Result::u, "u", ratio, "stress over the allowable one"}.check(),
      Field{&Result::x, "x", ratio, "whether the method is told of the diameter"}.limit(0, 1)};
  static constexpr std::array<Rule<Input>, 0> rules{};
  static constexpr std::array modes{
      Mode<Input>{"yield", "yield", [](const Input&) { return Applies::yes; }}.judged_by("u, x")};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace) {
    Result r;
    STEP_TO(r, sigma, in.F / (in.d * in.d), "square");
    STEP_TO(r, u, r.sigma / (100.0 * MPa.one), "strength");
    r.x = in.d > 30.0 * mm.one && in.d < 35.0 * mm.one ? 1.0 : 2.0;
    return r;
  }
};
template const Calculator& loadpath::erased<Gapped>();

namespace {

/// All that the program has, and the rod.
project::Catalogue with_gapped() {
  static const auto all = [] {
    std::vector<project::CatalogueEntry> entries(catalogue().begin(), catalogue().end());
    entries.push_back({&erased<Gapped>(), &project::make_calculator_step});
    return entries;
  }();
  return all;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (a != a && b != b);
}

double value_of(const project::SweptResult& column, const project::Project& machine) {
  static const Value none{{}, {std::nan("")}};
  return column.expression
      .evaluate([&](const std::string& path) -> const Value& {
        const Value* const known = machine.value(path);
        return known == nullptr ? none : *known;
      })
      .si[0];
}

double state_of(const project::SweptResult& column, const project::Project& machine) {
  account::Modes modes;
  for (const account::Mode& mode : project::modes(machine)) {
    if ((column.step.empty() || mode.step == column.step) && (column.mode.empty() || mode.id == column.mode))
      modes.push_back(mode);
  }
  if (modes.empty()) return column.mode.empty() ? static_cast<double>(account::State::open) : account::absent_state;
  return static_cast<double>(column.mode.empty() ? account::overall(modes) : account::worst(modes));
}

struct Compared {
  std::size_t points = 0, alone = 0, differ = 0, refused = 0;
};

/// Every point by columns, and as a machine of its own with all that `run` makes of it.
Compared compare(const std::string& text, const std::vector<std::string>& results,
                 project::Catalogue known = catalogue()) {
  const Swept swept(text, results, 1, {}, known);
  REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
  const std::size_t count = swept.column("state").size();
  project::Variants variants(swept.read_again(), results);
  std::vector<const double*> in;
  for (const auto& column : swept.inputs) in.push_back(column.data());
  std::vector<std::vector<double>> found(variants.outputs(), std::vector<double>(count));
  std::vector<double*> out;
  for (auto& column : found) out.push_back(column.data());
  variants.evaluate(in, out, count);
  Compared all{.points = count, .alone = variants.solved_alone()};
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<Issue> issues;
    project::Project machine = swept.read_again();
    project::set_point(machine, swept.plan, i, issues);
    if (!has_errors(issues)) project::solve(machine, issues);
    all.refused += has_errors(issues) ? 1 : 0;
    for (std::size_t k = 0; k < found.size() && !has_errors(issues); ++k) {
      const project::SweptResult& column = variants.columns()[k];
      const bool is_state = column.kind == project::SweptResult::Kind::state;
      if (!is_state && column.kind != project::SweptResult::Kind::expression) continue;
      const double alone = is_state ? state_of(column, machine) : value_of(column, machine);
      CHECK_MESSAGE(same_bits(found[k][i], alone), column.text, " at point ", i, ": ", found[k][i], " and ", alone);
      all.differ += same_bits(found[k][i], alone) ? 0 : 1;
    }
  }
  return all;
}

/// A slotted lever, with these lines for its crank, the crank's pin and the lever's mass.
std::string lever(const std::string& crank, const std::string& pin, const std::string& mass) {
  return "[lever]\ncalculator = \"mechanism.planar\"\ncrank = { joint = \"O\", " + crank +
         " }\n"
         "[lever.ground]\nO = [\"90 mm\", \"0 mm\"]\nB = [\"0 mm\", \"0 mm\"]\n"
         "[lever.links.crank]\npoints = { O = [\"0 mm\", \"0 mm\"], A = [" +
         pin + ", \"0 mm\"] }\nangle = \"-60 deg\"\n[lever.links.lever]\nangle = \"-14 deg\"\nmass = " + mass +
         "\nJ = \"0.14 kg*m^2\"\nS = \"S3\"\n[lever.links.lever.points]\nB = [\"0 mm\", \"0 mm\"]\n"
         "S3 = [\"55 mm\", \"0 mm\"]\nC = { r = \"40 mm\", angle = \"-20 deg\" }\n[lever.joints]\n"
         "O = { type = \"revolute\", links = [\"ground\", \"crank\"] }\n"
         "B = { type = \"revolute\", links = [\"ground\", \"lever\"] }\n"
         "A = { type = \"slot\", links = [\"crank\", \"lever\"], points = [\"A\", \"B\"], direction = \"0 deg\" }\n"
         "[[lever.loads]]\nname = \"F3\"\nlink = \"lever\"\nat = \"C\"\nF = \"720 N\"\ndirection = \"-110 deg\"\n"
         "axes = \"link\"\n";
}

const std::string even = "speed = \"45 rad/s\", start = \"-60 deg\", positions = 72";
const std::string pins = "{ from = \"26 mm\", to = \"34 mm\", count = 9 }";
const std::string crankshaft =
    "[crankshaft]\ncalculator = \"shaft.torsion\"\nT = \"=peak(lever.drive.M)\"\nK_A = 1.4\nmaterial = \"C45E\"\n"
    "tau_adm = \"30 MPa\"\ntheta_adm = \"0.25 deg/m\"\n";
const std::string crank_end =
    "[crank_end]\ncalculator = \"shaft.overhung\"\nload = \"=lever.drive\"\na = \"50 mm\"\nK_A = 1.4\n"
    "sigma_adm = \"60 MPa\"\ntau_adm = \"30 MPa\"\n";
const std::vector<std::string> loads = {"M = peak(lever.drive.M)", "F = max(lever.joints.A.F)",
                                        "there = at(lever.drive.M, 60 deg)"};

std::vector<std::string> with(std::vector<std::string> results, const std::vector<std::string>& more) {
  results.insert(results.end(), more.begin(), more.end());
  return results;
}

}  // namespace

TEST_SUITE("points of sweeps: columns") {
  TEST_CASE("a mechanism, a shaft for its peak and one over its positions, both with a size that is found") {
    const Compared all =
        compare(lever(even, pins, "[\"15 kg\", \"20 kg\"]") + crankshaft + crank_end,
                with(loads, {"d = crankshaft.d", "d_end = peak(crank_end.d)", "u = peak(crank_end.u_v)"}));
    CHECK(all.points == 18);
    CHECK(all.alone == 0);
    CHECK(all.differ == 0);
  }

  TEST_CASE("cranks with different starts have their series over different angles") {
    const std::string starts =
        "speed = \"45 rad/s\", start = { from = \"-70 deg\", to = \"-50 deg\", count = 5 }, positions = 72";
    const Compared all =
        compare(lever(starts, pins, "\"20 kg\"") + crank_end, with(loads, {"u = peak(crank_end.u_v)"}));
    CHECK(all.points == 45);
    CHECK(all.alone == 0);
    CHECK(all.differ == 0);
  }

  TEST_CASE("speeds of the crank are solved together, like lengths") {
    const std::string speeds =
        "speed = { from = \"20 rad/s\", to = \"60 rad/s\", count = 40 }, start = \"-60 deg\", positions = 72";
    const Compared all =
        compare(lever(speeds, "\"30 mm\"", "\"20 kg\"") + crankshaft + crank_end,
                with(loads, {"d = crankshaft.d", "u = peak(crank_end.u_v)", "M_mean = mean(lever.drive.M)"}));
    CHECK(all.points == 40);
    CHECK(all.alone == 0);
    CHECK(all.differ == 0);
  }

  TEST_CASE("inputs that need the speed of a series get that of each point") {
    const std::string speeds =
        "speed = { from = \"20 rad/s\", to = \"60 rad/s\", count = 5 }, start = \"-60 deg\", positions = 72";
    const std::string wheel =
        "[wheel]\ncalculator = \"machine.flywheel\"\nM = \"=lever.drive.M\"\nomega = \"=lever.crank.speed\"\ndelta "
        "= 0.02\n";
    const Compared all = compare(lever(speeds, "\"30 mm\"", "\"20 kg\"") + crank_end + wheel,
                                 {"u = peak(crank_end.u_v)", "J = wheel.J_F"});
    CHECK(all.points == 5);
    CHECK(all.differ == 0);
  }

  TEST_CASE("a flywheel takes the moment of each point, as a full series") {
    const std::string cranks =
        "speed = [\"45 rad/s\", \"30 rad/s\"], acceleration = [\"0 rad/s^2\", \"100 rad/s^2\"], start = \"-60 deg\", "
        "positions = 72";
    const auto wheel = [](const std::string& omega) {
      return "[wheel]\ncalculator = \"machine.flywheel\"\nM = \"=lever.drive.M\"\nomega = " + omega +
             "\ndelta = 0.02\n";
    };
    const std::string machine = lever(cranks, pins, "\"20 kg\"");
    const Compared as_crank = compare(machine + wheel("\"=lever.crank.speed\""), {"J = wheel.J_F"});
    CHECK(as_crank.points == 36);
    CHECK(as_crank.refused == 0);
    CHECK(as_crank.differ == 0);
    // At 30 rad/s it would turn at another speed than the crank, where that speed is constant.
    const Compared beside =
        compare(machine + crankshaft + wheel("\"45 rad/s\""), {"J = wheel.J_F", "d = crankshaft.d"});
    CHECK(beside.refused == 9);
    CHECK(beside.differ == 0);
  }

  TEST_CASE("speeds, one of them reversed") {
    const std::string speeds =
        "speed = [\"45 rad/s\", \"-30 rad/s\", \"5 rad/s\"], start = \"-60 deg\", positions = 72";
    CHECK(compare(lever(speeds, pins, "\"20 kg\"") + crankshaft, with(loads, {"d = crankshaft.d"})).differ == 0);
  }

  TEST_CASE("a four-bar that cannot revolve fails as when solved alone, its shaft is a machine of its own") {
    const std::string bar =
        "[bar]\ncalculator = \"mechanism.planar\"\ntemplate = \"four_bar\"\na = { from = \"10 mm\", to = \"40 mm\", "
        "count = "
        "11 }\nb = \"35 mm\"\nc = \"30 mm\"\nd = \"40 mm\"\ncrank.speed = \"600 rpm\"\nlinks.coupler.mass = \"2 kg\"\n"
        "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"=peak(bar.drive.M)\"\ntau_adm = \"30 MPa\"\nG = \"81 GPa\"\n";
    const Compared all = compare(bar, {"M = peak(bar.drive.M)", "d = shaft.d_min"});
    CHECK(all.alone > 0);
    CHECK(all.alone < all.points);
    CHECK(all.differ == 0);
  }

  TEST_CASE("limits that depend on the positions of the links are assessed at every point") {
    const std::string press =
        "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = { from = \"50 mm\", to = \"150 "
        "mm\", count = 11 }\nl = \"200 mm\"\ncrank = { speed = \"60 rpm\", positions = 36 }\nlinks.slider.mass = \"2 "
        "kg\"\njoints.guide = { guide_length = \"60 mm\", h_max = \"1 mm\" }\ngamma_min = \"60 deg\"\n"
        "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"=peak(press.drive.M)\"\ntau_adm = \"30 MPa\"\nG = \"81 "
        "GPa\"\n";
    const std::string state = "press.modes.transmission.state";
    const Compared all = compare(press, {"M = peak(press.drive.M)", "d = shaft.d_min", state});
    CHECK(all.points == 11);
    CHECK(all.differ == 0);
    const Swept swept(press, {state});
    CHECK(swept.column(state).front() == static_cast<double>(account::State::pass));
    CHECK(swept.column(state).back() == static_cast<double>(account::State::fail));  // r = 3/4 l
  }

  TEST_CASE("a link that loses its mass is refused as when solved alone") {
    const Compared all =
        compare(lever(even, "\"30 mm\"", "[\"20 kg\", \"10 kg\", \"0 kg\"]"), {"M = peak(lever.drive.M)"});
    const std::string text = lever(even, "\"30 mm\"", "[\"20 kg\", \"10 kg\", \"0 kg\"]");
    CHECK(all.refused == Swept(text, {"M = peak(lever.drive.M)"}).sum.tallies()[0].refused_points());
  }

  TEST_CASE("strengths fall with the diameter that is found") {
    const std::string shaft =
        "[shaft]\ncalculator = \"shaft.torsion\"\nmaterial = \"C45E\"\nS = 2\nT = { from = \"20 N*m\", to = "
        "\"60 kN*m\", log = 60 }\n";
    const Compared all = compare(shaft, {"shaft.d", "shaft.tau_max", "shaft.tau_all"});
    CHECK(all.points == 60);
    CHECK(all.alone < 30);  // beyond 100 mm the steel has no strength in the table
    CHECK(all.differ == 0);
  }

  TEST_CASE("a size within the limits of a method is found between some beyond them") {
    const std::string rod = "[rod]\ncalculator = \"test.gapped\"\nF = { from = \"1 kN\", to = \"200 kN\", log = 30 }\n";
    const Compared all = compare(rod, {"rod.d", "rod.x"}, with_gapped());
    CHECK(all.points == 30);
    CHECK(all.alone < 5);  // those without a size
    CHECK(all.differ == 0);
    const Swept swept(rod, {"rod.d"}, 1, {}, with_gapped());
    CHECK(swept.column("rod.d").front() == doctest::Approx(0.0315));
    CHECK(std::isnan(swept.column("rod.d").back()));  // too thin, and the method covers no thicker one
  }

  TEST_CASE("a force next to the torque, which torsion covers with no diameter") {
    const std::string over_turn =
        "[crankshaft]\ncalculator = \"shaft.torsion\"\nT = \"=lever.drive.M\"\nK_A = 1.4\nmaterial = "
        "\"C45E\"\ntau_adm = \"30 MPa\"\n";
    const Compared all =
        compare(lever(even, pins, "\"20 kg\"") + over_turn, {"d = max(crankshaft.d)", "F = max(crankshaft.F_bend)"});
    CHECK(all.points == 9);
    CHECK(all.alone == 0);
    CHECK(all.differ == 0);
  }

  TEST_CASE("a size that is found, and a strength that depends on it, are passed to other steps") {
    const std::string pin =
        "[pin]\ncalculator = \"pin.joint\"\nF = [\"100 kN\", \"10 kN\", \"1 kN\"]\nheld = \"in_fork\"\nloading = "
        "\"pulsating\"\nd = \"?\"\nt_1 = \"20 mm\"\nt_2 = \"12 mm\"\nc = \"0.5 mm\"\nmaterial = \"C45E\"\np_adm_1 = "
        "\"6000 "
        "MPa\"\np_adm_2 = \"8000 MPa\"\n[eye]\ncalculator = \"shaft.torsion\"\nT = \"10 N*m\"\nd = \"=pin.d\"\ntau_adm "
        "= "
        "\"30 MPa\"\nG = \"81 GPa\"\n";
    const Compared found = compare(pin, {"pin.d", "eye.d", "eye.tau_max", "R = pin.R_m"});
    CHECK(found.points == 3);
    CHECK(found.differ == 0);
    const std::string shafts =
        "[one]\ncalculator = \"shaft.torsion\"\nT = [\"1 N*m\", \"200 N*m\", \"20 kN*m\", \"2000 kN*m\"]\nmaterial = "
        "\"C45E\"\nS = 2\n[other]\ncalculator = \"shaft.torsion\"\nT = \"=one.T\"\nR_e = \"=one.R_e\"\nS = 2\n";
    CHECK(compare(shafts, {"one.R_e", "other.d", "other.tau_all"}).differ == 0);
    const std::string given =
        "[one]\ncalculator = \"shaft.torsion\"\nT = \"200 N*m\"\nmaterial = \"C45E\"\nS = 2\nd = [\"900 mm\", \"20 "
        "mm\", \"60 "
        "mm\"]\n";
    CHECK(compare(given, {"one.R_e", "one.tau_all"}).differ == 0);
  }

  TEST_CASE("the size of a part under a series is one number") {
    const std::string pin = lever(even, pins, "\"20 kg\"") +
                            "[pin]\ncalculator = \"pin.joint\"\nload = \"=lever.joints.A\"\nheld = "
                            "\"in_fork\"\nloading = \"pulsating\"\nd = "
                            "\"?\"\nt_1 = \"20 mm\"\nt_2 = \"12 mm\"\nc = \"0.5 mm\"\nmaterial = \"C45E\"\np_adm_1 = "
                            "\"6000 MPa\"\np_adm_2 = "
                            "\"8000 MPa\"\n[eye]\ncalculator = \"shaft.torsion\"\nT = \"10 N*m\"\nd = "
                            "\"=pin.d\"\ntau_adm = \"30 MPa\"\nG = "
                            "\"81 GPa\"\n";
    const Compared all = compare(pin, {"pin.d", "eye.d", "u = eye.u_tau"});
    CHECK(all.points == 9);
    CHECK(all.differ == 0);
  }

  TEST_CASE("load components that a step leaves out, at some points or at all") {
    const std::string end =
        "[crank_end]\ncalculator = \"shaft.overhung\"\nF = \"=lever.joints.A.F\"\nT = \"=lever.drive.M\"\na = \"50 "
        "mm\"\nK_A = 1.4\nsigma_adm = \"60 MPa\"\ntau_adm = \"30 MPa\"\n";
    const Compared always = compare(lever(even, pins, "\"20 kg\"") + crankshaft + end, {"u = peak(crank_end.u_v)"});
    CHECK(always.points == 9);
    CHECK(always.alone == 0);
    CHECK(always.differ == 0);
    // A spur gear has no axial force.
    const std::string gears =
        "[gears]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 60\nm_n = \"3 mm\"\nb = \"30 mm\"\nbeta = [\"10 deg\", "
        "\"0 deg\", \"15 deg\"]\nT_1 = \"100 N*m\"\nn_1 = \"1450 rpm\"\n[pinion]\ncalculator = \"shaft.overhung\"\nF = "
        "\"=gears.gear_1.F_y\"\nT = \"=gears.gear_1.T\"\na = \"50 mm\"\nK_A = 1.4\nsigma_adm = \"60 MPa\"\ntau_adm = "
        "\"30 MPa\"\n";
    CHECK(compare(gears, {"u = pinion.u_v"}).differ == 0);
  }

  TEST_CASE("a step that no varied input affects has its values at every point") {
    const std::string end =
        "[crank_end]\ncalculator = \"shaft.overhung\"\nload = \"=lever.drive\"\na = { from = \"40 mm\", to = \"60 "
        "mm\", "
        "count = 30 }\nK_A = 1.4\nsigma_adm = \"60 MPa\"\ntau_adm = \"30 MPa\"\n";
    const Compared all = compare(lever(even, "\"30 mm\"", "\"20 kg\"") + crankshaft + end,
                                 with(loads, {"d = crankshaft.d", "d_end = peak(crank_end.d)"}));
    CHECK(all.points == 30);
    CHECK(all.alone == 0);
    CHECK(all.differ == 0);
    // By a value that expressions contain, and by a size that another step takes.
    const std::string shafts =
        "[values]\nT = { from = \"50 N*m\", to = \"90 N*m\", count = 5 }\n[one]\ncalculator = \"shaft.torsion\"\nT = "
        "\"=2*values.T\"\nmaterial = \"C45E\"\nS = 2\n[other]\ncalculator = \"shaft.torsion\"\nT = \"10 N*m\"\nd = "
        "\"=one.d\"\ntau_adm = \"30 MPa\"\n[same]\ncalculator = \"shaft.torsion\"\nT = \"10 N*m\"\ntau_adm = \"30 "
        "MPa\"\n";
    const Compared by_value = compare(shafts, {"one.d", "other.tau_max", "same.d"});
    CHECK(by_value.points == 5);
    CHECK(by_value.differ == 0);
  }

  TEST_CASE("most mechanisms of a sweep are solved without display-only data") {
    const std::string text = lever(even, pins, "\"20 kg\"");
    std::vector<Issue> issues;
    project::Project project = project::read_project(text, "lever.toml", catalogue(), issues, project::Ranges::taken);
    project::Wanted numbers{
        .pictures = false, .formulas = false, .unused = false, .words = false, .series = project::SeriesChoice::none()};
    numbers.compared = {"lever.drive.M"};
    project::solve(project, issues, numbers);
    REQUIRE(!has_errors(issues));
    CHECK(dynamic_cast<const planar::MechanismStep&>(*project.steps[0]).is_ordinary());
    numbers.compared = {"lever.links.lever.swing"};  // read off the full cycle
    project::solve(project, issues, numbers);
    CHECK_FALSE(dynamic_cast<const planar::MechanismStep&>(*project.steps[0]).is_ordinary());
  }
}
