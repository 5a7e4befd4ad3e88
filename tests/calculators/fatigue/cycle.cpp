#include "calculators/fatigue/cycle.hpp"

#include "calculators/catalogue.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/lib/project/says.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace {

using namespace loadpath;
using fatigue::Kind;
constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr auto cycle = test::evaluated<fatigue::Cycle>;

/// One of the five characteristics by its place in the list, MPa.
void set(fatigue::Given& g, int which, double value) {
  Stress* stresses[] = {&g.sigma_max, &g.sigma_min, &g.sigma_m, &g.sigma_a};
  if (which == 4) {
    g.r = value;
  } else {
    *stresses[which] = value * MPa;
  }
}

double get(const fatigue::Characteristics& c, int which) {
  const double values[] = {c.sigma_max / MPa, c.sigma_min / MPa, c.sigma_m / MPa, c.sigma_a / MPa, c.r};
  return values[which];
}

bool says(const std::string& lines, const std::string& words) {
  return test::says("[c]\ncalculator = \"fatigue.cycle\"\n" + lines, words);
}

struct Known {
  double values[5];
  Kind kind;
};

/// Cycles of every kind: largest, least, mean, amplitude, ratio.
const Known known[] = {{{120, -40, 40, 80, -1.0 / 3}, Kind::alternating}, {{40, -120, -40, 80, -3}, Kind::alternating},
                       {{100, -100, 0, 100, -1}, Kind::symmetric},        {{200, 0, 100, 100, 0}, Kind::above},
                       {{0, -200, -100, 100, infinity}, Kind::below},     {{150, 150, 150, 0, 1}, Kind::constant},
                       {{-150, -150, -150, 0, 1}, Kind::constant},        {{180, 60, 120, 60, 1.0 / 3}, Kind::tensile},
                       {{-60, -180, -120, 60, 3}, Kind::compressive}};

}  // namespace

