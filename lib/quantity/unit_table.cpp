#include "lib/quantity/unit_table.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace loadpath {
namespace {

constexpr Prefix prefixes[] = {
    {"k", Script::latin, 'k', 3},       {"M", Script::latin, 'M', 6},     {"m", Script::latin, 'm', -3},
    {"G", Script::latin, 'G', 9},       {"c", Script::latin, 'c', -2},    {"\u00B5", Script::latin, 'u', -6},
    {"\u03BC", Script::latin, 'u', -6}, {"u", Script::latin, 'u', -6},    {"d", Script::latin, 'd', -1},
    {"da", Script::latin, 'D', 1},      {"h", Script::latin, 'h', 2},     {"n", Script::latin, 'n', -9},
    {"T", Script::latin, 'T', 12},      {"p", Script::latin, 'p', -12},   {"f", Script::latin, 'f', -15},
    {"a", Script::latin, 'a', -18},     {"z", Script::latin, 'z', -21},   {"y", Script::latin, 'y', -24},
    {"P", Script::latin, 'P', 15},      {"E", Script::latin, 'E', 18},    {"Z", Script::latin, 'Z', 21},
    {"Y", Script::latin, 'Y', 24},      {"к", Script::cyrillic, 'k', 3},  {"М", Script::cyrillic, 'M', 6},
    {"м", Script::cyrillic, 'm', -3},   {"Г", Script::cyrillic, 'G', 9},  {"с", Script::cyrillic, 'c', -2},
    {"мк", Script::cyrillic, 'u', -6},  {"д", Script::cyrillic, 'd', -1}, {"да", Script::cyrillic, 'D', 1},
    {"г", Script::cyrillic, 'h', 2},    {"н", Script::cyrillic, 'n', -9}, {"Т", Script::cyrillic, 'T', 12},
    {"п", Script::cyrillic, 'p', -12},  {"kilo", Script::word, 'k', 3},   {"mega", Script::word, 'M', 6},
    {"milli", Script::word, 'm', -3},   {"giga", Script::word, 'G', 9},   {"centi", Script::word, 'c', -2},
    {"micro", Script::word, 'u', -6},   {"deci", Script::word, 'd', -1},  {"deca", Script::word, 'D', 1},
    {"hecto", Script::word, 'h', 2},    {"nano", Script::word, 'n', -9},
};

constexpr Prefixes none{};
constexpr Prefixes only(std::string_view letters) { return {letters, false}; }
constexpr Prefixes si(std::string_view usual) { return {usual, true}; }

constexpr Dimension number{};
constexpr Dimension length = Dimension::of(1, 0, 0), mass = Dimension::of(0, 1, 0), time_ = Dimension::of(0, 0, 1);
constexpr Dimension temperature = Dimension::of(0, 0, 0, 1), angle = Dimension::of(0, 0, 0, 0, 1);
constexpr Dimension volume = length.power(3), speed = length / time_, force = mass * speed / time_;
constexpr Dimension stress = force / length.power(2), work = force * length, power = work / time_;
constexpr Dimension angular_speed = angle / time_, frequency = number / time_;

// Exact by definition: the international inch and pound, standard gravity. They are stored as integers with a power
// of ten, so that 1.5 in is 0.0381 m to the last bit.
constexpr double inch = 254, foot = 12 * inch, pound = 45359237, gravity = 980665;
constexpr double pound_force = pound * gravity, psi = pound_force / (inch * inch);
constexpr double horsepower = 550 * foot * pound_force, metric_horsepower = 75 * gravity;
constexpr double revolution = 2.0 * std::numbers::pi, degree = revolution / 360.0, minute = 60.0;

constexpr UnitRow rows[] = {
    {"m", "м", "metre|meter", 1.0, 0, length, si("mcuk")},
    {"Pa", "Па", "pascal", 1.0, 0, stress, si("MGk")},
    {"N", "Н", "newton", 1.0, 0, force, si("kMm")},
    {"g", "г", "gram|gramme", 1.0, -3, mass, si("km")},
    {"s", "с|сек", "second", 1.0, 0, time_, si("mu")},
    {"Nm", "Нм", "", 1.0, 0, work, only("kMmu"), Mark::run_together},
    {"Nmm", "Нмм", "", 1.0, -3, work, only("kM"), Mark::run_together},
    {"Ncm", "Нсм", "", 1.0, -2, work, only("k"), Mark::run_together},
    {"W", "Вт", "watt", 1.0, 0, power, si("kM"), Mark::work},
    {"J", "Дж", "joule", 1.0, 0, work, si("kM"), Mark::work},
    {"Wh", "Втч", "", 3600.0, 0, work, only("kMG"), Mark::work},
    {"Hz", "Гц", "hertz", 1.0, 0, frequency, si("kM"), Mark::hertz},
    {"rpm", "", "", revolution / minute, 0, angular_speed, none},
    {"rps", "", "", revolution, 0, angular_speed, none},
    {"deg|°|º", "град", "degree", degree, 0, angle, none},
    {"rad", "рад", "radian", 1.0, 0, angle, only("mu")},
    {"rev|r|U|tr", "об", "revolution|turn", revolution, 0, angle, none},
    {"gon", "", "", revolution / 400.0, 0, angle, none},
    {"arcmin", "", "", degree / 60.0, 0, angle, none},
    {"arcsec", "", "", degree / 3600.0, 0, angle, none},
    {"K", "К", "kelvin", 1.0, 0, temperature, si("m")},
    {"°C|ºC|\u2103|degC", "°С|ºС", "", 1.0, 0, temperature, none, Mark::scale, 273.15},
    {"°F|ºF|\u2109|degF", "", "", 5.0 / 9.0, 0, temperature, none, Mark::scale, 459.67 * 5.0 / 9.0},
    {"min", "мин|хв", "minute", minute, 0, time_, none, Mark::minute},
    {"h", "ч", "hour", 3600.0, 0, time_, none},
    {"d", "сут", "day", 86400.0, 0, time_, none},
    {"t", "т", "tonne", 1.0, 3, mass, none},
    {"bar", "бар", "", 1.0, 5, stress, only("mk")},
    {"atm", "атм", "atmosphere", 101325.0, 0, stress, none},
    {"kgf|kp", "кгс", "", gravity, -5, force, none},
    {"tf", "тс", "", gravity, -2, force, none},
    {"PS", "л.с.|л. с.|к.с.|к. с.", "", metric_horsepower, -5, power, none, Mark::work},
    {"hp", "", "horsepower", horsepower, -17, power, none, Mark::work},
    {"l|L", "л", "litre|liter", 1.0, -3, volume, only("mcdu")},
    {"cP", "", "", 1.0, -3, stress* time_, none},
    {"cSt", "сСт", "", 1.0, -6, length* speed, none},
    {"%", "", "percent", 1.0, -2, number, none},
    {"\u2030", "", "", 1.0, -3, number, none},
    {"in", "", "inch|inches", inch, -4, length, none},
    {"ft", "", "foot|feet", foot, -4, length, none},
    {"yd", "", "yard", 3 * foot, -4, length, none},
    {"mi", "", "mile", 5280 * foot, -4, length, none},
    {"mil|thou", "", "", inch, -7, length, none},
    {"mph", "", "", 5280 * foot / 3600, -4, speed, none},
    {"lb|lbm", "", "pound", pound, -8, mass, none},
    {"oz", "", "ounce", pound / 16, -8, mass, none},
    {"slug", "", "", pound_force / foot, -9, mass, none},
    {"lbf", "", "", pound_force, -13, force, none},
    {"ozf", "", "", pound_force / 16, -13, force, none},
    {"kip", "", "", pound_force, -10, force, none},
    {"psi", "", "", psi, -5, stress, none},
    {"ksi", "", "", psi, -2, stress, none},
    {"kpsi", "", "", psi, -2, stress, none},
};

/// The first eight bytes of a name as one number, in the order of the names: one comparison instead of a memcmp.
constexpr std::uint64_t key_of(std::string_view text) {
  std::uint64_t key = 0;
  for (std::size_t i = 0; i < 8; ++i) key = key << 8U | (i < text.size() ? static_cast<unsigned char>(text[i]) : 0U);
  return key;
}

struct Name {
  std::uint64_t key = 0;
  std::string_view text;
  Script script = Script::latin;
  const UnitRow* row = nullptr;
};

template <class Visit>
constexpr void each_name(const UnitRow& row, Visit visit) {
  const std::string_view scripts[] = {row.latin, row.cyrillic, row.words};
  for (std::size_t s = 0; s < 3; ++s) {
    for (std::size_t from = 0; from < scripts[s].size();) {
      const std::size_t end = std::min(scripts[s].find('|', from), scripts[s].size());
      const std::string_view text = scripts[s].substr(from, end - from);
      visit(Name{key_of(text), text, static_cast<Script>(s), &row});
      from = end + 1;
    }
  }
}

constexpr std::size_t name_count = [] {
  std::size_t count = 0;
  for (const UnitRow& row : rows) each_name(row, [&](const Name&) { ++count; });
  return count;
}();

constexpr auto names = [] {
  std::array<Name, name_count> sorted{};
  std::size_t count = 0;
  for (const UnitRow& row : rows) each_name(row, [&](const Name& name) { sorted[count++] = name; });
  std::sort(sorted.begin(), sorted.end(),
            [](const Name& a, const Name& b) { return a.key < b.key || (a.key == b.key && a.text < b.text); });
  return sorted;
}();

constexpr bool same_text(const Name& a, const Name& b) { return a.text == b.text; }
static_assert(std::adjacent_find(names.begin(), names.end(), same_text) == names.end(), "a unit name is used twice");

const Name* exactly(std::string_view text) {
  const std::uint64_t key = key_of(text);
  auto at = std::lower_bound(names.begin(), names.end(), key, [](const Name& n, std::uint64_t k) { return n.key < k; });
  while (at != names.end() && at->key == key && at->text != text) ++at;
  return at != names.end() && at->key == key ? &*at : nullptr;
}

bool is_usual(const UnitRow& row, const Prefix& prefix) {
  return row.prefixes.usual.find(prefix.letter) != std::string_view::npos;
}

bool takes(const Name& name, const Prefix& prefix) {
  return prefix.script == name.script && (name.row->prefixes.every || is_usual(*name.row, prefix));
}

}  // namespace

