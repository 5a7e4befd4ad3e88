// Random shafts whose diameters are found together: none can be a size smaller with the others unchanged, and
// what it is said to fail is what it fails.
#include "lib/numerics/magnitude.hpp"
#include "lib/project/run/evaluation/providers.hpp"
#include "tests/lib/project/solved.hpp"
#include "tests/parts.hpp"
#include "tests/tries.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using account::State;
using test::contains;
using test::Solved;

/// A shoulder at each joint, or nothing: the segments next to it are one cylinder then. Lengths in mm.
struct Shaft {
  std::vector<int> lengths;
  std::vector<double> radii;  // of every joint; 0: nothing
  std::vector<std::string> given;
  std::size_t left = 0, right = 0;  // the pieces in whose middles the bearings are
  std::string loads;

  [[nodiscard]] std::size_t count() const { return lengths.size(); }
  [[nodiscard]] int end(std::size_t piece) const {
    int x = 0;
    for (std::size_t i = 0; i <= piece; ++i) x += lengths[i];
    return x;
  }
  [[nodiscard]] std::string middle(std::size_t piece) const {
    return std::to_string(end(piece) - lengths[piece] / 2) + " mm";
  }
  [[nodiscard]] bool is_like(std::size_t a, std::size_t b) const {
    if (a > b) std::swap(a, b);
    return std::all_of(radii.begin() + static_cast<std::ptrdiff_t>(a), radii.begin() + static_cast<std::ptrdiff_t>(b),
                       [](double r) { return r == 0.0; });
  }
  [[nodiscard]] const char* stock(std::size_t piece) const {
    return is_like(piece, left) || is_like(piece, right) ? "bearing" : "R40";
  }
  [[nodiscard]] std::string text(const std::vector<std::string>& d) const {
    std::string pieces, notches;
    for (std::size_t i = 0; i < count(); ++i) {
      pieces += "{ l = \"" + std::to_string(lengths[i]) + " mm\", d = \"" + d[i] + "\" }, ";
      if (i + 1 == count() || radii[i] == 0.0) continue;
      notches += "{ x = \"" + std::to_string(end(i)) + " mm\", kind = \"shoulder\", r = \"" + std::to_string(radii[i]) +
                 " mm\" }, ";
    }
    return "[axle]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\npieces = [" + pieces +
           "]\nnotches = [" + notches + "]\nsupports = [{ x = \"" + middle(left) + "\", holds = \"both\" }, { x = \"" +
           middle(right) + "\" }]\n" + loads;
  }
};

std::string quoted(double number, const char* unit) { return "\"" + std::to_string(number) + " " + unit + "\""; }

/// Wholly by what the generator gives, which is the same everywhere.
struct Draw {
  std::mt19937 random;
  int below(int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); }
  template <class Value>
  Value one_of(const std::vector<Value>& all) {
    return all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
  }
};

Shaft random_shaft(Draw& draw) {
  Shaft shaft;
  const int count = 3 + draw.below(5);
  for (int i = 0; i < count; ++i) {
    shaft.lengths.push_back(draw.one_of<int>({20, 30, 40, 50, 60, 80}));
    shaft.given.emplace_back("?");
    if (i > 0) shaft.radii.push_back(draw.below(6) == 0 ? 0.0 : draw.one_of<double>({1.6, 2.0, 2.5}));
  }
  shaft.left = static_cast<std::size_t>(draw.below(count / 2));
  shaft.right = shaft.count() - 1 - static_cast<std::size_t>(draw.below(count / 2));
  if (draw.below(4) == 0) {
    const std::size_t own = static_cast<std::size_t>(draw.below(count));
    for (std::size_t i = 0; i < shaft.count(); ++i) {
      if (shaft.is_like(i, own)) shaft.given[i] = "40 mm";
    }
  }
  const double T = draw.one_of<double>({30.0, 100.0, 300.0});
  const int length = shaft.end(shaft.count() - 1);
  shaft.loads = "seats = [{ x = \"2 mm\", way = \"drives\", T = " + quoted(T, "N*m") +
                " }, { x = " + quoted(0.1 * length + draw.below(8) * 0.1 * length, "mm") + ", T = " + quoted(T, "N*m") +
                ", F_x = " + quoted(draw.below(6000), "N") +
                " }]\nS_F = 1.5\nS_D = " + "1.5\nr_T = " + std::to_string(draw.below(3) - 1) + "\n";
  if (draw.below(2) == 0) shaft.loads += "v_adm = " + quoted(draw.one_of<double>({0.02, 0.05, 0.1}), "mm") + "\n";
  if (draw.below(2) == 0) shaft.loads += "d_h = \"100 mm\"\n";
  return shaft;
}

