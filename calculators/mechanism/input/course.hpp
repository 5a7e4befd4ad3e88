// How loads vary, by name: shares of them over time or a stroke by points, or by a formula.
#pragma once

#include "lib/calculator/field.hpp"

#include <vector>

namespace loadpath::planar {

struct Course {
  Name name;
  struct AtTime {
    Time t = unset<Time>;
    double share = unset<double>;
    static constexpr Fields fields{Field{&AtTime::t, "t", sec, "time since the first position"},
                                   Field{&AtTime::share, "share", ratio, "share of F and M then"}};
  };
  std::vector<AtTime> over_time;
  struct AtPlace {
    Length s = unset<Length>;
    double share = unset<double>;
    static constexpr Fields fields{Field{&AtPlace::s, "s", mm, "length of the cylinder, or position along the guide"},
                                   Field{&AtPlace::share, "share", ratio, "share of F and M at this position"}};
  };
  std::vector<AtPlace> over_stroke;
  Formula share_of_phi, share_of_t, share_of_s;
  Name stroke_of;
  static constexpr Fields fields{
      NameField{&Course::name, "name", "name of the course"},
      ListField{&Course::over_time, "over_time", "shares over the time, straight from each to the next"}
          .as_arrays()
          .may_be_missing(),
      ListField{&Course::over_stroke, "over_stroke", "shares over a stroke, straight from each to the next"}
          .as_arrays()
          .may_be_missing(),
      FormulaField{&Course::share_of_phi, "share_of_phi",
                   "share as a formula of the crank angle phi: 0.5 - 0.5*cos(phi)"}
          .may_be_missing(),
      FormulaField{&Course::share_of_t, "share_of_t", "share as a formula of the time t: exp(-t/(2 s))"}
          .may_be_missing(),
      FormulaField{&Course::share_of_s, "share_of_s", "share as a formula of the stroke s: (80 mm)/s"}.may_be_missing(),
      NameField{&Course::stroke_of, "stroke_of",
                "cylinder, prismatic joint or slot whose length or position the stroke is; omitted: the only one"}
          .may_be_missing()};
};

}  // namespace loadpath::planar
