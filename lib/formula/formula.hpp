// Formulas as they are shown: in HTML, in TeX, as plain text.
#pragma once

#include "lib/formula/tree.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::formula {

/// A name as a symbol of the field: tau_adm, sigma_m1, d_i: Greek spelt out, subscript after the first '_', a second
/// '_' a comma, m1 after sigma or tau a -1, words of two or more Latin letters upright. TeX is a fragment: the
/// caller writes $ around it. HTML is text of the math font, with its fractions, roots and tables in <math>.
std::string symbol_html(std::string_view name);
std::string symbol_tex(std::string_view name);
std::string symbol_plain(std::string_view name);  // τ_adm

/// The branch of a choose that `known` selects is printed when `known` is given; both otherwise.
std::string html(const Node& tree, const Substituted& substituted = {}, const Known& known = {});
std::string tex(const Node& tree, const Substituted& substituted = {}, const Known& known = {});
std::string plain(const Node& tree, const Substituted& substituted = {}, const Known& known = {});
/// The right side of an equation, "= a", " + b": the terms of the outermost sum, between which a long formula may
/// break.
std::vector<std::string> equation_html(const Node& tree, const Substituted& substituted = {}, const Known& known = {});
std::string equation_html(const Written& value);
/// How many these terms are, and about how many letters wide the widest is set; none of them is written.
struct Extent {
  std::size_t terms = 0, widest = 0;
};
Extent extent(const Node& tree, const Substituted& substituted = {}, const Known& known = {});

/// A value with its printed unit: 27.35 mm.
std::string quantity_tex(const Written& value);
std::string quantity_plain(const Written& value);

}  // namespace loadpath::formula
