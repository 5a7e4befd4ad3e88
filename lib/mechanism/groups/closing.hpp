// The closing angle of a dyad. Its sine determines the assembly mode of the dyad, vanishes at the change point where
// its two assemblies meet, and is, apart from its sign, that of the transmission angle.
#pragma once

#include "lib/mechanism/groups/plan.hpp"
#include "lib/mechanism/model/model.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace loadpath::mechanism {

/// A dyad with two assemblies. The sine is positive if, seen along its first line:
/// - two_arms (RRR): the inner pin is to the left of the line from the first outer pin to the second.
/// - arm_and_line (RRP, or a bar with its pin in a slot): the inner pin is ahead of the bar's other pin along the
///   guide.
/// - pivots_along_line (RPR, or a slotted lever): the one pivot, or the pin in the slot, is ahead of the other along
///   the guide.
struct DyadClosing {
  enum class Kind { two_arms, arm_and_line, pivots_along_line };
  Kind kind = Kind::two_arms;
  std::size_t group = 0;              // in order of attachment
  std::size_t joint = 0;              // the inner one, by which the dyad is called
  std::size_t first = 0, second = 0;  // joints at its ends; of a slotted lever the first is the slot itself
  std::size_t line = none;            // the joint along whose direction is measured
};

std::vector<DyadClosing> dyad_closings(const Model& model, const Plan& plan);

/// Sine and cosine of the angle: between the two arms; between an arm, or the line of the pivots, and the guide's
/// normal.
struct ClosingAngle {
  double sine = 0.0;
  double cosine = 1.0;
};
ClosingAngle closing_angle(const Model& model, const DyadClosing& dyad, std::span<const Pose> poses);

/// "B_left": the side on which the dyad is, by the name of its inner joint.
std::string side_name(const Model& model, const DyadClosing& dyad, double sine);

/// The transmission angle, rad, 0 to pi/2: the acute angle between the two bars of a dyad at their pin; of a bar and a
/// slider between the bar and the normal of the guide; of a slotted lever between the arm of the pin and the slot, so
/// 90 degrees where the pin drives square to its arm. H. Alt, Werkstattstechnik 26 (1932), as surveyed by Balli and
/// Chand, Mechanism and Machine Theory 37 (2002). Its complement is the pressure angle.
double transmission_angle(const ClosingAngle& angle);

}  // namespace loadpath::mechanism
