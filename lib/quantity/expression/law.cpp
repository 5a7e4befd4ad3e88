#include "lib/quantity/expression/law.hpp"

#include "lib/quantity/expression/tree.hpp"

#include <string>

namespace loadpath {

namespace {

using expression::Node;
using expression::Operation;

/// The first function in a tree that has kinks, or none that could be differentiated.
const Node* find_kink(const Node& node) {
  const bool reduces = node.operation == Operation::call && node.function->jet == nullptr;
  if (reduces && node.function->jet_of_two == nullptr) return &node;
  for (const Node& kid : node.kids) {
    if (const Node* const kink = find_kink(kid)) return kink;
  }
  return nullptr;
}

Jet value_of(const Node& node, const Jet& variable) {
  const auto kid = [&](std::size_t k) { return value_of(node.kids[k], variable); };
  switch (node.operation) {
    case Operation::literal:
      return {node.si};
    case Operation::reference:
      return variable;
    case Operation::negate:
      return -kid(0);
    case Operation::add:
      return kid(0) + kid(1);
    case Operation::subtract:
      return kid(0) - kid(1);
    case Operation::multiply:
      return kid(0) * kid(1);
    case Operation::divide:
      return kid(0) / kid(1);
    case Operation::power:
      return pow(kid(0), kid(1).value);  // the check has made sure that the exponent is constant
    case Operation::call:
      return node.function->jet != nullptr ? node.function->jet(kid(0)) : node.function->jet_of_two(kid(0), kid(1));
  }
  return {};
}

}  // namespace

Law::Law() = default;
Law::~Law() = default;
Law::Law(Law&&) noexcept = default;
Law& Law::operator=(Law&&) noexcept = default;

Outcome<Law> Law::parse(std::string_view text, const Variable& variable, const Dimension& result) {
  auto parsed = expression::parse(text, variable.name);
  if (!parsed) return parsed.fault();
  const std::string name(variable.name);
  const auto declared = [&](const std::string& path) -> Outcome<Signature> {
    if (path == name) return Signature{variable.dimension, nullptr};
    return Fault{0, path.size(), say("'{1}' is not known here", path),
                 say("a law has numbers with units and the variable {1}", name)};
  };
  if (const Node* const kink = find_kink(parsed->tree.root)) {
    return Fault{kink->at, kink->length, say("'{1}' has kinks, or is of a series", kink->function->name),
                 say("a law of motion must be smooth: its speed and acceleration come from it")};
  }
  const auto signature = expression::check(parsed->tree, declared);
  if (!signature) return signature.fault();
  if (signature->dimension.without_angle() != result.without_angle()) {
    return Fault{
        0, text.size(),
        say("the law gives the kind '{1}', and '{2}' is expected", name_of(signature->dimension), name_of(result)),
        say("give its numbers their units")};
  }
  Law law;
  law.tree_ = std::make_unique<const expression::Tree>(std::move(parsed->tree));
  return law;
}

Jet Law::at(double variable) const { return value_of(tree_->root, {variable, 1.0, 0.0}); }

}  // namespace loadpath
