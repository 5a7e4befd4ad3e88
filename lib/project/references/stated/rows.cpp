#include "lib/project/references/stated/rows.hpp"

#include "lib/project/references/agreement/stated_names.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/stated/dimensions.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double few_digits = 0.02;

using stated::force;
using stated::inertia;
using stated::mass;

/// Whether only more than the row has is unsafe: of a load, a mass, a moment of inertia, a share of the time.
bool is_unsafe_above(const FieldInfo& field) {
  return field.is_load || field.dimension == mass || field.dimension == inertia || std::string_view(field.key) == "q";
}

/// The symbol of a field in a row: the mass of a component is its m, the order of vanes their number.
std::string symbol_of(const FieldInfo& list, const FieldInfo& field) {
  const std::string_view key = field.key;
  if (key == "mass") return "m";
  return key == "h" && std::string_view(list.key) == "orders" ? "z" : std::string(key);
}

class RowCheck {
 public:
  RowCheck(const Step& step, const Project& project) : step_(step), project_(project) {}

  std::vector<ReducedLoad> run() {
    const Record& record = step_.input().reading.record;
    compare_step();
    for (const FieldInfo& list : record.type->fields) {
      if (list.type != FieldInfo::Type::list) continue;
      for (std::size_t i = 0; i < list.size(record.data.get()); ++i) {
        const std::string element = element_path(list, record.data.get(), i);
        if (element.starts_with(".")) compare_row(list, element.substr(1));
      }
    }
    return std::move(found_);
  }

 private:
  /// Sizes, masses and loads of the step by its name: "d_pin" next to [pin].
  void compare_step() {
    for (const FieldInfo& field : step_.input().calculator->input->fields) {
      const Dimension& dimension = field.dimension;
      const bool is_of_part = field.is_load || dimension == stated::length || dimension == mass || dimension == inertia;
      if (field.is_number() && !dimension.is_number() && is_of_part)
        compare(field.key, std::string(field.key) + "_" + step_.name(), field);
    }
  }

  void compare_row(const FieldInfo& list, const std::string& row) {
    const std::string at = std::string(list.key) + "." + row + ".";
    for (const FieldInfo& field : list.fields) {
      if (!field.is_number() && field.type != FieldInfo::Type::count) continue;
      compare(at + field.key, symbol_of(list, field) + "_" + row, field);
    }
    compare_force(at, "F_" + row);
  }

  void compare(const std::string& path, const std::string& name, const FieldInfo& field) {
    for (const auto& [stated, value] : project_.values.unused()) {
      if (stated != name || !(value.signature.dimension == field.dimension)) continue;
      const double si = std::abs(value.si.front()), own = std::abs(own_value(step_, project_, path));
      const double here = std::isnan(own) ? std::abs(magnitude_at(project_, step_.name() + "." + path)) : own;
      const bool differs = is_unsafe_above(field) ? si > (1.0 + few_digits) * here
                                                  : std::abs(si - here) > few_digits * std::fmax(si, here);
      if (!std::isnan(here) && differs) add(path, name, si, here, field.dimension, field.unit);
    }
  }

  /// The force on a mounted component, next to the resultant of its components.
  void compare_force(const std::string& at, const std::string& name) {
    for (const auto& [stated, value] : project_.values.unused()) {
      if (stated != name || !(value.signature.dimension == force)) continue;
      double square = 0.0;
      std::string last;
      for (const char* const key : {"F_x", "F_y", "F_z"}) {
        const double component = own_value(step_, project_, at + key);
        if (std::isnan(component) || component == 0.0) continue;
        square += component * component, last = at + key;
      }
      const double si = std::abs(value.si.front()), here = std::sqrt(square);
      if (si <= (1.0 + few_digits) * here || !is_mounted(at)) continue;
      add(last.empty() ? at + "F_x" : last, name, si, here, force, "N");
    }
  }

  /// A mounted component that takes no load of another step.
  [[nodiscard]] bool is_mounted(const std::string& at) const {
    const auto& records = step_.input().reading.records;
    return at.starts_with("seats") &&
           std::ranges::none_of(records, [&](const Taken& record) { return record.path == at + "load"; });
  }

  void add(const std::string& path, const std::string& name, double stated, double here, const Dimension& dimension,
           const char* unit) {
    const auto shown = [&](double si) {
      return dimension.is_number() ? format_number(si, 5) : format_quantity(si, unit, 5);
    };
    found_.push_back({path, say("values.{1} = {2} acts on no step, and this row has {3}: refer to it, delete it, or "
                                "justify it: {4} = \"...\"",
                                name, shown(stated), shown(here), because_key(path))});
  }

  const Step& step_;
  const Project& project_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> rows_stated_otherwise(const Step& step, const Project& project) {
  return RowCheck(step, project).run();
}

}  // namespace loadpath::project
