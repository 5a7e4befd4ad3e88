// A shaft section by DIN 743, its steel, its actions and its results: plain data, so that the sections of a full
// shaft can be rated one by one.
#pragma once

#include "calculators/fatigue/mean_stress.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/list.hpp"
#include "lib/quantity/units.hpp"

namespace loadpath::fatigue {

enum class Notch {
  untold,
  smooth,
  shoulder,
  round_groove,
  rectangular_groove,
  v_groove,
  keyway,
  two_keyways,
  press_fit,
  cross_hole,
  alpha,
  beta
};
enum class SteelGroup { none, quenched_tempered, case_hardening_crnimo, case_hardening, nitriding, structural };
enum class Layer { none, hard };
enum class Stressing { tension, bending, torsion };

/// Strengths at the reference diameter of the group (sigma_B, sigma_S, the limits of polished bars), or R_m and R_e as
/// they are in a part of this size. d_h is the diameter at heat treatment, which decides the strength.
struct Din743Steel {
  SteelGroup group = SteelGroup::none;
  Stress sigma_B = unset<Stress>, sigma_S = unset<Stress>;
  Stress R_m = unset<Stress>, R_e = unset<Stress>;
  Stress sigma_zdW = unset<Stress>, sigma_bW = unset<Stress>, tau_tW = unset<Stress>;
  Length d_h = unset<Length>;
};

/// The notch factors that are typed are those of tension, bending and torsion; r is the radius of the notch, w the
/// width of a rectangular groove.
struct Din743Section {
  Notch notch = Notch::untold;
  Length d = unset<Length>, d_bore = 0.0 * m.one, D = unset<Length>, r = unset<Length>, w = unset<Length>;
  Length R_z = unset<Length>;
  double K_V = 1.0;
  Layer layer = Layer::none;
  double alpha_zd = unset<double>, alpha_b = unset<double>, alpha_t = unset<double>;
  double beta_zd = unset<double>, beta_b = unset<double>, beta_t = unset<double>;
  Length d_BK = unset<Length>, R_zB = unset<Length>;
};

/// Force or moment in a section: its mean, its amplitude, and the largest that ever comes; one that is unset is not
/// there.
template <class Quantity>
struct Din743Action {
  Quantity mean = unset<Quantity>, amplitude = unset<Quantity>, largest = unset<Quantity>;
  [[nodiscard]] bool acts() const { return is_set(mean) || is_set(amplitude) || is_set(largest); }
};

/// Actions as typed: forces and moments, or their nominal stresses.
struct SectionActions {
  Force F_zdm = unset<Force>, F_zda = unset<Force>, F_zdmax = unset<Force>;
  Moment M_bm = unset<Moment>, M_ba = unset<Moment>, M_bmax = unset<Moment>;
  Moment M_tm = unset<Moment>, M_ta = unset<Moment>, M_tmax = unset<Moment>;
  Stress sigma_zdm = unset<Stress>, sigma_zda = unset<Stress>, sigma_zdmax = unset<Stress>;
  Stress sigma_bm = unset<Stress>, sigma_ba = unset<Stress>, sigma_bmax = unset<Stress>;
  Stress tau_tm = unset<Stress>, tau_ta = unset<Stress>, tau_tmax = unset<Stress>;
  double f_max = unset<double>;
};

/// Actions, as forces and moments, or as nominal stresses where these are set. If no maximum is given, it is f_max
/// times the sum of mean and amplitude; without f_max it is unknown.
struct Din743Loads {
  Din743Action<Force> F_zd;
  Din743Action<Moment> M_b, M_t;
  Din743Action<Stress> sigma_zd, sigma_b, tau_t;
  double f_max = unset<double>;
  MeanStress mean = MeanStress::proportional;
  double S_min = 1.2;
};

/// One kind of stress: tension, bending or torsion, whose stresses are shear.
struct Din743Stress {
  Name name;
  Stress sigma_m = unset<Stress>, sigma_a = unset<Stress>, sigma_max = unset<Stress>;
  double alpha = unset<double>, n = unset<double>, beta = unset<double>, K_2 = unset<double>, K_R = unset<double>;
  double K_sigma = unset<double>;
  Stress sigma_WK = unset<Stress>, sigma_FK = unset<Stress>, sigma_mv = unset<Stress>, sigma_ADK = unset<Stress>;
  double psi = unset<double>, u_a = unset<double>, u_max = unset<double>;

