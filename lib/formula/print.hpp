// Prints a tree in any notation: which parentheses, dots and fractions it takes is decided once; how they are written,
// by the notation.
#pragma once

#include "lib/formula/names.hpp"
#include "lib/formula/tree.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace loadpath::formula {

/// The binding strength of a printed piece.
enum class Level { choice, either, both, comparison, sum, product, power, atom };

class Notation {
 public:
  virtual ~Notation() = default;
  /// Fractions are stacked, exponents are raised; else everything is on one line.
  [[nodiscard]] virtual bool stacked() const { return true; }

  [[nodiscard]] virtual std::string words(std::string_view text) const = 0;
  [[nodiscard]] virtual std::string number(std::string_view digits) const = 0;
  [[nodiscard]] virtual std::string symbol(const Symbol& symbol, std::string_view exponent = {}) const = 0;
  [[nodiscard]] virtual std::string unit(std::string_view pretty) const = 0;
  [[nodiscard]] virtual std::string quantity(std::string_view number, std::string_view unit) const = 0;
  [[nodiscard]] virtual std::string minus() const = 0;
  [[nodiscard]] virtual std::string infix(std::string_view op) const = 0;  // notation of a C++ operator
  [[nodiscard]] virtual std::string thin_space() const = 0;
  [[nodiscard]] virtual std::string fraction(std::string_view over, std::string_view under) const = 0;
  /// Between a value and the value that divides it, on one line.
  [[nodiscard]] virtual std::string solidus() const { return number("/"); }
  [[nodiscard]] virtual std::string power(std::string_view base, std::string_view exponent,
                                          Level of_exponent) const = 0;
  [[nodiscard]] virtual std::string root(int degree, std::string_view radicand) const = 0;
  [[nodiscard]] virtual std::string fenced(std::string_view inner) const = 0;
  [[nodiscard]] virtual std::string magnitude(std::string_view inner) const = 0;
  [[nodiscard]] virtual std::string call(std::string_view function,
                                         const std::vector<std::string>& arguments) const = 0;
  [[nodiscard]] virtual std::string either(std::string_view condition, std::string_view yes,
                                           std::string_view no) const = 0;
};

std::string print(const Notation& notation, const Node& tree, const Substituted& substituted, const Known& known);

/// The same in the terms of its outermost sum, each with its sign.
std::vector<std::string> print_terms(const Notation& notation, const Node& tree, const Substituted& substituted,
                                     const Known& known);

/// A value that is no longer a name: -1.5e-5 becomes −1.5·10⁻⁵.
std::string print_quantity(const Notation& notation, const Written& value);

}  // namespace loadpath::formula
