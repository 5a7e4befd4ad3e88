// Internal forces of links.
#include "calculators/mechanism/cycle/point_motion.hpp"
#include "calculators/mechanism/input/points.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/rows.hpp"
#include "lib/mechanism/studies/member.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace loadpath::planar {

namespace {

using mechanism::MemberLoads;
using mechanism::Position;
using mechanism::Vec;

/// Reach of a link with one joint, from there to its farthest point.
void reach_from_one_joint(const planar::Link& link, const mechanism::Model& model, mechanism::Member& member) {
  const auto own = static_cast<int>(member.link);
  const auto holds = [own](const mechanism::Joint& j) { return j.i == own || j.j == own; };
  if (std::count_if(model.joints.begin(), model.joints.end(), holds) != 1) return;
  const mechanism::Joint& joint = *std::find_if(model.joints.begin(), model.joints.end(), holds);
  member.start = member.end = joint.i == own ? joint.point_i : joint.point_j;
  for (const planar::Point& point : link.points) {
    const mechanism::Vec at = vector_of(point);
    if (mechanism::length(at - member.start) > member.length()) member.end = at;
  }
}

mechanism::Member member_of(const Mechanism::Input& in, const mechanism::Model& model, std::size_t k) {
  mechanism::Member member = mechanism::member_of(model, k);
  if (member.length() == 0.0) reach_from_one_joint(in.links[k], model, member);
  const bool bar = member.length() > 0.0 && mechanism::is_uniform(model, member);
  const bool uniform = in.links[k].mass_line == planar::MassLine::uniform ||
                       (in.links[k].mass_line == planar::MassLine::automatic && bar);
  member.mass = uniform ? mechanism::MassLine::uniform : mechanism::MassLine::lumped;
  return member;
}

/// Before the values of a template are known all its points lie in one place.
bool has_no_size(const mechanism::Model& model) {
  return std::all_of(model.joints.begin(), model.joints.end(), [](const mechanism::Joint& j) {
    return mechanism::length(j.point_i) == 0.0 && mechanism::length(j.point_j) == 0.0;
  });
}

struct Bar {
  std::string name;
  std::shared_ptr<const mechanism::Model> model;
  std::shared_ptr<MemberLoads> loads;
  std::size_t index = 0;
  bool statics = false;

  [[nodiscard]] bool knows_reactions(const Position& p) const {
    const int own = static_cast<int>(index);
    for (std::size_t k = 0; k < model->joints.size(); ++k) {
      const bool known = std::isfinite(p.reactions[k].force.x) && std::isfinite(p.reactions[k].couple);
      if (!known && (model->joints[k].i == own || model->joints[k].j == own)) return false;
    }
    return true;
  }
  [[nodiscard]] MemberLoads::Peaks now(const Position& p) const {
    if (!knows_reactions(p)) return {{0.0, none, none, none}, {0.0, none, none, none}, {0.0, none, none, none}};
    loads->take(p, statics);
    return loads->peaks();
  }
};

constexpr std::array bar_rows{
    row<Bar>(
        "links.NAME.N", "axial force of the maximum magnitude over the link's length, tension positive", N,
        {.tabled = Tabled::always, .is_load = true, .is_tension = true, .with = "V, M_b"},
        [](const Bar&, const MemberLoads::Peaks& most) { return most.N.N; }, nullptr,
        "links with two joints in different places, or with one joint and another point"),
    row<Bar>(
        "links.NAME.V", "shear force of the maximum magnitude over its length", N,
        {.tabled = Tabled::always, .is_load = true, .with = "N, M_b"},
        [](const Bar&, const MemberLoads::Peaks& most) { return most.V.V; }, nullptr,
        "links with two joints in different places, or with one joint and another point"),
    row<Bar>(
        "links.NAME.M_b", "bending moment of the maximum magnitude over its length", N_m,
        {.tabled = Tabled::always, .is_load = true, .with = "N, V"},
        [](const Bar&, const MemberLoads::Peaks& most) { return most.M.M; }, nullptr,
        "links with two joints in different places, or with one joint and another point")};

/// A link whose own inertia is not among the loads.
struct Massless {
  std::string name;
  int index;
  Vec start, end;
};

constexpr std::array massless_rows{row<Massless>(
    "links.NAME.a_m", "maximum acceleration of its axis, whose inertia force is not included", m_per_s2,
    {.detail = true},
    [](const Massless& link, const Position& p) {
      return std::max(mechanism::length(motion_of(p, link.index, link.start).acceleration),
                      mechanism::length(motion_of(p, link.index, link.end).acceleration));
    },
    nullptr, "links without mass, and all in a static analysis")};

constexpr Declaration length =
    declare("links.NAME.length", "maximum distance between its joints", mm,
            "links with two joints in different places, or with one joint and another point");

void list_members(std::vector<ResultPattern>& patterns) {
  list_patterns(bar_rows, patterns);
  list_patterns(massless_rows, patterns);
  patterns.push_back(length.pattern);
}

void add_members(const Mechanism::Input& in, const mechanism::Model& model, std::vector<Output>& out) {
  const auto kept = std::make_shared<const mechanism::Model>(model);
  const bool statics = leaves_out_inertia(in);
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    const mechanism::Member member = member_of(in, *kept, k);
    const bool unknown = has_no_size(*kept) && joint_points(in, in.links[k].name).size() > 1;
    if (member.length() == 0.0 && !unknown) continue;
    const auto loads = std::make_shared<MemberLoads>(*kept, member);
    add_outputs(Bar{model.links[k].name, kept, loads, k, statics}, bar_rows, out);
    if (statics || !(model.links[k].mass > 0.0))
      add_outputs(Massless{model.links[k].name, static_cast<int>(k), member.start, member.end}, massless_rows, out);
    out.push_back(output(length, model.links[k].name));
    out.back().is_single = true;
    out.back().read_cycle = [l = member.length()](const Solved&) { return Output::Values({l}); };
  }
}

/// Links that are said to be uniform bars and are not.
void check(const Mechanism::Input& in, const mechanism::Model& model, std::vector<FieldFault>& faults) {
  for (std::size_t k = 0; k < in.links.size(); ++k) {
    if (in.links[k].mass_line != planar::MassLine::uniform) continue;
    const mechanism::Member member = member_of(in, model, k);
    if (member.length() > 0.0 && mechanism::is_uniform(model, member)) continue;
    const double l = member.length(), J = model.links[k].mass * l * l / 12.0;
    faults.push_back({"links." + model.links[k].name + ".mass_line",
                      say("link '{1}' is not a uniform bar of {2}, which has its mass centre in the middle and J = {3}",
                          model.links[k].name, format_quantity(l, "mm", 4), format_quantity(J, "kg*m^2", 4)),
                      say("correct S and J, or give mass_line = \"lumped\"")});
  }
}

}  // namespace

constinit const Aspect aspects::members{.check_values = &check, .list = &list_members, .add_outputs = &add_members};

}  // namespace loadpath::planar
