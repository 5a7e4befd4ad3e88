#include "lib/draw/canvas/display.hpp"

#include "lib/draw/canvas/typeset.hpp"
#include "lib/quantity/format.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace loadpath::draw {
namespace {

constexpr int display_digits = 4;

/// A power of ten and a unit as engineers write them: "µm" for 10⁻³ mm; empty if the unit has no such prefix.
std::string_view prefixed(int power, std::string_view unit) {
  struct Prefixed {
    int power;
    std::string_view unit, written;
  };
  static constexpr std::array all{Prefixed{-3, "mm", "µm"},   Prefixed{3, "mm", "m"},     Prefixed{-3, "m", "mm"},
                                  Prefixed{3, "N", "kN"},     Prefixed{6, "N", "MN"},     Prefixed{3, "kN", "MN"},
                                  Prefixed{3, "N·m", "kN·m"}, Prefixed{6, "N·m", "MN·m"}, Prefixed{-3, "MPa", "kPa"},
                                  Prefixed{3, "MPa", "GPa"},  Prefixed{-3, "kW", "W"},    Prefixed{3, "kW", "MW"}};
  const auto found = std::ranges::find_if(all, [&](const Prefixed& p) { return p.power == power && p.unit == unit; });
  return found == all.end() ? std::string_view() : found->written;
}

}  // namespace

std::string superscript(int number) {
  constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(number))) text += digits[c - '0'];
  return text;
}

Display::Display(const figure::Scale& scale) : scale_(scale), degrees_(scale.unit == "deg") {
  if (scale.unit.empty() || scale.unit == "-" || scale.unit == "1") return;
  printed_ = pretty_unit(scale.unit);
  offset_ = in_unit(0.0, scale.unit);
  slope_ = in_unit(1.0, scale.unit) - offset_;
}

std::string Display::number(double si) const { return format_number(value(si), display_digits); }

std::string Display::quantity(double si, int power) const {
  if (printed_ == "%") return number(si) + printed_;
  if (const std::string_view unit = prefixed(power, printed_); !unit.empty())
    return format_number(value(si) * std::pow(10.0, -power), display_digits) + " " + std::string(unit);
  return with_unit(number(si), printed_);
}

std::string Display::title(int power, bool with_meaning) const {
  std::string name = scale_.symbol.empty() ? "" : symbol(scale_.symbol);
  if (with_meaning && !scale_.meaning.empty()) {
    name = say(scale_.meaning).text() + (name.empty() ? "" : " " + name);
  }
  std::string unit = printed_;
  if (const std::string_view written = prefixed(power, unit); !written.empty())
    unit = written;
  else if (power != 0)
    unit = "10" + superscript(power) + (unit.empty() ? "" : " " + unit);
  return unit.empty() ? name : say("{1} in {2}", name, unit).text();
}

}  // namespace loadpath::draw
