// Spherical four-bar linkages: published positions, the universal joint, derivatives by differences, and the motion of
// the coupler against that of its neighbours.
#include "calculators/motion/spherical/four_bar.hpp"
#include "tests/calculators/motion/solved.hpp"

#include <array>
#include <numbers>
#include <sstream>

using namespace loadpath::test;

namespace {

constexpr double pi = std::numbers::pi, deg = pi / 180.0;

std::string text(double value) {
  std::ostringstream out;
  out.precision(17);
  out << value;
  return out.str();
}

using Arcs = std::array<double, 4>;

SolvedStep linkage(const Arcs& arcs, double phi, const std::string& more = "") {
  std::string lines = "n_1 = \"10 rad/s\"\nphi_1 = \"" + text(phi) + " rad\"\n" + more;
  for (std::size_t k = 0; k < 4; ++k) lines += "alpha_" + std::to_string(k + 1) + " = \"" + text(arcs[k]) + " deg\"\n";
  return {"motion.spherical_four_bar", lines};
}

const std::string right = "assembly = \"right\"\n";

using Vector = std::array<double, 3>;
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector sum(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
double distance(const Vector& a, const Vector& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// The four axes by rotations of z: about y by an arc, about z by an angle.
Vector about_y(const Vector& v, double angle) {
  return {std::cos(angle) * v[0] + std::sin(angle) * v[2], v[1], -std::sin(angle) * v[0] + std::cos(angle) * v[2]};
}
Vector about_z(const Vector& v, double angle) {
  return {std::cos(angle) * v[0] - std::sin(angle) * v[1], std::sin(angle) * v[0] + std::cos(angle) * v[1], v[2]};
}
constexpr Vector z_axis{0.0, 0.0, 1.0};
Vector input_joint(const Arcs& arcs, double phi_1) { return about_z(about_y(z_axis, arcs[0] * deg), phi_1); }
Vector output_joint(const Arcs& arcs, double phi_4) {
  return about_y(about_z(about_y(z_axis, arcs[2] * deg), phi_4), arcs[3] * deg);
}

/// One linkage of each type, with input angles at which it closes.
struct Sample {
  Arcs arcs;
  const char* type;
  std::array<double, 3> phi;
};
const Sample samples[] = {{{30, 70, 60, 80}, "crank-rocker", {0.9, 2.6, -1.3}},
                          {{60, 70, 80, 30}, "double-crank", {0.9, 2.6, -1.3}},
                          {{60, 70, 30, 80}, "rocker-crank", {1.3, 1.1, -1.2}},
                          {{80, 30, 60, 70}, "double-rocker", {1.0, 0.8, -0.9}},
                          {{60, 40, 50, 80}, "triple-rocker", {0.3, 1.4, -1.0}},
                          {{150, 110, 60, 80}, "crank-rocker", {0.9, 2.6, -1.3}}};  // the first with two supplements

}  // namespace

TEST_SUITE("motion spherical four bar") {
  TEST_CASE("a published position, in both assemblies") {  // [Birglen-spherical]: -26.8990 and 108.6857 deg
    const SolvedStep s = linkage({45, 60, 45, 90}, -60.0 * deg);
    CHECK(std::abs(s("phi_4") / deg - (180.0 - 26.8990)) < 5e-5);
    CHECK(std::abs(s("phi_4o") / deg - (108.6857 - 180.0)) < 5e-5);
    CHECK(near(linkage({45, 60, 45, 90}, -60.0 * deg, right)("phi_4"), s("phi_4o")));
    // published axis of coupler and output, (0.6306, -0.3199, 0.7071) from the output axis: the same distance from the
    // input axis, which lies along x there
    CHECK(std::abs(output_joint({45, 60, 45, 90}, s("phi_4"))[2] - 0.6306) < 5e-5);
  }

  TEST_CASE("with three arcs of 90 deg it is a universal joint") {
    for (const double beta : {5.0, 20.0, 45.0, 70.0}) {
      for (const double phi : {-2.0, 0.3, 1.0, 2.2, 4.0}) {
        CAPTURE(beta);
        CAPTURE(phi);
        const std::string more = "epsilon_1 = \"3 rad/s^2\"\n";
        const SolvedStep joint("motion.universal_joint", "n_1 = \"10 rad/s\"\nbeta = \"" + text(beta) +
                                                             " deg\"\nphi_1 = \"" + text(phi) +
                                                             " rad\"\nM_2 = \"7 N*m\"\n" + more);
        const SolvedStep s = linkage({90, 90, 90, beta}, phi, more + "M_4 = \"7 N*m\"\n");
        CHECK(std::abs(std::remainder(s("phi_4") + pi / 2.0 - joint("phi_2"), pi)) < 1e-12);
        CHECK(near(s("i"), joint("i")));
        CHECK(near(s("omega_4"), joint("n_2")));
        CHECK(std::abs(s("epsilon_4") - joint("epsilon_2")) < 1e-9 * joint("epsilon_max"));
        CHECK(near(s("M_1"), joint("M_1")));
        CHECK(near(s("M_1max"), joint("M_1max")));
        CHECK(near(s("i_max") * 10.0, joint("n_2max")));
        CHECK(near(s("i_min") * 10.0, joint("n_2min")));
      }
    }
  }

  TEST_CASE("the type follows from the links that can revolve") {
    for (const Sample& sample : samples) {
      CAPTURE(sample.type);
      CHECK(linkage(sample.arcs, sample.phi[0]).word("type") == sample.type);
    }
    // [Mechamechanisms-4R]: the output revolves; with a ground of 20 deg it makes one revolution in two of the input
    CHECK(linkage({20, 90, 90, 15}, 1.0).word("type") == "double-crank");
    CHECK(linkage({20, 90, 90, 20}, 1.0).word("type") == "change-point");
    CHECK(linkage({20, 90, 90, 20}, 1.0).worst() == loadpath::account::State::fail);
    CHECK(near(linkage({20, 90, 90, 20}, 1.0)("i"), 0.5, 0.05));
    // [Sclater-168]: the output oscillates where the arc of the input is less than that of the ground
    CHECK(linkage({20, 90, 90, 25}, 1.0).word("type") == "crank-rocker");
  }

  TEST_CASE("the loop closes, and ratio and derivative are those of the angle") {
    const double h = 1e-4;
    for (const Sample& sample : samples) {
      for (const std::string& more : {std::string(), right}) {
        for (const double phi : sample.phi) {
          CAPTURE(sample.type);
          CAPTURE(phi);
          const SolvedStep s = linkage(sample.arcs, phi, more + "epsilon_1 = \"7 rad/s^2\"\n");
          const Vector p = input_joint(sample.arcs, phi), q = output_joint(sample.arcs, s("phi_4"));
          CHECK(std::abs(p[0] * q[0] + p[1] * q[1] + p[2] * q[2] - std::cos(sample.arcs[1] * deg)) < 1e-12);
          const SolvedStep before = linkage(sample.arcs, phi - h, more), after = linkage(sample.arcs, phi + h, more);
          const double i = std::remainder(after("phi_4") - before("phi_4"), 2.0 * pi) / (2.0 * h);
          CHECK(std::abs(s("i") - i) < 1e-5 * (1.0 + std::abs(i)));
          const double slope = (after("i") - before("i")) / (2.0 * h);
          CHECK(std::abs(s("i_phi") - slope) < 1e-5 * (1.0 + std::abs(slope)));
          CHECK(near(s("omega_4"), 10.0 * s("i")));
          CHECK(near(s("epsilon_4"), 7.0 * s("i") + 100.0 * s("i_phi")));
        }
      }
    }
  }

  TEST_CASE("the joints of the coupler move as those of input and output") {
    for (const Sample& sample : samples) {
      for (const std::string& more : {std::string(), right}) {
        for (const double phi : sample.phi) {
          CAPTURE(sample.type);
          CAPTURE(phi);
          const SolvedStep s = linkage(sample.arcs, phi, more + "epsilon_1 = \"7 rad/s^2\"\n");
          const Vector omega{s("omega_x"), s("omega_y"), s("omega_z")};
          const Vector epsilon{s("epsilon_x"), s("epsilon_y"), s("epsilon_z")};
          const Vector axis{std::sin(sample.arcs[3] * deg), 0.0, std::cos(sample.arcs[3] * deg)};
          const auto along = [](const Vector& a, double k) { return Vector{a[0] * k, a[1] * k, a[2] * k}; };
          const auto velocity = [](const Vector& w, const Vector& r) { return cross(w, r); };
          const auto acceleration = [&](const Vector& w, const Vector& e, const Vector& r) {
            return sum(cross(e, r), cross(w, cross(w, r)));
          };
          const Vector p = input_joint(sample.arcs, phi), q = output_joint(sample.arcs, s("phi_4"));
          const Vector input = along(z_axis, 10.0), output = along(axis, s("omega_4"));
          CHECK(distance(velocity(omega, p), velocity(input, p)) < 1e-9 * s("omega_2"));
          CHECK(distance(velocity(omega, q), velocity(output, q)) < 1e-9 * s("omega_2"));
          const double scale = 1e-9 * (s("epsilon_2") + s("omega_2") * s("omega_2"));
          CHECK(distance(acceleration(omega, epsilon, p), acceleration(input, along(z_axis, 7.0), p)) < scale);
          CHECK(distance(acceleration(omega, epsilon, q), acceleration(output, along(axis, s("epsilon_4")), q)) <
                scale);
        }
      }
    }
  }

  TEST_CASE("a rocker reverses in the stretched and the folded position, at its limits") {
    for (const std::string& more : {std::string(), right}) {
      const Arcs arcs{30, 70, 60, 80};
      const SolvedStep s = linkage(arcs, 1.0, more);
      for (const std::string& at : {std::string("s"), std::string("f")}) {
        const SolvedStep there = linkage(arcs, s("phi_1" + at), more);
        CHECK(near(there("phi_4"), s("phi_4" + at)));
        CHECK(std::abs(there("i")) < 1e-9);
      }
      CHECK(near(std::abs(s("phi_4s")), s("phi_4min")));
      CHECK(near(std::abs(s("phi_4f")), s("phi_4max")));
      CHECK(near(s("theta_4"), s("phi_4max") - s("phi_4min")));
      const double stroke = std::abs(s("phi_1f") - s("phi_1s"));
      CHECK(near(s("Q"), std::max(stroke, 2.0 * pi - stroke) / std::min(stroke, 2.0 * pi - stroke)));
    }
  }

  TEST_CASE("over the range in use, transmission angle and ratio are the extremes of its positions") {
    const Arcs arcs{30, 70, 60, 80};
    const SolvedStep s = linkage(arcs, 1.0, "phi_a = \"-0.5 rad\"\nphi_b = \"2 rad\"\nM_4 = \"-4 N*m\"\n");
    double mu_min = pi, low = 1e9, high = -1e9;
    for (int k = 0; k <= 100; ++k) {
      const SolvedStep there = linkage(arcs, -0.5 + 0.025 * k);
      mu_min = std::min({mu_min, there("mu"), pi - there("mu")});
      low = std::min(low, there("i")), high = std::max(high, there("i"));
    }
    CHECK(near(s("mu_min"), mu_min, 1e-4));
    CHECK(s("mu_min") <= mu_min * (1.0 + 1e-12));
    CHECK(near(s("i_min"), low, 1e-3));
    CHECK(s("i_min") <= low + 1e-12);
    CHECK(near(s("i_max"), high, 1e-3));
    CHECK(s("i_max") >= high - 1e-12);
    CHECK(near(s("M_1max"), 4.0 * std::max(std::abs(s("i_min")), std::abs(s("i_max")))));
  }

  TEST_CASE("a range in use without phi_1 is reported") {
    const auto broken_rules = [](double phi_1, double phi_a, double phi_b) {
      const loadpath::Calculator& linkage =
          *loadpath::find_calculator(loadpath::calculators(), "motion.spherical_four_bar");
      const loadpath::Record in(*linkage.input);
      for (const auto& [key, degrees] : std::initializer_list<std::pair<const char*, double>>{{"alpha_1", 30},
                                                                                              {"alpha_2", 70},
                                                                                              {"alpha_3", 60},
                                                                                              {"alpha_4", 80},
                                                                                              {"phi_1", phi_1},
                                                                                              {"phi_a", phi_a},
                                                                                              {"phi_b", phi_b}})
        find_leaf(in, key).set(degrees * deg);
      std::string all;
      for (std::size_t rule = 0; rule < linkage.rules.size(); ++rule) {
        if (!linkage.holds(rule, in.data.get())) all += linkage.fault_of(rule, in.data.get()).message.text();
      }
      return all;
    };
    CHECK(contains(broken_rules(50, 60, 120), "phi_1 = 50° is outside the range in use, 60° to 120°"));
    CHECK(broken_rules(50, 50, 120).empty());
    CHECK(broken_rules(50, -20, 50).empty());
    CHECK(broken_rules(410, 40, 60).empty());  // a revolution further
  }

  TEST_CASE("small arcs approach a planar linkage") {
    // links of 3, 7, 6 and 8 at 50 deg: law of cosines of both triangles
    const double d = std::sqrt(9.0 + 64.0 - 48.0 * std::cos(50.0 * deg));
    const double delta = pi - std::asin(3.0 * std::sin(50.0 * deg) / d);
    const double phi_4 = delta - std::acos((d * d + 36.0 - 49.0) / (12.0 * d));
    CHECK(near(linkage({0.3, 0.7, 0.6, 0.8}, 50.0 * deg)("phi_4"), phi_4, 1e-4));
  }

  TEST_CASE("linkages that do not close are refused, with the range in which they do") {
    const std::string arcs = "n_1 = \"1 rpm\"\nalpha_1 = \"60 deg\"\nalpha_2 = \"40 deg\"\nalpha_3 = \"50 deg\"\n";
    CHECK(
        contains(SolvedStep("motion.spherical_four_bar", arcs + "alpha_4 = \"80 deg\"\nphi_1 = \"100 deg\"\n").fault(),
                 "does not close at phi_1 = 100"));
    CHECK(
        contains(SolvedStep("motion.spherical_four_bar", arcs + "alpha_4 = \"151 deg\"\nphi_1 = \"10 deg\"\n").fault(),
                 "the arcs must close"));
    CHECK(contains(SolvedStep("motion.spherical_four_bar",
                              arcs + "alpha_4 = \"80 deg\"\nphi_1 = \"10 deg\"\nphi_a = \"5 deg\"\nphi_b = \"5 deg\"\n")
                       .fault(),
                   "must end after its start"));
    const SolvedStep wide("motion.spherical_four_bar",
                          arcs + "alpha_4 = \"80 deg\"\nphi_1 = \"10 deg\"\nphi_a = \"5 deg\"\nphi_b = \"120 deg\"\n");
    CHECK(wide.worst() == loadpath::account::State::fail);
    CHECK(std::isnan(wide("i_max")));
  }
}
