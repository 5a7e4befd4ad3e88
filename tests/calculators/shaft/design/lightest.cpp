// The search for the diameters of a shaft against all that its stocks offer: shafts with loads between, outside and on
// both sides of the bearings, of which two to five pieces are searched for. What is found passes, and no lighter shaft
// does.
#include "calculators/shaft/design/design.hpp"
#include "lib/numerics/magnitude.hpp"
#include "lib/project/run/calculator_step.hpp"
#include "lib/project/run/evaluation/providers.hpp"
#include "tests/lib/project/solved.hpp"
#include "tests/parts.hpp"
#include "tests/tries.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using test::Solved;

/// Pieces in mm, with a shoulder between each and the next; loads at the ends, between the bearings, or both.
struct Layshaft {
  std::vector<int> lengths;
  std::vector<double> radii;  // fillets of the shoulders
  std::vector<double> given;  // diameters; 0: searched for
  std::size_t left = 0, right = 0;
  std::string loads;

  [[nodiscard]] std::size_t count() const { return lengths.size(); }
  [[nodiscard]] bool is_seat(std::size_t i) const { return i == left || i == right; }
  [[nodiscard]] int end(std::size_t i) const {
    int x = 0;
    for (std::size_t k = 0; k <= i; ++k) x += lengths[k];
    return x;
  }
  [[nodiscard]] std::string middle(std::size_t i) const { return std::to_string(end(i) - lengths[i] / 2) + " mm"; }
  [[nodiscard]] std::string text() const {
    std::string pieces, notches;
    for (std::size_t i = 0; i < count(); ++i) {
      pieces += "{ l = \"" + std::to_string(lengths[i]) + " mm\", d = \"" +
                (given[i] > 0.0 ? std::to_string(given[i]) + " mm" : "?") + "\" }, ";
      if (i + 1 == count()) continue;
      notches += "{ x = \"" + std::to_string(end(i)) + " mm\", kind = \"shoulder\", r = \"" + std::to_string(radii[i]) +
                 " mm\" }, ";
    }
    return "[axle]\ncalculator = \"shaft.design\"\nE = \"210 GPa\"\nG = \"80 GPa\"\nrho = \"7850 kg/m^3\"\nR_e = \"370 "
           "MPa\"\n"
           "R_m = \"630 MPa\"\ngroup = \"carbon-steel\"\nS_F = 1.5\nS_D = 1.5\nr_T = 0\npieces = [" +
           pieces + "]\nnotches = [" + notches + "]\nsupports = [{ x = \"" + middle(left) +
           "\", holds = \"both\" }, { x = \"" + middle(right) + "\" }]\n" + loads;
  }
};

/// By what the generator gives alone, which is the same everywhere.
struct Draw {
  std::mt19937 random;
  int below(int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); }
  int from(std::initializer_list<int> all) { return all.begin()[below(static_cast<int>(all.size()))]; }
};

std::string mm_text(double x) { return "\"" + std::to_string(x) + " mm\""; }

/// A wheel in the middle of a piece.
std::string wheel(const Layshaft& shaft, std::size_t piece, const char* way, int T, int F, int angle) {
  return "{ x = \"" + shaft.middle(piece) + "\", way = \"" + way + "\", T = \"" + std::to_string(T) +
         " N*m\", F_x = \"" + std::to_string(F) + " N\", angle = \"" + std::to_string(angle) + " deg\" }, ";
}

