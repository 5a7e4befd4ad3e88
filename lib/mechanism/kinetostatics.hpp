// Forces at one position: what the constraints must supply, how it is shared by the joints, and the proof by summing
// up.
#pragma once

#include "lib/mechanism/kinematics.hpp"
#include "lib/mechanism/model.hpp"
#include "lib/mechanism/whole_system.hpp"

#include <span>

namespace loadpath::mechanism {

/// Inertia less loads and gravity, per coordinate: the right side of the transposed system for the multipliers.
/// `statics`: without inertia.
void required_forces(const Model& model, const Constraints& constraints, std::span<const double> velocity,
                     std::span<const double> acceleration, bool statics, std::span<double> required);

/// Reactions and efforts from the multipliers; `length`: the unit of length of the constraints, in m.
void share_out(const Model& model, const Constraints& constraints, std::span<const double> q,
               std::span<const double> multipliers, double length, Position& out);

/// What is left of the equilibrium of each link and of the power balance, from the values in `out` and the model in SI.
class Balance {
 public:
  explicit Balance(const Model& model) : sums_(model.links.size() + 1) {}
  void check(const Model& model, const Constraints& constraints, std::span<const Drive> drives, bool statics,
             Position& out);

 private:
  struct Sum {
    Vec centre;  // about which the moments are taken
    Vec force;
    double moment = 0.0;
    void add(Vec at, Vec push, double couple);
  };
  void add_links(const Model& model, const Constraints& constraints, bool statics, const Position& at);
  void add_loads(const Model& model, const Constraints& constraints, const Position& at);
  void add_joints(const Constraints& constraints, const Position& at);
  void add_drives(const Model& model, const Constraints& constraints, std::span<const Drive> drives,
                  const Position& at);
  void add_power(double power);
  Sum& of(int link) { return link == ground ? sums_.back() : sums_[static_cast<std::size_t>(link)]; }

  std::vector<Sum> sums_;  // the ground's comes last
  double power_ = 0.0;
  double power_scale_ = 0.0;
};

}  // namespace loadpath::mechanism
