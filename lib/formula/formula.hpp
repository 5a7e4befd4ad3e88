// Formulas as they are shown: in MathML, in TeX, as plain text.
#pragma once

#include "lib/formula/tree.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::formula {

/// A name as a symbol of the field: tau_adm, sigma_m1, d_i: Greek spelt out, subscript after the first '_', a second
/// '_' a comma, m1 after sigma or tau a -1, words of two or more Latin letters upright. MathML and TeX are fragments:
/// the caller writes <math> or $ around them.
std::string symbol_mathml(std::string_view name);
std::string symbol_tex(std::string_view name);
std::string symbol_plain(std::string_view name);  // τ_adm

/// The branch of a choose that `known` selects is printed when `known` is given; both otherwise.
std::string mathml(const Node& tree, const Substituted& substituted = {}, const Known& known = {});
std::string tex(const Node& tree, const Substituted& substituted = {}, const Known& known = {});
std::string plain(const Node& tree, const Substituted& substituted = {}, const Known& known = {});
/// The terms of the outermost sum, each with its sign: between them a long formula may break.
std::vector<std::string> mathml_terms(const Node& tree, const Substituted& substituted = {}, const Known& known = {});
/// How many these terms are, and about how many letters wide the widest is set; none of them is written.
struct Extent {
  std::size_t terms = 0, widest = 0;
};
Extent extent(const Node& tree, const Substituted& substituted = {}, const Known& known = {});

/// A value with its printed unit, in the three notations: 27.35 mm.
std::string quantity_mathml(const Written& value);
std::string quantity_tex(const Written& value);
std::string quantity_plain(const Written& value);

}  // namespace loadpath::formula
