// The S-N curves of details of steel by DNV-RP-C203 in air, by their names: [DNVC203] table 2-1, edition 2016.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/quantity/units.hpp"

#include <array>

namespace loadpath::fatigue {

enum class DnvDetail { untold, B1, B2, C, C1, C2, D, E, F, F1, F3, G, W1, W2, W3 };

/// The first branch of a detail: N = 10^lg_a S^-m_1, S in MPa.
struct DnvBranch {
  double m_1 = unset<double>, lg_a = unset<double>;
};
/// [DNVC203] table 2-1, edition 2016: B1, C, D, E, F and W3 as read there, the others recalled.
constexpr DnvBranch branch_of(DnvDetail detail) {
  using D = DnvDetail;
  switch (detail) {
    case D::untold:
      return {};
    case D::B1:
      return {4.0, 15.117};
    case D::B2:
      return {4.0, 14.885};
    case D::C:
      return {3.0, 12.592};
    case D::C1:
      return {3.0, 12.449};
    case D::C2:
      return {3.0, 12.301};
    case D::D:
      return {3.0, 12.164};
    case D::E:
      return {3.0, 12.010};
    case D::F:
      return {3.0, 11.855};
    case D::F1:
      return {3.0, 11.699};
    case D::F3:
      return {3.0, 11.546};
    case D::G:
      return {3.0, 11.398};
    case D::W1:
      return {3.0, 11.261};
    case D::W2:
      return {3.0, 11.107};
    case D::W3:
      return {3.0, 10.970};
  }
  return {};
}

constexpr auto choices_of(DnvDetail) {
  using D = DnvDetail;
  return std::array{ChoiceName<D>{D::untold, "not_given", "none: give lg_a", "unstated"},
                    ChoiceName<D>{D::B1, "B1", "lg a 15.117, m_1 4"},
                    ChoiceName<D>{D::B2, "B2", "14.885, m_1 4; not checked against the standard"},
                    ChoiceName<D>{D::C, "C", "12.592, m_1 3, as of all that follow"},
                    ChoiceName<D>{D::C1, "C1", "12.449; not checked against the standard"},
                    ChoiceName<D>{D::C2, "C2", "12.301; not checked against the standard"},
                    ChoiceName<D>{D::D, "D", "12.164"},
                    ChoiceName<D>{D::E, "E", "12.010"},
                    ChoiceName<D>{D::F, "F", "11.855"},
                    ChoiceName<D>{D::F1, "F1", "11.699; not checked against the standard"},
                    ChoiceName<D>{D::F3, "F3", "11.546; not checked against the standard"},
                    ChoiceName<D>{D::G, "G", "11.398; not checked against the standard"},
                    ChoiceName<D>{D::W1, "W1", "11.261; not checked against the standard"},
                    ChoiceName<D>{D::W2, "W2", "11.107; not checked against the standard"},
                    ChoiceName<D>{D::W3, "W3", "10.970"}};
}

}  // namespace loadpath::fatigue