FoundUnit find_unit(std::string_view name) {
  if (const Name* const found = exactly(name)) return {found->row, 0, found->script};
  for (const Prefix& prefix : prefixes) {
    if (name[0] != prefix.name[0] || !name.starts_with(prefix.name)) continue;
    const Name* const found = exactly(name.substr(prefix.name.size()));
    if (found != nullptr && takes(*found, prefix)) return {found->row, prefix.ten, found->script};
  }
  if (name.size() < 4 || name.back() != 's') return {};
  const FoundUnit singular = find_unit(name.substr(0, name.size() - 1));
  return singular.script == Script::word ? singular : FoundUnit{};
}

std::vector<UnitName> all_unit_names(bool usual_only) {
  std::vector<UnitName> all;
  const auto with = [&](const Prefix& prefix, const Name& name) {
    all.push_back({std::string(prefix.name) + std::string(name.text), name.script, name.row, prefix.ten});
  };
  for (const UnitRow& row : rows) {
    each_name(row, [&](const Name& name) {
      all.push_back({std::string(name.text), name.script, &row, 0});
      for (const char letter : row.prefixes.usual)
        for (const Prefix& prefix : prefixes)
          if (prefix.letter == letter && prefix.script == name.script) with(prefix, name);
      if (usual_only || !row.prefixes.every) return;
      for (const Prefix& prefix : prefixes)
        if (prefix.script == name.script && !is_usual(row, prefix)) with(prefix, name);
    });
  }
  return all;
}

}  // namespace loadpath
