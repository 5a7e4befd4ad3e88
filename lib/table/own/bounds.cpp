// References for checking the rows of a project: the rows themselves, the built-in row that they replace, their
// group.
#include "lib/calculator/strength_bounds.hpp"
#include "lib/quantity/format.hpp"
#include "lib/table/library.hpp"
#include "lib/table/own/own.hpp"
#include "lib/table/search.hpp"
#include "lib/table/section_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace loadpath::table {

namespace {

constexpr double rounding_of_rows = 1.005;
constexpr double beyond_group = 1.5;  // over the largest, or below the least, of the rows of a group
constexpr double beyond_twins = 1.3;  // over the largest of the rows of one kind and size: ratings of other makers
constexpr double below_twins = 2.0;   // below the least of these: not a fault of units
constexpr double MPa = 1e6;

/// Integer powers of a dimension; none for temperatures and angles.
struct Powers {
  int length, mass, time;
  bool is_whole;
};

Powers powers_of(const Dimension& dimension) {
  const auto& t = dimension.twelfths;
  const auto whole = [](int twelfths) { return twelfths % Dimension::one == 0; };
  return {t[0] / Dimension::one, t[1] / Dimension::one, t[2] / Dimension::one,
          whole(t[0]) && whole(t[1]) && whole(t[2]) && t[3] == 0 && t[4] == 0};
}

/// Whether more of it is a stronger part: stress, force; of sections and chains areas and moments of area.
bool is_strength(const Dimension& dimension, std::string_view group) {
  const Powers p = powers_of(dimension);
  if (!p.is_whole) return false;
  const bool is_area = p.mass == 0 && p.time == 0 && p.length >= 2;
  return (p.mass == 1 && p.time == -2) || (is_area && (group == "section" || group == "chain"));
}

/// The characteristic length of a group's rows: the values of a chain grow with its pitch.
std::string_view size_of_group(std::string_view group) {
  if (group == "chain") return "p";
  if (group == "key") return "b";
  if (group == "set_screw") return "d_s";
  if (group == "bearing") return "D";
  return group == "circlip" || group == "spline" ? "d_1" : "";
}

/// Detaching speed of a retaining ring. A smaller value is not an error.
bool is_speed(const Dimension& dimension) {
  const Powers p = powers_of(dimension.without_angle());
  return p.is_whole && p.length == 0 && p.mass == 0 && p.time == -1;
}

/// The power of that length with which a value grows: 2 for areas, forces and masses per length; speeds fall.
std::optional<int> growth_of(const Dimension& dimension) {
  if (is_speed(dimension)) return -1;
  const Powers p = powers_of(dimension);
  if (!p.is_whole) return std::nullopt;
  if (p.mass == 0 && p.time == 0 && p.length > 0) return p.length;
  const bool is_force = p.mass == 1 && p.length == 1 && p.time == -2;
  const bool is_line_density = p.mass == 1 && p.length == -1 && p.time == 0;
  return is_force || is_line_density ? std::optional(2) : std::nullopt;
}

std::vector<double> sizes_in(const Row& row) {
  std::vector<double> sizes{no_size};
  for (const Step& step : row.by_size) sizes.push_back(step.size_max);
  return sizes;
}

double value_at(const Entry& row, std::string_view key, double size) {
  const auto found = property(row, key, size);
  return found ? found->si : no_size;
}

struct Span {
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
};

/// The families of materials whose strength ends far below that of steels, by a word of their kinds.
constexpr std::array<std::string_view, 5> families{"aluminium", "copper", "grey iron", "ductile iron", "titanium"};

/// The family of a row by its kind, or by its modulus that of light metals; empty for steels and unknown materials.
std::string_view family_of(const Row& row) {
  constexpr double most_of_light_metals = 80e9;  // Pa
  const auto has = [&](std::string_view word) { return row.kind.find(word) != std::string::npos; };
  if (has("bronze") || has("brass")) return "copper";
  const auto found = std::ranges::find_if(families, has);
  if (found != families.end()) return *found;
  return searched_value(row, "E") < most_of_light_metals ? "aluminium" : "";
}

/// The largest strength, at any size, that the built-in materials of a family have.
double strongest(std::string_view group, std::string_view key, std::string_view family) {
  double most = 0.0;
  for (const Table* table : tables_of(group)) {
    for (const Row& row : table->rows) {
      if (!family.empty() && family_of(row) != family) continue;
      for (const double size : sizes_in(row)) most = std::fmax(most, value_at({table, &row}, key, size));
    }
  }
  return most;
}

/// The range of the built-in rows, over the power of their size.
Span span_of(std::string_view group, std::string_view key, std::string_view size, int power) {
  Span span;
  for (const Table* table : tables_of(group)) {
    for (const Row& row : table->rows) {
      const double ratio = searched_value(row, key) / std::pow(searched_value(row, size), power);
      if (!(ratio > 0.0)) continue;
      span.least = std::min(span.least, ratio), span.most = std::max(span.most, ratio);
    }
  }
  return span;
}

/// Whether a built-in row is of the same kind, bore, outside diameter and width: a bearing of another maker.
bool is_twin(const Row& row, const Row& own) {
  constexpr double same = 1e-3;
  return row.kind == own.kind && std::ranges::all_of(std::array{"d", "D", "B"}, [&](const char* key) {
           const double here = searched_value(own, key), there = searched_value(row, key);
           return std::abs(there - here) <= same * here;
         });
}

/// The range of the built-in rows of the same kind and size; empty if there are none.
Span span_of_twins(std::string_view group, std::string_view key, const Row& own) {
  Span span;
  for (const Table* table : tables_of(group)) {
    for (const Row& row : table->rows) {
      const double value = searched_value(row, key);
      if (!(value > 0.0) || !is_twin(row, own)) continue;
      span.least = std::min(span.least, value), span.most = std::max(span.most, value);
    }
  }
  return span;
}

}  // namespace