Layshaft drawn(Draw& draw) {
  Layshaft shaft;
  const int where = draw.below(3);  // 0: both loads outside; 1: both between; 2: one of each
  const std::size_t outside = where == 0 ? 2 : where == 2 ? 1 : 0, between = where == 1 ? 2 : 1;
  const std::size_t before = outside > 0 ? 1 : 0, after = outside > 1 ? 1 : 0;
  const std::size_t count = before + 1 + between + 1 + after;
  shaft.left = before;
  shaft.right = before + 1 + between;
  for (std::size_t i = 0; i < count; ++i) {
    shaft.lengths.push_back(shaft.is_seat(i) ? draw.from({16, 20, 40, 60}) : draw.from({40, 60, 80, 150}));
    shaft.given.push_back(0.0);
    if (i > 0) shaft.radii.push_back(draw.from({10, 16, 20}) / 10.0);
  }
  const int T = draw.from({50, 120, 200}), F = 500 + draw.below(4000), G = 500 + draw.below(4000);
  const std::size_t first = where == 0 ? 0 : where == 2 ? 0 : shaft.left + 1;
  const std::size_t second = where == 0 ? count - 1 : shaft.right - 1;
  shaft.loads = "seats = [" + wheel(shaft, first, "drives", T, F, draw.below(360)) +
                wheel(shaft, second, "takes", T, G, draw.below(360)) + "]\n";
  if (draw.below(3) == 0) shaft.loads += "v_adm = " + mm_text(draw.from({5, 10, 20}) / 100.0) + "\n";
  return shaft;
}

/// What the pieces may be, ascending, in m.
std::vector<std::vector<double>> stocks_of(const Layshaft& shaft, const project::Project& project) {
  std::vector<std::vector<double>> all;
  for (std::size_t i = 0; i < shaft.count(); ++i) {
    if (shaft.given[i] > 0.0)
      all.push_back({1e-3 * shaft.given[i]});
    else
      all.push_back(project::stock_values(*project.tables, shaft.is_seat(i) ? "bearing" : "R40"));
  }
  return all;
}

/// All shafts of these stocks that are lighter than one of this volume.
struct Enumeration {
  const Layshaft& shaft;
  const project::CalculatorStep& step;
  std::vector<std::vector<double>> stocks;
  Record record;
  double lowest;  // volume, m^3
  std::vector<double> d = {};
  std::vector<double> lightest = {};
  bool found = false;

  [[nodiscard]] static double volume(double d, int l) { return pi / 4.0 * d * d * 1e-3 * l; }
  /// The diameters fall to both ends from a piece between the bearings, with a shoulder of its fillet's height at least
  /// at each joint.
  [[nodiscard]] bool is_shaft() const {
    std::size_t top = 0;
    for (std::size_t i = 1; i < d.size(); ++i) {
      if (d[i] > d[top]) top = i;
    }
    if (top <= shaft.left || top >= shaft.right) return false;
    for (std::size_t i = 0; i + 1 < d.size(); ++i) {
      const double step_up = i < top ? d[i + 1] - d[i] : d[i] - d[i + 1];
      if (step_up < 2e-3 * shaft.radii[i] * (1.0 - 1e-9)) return false;
    }
    return true;
  }
  [[nodiscard]] bool passes() {
    const Calculator& calculator = *step.input().calculator;
    for (std::size_t i = 0; i < d.size(); ++i) find_leaf(record, "pieces[" + std::to_string(i + 1) + "].d").set(d[i]);
    for (std::size_t rule = 0; rule < calculator.rules.size(); ++rule) {
      if (!calculator.rules[rule].only_warns && !calculator.holds(rule, record.data.get())) return false;
    }
    const Record result(*calculator.result);
    calculator.evaluate(record.data.get(), result.data.get());
    bool all = true;
    for_each_leaf(result, [&](const std::string&, const Leaf& leaf) {
      const FieldInfo& f = *leaf.field;
      if ((f.role != Role::check && f.role != Role::limit) || f.is_informative || !step.is_asked(f, record)) return;
      const double x = leaf.get();
      if (std::isnan(x))
        all = all && f.where_set;
      else
        all = all && (f.role == Role::check ? x <= 1.0 + 1e-9 : f.bounds.holds(x));
    });
    return all;
  }
  void search(std::size_t i, double V) {
    if (i == stocks.size()) {
      if (!is_shaft() || !passes()) return;
      lowest = V;
      lightest = d;
      found = true;
      return;
    }
    double rest = 0.0;
    for (std::size_t k = i + 1; k < stocks.size(); ++k) rest += volume(stocks[k].front(), shaft.lengths[k]);
    for (const double size : stocks[i]) {
      const double now = V + volume(size, shaft.lengths[i]);
      if (!numerics::exceeds(lowest, now + rest)) break;
      d.push_back(size);
      search(i + 1, now);
      d.pop_back();
    }
  }
};

