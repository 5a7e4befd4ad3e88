// Allowable stress numbers of gear materials: [ISO6336-5] table 1, edition 2016, as lines over the hardness.
#pragma once

#include "calculators/gear/rating/choices.hpp"
#include "lib/quantity/units.hpp"

#include <array>
#include <limits>

namespace loadpath::gear {

/// sigma = A H + B in MPa, for a hardness in HBW of steel, nodular and grey, else in HV.
struct StrengthLine {
  GearMaterial material;
  Quality quality;
  double A_H, B_H;  // contact: sigma_Hlim
  double A_F, B_F;  // bending: sigma_Flim, half of sigma_FE
  double low, high;
};

inline constexpr std::array strength_lines{
    StrengthLine{GearMaterial::steel, Quality::ML, 1.0, 190, 0.455, 69, 110, 210},
    StrengthLine{GearMaterial::steel, Quality::MQ, 1.0, 190, 0.455, 69, 110, 210},
    StrengthLine{GearMaterial::steel, Quality::ME, 1.52, 250, 0.386, 147, 110, 210},
    StrengthLine{GearMaterial::nodular, Quality::ML, 1.434, 211, 0.35, 119, 175, 300},
    StrengthLine{GearMaterial::nodular, Quality::MQ, 1.434, 211, 0.35, 119, 175, 300},
    StrengthLine{GearMaterial::nodular, Quality::ME, 1.5, 250, 0.38, 134, 200, 300},
    StrengthLine{GearMaterial::grey, Quality::ML, 1.033, 132, 0.256, 8, 150, 240},
    StrengthLine{GearMaterial::grey, Quality::MQ, 1.033, 132, 0.256, 8, 150, 240},
    StrengthLine{GearMaterial::grey, Quality::ME, 1.465, 122, 0.2, 53, 175, 275},
    StrengthLine{GearMaterial::through_carbon, Quality::ML, 0.963, 283, 0.25, 108, 135, 210},
    StrengthLine{GearMaterial::through_carbon, Quality::MQ, 0.925, 360, 0.24, 163, 135, 210},
    StrengthLine{GearMaterial::through_carbon, Quality::ME, 0.838, 432, 0.283, 202, 135, 210},
    StrengthLine{GearMaterial::through_alloy, Quality::ML, 1.313, 188, 0.423, 104, 200, 360},
    StrengthLine{GearMaterial::through_alloy, Quality::MQ, 1.313, 373, 0.425, 187, 200, 360},
    StrengthLine{GearMaterial::through_alloy, Quality::ME, 2.213, 260, 0.358, 231, 200, 390},
    StrengthLine{GearMaterial::case_hardened, Quality::ML, 0, 1300, 0, 312, 600, 800},
    StrengthLine{GearMaterial::case_hardened, Quality::MQ, 0, 1500, 0, 425, 660, 800},
    StrengthLine{GearMaterial::case_hardened, Quality::ME, 0, 1650, 0, 525, 660, 800},
    StrengthLine{GearMaterial::induction, Quality::ML, 0.74, 602, 0.305, 76, 485, 615},
    StrengthLine{GearMaterial::induction, Quality::MQ, 0.541, 882, 0.138, 290, 500, 570},
    StrengthLine{GearMaterial::induction, Quality::ME, 0.505, 1013, 0.271, 237, 500, 615},
    StrengthLine{GearMaterial::nitrided, Quality::ML, 0, 1125, 0, 270, 650, 900},
    StrengthLine{GearMaterial::nitrided, Quality::MQ, 0, 1250, 0, 420, 650, 900},
    StrengthLine{GearMaterial::nitrided, Quality::ME, 0, 1450, 0, 468, 650, 900},
    StrengthLine{GearMaterial::nitrided_through, Quality::ML, 0, 788, 0, 258, 450, 650},
    StrengthLine{GearMaterial::nitrided_through, Quality::MQ, 0, 998, 0, 363, 450, 650}};

/// Null where table 1 has no such line, or the hardness lies outside of it.
constexpr const StrengthLine* strength_line(GearMaterial material, Quality quality, double hardness) {
  for (const StrengthLine& line : strength_lines) {
    if (line.material == material && line.quality == quality && hardness >= line.low && hardness <= line.high)
      return &line;
  }
  return nullptr;
}

/// The largest values of a material in table 1: of a quality or, where none is stated, of any; at a hardness, or the
/// nearest that table 1 has, or where it is unset at any.
struct StrengthBounds {
  double sigma_H = std::numeric_limits<double>::quiet_NaN(), sigma_F = std::numeric_limits<double>::quiet_NaN();
};
constexpr StrengthBounds strength_bounds(GearMaterial material, Quality quality, double hardness) {
  StrengthBounds most;
  for (const StrengthLine& line : strength_lines) {
    if (line.material != material || (quality != Quality::untold && line.quality != quality)) continue;
    const double known = hardness == hardness ? hardness : line.high;
    const double H = known < line.low ? line.low : known > line.high ? line.high : known;
    const double h = (line.A_H * H + line.B_H) * 1e6, f = (line.A_F * H + line.B_F) * 1e6;
    if (!(most.sigma_H >= h)) most.sigma_H = h;
    if (!(most.sigma_F >= f)) most.sigma_F = f;
  }
  return most;
}

/// Modulus of elasticity and Poisson's ratio: [DIN3990-2] table 1, not checked against the source.
constexpr double modulus_of(GearMaterial material) {
  return material == GearMaterial::nodular ? 173e9 : material == GearMaterial::grey ? 126e9 : 206e9;
}
inline constexpr double poisson = 0.3;

}  // namespace loadpath::gear