  using K = Din743Stress;
  static constexpr Fields fields{
      NameField<K>{&K::name, "name", "tension, bending or torsion, whose stresses are shear"},
      Field<K, Stress>{&K::sigma_m, "sigma_m", MPa, "mean nominal stress"},
      Field<K, Stress>{&K::sigma_a, "sigma_a", MPa, "amplitude of the nominal stress"},
      Field<K, Stress>{&K::sigma_max, "sigma_max", MPa, "maximum nominal stress"},
      Field<K, double>{&K::alpha, "alpha", ratio, "shape factor"},
      Field<K, double>{&K::n, "n", ratio, "support of the stress gradient"},
      Field<K, double>{&K::beta, "beta", ratio, "notch factor"},
      Field<K, double>{&K::K_2, "K_2", ratio, "size of the section"},
      Field<K, double>{&K::K_R, "K_R", ratio, "roughness: K_F, relative to the bars used to measure beta"},
      Field<K, double>{&K::K_sigma, "K_sigma", ratio, "total influence, in torsion K_tau"},
      Field<K, Stress>{&K::sigma_WK, "sigma_WK", MPa, "fatigue limit of the section, r = −1"},
      Field<K, double>{&K::psi, "psi", ratio, "sensitivity to mean stress"},
      Field<K, Stress>{&K::sigma_FK, "sigma_FK", MPa, "yield limit of the section"},
      Field<K, Stress>{&K::sigma_mv, "sigma_mv", MPa, "equivalent mean stress, in torsion tau_mv"},
      Field<K, Stress>{&K::sigma_ADK, "sigma_ADK", MPa, "permissible amplitude at this mean stress"},
      Field<K, double>{&K::u_a, "u_a", ratio, "amplitude over that"},
      Field<K, double>{&K::u_max, "u_max", ratio, "maximum stress / yield limit"}};
};

/// Position of the notch within the measured or fitted ranges of its kind: only the x that concern it are set.
struct NotchRanges {
  double x_r = unset<double>, x_D = unset<double>, x_alpha = unset<double>, x_t = unset<double>;
  double x_hole = unset<double>, x_bore = unset<double>;
};

/// The safeties are infinite where nothing varies, or nothing acts.
struct Din743Safety : NotchRanges {
  Length d_eff = unset<Length>;
  double K_1B = unset<double>, K_1S = unset<double>;
  Stress sigma_Bd = unset<Stress>, sigma_Sd = unset<Stress>;
  Stress sigma_mv = unset<Stress>, tau_mv = unset<Stress>;
  double S_D = unset<double>, S_F = unset<double>;
  double u_D = unset<double>, u_F = unset<double>;
  double x_m = unset<double>, x_small = unset<double>, x_eff = unset<double>, x_Rz = unset<double>;
  List<Din743Stress, 3> stresses;
};

/// Groups of notches.
constexpr bool has_shape_factors(Notch n) { return n == Notch::shoulder || n == Notch::round_groove; }
constexpr bool is_keyed(Notch n) { return n == Notch::keyway || n == Notch::two_keyways; }
constexpr bool is_typed(Notch n) { return n == Notch::alpha || n == Notch::beta; }
constexpr bool is_groove(Notch n) { return n == Notch::rectangular_groove || n == Notch::v_groove; }
/// Notches around the full circumference: the yield limit rises at their root. Unknown for a typed notch.
constexpr bool runs_around(Notch n) { return has_shape_factors(n) || is_groove(n) || n == Notch::press_fit; }
/// Notches measured with their hub: valid for any roughness under the hub.
constexpr bool needs_roughness(Notch n) { return !is_keyed(n) && n != Notch::press_fit; }
constexpr bool has_depth(Notch n) { return has_shape_factors(n) || is_groove(n); }
constexpr bool needs_radius(Notch n) {
  return has_shape_factors(n) || n == Notch::rectangular_groove || n == Notch::cross_hole;
}

/// One of three, by kind of stress.
template <class Quantity>
constexpr Quantity typed_of(Stressing kind, Quantity zd, Quantity b, Quantity t) {
  return kind == Stressing::tension ? zd : kind == Stressing::bending ? b : t;
}

}  // namespace loadpath::fatigue
