// Results of a bar with bending.
#pragma once

#include "calculators/column/member/result.hpp"
#include "lib/calculator/fields.hpp"

namespace loadpath::column {

struct BeamColumnResult : MemberResult {
  Moment M_yEd = unset<Moment>, M_zEd = unset<Moment>;
  double section_class = unset<double>;
  Moment M_cr = unset<Moment>;
  double C_1 = unset<double>, lambda_LT = unset<double>, chi_LT = unset<double>, chi_T = unset<double>;
  double C_my = unset<double>, C_mz = unset<double>, C_mLT = unset<double>;
  double k_yy = unset<double>, k_yz = unset<double>, k_zy = unset<double>, k_zz = unset<double>;
  double B_y = unset<double>, B_z = unset<double>;
  Moment M_cy = unset<Moment>, M_cz = unset<Moment>;
  double u_s = unset<double>, u_y = unset<double>, u_z = unset<double>, u_LT = unset<double>, u_T = unset<double>,
         u_H = unset<double>;
  double x_V = unset<double>;
};

/// The moments that are given in one way or the other.
inline constexpr auto moment_inputs = "M_y, M_y_1, q_z, F_z, M_z, M_z_1, q_y, F_y";

inline constexpr auto beam_column_results = join(
    slenderness_results<BeamColumnResult>(), stress_results<BeamColumnResult>(),
    Fields{
        Field{&BeamColumnResult::M_yEd, "M_yEd", N_m, "largest moment about y, with the factor of the actions"},
        Field{&BeamColumnResult::M_zEd, "M_zEd", N_m, "largest moment about z, with the factor of the actions"},
        Field{&BeamColumnResult::section_class, "section_class", ratio, "class of the section under these loads (ec3)"},
        Field{&BeamColumnResult::M_cr, "M_cr", N_m, "elastic critical moment of lateral-torsional buckling"},
        Field{&BeamColumnResult::C_1, "C_1", ratio,
              "moment distribution factor: critical moment over that of a uniform moment (aisc: C_b)"},
        Field{&BeamColumnResult::lambda_LT, "lambda_LT", ratio, "slenderness of lateral-torsional buckling"},
        Field{&BeamColumnResult::chi_LT, "chi_LT", ratio, "reduction factor of lateral-torsional buckling"},
        Field{&BeamColumnResult::chi_T, "chi_T", ratio, "reduction factor of torsional buckling"},
        Field{&BeamColumnResult::C_my, "C_my", ratio, "equivalent uniform moment factor about y"},
        Field{&BeamColumnResult::C_mz, "C_mz", ratio, "equivalent uniform moment factor about z"},
        Field{&BeamColumnResult::C_mLT, "C_mLT", ratio,
              "equivalent uniform moment factor of lateral-torsional buckling"},
        Field{&BeamColumnResult::k_yy, "k_yy", ratio, "interaction factor k_yy of annex B"},
        Field{&BeamColumnResult::k_yz, "k_yz", ratio, "interaction factor k_yz of annex B"},
        Field{&BeamColumnResult::k_zy, "k_zy", ratio, "interaction factor k_zy of annex B"},
        Field{&BeamColumnResult::k_zz, "k_zz", ratio, "interaction factor k_zz of annex B"},
        Field{&BeamColumnResult::B_y, "B_y", ratio, "amplification B_1 of the moment about y (aisc)"},
        Field{&BeamColumnResult::B_z, "B_z", ratio, "amplification B_1 of the moment about z (aisc)"},
        Field{&BeamColumnResult::M_cy, "M_cy", N_m,
              "resistance to bending about y: with lateral-torsional buckling and gamma_M1 (aisc: over Omega_b)"},
        Field{&BeamColumnResult::M_cz, "M_cz", N_m,
              "resistance to bending about z: with gamma_M1 (aisc: over Omega_b)"}},
    buckling_check<BeamColumnResult>(),
    Fields{Field{&BeamColumnResult::u_s, "u_s", ratio, "section under N, M_y and M_z, EN 1993-1-1 6.2.9"}
               .check(moment_inputs)
               .where_it_applies(),
           Field{&BeamColumnResult::u_y, "u_y", ratio, "interaction with buckling about y, EN 1993-1-1 (6.61)"}
               .check(moment_inputs)
               .where_it_applies(),
           Field{&BeamColumnResult::u_z, "u_z", ratio, "interaction with buckling about z, EN 1993-1-1 (6.62)"}
               .check(moment_inputs)
               .where_it_applies(),
           Field{&BeamColumnResult::u_H, "u_H", ratio, "interaction of axial force and bending, AISC 360 H1"}
               .check(moment_inputs)
               .where_it_applies(),
           Field{&BeamColumnResult::u_LT, "u_LT", ratio, "lateral-torsional buckling: moment about y / resistance"}
               .check("M_y, M_y_1, q_z, F_z")
               .where_it_applies(),
           Field{&BeamColumnResult::u_T, "u_T", ratio, "torsional buckling of an I section: force / resistance"}
               .check("N, P")
               .where_it_applies()},
    slenderness_limit<BeamColumnResult>(), class_limit<BeamColumnResult>(),
    Fields{Field{&BeamColumnResult::x_V, "x_V", ratio,
                 "shear force of the moments and transverse loads / plastic shear resistance; up to 0.5 it does not "
                 "reduce the resistance to bending, EN 1993-1-1 6.2.8"}
               .limit(0, 0.5)
               .where_it_applies()},
    side_by_side<BeamColumnResult>());

}  // namespace loadpath::column
