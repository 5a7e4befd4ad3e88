// Templates of a calculator: inputs known in shape, by a few parameters.
#pragma once

#include "lib/calculator/calculator.hpp"

#include <string>

namespace loadpath::cli {

/// The templates of a calculator in a line each.
void show_templates(const Calculator& calculator);

/// "mechanism.planar.slider_crank"; null where there is none of that name. `calculator`: whose it is.
const Template* template_of(const std::string& id, const Calculator*& calculator);
void show_template(const Calculator& calculator, const Template& t);

}  // namespace loadpath::cli
