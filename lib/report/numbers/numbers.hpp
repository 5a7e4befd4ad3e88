// Numbers, names and sizes as the short answer writes them.
#pragma once

#include "lib/account/cell.hpp"

#include <string>
#include <string_view>

namespace loadpath::report {

/// Three significant digits, four behind a leading 1: "2.69", "10.79".
std::string short_number(double value);
/// A safety factor: "2.69", above 1000 "> 1000".
std::string safety_number(double value);
/// A number with a prefix that gives 1 to 9999: "45.3 kN", "34.8 µm", "30°".
std::string short_quantity(double si, const std::string& unit);
/// Both in one unit: "45.3 / 42.3 kN".
std::string short_pair(const account::Quantity& demand, const account::Quantity& capacity);
/// Three decimals; more where it would be rounded to 1 and is not: "0.859", "0.9997".
std::string utilisation_text(double utilisation);
/// A name of the file as a text has it: "left seat" of "left_seat".
std::string spoken(std::string name);
/// Whether a name is a word and no symbol of the field: "roller", "force_balance"; not "tau_adm", "KA".
bool is_word(std::string_view name);
/// With a capital letter in front.
std::string capitalised(std::string text);

}  // namespace loadpath::report
