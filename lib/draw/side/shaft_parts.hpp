// The parts and signs of a drawn shaft, and the texts of its diameters.
#pragma once

#include "lib/draw/canvas/typeset.hpp"
#include "lib/draw/canvas/view.hpp"
#include "lib/figure/figure.hpp"
#include "lib/quantity/format.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace loadpath::draw::shaft {

inline constexpr double shaft_left = 30.0, shaft_right = 450.0, least_length = 180.0;
inline constexpr double diagrams_left = 62.0, diagrams_right = 466.0;  // room for the numbers of their scales
inline constexpr double least_depth = 48.0, most_depth = 170.0;        // thickness of the thickest part
inline constexpr double most_outline = 190.0;                          // diameter of the largest drawn bearing
inline constexpr double torque_reach = 16.0;                           // overhang of torque lines
inline constexpr double torque_radius = 6.5;
inline constexpr double support_depth = 22.0;  // depth of a bearing symbol with its ground

inline std::string millimetres(double metres) { return format_number(std::round(1e5 * metres) / 100.0, 6); }
inline std::string diameter_text(double metres) { return "Ø" + millimetres(metres); }

/// "40 mm", of a taper "40 mm to 30 mm".
inline std::string diameters(const figure::Shaft::Part& part) {
  const std::string left = format_quantity(part.diameter, "mm", 5);
  if (part.right_diameter() == part.diameter) return left;
  return say("{1} to {2}", left, format_quantity(part.right_diameter(), "mm", 5)).text();
}

struct Cylinder {
  const figure::Shaft::Part* part;
  double left, right, radius, bore;  // view units
  double right_radius = 0.0;         // right radius; differs for a taper
  [[nodiscard]] bool tapers() const { return part->right_diameter() != part->diameter; }
  [[nodiscard]] double radius_at(double x) const {
    return tapers() ? radius + (right_radius - radius) * std::clamp((x - left) / (right - left), 0.0, 1.0) : radius;
  }
  [[nodiscard]] double largest() const { return std::max(radius, right_radius); }
};

/// "T_1 = 900 N·m" of a symbol, "pulley: 900 N·m" of a component.
inline std::string labelled(const std::string& label, const std::string& value) {
  constexpr std::size_t longest_symbol = 2;
  if (label.empty()) return value;
  const bool is_symbol = std::min(label.find('_'), label.size()) <= longest_symbol;
  return say(is_symbol ? "{1} = {2}" : "{1}: {2}", symbol(label), value).text();
}

inline bool acts(double force) { return drawable(force) && force > 1e-6; }

struct TorqueSign {
  const figure::Shaft::Torque* torque;
  Text text;
  double x, half_width;
  std::size_t row;
};

/// A diameter above the shaft, of a part in which its text has no room.
struct RaisedSign {
  const Cylinder* cylinder;
  Text text;
  double x;
  std::size_t row;
};

struct BearingSign {
  const figure::Shaft::Bearing* bearing;
  Text text, reaction;
  double x, middle;  // of the bearing and of its label
  std::size_t row;
};

/// "Ø40", marked where it was found.
inline Text diameter_label(const Cylinder& c) {
  const std::string size = diameter_text(c.part->diameter), mark = c.part->is_sized ? "*" : "";
  return typeset((c.tapers() ? size + "…" + millimetres(c.part->right_diameter()) : size) + mark);
}

/// Whether the text of a diameter has room next to its dimension line, along the shaft.
inline bool fits_along(const Cylinder& c) {
  constexpr double gaps = 15.0;
  return c.right - c.left > width(diameter_label(c), text_size) + gaps;
}

/// Whether it has room across the shaft, above the axis.
inline bool fits_upright(const Cylinder& c) {
  constexpr double least_room = 24.0, gaps = 10.0;
  return c.right - c.left >= least_room &&
         std::min(c.radius, c.right_radius) > width(diameter_label(c), text_size) + gaps;
}

}  // namespace loadpath::draw::shaft