void OwnReader::check_bounds(const Row& row, const Table& table, const Place& place, const std::string& key) {
  const RowRead read{row, table, place, key};
  std::vector<std::string> used;
  check_strengths(read, used);
  check_moduli(read, used);
  check_shape(read);
  check_replaced(read, used);
  check_group(read, used);
  for (const auto& [column, reason] : row.because) {
    if (std::find(used.begin(), used.end(), column) != used.end()) continue;
    std::string at = key;
    at.append(".because.").append(column);
    complain(place, at, say("because.{1} of '{2}' is not needed", column, row.name), say("leave it out"));
  }
}

/// The yield strength is not above the tensile strength, and no strength far above that of its family.
void OwnReader::check_strengths(const RowRead& read, std::vector<std::string>& used) {
  if (read.table.column("R_e") == nullptr || read.table.column("R_m") == nullptr) return;
  const Entry entry{&read.table, &read.row};
  for (const double size : sizes_in(read.row)) {
    const double R_e = value_at(entry, "R_e", size), R_m = value_at(entry, "R_m", size);
    if (!(R_e > R_m)) continue;
    const char* const unit = "MPa";
    return complain(read.place, read.key + ".R_e",
                    say("R_e = {1} of '{2}' is above its R_m = {3}", format_quantity(R_e, unit, 5), read.row.name,
                        format_quantity(R_m, unit, 5)),
                    say("yield strength cannot exceed tensile strength: check both"));
  }
  for (const char* const key : {"R_e", "R_m"}) check_strength(read, key, used);
}

void OwnReader::check_strength(const RowRead& read, const char* key, std::vector<std::string>& used) {
  const Entry entry{&read.table, &read.row};
  const std::string_view family = family_of(read.row);
  const double of_tables = strongest(read.table.group, key, family);
  const double customary = MPa * (std::string_view(key) == "R_e" ? most_yield_strength : most_tensile_strength);
  const double most = family.empty() || of_tables == 0.0 ? std::fmax(of_tables, customary)
                                                         : std::fmin(beyond_group * of_tables, customary);
  double own = no_size;
  for (const double size : sizes_in(read.row)) own = std::fmax(own, value_at(entry, key, size));
  if (!(own > most) || std::find(used.begin(), used.end(), key) != used.end()) return;
  used.emplace_back(key);
  if (read.row.because.contains(key)) return;
  complain(read.place, read.key + "." + key,
           say("{1} = {2} of '{3}' is above what {4} usually have: {5}", key, format_quantity(own, "MPa", 5),
               read.row.name, family.empty() ? say("steels") : say("materials of this kind ({1})", std::string(family)),
               format_quantity(most, "MPa", 4)),
           say("check the unit, or justify it: because.{1} = \"data sheet of the manufacturer\"", key));
}