struct Tally {
  int found = 0, none = 0, lighter = 0;
  double worst = 0.0;  // how much heavier than the lightest
};

void compare(const Layshaft& shaft, Tally& tally) {
  const Solved solved(shaft.text());
  CAPTURE(shaft.text());
  REQUIRE_MESSAGE(solved.errors().empty(), solved.errors());
  const auto& step = dynamic_cast<const project::CalculatorStep&>(*solved.project.find("axle"));
  Enumeration all{shaft, step, stocks_of(shaft, solved.project), step.input().reading.record.clone(),
                  std::numeric_limits<double>::infinity()};
  double V = 0.0;
  for (std::size_t i = 0; i < shaft.count(); ++i) {
    all.d.push_back(solved.value("axle.pieces[" + std::to_string(i + 1) + "].d"));
    V += Enumeration::volume(all.d.back(), shaft.lengths[i]);
  }
  const bool passes = all.is_shaft() && all.passes();
  (passes ? tally.found : tally.none) += 1;
  for (auto& stock : all.stocks) std::erase_if(stock, [](double size) { return size < 0.012 || size > 0.2; });
  all.d.clear();
  if (passes) all.lowest = V;
  all.search(0, 0.0);
  CHECK_FALSE((!passes && all.found));
  if (passes && all.found) {
    ++tally.lighter;
    tally.worst = std::max(tally.worst, V / all.lowest - 1.0);
    std::string sizes;
    for (const double size : all.lightest) sizes += " " + std::to_string(1e3 * size);
    MESSAGE((V / all.lowest - 1.0), sizes, "\n", shaft.text());
  }
}

/// An overhung shaft whose deflection decides: from brute force over typed sizes, 40, 30, 26.5, 13.2 mm are lighter
/// than 40, 31.5, 25, 10.6 mm, of which no single one can be smaller.
const std::string overhung_shaft = R"([axle]
calculator = "shaft.design"
material = "C45E"
group = "carbon-steel"
n = "500 rpm"
pieces = [
  { l = "40 mm", d = "30 mm" },
  { l = "40 mm", d = "?" },
  { l = "80 mm", d = "?" },
  { l = "60 mm", d = "?" },
  { l = "20 mm", d = "?" },
]
supports = [
  { x = "12 mm", holds = "both" },
  { x = "52 mm" },
]
seats = [
  { x = "120 mm", F_x = "1000.5958 N", angle = "-19.014406 deg" },
  { x = "230 mm", F_x = "1000.0465 N", angle = "147.454107 deg" },
]
notches = [
  { x = "40 mm", kind = "shoulder", r = "1 mm" },
  { x = "80 mm", kind = "shoulder", r = "0.4 mm", h = "2.4 mm" },
  { x = "160 mm", kind = "shoulder", r = "0.4 mm" },
  { x = "220 mm", kind = "shoulder", r = "1.6 mm", h = "2.1 mm" },
  { x = "229 mm", kind = "groove", r = "1 mm", t = "1 mm" },
]
S_F = 1.5
S_D = 2
r_T = 0
v_adm = "0.2 mm"
)";

/// Bearings on two adjacent segments and none free between them; the shaft is bent most in the middle one.
const std::string adjacent_bearings = R"([axle]
calculator = "shaft.design"
n = "500 rpm"
pieces = [{ l = "120 mm", d = "?" }, { l = "30 mm", d = "?" }, { l = "40 mm", d = "?" }]
supports = [{ x = "129 mm", holds = "both" }, { x = "178 mm" }]
seats = [
  { x = "60 mm", integral = true, F_x = "1000 N", angle = "-26.5 deg" },
  { x = "96 mm", integral = true, T = "80 N*m", F_x = "1000 N", angle = "149.9 deg", F_z = "500 N" },
  { x = "144 mm", integral = true, F_x = "3000 N", angle = "59.4 deg" },
  { x = "170 mm", integral = true, T = "80 N*m", way = "drives", F_x = "8000 N", angle = "-121.8 deg" },
]
notches = [
  { x = "120 mm", kind = "shoulder", r = "0.4 mm" },
  { x = "150 mm", kind = "shoulder", r = "2 mm", h = "3 mm" },
]
S_F = 2.5
material = "42CrMo4"
group = "alloy-steel"
)";

