#include "lib/project/references/stated/columns.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/stated/dimensions.hpp"
#include "lib/quantity/format.hpp"

#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

using stated::in_few_digits;
using stated::length;

const Dimension bending_moment = Dimension::of(2, 1, -2);

/// The largest of some inputs; 0 if it has none of them.
double largest_of(const Step& step, const Project& project, std::initializer_list<const char*> keys) {
  double most = 0.0;
  for (const char* const key : keys) most = std::fmax(most, std::abs(own_value(step, project, key)));
  return most;
}

bool is_eccentricity(const std::string& name) {
  return name == "e" || name == "e_0" || name == "ecc" || has_word(name, {"eccentricity"});
}

bool is_bending_moment(const std::string& name) {
  return name == "M" || name == "M_b" || name == "M_max" || name == "M_Ed" || name == "M_d";
}

}  // namespace

std::vector<ReducedLoad> columns_stated_otherwise(const Step& step, const Project& project) {
  const Calculator& calculator = *step.input().calculator;
  if (!std::string_view(calculator.id).starts_with("column.") || project.values.unused().empty()) return {};
  if (find_field(calculator.input->fields, "P") == nullptr) return {};
  const double M = largest_of(step, project, {"M_y_1", "M_y_2", "M_z_1", "M_z_2", "M_y", "M_z"});
  const double l = own_value(step, project, "l");
  std::vector<ReducedLoad> found;
  for (const auto& [name, value] : project.values.unused()) {
    const Dimension dimension = value.signature.dimension.without_angle();
    const double si = std::abs(value.si.front());
    const bool is_off_axis = dimension == length && si > 0.0 && is_eccentricity(name) && M == 0.0 &&
                             largest_of(step, project, {"e_y", "e_z"}) == 0.0;
    const bool is_bent = dimension == bending_moment && is_bending_moment(name) && si > (1.0 + in_few_digits) * M;
    if (is_off_axis || is_bent)
      found.push_back({"P", say("values.{1} is not used by any step: include it in a load, delete it, or justify it: "
                                "because.P = \"...\"",
                                name)});
    if (dimension == length && has_word(name, {"stroke"}) && si > (1.0 + in_few_digits) * l)
      found.push_back({"l", say("values.{1} = {2} acts on no step, and l is {3}: refer to it, delete it, or justify "
                                "it: because.l = \"...\"",
                                name, format_quantity(si, "mm", 5), format_quantity(l, "mm", 5))});
  }
  return found;
}

}  // namespace loadpath::project
