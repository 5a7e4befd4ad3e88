// A point under plane stress that comes and goes out of phase: its safety without end by four criteria side by side.
//
// Decides how many times as large the full path of sigma_x, sigma_y and tau_xy may be: Findley and Matake on planes of
// all directions in space, Crossland by invariants, Dang Van on the scale of grains; each set by the two fatigue limits
// sigma_D and tau_D in symmetric cycles. The shear amplitude of a plane is the radius of the smallest circle around its
// path, that of the deviator the radius of the smallest ball. Yielding by von Mises at every moment. Compression is no
// help: largest normal and hydrostatic stresses count from 0. Stresses are those of the point, as sigma_D and tau_D
// are, tension positive; the samples of the three are taken at the same moments, straight between them, and come again.
// Crossland and Dang Van hold up to tau_D/sigma_D = 0.8, the limit of hard metals in the usual classification
// (recalled); Findley and Matake answer from 0.5 to 1. Not covered: finite life, stresses across the surface, mild
// metals below 0.5.
#pragma once

#include "calculators/load/heat_treatment.hpp"
#include "calculators/load/limit_meanings.hpp"
#include "calculators/load/metal.hpp"
#include "calculators/load/strength_rules.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/strength_bounds.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"

#include <array>
#include <limits>
#include <vector>

namespace loadpath::fatigue {

struct Multiaxial {
  static constexpr auto id = "fatigue.multiaxial";
  static constexpr auto title = "Non-proportional multiaxial fatigue";
  static constexpr auto scope =
      "Infinite-life safety factor at a surface point in plane stress with independently varying sigma_x, "
      "sigma_y and tau_xy by Findley, Matake, Crossland and Dang Van, with von Mises in phase for comparison, "
      "the critical plane and yielding; brittle metals by Findley and Matake only; finite life and stresses normal to "
      "the surface are not covered.";
  static constexpr auto source = "[Findley], [Matake], [Crossland], [DangVan], [Mises]";
  static constexpr auto headline = "n = {n}";
  static constexpr auto subject = "fatigue";
  static constexpr auto synonyms =
      "multiaxial fatigue, non-proportional, out of phase, critical plane, Findley, Matake, Crossland, Dang Van, "
      "mehrachsige Ermüdung, kritische Schnittebene, nichtproportional, многоосная усталость, "
      "непропорциональное нагружение";
  static constexpr auto example = R"([project]
title = "Hollow shaft, bending and torsion a quarter of a turn apart"

[point]
calculator = "fatigue.multiaxial"
sigma_x = { values = [0, 43.3, 75, 86.6, 75, 43.3, 0, -43.3, -75, -86.6, -75, -43.3], unit = "MPa" }
tau_xy = { values = [95, 89.6, 75, 55, 35, 20.4, 15, 20.4, 35, 55, 75, 89.6], unit = "MPa" }
sigma_D = "240 MPa"
tau_D = "150 MPa"
R_e = "490 MPa"
S_D = 1.5
S_F = 1.5
)";

  static constexpr double most_of_hard = 0.8;  // tau_D/sigma_D, up to which Crossland and Dang Van hold

  /// Governing criterion: the worst of those valid for tau_D/sigma_D.
  enum class Criterion { worst, findley, matake, crossland, dang_van };

  struct Input {
    Varying<Stress> sigma_x = 0.0 * MPa, sigma_y = 0.0 * MPa, tau_xy = 0.0 * MPa;
    double K_A = 1.0;
    Stress sigma_D = unset<Stress>, tau_D = unset<Stress>;
    Length d_h = unset<Length>;
    Stress R_e = unset<Stress>, E = unset<Stress>;
    Density rho = unset<Density>;
    Criterion criterion = Criterion::worst;
    double S_D = unset<double>, S_F = unset<double>, N = unset<double>, N_D = unset<double>;
  };
  static constexpr Fields inputs = join(
      Fields{
          Field{&Input::sigma_x, "sigma_x", MPa,
                "normal stress along x: a series, or { file, column, unit }, or { values, unit }; or one value"}
              .load()
              .may_be_missing(),
          Field{&Input::sigma_y, "sigma_y", MPa, "normal stress along y, the same, at the same moments"}
              .load()
              .may_be_missing(),
          Field{&Input::tau_xy, "tau_xy", MPa, "shear stress, the same, at the same moments"}.load().may_be_missing(),
          Field{&Input::K_A, "K_A", ratio, "application factor K_A on the stresses (1 if they include it)"}
              .at_least(1)
              .usually(1, 4)
              .factor(),
          Field{&Input::sigma_D, "sigma_D", MPa, "fatigue limit of the point in normal stresses, r = −1"}
              .positive()
              .usually(5, 1500),
          Field{&Input::tau_D, "tau_D", MPa, "the same in torsion, r = −1"}.positive().usually(3, 1000),
          diameter_at_heat_treatment(&Input::d_h).at_least_that_of_source("d_s, t, d_h"),
          Field{&Input::R_e, "R_e", MPa, "yield strength"}
              .positive()
              .usually(50, 2500)
              .customarily_at_most(most_yield_strength)
              .from("material", "R_e", "d_h"),
          modulus_of_material<Input>(&Input::E), density_of_material<Input>(&Input::rho),
          Choice{&Input::criterion, "criterion", "governing criterion"}.may_be_missing(),
          Field{&Input::S_D, "S_D", ratio, "safety factor against fatigue, on the full load path"}
              .at_least(1)
              .usually(1.2, 6)
              .customarily_at_least(1.2)
              .factor(),
          Field{&Input::S_F, "S_F", ratio, "required safety factor against yielding"}
              .at_least(1)
              .usually(1, 6)
              .customarily_at_least(1.2)
              .may_be_missing()
              .factor()},
      cycles_of_metal<Input>());

