// Internal forces of links.
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/rows.hpp"
#include "lib/mechanism/studies/member.hpp"
#include "lib/quantity/format.hpp"

#include <array>
#include <cmath>
#include <memory>

namespace loadpath::planar {

namespace {

using mechanism::MemberLoads;
using mechanism::Position;

mechanism::Member member_of(const Mechanism::Input& in, const mechanism::Model& model, std::size_t k) {
  mechanism::Member member = mechanism::member_of(model, k);
  const bool bar = member.length() > 0.0 && mechanism::is_uniform(model, member);
  const bool uniform = in.links[k].mass_line == planar::MassLine::uniform ||
                       (in.links[k].mass_line == planar::MassLine::automatic && bar);
  member.mass = uniform ? mechanism::MassLine::uniform : mechanism::MassLine::lumped;
  return member;
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
        "links.NAME.N", "axial force of the largest magnitude over the link's length, tension positive", N,
        {.tabled = Tabled::always, .with = "V, M_b"},
        [](const Bar&, const MemberLoads::Peaks& most) { return most.N.N; }, nullptr, "links with two joints or more"),
    row<Bar>(
        "links.NAME.V", "shear force of the largest magnitude over its length", N,
        {.tabled = Tabled::always, .with = "N, M_b"},
        [](const Bar&, const MemberLoads::Peaks& most) { return most.V.V; }, nullptr, "links with two joints or more"),
    row<Bar>(
        "links.NAME.M_b", "bending moment of the largest magnitude over its length", N_m,
        {.tabled = Tabled::always, .with = "N, V"}, [](const Bar&, const MemberLoads::Peaks& most) { return most.M.M; },
        nullptr, "links with two joints or more")};

void list(std::vector<ResultPattern>& patterns) { list_patterns(bar_rows, patterns); }

void add(const Mechanism::Input& in, const mechanism::Model& model, std::vector<Output>& out) {
  const auto kept = std::make_shared<const mechanism::Model>(model);
  const bool statics = in.analysis == Mechanism::Analysis::statics;
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    const mechanism::Member member = member_of(in, *kept, k);
    if (member.length() == 0.0) continue;
    const auto loads = std::make_shared<MemberLoads>(*kept, member);
    add_outputs(Bar{model.links[k].name, kept, loads, k, statics}, bar_rows, out);
  }
}

/// Links that are said to be uniform bars and are not.
void check(const Mechanism::Input& in, const mechanism::Model& model, std::vector<FieldFault>& faults) {
  for (std::size_t k = 0; k < in.links.size(); ++k) {
    if (in.links[k].mass_line != planar::MassLine::uniform) continue;
    const mechanism::Member member = mechanism::member_of(model, k);
    if (member.length() > 0.0 && mechanism::is_uniform(model, member)) continue;
    const double l = member.length(), J = model.links[k].mass * l * l / 12.0;
    faults.push_back({"links." + model.links[k].name + ".mass_line",
                      say("link '{1}' is no uniform bar of {2}: that has its mass centre in the middle and J = {3}",
                          model.links[k].name, format_quantity(l, "mm", 4), format_quantity(J, "kg*m^2", 4)),
                      say("correct S and J, or say mass_line = \"lumped\"")});
  }
}

}  // namespace

constinit const Aspect aspects::members{.check_values = &check, .list = &list, .add_outputs = &add};

}  // namespace loadpath::planar
