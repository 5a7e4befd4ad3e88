// What a planar mechanism gives to other steps: paths, dimensions, and how each is read off a position.
#pragma once

#include "calculators/mechanism/planar_model.hpp"
#include "lib/calculator.hpp"
#include "lib/quantity/dimension.hpp"

#include <functional>
#include <string>
#include <vector>

namespace loadpath {

struct Cycle;
struct Kinematics;

struct MechanismOutput {
  std::string path;  // "joints.A.F"
  std::string doc;
  std::string unit;
  Dimension dimension;
  std::function<double(const mechanism::Position&)> read;
  /// In place of `read`, of the whole cycle: a value for every position, or one value.
  std::function<std::vector<double>(const Cycle&, const Kinematics&)> read_cycle = {};
  bool is_single = false;
};

/// All outputs, in the order of reports. `model` must outlive nothing: what the readers need is copied.
std::vector<MechanismOutput> mechanism_outputs(const PlanarMechanism::Input& in, const mechanism::Model& model);

/// The same before there is a model: NAME stands for the names in it.
std::vector<ResultPattern> mechanism_result_patterns();

/// Global place, velocity and acceleration of a point of a link.
struct PointMotion {
  mechanism::Vec place, velocity, acceleration;
};
PointMotion motion_of(const mechanism::Position& p, int link, mechanism::Vec at);

}  // namespace loadpath