  struct Result {
    double samples = unset<double>;
    double k = unset<double>, theta_F = unset<double>, phi_F = unset<double>;
    Stress tau_F = unset<Stress>, sigma_F = unset<Stress>, sigma_eF = unset<Stress>;
    double mu = unset<double>, theta_M = unset<double>, phi_M = unset<double>;
    Stress tau_M = unset<Stress>, sigma_M = unset<Stress>, sigma_eM = unset<Stress>;
    double kappa = unset<double>;
    Stress tau_C = unset<Stress>, sigma_H = unset<Stress>, sigma_eC = unset<Stress>;
    double a = unset<double>;
    Stress tau_DV = unset<Stress>, sigma_eDV = unset<Stress>;
    Stress sigma_va = unset<Stress>, sigma_v = unset<Stress>;
    double n_F = unset<double>, n_M = unset<double>, n_C = unset<double>, n_DV = unset<double>, n_v = unset<double>;
    double n = unset<double>, n_y = unset<double>;
    double u_D = unset<double>, x_D = unset<double>, x_C = unset<double>, x_H = unset<double>, e_p = unset<double>;
    double u_y = unset<double>, u_F = unset<double>, x_N = unset<double>;
  };
  static constexpr Fields results{
      Field{&Result::samples, "samples", ratio, "moments at which the path is known"},
      Field{&Result::k, "k", ratio, "weight of the normal stress by Findley, of both fatigue limits"},
      Field{&Result::theta_F, "theta_F", deg, "critical plane of Findley: angle of its normal from the surface normal"},
      Field{&Result::phi_F, "phi_F", deg, "plane of Findley: its normal along the surface, from x to y"},
      Field{&Result::tau_F, "tau_F", MPa, "amplitude of its shear stress: radius of the minimum circumscribed circle"}
          .holding("K_A"),
      Field{&Result::sigma_F, "sigma_F", MPa, "its maximum normal stress, compression as 0"}.holding("K_A"),
      Field{&Result::sigma_eF, "sigma_eF", MPa, "equivalent amplitude in symmetric tension by Findley"}.holding("K_A"),
      Field{&Result::mu, "mu", ratio, "weight of the normal stress by Matake"},
      Field{&Result::theta_M, "theta_M", deg, "plane of Matake, of the maximum amplitude of shear"},
      Field{&Result::phi_M, "phi_M", deg, "the same along the surface"},
      Field{&Result::tau_M, "tau_M", MPa, "amplitude of its shear stress"}.holding("K_A"),
      Field{&Result::sigma_M, "sigma_M", MPa, "its maximum normal stress, compression as 0"}.holding("K_A"),
      Field{&Result::sigma_eM, "sigma_eM", MPa, "equivalent amplitude in symmetric tension by Matake"}.holding("K_A"),
      Field{&Result::kappa, "kappa", ratio, "weight of the hydrostatic stress by Crossland"},
      Field{&Result::tau_C, "tau_C", MPa, "amplitude of sqrt(J_2): radius of the minimum circumscribed sphere"}.holding(
          "K_A"),
      Field{&Result::sigma_H, "sigma_H", MPa, "maximum hydrostatic stress, compression as 0"}.holding("K_A"),
      Field{&Result::sigma_eC, "sigma_eC", MPa, "equivalent amplitude in symmetric tension by Crossland"}.holding(
          "K_A"),
      Field{&Result::a, "a", ratio, "weight of the hydrostatic stress by Dang Van"},
      Field{&Result::tau_DV, "tau_DV", MPa, "maximum of shear stress in grains and a times hydrostatic stress"}.holding(
          "K_A"),
      Field{&Result::sigma_eDV, "sigma_eDV", MPa, "equivalent amplitude in symmetric tension by Dang Van"}.holding(
          "K_A"),
      Field{&Result::sigma_va, "sigma_va", MPa, "von Mises stress of the amplitudes, as if all were in phase"}.holding(
          "K_A"),
      Field{&Result::sigma_v, "sigma_v", MPa, "maximum von Mises stress"}.holding("K_A"),
      Field{&Result::n_F, "n_F", ratio, "safety by Findley"}.may_be_infinite(),
      Field{&Result::n_M, "n_M", ratio, "safety by Matake"}.may_be_infinite(),
      Field{&Result::n_C, "n_C", ratio, "safety by Crossland; none below 0.577 and above 0.8 of tau_D / sigma_D"}
          .may_be_infinite(),
      Field{&Result::n_DV, "n_DV", ratio, "safety by Dang Van; none above 0.8 of tau_D / sigma_D"}.may_be_infinite(),
      Field{&Result::n_v, "n_v", ratio, "safety by von Mises in phase, without mean stress: to compare, never decides"}
          .may_be_infinite(),
      Field{&Result::n, "n", ratio, "safety factor by the governing criterion"}.may_be_infinite(),
      Field{&Result::n_y, "n_y", ratio, "safety against yielding at the most stressed moment"},
      Field{&Result::u_D, "u_D", ratio, "fatigue: required / calculated safety factor"}.check().where_it_applies(),
      Field{&Result::x_D, "x_D", ratio, "tau_D / sigma_D: metals covered by Findley and Matake"}.limit(0.5 - 1e-9, 1.0),
      Field{&Result::x_C, "x_C", ratio, "Crossland only: sqrt(3) tau_D / sigma_D, at least 1"}
          .limit(1 - 1e-9, std::numeric_limits<double>::infinity())
          .where_it_applies(),
      Field{&Result::x_H, "x_H", ratio, "Crossland and Dang Van only: tau_D / sigma_D, up to 0.8"}
          .limit(0.0, most_of_hard + 1e-9)
          .where_it_applies(),
      Field{&Result::e_p, "e_p", ratio, "planes: difference of two searches from other grids, over the larger"},
      Field{&Result::u_y, "u_y", ratio, "yielding: maximum von Mises stress / yield strength"}.check("R_e"),
      Field{&Result::u_F, "u_F", ratio, "yielding: required / calculated safety factor"}.check("S_F"),
      cycles_over_told<Result>(&Result::x_N)};

