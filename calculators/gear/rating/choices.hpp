// Choices of the rating of a gear pair.
#pragma once

#include "lib/calculator/field.hpp"

#include <array>

namespace loadpath::gear {

/// The groups of materials of ISO 6336-5; `steel`: normalized low carbon steel.
enum class GearMaterial {
  steel,
  nodular,
  grey,
  through_carbon,
  through_alloy,
  case_hardened,
  induction,
  nitrided,
  nitrided_through
};
enum class Quality { untold, ML, MQ, ME };
/// How the flanks are finished: they carry more, the smoother they are.
enum class Finish { hobbed, mixed, ground };
enum class Crowning { none, crowned, end_relief };
/// The place of the pinion on its shaft, [DIN3990-11].
enum class Place { untold, middle, a, b, c, d, e };
enum class Pattern { unfavourable, favourable };
/// Standard of the factors for load, contact stress and root stress.
enum class RatingStandard { din3990, iso6336 };
/// Edition of ISO 6336-3 for form and helix factors of the root.
enum class RootEdition { of_2006, of_2019 };
/// Whether the pinion stiffens its shaft, [DIN3990-11] figure 3.2.
enum class Stiffening { none, pinion };

constexpr auto choices_of(GearMaterial) {
  using M = GearMaterial;
  return std::array{
      ChoiceName<M>{M::steel, "steel", "normalized low carbon steel, 110 to 210 HBW"},
      ChoiceName<M>{M::nodular, "nodular", "nodular cast iron, 175 to 300 HBW"},
      ChoiceName<M>{M::grey, "grey", "grey cast iron, 150 to 275 HBW"},
      ChoiceName<M>{M::through_carbon, "through_carbon", "through-hardened carbon steel, 135 to 210 HV"},
      ChoiceName<M>{M::through_alloy, "through_alloy", "through-hardened alloy steel, 200 to 390 HV"},
      ChoiceName<M>{M::case_hardened, "case", "case-hardened steel, 600 to 800 HV"},
      ChoiceName<M>{M::induction, "induction", "flame or induction hardened steel, 485 to 615 HV"},
      ChoiceName<M>{M::nitrided, "nitrided", "nitrided nitriding steel, 650 to 900 HV"},
      ChoiceName<M>{M::nitrided_through, "nitrided_through", "nitrided through-hardening steel, 450 to 650 HV"}};
}
constexpr auto choices_of(Quality) {
  using Q = Quality;
  return std::array{ChoiceName<Q>{Q::untold, "", "none: give sigma_Hlim and sigma_Flim"},
                    ChoiceName<Q>{Q::ML, "ML", "modest demands on the material"},
                    ChoiceName<Q>{Q::MQ, "MQ", "demands met by experienced manufacturers at moderate cost"},
                    ChoiceName<Q>{Q::ME, "ME", "demands for high reliability"}};
}
constexpr auto choices_of(Finish) {
  using F = Finish;
  return std::array{ChoiceName<F>{F::hobbed, "hobbed", "hobbed, shaped or planed"},
                    ChoiceName<F>{F::mixed, "mixed", "one gear hobbed, the other ground or shaved"},
                    ChoiceName<F>{F::ground, "ground", "both ground or shaved"}};
}
constexpr auto choices_of(Crowning) {
  using C = Crowning;
  return std::array{ChoiceName<C>{C::none, "none", "no lead modification"},
                    ChoiceName<C>{C::crowned, "crowned", "crowned"},
                    ChoiceName<C>{C::end_relief, "end_relief", "relieved at the ends"}};
}
constexpr auto choices_of(Place) {
  using P = Place;
  return std::array{ChoiceName<P>{P::untold, "", "not given"},
                    ChoiceName<P>{P::middle, "middle", "midway between the bearings"},
                    ChoiceName<P>{P::a, "a", "between the bearings, torque enters at the near end"},
                    ChoiceName<P>{P::b, "b", "between the bearings, torque enters at the far end"},
                    ChoiceName<P>{P::c, "c", "overhung, torque enters through the bearings"},
                    ChoiceName<P>{P::d, "d", "between the bearings, a second gear on the shaft at the near side"},
                    ChoiceName<P>{P::e, "e", "between the bearings, a second gear on the shaft at the far side"}};
}
constexpr auto choices_of(Pattern) {
  using P = Pattern;
  return std::array{ChoiceName<P>{P::unfavourable, "unfavourable", "deflection and manufacturing deviation add up"},
                    ChoiceName<P>{P::favourable, "favourable", "the contact pattern shows that they compensate"}};
}

constexpr auto choices_of(RatingStandard) {
  using S = RatingStandard;
  return std::array{ChoiceName<S>{S::din3990, "din3990", "DIN 3990-11:1989, load at the tip and Y_eps"},
                    ChoiceName<S>{S::iso6336, "iso6336", "ISO 6336-1, -2 and -3:2006, methods B and C"}};
}
constexpr auto choices_of(RootEdition) {
  using E = RootEdition;
  return std::array{ChoiceName<E>{E::of_2006, "2006", "ISO 6336-3:2006"},
                    ChoiceName<E>{E::of_2019, "2019", "ISO 6336-3:2019: Y_F with f_eps, Y_beta over cos^3 beta"}};
}
constexpr auto choices_of(Stiffening) {
  using S = Stiffening;
  return std::array{
      ChoiceName<S>{S::none, "none", "no stiffening: the pinion slides on the shaft, or is keyed or shrunk on"},
      ChoiceName<S>{S::pinion, "pinion", "the body of the pinion stiffens the shaft: d_1/d_sh of 1.15 or more"}};
}

/// Whether the surface of the teeth is hardened.
constexpr bool is_hardened(GearMaterial m) { return m >= GearMaterial::case_hardened; }
constexpr bool is_nitrided(GearMaterial m) {
  return m == GearMaterial::nitrided || m == GearMaterial::nitrided_through;
}

}  // namespace loadpath::gear