TEST_SUITE("fatigue.cycle") {
  TEST_CASE("any two characteristics give the other three, or a reason why they cannot") {
    int refused = 0;
    for (const Known& k : known) {
      for (int a = 0; a < 5; ++a) {
        for (int b = a + 1; b < 5; ++b) {
          fatigue::Cycle::Input in;
          set(in, a, k.values[a]), set(in, b, k.values[b]);
          CAPTURE(k.values[4]);
          CAPTURE(a);
          CAPTURE(b);
          if (!fatigue::Cycle::sound(in)) {
            ++refused;
            CHECK(b == 4);  // only a ratio can leave the size open
            continue;
          }
          const auto c = cycle(in);
          CHECK(c.kind == k.kind);
          for (int i = 0; i < 5; ++i) {
            if (std::isinf(k.values[i])) {
              CHECK(std::isinf(get(c, i)));
            } else {
              CHECK(std::abs(get(c, i) - k.values[i]) <= 1e-12 * 200);
            }
          }
        }
      }
    }
    CHECK(refused == 5);  // (r=-1, mean), (r=0, least), (r=inf, largest), (r=1, amplitude) twice
  }

  TEST_CASE("both infinite ratios are the same point") {
    for (const double r : {infinity, -infinity}) {
      fatigue::Cycle::Input in;
      in.r = r, in.sigma_a = 50.0 * MPa;
      REQUIRE(fatigue::Cycle::sound(in));
      CHECK(in_si(cycle(in).sigma_min) == -100e6);
      CHECK(cycle(in).r == infinity);
    }
  }

  TEST_CASE("an infinite ratio is read as a word and never written as a number") {
    for (const std::string r : {"inf", "-inf", "\"inf\"", "\"+inf\""}) {
      std::vector<Issue> issues;
      project::Project p =
          project::read_project("[c]\ncalculator = \"fatigue.cycle\"\nsigma_min = \"-80 MPa\"\nr = " + r + "\n",
                                "c.toml", catalogue(), issues);
      project::solve(p, issues);
      CHECK(issues.empty());
      CHECK(p.value("c.sigma_a")->si[0] == 40e6);
    }
  }

  TEST_CASE("pairs that leave the size of the cycle open are refused with the reason") {
    CHECK(says("r = -1\nsigma_m = \"0 MPa\"\n", "has no mean stress"));
    CHECK(says("r = 1\nsigma_a = \"0 MPa\"\n", "has no amplitude"));
    CHECK(says("r = inf\nsigma_max = \"0 MPa\"\n", "does not determine the cycle"));
    CHECK(says("r = 0\nsigma_min = \"0 MPa\"\n", "does not determine the cycle"));
  }

  TEST_CASE("pairs that contradict each other are refused with the reason") {
    CHECK(says("sigma_max = \"10 MPa\"\nsigma_min = \"20 MPa\"\n", "sigma_max is below sigma_min"));
    CHECK(says("sigma_max = \"10 MPa\"\nsigma_m = \"20 MPa\"\n", "below the mean"));
    CHECK(says("sigma_min = \"30 MPa\"\nsigma_m = \"20 MPa\"\n", "above the mean"));
    CHECK(says("sigma_max = \"10 MPa\"\nr = 2\n", "must be negative"));
    CHECK(says("sigma_max = \"-10 MPa\"\nr = 0.5\n", "needs r >= 1"));
    CHECK(says("sigma_min = \"10 MPa\"\nr = -1\n", "0 < r <= 1"));
    CHECK(says("sigma_min = \"-10 MPa\"\nr = 0.5\n", "r < 0 or r >= 1"));
    CHECK(says("sigma_m = \"10 MPa\"\nr = 2\n", "-1 < r <= 1"));
    CHECK(says("sigma_m = \"-10 MPa\"\nr = 0\n", "r < -1 or r >= 1"));
    CHECK(says("sigma_max = \"0 MPa\"\nsigma_min = \"0 MPa\"\n", "no cycle"));
    CHECK(says("sigma_a = \"-10 MPa\"\nr = 0\n", "must be"));
  }

  TEST_CASE("one characteristic or three do not make a cycle; the message states how many there are and where") {
    CHECK(says("sigma_max = \"10 MPa\"\n", "given here: 1"));
    CHECK(says("sigma_max = \"10 MPa\"\nsigma_min = \"0 MPa\"\nr = 0\n", "given here: 3"));
    CHECK(says("sigma_max = \"10 MPa\"\nr = 0\nothers = [{ sigma_a = \"3 MPa\" }]\n", "c.others[1].sigma_a"));
    CHECK(says("sigma_max = \"10 MPa\"\nr = 0\nothers = [{ name = \"b\", sigma_m = \"3 MPa\", r = -1 }]\n",
               "has no mean stress"));
  }

  TEST_CASE("cycles of one ratio are similar, at any size; opposite ones are not") {
    fatigue::Cycle::Input in;
    in.sigma_max = 120.0 * MPa, in.sigma_min = -40.0 * MPa;
    for (const double factor : {0.1, 1.0, 2.5, -1.0}) {
      fatigue::Cycle::Other other;
      const double a = 120.0 * factor, b = -40.0 * factor;
      other.sigma_max = std::max(a, b) * MPa, other.sigma_min = std::min(a, b) * MPa;
      in.others.push_back(other);
    }
    const auto r = cycle(in);
    for (std::size_t i = 0; i < 3; ++i) CHECK(r.others[i].similar == fatigue::Cycle::Similar::yes);
    CHECK(r.others[3].similar == fatigue::Cycle::Similar::no);
  }

  TEST_CASE("the largest stress is checked against yielding, in shear by von Mises") {
    fatigue::Cycle::Input in;
    in.sigma_max = 60.0 * MPa, in.sigma_min = -180.0 * MPa, in.R_e = 360.0 * MPa;
    CHECK(std::abs(cycle(in).u_y - 0.5) < 1e-12);
    in.stress = Stresses::shear;
    CHECK(std::abs(cycle(in).u_y - 0.5 * std::sqrt(3.0)) < 1e-12);
  }
}
