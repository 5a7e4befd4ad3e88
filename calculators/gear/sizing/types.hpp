// Input and result of gear.sizing.
#pragma once

#include "calculators/gear/rating/rating.hpp"
#include "lib/calculator/field.hpp"

#include <array>

namespace loadpath::gear {

struct PairSizingTypes {
  /// Ranking criterion.
  enum class By { mass, centre };
  /// Distribution of the profile shift over both gears.
  enum class Shift { balanced, none };
  /// The mode that rejects a pair.
  enum class Failure {
    none,
    pitting_1,
    pitting_2,
    root_1,
    root_2,
    dynamic,
    stiffness,
    contact,
    undercut,
    pointed,
    interference,
    clearance,
    fit
  };

  struct Helix {
    double beta = unset<double>;
    static constexpr Fields fields{Field{&Helix::beta, "beta", deg, "helix angle"}.within(0, 45).usually(0, 30)};
  };
  using Helices = List<Helix, 6>;

  /// Load, accuracy, materials and required safety factors are those of gear.rating; its teeth are sought.
  struct Input : RatingTypes::Input {
    Power P = unset<Power>;
    double i_set = unset<double>, tol_i = 0.03;
    Length a_set = unset<Length>;
    Helices betas;
    Shift shift = Shift::balanced;
    double x_sum = unset<double>;
    Whole z_min = 17, z_max = 35;
    Length m_min = unset<Length>, m_max = unset<Length>;
    double psi_min = 0.3, psi_max = 1.0;
    Density rho = from_si<Density>(7850.0);
    By by = By::mass;
  };

  struct Candidate {
    Length m_n = unset<Length>;
    Whole z_1 = 0, z_2 = 0;
    double beta = unset<double>;
    Length b = unset<Length>;
    double x_1 = unset<double>, x_2 = unset<double>;
    Length a_w = unset<Length>;
    Mass mass = unset<Mass>;
    double S_H = unset<double>, S_F = unset<double>, u = unset<double>, excess = unset<double>;
    Failure failure = Failure::none;
    static constexpr Fields fields{
        Field{&Candidate::m_n, "m_n", mm, "normal module"},
        Count{&Candidate::z_1, "z_1", 0, 2000, "number of teeth, gear 1"},
        Count{&Candidate::z_2, "z_2", 0, 2000, "number of teeth, gear 2"},
        Field{&Candidate::beta, "beta", deg, "helix angle"},
        Field{&Candidate::b, "b", mm, "face width"},
        Field{&Candidate::x_1, "x_1", ratio, "profile shift coefficient, gear 1"},
        Field{&Candidate::x_2, "x_2", ratio, "profile shift coefficient, gear 2"},
        Field{&Candidate::a_w, "a_w", mm, "working centre distance"},
        Field{&Candidate::mass, "mass", kg, "mass of both gears"},
        Field{&Candidate::S_H, "S_H", ratio, "safety factor against pitting, the smaller one"},
        Field{&Candidate::S_F, "S_F", ratio, "safety factor against tooth breakage, the smaller one"},
        Field{&Candidate::u, "u", ratio, "maximum utilisation: required / calculated safety factor"},
        Field{&Candidate::excess, "excess", ratio, "relative excess over the best pair in the ranking criterion"},
        Choice{&Candidate::failure, "failure", "reason for rejection"}};
  };
  using Candidates = List<Candidate, 10>;

  /// Input that gear.rating takes from a pair.
  struct Teeth : RatingTypes::Input {
    static constexpr const auto& fields = Rating::inputs;
  };

  struct Result : RatingTypes::Result {
    double tried = 0.0, found = 0.0;
    Length m_n = unset<Length>, b = unset<Length>, a_w = unset<Length>;
    Length d_1 = unset<Length>, d_2 = unset<Length>;
    Whole z_1 = 0, z_2 = 0;
    double beta = unset<double>, x_1 = unset<double>, x_2 = unset<double>;
    double i = unset<double>, dev_i = unset<double>, psi_d = unset<double>;
    double zeta_1 = unset<double>, zeta_2 = unset<double>;
    Mass mass = unset<Mass>;
    Teeth best;
    Candidates candidates, rejected;
  };
};

constexpr auto choices_of(PairSizingTypes::By) {
  using By = PairSizingTypes::By;
  return std::array{ChoiceName<By>{By::mass, "mass", "small mass of both gears as solid cylinders of d and b"},
                    ChoiceName<By>{By::centre, "centre", "small centre distance, then small mass"}};
}
constexpr auto choices_of(PairSizingTypes::Shift) {
  using Shift = PairSizingTypes::Shift;
  return std::array{ChoiceName<Shift>{Shift::balanced, "balanced", "equal specific sliding at both root flanks"},
                    ChoiceName<Shift>{Shift::none, "none", "no profile shift"}};
}
constexpr auto choices_of(PairSizingTypes::Failure) {
  using F = PairSizingTypes::Failure;
  return std::array{ChoiceName<F>{F::none, "none", "none: the pair passes"},
                    ChoiceName<F>{F::pitting_1, "pitting_1", "pitting, gear 1"},
                    ChoiceName<F>{F::pitting_2, "pitting_2", "pitting, gear 2"},
                    ChoiceName<F>{F::root_1, "root_1", "tooth breakage, gear 1"},
                    ChoiceName<F>{F::root_2, "root_2", "tooth breakage, gear 2"},
                    ChoiceName<F>{F::dynamic, "dynamic", "velocity outside the range of the dynamic factor"},
                    ChoiceName<F>{F::stiffness, "stiffness", "profile shifts outside the range of the mesh stiffness"},
                    ChoiceName<F>{F::contact, "contact", "transverse contact ratio outside 1 to 2"},
                    ChoiceName<F>{F::undercut, "undercut", "undercut"},
                    ChoiceName<F>{F::pointed, "pointed", "tip thickness"},
                    ChoiceName<F>{F::interference, "interference", "tip and fillet interference"},
                    ChoiceName<F>{F::clearance, "clearance", "tip clearance"},
                    ChoiceName<F>{F::fit, "fit", "shaft, bearings or rim: the pair does not fit"}};
}

}  // namespace loadpath::gear
