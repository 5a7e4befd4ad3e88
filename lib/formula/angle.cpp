#include "lib/formula/tree.hpp"

#include <algorithm>

namespace loadpath::formula {

namespace {

/// Whether it consists of numbers and pi: 2 pi.
bool is_constant(const Node& tree) {
  if (tree.kind == Kind::symbol) return tree.text == "pi";
  return tree.kind != Kind::call && tree.kind != Kind::choose &&
         std::all_of(tree.kids.begin(), tree.kids.end(), is_constant);
}

bool is_inverse(const std::string& function) { return function == "asin" || function == "acos" || function == "atan"; }

bool keeps_kind(const std::string& function) { return function == "abs" || function == "min" || function == "max"; }

}  // namespace

bool is_angle(const Node& tree, const std::function<bool(std::string_view)>& known) {
  const auto angle = [&](const Node& kid) { return is_angle(kid, known); };
  const auto& kids = tree.kids;
  switch (tree.kind) {
    case Kind::number:
      return false;
    case Kind::symbol:
      return known(tree.text);
    case Kind::negate:
      return angle(kids[0]);
    case Kind::call:
      return is_inverse(tree.text) || (keeps_kind(tree.text) && std::all_of(kids.begin(), kids.end(), angle));
    case Kind::choose:
      return angle(kids[1]) && angle(kids[2]);
    case Kind::binary:
      break;
  }
  const bool first = angle(kids[0]), second = angle(kids[1]);
  if (tree.text == "+" || tree.text == "-")
    return (first && (second || is_constant(kids[1]))) || (second && is_constant(kids[0]));
  if (tree.text == "*") return (first && is_constant(kids[1])) || (second && is_constant(kids[0]));
  return tree.text == "/" && first && is_constant(kids[1]);
}

}  // namespace loadpath::formula
