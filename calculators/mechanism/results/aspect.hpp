// One side of a mechanism that a project can ask about: drives, losses, accuracy, counterweights, hodographs...
//
// An aspect is one source, which says here what it reads, adds, finds, tables, draws and needs, its name below and a
// row in calculators/mechanism/aspects.cpp. The step goes through the rows and names none of them. Functions that an
// aspect does not have are null.
#pragma once

#include "calculators/mechanism/input/names.hpp"
#include "calculators/mechanism/results/output.hpp"
#include "calculators/mechanism/results/results.hpp"
#include "calculators/mechanism/results/solved.hpp"
#include "lib/account/account.hpp"

#include <span>
#include <vector>

namespace loadpath::planar {

/// A key of tables/sources.toml that a mechanism cites only where it uses it.
struct Citation {
  const char* key;
  bool (*used)(const Mechanism::Input& in, const mechanism::Structure& structure);
};

struct Aspect {
  // When the file is read: what is wrong with its part of the input.
  void (*check_names)(NameFaults& faults) = nullptr;  // needs no values
  void (*check_values)(const Mechanism::Input& in, const mechanism::Model& model,
                       std::vector<FieldFault>& faults) = nullptr;
  /// Limits of the aspect for overconstrained joints.
  void (*check_structure)(const Mechanism::Input& in, const mechanism::Model& model,
                          const mechanism::Structure& structure, std::vector<FieldFault>& faults) = nullptr;
  // Its results: as they are documented, and those of a mechanism. The model must outlive nothing.
  void (*list)(std::vector<ResultPattern>& patterns) = nullptr;
  void (*add_outputs)(const Mechanism::Input& in, const mechanism::Model& model, std::vector<Output>& out) = nullptr;
  // When the positions are solved: what it finds for its own results and tables, and its verdicts.
  void (*find)(const Solved& solved, Findings& found) = nullptr;
  /// Without `find`, an aspect is called at most points of a sweep too (Ordinary): with forces and closing only, for
  /// poses, pins and kinematics may be missing there.
  void (*judge)(const Solved& solved, std::vector<account::Verdict>& verdicts) = nullptr;
  // In a report: tables of what is given and of what is found, notes of what is missing, figures.
  void (*show_input)(const Mechanism::Input& in, std::vector<account::Block>& blocks) = nullptr;
  void (*show)(const Solved& solved, const Results& results, std::vector<account::Block>& blocks) = nullptr;
  void (*draw)(const Solved& solved, const Results& results, std::vector<figure::Figure>& figures) = nullptr;
  std::span<const Citation> citations = {};
  /// Its results follow only from forces, efforts and velocities, and depend on no number of the model.
  bool reads_forces_alone = false;
};

namespace aspects {

// Each is defined in a source of its own.
extern const Aspect drawn, masses, details, closing, equilibrium, contact, courses, drives, drive_wheels, reactions,
    pins, shafts, places, members, contacts, cams, machine, springs, cylinders, kinematics, transmission, equations,
    extremes, power, rest, efficiency, flanks, structure, redundancy, resolution, changes_of_assembly, motion,
    influence, accuracy, balance, figures, hodographs;

}  // namespace aspects

/// Puts the tables or notes of an aspect behind those that are there.
template <class Blocks>
void append(Blocks&& more, std::vector<account::Block>& blocks) {
  for (auto& block : more) blocks.emplace_back(std::move(block));
}

}  // namespace loadpath::planar
