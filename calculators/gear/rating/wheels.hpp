// What the formulas of a rating need of its two gears.
#pragma once

#include "calculators/gear/pair_layout.hpp"
#include "calculators/gear/pair_mesh.hpp"
#include "calculators/gear/pair_teeth.hpp"
#include "calculators/gear/rating/materials.hpp"
#include "calculators/gear/rating/types.hpp"

namespace loadpath::gear::rating {

using Input = RatingTypes::Input;
using Result = RatingTypes::Result;

/// The pair as gear.pair lays it out.
inline PairInput pair_of(const Input& in) {
  PairInput pair;
  pair.z_1 = in.z_1, pair.z_2 = in.z_2;
  pair.m_n = in.m_n, pair.alpha_n = in.alpha_n, pair.beta = in.beta;
  pair.x_1 = in.x_1, pair.x_2 = in.x_2, pair.a_w = in.a_w;
  pair.h_aP = in.h_aP, pair.h_fP = in.h_fP, pair.rho_fP = in.rho_fP;
  pair.shortening = in.shortening;
  pair.b = in.b;
  return pair;
}

inline PairResult geometry_of(const Input& in) {
  NoTrace quiet;
  PairResult r;
  lay_out(pair_of(in), r, quiet);
  bring_to_mesh(pair_of(in), r, quiet);
  measure_teeth(pair_of(in), r, quiet);
  return r;
}

inline double cos_of_base_helix(const Input& in, const PairResult& g) {
  return cos(atan(tan(in.beta) * cos(g.alpha_t)));
}

/// One gear, with the symbols of its results.
struct Wheel {
  double z, x;
  Length d, d_b, d_a, d_f;
  GearMaterial material;
  Quality quality;
  double H;
  Stress sigma_Hlim, sigma_Flim;
  Length R_z, s_R;
  double cycles;  // of a tooth for one revolution of gear 1
  bool both_ways;
  struct Symbols {
    const char *sigma_H, *sigma_HG, *S_H, *u_H, *K_Fbeta, *Y_Fa, *Y_Sa, *sigma_F0, *sigma_F, *sigma_FG, *S_F, *u_F,
        *Z_NT, *Y_NT, *Y_F, *Y_S, *Y_B;
  } symbols;
};

inline Wheel first_of(const Input& in, const PairResult& g) {
  return {static_cast<double>(in.z_1),
          in.x_1,
          g.d_1,
          g.d_b1,
          g.d_a1,
          g.d_f1,
          in.material_1,
          in.quality_1,
          in.H_1,
          in.sigma_Hlim_1,
          in.sigma_Flim_1,
          in.R_z1,
          in.s_R1,
          static_cast<double>(in.q_1),
          is_idler(in.idler, Idler::gear_1),
          {"sigma_H1", "sigma_HG1", "S_H1", "u_H1", "K_Fbeta1", "Y_Fa1", "Y_Sa1", "sigma_F01", "sigma_F1", "sigma_FG1",
           "S_F1", "u_F1", "Z_NT1", "Y_NT1", "Y_F1", "Y_S1", "Y_B1"}};
}
inline Wheel second_of(const Input& in, const PairResult& g) {
  return {static_cast<double>(in.z_2),
          g.x_2,
          g.d_2,
          g.d_b2,
          g.d_a2,
          g.d_f2,
          in.material_2,
          in.quality_2,
          in.H_2,
          in.sigma_Hlim_2,
          in.sigma_Flim_2,
          in.R_z2,
          in.s_R2,
          static_cast<double>(in.q_2) * static_cast<double>(in.z_1) / static_cast<double>(in.z_2),
          is_idler(in.idler, Idler::gear_2),
          {"sigma_H2", "sigma_HG2", "S_H2", "u_H2", "K_Fbeta2", "Y_Fa2", "Y_Sa2", "sigma_F02", "sigma_F2", "sigma_FG2",
           "S_F2", "u_F2", "Z_NT2", "Y_NT2", "Y_F2", "Y_S2", "Y_B2"}};
}

}  // namespace loadpath::gear::rating