void OwnReader::check_shape(const RowRead& read) {
  if (read.table.group != "section") return;
  const auto of = [&](const char* column) { return searched_value(read.row, column); };
  const SectionShape shape{of("h"),   of("b"),       of("d"),     of("t_f"), of("t_w"), of("A"),      of("I_y"),
                           of("I_z"), read.row.kind, of("I_min"), of("I_t"), of("I_w"), of("W_pl_y"), of("W_pl_z")};
  if (const auto misfit = inconsistency_of(shape))
    complain(read.place, read.key + "." + misfit->key, say("'{1}': {2}", read.row.name, misfit->message),
             say("check the units: mm, cm^2, cm^4"));
}

/// A row in the place of a built-in one is not stronger without a reason.
void OwnReader::check_replaced(const RowRead& read, std::vector<std::string>& used) {
  std::vector<std::string> names = read.row.aliases;
  names.push_back(read.row.name);
  for (const std::string& name : names) {
    const auto replaced = table::find_row(read.table.group, name);
    if (replaced) compare_with(read, *replaced, rounding_of_rows, used);
  }
  check_namesake(read, used);
}

/// A row "C45E forged" is of the built-in steel: another treatment is not that much stronger.
void OwnReader::check_namesake(const RowRead& read, std::vector<std::string>& used) {
  const std::size_t end = read.row.name.find_first_of(" +-,(/");
  if (end == std::string::npos || read.table.group != "material") return;
  const auto namesake = table::find_row(read.table.group, read.row.name.substr(0, end));
  if (namesake) compare_with(read, *namesake, beyond_group, used);
}

/// Of a steel both moduli are known; E/G of any isotropic material is 2(1 + nu), and nu lies between 0 and 0.5.
void OwnReader::check_moduli(const RowRead& read, std::vector<std::string>& used) {
  constexpr double GPa = 1e9, most_E = 230.0 * GPa, most_G = 90.0 * GPa;
  constexpr double least_E_of_steel = 185.0 * GPa, least_G_of_steel = 70.0 * GPa;
  if (read.table.group != "material") return;
  const bool is_steel = read.row.kind.ends_with("steel");
  const double E = searched_value(read.row, "E");
  check_modulus(read, "E", is_steel ? least_E_of_steel : 0.0, most_E, used);
  check_modulus(read, "G", is_steel ? least_G_of_steel : 0.0, most_G, used);
  if (!std::isnan(E)) check_modulus(read, "G", E / 3.0, E / 2.0, used);
  check_density(read, E, used);
  check_contraction(read, E / searched_value(read.row, "G") / 2.0 - 1.0, used);
}

/// Poisson's ratio of an isotropic material is that of its moduli.
void OwnReader::check_contraction(const RowRead& read, double of_moduli, std::vector<std::string>& used) {
  constexpr double rounded = 0.06;  // of moduli with two digits
  const double nu = searched_value(read.row, "nu");
  if (!(std::abs(nu - of_moduli) > rounded) || std::find(used.begin(), used.end(), "nu") != used.end()) return;
  used.emplace_back("nu");
  if (read.row.because.contains("nu")) return;
  complain(read.place, read.key + ".nu",
           say("nu = {1} of '{2}' is not E/(2 G) - 1 = {3}", format_number(nu, 3), read.row.name,
               format_number(of_moduli, 3)),
           say("check E, G and nu, or justify it: because.nu = \"data sheet of the manufacturer\""));
}

/// No metal is that light for its modulus; steel, aluminium and titanium have E/rho of 2.5e7 to 2.7e7 m^2/s^2.
void OwnReader::check_density(const RowRead& read, double E, std::vector<std::string>& used) {
  constexpr double most = 4e7;  // m^2/s^2
  const double rho = searched_value(read.row, "rho");
  if (!(E > most * rho) || std::find(used.begin(), used.end(), "rho") != used.end()) return;
  used.emplace_back("rho");
  if (read.row.because.contains("rho")) return;
  complain(read.place, read.key + ".rho",
           say("rho = {1} of '{2}' is too low for a metal of E = {3}", format_quantity(rho, "kg/m^3", 4), read.row.name,
               format_quantity(E, "GPa", 4)),
           say("check the unit, or justify it: because.rho = \"data sheet of the manufacturer\""));
}

