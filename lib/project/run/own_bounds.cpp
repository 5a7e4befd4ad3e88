#include "lib/project/run/own_bounds.hpp"

#include "lib/project/modes.hpp"
#include "lib/project/project.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace loadpath::project {

namespace {

/// Whether a load of the step comes from a part with the key too: "press.links.rod.N" from one with a length.
bool source_has(const Reading& reading, const std::string& key, const Known& known) {
  const auto has = [&](const Expression::Reference& reference) {
    const std::string path = reference.path.substr(0, reference.path.rfind('.') + 1) + key;
    return !std::isnan(largest_magnitude(known(path)));
  };
  return std::any_of(reading.operands.begin(), reading.operands.end(), [&](const Operand& operand) {
    const auto& references = operand.expression.references();
    return operand.leaf.field->is_load && std::any_of(references.begin(), references.end(), has);
  });
}

bool holds(const BoundInfo& bound, const std::string& path, const Reading& reading, const Known& known) {
  if (!is_typed(reading, path) || (bound.spares_results && is_found(reading, path))) return false;
  return *bound.source_has == '\0' || source_has(reading, bound.source_has, known);
}

struct BoundLeaf {
  std::string path;
  Leaf leaf;
};

/// The bounded input; of a list that of each element.
std::vector<BoundLeaf> leaves_of(const BoundInfo& bound, const Evaluation& evaluation) {
  std::vector<BoundLeaf> leaves;
  const Leaf one = evaluation.inputs().leaf(bound.field);
  if (one) return {{bound.field, one}};
  for_each_leaf(evaluation.record(), [&](const std::string& path, const Leaf& leaf) {
    if (names_row(bound.field, path)) leaves.push_back({path, leaf});
  });
  return leaves;
}

}  // namespace

void add_own_bounds(const Evaluation& evaluation, const Known& known, std::vector<Neighbour>& all) {
  const Calculator& calculator = evaluation.calculator();
  for (std::size_t i = 0; i < calculator.bounds.size(); ++i) {
    const BoundInfo& bound = calculator.bounds[i];
    std::size_t element = 0;
    for (const auto& [path, leaf] : leaves_of(bound, evaluation)) {
      const BoundPlace place{i, element++};
      const double value = calculator.bound(i, evaluation.record().data.get(), place.element);
      if (!holds(bound, path, evaluation.step().input().reading, known)) continue;
      all.push_back({path,
                     leaf,
                     {{leaf.field->dimension, nullptr}, {value}},
                     say("{1}", say(bound.text)),
                     bound.is_least ? FieldRole::demand : FieldRole::capacity});
      all.back().by_size = true;  // at another point it has other neighbours
      all.back().of_bound = place;
    }
  }
}

}  // namespace loadpath::project
