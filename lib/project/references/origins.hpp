// Values that are taken from another part, or from another state of it, than the value next to them.
#pragma once

#include "lib/project/project.hpp"

#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

/// Inputs that need a reason: a fatigue limit of another material or size, or above the limit that it is computed from;
/// a component of a force, a part of a stress, and the force of a guide for a pin; the torque of a connection below
/// that of the shaft which its diameter comes from; a ratio of speeds that is not the ratio which it refers to; a belt
/// that reverses where the train does not. The steps that it refers to are solved.
std::vector<ReducedLoad> values_of_others(const Step& step, const Project& project);

/// Whether such a comparison is of numbers that may vary: at another point of a sweep it may end otherwise.
bool compares_numbers(const Step& step, const Project& project);

/// While it lives, notes the paths that comparisons of this thread read: "shaft.T", "values.F". A sweep that varies
/// none of them need not compare again.
class NotedReads {
 public:
  NotedReads();
  ~NotedReads();
  NotedReads(const NotedReads&) = delete;
  NotedReads& operator=(const NotedReads&) = delete;

  [[nodiscard]] const std::set<std::string>& paths() const { return paths_; }
  static void note(const std::string& path);

 private:
  std::set<std::string> paths_;
};

/// Whether a value differs from another one by at most this share of it; not if one of them is not known.
inline bool is_near(double value, double other, double share) { return std::abs(value - other) <= share * other; }

/// The calculator of a step: "shaft.design".
inline std::string_view id_of(const Step& step) { return step.input().calculator->id; }

/// How a reason for an input is written in a file: "because.F", because."seats[2].J".
std::string because_key(const std::string& path);

/// The value of largest magnitude at a path of a solved step; NaN if there is none.
double magnitude_at(const Project& project, const std::string& path);
/// That of an input before its step is solved; NaN if it is not known.
double own_value(const Step& step, const Project& project, const std::string& path);
/// Whether an input is the axial force of a bar that may buckle.
bool is_compression_of_bar(const FieldInfo& field);
/// Whether a step is a connection of one of several outputs of a shaft: another one carries its full torque, and the
/// torques of the outputs together make it up, but for the losses of a drive.
bool is_one_of_outputs(const Step& step, const Project& project, const std::string& shaft);
/// The material that a step names; empty if none.
std::string material_of(const Step& step);
/// Whether a step connects a hub to a shaft: it hands over a notch of the shaft, or the connection.
bool connects(const Step& step);
/// Whether a meaning is a strength or an allowable stress of a material.
bool is_strength(std::string_view what);
/// Whether the calculator declares one of these meanings for a field.
bool means(const Calculator& calculator, const std::string& path, bool (*is_it)(std::string_view what));

}  // namespace loadpath::project
