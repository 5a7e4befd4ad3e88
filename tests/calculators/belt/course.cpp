#include "calculators/belt/course.hpp"

#include "calculators/belt/flat.hpp"
#include "calculators/belt/geometry.hpp"
#include "tests/calculators/belt/steps.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/lib/project/texts.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

using namespace loadpath;
using test::BeltStep;
using test::replaced;
using test::with;
using Pulley = belt::Course::Pulley;
using Side = belt::Course::Side;

Pulley pulley(double x, double y, double d, Side side = Side::inside, Power P = unset<Power>) {
  Pulley p;
  p.x = x * mm, p.y = y * mm, p.d = d * mm;
  p.side = side, p.P = P;
  return p;
}

belt::Course::Input around(std::initializer_list<Pulley> pulleys,
                           belt::Course::Turns turns = belt::Course::Turns::ccw) {
  belt::Course::Input in;
  for (const Pulley& p : pulleys) in.pulleys.push_back(p);
  in.turns = turns;
  return in;
}

/// The motor, a roller on the slack span, a pump and a fan.
belt::Course::Input machine() {
  auto in =
      around({pulley(0.0, 0.0, 160.0), pulley(148.0, 229.0, 80.0, Side::outside),
              pulley(300.0, 480.0, 200.0, Side::inside, 3.0 * kW), pulley(600.0, 100.0, 250.0, Side::inside, 4.0 * kW)},
             belt::Course::Turns::cw);
  in.n_1 = 1450.0 * rpm, in.mu = 0.5, in.q = 0.3 * kg_per_m;
  return in;
}

constexpr auto solve = test::evaluated<belt::Course>;

double in_mm(Length l) { return in_si(l) * 1e3; }

const std::string text = R"(calculator = "belt.course"
n_1 = "1450 rpm"
mu = 0.5
L = "2360 mm"
turns = "cw"
pulleys = [{ name = "motor", x = "0 mm", y = "0 mm", d = "160 mm" }, { name = "roller", x = "60 mm", y = "280 mm", d = "80 mm", side = "outside", along = "-30 deg" }, { name = "pump", x = "300 mm", y = "480 mm", d = "200 mm", P = "3 kW" }, { name = "fan", x = "600 mm", y = "100 mm", d = "250 mm", P = "4 kW" }]
)";

}  // namespace

