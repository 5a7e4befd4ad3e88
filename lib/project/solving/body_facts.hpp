// What steps of one body state about it besides its size: the torque that it transmits, its length, its ends, its
// strength. The less favourable value is that of the body, and a step with another one needs a reason.
#pragma once

#include "lib/project/project.hpp"

#include <set>
#include <string>
#include <vector>

namespace loadpath::project {

/// What a step states of its body under one name.
struct Statement {
  Step* step;
  const FieldInfo* input;             // null: it follows from other inputs
  double value;                       // of the input
  double measure;                     // by the result of that name, else the input with the factor on it
  const FieldInfo* result = nullptr;  // that the measure is of; null: of the input
};
/// What the steps of a body state under one name.
struct BodyStatements {
  std::string name;
  std::vector<Statement> all;
};
/// Of solved steps, by the names of all their facts.
std::vector<BodyStatements> statements_of_bodies(const Project& project);
/// Whether no step needs the value of another one, or each that does has a reason; of bores, whether they are one.
bool agree(const BodyStatements& stated);

/// Whether walls under pressure are compared that these steps affect: at another point they may be of one vessel, or
/// have different pressures.
bool compares_walls(const Project& project, const std::set<std::string>& affected);

/// After all steps are solved, with the sizes of their bodies: whether they must be solved again because the body has a
/// less favourable value. A bore that one step has and another has not becomes an issue.
bool hand_out_facts(Project& project, std::vector<Issue>& issues);

}  // namespace loadpath::project
