// The styles of all figures: colours by CSS variables that a page may redefine, with fallbacks for a separate figure.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace loadpath::draw {

struct StyleColour {
  std::string_view variable, fallback;  // "--ink", "#1b2530"
};

/// The appearance of a class of elements; of two rules the later one takes precedence.
struct StyleRule {
  std::string_view selector;  // ".grid"; "text"
  const StyleColour* stroke;  // null: not set
  const StyleColour* fill;
  std::string_view rest;  // declarations of CSS: "stroke-width:1.9;stroke-linejoin:round"
};
std::span<const StyleRule> style_rules();

/// The rules for the classes that figures use, within an element of class "lp".
std::string style_sheet();

}  // namespace loadpath::draw
