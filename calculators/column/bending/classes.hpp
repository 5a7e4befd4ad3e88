// Classes of cross-sections by EN 1993-1-1, table 5.2, under a normal force and bending.
#pragma once

#include "calculators/column/codes/eurocode.hpp"

namespace loadpath::column {

/// Stresses that decide how far the web of an I section is compressed, all at the same level of the load.
struct WebStress {
  Force N = unset<Force>;          // compression positive; in tension 0
  Moment M_y = unset<Moment>;      // magnitude
  Moment M_pl = unset<Moment>;     // plastic moment about y
  Stress mean = unset<Stress>;     // N/A
  Stress bending = unset<Stress>;  // of the moments at the extreme fibre of the web
};

struct SectionClass {
  int number = 4;
  double ratio = unset<double>;  // largest width-to-thickness ratio over its limit of class 3
};

/// The class of a doubly symmetric section whose loads grow in proportion. The flanges of an I and all walls of a
/// hollow section count as evenly compressed, the web of an I as it is under N and M_y.
SectionClass section_class(const Plates& section, Stress R_e, const WebStress& web);

}  // namespace loadpath::column
