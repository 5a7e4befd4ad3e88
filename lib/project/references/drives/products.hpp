// A load that is a product of powers of values of [values], taken apart by its numbers.
#pragma once

#include "lib/project/project.hpp"

#include <optional>
#include <string>
#include <vector>

namespace loadpath::project {

struct Product {
  struct Power {
    std::string path;
    int exponent;
    Dimension dimension;
  };
  double number = 1.0;            // plain numbers and pi, without the acceleration of gravity
  std::vector<Power> powers;      // of values of [values], and of application factors
  Dimension of_numbers;           // of the numbers together
  std::vector<std::string> rest;  // values in the other terms of a sum, which counts as one of its terms
};

/// Nothing if the input is computed from anything else, or in another way. Its numbers may have units.
std::optional<Product> product_with_sizes(const Operand& operand, const Project& project);
/// The same, of plain numbers only, and the acceleration of gravity.
std::optional<Product> product_of(const Operand& operand, const Project& project);

/// "K_A", and that of another step: "chain.K_A".
bool is_application_factor(const std::string& path);

/// A value of [values], typed or computed from others; null if it is unknown before the steps are solved.
const Value* value_of_file(const Project& project, const std::string& path);

}  // namespace loadpath::project
