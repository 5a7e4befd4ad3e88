// Sweeps of the shaft calculators next to plain loops over doubles, written by hand for the one case.
#include "calculators/shaft/torsion/torsion.hpp"

#include "calculators/shaft/overhung.hpp"
#include "lib/calculator/sweep_of.hpp"
#include "tests/bench/sweep.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace {

using namespace loadpath;
using namespace loadpath::bench;
using std::numbers::pi;

constexpr double G = 80e9, theta_adm = 0.004;

/// Two columns that vary, and a column for each result: the plain loops compute what the calculator computes.
struct Columns {
  std::vector<double> first, tau_adm;
  std::vector<std::vector<double>> results;
  Columns(std::vector<double> varied, std::vector<double> allowed, std::size_t count)
      : first(std::move(varied)), tau_adm(std::move(allowed)), results(count, std::vector<double>(points)) {}
};

/// The sweep of a calculator over the two columns.
Sweep sweep_of(const Calculator& calculator, Record input, const std::string& first,
               const std::vector<std::string>& results, Columns& columns) {
  return {
      calculator, std::move(input), {{first, columns.first}, {"tau_adm", columns.tau_adm}}, results, columns.results};
}

template <class Swept, class ByHand>
void race(benchmark::State& state, const Swept& sweep, const ByHand& by_hand, const Columns& general,
          const Columns& plain) {
  compare(state, sweep, by_hand);
  if (!std::equal(general.results.begin(), general.results.end(), plain.results.begin(), agree)) {
    state.SkipWithError("they disagree");
  }
}

shaft::Torsion::Input plain_shaft() {
  shaft::Torsion::Input in;
  in.G = from_si<Stress>(G);
  in.theta_adm = from_si<Twist>(theta_adm);
  return in;
}

template <class CubeRoot>
std::array<double, 8> short_form_of(double T, double tau_adm, CubeRoot root) {
  const double M = std::abs(T);
  const double d_strength = root(16.0 * M / (pi * tau_adm));
  const double d_stiffness = std::sqrt(std::sqrt(32.0 * M / (pi * G * theta_adm)));
  const double d = d_strength < d_stiffness ? d_stiffness : d_strength;
  const double I_t = pi / 32.0 * d * d * d * d;
  const double tau = M * d / (2.0 * I_t), theta = M / (G * I_t);
  return {d_strength, d_stiffness, d, 2.0 * tau_adm / (G * theta_adm), tau, theta, tau / tau_adm, theta / theta_adm};
}

/// The floor of floors: columns in wide registers, with a cube root that goes there.
LOADPATH_LANES void short_form_in_lanes(const double* T, const double* tau_adm, double* const* results) {
  const std::array<double*, 8> to{results[0], results[1], results[2], results[3],
                                  results[4], results[5], results[6], results[7]};
  LOADPATH_POINTWISE
  for (std::size_t i = 0; i < points; ++i) {
    const auto found = short_form_of(T[i], tau_adm[i], [](double x) { return numerics::cube_root(x); });
    for (std::size_t k = 0; k < to.size(); ++k) to[k][i] = found[k];
  }
}

void short_form(benchmark::State& state) {
  const std::vector<std::string> results{"d_strength", "d_stiffness", "d_min", "D_star",
                                         "tau_max",    "theta_max",   "u_tau", "u_theta"};
  Columns general(spread(50.0, 500.0, 1), spread(20e6, 60e6, 2), results.size()), plain = general;
  const Sweep sweep =
      sweep_of(erased<shaft::Torsion>(), record_of<shaft::Torsion>(plain_shaft()), "T", results, general);
  const auto by_hand = [&] {
    for (std::size_t i = 0; i < points; ++i) {
      const auto found = short_form_of(plain.first[i], plain.tau_adm[i], [](double x) { return std::cbrt(x); });
      for (std::size_t k = 0; k < found.size(); ++k) plain.results[k][i] = found[k];
    }
  };
  race(state, sweep, by_hand, general, plain);
  std::array<double*, 8> results_at{};
  for (std::size_t k = 0; k < results_at.size(); ++k) results_at[k] = plain.results[k].data();
  compare_in_lanes(state, [&] { short_form_in_lanes(plain.first.data(), plain.tau_adm.data(), results_at.data()); });
  if (!std::equal(general.results.begin(), general.results.end(), plain.results.begin(), agree)) {
    state.SkipWithError("the lanes disagree");
  }
}