/// The bearing seat on the right is one cylinder with a given end of 20 mm, and so no more than that.
const std::string given_end = R"([axle]
calculator = "shaft.design"
E = "210 GPa"
G = "80 GPa"
rho = "7850 kg/m^3"
R_e = "370 MPa"
R_m = "630 MPa"
group = "carbon-steel"
S_F = 1.2
S_D = 1.2
r_T = -1
n = "3000 rpm"
v_adm = "0.2 mm"
pieces = [
  { l = "40 mm", d = "?" },
  { l = "60 mm", d = "?" },
  { l = "80 mm", d = "?" },
  { l = "30 mm", d = "?" },
  { l = "60 mm", d = "20 mm" },
]
notches = [
  { x = "40 mm", kind = "shoulder", r = "2.5 mm" },
  { x = "100 mm", kind = "shoulder", r = "0.4 mm", h = "3 mm" },
  { x = "180 mm", kind = "shoulder", r = "1 mm" },
  { x = "34 mm", kind = "groove", r = "1 mm", t = "1 mm" },
]
supports = [{ x = "70 mm", holds = "both" }, { x = "195 mm" }, ]
seats = [
  { x = "20 mm", integral = true, way = "drives", T = "20 N*m", F_x = "4983 N", F_y = "0 N", angle = "114 deg" },
  { x = "240 mm", integral = true, way = "takes", T = "20 N*m", F_x = "2328 N", F_y = "0 N", angle = "285 deg" },
]
)";

}  // namespace

TEST_SUITE("lightest shafts" * test::takes_share) {
  TEST_CASE("where the deflection governs, one size is smaller if others are larger") {
    const Solved solved(overhung_shaft);
    REQUIRE_MESSAGE(solved.errors().empty(), solved.errors());
    const std::vector<double> expected{0.03, 0.04, 0.03, 0.0265, 0.0132};
    for (std::size_t i = 0; i < expected.size(); ++i)
      CHECK(solved.value("axle.pieces[" + std::to_string(i + 1) + "].d") == doctest::Approx(expected[i]));
  }

  TEST_CASE("where no segment between the bearings is free, each may be the thickest") {
    const Solved solved(adjacent_bearings);
    REQUIRE_MESSAGE(solved.errors().empty(), solved.errors());
    const std::vector<double> expected{0.014, 0.022, 0.015};  // 14, 15, 22 mm passes too, 5 % heavier
    for (std::size_t i = 0; i < expected.size(); ++i)
      CHECK(solved.value("axle.pieces[" + std::to_string(i + 1) + "].d") == doctest::Approx(expected[i]));
  }

  TEST_CASE("where a given end limits one size, the others may be larger") {
    const Solved solved(given_end);
    REQUIRE_MESSAGE(solved.errors().empty(), solved.errors());
    const std::vector<double> expected{0.0224, 0.028, 0.0355, 0.02};  // from brute force over typed sizes
    for (std::size_t i = 0; i < expected.size(); ++i)
      CHECK(solved.value("axle.pieces[" + std::to_string(i + 1) + "].d") == doctest::Approx(expected[i]));
  }

  TEST_CASE("for random shafts no lighter one passes") {
    Draw draw{std::mt19937(29)};
    Tally tally;
    for (int i = 0; i < test::tries(300, test::sanitized ? 100 : 30); ++i) compare(drawn(draw), tally);
    MESSAGE(tally.found, " found, ", tally.none, " none, ", tally.lighter, " not the lightest, worst ", tally.worst);
    CHECK(tally.lighter == 0);
  }
}
