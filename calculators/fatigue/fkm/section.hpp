// A section of a shaft or rod by FKM, nominal stresses: its steel, loading, required safety factors and results. The
// section itself and its actions are those of DIN 743. Plain data, so that the sections of a full shaft can be rated
// one by one.
#pragma once

#include "calculators/fatigue/din743/section.hpp"

namespace loadpath::fatigue {

enum class FkmSteelGroup {
  untold,
  structural,
  quenched_tempered,
  normalised,
  case_hardening,
  nitriding,
  stainless,
  forged
};
/// The fibre of the rolled bar, against the normal stresses.
enum class Fibre { along, across };
/// Type of overloading, the quantity kept constant: mean stress, stress ratio, minimum or maximum stress.
enum class Overload { F1, F2, F3, F4 };
/// Whether each stress has its own mean stress, or all stresses the common equivalent one.
enum class Means { together, each };

/// R_mN and R_eN are those of the standard, at its reference diameters, R_m and R_e those of a part of this size. a_dm,
/// d_Nm and a_dp, d_Np are the constants of the size factors; d_h is the diameter at heat treatment.
struct FkmSteel {
  FkmSteelGroup steel = FkmSteelGroup::untold;
  Stress R_mN = unset<Stress>, R_eN = unset<Stress>;
  double a_dm = unset<double>, a_dp = unset<double>;
  Length d_Nm = unset<Length>, d_Np = unset<Length>;
  Stress R_m = unset<Stress>, R_e = unset<Stress>;
  Length d_h = unset<Length>;
  Fibre fibre = Fibre::along;
  double K_an = unset<double>;
  Stress sigma_W = unset<Stress>, tau_W = unset<Stress>;
};

/// How the part is loaded and how safe it has to be: j_D against fatigue, j_m against fracture, j_p against yielding.
/// The gradients G are those of typed shape factors. Without N it lasts without end.
struct FkmService {
  Overload overload = Overload::F2;
  Means means = Means::together;
  double N = unset<double>;
  double j_D = 1.5, j_m = 2.0, j_p = 1.5;
  Stress R_pmax = from_si<Stress>(1050e6);
  Twist G_zd = unset<Twist>, G_b = unset<Twist>, G_t = unset<Twist>;
};

/// One kind of stress: tension, bending or torsion, whose stresses are shear.
struct FkmStress {
  Name name;
  Stress sigma_m = unset<Stress>, sigma_a = unset<Stress>, sigma_max = unset<Stress>;
  double K_t = unset<double>, n = unset<double>, n_d = unset<double>, K_f = unset<double>, K_R = unset<double>;
  double K_WK = unset<double>;
  Stress sigma_W = unset<Stress>, sigma_WK = unset<Stress>;
  double M = unset<double>;
  Stress sigma_mv = unset<Stress>;
  double K_AK = unset<double>;
  Stress sigma_AK = unset<Stress>;
  double K_BK = unset<double>;
  Stress sigma_BK = unset<Stress>;
  double a = unset<double>, N_a = unset<double>, n_pl = unset<double>;
  Stress sigma_SK = unset<Stress>;
  double a_S = unset<double>;

  using K = FkmStress;
  static constexpr Fields fields{
      NameField<K>{&K::name, "name", "tension, bending or torsion, whose stresses are shear"},
      Field<K, Stress>{&K::sigma_m, "sigma_m", MPa, "mean nominal stress"},
      Field<K, Stress>{&K::sigma_a, "sigma_a", MPa, "amplitude of the nominal stress"},
      Field<K, Stress>{&K::sigma_max, "sigma_max", MPa, "maximum nominal stress"},
      Field<K, double>{&K::K_t, "K_t", ratio, "shape factor"},
      Field<K, double>{&K::n, "n", ratio, "support of the gradient of the notch"},
      Field<K, double>{&K::n_d, "n_d", ratio, "support of the gradient of bending or torsion over the diameter"},
      Field<K, double>{&K::K_f, "K_f", ratio, "notch factor; below 1 where no notch is and bending is supported"},
      Field<K, double>{&K::K_R, "K_R", ratio, "roughness"},
      Field<K, double>{&K::K_WK, "K_WK", ratio, "design factor: notch, roughness, surface treatment"},
      Field<K, Stress>{&K::sigma_W, "sigma_W", MPa, "fatigue limit of the material in tension, in torsion in shear"},
      Field<K, Stress>{&K::sigma_WK, "sigma_WK", MPa, "fatigue limit of the section, R = −1"},
      Field<K, double>{&K::M, "M", ratio, "sensitivity to mean stress"},
      Field<K, Stress>{&K::sigma_mv, "sigma_mv", MPa, "effective mean stress"},
      Field<K, double>{&K::K_AK, "K_AK", ratio, "mean stress factor"},
      Field<K, Stress>{&K::sigma_AK, "sigma_AK", MPa, "permissible amplitude at this mean stress"},
      Field<K, double>{&K::K_BK, "K_BK", ratio, "factor for finite life"},
      Field<K, Stress>{&K::sigma_BK, "sigma_BK", MPa, "amplitude for the required life"},
      Field<K, double>{&K::a, "a", ratio, "utilisation in fatigue, with its safety factor"},
      Field<K, double>{&K::N_a, "N_a", ratio, "life under this stress only, with its safety factor"}.may_be_infinite(),
      Field<K, double>{&K::n_pl, "n_pl", ratio, "plastic support of the section"},
      Field<K, Stress>{&K::sigma_SK, "sigma_SK", MPa, "static strength of the section"},
      Field<K, double>{&K::a_S, "a_S", ratio, "static utilisation, with its safety factor"}};
};

inline double shape_of(const FkmStress& k) { return k.K_t; }

/// S_D is infinite without amplitude. Only the x with a range for the section are set.
struct FkmSafety : NotchRanges {
  Length d_eff = unset<Length>;
  double K_dm = unset<double>, K_dp = unset<double>, K_an = unset<double>;
  Stress R_md = unset<Stress>, R_ed = unset<Stress>;
  Stress sigma_mv = unset<Stress>, tau_mv = unset<Stress>;
  double q = unset<double>, a_NH = unset<double>, a_GH = unset<double>, S_D = unset<double>, j_ges = unset<double>;
  double u_D = unset<double>, u_S = unset<double>;
  double x_eff = unset<double>, x_G = unset<double>, x_Rz = unset<double>, x_N = unset<double>;
  double x_small = unset<double>;
  List<FkmStress, 3> stresses;
};

}  // namespace loadpath::fatigue