bool passes(const Solved& solved) {
  return solved.errors().empty() && std::all_of(solved.all.begin(), solved.all.end(), [](const account::Mode& mode) {
           return mode.state != State::fail && mode.state != State::not_covered;
         });
}

/// Whether a segment is too thin next to a neighbour: over which nothing can be pushed any more, or whose shoulder is
/// lower than its fillet.
bool is_unsound(const Shaft& shaft, const std::vector<double>& d, std::size_t piece, double less) {
  const auto beside = [&](std::size_t other) {
    const double r = shaft.radii[std::min(piece, other)];
    return r > 0.0 && (std::abs(less - d[other]) < 2.0 * r - 1e-6 || (d[piece] > d[other] && less < d[other]));
  };
  return (piece > 0 && beside(piece - 1)) || (piece + 1 < shaft.count() && beside(piece + 1));
}

/// The check that is beyond 1 most: "safeties[3].u_D"; of equal ones the first, as everywhere.
std::string worst(const Solved& solved) {
  const account::Mode* most = nullptr;
  for (const account::Mode& mode : solved.all) {
    if (mode.state != State::fail) continue;
    if (most == nullptr || numerics::exceeds(mode.utilisation.value_or(-1.0), most->utilisation.value_or(-1.0)))
      most = &mode;
  }
  return most == nullptr ? "" : most->governs;
}

/// How many of its cylinders were made a size smaller.
int try_smaller(const Shaft& shaft, const Solved& found) {
  std::vector<double> d;
  for (std::size_t i = 0; i < shaft.count(); ++i)
    d.push_back(1e3 * found.value("axle.pieces[" + std::to_string(i + 1) + "].d"));
  int tried = 0;
  for (std::size_t i = 0; i < shaft.count(); ++i) {
    if (shaft.given[i] != "?" || (i > 0 && shaft.radii[i - 1] == 0.0)) continue;
    const std::vector<double> stock = project::stock_values(*found.project.tables, shaft.stock(i));
    const auto own = std::lower_bound(stock.begin(), stock.end(), 1e-3 * (d[i] - 1e-6));
    if (own == stock.begin()) continue;
    const double less = 1e3 * *std::prev(own);
    bool unsound = false;
    std::vector<std::string> typed;
    for (std::size_t k = 0; k < shaft.count(); ++k) {
      unsound = unsound || (shaft.is_like(i, k) && is_unsound(shaft, d, k, less));
      typed.push_back(std::to_string(shaft.is_like(i, k) ? less : d[k]) + " mm");
    }
    const std::string why = found.origin("axle", "pieces[" + std::to_string(i + 1) + "].d");
    CAPTURE(shaft.text(typed));
    CAPTURE(why);
    CHECK(unsound == (contains(why, "shoulder at x = ") || contains(why, "pushed over")));
    if (unsound) continue;
    ++tried;
    const Solved smaller(shaft.text(typed));
    CHECK_FALSE(passes(smaller));
    CHECK(contains(why, worst(smaller)));
  }
  return tried;
}

}  // namespace

TEST_SUITE("smallest shafts" * test::by_case) {
  TEST_CASE("for random shafts no diameter can be a size smaller, and each states why it would fail") {
    Draw draw{std::mt19937(5)};
    int found = 0, tried = 0;
    const int shafts = test::sanitized ? 6 : 24;
    for (int i = 0; i < shafts; ++i) {
      const Shaft shaft = random_shaft(draw);
      const Solved solved(shaft.text(shaft.given));
      if (!passes(solved)) continue;  // of fillets that are outside Peterson's range next to the steps of bearings
      ++found;
      tried += try_smaller(shaft, solved);
    }
    CHECK(2 * found >= shafts);
    CHECK(tried >= shafts);
  }
}
