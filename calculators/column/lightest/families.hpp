// Rows of the section tables by family, as the sections of compressed bars.
#pragma once

#include "calculators/column/member/section.hpp"
#include "lib/calculator/fields.hpp"
#include "lib/quantity/drive_units.hpp"
#include "lib/table/rows.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::column {

struct SectionRow : Section {
  static constexpr auto group = "section";
  LineDensity m = unset<LineDensity>;
  static constexpr auto fields = join(section_inputs<SectionRow>(), twisting_inputs<SectionRow>(),
                                      Fields{Field{&SectionRow::m, "m", kg_per_m, "mass per length"}.positive()});
};
using TableSection = table::Typed<SectionRow>;

/// The rows of all section tables that have a mass, lightest first. Allocates nothing once the tables are read.
const std::vector<TableSection>& sections_by_mass();

/// Beginning of the name of a row: "IPE" of "IPE 200", "W" of "W4X13".
std::string_view family_of(std::string_view name);

/// Whether the name of a row begins with this text, which ends at the end of a word or of a number: W14X90 is of "W"
/// and of "W14", not of "W1"; HSS8X8X1/4 is of "HSS8X8". Spaces in the name do not count: SHS 100x5 is of "SHS100".
bool begins_with(std::string_view name, std::string_view beginning);

/// Beginnings of the rows of a family up to their first number, without spaces, each once: W4, W5, W6 of W.
std::vector<std::string> first_sizes(std::string_view family);

/// The families of the tables, each once.
std::vector<std::string> families();

}  // namespace loadpath::column