  static bool in_step(const Input& in);
  static bool varies(const Input& in);
  static bool fine_enough(const Input& in);
  static constexpr std::array rules{
      Rule<Input>{&in_step, "sigma_x, sigma_y, tau_xy",
                  "the stresses must be simultaneous: series of one mechanism, or the same number of samples"},
      Rule<Input>{&varies, "sigma_x, sigma_y, tau_xy",
                  "a constant stress is not a load history: at least one of the three must vary"},
      Rule<Input>{
          &fine_enough, "sigma_x, sigma_y, tau_xy",
          "36 positions of a turn at least, and between them extremes no more than 1 % of the range larger: take more"},
      Rule<Input>{[](const Input& in) { return !(in.tau_D >= in.sigma_D); }, "tau_D, sigma_D",
                  "the fatigue limit in torsion must be below that in normal stress"},
      safety_has_its_yield<Input>()};

  static constexpr std::array meanings{Meaning{"sigma_D", limit_in_normal}, Meaning{"tau_D", limit_in_shear},
                                       Meaning{"sigma_x, sigma_y, tau_xy", steady_part}};
  static constexpr std::array modes{
      Mode<Input>{"yield", "yielding at peak equivalent stress", &always<Input>}.judged_by("u_y, u_F"),
      Mode<Input>{"fatigue", "infinite-life fatigue, non-proportional stresses", &always<Input>}.judged_by(
          "u_D, x_D, x_C, x_H"),
      fatigue_of_metal<&varies, Input>(),
      Mode<Input>{"rest", "additional stress components", &unseen<Input>}.by_companions(),
      Mode<Input>{"across", "surface-normal and subsurface stresses", &unseen<Input>},
      Mode<Input>{"surroundings", "corrosion and heat", &unseen<Input>}.special()};

  static constexpr bool takes_series = false;
  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace);
  static std::vector<figure::Figure> figures(const Input& in, const Result& r);
};

constexpr auto choices_of(Multiaxial::Criterion) {
  using C = Multiaxial::Criterion;
  return std::array{ChoiceName<C>{C::worst, "worst", "the lowest safety factor of all rules valid for tau_D/sigma_D"},
                    ChoiceName<C>{C::findley, "findley", "the plane of the maximum tau_a + k sigma_n"},
                    ChoiceName<C>{C::matake, "matake", "the plane of the maximum tau_a, and its sigma_n"},
                    ChoiceName<C>{C::crossland, "crossland", "root of J_2 of the amplitude and hydrostatic stress"},
                    ChoiceName<C>{C::dang_van, "dang-van", "shear stress in grains and hydrostatic stress"}};
}

}  // namespace loadpath::fatigue
