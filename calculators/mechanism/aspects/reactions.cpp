// The force of each joint.
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/rows.hpp"
#include "lib/mechanism/model/vec.hpp"

#include <array>

namespace loadpath::planar {

namespace {

using mechanism::Position;

struct Jointed {
  std::string name;
  std::size_t index;
  mechanism::JointKind kind;

  static bool holds_angle(const Jointed& j) {
    return j.kind == mechanism::JointKind::prismatic || j.kind == mechanism::JointKind::rigid;
  }
};

constexpr std::array joint_rows{
    row<Jointed>("joints.NAME.F", "magnitude of the joint's force", N,
                 {.kind = Kind::joint_force, .tabled = Tabled::always, .is_load = true},
                 [](const Jointed& j, const Position& p) { return mechanism::length(p.reactions[j.index].force); }),
    row<Jointed>("joints.NAME.x", "force of the first link on the second, along x", N,
                 {.tabled = Tabled::at_one_position, .detail = true, .is_load = true, .with = "y"},
                 [](const Jointed& j, const Position& p) { return -p.reactions[j.index].force.x; }),
    row<Jointed>("joints.NAME.y", "force of the first link on the second, along y", N,
                 {.tabled = Tabled::at_one_position, .detail = true, .is_load = true, .with = "x"},
                 [](const Jointed& j, const Position& p) { return -p.reactions[j.index].force.y; }),
    row<Jointed>(
        "joints.NAME.M", "moment of the first link on the second at the first link's point", N_m,
        {.tabled = Tabled::always, .is_load = true},
        [](const Jointed& j, const Position& p) { return -p.reactions[j.index].couple; }, &Jointed::holds_angle,
        "prismatic and rigid joints")};

void list_reactions(std::vector<ResultPattern>& patterns) { list_patterns(joint_rows, patterns); }

void add_reactions(const Mechanism::Input&, const mechanism::Model& model, std::vector<Output>& out) {
  for (std::size_t j = 0; j < model.joints.size(); ++j)
    add_outputs(Jointed{model.joints[j].name, j, model.joints[j].kind}, joint_rows, out);
}

}  // namespace

constinit const Aspect aspects::reactions{
    .list = &list_reactions, .add_outputs = &add_reactions, .reads_forces_alone = true};

}  // namespace loadpath::planar
