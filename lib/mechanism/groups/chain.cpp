#include "lib/mechanism/groups/chain.hpp"

#include "lib/mechanism/forces/induced_source.hpp"

#include <algorithm>

namespace loadpath::mechanism {
namespace {

using Kind = ChainStep::Kind;

bool turns(const Plan& plan, std::size_t tree) { return tree != none && plan.tree[tree].kind == TreeJoint::Kind::turn; }

Hinge hinge_of(const Plan& plan, std::size_t t) {
  const TreeJoint& tree = plan.tree[t];
  return {.tree = t,
          .link = tree.link,
          .on = tree.on,
          .joint = tree.joint,
          .grounded = tree.on == plan.ground,
          .link_is_i = tree.link_is_i,
          .seat = {},
          .mount = {}};
}

/// A line of an existing link, as for a massless slider.
Hinge line_of(const Plan& plan, std::size_t link) {
  return {.on = link, .grounded = link == plan.ground, .seat = {}, .mount = {}};
}

class Reader {
 public:
  Reader(const Model& model, const Plan& plan) : model_(model), plan_(plan) {}

  bool read(Chain& chain) {
    if (!is_chain(model_)) return false;
    for (group_ = 0; group_ < plan_.groups.size(); ++group_) {
      const GroupPlan& group = plan_.groups[group_];
      if (!(group.unknowns.empty() ? read_driven(group, chain) : read_dyad(group, chain))) return false;
    }
    return true;
  }

 private:
  bool read_driven(const GroupPlan& group, Chain& chain) {
    if (group.first_cut != group.last_cut) return false;
    for (std::size_t t = group.first_tree; t < group.last_tree; ++t) {
      const TreeJoint& tree = plan_.tree[t];
      const bool fixed = tree.kind == TreeJoint::Kind::fixed;
      if (tree.link > plan_.ground || tree.on > plan_.ground || (!fixed && tree.driver == none)) return false;
      ChainStep step{.group = group_, .first = hinge_of(plan_, t), .second = {}, .driver = tree.driver, .pin = {}};
      step.kind = fixed ? Kind::fixed : turns(plan_, t) ? Kind::turned : Kind::slid;
      step.sense = tree.sense;
      chain.steps.push_back(step);
    }
    return true;
  }

  bool read_dyad(const GroupPlan& group, Chain& chain) {
    if (group.last_cut != group.first_cut + 1 || group.last_tree - group.first_tree != group.unknowns.size())
      return false;
    for (std::size_t t = group.first_tree; t < group.last_tree; ++t) {
      if (!plan_.tree[t].based || plan_.tree[t].on > plan_.ground || plan_.tree[t].link > plan_.ground) return false;
    }
    ChainStep step{.group = group_, .first = {}, .second = {}, .cut = group.first_cut, .pin = {}};
    step.joint = plan_.cuts[group.first_cut].joint;
    if (!read_closing(group, step)) return false;
    chain.steps.push_back(step);
    return true;
  }

  bool read_closing(const GroupPlan& group, ChainStep& step) const {
    const Cut& cut = plan_.cuts[group.first_cut];
    if (group.closing == Closing::two_paths) return read_paths(group, cut, step);
    if (group.closing == Closing::slot_about_pin) {
      step.kind = Kind::slot;
      step.first = line_of(plan_, cut.i);
      step.second = hinge_of(plan_, group.mover_j);
      return true;
    }
    if (group.closing != Closing::slide_of_two_turns) return false;
    step.kind = Kind::guide;
    step.first = hinge_of(plan_, group.mover_i);
    step.second = hinge_of(plan_, group.mover_j);
    return true;
  }

  bool read_paths(const GroupPlan& group, const Cut& cut, ChainStep& step) const {
    const bool turns_i = turns(plan_, group.mover_i), turns_j = turns(plan_, group.mover_j);
    if (!turns_i && !turns_j) return false;
    step.kind = turns_i && turns_j ? Kind::two_arms : Kind::arm_and_line;
    const auto side = [&](std::size_t mover, std::size_t link) {
      return mover == none ? line_of(plan_, link) : hinge_of(plan_, mover);
    };
    step.first = side(group.mover_i, cut.i);
    step.second = side(group.mover_j, cut.j);
    if (!turns_i) std::swap(step.first, step.second);
    step.sense = turns_i ? 1.0 : -1.0;
    return true;
  }

  const Model& model_;
  const Plan& plan_;
  std::size_t group_ = 0;
};

/// Sets all frames and hinges, from the first step on.
class Dimensions {
 public:
  Dimensions(const Model& model, const Plan& plan, Chain& chain) : model_(model), plan_(plan), chain_(chain) {}

  void take() {
    chain_.gravity = model_.gravity;
    for (ChainStep& step : chain_.steps) take(step);
    for (std::size_t n = 0; n < model_.loads.size(); ++n) take(model_.loads[n], chain_.loads[n]);
  }

