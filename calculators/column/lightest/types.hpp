// Input and result of column.lightest.
#pragma once

#include "calculators/column/buckling.hpp"
#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"

#include <array>

namespace loadpath::column {

struct LightestTypes {
  /// Why a section does not carry the bar.
  enum class Failure { none, load, tension, range, open, strength, beyond, slenderness, thin, twisting };

  struct Family {
    Name family;
    static constexpr Fields fields{
        NameField{&Family::family, "family", "family, or beginning of the section names: IPE, HEA, RHS, W14, HSS8X8"}};
  };
  using Families = List<Family, 12>;

  struct Strength {
    Length t_max = unset<Length>;
    Stress R_e = unset<Stress>;
    static constexpr Fields fields{Field{&Strength::t_max, "t_max", mm, "upper thickness limit"}.positive(),
                                   Field{&Strength::R_e, "R_e", MPa, "yield strength"}.positive()};
  };
  using Strengths = List<Strength, 12>;

  struct Input : Member {
    Families families;
    Strengths strengths;
    SectionKind kind = SectionKind::unsaid;
    Length h_max = unset<Length>, b_max = unset<Length>;
  };

  struct Candidate {
    Name name;
    LineDensity q = unset<LineDensity>;
    AxisName axis = AxisName::y;
    double lambda = unset<double>;
    Stress sigma_cr = unset<Stress>;
    Force P_all = unset<Force>;
    double u = unset<double>, demand = unset<double>, excess = unset<double>;
    Failure failure = Failure::none;
    static constexpr Fields fields{
        NameField{&Candidate::name, "name", "section"},
        Field{&Candidate::q, "q", kg_per_m, "mass per length"},
        Choice{&Candidate::axis, "axis", "axis of maximum slenderness"},
        Field{&Candidate::lambda, "lambda", ratio, "maximum slenderness"},
        Field{&Candidate::sigma_cr, "sigma_cr", MPa, "critical stress, without safety factor"},
        Field{&Candidate::P_all, "P_all", kN, "allowable force"},
        Field{&Candidate::u, "u", ratio, "force / allowable force"},
        Field{&Candidate::demand, "demand", ratio, "maximum of all checks and limits assessed; adequate up to 1"},
        Field{&Candidate::excess, "excess", ratio, "relative mass excess over the section found"},
        Choice{&Candidate::failure, "failure", "reason for rejection"}};
  };
  using Candidates = List<Candidate, 12>;

  struct Result : MemberResult {
    Name section;
    LineDensity q = unset<LineDensity>;
    Mass mass = unset<Mass>;
    double sections = 0.0, carrying = 0.0, lack = unset<double>;
    Candidates candidates, lighter;
  };
};

constexpr auto choices_of(LightestTypes::Failure) {
  using Failure = LightestTypes::Failure;
  return std::array{ChoiceName<Failure>{Failure::none, "none", "none: the section passes"},
                    ChoiceName<Failure>{Failure::load, "load", "allowable force exceeded"},
                    ChoiceName<Failure>{Failure::tension, "tension", "yielding in tension"},
                    ChoiceName<Failure>{Failure::range, "range", "outside the range of the method"},
                    ChoiceName<Failure>{Failure::open, "open", "buckling curve unknown: give the section type"},
                    ChoiceName<Failure>{Failure::strength, "strength", "no strength given for its thickness"},
                    ChoiceName<Failure>{Failure::beyond, "beyond", "slenderness beyond the code table"},
                    ChoiceName<Failure>{Failure::slenderness, "slenderness", "slenderness limit exceeded"},
                    ChoiceName<Failure>{Failure::thin, "thin", "local buckling"},
                    ChoiceName<Failure>{Failure::twisting, "twisting", "torsional-flexural buckling"}};
}

}  // namespace loadpath::column
