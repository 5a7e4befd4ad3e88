// What is mounted on a drawn shaft, from the side: hubs as thin outlines, bearings as boxes with a cross [ISO 8826-1].
#pragma once

#include "lib/draw/canvas/canvas.hpp"
#include "lib/figure/figure.hpp"

#include <string>
#include <vector>

namespace loadpath::draw {

/// In view units.
struct SideOutline {
  double left, right;
  double left_surface, right_surface;  // radius of the shaft at both ends
  double radius;                       // 0: not known
  bool is_bearing;
};

class Outlines {
 public:
  /// A large hub, or one of unknown diameter, is cut off by a break line.
  void add(const SideOutline& outline);
  void draw(double axis, Canvas& canvas) const;
  /// The largest radius that is drawn; 0 without any.
  [[nodiscard]] double reach() const;
  /// The largest radius that is drawn there; 0 without any.
  [[nodiscard]] double radius_at(double x) const;

 private:
  struct Drawn {
    SideOutline of;
    double radius;
    bool is_cut;
  };
  static void draw_hub(const Drawn& hub, double axis, double side, Canvas& canvas);
  static void draw_bearing(const Drawn& bearing, double axis, double side, Canvas& canvas);
  std::vector<Drawn> all_;
};

/// Whether the bearing is drawn as a box, and not as a support.
bool is_outlined(const figure::Shaft::Bearing& bearing);
/// The outer diameter of the largest drawn bearing, m.
double largest_bearing(const figure::Shaft& shaft);

/// "left: 6308, locating".
std::string bearing_words(const figure::Shaft::Bearing& bearing);
/// "3007 N, axial 1199 N".
std::string reaction_words(const figure::Shaft::Bearing& bearing);
/// "181.7 N·m, 2048 N".
std::string load_words(const figure::Shaft::Torque& torque);

}  // namespace loadpath::draw