 private:
  void take(ChainStep& step) {
    switch (step.kind) {
      case Kind::turned:
        step.offset = tree(step.first).offset;
        return hang(step.first, tree(step.first).pin, {});
      case Kind::slid:
        step.offset = tree(step.first).offset;
        return hang_slider(step.first, tree(step.first).pin);
      case Kind::fixed:
        return hang_slider(step.first, tree(step.first).pin);
      case Kind::two_arms: {
        const bool is_i = step.first.link == plan_.cuts[step.cut].i;
        hang_arm(step.first, inner(step, is_i));
        return hang_arm(step.second, inner(step, !is_i));
      }
      case Kind::arm_and_line: {
        const bool is_i = step.first.link == plan_.cuts[step.cut].i;
        hang_arm(step.first, inner(step, is_i));
        return step.second.tree == none ? take_slot(step) : hang_slider(step.second, inner(step, !is_i));
      }
      case Kind::slot: {
        hang_along(step.second, plan_.cuts[step.cut].shape.line);
        step.pin = own(step.first.on, inner(step, true));
        step.aside = own(step.second.link, inner(step, false)).y;
        return;
      }
      case Kind::guide: {
        const PairShape& shape = plan_.cuts[step.cut].shape;
        hang_along(step.first, shape.turned.back()(shape.line));
        hang_along(step.second, shape.line);
        step.pin = own(step.first.link, inner(step, true));
        step.angle = shape.angle;
        step.aside = own(step.second.link, inner(step, false)).y - step.pin.y;
        return;
      }
    }
  }

  [[nodiscard]] const TreeJoint& tree(const Hinge& hinge) const { return plan_.tree[hinge.tree]; }
  /// The inner joint's point of link i, or of link j, in the model's frame.
  [[nodiscard]] Vec inner(const ChainStep& step, bool of_i) const {
    const PairShape& shape = plan_.cuts[step.cut].shape;
    return of_i ? shape.point_i : shape.point_j;
  }
  [[nodiscard]] Vec own(std::size_t link, Vec point) const {
    return chain_.links[link].own(point - chain_.links[link].base);
  }

  /// Sets the frame at `base` of the model's frame, with this rotation against it.
  void found(std::size_t k, Vec base, Turn turned) {
    ChainLink& link = chain_.links[k];
    const Link& given = model_.links[k];
    link.own = turned;
    link.base = base;
    link.start = own(k, {});
    link.shifted = link.start.x != 0.0 || link.start.y != 0.0;
    link.mass = given.mass;
    link.inertia = given.inertia;
    link.centre = own(k, given.centre);
  }

  void hang(Hinge& hinge, Vec base, Turn turned) {
    found(hinge.link, base, turned);
    hinge.seat = own(hinge.on, tree(hinge).seat);
  }
  /// Its frame looks along `direction` of the model's frame, a unit vector.
  void hang_along(Hinge& hinge, Vec direction) { hang(hinge, tree(hinge).pin, Turn{direction.x, direction.y}.back()); }
  void hang_arm(Hinge& hinge, Vec inner) {
    const Vec bar = inner - tree(hinge).pin;
    hinge.length = length(bar);
    hang_along(hinge, (1.0 / hinge.length) * bar);
  }
  /// Its frame is parallel to that of the link that it slides on.
  void hang_slider(Hinge& hinge, Vec inner) {
    const TreeJoint& joint = tree(hinge);
    const Turn turned = chain_.links[hinge.on].own * joint.turned;
    hinge.angle = joint.angle;
    hang(hinge, inner, turned);
    hinge.mount = hinge.link_is_i ? own(hinge.link, joint.pin) : hinge.seat;
    hinge.centred = hinge.link_is_i && hinge.mount.x == 0.0 && hinge.mount.y == 0.0;
    hinge.seat = hinge.seat + turned(inner - joint.pin);
    hinge.along = chain_.links[hinge.on].own(joint.along);
  }
  void take_slot(ChainStep& step) const {
    step.second.seat = own(step.second.on, inner(step, false));
    step.second.along = chain_.links[step.second.on].own(plan_.cuts[step.cut].shape.line);
  }
  void take(const Load& load, ChainLoad& own_load) const {
    own_load.point = own(own_load.link, load.point);
    own_load.at_start = own_load.point.x == 0.0 && own_load.point.y == 0.0;
  }

  const Model& model_;
  const Plan& plan_;
  Chain& chain_;
};

}  // namespace

bool is_chain(const Model& model) {
  return model.springs.empty() && std::ranges::none_of(model.joints, [](const Joint& j) { return modes_of(j) > 0; });
}

void Chain::take_dimensions(const Model& model, const Plan& plan) { Dimensions(model, plan, *this).take(); }

std::optional<Chain> chain_of(const Model& model, const Plan& plan) {
  Chain chain;
  chain.ground = plan.ground;
  chain.joints = model.joints.size();
  chain.drivers = model.drivers.size();
  chain.links.resize(plan.ground + 1);
  if (!Reader(model, plan).read(chain)) return std::nullopt;
  for (const Load& load : model.loads)
    chain.loads.push_back(
        {.link = static_cast<std::size_t>(load.link), .turns_with_link = load.turns_with_link, .point = {}});
  chain.take_dimensions(model, plan);
  return chain;
}

}  // namespace loadpath::mechanism
