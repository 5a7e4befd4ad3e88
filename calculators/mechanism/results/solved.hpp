// A mechanism with all its positions solved.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/cycle/kinematics.hpp"
#include "lib/mechanism/structure/structure.hpp"

#include <any>
#include <map>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

namespace loadpath::planar {

/// Findings of aspects for their own results and tables: one of each type.
class Findings {
 public:
  template <class Found>
  void add(Found found) {
    all_.insert_or_assign(typeid(Found), std::move(found));
  }
  /// It has been added.
  template <class Found>
  [[nodiscard]] const Found& of() const {
    return *std::any_cast<Found>(&all_.at(typeid(Found)));
  }

 private:
  std::map<std::type_index, std::any> all_;
};

struct Solved {
  const std::string& step;  // its name
  const Mechanism::Input& in;
  const mechanism::Structure& structure;
  const mechanism::Model& given;
  const mechanism::Model& model;  // without what joints hold too much
  const Cycle& proved;            // cycle of the given model, with every reaction
  const Cycle& cycle;             // without reactions that are not unique
  const Kinematics& kinematics;
  const Axis* axis;  // null: one position
  Findings found = {};
  bool in_words = true;  // else texts that take time may be shorter
  /// The values of each output over the positions, to be taken, where these are not filled; null: they are.
  std::vector<std::vector<double>>* values = nullptr;
};

}  // namespace loadpath::planar
