// The full mechanism: reduced to its crank, its action on its frame, and its friction losses.
#include "calculators/mechanism/parts/losses.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/rows.hpp"
#include "lib/mechanism/model/frames.hpp"
#include "lib/mechanism/studies/reduction.hpp"
#include "lib/mechanism/studies/shaking.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

namespace loadpath::planar {

namespace {

using mechanism::Position;
using mechanism::Vec;

struct Machine {
  std::string name;
  std::shared_ptr<const mechanism::Model> model;
  std::vector<std::size_t> useful;  // loads
  std::shared_ptr<mechanism::Reduction> reduction;
  bool cranked = false, statics = false;

  static bool has_friction(const Machine& m) {
    return std::any_of(m.model->joints.begin(), m.model->joints.end(), [](const auto& j) { return rubs(j); });
  }
  static bool has_use(const Machine& m) { return !m.useful.empty(); }
  static bool has_crank(const Machine& m) { return m.cranked; }
  static bool shakes(const Machine& m) {
    return !m.statics &&
           std::any_of(m.model->links.begin(), m.model->links.end(), [](const auto& link) { return link.mass > 0.0; });
  }

  struct Now {
    const Position* at = nullptr;
    mechanism::Reduced reduced;  // reduced inertia and moment, with a crank
    mechanism::Shaking shaking;  // shaking force of an unbalanced one
  };
  [[nodiscard]] Now now(const Reached& reached) const {
    Now all{&reached.at, {}, {}};
    if (cranked) all.reduced = reduced(reached).value_or(mechanism::Reduced{none, none, none, none});
    if (shakes(*this)) all.shaking = mechanism::shaking(*model, reached.at, {});
    return all;
  }
  [[nodiscard]] std::optional<mechanism::Reduced> reduced(const Reached& reached) const {
    return reached.derivative == nullptr ? reduction->find(reached.at)
                                         : reduction->find(reached.at, *reached.derivative);
  }
};

double loss(const Machine& m, const Machine::Now& now) {
  double sum = 0.0;
  for (std::size_t k = 0; k < m.model->joints.size(); ++k) {
    if (rubs(m.model->joints[k])) sum += loss_of(*m.model, k, *now.at);
  }
  return sum;
}

double use(const Machine& m, const Machine::Now& now) {
  const Position& p = *now.at;
  double sum = 0.0;
  for (const std::size_t n : m.useful) {
    const mechanism::Load& load = m.model->loads[n];
    const mechanism::Placed frame = mechanism::placed_at(p, load.link);
    const mechanism::Speeds speed = mechanism::speeds_at(p, load.link);
    const Vec velocity = speed.origin + speed.omega * normal(frame.turned(load.point));
    sum -= dot(global_force(load, p.loads[n].force, frame.turned), velocity) + p.loads[n].moment * speed.omega;
  }
  return sum;
}

constexpr std::array machine_rows{
    row<Machine>(
        "drive.J_red", "moment of inertia of all links, reduced to the crank", kg_m2, {.tabled = Tabled::always},
        [](const Machine&, const Machine::Now& now) { return now.reduced.inertia; }, &Machine::has_crank,
        "with a crank"),
    row<Machine>(
        "drive.M_red", "moment of loads, weights and springs, reduced to the crank", N_m,
        {.tabled = Tabled::always, .is_load = true, .loads_crank = true},
        [](const Machine&, const Machine::Now& now) { return now.reduced.moment; }, &Machine::has_crank,
        "with a crank"),
    row<Machine>(
        "frame.F", "shaking force on the frame, the magnitude of -sum m a", N,
        {.tabled = Tabled::always, .detail = true, .is_load = true},
        [](const Machine&, const Machine::Now& now) { return mechanism::length(now.shaking.force); }, &Machine::shakes,
        "links with mass"),
    row<Machine>(
        "frame.x", "shaking force along x", N, {.detail = true, .is_load = true},
        [](const Machine&, const Machine::Now& now) { return now.shaking.force.x; }, &Machine::shakes,
        "links with mass"),
    row<Machine>(
        "frame.y", "shaking force along y", N, {.detail = true, .is_load = true},
        [](const Machine&, const Machine::Now& now) { return now.shaking.force.y; }, &Machine::shakes,
        "links with mass"),
    row<Machine>(
        "frame.M", "shaking moment on the frame about the global origin", N_m,
        {.tabled = Tabled::always, .detail = true, .is_load = true},
        [](const Machine&, const Machine::Now& now) { return now.shaking.moment; }, &Machine::shakes,
        "links with mass"),
    row<Machine>("drive.P_loss", "power loss by friction in all joints", W,
                 {.kind = Kind::friction_power, .tabled = Tabled::always, .loads_crank = true}, &loss,
                 &Machine::has_friction, "with friction"),
    row<Machine>("drive.P_useful", "power against the useful loads", W,
                 {.kind = Kind::useful_power, .tabled = Tabled::always, .loads_crank = true}, &use, &Machine::has_use,
                 "with useful loads")};

void list_machine(std::vector<ResultPattern>& patterns) { list_patterns(machine_rows, patterns); }

void add_machine(const Mechanism::Input& in, const mechanism::Model& model, std::vector<Output>& out) {
  const auto kept = std::make_shared<const mechanism::Model>(model);
  const bool statics = leaves_out_inertia(in);
  Machine machine{"",     kept, {}, std::make_shared<mechanism::Reduction>(*kept), !in.crank.joint.empty() && !statics,
                  statics};
  for (std::size_t n = 0; n < in.loads.size(); ++n) {
    if (in.loads[n].useful == planar::Useful::yes) machine.useful.push_back(n);
  }
  add_outputs(machine, machine_rows, out);
}

}  // namespace

constinit const Aspect aspects::machine{.list = &list_machine, .add_outputs = &add_machine};

}  // namespace loadpath::planar
