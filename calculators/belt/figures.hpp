// Drives to scale: pulleys or sprockets, belt or chain with its wraps, tensions, and what the shafts take.
#pragma once

#include "calculators/belt/loop.hpp"
#include "lib/figure/drawing.hpp"
#include "lib/quantity/units.hpp"

#include <string>
#include <vector>

namespace loadpath::belt {

/// A drive of two pulleys in SI. Unknown values stay NaN and are not drawn. Pulley 1 is drawn rotating clockwise, so
/// that the tight span lies below.
struct TwoWheels {
  double d_1 = unset<double>, d_2 = unset<double>, a = unset<double>;
  double d_a1 = unset<double>, d_a2 = unset<double>;  // rims, where they are not the wheels themselves
  bool crossed = false;
  double alpha_1 = unset<double>, alpha_2 = unset<double>;
  double n_1 = unset<double>, n_2 = unset<double>;
  double farther = unset<double>, nearer = unset<double>;  // how far the centre distance is to be changed
};

/// Tensions and shaft loads; R_y points to the side of the tight span, on the driving shaft.
struct Pulls {
  double tight = unset<double>, slack = unset<double>;
  std::string tight_symbol = "S_1", slack_symbol = "S_2";
  bool of_one_belt = false;  // then they are listed, not drawn: the shaft carries those of all belts
  double R = unset<double>, R_x = unset<double>, R_y = unset<double>;
  std::string symbol = "R";
};

/// The straight pieces between the wheels, each from wheel 1 to wheel 2: the upper one, as it leaves wheel 1, first.
std::array<LoopSpan, 2> spans_of(const TwoWheels& w);
/// The belt as one closed line, from wheel 1 at the origin to wheel 2 at (a, 0).
std::vector<figure::Point> line_of(const TwoWheels& w);

figure::Drawing::View drive_view(const TwoWheels& w, const Pulls& pulls);

figure::Figure drive_figure(const TwoWheels& w, const Pulls& pulls);

}  // namespace loadpath::belt
