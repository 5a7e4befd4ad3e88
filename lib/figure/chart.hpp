// Many designs over two scales: which of them pass, and the data of each. A cloud of points, or the points of a grid
// with contour lines between them.
#pragma once

#include "lib/figure/figure.hpp"

#include <cstdint>

namespace loadpath::figure {

struct Chart {
  enum class Verdict : char { passes, fails, open, none };  // open: not assessed; none: invalid design
  struct Dot {
    double x = 0.0;  // SI
    double y = 0.0;
    Verdict verdict = Verdict::none;
    std::size_t mode = 0;  // index of the failing mode in `modes`
  };
  /// The data shown for each dot: a quantity, or one of several words.
  struct Column {
    std::string name;
    std::string unit;
    std::vector<double> si;
    std::vector<std::string> words = {};
  };
  Scale x;
  Scale y;
  std::vector<Dot> dots;
  std::vector<std::string> modes;
  // For a cloud: the Pareto-optimal dots, by rising x, and those with the highest utilisation.
  std::vector<std::size_t> front;
  std::vector<std::size_t> worst;
  bool more_x = false, more_y = false;  // is better
  bool steps = false;                   // whether the front belongs to only one of these two scales
  // For a grid: number of dots in a row, x and y rising; none: a cloud.
  std::size_t columns = 0;
  std::string level;           // quantity of the contour lines
  std::string level_unit;      // and its unit
  std::vector<double> levels;  // value of each dot, SI; NaN if there is none
  bool is_limited = false;     // at the level 1, if that decides

  std::vector<std::uint64_t> points;  // the number of each dot
  std::vector<Column> readout;
  std::string command;    // command that solves a point separately, without its number
  std::size_t shown = 0;  // dot that is shown first
};

}  // namespace loadpath::figure
