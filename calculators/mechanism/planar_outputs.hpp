// What a planar mechanism gives to other steps: paths, dimensions, and how each is read off a position.
#pragma once

#include "calculators/mechanism/planar_model.hpp"
#include "lib/calculator.hpp"
#include "lib/issue.hpp"
#include "lib/quantity/dimension.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace loadpath {

namespace project {
struct Account;
}
struct Cycle;
struct Kinematics;
struct Errors;
struct Balanced;

/// What is known when all positions are solved.
struct Solved {
  const Cycle& cycle;
  const Kinematics& kinematics;
  const Errors& errors;
  const Balanced& balanced;
};

struct MechanismOutput {
  struct Values {
    std::vector<double> si;  // one for every position, or one
    Message missing;         // why there are none, or not everywhere; empty: there are, or it goes without saying
    Values(std::vector<double> values, Message reason = {})  // NOLINT(google-explicit-constructor)
        : si(std::move(values)), missing(std::move(reason)) {}
  };
  std::string path;  // "joints.A.F"
  std::string doc;
  std::string unit;
  Dimension dimension;
  std::function<double(const mechanism::Position&)> read;
  /// In place of `read`, of all that is solved.
  std::function<Values(const Solved&)> read_cycle = {};
  bool is_single = false;
  /// In place of `read`, of the results before it.
  std::function<Values(const project::Account&)> read_results = {};
};

/// Whether a result is the effort of a drive itself, "drive.M" or "cylinders.NAME.F".
bool is_drive_effort(std::string_view path);

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
