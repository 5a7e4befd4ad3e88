// Input of shaft.design.
#pragma once

#include "calculators/fatigue/endurance.hpp"
#include "calculators/shaft/parts/pieces.hpp"
#include "lib/calculator/field.hpp"

namespace loadpath::shaft {

inline constexpr std::size_t most_pieces = 32, most_supports = 8, most_seats = 24, most_notches = 32;
inline constexpr std::size_t most_orders = 12, most_whirls = 3;

enum class School { goodman, soderberg, gerber, elliptic, din743, fkm, serensen };

struct DesignInput {
  List<Piece, most_pieces> pieces;
  List<Support, most_supports> supports;
  List<Seat, most_seats> seats;
  List<Notched, most_notches> notches;
  List<Order, most_orders> orders;
  AngularSpeed n = unset<AngularSpeed>;
  double K_A = 1.0, k_max = 1.0, g_angle = unset<double>;
  Stress E = unset<Stress>, G = unset<Stress>;
  Density rho = unset<Density>;
  Length d_h = unset<Length>;
  Stress R_e = unset<Stress>, R_m = unset<Stress>;
  double S_F = unset<double>, S_D = unset<double>, r_T = unset<double>;
  School method = School::goodman;
  fatigue::Endurance::Group group = fatigue::Endurance::Group::carbon_steel;
  fatigue::Endurance::Finish finish = fatigue::Endurance::Finish::machined;
  Stress sigma_W = unset<Stress>;
  Length R_z = unset<Length>;
  Length v_adm = unset<Length>;
  Twist theta_adm = unset<Twist>;
  double k_n = 1.25;
  Whole whirl_modes = 1;
};

inline bool asks_fatigue(const DesignInput& in) { return is_set(in.S_D); }

constexpr auto choices_of(School) {
  return std::array{
      ChoiceName<School>{School::goodman, "goodman", "a line to the tensile strength"},
      ChoiceName<School>{School::soderberg, "soderberg", "a line to the yield strength: on the safe side"},
      ChoiceName<School>{School::gerber, "gerber", "a parabola to the tensile strength"},
      ChoiceName<School>{School::elliptic, "elliptic", "an ellipse to the yield strength, of ASME"},
      ChoiceName<School>{School::din743, "din743", "DIN 743, case 2: constant stress ratio"},
      ChoiceName<School>{School::fkm, "fkm", "FKM, case F2: constant stress ratio; steels, no castings"},
      ChoiceName<School>{School::serensen, "serensen", "Serensen, with size and surface of DIN 743"}};
}

}  // namespace loadpath::shaft