enum class Bore { none, ratio, size };
struct Part {
  double l;
  Bore bore;
  double of;
};
struct Torque {
  double x, T;
};
constexpr std::array<Part, 3> parts{{{0.30, Bore::none, 0.0}, {0.50, Bore::ratio, 0.5}, {0.20, Bore::size, 0.02}}};
constexpr std::array<Torque, 4> torques{{{0.0, 900.0}, {0.3, -3600.0}, {0.8, 1500.0}, {1.0, 1200.0}}};

shaft::Torsion::Input line_shaft() {
  shaft::Torsion::Input in = plain_shaft();
  for (const Torque& t : torques) in.torques.push_back({{}, t.x * m, t.T * N_m});
  for (const Part& p : parts) {
    in.segments.push_back({{}, p.l * m, 120.0 * mm});
    if (p.bore == Bore::ratio) in.segments.back().chi = p.of;
    if (p.bore == Bore::size) in.segments.back().d_bore = p.of * m;
  }
  return in;
}

struct Least {
  double by_strength, by_stiffness, bore_at_120;
};

Least least_of(const Part& part, double M_t, double tau_adm) {
  const double w = 16.0 * M_t / (pi * tau_adm), i = 32.0 * M_t / (pi * G * theta_adm);
  if (part.bore == Bore::none) return {std::cbrt(w), std::sqrt(std::sqrt(i)), 0.0};
  const double b = part.of, b4 = b * b * b * b;
  if (part.bore == Bore::ratio) return {std::cbrt(w / (1.0 - b4)), std::sqrt(std::sqrt(i / (1.0 - b4))), b * 0.120};
  double d = b + std::cbrt(w);  // Newton from above for d^4 - b^4 = w d
  for (double next = 0.0; true; d = next) {
    next = d - (d * d * d * d - b4 - w * d) / (4.0 * d * d * d - w);
    if (!(next < d)) break;
  }
  return {d, std::sqrt(std::sqrt(b4 + i)), b};
}

void line_shaft_by_hand(Columns& columns) {
  for (std::size_t i = 0; i < points; ++i) {
    const double K_A = columns.first[i], tau_adm = columns.tau_adm[i];
    double M = 0.0, d_min = 0.0, tau = 0.0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      M += torques[k].T;
      const double M_t = K_A * std::abs(M), d = 0.120;
      const auto [by_strength, by_stiffness, b] = least_of(parts[k], M_t, tau_adm);
      d_min = std::max(d_min, std::max(by_strength, by_stiffness));
      tau = std::max(tau, M_t * d / (2.0 * pi / 32.0 * (d * d * d * d - b * b * b * b)));
    }
    columns.results[0][i] = d_min;
    columns.results[1][i] = tau / tau_adm;
  }
}

void three_segments(benchmark::State& state) {
  Columns general(spread(1.0, 2.0, 3), spread(20e6, 60e6, 4), 2), plain = general;
  const Sweep sweep =
      sweep_of(erased<shaft::Torsion>(), record_of<shaft::Torsion>(line_shaft()), "K_A", {"d_min", "u_tau"}, general);
  race(
      state, sweep, [&] { line_shaft_by_hand(plain); }, general, plain);
}

void overhung(benchmark::State& state) {
  constexpr double a = 0.05, T = 78.3, sigma_adm = 60e6;
  Columns general(spread(500.0, 5000.0, 5), spread(20e6, 60e6, 6), 2), plain = general;
  shaft::Overhung::Input in;
  in.a = a * m, in.T = T * N_m, in.sigma_adm = from_si<Stress>(sigma_adm);
  const Sweep sweep =
      sweep_of(erased<shaft::Overhung>(), record_of<shaft::Overhung>(in), "F", {"d_min", "u_v"}, general);
  const auto by_hand = [&] {
    for (std::size_t i = 0; i < points; ++i) {
      const double M = std::abs(plain.first[i]) * a;
      const double d_v = std::cbrt(32.0 * std::sqrt(M * M + 0.75 * T * T) / (pi * sigma_adm));
      const double d_t = std::cbrt(16.0 * T / (pi * plain.tau_adm[i]));
      const double d = std::max(d_v, d_t);
      const double W = pi / 32.0 * d * d * d, sigma_b = M / W, tau_t = T / (2.0 * W);
      plain.results[0][i] = d;
      plain.results[1][i] = std::sqrt(sigma_b * sigma_b + 3.0 * tau_t * tau_t) / sigma_adm;
    }
  };
  race(state, sweep, by_hand, general, plain);
}

}  // namespace

BENCHMARK(short_form);
BENCHMARK(three_segments);
BENCHMARK(overhung);
BENCHMARK_MAIN();
