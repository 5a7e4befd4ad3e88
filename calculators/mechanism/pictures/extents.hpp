// Extents of the drawing of a moving mechanism over every position.
#pragma once

#include "calculators/mechanism/cycle/cycle.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <vector>

namespace loadpath::planar {

/// How far a pin goes along its guide or slot, or a contact along a flat face: from its own point, m.
struct Stroke {
  double from = 0.0, to = 0.0;
};
struct Extents {
  std::vector<Stroke> strokes;               // strokes of every joint; of joints without a line empty
  std::vector<bool> loads_push, loads_turn;  // somewhere in the cycle
};
Extents extents_of(const mechanism::Model& model, const Cycle& cycle);

/// Whether a pin of the joint goes along a line, a guide or slot.
bool has_line(mechanism::JointKind kind);
/// Whether it is a flat face on a cam.
bool has_face(const mechanism::Joint& joint);
/// The direction of that face, global.
mechanism::Vec face_of(const mechanism::Joint& joint, const mechanism::Position& at);

}  // namespace loadpath::planar
