// Input and result of fatigue.endurance.
#pragma once

#include "calculators/load/heat_treatment.hpp"
#include "calculators/load/metal.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/quantity/fit_units.hpp"

#include <array>

namespace loadpath::fatigue {

struct EnduranceTypes {
  enum class Group {
    carbon_steel,
    alloy_steel,
    case_hardening_steel,
    stainless_steel,
    cast_steel,
    grey_iron,
    ductile_iron,
    malleable_iron,
    wrought_aluminium,
    cast_aluminium,
    other_non_ferrous
  };
  enum class RuleOf { textbook, din743, fkm, shigley };
  enum class Loading { bending, tension, torsion };
  enum class School { serensen, marin };
  enum class Finish { ground, machined, hot_rolled, forged };
  enum class Edition { ninth, eleventh };
  enum class Turning { rotating, standing };
  enum class Sensitivity { neuber, peterson, cast_iron };

  struct Input {
    Stress R_m = unset<Stress>;
    Group group = Group::carbon_steel;
    Loading loading = Loading::bending;
    RuleOf rule = RuleOf::textbook;
    Stress sigma_W = unset<Stress>;
    School school = School::serensen;
    Stress E = unset<Stress>;
    Density rho = unset<Density>;
    Length d = unset<Length>, d_h = unset<Length>;
    double epsilon = unset<double>, K_t = 1.0, q = unset<double>;
    Length r_n = unset<Length>;
    double K_f = unset<double>;
    Length R_z = unset<Length>;
    double beta_F = unset<double>, beta_V = 1.0;
    Finish finish = Finish::ground;
    Sensitivity sensitivity = Sensitivity::neuber;
    Edition edition = Edition::ninth;
    Turning turning = Turning::rotating;
    Length h = unset<Length>, b = unset<Length>;
    double k_a = unset<double>, k_b = unset<double>, k_c = unset<double>;
    Heating T = unset<Heating>;
    double P_s = unset<double>;
  };

  struct Result {
    Stress sigma_m1 = unset<Stress>, sigma_low = unset<Stress>, sigma_high = unset<Stress>;
    double N_0 = unset<double>;
    double K_f = unset<double>, epsilon = unset<double>, beta_F = unset<double>, K_D = unset<double>;
    double k_a = unset<double>, k_b = unset<double>, k_c = unset<double>, k_d = unset<double>, k_e = unset<double>;
    Length d_e = unset<Length>;
    Stress sigma_D = unset<Stress>;
    double x_d = unset<double>, x_n = unset<double>, x_r = unset<double>, x_Rz = unset<double>, x_T = unset<double>;
    double x_E = unset<double>;
  };
};

constexpr auto choices_of(EnduranceTypes::Group) {
  using G = EnduranceTypes::Group;
  return std::array{ChoiceName<G>{G::carbon_steel, "carbon-steel", "carbon and structural steel"},
                    ChoiceName<G>{G::alloy_steel, "alloy-steel", "low alloy steel, also quenched and tempered"},
                    ChoiceName<G>{G::case_hardening_steel, "case-hardening-steel", "steel for case hardening, core"},
                    ChoiceName<G>{G::stainless_steel, "stainless-steel", "stainless steel"},
                    ChoiceName<G>{G::cast_steel, "cast-steel", "cast steel"},
                    ChoiceName<G>{G::grey_iron, "grey-iron", "grey cast iron"},
                    ChoiceName<G>{G::ductile_iron, "ductile-iron", "ductile (spheroidal graphite) cast iron"},
                    ChoiceName<G>{G::malleable_iron, "malleable-iron", "malleable cast iron"},
                    ChoiceName<G>{G::wrought_aluminium, "wrought-aluminium", "wrought aluminium alloy"},
                    ChoiceName<G>{G::cast_aluminium, "cast-aluminium", "cast aluminium alloy"},
                    ChoiceName<G>{G::other_non_ferrous, "non-ferrous", "other non-ferrous metals"}};
}

constexpr auto choices_of(EnduranceTypes::RuleOf) {
  using R = EnduranceTypes::RuleOf;
  return std::array{ChoiceName<R>{R::textbook, "textbook", "band of the textbook in bending, its lower end"},
                    ChoiceName<R>{R::din743, "din743", "DIN 743-3: 0.5, 0.4, 0.3 of R_m; steels"},
                    ChoiceName<R>{R::fkm, "fkm", "FKM 2012 by group; tension and torsion"},
                    ChoiceName<R>{R::shigley, "shigley", "half of R_m, 700 MPa at most, with load factor; steels"}};
}

constexpr auto choices_of(EnduranceTypes::Loading) {
  using L = EnduranceTypes::Loading;
  return std::array{ChoiceName<L>{L::bending, "bending", "bending, rotating"},
                    ChoiceName<L>{L::tension, "tension", "tension and compression"},
                    ChoiceName<L>{L::torsion, "torsion", "torsion; all stresses are shear stresses"}};
}

constexpr auto choices_of(EnduranceTypes::School) {
  using S = EnduranceTypes::School;
  return std::array{
      ChoiceName<S>{S::serensen, "serensen", "K_D of Serensen and GOST 25.504, size and roughness of DIN 743"},
      ChoiceName<S>{S::marin, "marin", "Marin's factors after Shigley"}};
}

constexpr auto choices_of(EnduranceTypes::Finish) {
  using F = EnduranceTypes::Finish;
  return std::array{
      ChoiceName<F>{F::ground, "ground", "ground"}, ChoiceName<F>{F::machined, "machined", "machined or cold drawn"},
      ChoiceName<F>{F::hot_rolled, "hot-rolled", "hot rolled"}, ChoiceName<F>{F::forged, "forged", "as forged"}};
}

constexpr auto choices_of(EnduranceTypes::Edition) {
  using E = EnduranceTypes::Edition;
  return std::array{
      ChoiceName<E>{E::ninth, "9th", "Shigley, 9th edition"},
      ChoiceName<E>{E::eleventh, "11th", "Shigley, 11th edition; only ground surfaces checked against it"}};
}

constexpr auto choices_of(EnduranceTypes::Turning) {
  using T = EnduranceTypes::Turning;
  return std::array{ChoiceName<T>{T::rotating, "rotating", "rotating: its full rim is stressed"},
                    ChoiceName<T>{T::standing, "standing", "non-rotating: two sides of the rim are stressed"}};
}

constexpr auto choices_of(EnduranceTypes::Sensitivity) {
  using S = EnduranceTypes::Sensitivity;
  return std::array{
      ChoiceName<S>{S::neuber, "neuber", "Neuber's constant; steels"},
      ChoiceName<S>{S::peterson, "peterson",
                    "Peterson's constant; steels from 560 MPa; not checked against the source"},
      ChoiceName<S>{S::cast_iron, "cast-iron", "0.2, for all grades of cast iron; not checked against the source"}};
}

}  // namespace loadpath::fatigue
