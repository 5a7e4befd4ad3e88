// A row of the section tables. Values that a family does not have (r of W, e_z of I) are unset.
#pragma once

#include "lib/calculator/field.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/table/rows.hpp"

#include <string_view>

namespace loadpath::section {

struct Profile {
  static constexpr auto group = "section";

  Length h = unset<Length>, b = unset<Length>, t_w = unset<Length>, t_f = unset<Length>;
  Length r = unset<Length>, r_2 = unset<Length>, e_z = unset<Length>;
  LineDensity m = unset<LineDensity>;
  Area A = unset<Area>;
  SecondMoment I_y = unset<SecondMoment>, I_z = unset<SecondMoment>, I_yz = unset<SecondMoment>;
  SecondMoment I_min = unset<SecondMoment>, I_t = unset<SecondMoment>;
  SectionModulus W_y = unset<SectionModulus>, W_z = unset<SectionModulus>, W_t = unset<SectionModulus>;
  Length i_y = unset<Length>, i_z = unset<Length>, i_min = unset<Length>;

  static constexpr Fields fields{
      Field{&Profile::h, "h", mm, "depth; outer diameter of round tubes"},
      Field{&Profile::b, "b", mm, "width"},
      Field{&Profile::t_w, "t_w", mm, "thickness of the web; wall of tubes, leg of angles"},
      Field{&Profile::t_f, "t_f", mm, "thickness of the flange; wall of tubes, leg of angles"},
      Field{&Profile::r, "r", mm, "radius of the fillets"},
      Field{&Profile::r_2, "r_2", mm, "radius of the toes"},
      Field{&Profile::e_z, "e_z", mm, "from the back of a channel's web, of an angle's legs, to the centroid"},
      Field{&Profile::m, "m", kg_per_m, "mass per length"},
      Field{&Profile::A, "A", mm2, "area"},
      Field{&Profile::I_y, "I_y", mm4, "second moment of area about y"},
      Field{&Profile::I_z, "I_z", mm4, "second moment of area about z"},
      Field{&Profile::I_yz, "I_yz", mm4, "product of area"},
      Field{&Profile::I_min, "I_min", mm4, "minimum second moment of area"},
      Field{&Profile::I_t, "I_t", mm4, "torsion constant"},
      Field{&Profile::W_y, "W_y", mm3, "elastic section modulus about y"},
      Field{&Profile::W_z, "W_z", mm3, "elastic section modulus about z"},
      Field{&Profile::W_t, "W_t", mm3, "section modulus in torsion"},
      Field{&Profile::i_y, "i_y", mm, "radius of gyration about y"},
      Field{&Profile::i_z, "i_z", mm, "radius of gyration about z"},
      Field{&Profile::i_min, "i_min", mm, "minimum radius of gyration"}};
};

/// The row of a name or alias, whatever the case and the spaces; null where there is none. Allocates nothing once the
/// tables are read.
const table::Typed<Profile>* find_profile(std::string_view name);

}  // namespace loadpath::section
