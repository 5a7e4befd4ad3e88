// Input of gear.pair.
#pragma once

#include "calculators/gear/pair_choices.hpp"
#include "lib/calculator/field.hpp"

namespace loadpath::gear {

struct PairInput {
  Mesh mesh = Mesh::external;
  Whole z_1 = 0, z_2 = 0;
  Length m_n = unset<Length>;
  double alpha_n = 20.0 * deg.one, beta = 0.0;
  Hand hand = Hand::right;
  double x_1 = 0.0, x_2 = unset<double>;
  Length a_w = unset<Length>;
  double h_aP = 1.0, h_fP = 1.25, rho_fP = 0.38;
  Shortening shortening = Shortening::clearance;
  Length d_a2 = unset<Length>;
  Length A_s1 = 0.0 * mm, A_s2 = 0.0 * mm;
  Whole k_W1 = 0, k_W2 = 0;
  Length b = unset<Length>;
  double psi_m = unset<double>;
  Moment T_1 = unset<Moment>;
  Power P = unset<Power>;
  AngularSpeed n_1 = unset<AngularSpeed>;
  Turns turns = Turns::ccw;
  double K_A = 1.0, K_f = 1.0;
  Cutting cutting = Cutting::none;
  Idler idler = Idler::none;
  double Y_1 = unset<double>, Y_2 = unset<double>;
  Stress sigma_adm_1 = unset<Stress>, sigma_adm_2 = unset<Stress>;
  Length bore_1 = unset<Length>, bore_2 = unset<Length>, t_k1 = 0.0 * mm, t_k2 = 0.0 * mm;
};

inline bool asks_strength(const PairInput& in) { return is_set(in.sigma_adm_1) || is_set(in.sigma_adm_2); }

}  // namespace loadpath::gear
