#include "calculators/fatigue/multiaxial/multiaxial.hpp"

#include "calculators/fatigue/multiaxial/planes.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/cli/process.hpp"
#include "tests/found/modes.hpp"

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using namespace loadpath::fatigue;
using namespace loadpath::test;
using In = Multiaxial::Input;

Axis samples(std::size_t n) {
  Axis axis;
  axis.quantity = "sample", axis.unit = "-", axis.at = std::vector<double>(n);
  return axis;
}

Varying<Stress> series(const Axis& axis, std::vector<double> in_MPa) {
  for (double& value : in_MPa) value *= 1e6;
  return Varying<Stress>(Value{{dimension_of<Stress>, &axis}, std::move(in_MPa)});
}

std::vector<double> sine(std::size_t n, double amplitude, double lag_deg, double mean = 0.0) {
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    values.push_back(mean + amplitude * std::sin(angle - lag_deg * std::numbers::pi / 180.0));
  }
  return values;
}

Multiaxial::Result solved(const In& in) {
  for (const auto& rule : Multiaxial::rules) CHECK_MESSAGE((rule.only_warns || rule.holds(in)), rule.text);
  NoTrace trace;
  return Multiaxial::evaluate(in, trace);
}

In of_metal(double sigma_D, double tau_D) {
  In in;
  in.sigma_D = sigma_D * MPa, in.tau_D = tau_D * MPa, in.S_D = 1.0;
  return in;
}

/// Bending and torsion of the hard steel, the shear behind by `lag`.
Multiaxial::Result hard_steel(double sigma_a, double tau_a, double lag) {
  const Axis axis = samples(36);
  In in = of_metal(313.9, 196.2);
  in.sigma_x = series(axis, sine(36, sigma_a, 0.0)), in.tau_xy = series(axis, sine(36, tau_a, lag));
  return solved(in);
}

std::string errors_of(const std::string& lines) {
  std::vector<Issue> issues;
  project::Project project = project::read_project(
      "[p]\ncalculator = \"fatigue.multiaxial\"\nsigma_D = \"240 MPa\"\ntau_D = \"150 MPa\"\nS_D = 1\n" + lines,
      "path.toml", catalogue(), issues);
  if (!has_errors(issues)) project::solve(project, issues);
  for (const Issue& issue : issues) {
    if (issue.severity == Severity::error) return issue.message.text();
  }
  return "";
}

}  // namespace

