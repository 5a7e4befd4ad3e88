#include "lib/quantity/expression/relation.hpp"

#include "lib/quantity/expression/tree.hpp"

#include <algorithm>

namespace loadpath {

namespace {

Fault unknown(const std::string& path, const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return {0, path.size(), say("'{1}' is not known here", path),
          say("a function has numbers with units and the variables {1}", all)};
}

}  // namespace

Relation::Relation() = default;
Relation::~Relation() = default;
Relation::Relation(Relation&&) noexcept = default;
Relation& Relation::operator=(Relation&&) noexcept = default;

Outcome<Relation> Relation::parse(std::string_view text, Variables variables, const std::optional<Dimension>& result) {
  Relation relation;
  std::vector<std::string_view> bare;
  for (const Law::Variable& variable : variables) {
    bare.push_back(variable.name);
    relation.names_.emplace_back(variable.name);
  }
  auto parsed = expression::parse(text, bare);
  if (!parsed) return parsed.fault();
  const auto declared = [&](const std::string& path) -> Outcome<Signature> {
    const auto found = std::ranges::find(variables, path, &Law::Variable::name);
    if (found == variables.end()) return unknown(path, relation.names_);
    return Signature{found->dimension, nullptr};
  };
  const auto signature = expression::check(parsed->tree, declared);
  if (!signature) return expression::with_variables(signature.fault(), parsed->tree, bare);
  if (result && signature->dimension.without_angle() != result->without_angle()) {
    return expression::with_variables({0,
                                       text.size(),
                                       say("the function gives the kind '{1}', and '{2}' is expected",
                                           name_of(signature->dimension), name_of(*result)),
                                       {}},
                                      parsed->tree, bare);
  }
  relation.tree_ = std::make_unique<const expression::Tree>(std::move(parsed->tree));
  return relation;
}

double Relation::at(std::span<const double> variables) const {
  return expression::number(tree_->root, [&](const std::string& path) {
    return variables[static_cast<std::size_t>(std::ranges::find(names_, path) - names_.begin())];
  });
}

}  // namespace loadpath
