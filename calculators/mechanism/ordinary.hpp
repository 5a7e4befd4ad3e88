// A mechanism solved again with other numbers, for the results that somebody asks for: most points of a sweep.
//
// It knows the ordinary course of things: one crank drives a chain of dyads without springs and friction, its loads
// stay as they are, the mechanism keeps clear of its change points, and the verdicts are those of the mechanism that
// was solved whole. What is otherwise is left to be solved whole. Results have the same bits either way.
#pragma once

#include "calculators/mechanism/results/solved.hpp"
#include "lib/account/account.hpp"

#include <memory>
#include <set>
#include <string>

namespace loadpath::planar {

class Ordinary {
 public:
  /// Of a mechanism that was solved whole, with this account; null where it, or a path of what is asked for, goes
  /// beyond what is ordinary.
  static std::unique_ptr<Ordinary> of(const Solved& solved, const account::Account& account,
                                      const std::set<std::string>& asked);
  ~Ordinary();

  /// Fills the results that are asked for, and the modes; false, with the account as it was, where this mechanism is
  /// not an ordinary one. Its links, joints and drives are those of the one before.
  bool solve(const Mechanism::Input& in, const mechanism::Model& model, Axis& axis, account::Account& account);

 private:
  struct Parts;
  explicit Ordinary(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace loadpath::planar
