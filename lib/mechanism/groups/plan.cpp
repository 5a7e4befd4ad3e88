#include "lib/mechanism/groups/plan.hpp"

#include "lib/mechanism/structure/assur.hpp"

#include <algorithm>

namespace loadpath::mechanism {
namespace {

Vec unit(double direction) { return turn(direction)({1.0, 0.0}); }

void take_dimensions_of(const Joint& joint, TreeJoint& tree) {
  tree.pin = tree.link_is_i ? joint.point_i : joint.point_j;
  tree.seat = tree.link_is_i ? joint.point_j : joint.point_i;
  if (tree.kind == TreeJoint::Kind::turn) return;
  tree.angle = tree.link_is_i ? joint.angle : -joint.angle;
  tree.turned = turn(tree.angle);
  tree.along = tree.link_is_i ? unit(joint.direction) : -unit(joint.direction - joint.angle);
}

/// The pair of a drive that closes a loop.
PairShape shape_of_drive(const Model& model, const Driver& driver) {
  const bool linear = driver.kind == Driver::Kind::linear;
  return shape_of(driver, linear ? &model.joints[static_cast<std::size_t>(driver.joint)] : nullptr);
}

class Planner {
 public:
  explicit Planner(const Model& model) : model_(model), ground_(model.links.size()), placed_(ground_ + 1, false) {
    plan_.ground = ground_;
    plan_.links = ground_ + 1;
    plan_.drivers = model.drivers.size();
    placed_[ground_] = true;
  }

  Plan run() {
    for (const Group& group : groups(model_)) add(group);
    return std::move(plan_);
  }

 private:
  [[nodiscard]] std::size_t index(int link) const { return link == ground ? ground_ : static_cast<std::size_t>(link); }

  void add(const Group& group) {
    GroupPlan plan;
    plan.first_tree = plan_.tree.size();
    plan.first_cut = plan_.cuts.size();
    used_joints_.assign(model_.joints.size(), false);
    used_drivers_.assign(model_.drivers.size(), false);
    before_ = placed_;
    while (std::ranges::any_of(group.links, [&](std::size_t k) { return !placed_[k]; })) hang_one(group);
    plan.last_tree = plan_.tree.size();
    number_unknowns(plan);
    cut_the_rest(group, plan);
    choose_closing(plan);
    plan_.groups.push_back(std::move(plan));
  }

  /// The next link: preferably by a driven joint, then by one to links before the group.
  void hang_one(const Group& group) {
    std::size_t best = none;
    int best_rank = 0;
    for (const std::size_t k : group.joints) {
      const int rank = rank_of(group, model_.joints[k], k);
      if (rank <= best_rank) continue;
      best = k;
      best_rank = rank;
    }
    if (best != none) {
      hang_by(group, best);
    } else {
      hang_loose(*std::ranges::find_if(group.links, [&](std::size_t k) { return !placed_[k]; }));
    }
  }

  [[nodiscard]] int rank_of(const Group& group, const Joint& joint, std::size_t k) const {
    const std::size_t i = index(joint.i), j = index(joint.j);
    if (placed_[i] == placed_[j]) return 0;
    if (joint.kind == JointKind::rigid) return 4;
    if (joint.kind != JointKind::revolute && joint.kind != JointKind::prismatic) return 0;
    if (driver_of(group, joint, k) != none) return 3;
    return before_[placed_[i] ? i : j] ? 2 : 1;
  }

  [[nodiscard]] std::size_t driver_of(const Group& group, const Joint& joint, std::size_t k) const {
    for (const std::size_t d : group.drivers) {
      const Driver& driver = model_.drivers[d];
      if (driver.kind == Driver::Kind::linear) {
        if (joint.kind == JointKind::prismatic && index(driver.joint) == k) return d;
      } else if (joint.kind == JointKind::revolute &&
                 ((driver.i == joint.i && driver.j == joint.j) || (driver.i == joint.j && driver.j == joint.i))) {
        if (!used_drivers_[d]) return d;
      }
    }
    return none;
  }

  void hang_by(const Group& group, std::size_t k) {
    const Joint& joint = model_.joints[k];
    const bool link_is_i = !placed_[index(joint.i)];
    TreeJoint tree{.link = index(link_is_i ? joint.i : joint.j),
                   .on = index(link_is_i ? joint.j : joint.i),
                   .joint = k,
                   .link_is_i = link_is_i};
    used_joints_[k] = true;
    if (joint.kind != JointKind::revolute)
      tree.kind = joint.kind == JointKind::rigid ? TreeJoint::Kind::fixed : TreeJoint::Kind::slide;
    take_dimensions_of(joint, tree);
    give_drive(driver_of(group, joint, k), tree);
    push(tree);
  }

  void give_drive(std::size_t d, TreeJoint& tree) {
    if (d == none) return;
    used_drivers_[d] = true;
    tree.driver = d;
    tree.offset = model_.drivers[d].offset;
    const bool rotary = model_.drivers[d].kind == Driver::Kind::rotary;
    tree.sense = rotary && index(model_.drivers[d].i) != tree.link ? -1.0 : 1.0;
  }

  /// On two crossed slides from the ground, about which it turns.
  void hang_loose(std::size_t link) {
    TreeJoint hang{.kind = TreeJoint::Kind::slide, .link = new_link(), .on = ground_};
    push(hang);
    hang.on = hang.link;
    hang.link = new_link();
    hang.along = {0.0, 1.0};
    push(hang);
    push({.link = link, .on = hang.link});
  }

  std::size_t new_link() {
    placed_.push_back(false);
    before_.push_back(false);
    return plan_.links++;
  }

  void push(TreeJoint tree) {
    tree.based = before_[tree.on];
    placed_[tree.link] = true;
    plan_.tree.push_back(tree);
  }

