#include "lib/report/numbers/numbers.hpp"

#include "lib/formula/names.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>

namespace loadpath::report {

namespace {

using Prefixed = std::array<const char*, 4>;  // ascending
constexpr std::array<Prefixed, 7> families{{{"N", "kN", "MN", ""},
                                            {"N*m", "kN*m", "MN*m", ""},
                                            {"W", "kW", "MW", ""},
                                            {"J", "kJ", "MJ", ""},
                                            {"Pa", "kPa", "MPa", "GPa"},
                                            {"um", "mm", "", ""},
                                            {"g", "kg", "", ""}}};

/// The unit of the family whose number has a few digits before its point; the unit itself where it is of none.
std::string readable(double si, const std::string& unit) {
  constexpr double most = 9999.5, least = 0.9995;
  if (unit.empty()) return unit;  // of no family: empty texts fill these up
  const auto family = std::ranges::find_if(families, [&](const Prefixed& all) {
    return std::ranges::any_of(all, [&](const char* one) { return unit == one; });
  });
  if (family == families.end() || si == 0.0 || !std::isfinite(si)) return unit;
  auto at = std::ranges::find_if(*family, [&](const char* one) { return unit == one; });
  const auto size = [&] { return std::abs(in_unit(si, *at)); };
  while (size() > most && at + 1 != family->end() && **(at + 1) != '\0') ++at;
  while (size() < least && at != family->begin()) --at;
  return *at;
}

constexpr std::string_view unbroken_space = "\u00A0";

}  // namespace

std::string short_number(double value) {
  if (std::isinf(value)) return "infinite";
  const double size = std::abs(value);
  const double leading = size > 0.0 ? size / std::pow(10.0, std::floor(std::log10(size))) : 0.0;
  return format_number(value, leading < 2.0 ? 4 : 3);
}

std::string safety_number(double value) {
  constexpr double most = 1000.0;  // above, the value says only that the stress is small
  return std::isfinite(value) && value > most ? "> 1000" : short_number(value);
}

std::string short_quantity(double si, const std::string& unit) {
  const std::string shown = readable(si, unit);
  return with_unit(short_number(in_unit(si, shown)), pretty_unit(shown), unbroken_space);
}

std::string short_pair(const account::Quantity& demand, const account::Quantity& capacity) {
  const std::string unit = readable(capacity.si, capacity.unit);
  return short_number(in_unit(demand.si, unit)) + " / " +
         with_unit(short_number(in_unit(capacity.si, unit)), pretty_unit(unit), unbroken_space);
}

std::string utilisation_text(double utilisation) {
  if (!std::isfinite(utilisation)) return std::isinf(utilisation) ? "infinite" : "-";
  constexpr int usual = 3, most = 9;
  if (utilisation >= 1000.0) return format_number(utilisation, 4);  // a wrong unit: 3.144e16
  std::array<char, 64> text{};
  for (int decimals = usual; decimals <= most; ++decimals) {
    std::snprintf(text.data(), text.size(), "%.*f", decimals, utilisation);
    const double shown = std::strtod(text.data(), nullptr);
    if (shown != 1.0 || std::abs(utilisation - 1.0) < 1e-9) break;
  }
  return text.data();
}

std::string spoken(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

bool is_word(std::string_view name) {
  constexpr std::size_t longest_symbol = 2;
  const formula::Symbol symbol = formula::symbol(name);
  return symbol.base.greek == nullptr && symbol.base.text.size() > longest_symbol;
}

std::string capitalised(std::string text) {
  if (!text.empty() && 'a' <= text[0] && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace loadpath::report