TEST_SUITE("belt course") {
  TEST_CASE("around equal pulleys the belt is as long as the polygon of their centres plus one circumference") {
    const auto r = solve(around({pulley(0, 0, 100), pulley(600, 0, 100), pulley(600, 450, 100)}));
    CHECK(in_mm(r.L) == doctest::Approx(600.0 + 450.0 + 750.0 + 100.0 * pi).epsilon(1e-14));
    CHECK(r.pulleys[0].alpha == doctest::Approx(pi - std::atan2(450.0, 600.0)).epsilon(1e-14));
    CHECK(r.pulleys[1].alpha == doctest::Approx(pi / 2.0).epsilon(1e-14));
    CHECK(in_mm(r.pulleys[2].l_s) == doctest::Approx(750.0).epsilon(1e-14));
  }

  TEST_CASE("around two pulleys the belt is the open drive") {
    for (const double d : {80.0, 200.0, 560.0}) {
      const auto r = solve(around({pulley(0, 0, 200), pulley(700, 300, d)}));
      NoTrace trace;
      belt::Flat::Result open;
      belt::lay({200.0 * mm, d * mm, std::hypot(700.0, 300.0) * mm, unset<Length>, belt::Arrangement::open}, open,
                trace);
      CHECK(in_mm(r.L) == doctest::Approx(in_mm(open.L)).epsilon(1e-13));
      CHECK(r.pulleys[0].alpha == doctest::Approx(open.alpha_1).epsilon(1e-13));
      CHECK(r.pulleys[1].alpha == doctest::Approx(open.alpha_2).epsilon(1e-13));
    }
  }

  // Contact angles acos((r_1 -+ r_2) / d) of every pair, computed apart.
  TEST_CASE("with a roller outside: spans, wraps and length of an independent computation") {
    const auto r = solve(machine());
    CHECK(in_mm(r.L) == doctest::Approx(2359.841948512847).epsilon(1e-12));
    const double spans[] = {244.83668025849394, 257.8856335665095, 483.50284383858593, 606.6094295343587};
    const double wraps[] = {154.20436015277076, 56.282953923658525, 136.04826126877822, 126.03033250210947};
    for (std::size_t k = 0; k < 4; ++k) {
      CHECK(in_mm(r.pulleys[k].l_s) == doctest::Approx(spans[k]).epsilon(1e-12));
      CHECK(r.pulleys[k].alpha * 180.0 / pi == doctest::Approx(wraps[k]).epsilon(1e-12));
    }
  }

  TEST_CASE("the loads of all shafts are in balance, forces, moments and powers") {
    const auto in = machine();
    const auto r = solve(in);
    double x = 0.0, y = 0.0, M = 0.0, P = 0.0;
    for (const auto& p : r.pulleys) {
      x += in_si(p.R_x), y += in_si(p.R_y);
      M += in_si(p.x * p.R_y - p.y * p.R_x + p.T);
      P += in_si(p.T * p.n);
    }
    const double size = in_si(r.S_max);
    CHECK(std::abs(x) < 1e-12 * size);
    CHECK(std::abs(y) < 1e-12 * size);
    CHECK(std::abs(M) < 1e-12 * size);
    CHECK(std::abs(P) < 1e-12 * in_si(r.P_1));
    CHECK(in_si(r.P_1) == doctest::Approx(7000.0));
    CHECK(in_si(r.pulleys[1].T) == doctest::Approx(0.0));
  }

  TEST_CASE("with the minimum tension one pulley uses all of its friction, the others less") {
    const auto r = solve(machine());
    double most = 0.0;
    for (const auto& p : r.pulleys) most = std::max(most, p.mu_req);
    CHECK(most == doctest::Approx(0.5).epsilon(1e-12));
    CHECK(r.u_S == doctest::Approx(1.0));
    auto tighter = machine();
    tighter.S_0 = 2.0 * r.S_0_min;
    CHECK(solve(tighter).u_S == doctest::Approx(0.5));
    tighter.mu = 0.8;
    CHECK(solve(tighter).u_S < 0.5);
  }

  TEST_CASE("mirroring and reversed rotation change no length, and scaling changes it in proportion") {
    auto in = machine();
    const auto before = solve(in);
    for (Pulley& p : in.pulleys) p.x = -p.x;
    in.turns = belt::Course::Turns::ccw;
    CHECK(in_mm(solve(in).L) == doctest::Approx(in_mm(before.L)).epsilon(1e-14));
    for (Pulley& p : in.pulleys) p.x = 3.0 * p.x, p.y = 3.0 * p.y, p.d = 3.0 * p.d;
    CHECK(in_mm(solve(in).L) == doctest::Approx(3.0 * in_mm(before.L)).epsilon(1e-14));
  }

  TEST_CASE("a roller moves until the belt has its given length") {
    auto in = machine();
    in.pulleys[1].along = -0.5;
    for (const double L : {2330.0, 2400.0, 2500.0}) {
      in.L = L * mm;
      CHECK(in_mm(solve(in).L) == doctest::Approx(L).epsilon(1e-12));
    }
    in.L = unset<Length>;
    in.pulleys[1].along = unset<double>;
    const Length here = solve(in).L;
    in.pulleys[1].along = 1.0, in.L = here;
    CHECK(std::abs(in_mm(solve(in).s)) < 1e-6);
  }

  TEST_CASE("a pulley moves no farther than to the next one, and just to it where the belt needs that") {
    auto in = around({pulley(0.0, 0.0, 100.0), pulley(0.0, 500.0, 100.0)});
    in.pulleys[1].along = pi / 2.0;
    in.L = (2.0 * 100.12 + 100.0 * pi) * mm;  // the pulleys all but touch
    CHECK(in_mm(solve(in).s) == doctest::Approx(-399.88).epsilon(1e-9));
    in.L = 510.0 * mm;  // shorter than that: no place behind the other pulley is taken
    CHECK_FALSE(belt::Course::closes(in));
    CHECK(belt::Course::flaw_of(in).hint.text().find("from 514.159 mm") != std::string::npos);
  }

  TEST_CASE("what the belt cannot do is reported with the pulleys at fault") {
    const auto says = [](const std::string& pulleys, const std::string& what) {
      const BeltStep step("calculator = \"belt.course\"\npulleys = [" + pulleys + "]\n");
      INFO(pulleys);
      CHECK(step.says(what));
    };
    const std::string a = "{ name = \"a\", x = \"0 mm\", y = \"0 mm\", d = \"100 mm\" }",
                      b = ", { name = \"b\", x = \"500 mm\", y = \"0 mm\", d = \"100 mm\" }",
                      c = ", { name = \"c\", x = \"500 mm\", y = \"400 mm\", d = \"100 mm\" }",
                      d = ", { name = \"d\", x = \"0 mm\", y = \"400 mm\", d = \"100 mm\" }";
    says(a, "a belt needs at least two pulleys");
    says(a + ", { name = \"b\", x = \"90 mm\", y = \"0 mm\", d = \"100 mm\" }", "'pulleys.a' and 'pulleys.b' touch");
    says(a + ", { name = \"t\", x = \"250 mm\", y = \"-200 mm\", d = \"60 mm\", side = \"outside\" }" + b,
         "the belt does not reach 'pulleys.t'");
    says(a + ", { name = \"t\", x = \"250 mm\", y = \"200 mm\", d = \"60 mm\" }" + b + c,
         "the belt does not reach 'pulleys.t'");
    says(a + c + b + d, "the belt would cross itself");
    says(a + ", { name = \"b\", x = \"500 mm\", y = \"0 mm\", d = \"100 mm\", P = \"1 kW\" }",
         "powers and tensions need the speed n_1");
    says(a + b + ", { x = \"250 mm\", y = \"300 mm\", d = \"60 mm\", along = \"90 deg\" }",
         "this pulley moves, and the belt length is not given");
    says("{ x = \"0 mm\", y = \"0 mm\", d = \"100 mm\", side = \"outside\" }" + b,
         "the first (driving) pulley must be inside the belt");
    CHECK(BeltStep(with(text, "L", "\"2200 mm\"")).says("it gives belts from 2295.4"));
    CHECK(BeltStep(text).issues.empty());
    const BeltStep backwards("calculator = \"belt.course\"\nturns = \"cw\"\npulleys = [" + a + b + c + "]\n");
    CHECK(backwards.says("reverse the first one: turns = \"ccw\""));
    CHECK(BeltStep(with(text, "mu", "")).says("the tensions need the friction mu, or the tension S_0"));
    CHECK(BeltStep(replaced(text, "P = \"4 kW\"", "P = \"-4 kW\"")).says("give more power than they take"));
    CHECK(BeltStep(replaced(text, "d = \"160 mm\"", "d = \"160 mm\", P = \"1 kW\"")).says("the first pulley drives"));
  }

  TEST_CASE("without mu the tension is as given; too small a tension is not covered") {
    const std::string loose = with(with(text, "mu", ""), "S_0", "\"600 N\"");
    CHECK(BeltStep(loose).worst() == account::State::pass);
    CHECK(BeltStep(with(text, "S_0", "\"100 N\"")).worst() == account::State::fail);
    CHECK(BeltStep(with(with(loose, "q", "\"5 kg/m\""), "S_0", "\"600 N\"")).worst() != account::State::pass);
  }
}