void OwnReader::check_modulus(const RowRead& read, const char* key, double low, double high,
                              std::vector<std::string>& used) {
  const double own = searched_value(read.row, key);
  if (std::isnan(own) || (own >= low && own <= high)) return;
  if (std::find(used.begin(), used.end(), key) != used.end()) return;
  used.emplace_back(key);
  if (read.row.because.contains(key)) return;
  complain(read.place, read.key + "." + key,
           say("{1} = {2} of '{3}' is not that of {4}: {5} to {6}", key, format_quantity(own, "GPa", 4), read.row.name,
               read.row.kind.ends_with("steel") ? "steel" : "an isotropic metal", format_quantity(low, "GPa", 3),
               format_quantity(high, "GPa", 3)),
           say("check the unit, or justify it: because.{1} = \"data sheet of the manufacturer\"", key));
}

void OwnReader::compare_with(const RowRead& read, const Entry& replaced, double most, std::vector<std::string>& used) {
  const Entry own{&read.table, &read.row};
  for (const Column& column : replaced.table->columns) {
    if (!is_strength(column.dimension, read.table.group) || read.table.column(column.key) == nullptr) continue;
    std::vector<double> sizes = sizes_in(*replaced.row);
    const auto more = sizes_in(read.row);
    sizes.insert(sizes.end(), more.begin(), more.end());
    const auto stronger = [&](double size) {
      return value_at(own, column.key, size) > most * value_at(replaced, column.key, size);
    };
    const auto found = std::find_if(sizes.begin(), sizes.end(), stronger);
    if (found == sizes.end()) continue;
    if (std::find(used.begin(), used.end(), column.key) != used.end()) continue;
    used.push_back(column.key);
    if (read.row.because.contains(column.key)) continue;
    complain(read.place, read.key + "." + column.key,
             say("{1} = {2} of '{3}' is above the {4} of the built-in row {5}", column.key,
                 format_quantity(value_at(own, column.key, *found), column.unit, 5), read.row.name,
                 format_quantity(value_at(replaced, column.key, *found), column.unit, 5),
                 most > rounding_of_rows ? say("'{1}'", replaced.row->name) : say("that it replaces")),
             say("give the reason, because.{1} = \"certificate 4711\", or give the row another name", column.key));
  }
}

/// A row of a group that is alike in all sizes lies near the others.
void OwnReader::check_group(const RowRead& read, std::vector<std::string>& used) {
  const std::string_view size = size_of_group(read.table.group);
  const double own_size = size.empty() ? no_size : searched_value(read.row, size);
  if (std::isnan(own_size)) return;
  for (const Value& value : read.row.values) {
    const Column& column = *read.table.column(value.key);
    const auto power = growth_of(column.dimension);
    if (!power || value.key == size) continue;
    const Span twins = span_of_twins(read.table.group, value.key, read.row);
    const bool has_twins = twins.most > 0.0;
    const Span span = has_twins ? twins : span_of(read.table.group, value.key, size, *power);
    const double scale = has_twins ? 1.0 : std::pow(own_size, *power);
    const bool may_be_less = is_speed(column.dimension);
    const double beyond = has_twins && !may_be_less ? beyond_twins : beyond_group;
    const double least = may_be_less ? 0.0 : span.least / (has_twins ? below_twins : beyond_group) * scale;
    const double most = span.most * beyond * scale;
    if (!(span.most > 0.0) || (value.si >= least && value.si <= most)) continue;
    if (std::find(used.begin(), used.end(), value.key) == used.end()) used.push_back(value.key);
    if (read.row.because.contains(value.key)) continue;
    complain(
        read.place, read.key + "." + value.key,
        say("{1} = {2} of '{3}' is far from what a {4} of its size has: {5} to {6}", value.key,
            format_quantity(value.si, column.unit, 5), read.row.name, read.table.group,
            format_quantity(span.least * scale, column.unit, 3), format_quantity(span.most * scale, column.unit, 3)),
        say("check the unit, or justify it: because.{1} = \"data sheet of the manufacturer\"", value.key));
  }
}

}  // namespace loadpath::table
