// A mechanism solved again with other numbers, for the requested results: most points of a sweep.
//
// Covers the ordinary case: one crank drives a chain of dyads without springs and friction, its loads stay as they
// are, the mechanism keeps clear of its change points, and the verdicts are those of the mechanism that was solved in
// full. Other cases are left to the full solution. Results have the same bits in both cases.
#pragma once

#include "calculators/mechanism/results/solved.hpp"
#include "lib/account/account.hpp"

#include <memory>
#include <set>
#include <string>

namespace loadpath::planar {

class Ordinary {
 public:
  /// For a mechanism that was solved in full, with this account; null if it, or the path of a requested result, goes
  /// beyond the ordinary case.
  static std::unique_ptr<Ordinary> of(const Solved& solved, const account::Account& account,
                                      const std::set<std::string>& asked);
  ~Ordinary();

  /// Fills the requested results, and the modes; false, with the account as it was, where this mechanism is not an
  /// ordinary one. Its links, joints and drives are those of the one before.
  bool solve(const Mechanism::Input& in, const mechanism::Model& model, Axis& axis, account::Account& account);

 private:
  struct Parts;
  explicit Ordinary(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace loadpath::planar