  void number_unknowns(GroupPlan& plan) {
    for (std::size_t t = plan.first_tree; t < plan.last_tree; ++t) {
      if (plan_.tree[t].driver != none || plan_.tree[t].kind == TreeJoint::Kind::fixed) continue;
      plan_.tree[t].unknown = plan.unknowns.size();
      plan.unknowns.push_back(t);
    }
  }

  void cut_the_rest(const Group& group, GroupPlan& plan) {
    std::size_t row = 0;
    const auto add = [&](Cut cut) {
      cut.row = row;
      cut.rows = cut.shape.rows();
      row += cut.rows;
      cut.movers = movers_of(plan, cut);
      plan.on_cam = plan.on_cam || cut.shape.profile != nullptr;
      plan_.cuts.push_back(std::move(cut));
    };
    for (const std::size_t k : group.joints) {
      if (!used_joints_[k]) add(cut_of(k));
    }
    for (const std::size_t d : group.drivers) {
      if (!used_drivers_[d]) add(cut_of_drive(d));
    }
    plan.last_cut = plan_.cuts.size();
  }

  [[nodiscard]] Cut cut_of(std::size_t k) const {
    const Joint& joint = model_.joints[k];
    return {.shape = shape_of(joint), .i = index(joint.i), .j = index(joint.j), .joint = k};
  }

  [[nodiscard]] Cut cut_of_drive(std::size_t d) const {
    const Driver& driver = model_.drivers[d];
    const bool linear = driver.kind == Driver::Kind::linear;
    const Joint* slide = linear ? &model_.joints[index(driver.joint)] : nullptr;
    return {.shape = shape_of_drive(model_, driver),
            .i = index(linear ? slide->i : driver.i),
            .j = index(linear ? slide->j : driver.j),
            .driver = d};
  }

  /// The unknown coordinates between link i and link j: those above both move neither against the other.
  [[nodiscard]] std::vector<Mover> movers_of(const GroupPlan& plan, const Cut& cut) const {
    const auto of_i = unknowns_above(plan, cut.i), of_j = unknowns_above(plan, cut.j);
    std::vector<Mover> movers;
    for (const std::size_t t : of_i) {
      if (std::ranges::find(of_j, t) == of_j.end()) movers.push_back({t, 1.0});
    }
    for (const std::size_t t : of_j) {
      if (std::ranges::find(of_i, t) == of_i.end()) movers.push_back({t, -1.0});
    }
    return movers;
  }

  [[nodiscard]] std::vector<std::size_t> unknowns_above(const GroupPlan& plan, std::size_t link) const {
    std::vector<std::size_t> above;
    for (std::size_t t = plan.last_tree; t-- > plan.first_tree;) {
      if (plan_.tree[t].link != link) continue;
      if (plan_.tree[t].unknown != none) above.push_back(t);
      link = plan_.tree[t].on;
    }
    return above;
  }

  void choose_closing(GroupPlan& plan) const {
    if (plan.unknowns.empty()) return;
    plan.closing = Closing::by_newton;
    if (plan.last_cut != plan.first_cut + 1) return;
    const Cut& cut = plan_.cuts[plan.first_cut];
    for (const Mover& mover : cut.movers) {
      std::size_t& of_side = mover.side > 0.0 ? plan.mover_i : plan.mover_j;
      if (of_side != none) return;  // two coordinates on one side
      of_side = mover.tree;
    }
    if (cut.movers.size() == plan.unknowns.size()) plan.closing = closed_form(plan, cut);
  }

  [[nodiscard]] Closing closed_form(const GroupPlan& plan, const Cut& cut) const {
    const auto turns = [&](std::size_t t) { return t != none && plan_.tree[t].kind == TreeJoint::Kind::turn; };
    const bool turns_i = turns(plan.mover_i), turns_j = turns(plan.mover_j);
    if (cut.shape.kind != PairShape::Kind::joint) return Closing::by_newton;
    switch (cut.shape.joint) {
      case JointKind::revolute:
        return Closing::two_paths;
      case JointKind::slot:
        if (plan.mover_j == none) return Closing::two_paths;
        return turns_j ? Closing::slot_about_pin : Closing::slot_along_slide;
      case JointKind::prismatic:
        if (turns_i && turns_j) return Closing::slide_of_two_turns;
        return turns_i || turns_j ? Closing::slide_of_turn : Closing::by_newton;
      case JointKind::rigid:
      case JointKind::gear:
      case JointKind::rack:
      case JointKind::belt:
      case JointKind::rolling:
      case JointKind::rolling_on_line:
      case JointKind::cam:
      case JointKind::none:
        break;
    }
    return Closing::by_newton;
  }

  const Model& model_;
  std::size_t ground_;
  Plan plan_;
  std::vector<bool> placed_, before_;
  std::vector<bool> used_joints_, used_drivers_;
};

}  // namespace

std::size_t first_link(const Plan& plan, const GroupPlan& group) {
  std::size_t first = none;
  for (std::size_t t = group.first_tree; t < group.last_tree; ++t) first = std::min(first, plan.tree[t].link);
  return first;
}

Plan plan_of(const Model& model) { return Planner(model).run(); }

void take_dimensions(const Model& model, Plan& plan) {
  for (TreeJoint& tree : plan.tree) {
    if (tree.joint != none) take_dimensions_of(model.joints[tree.joint], tree);
    if (tree.driver != none) tree.offset = model.drivers[tree.driver].offset;
  }
  for (Cut& cut : plan.cuts) {
    cut.shape =
        cut.joint != none ? shape_of(model.joints[cut.joint]) : shape_of_drive(model, model.drivers[cut.driver]);
  }
}

}  // namespace loadpath::mechanism
