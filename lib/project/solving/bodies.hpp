// Steps that describe one physical part, body = "crankshaft": it has one size, the largest that they require, and all
// of them are assessed at it.
#pragma once

#include "lib/project/project.hpp"

#include <map>
#include <string>
#include <vector>

namespace loadpath::project {

/// The steps of each body.
std::map<std::string, std::vector<Step*>> bodies_of(const Project& project);

/// When the project is read: issues for bodies that only one step names, and for steps without a common size.
void check_bodies(const Project& project, std::vector<Issue>& issues);

/// A size of a body, and the values of its steps for it.
struct SharedSize {
  struct Of {
    Step* step;
    double si;
    bool is_given;
  };
  std::string body, key;
  std::vector<Of> of;
};
/// Of solved steps; a size that fewer than two of them have is left out.
std::vector<SharedSize> shared_sizes(const Project& project);
/// Whether two steps have the same size.
bool is_one_size(double a, double b);

/// After all steps are solved: whether a search must be repeated because the body requires another size.
/// Contradicting sizes become issues.
bool hand_out_sizes(Project& project, std::vector<Issue>& issues);

}  // namespace loadpath::project
