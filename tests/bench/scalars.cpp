// Sweeps of scalar calculators next to plain loops over doubles, written by hand for the one case: at most twice as
// slow. In forms of their own a stress cycle makes 150 million points a second, a cylinder and a column 40 million, a
// pair of gears 2 million.
#include "calculators/belt/flat.hpp"
#include "calculators/column/buckling.hpp"
#include "calculators/fatigue/cycle.hpp"
#include "calculators/gear/pair.hpp"
#include "calculators/vessel/cylinder.hpp"
#include "tests/bench/sweep.hpp"

#include <cmath>
#include <numbers>

namespace {

using namespace loadpath;
using namespace loadpath::bench;
using std::numbers::pi;
using Columns = std::vector<std::vector<double>>;

template <class ByHand>
void race(benchmark::State& state, const Sweep& sweep, const ByHand& by_hand, const Columns& general,
          const Columns& plain, Agree agreement = agree) {
  compare(state, sweep, by_hand);
  if (!std::equal(general.begin(), general.end(), plain.begin(), agreement)) state.SkipWithError("they disagree");
}

void stress_cycle(benchmark::State& state) {
  constexpr double R_e = 355e6;
  const auto high = spread(100e6, 300e6, 3), low = spread(10e6, 90e6, 4);
  fatigue::Cycle::Input in;
  in.R_e = from_si<Stress>(R_e);
  Columns general;
  const Sweep sweep(erased<fatigue::Cycle>(), record_of<fatigue::Cycle>(in), {{"sigma_max", high}, {"sigma_min", low}},
                    {"sigma_m", "sigma_a", "r", "u_y"}, general);
  Columns plain(general.size(), std::vector<double>(points));
  std::vector<int> kinds(points);
  const auto by_hand = [&] {
    for (std::size_t i = 0; i < points; ++i) {
      const double size = std::max(std::abs(high[i]), std::abs(low[i])), same = 1e-9 * size;
      plain[0][i] = (high[i] + low[i]) / 2.0, plain[1][i] = (high[i] - low[i]) / 2.0, plain[2][i] = low[i] / high[i];
      plain[3][i] = size / R_e;
      kinds[i] = high[i] - low[i] <= same             ? 0
                 : std::abs(high[i] + low[i]) <= same ? 1
                 : std::abs(low[i]) <= same           ? 2
                 : std::abs(high[i]) <= same          ? 3
                 : low[i] > 0.0                       ? 4
                 : high[i] < 0.0                      ? 5
                                                      : 6;
    }
    benchmark::DoNotOptimize(kinds.data());
  };
  race(state, sweep, by_hand, general, plain);
}

/// A closed cylinder of a given wall by Tresca, in wide registers by hand and in its form.
void closed_cylinder(benchmark::State& state) {
  constexpr double delta = 0.012, sigma_adm = 140e6;
  const auto p = spread(0.5e6, 2e6, 5), R = spread(0.5, 1.0, 6);
  vessel::Cylinder::Input in;
  in.delta = delta * m, in.sigma_adm = from_si<Stress>(sigma_adm);
  Columns general;
  const Sweep sweep(erased<vessel::Cylinder>(), record_of<vessel::Cylinder>(in), {{"p", p}, {"R", R}},
                    {"sigma_o", "sigma_v", "t_R", "delta_min", "p_max", "u_v", "sigma_L", "delta_L"}, general);
  Columns plain(general.size(), std::vector<double>(points));
  const auto by_hand = [&] {
    for (std::size_t i = 0; i < points; ++i) {
      const double sigma_o = p[i] * R[i] / delta, R_i = R[i] - delta / 2.0, R_a = R[i] + delta / 2.0;
      plain[0][i] = sigma_o, plain[1][i] = sigma_o + p[i], plain[2][i] = delta / R[i];
      plain[3][i] = p[i] * R[i] / (sigma_adm - p[i]), plain[4][i] = sigma_adm / (R[i] / delta + 1.0);
      plain[5][i] = plain[1][i] / sigma_adm;
      const double square = R_a * R_a - R_i * R_i;
      plain[6][i] = p[i] * (R_a * R_a + R_i * R_i) / square + p[i];
      const double q = p[i] / sigma_adm;
      plain[7][i] = 2.0 * R[i] * q / (1.0 - q + std::sqrt(1.0 - 2.0 * q));
    }
  };
  race(state, sweep, by_hand, general, plain, Agree{1e-12});
}

/// A round column, clamped below and free above, by Euler's formula.
void slender_column(benchmark::State& state) {
  constexpr double E = 210e9, sigma_P = 270e6, n_st = 3.0;
  const auto l = spread(0.8, 1.2, 9), d = spread(0.02, 0.05, 10), P = spread(5e3, 50e3, 11);
  column::Buckling::Input in;
  in.E = from_si<Stress>(E), in.sigma_P = from_si<Stress>(sigma_P), in.n_st = n_st;
  in.ends = column::Ends::fixed_free, in.method = column::Method::euler;
  Columns general;
  const Sweep sweep(erased<column::Buckling>(), record_of<column::Buckling>(in), {{"l", l}, {"d", d}, {"P", P}},
                    {"A", "lambda", "sigma_cr", "P_all", "u", "r_1"}, general);
  Columns plain(general.size(), std::vector<double>(points));
  const auto by_hand = [&] {
    for (std::size_t i = 0; i < points; ++i) {
      const double A = pi / 4.0 * d[i] * d[i], lambda = 2.0 * l[i] / (d[i] / 4.0);
      const double sigma = pi * pi * E / (lambda * lambda), P_all = sigma * A / n_st;
      plain[0][i] = A, plain[1][i] = lambda, plain[2][i] = sigma, plain[3][i] = P_all, plain[4][i] = P[i] / P_all;
      plain[5][i] = pi * std::sqrt(E / sigma_P) / lambda;
    }
  };
  race(state, sweep, by_hand, general, plain);
}

/// An open flat belt of given width on fixed centres, with the least initial tension.
void flat_belt(benchmark::State& state) {
  constexpr double d_1 = 0.2, d_2 = 0.5, K_A = 1.2, mu = 0.4, delta = 2.5e-3, b = 0.125, rho = 1100.0;
  constexpr double sigma_adm = 6e6, epsilon = 0.01, n_1 = 1450.0 * pi / 30.0;
  const auto P = spread(5e3, 15e3, 7), a = spread(0.9, 1.6, 8);
  belt::Flat::Input in;
  in.K_A = K_A, in.mu = mu, in.epsilon = epsilon;
  in.n_1 = from_si<AngularSpeed>(n_1), in.d_1 = d_1 * m, in.d_2 = d_2 * m;
  in.delta = delta * m, in.b = b * m, in.rho = from_si<Density>(rho);
  in.sigma_adm = from_si<Stress>(sigma_adm);
  Columns general;
  const Sweep sweep(erased<belt::Flat>(), record_of<belt::Flat>(in), {{"P", P}, {"a", a}},
                    {"i", "L", "alpha_1", "b_min", "S_0_min", "S_1", "S_2", "mu_req", "sigma_max", "R_0", "R", "f_B",
                     "l_s", "v_opt", "theta_R"},
                    general);
  Columns plain(general.size(), std::vector<double>(points));
  const auto by_hand = [&] {
    for (std::size_t i = 0; i < points; ++i) {
      const double v = n_1 * d_1 / 2.0, gamma = std::asin((d_2 - d_1) / (2.0 * a[i]));
      const double alpha_1 = pi - 2.0 * gamma, alpha_2 = pi + 2.0 * gamma, alpha = std::min(alpha_1, alpha_2);
      const double L = 2.0 * a[i] * std::cos(gamma) + (d_1 * alpha_1 + d_2 * alpha_2) / 2.0;
      const double F_t = K_A * P[i] / v, m_e = std::exp(mu * alpha);
      const double sigma_N = sigma_adm - rho * v * v, F_c = rho * b * delta * v * v;
      const double S_0 = F_t / 2.0 * (m_e + 1.0) / (m_e - 1.0) + F_c;
      const double S_1 = S_0 + F_t / 2.0, S_2 = S_1 - F_t;
      const double x = (S_1 - F_c + S_2 - F_c) * std::cos(gamma), y = F_t * std::sin(gamma);
      plain[0][i] = d_2 / d_1 / (1.0 - epsilon), plain[1][i] = L, plain[2][i] = alpha_1;
      plain[3][i] = F_t / (delta * sigma_N * (1.0 - 1.0 / m_e)), plain[4][i] = S_0, plain[5][i] = S_1;
      plain[6][i] = S_2, plain[7][i] = std::log((S_1 - F_c) / (S_2 - F_c)) / alpha;
      plain[8][i] = S_1 / (b * delta), plain[9][i] = 2.0 * S_0 * std::cos(gamma), plain[10][i] = std::hypot(x, y);
      plain[11][i] = 2.0 * v / L, plain[12][i] = a[i] * std::cos(gamma);
      plain[13][i] = std::sqrt(sigma_adm / (3.0 * rho)), plain[14][i] = std::atan(y / x);
    }
  };
  race(state, sweep, by_hand, general, plain);
}

/// Helical gears on a given centre distance, with forces and Lewis' stresses, every result; or only geometry.
void gear_pair(benchmark::State& state) {
  constexpr double z_1 = 20.0, z_2 = 57.0, m_n = 2.5e-3, a_w = 0.1, T = 60.0;
  const auto x_1 = spread(0.1, 0.5, 12), beta = spread(0.17, 0.22, 13), alpha = spread(0.34, 0.36, 14);
  gear::Pair::Input in;
  in.z_1 = 20, in.z_2 = 57, in.m_n = m_n * m, in.a_w = a_w * m, in.b = 28.0 * mm, in.T_1 = T * N_m, in.K_A = 1.25;
  in.n_1 = 1450.0 * rpm, in.cutting = gear::Cutting::hobbed;
  in.sigma_adm_1 = 220.0 * MPa, in.sigma_adm_2 = 200.0 * MPa;
  Columns general;
  const Sweep sweep(erased<gear::Pair>(), record_of<gear::Pair>(in), {{"x_1", x_1}, {"beta", beta}, {"alpha_n", alpha}},
                    {"alpha_t", "alpha_wt", "x_0", "eps_alpha", "F_bn", "s_an1", "sigma_F1", "sigma_F2"}, general);
  Columns plain(5, std::vector<double>(points));
  const auto by_hand = [&] {
    for (std::size_t i = 0; i < points; ++i) {
      const double m_t = m_n / std::cos(beta[i]), alpha_t = std::atan(std::tan(alpha[i]) / std::cos(beta[i]));
      const double d_1 = z_1 * m_t, d_2 = z_2 * m_t, a = 0.5 * (d_1 + d_2), c = std::cos(alpha_t);
      const double alpha_w = std::acos(a * c / a_w), inv_w = std::tan(alpha_w) - alpha_w;
      const double x_0 = (z_1 + z_2) * (inv_w - std::tan(alpha_t) + alpha_t) / (2.0 * std::tan(alpha[i])),
                   x_2 = x_0 - x_1[i];
      const double k = std::max(0.0, x_0 - (a_w - a) / m_n);
      const double d_a1 = d_1 + 2.0 * m_n * (1.0 + x_1[i] - k), d_a2 = d_2 + 2.0 * m_n * (1.0 + x_2 - k);
      const double rho_1 = std::sqrt(d_a1 * d_a1 - d_1 * c * d_1 * c),
                   rho_2 = std::sqrt(d_a2 * d_a2 - d_2 * c * d_2 * c);
      const double g = 0.5 * (rho_1 + rho_2) - a_w * std::sin(alpha_w), lean = std::tan(beta[i]) * c;
      const double F_tw = 2.0 * T / (2.0 * a_w * z_1 / (z_1 + z_2));
      plain[0][i] = alpha_t, plain[1][i] = alpha_w, plain[2][i] = x_0, plain[3][i] = g / (pi * m_t * c);
      plain[4][i] = F_tw / std::cos(alpha_w) * std::sqrt(1.0 + lean * lean);
    }
  };
  compare(state, sweep, by_hand);
  if (!std::equal(plain.begin(), plain.end(), general.begin(), Agree{1e-11})) state.SkipWithError("they disagree");
}

}  // namespace

BENCHMARK(stress_cycle);
BENCHMARK(closed_cylinder);
BENCHMARK(slender_column);
BENCHMARK(gear_pair);
BENCHMARK(flat_belt);
BENCHMARK_MAIN();
