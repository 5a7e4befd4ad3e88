// Values as a figure writes them: in the unit of their axis, with few digits.
#pragma once

#include "lib/draw/canvas/view.hpp"

#include <string>

namespace loadpath::draw {

/// A power's exponent: "⁻⁶".
std::string superscript(int number);

/// The conversion of a scale's SI values to its display unit.
class Display {
 public:
  explicit Display(const figure::Scale& scale);

  [[nodiscard]] double value(double si) const { return slope_ * si + offset_; }
  [[nodiscard]] std::string number(double si) const;  // "-86"
  /// "-86 N·m"; with the power of an axis in its unit, "2.5 µm".
  [[nodiscard]] std::string quantity(double si, int power = 0) const;
  [[nodiscard]] bool in_degrees() const { return degrees_; }
  [[nodiscard]] bool logarithmic() const { return scale_.logarithmic; }
  /// Whether a value of the display unit has a place on the scale.
  [[nodiscard]] bool has_place(double value) const { return drawable(value) && (!scale_.logarithmic || value > 0.0); }
  /// "bending moment M in kN·m" for a power of 3, the symbol marked.
  [[nodiscard]] std::string title(int power, bool with_meaning = true) const;

 private:
  figure::Scale scale_;
  std::string printed_;  // empty: a plain number
  double slope_ = 1.0, offset_ = 0.0;
  bool degrees_ = false;
};

}  // namespace loadpath::draw
