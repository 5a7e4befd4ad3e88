// Lengths, speeds, forces and power of cylinders.
#include "calculators/mechanism/completion/cylinders.hpp"

#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/rows.hpp"
#include "lib/mechanism/model/frames.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace loadpath::planar {

namespace {

using mechanism::Position;

struct Ram {
  std::string name;
  mechanism::Joint bore;
  bool driven = true;
  std::size_t index = 0;  // index of its driver, or of the load that pushes its rod

  struct State {
    double s = 0.0, v = 0.0, F = 0.0;
  };
  [[nodiscard]] State now(const Position& p) const {
    const mechanism::Placed i = mechanism::placed_at(p, bore.i), j = mechanism::placed_at(p, bore.j);
    mechanism::PairPlace at;
    mechanism::place(mechanism::shape_of(bore), i, j, at);
    const mechanism::Vec parting = mechanism::velocity_at(at.at, i, mechanism::speeds_at(p, bore.i)) -
                                   mechanism::velocity_at(at.at, j, mechanism::speeds_at(p, bore.j));
    return {dot(at.along, at.apart), dot(at.along, parting), driven ? p.effort[index] : p.loads[index].force.x};
  }
};

/// In place of that of a drive (aspects/drives.cpp).
constexpr std::array pushed_rows{row<Ram>("cylinders.NAME.F", "given force, pushing the ends apart", N,
                                          {.tabled = Tabled::always},
                                          [](const Ram&, const Ram::State& now) { return now.F; })};

constexpr std::array ram_rows{row<Ram>("cylinders.NAME.s", "length between its two points, or position along its guide",
                                       mm, {.detail = true}, [](const Ram&, const Ram::State& now) { return now.s; }),
                              row<Ram>("cylinders.NAME.v", "speed of extension", m_per_s, {.detail = true},
                                       [](const Ram&, const Ram::State& now) { return now.v; }),
                              row<Ram>("cylinders.NAME.P", "power delivered", W, {.detail = true},
                                       [](const Ram&, const Ram::State& now) { return now.F * now.v; })};

constexpr Declaration stroke =
    declare("cylinders.NAME.stroke", "stroke between minimum and maximum length", mm, "more than one position");

Output::Values stroke_of(const Ram& ram, const Solved& solved) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t k = 0; k < solved.cycle.positions.size(); ++k) {
    if (!solved.cycle.closed[k]) return {{none}, say("it does not close everywhere")};
    const double s = ram.now(solved.cycle.positions[k]).s;
    least = std::min(least, s), most = std::max(most, s);
  }
  return {{most - least}};
}

void list_cylinders(std::vector<ResultPattern>& patterns) {
  list_patterns(ram_rows, patterns);
  patterns.push_back(stroke.pattern);
}

Ram ram_of(const Mechanism::Input& in, const mechanism::Model& model, const Mechanism::Actuator& actuator) {
  Ram ram{text(actuator.name), model.joints[index_of(in.joints, actuator.joint)], actuator.driven};
  if (actuator.driven) {
    const auto named = [&](const mechanism::Driver& d) { return d.name == ram.name; };
    ram.index = static_cast<std::size_t>(std::find_if(model.drivers.begin(), model.drivers.end(), named) -
                                         model.drivers.begin());
  } else {
    const auto pushes = [&](const mechanism::Load& load) { return load.link == ram.bore.i; };
    ram.index =
        static_cast<std::size_t>(std::find_if(model.loads.begin(), model.loads.end(), pushes) - model.loads.begin());
  }
  return ram;
}

void add_cylinders(const Mechanism::Input& in, const mechanism::Model& model, std::vector<Output>& out) {
  for (const Mechanism::Actuator& actuator : in.actuators) {
    const Ram ram = ram_of(in, model, actuator);
    if (!ram.driven) add_outputs(ram, pushed_rows, out);
    add_outputs(ram, ram_rows, out);
    if (axis_name(in).empty()) continue;
    out.push_back(output(stroke, ram.name));
    out.back().is_single = true;
    out.back().read_cycle = [ram](const Solved& solved) { return stroke_of(ram, solved); };
  }
}

}  // namespace

constinit const Aspect aspects::cylinders{
    .check_names = &check_cylinders, .list = &list_cylinders, .add_outputs = &add_cylinders};

}  // namespace loadpath::planar
