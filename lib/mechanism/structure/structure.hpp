// Whether a model can be solved: its numbers, its connectivity, its mobility by count and by rank, its redundancies.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/text/issue.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace loadpath::mechanism {

/// An obstacle to solving a model, and the part of it concerned.
struct Finding {
  enum class About { model, link, joint, driver, load, spring };
  About about = About::model;
  std::size_t index = 0;
  Message message;
  Message hint;
};

/// The part of `diagnose` that needs no geometry: numbers, references, connections.
std::vector<Finding> check_parts(const Model& model);

/// Wheels whose centre distance differs from that required by their radii.
struct CentreDistanceError {
  std::size_t joint = 0;
  double apart = 0.0, needed = 0.0;  // m; of a belt the least distance, of a rack that of its line
};

/// Mobility and rank at the assembly nearest to the stated poses. The model has passed `check_parts`.
struct Structure {
  int mobility_by_count = 0;  // 3 n - 2 p5 - p4
  int mobility = 0;           // by rank; the drivers do not count
  bool closes = false;
  std::size_t open_joint = 0;  // when it does not close: the widest
  double gap = 0.0;            // m
  bool singular = false;       // the rank is lower here than nearby: a dead point or a change point
  /// Sets of joints that share one constraint too many, whichever of them is blamed; their reactions are not unique.
  std::vector<std::vector<std::size_t>> redundant;
  /// Misfits of gears and belts, whose joint does not fix its centres.
  std::vector<CentreDistanceError> misfits;
  /// Gears, racks and belts whose centre distance changes as the mechanism moves.
  std::vector<std::size_t> parting;
  /// Links that can move with all drivers fixed.
  std::vector<std::size_t> loose;
};
Structure analyse(const Model& model);

/// Empty if the model can be solved at its stated assembly. Mobility 0 without drivers is legal: statics. So are
/// redundant joints, if they can be released and no friction depends on a reaction that is not unique.
std::vector<Finding> diagnose(const Model& model);
/// Gives the structure too; it is empty if the model has not passed `check_parts`.
std::vector<Finding> diagnose(const Model& model, Structure& structure);

/// The sets of `redundant`, each once, with how many freedoms too many they hold.
struct SharedFreedoms {
  std::vector<std::size_t> joints;
  std::size_t freedoms = 0;
};
std::vector<SharedFreedoms> shared_freedoms(const Structure& structure);
/// "the joints 'A', 'B' together constrain one degree of freedom too many"
Message too_many(const Model& model, const std::vector<std::size_t>& joints, std::size_t freedoms);

inline std::string link_name(const Model& model, int link) {
  return link == ground ? "ground" : model.links[static_cast<std::size_t>(link)].name;
}
/// "'crank', 'rod'".
template <class Parts>
std::string names_of(const Parts& parts, const std::vector<std::size_t>& chosen) {
  std::string text;
  for (const auto k : chosen) text += (text.empty() ? "'" : ", '") + parts[k].name + "'";
  return text;
}

}  // namespace loadpath::mechanism