TEST_SUITE("fatigue.multiaxial") {
  TEST_CASE("hard steel of Nishihara and Kawamoto, by Crossland in closed form and by all planes computed elsewhere") {
    struct Test {
      double sigma_a, tau_a, lag, index;  // index in % of [Papadopoulos], recalled
      double n_F, n_M, n_DV;
    };
    for (const Test& t : {Test{138.1, 167.1, 0, -2.3, 0.9905457678, 0.990540111, 0.9905457678},
                          Test{140.4, 169.9, 30, -2.9, 0.9762456717, 0.965180599, 0.9992359181},
                          Test{145.7, 176.3, 60, -3.8, 0.9448210708, 0.923361043, 1.0243501173},
                          Test{150.2, 181.7, 90, -3.7, 0.9190190838, 0.894820049, 1.0740360604},
                          Test{245.3, 122.6, 0, 1.4, 0.9613395962, 0.961334487, 0.9613395962},
                          Test{249.7, 124.8, 30, -0.1, 0.9556867985, 0.957134305, 0.9777653850},
                          Test{252.4, 126.2, 60, -8.4, 0.9864815852, 0.974590864, 1.0741378688},
                          Test{258.0, 129.0, 90, -17.8, unset<double>, unset<double>, unset<double>},
                          Test{299.1, 62.8, 0, 0.9, 0.9829657601, 0.982960765, 0.9829657601}}) {
      const auto r = hard_steel(t.sigma_a, t.tau_a, t.lag);
      CHECK(std::abs(100.0 * (1.0 / r.n_C - 1.0) - t.index) < 0.05);
      if (!is_set(t.n_F)) continue;
      CHECK(r.e_p < 1e-6);
      CHECK(rel(r.n_F, t.n_F) < 2e-7);  // the other search stops at ridges
      CHECK(rel(r.n_M, t.n_M) < 1e-5);
      CHECK(rel(r.n_DV, t.n_DV) < 1e-8);
    }
  }

  TEST_CASE("both fatigue limits lie on every criterion, and a third between them by von Mises") {
    const Axis axis = samples(2);
    for (const double tau_D : {120.0, 138.6, 150.0, 190.0, 200.0, 235.0}) {
      In in = of_metal(240.0, tau_D);
      in.sigma_x = series(axis, {240, -240});
      const auto tension = solved(in);
      in.sigma_x = 0.0 * MPa, in.tau_xy = series(axis, {tau_D, -tau_D});
      const auto torsion = solved(in);
      for (const auto* r : {&tension, &torsion}) {
        CHECK(rel(r->n_F, 1.0) < 1e-9);
        CHECK(rel(r->n_M, 1.0) < 1e-3);  // the plane of most shear is chosen with a little of the normal stress
        const bool is_hard = tau_D <= 0.8 * 240.0;
        CHECK(is_set(r->n_DV) == is_hard);
        if (is_hard) CHECK(rel(r->n_DV, 1.0) < 1e-12);
        if (tau_D > 139.0 && is_hard) CHECK(rel(r->n_C, 1.0) < 1e-12);
        CHECK(is_set(r->n_C) == (is_hard && tau_D * std::sqrt(3.0) >= 240.0 * (1 - 1e-9)));
      }
    }
  }

  TEST_CASE("towards brittle metals Findley and Matake answer, by a search over planes computed elsewhere") {
    const Axis axis = samples(36);
    In in = of_metal(240.0, 210.0);
    in.sigma_x = series(axis, sine(36, 150.0, 0.0)), in.tau_xy = series(axis, sine(36, 120.0, 90.0));
    const auto r = solved(in);
    CHECK(rel(r.n_F, 1.0944765766) < 1e-8);
    CHECK(rel(r.n_M, 210.0 / (120.0 + 0.75 * 150.0)) < 1e-5);  // the plane across the axis
    CHECK(!is_set(r.n_C));
    CHECK(!is_set(r.n_DV));
    CHECK(r.n == r.n_M);
  }

  TEST_CASE("a plane's amplitude is the radius of the smallest circle, not half of the longest chord") {
    // Shear of the plane z = 0 alone varies along no chord; a triangle of sides 2 in the plane x: sigma_x apart.
    const double h = std::sqrt(3.0);
    const auto triangle = [&](std::size_t i) {
      return std::array<std::array<double, 2>, 3>{{{-1.0, 0.0}, {1.0, 0.0}, {0.0, h}}}[i];
    };
    const auto ball = numerics::smallest_ball<2>(3, triangle);
    CHECK(rel(ball.radius, 2.0 / h) < 1e-14);  // 15 % more than half of a side
    CHECK(rel(ball.centre[1], 1.0 / h) < 1e-14);
    const auto obtuse = [](std::size_t i) {
      return std::array<std::array<double, 2>, 4>{{{-3.0, 0.0}, {3.0, 0.0}, {0.0, 0.5}, {0.0, 0.5}}}[i];
    };
    CHECK(rel(numerics::smallest_ball<2>(4, obtuse).radius, 3.0) < 1e-14);
    const auto corners = [](std::size_t i) {  // corners of a cube, and points inside of it
      const double s = i < 8 ? 1.0 : 0.3;
      return std::array<double, 3>{(i & 1U) != 0 ? s : -s, (i & 2U) != 0 ? s : -s, (i & 4U) != 0 ? s : -s};
    };
    CHECK(rel(numerics::smallest_ball<3>(16, corners).radius, h) < 1e-14);
  }

  TEST_CASE("the axes of the surface may be rotated, the path shifted in time and its samples repeated") {
    const Axis axis = samples(24), twice = samples(48);
    In in = of_metal(300.0, 190.0);
    const auto x = sine(24, 120.0, 0.0, 40.0), y = sine(24, 60.0, 50.0), xy = sine(24, 80.0, 110.0, -20.0);
    in.sigma_x = series(axis, x), in.sigma_y = series(axis, y), in.tau_xy = series(axis, xy);
    const auto r = solved(in);
    for (const double turn : {0.3, 1.1}) {
      std::vector<double> u, v, uv;
      for (std::size_t i = 0; i < 48; ++i) {
        const std::size_t j = (i / 2 + 7) % 24;
        const double m = (x[j] + y[j]) / 2, d = (x[j] - y[j]) / 2, c = std::cos(2 * turn), s = std::sin(2 * turn);
        u.push_back(m + d * c + xy[j] * s), v.push_back(m - d * c - xy[j] * s), uv.push_back(xy[j] * c - d * s);
      }
      In turned = in;
      turned.sigma_x = series(twice, u), turned.sigma_y = series(twice, v), turned.tau_xy = series(twice, uv);
      const auto t = solved(turned);
      CHECK(rel(t.n_F, r.n_F) < 1e-8);
      CHECK(rel(t.n_M, r.n_M) < 1e-5);
      CHECK(rel(t.n_C, r.n_C) < 1e-9);
      CHECK(rel(t.n_DV, r.n_DV) < 1e-9);
      CHECK(rel(in_si(t.sigma_v), in_si(r.sigma_v)) < 1e-12);
      const double along = std::remainder(r.phi_F - turn - t.phi_F, std::numbers::pi);
      CHECK(std::abs(along) < 1e-3);
    }
  }

  TEST_CASE("planes inclined to the surface are searched too: two equal tensions shear it at 45 degrees") {
    const Axis axis = samples(2);
    In in = of_metal(240.0, 150.0);
    in.sigma_x = series(axis, {200, -200}), in.sigma_y = series(axis, {200, -200});
    const auto r = solved(in);
    CHECK(rel(in_si(r.tau_M), 100e6) < 1e-6);
    CHECK(std::abs(r.theta_M - std::numbers::pi / 4) < 1e-3);
    CHECK(rel(in_si(r.sigma_H), 400e6 / 3.0) < 1e-12);
    CHECK(rel(in_si(r.tau_C), 200e6 / std::sqrt(3.0)) < 1e-12);
  }

  TEST_CASE("typed stresses are paired sample by sample; series over other positions are not mixed") {
    const std::string y = "tau_xy = { values = [0, 50, 100, 50, 0, -50, -100, -50], unit = \"MPa\" }\n";
    const auto p = solved_as_found(
        "[p]\ncalculator = \"fatigue.multiaxial\"\nsigma_D = \"240 MPa\"\ntau_D = \"150 MPa\"\nS_D = 1\n" + y +
        "sigma_x = { values = [100, 100, 0, 0, -100, -100, 0, 0], unit = \"MPa\" }\n");
    const Value* const samples = p.steps.front()->value("samples");
    REQUIRE(samples != nullptr);
    CHECK(samples->si[0] == 8.0);
    CHECK(errors_of(y + "sigma_x = { values = [100, 0, -100, 0], unit = \"MPa\" }\n").find("must be simultaneous") !=
          std::string::npos);
    CHECK(errors_of(y + "sigma_x = \"30 MPa\"\n").empty());
    CHECK(errors_of("sigma_x = \"30 MPa\"\n").find("must vary") != std::string::npos);
    CHECK(errors_of("sigma_x = { values = [3, 3, 3], unit = \"MPa\" }\n").find("must vary") != std::string::npos);
  }

  TEST_CASE("columns of a file, of bounded length") {
    const test::Desk desk;
    const auto& folder = desk.folder();
    std::ofstream file(folder / "rosette.csv"), longer(folder / "long.csv");
    file << "sx,sy,txy\n";
    for (int i = 0; i < 12; ++i) file << 10 * i << "," << 5 << "," << 100 - i * i << "\n";
    longer << "sx\n";
    for (int i = 0; i < 5001; ++i) longer << i % 7 << "\n";
    file.close(), longer.close();
    const auto column = [&](const char* key, const char* name) {
      return std::string(key) + " = { file = \"" + (folder / "rosette.csv").string() + "\", column = \"" + name +
             "\", unit = \"MPa\" }\n";
    };
    CHECK(errors_of(column("sigma_x", "sx") + column("sigma_y", "sy") + column("tau_xy", "txy")).empty());
    const std::string too_long = (folder / "long.csv").string();
    CHECK(errors_of("sigma_x = { file = \"" + too_long + "\", column = \"sx\", unit = \"MPa\" }\n")
              .find("more than 5000 samples") != std::string::npos);
  }

  TEST_CASE("a revolution whose positions miss its extremes is refused") {
    Axis turn;
    turn.step = "crank", turn.quantity = "crank angle", turn.period = 2.0 * std::numbers::pi;
    In in = of_metal(240.0, 150.0);
    for (const std::size_t n : {13U, 72U}) {
      turn.at = {};
      const auto positions = static_cast<double>(n);
      for (std::size_t i = 0; i < n; ++i) turn.at.add(turn.period * static_cast<double>(i) / positions);
      in.sigma_x = series(turn, sine(n, 100.0, 90.0 / positions));
      CHECK(Multiaxial::fine_enough(in) == (n == 72));
    }
    const Axis other = samples(72);
    in.tau_xy = series(other, sine(72, 10.0, 0.0));
    CHECK(!Multiaxial::in_step(in));
  }

  TEST_CASE("missing input does not pass") {
    const auto state = [](const std::string& lines, const char* mode) {  // over few samples, which take less time
      return mode_with("fatigue.multiaxial",
                       "sigma_x = { values = [0, 80, 0, -80], unit = \"MPa\" }\n"
                       "tau_xy = { values = [90, 60, 20, 60], unit = \"MPa\" }\n" +
                           lines,
                       mode);
    };
    CHECK(state("R_e = \nS_F = ", "yield") == "not-judged");
    CHECK(state("tau_D = \"119 MPa\"", "fatigue") == "not-covered");
    CHECK(state("tau_D = \"193 MPa\"", "fatigue") == "pass");  // by Findley and Matake
    for (const char* by : {"crossland", "dang-van"})
      CHECK(state(std::string("tau_D = \"193 MPa\"\ncriterion = \"") + by + "\"", "fatigue") == "not-covered");
    CHECK(state("tau_D = \"130 MPa\"\ncriterion = \"crossland\"", "fatigue") == "not-covered");
    CHECK(state("S_D = 20", "fatigue") == "fail");
    CHECK(state("sigma_y = \"-480 MPa\"", "yield") == "fail");  // fatigue does not see it
  }
}
