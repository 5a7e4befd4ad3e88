#include "lib/project/references/drives/products.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/quantity/gravity.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace loadpath::project {

bool is_application_factor(const std::string& path) { return path.substr(path.rfind('.') + 1).starts_with("K_A"); }

const Value* value_of_file(const Project& project, const std::string& path) {
  constexpr std::string_view prefix = "values.";
  NotedReads::note(path);
  const Value* const value = project.value(path);
  return value != nullptr || !path.starts_with(prefix) ? value : project.values.fixed(path.substr(prefix.size()));
}

namespace {

constexpr double rounding = 1e-9;

/// The expression as a function of its references.
class Probe {
 public:
  Probe(const Operand& operand, const Project& project) : operand_(operand) {
    for (const auto& reference : operand.expression.references()) {
      const bool is_of_file = reference.path.starts_with("values.") || is_application_factor(reference.path);
      const Value* const value = is_of_file ? value_of_file(project, reference.path) : nullptr;
      is_known_ = is_known_ && value != nullptr && !value->is_series();
      if (value != nullptr) values_.insert_or_assign(reference.path, *value);
    }
  }

  [[nodiscard]] bool is_known() const { return is_known_ && !values_.empty(); }
  [[nodiscard]] const std::map<std::string, Value>& values() const { return values_; }

  void set(const std::string& path, double si) { values_.at(path).si.front() = si; }

  [[nodiscard]] double result() const {
    const Value value =
        operand_.expression.evaluate([&](const std::string& path) -> const Value& { return values_.at(path); });
    return value.si.front();
  }

 private:
  const Operand& operand_;
  std::map<std::string, Value> values_;
  bool is_known_ = true;
};

/// The exponent of a value of which the result is a power; NaN if it is none.
double exponent_of(Probe probe, const std::string& path) {
  const double one = probe.result();
  probe.set(path, 2.0);
  const double two = probe.result() / one;
  probe.set(path, 4.0);
  const double exponent = std::log2(two);
  const bool is_power = std::abs(probe.result() / one - two * two) <= rounding * two * two;
  const bool is_whole = std::abs(exponent - std::round(exponent)) <= rounding;
  return is_power && is_whole ? std::round(exponent) : std::nan("");
}

/// Takes values out of sums, the last ones first, until the result is a product of the others.
bool reduce_to_product(Probe& probe, std::vector<std::string>& rest) {
  const auto is_product = [&] {
    return std::ranges::all_of(probe.values(), [&](const auto& entry) {
      return entry.second.si.front() == 0.0 || !std::isnan(exponent_of(probe, entry.first));
    });
  };
  if (is_product()) return true;
  std::vector<std::string> paths;
  for (const auto& entry : probe.values()) paths.push_back(entry.first);
  for (auto path = paths.rbegin(); path != paths.rend(); ++path) {
    if (!std::isnan(exponent_of(probe, *path))) continue;
    probe.set(*path, 0.0);
    const double left = probe.result();
    if (!std::isfinite(left) || left == 0.0) {
      probe.set(*path, 1.0);
      continue;
    }
    rest.push_back(*path);
    if (is_product()) return true;
  }
  return false;
}

}  // namespace

std::optional<Product> product_with_sizes(const Operand& operand, const Project& project) {
  constexpr double most_exponent = 8.0;
  Probe probe(operand, project);
  if (!probe.is_known()) return std::nullopt;
  std::map<std::string, Dimension> dimensions;
  for (const auto& [path, value] : probe.values()) dimensions[path] = value.signature.dimension.without_angle();
  for (const auto& [path, dimension] : dimensions) probe.set(path, 1.0);
  Product product;
  if (!reduce_to_product(probe, product.rest)) return std::nullopt;
  product.number = std::abs(probe.result());
  product.of_numbers = operand.leaf.field->dimension.without_angle();
  for (const auto& [path, dimension] : dimensions) {
    if (std::ranges::find(product.rest, path) != product.rest.end()) continue;
    const double exponent = exponent_of(probe, path);
    if (!(std::abs(exponent) <= most_exponent)) return std::nullopt;
    const int power = static_cast<int>(exponent);
    if (power == 0) continue;
    product.powers.push_back({path, power, dimension});
    product.of_numbers = product.of_numbers / dimension.power(power);
  }
  return product;
}

std::optional<Product> product_of(const Operand& operand, const Project& project) {
  auto product = product_with_sizes(operand, project);
  if (product && product->of_numbers == Dimension::of(1, 0, -2))
    product->number /= standard_gravity;
  else if (product && !product->of_numbers.is_number())
    return std::nullopt;  // a size that is a number here
  return product;
}

}  // namespace loadpath::project
