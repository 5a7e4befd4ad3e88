#include "lib/formula/names.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/quantity/fit_units.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace loadpath::formula {
namespace {

struct NamedUnit {
  std::string_view name;
  std::string_view symbol;
  double si;
};
template <class Quantity>
constexpr NamedUnit row(std::string_view name, const Unit<Quantity>& unit) {
  return {name, unit.symbol, in_si(unit.one)};
}

constexpr std::array units = {
    row("deg", deg),
    row("mm", mm),
    row("m", m),
    row("mm2", mm2),
    row("mm3", mm3),
    row("mm4", mm4),
    row("kg", kg),
    row("kg_m2", kg_m2),
    row("N", N),
    row("kN", kN),
    row("N_m", N_m),
    row("MPa", MPa),
    row("GPa", GPa),
    row("deg_per_m", deg_per_m),
    row("m_per_s", m_per_s),
    row("m_per_s2", m_per_s2),
    row("rad_per_s", rad_per_s),
    row("rad_per_s2", rad_per_s2),
    row("W", W),
    row("kW", kW),
    row("rpm", rpm),
    row("N_per_mm", N_per_mm),
    row("um", um),
    row("hour", hour),
    row("kg_per_m", kg_per_m),
    row("kelvin", kelvin),
};

const NamedUnit* find(std::string_view name) {
  const auto is_named = [&](const NamedUnit& unit) {
    return unit.name.size() == name.size() && unit.name.front() == name.front() && unit.name == name;
  };
  const auto found = std::find_if(units.begin(), units.end(), is_named);
  return found == units.end() ? nullptr : &*found;
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 11> raised = {{{"⁻", "−"},
                                                                                   {"⁰", "0"},
                                                                                   {"¹", "1"},
                                                                                   {"²", "2"},
                                                                                   {"³", "3"},
                                                                                   {"⁴", "4"},
                                                                                   {"⁵", "5"},
                                                                                   {"⁶", "6"},
                                                                                   {"⁷", "7"},
                                                                                   {"⁸", "8"},
                                                                                   {"⁹", "9"}}};

}  // namespace

std::optional<double> constant(std::string_view name) {
  if (name == "pi") return pi;
  const NamedUnit* unit = find(name);
  return unit != nullptr ? std::optional(unit->si) : std::nullopt;
}

std::string_view unit_named(std::string_view name) {
  const NamedUnit* unit = find(name);
  return unit != nullptr ? unit->symbol : std::string_view{};
}

std::vector<UnitRun> unit_runs(std::string_view pretty) {
  std::vector<UnitRun> runs;
  while (!pretty.empty()) {
    const auto found =
        std::find_if(raised.begin(), raised.end(), [&](const auto& sign) { return pretty.starts_with(sign.first); });
    const bool letter = found == raised.end();
    if (runs.empty() || (letter && !runs.back().exponent.empty())) runs.emplace_back();
    letter ? runs.back().letters += pretty.front() : runs.back().exponent += found->second;
    pretty.remove_prefix(letter ? 1 : found->first.size());
  }
  return runs;
}

}  // namespace loadpath::formula
