// Counterweights by request of a project, and the remaining shaking force (lib/mechanism/studies/shaking.hpp).
#include "calculators/mechanism/cycle/rounding.hpp"
#include "calculators/mechanism/input/names.hpp"
#include "calculators/mechanism/input/points.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/mechanism/studies/shaking.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::planar {

namespace {

using account::Cell;
using account::Quantity;
using account::Table;
using mechanism::Counterweight;
using mechanism::ShakingCycle;
using mechanism::Vec;

/// Empty if no counterweights are requested or not every position closes.
struct Balanced {
  std::vector<mechanism::Counterweight> weights;  // in the order of the project
  mechanism::ShakingCycle before, after;          // moments about the global origin
  std::vector<mechanism::Shaking> left;           // with the counterweights, at every position
  bool knows_moment = false;                      // afterwards: every counterweight has a mass or a radius
};

/// Whether a pin or a weld holds this point of the link to the ground.
bool is_fixed(const Mechanism::Input& in, const planar::Counterweight& weight) {
  return std::any_of(in.joints.begin(), in.joints.end(), [&](const planar::Joint& j) {
    if (j.type != planar::Type::revolute && j.type != planar::Type::rigid) return false;
    const auto [first, second] = point_names(j);
    return (j.links.first == weight.link && first == weight.at && j.links.second.view() == "ground") ||
           (j.links.second == weight.link && second == weight.at && j.links.first.view() == "ground");
  });
}

mechanism::CounterweightSite site_of(const Mechanism::Input& in, const planar::Counterweight& weight) {
  const int link = link_index(in, weight.link);
  mechanism::CounterweightSite site{static_cast<std::size_t>(link), vector_of(*find_point(in, link, weight.at)),
                                    in_si(weight.mass)};
  if (is_set(weight.direction)) site.direction = weight.direction;
  return site;
}

/// Where no radius is given any one does for the forces.
double radius_of(const planar::Counterweight& weight) { return is_set(weight.radius) ? in_si(weight.radius) : 1.0; }

bool has_place(const planar::Counterweight& weight) { return is_set(weight.radius) || in_si(weight.mass) > 0.0; }

/// Moments that rounding leaves where all forces go through the origin are none.
ShakingCycle without_rounding(ShakingCycle shaking, const Cycle& cycle) {
  double arm = 0.0;
  for (const mechanism::Position& p : cycle.positions) {
    for (const mechanism::Pose& pose : p.pose) arm = std::max(arm, std::hypot(pose.x, pose.y));
  }
  if (shaking.peak_moment <= 1e-13 * shaking.peak_force * arm) shaking.peak_moment = shaking.rms_moment = 0.0;
  return shaking;
}

mechanism::Model balanced_model(const Mechanism::Input& in, const mechanism::Model& model,
                                const std::vector<Counterweight>& weights) {
  mechanism::Model balanced = model;
  for (std::size_t n = 0; n < weights.size(); ++n) {
    mechanism::Link& link = balanced.links[weights[n].site.link];
    link = mechanism::with_counterweight(link, weights[n], radius_of(in.counterweights[n]));
  }
  return balanced;
}

double moment_of(const Counterweight& w) { return mechanism::length(w.mass_moment); }
double angle_of(const Counterweight& w) { return direction_of(w.mass_moment); }
double mass_of(const planar::Counterweight& weight, const Counterweight& found) {
  if (in_si(weight.mass) > 0.0) return in_si(weight.mass);
  return is_set(weight.radius) ? found.mass_at(in_si(weight.radius)) : none;
}
double arm_of(const planar::Counterweight& weight, const Counterweight& found) {
  if (in_si(weight.mass) > 0.0) return moment_of(found) / in_si(weight.mass);
  return in_si(weight.radius);
}

Message open_somewhere() { return say("the mechanism does not close at every position"); }
Message no_radius() { return say("a counterweight without radius has no moment of inertia: give its radius"); }

/// One number of the balance as a result.
struct Single {
  Declaration what;
  double (*read)(const Balanced&);
  bool needs_place = false;
};
constexpr const char* with_counterweights = "with counterweights";
constexpr std::array frame_rows{
    Single{declare("frame.F_rms", "shaking force, root mean square over the turn", N, with_counterweights,
                   {.detail = true}),
           [](const Balanced& b) { return b.before.rms_force; }},
    Single{declare("frame.F_peak", "its maximum magnitude", N, with_counterweights, {.detail = true}),
           [](const Balanced& b) { return b.before.peak_force; }},
    Single{declare("frame.F_rms_balanced", "residual with counterweights, root mean square", N, with_counterweights,
                   {.detail = true}),
           [](const Balanced& b) { return b.after.rms_force; }},
    Single{declare("frame.F_peak_balanced", "maximum residual magnitude", N, with_counterweights, {.detail = true}),
           [](const Balanced& b) { return b.after.peak_force; }},
    Single{declare("frame.M_peak_balanced", "maximum shaking moment with counterweights, about the global origin", N_m,
                   with_counterweights, {.detail = true}),
           [](const Balanced& b) { return b.after.peak_moment; }, true}};
constexpr Declaration left_over =
    declare("frame.F_balanced", "shaking force with the counterweights", N, with_counterweights, {.detail = true});

struct OfWeight {
  Declaration what;
  double (*read)(const planar::Counterweight&, const Counterweight&);
};
constexpr std::array weight_rows{
    OfWeight{declare("counterweights.NAME.mr", "its mass times its arm", kg_mm, "counterweights"),
             [](const planar::Counterweight&, const Counterweight& w) { return moment_of(w); }},
    OfWeight{declare("counterweights.NAME.angle", "direction of its arm in the link's axes", deg, "counterweights"),
             [](const planar::Counterweight&, const Counterweight& w) { return angle_of(w); }},
    OfWeight{declare("counterweights.NAME.m", "its mass", kg, "counterweights"), &mass_of},
    OfWeight{declare("counterweights.NAME.r", "its arm", mm, "counterweights"), &arm_of}};

Output::Values one(double value, const Message& missing) {
  return std::isnan(value) ? Output::Values({none}, missing) : Output::Values({value});
}

Table weight_table(const Mechanism::Input& in, const Balanced& balanced) {
  Table table{say("Counterweights"),
              {say("name"), say("link"), say("arm from"), say("mass times arm"), say("angle in the link's axes"),
               say("arm"), say("mass")},
              {}};
  for (std::size_t n = 0; n < balanced.weights.size(); ++n) {
    const planar::Counterweight& wanted = in.counterweights[n];
    const Counterweight& found = balanced.weights[n];
    const auto optional = [](double si, const char* unit) {
      return std::isnan(si) ? Cell(std::string("–")) : Cell(Quantity{si, unit});
    };
    table.rows.push_back({std::string(wanted.name.view()), std::string(wanted.link.view()),
                          std::string(wanted.at.view()), Quantity{moment_of(found), "kg*mm"},
                          Quantity{angle_of(found), "deg"}, optional(arm_of(wanted, found), "mm"),
                          optional(mass_of(wanted, found), "kg")});
  }
  return table;
}

Table shaking_table(const Mechanism::Input& in, const Balanced& balanced) {
  const bool rms = in.balance == planar::Balance::rms;
  Table table{rms ? say("Shaking force and moment: counterweights for the smallest root mean square of the force")
                  : say("Shaking force and moment; counterweights for minimum peak force"),
              {say("quantity"), say("without"), say("with counterweights"), say("left")},
              {}};
  const auto add = [&](Message name, double ShakingCycle::*of, const char* unit, bool known) {
    const double before = balanced.before.*of, after = balanced.after.*of;
    table.rows.push_back({std::move(name), Quantity{before, unit},
                          known ? Cell(Quantity{after, unit}) : Cell(say("not available: a radius is missing")),
                          known && before > 0.0 ? Cell(Quantity{after / before, "-", 4}) : Cell(std::string("–"))});
  };
  add(say("force, root mean square"), &ShakingCycle::rms_force, "N", true);
  add(say("force, peak"), &ShakingCycle::peak_force, "N", true);
  add(say("moment about the global origin, root mean square"), &ShakingCycle::rms_moment, "N*m", balanced.knows_moment);
  add(say("moment about the global origin, peak"), &ShakingCycle::peak_moment, "N*m", balanced.knows_moment);
  return table;
}

/// Counterweights that say too little, or where there is nothing to balance.
void check_names_of_balance(NameFaults& faults) {
  const Mechanism::Input& in = faults.input();
  if (in.counterweights.empty()) return;
  if (leaves_out_inertia(in))
    faults.add("counterweights", say("counterweights balance inertia, and the analysis is static"),
               say("leave out analysis = \"static\""));
  if (!is_whole_turn(in))
    faults.add("counterweights", say("counterweights need a full revolution of a crank, and there is none"),
               say("drive by a crank, without 'at' and 'law'"));
  for (const planar::Counterweight& weight : in.counterweights) {
    const std::string path = path_of("counterweights", weight.name);
    if (!faults.require_link(weight.link, path + ".link")) continue;
    const int link = link_index(in, weight.link);
    if (link == mechanism::ground) {
      faults.add(path + ".link", say("a counterweight on the ground does not move"), say("name a moving link"));
      continue;
    }
    if (!faults.require_point(link, weight.at, path + ".at")) continue;
    if (in_si(weight.mass) == 0.0 && !is_fixed(in, weight)) {
      faults.add(path,
                 say("the point '{1}' of '{2}' moves: a counterweight there needs its mass", weight.at.view(),
                     weight.link.view()),
                 say("add mass = \"0.5 kg\", or begin its arm at a pin on the ground"));
    }
    if (in_si(weight.mass) > 0.0 && is_set(weight.radius))
      faults.add(
          path + ".radius",
          say("with a mass the arm of '{1}' follows from the balance, and 'radius' has no effect", weight.name.view()),
          say("leave out 'mass' or 'radius'"));
  }
}

Balanced balance_of(const Mechanism::Input& in, const mechanism::Model& model, const Cycle& cycle) {
  Balanced balanced;
  const bool whole = std::all_of(cycle.closed.begin(), cycle.closed.end(), [](bool closed) { return closed; });
  if (in.counterweights.empty() || !whole) return balanced;
  std::vector<mechanism::CounterweightSite> sites;
  for (const planar::Counterweight& weight : in.counterweights) sites.push_back(site_of(in, weight));
  const bool rms = in.balance == planar::Balance::rms;
  balanced.weights = mechanism::find_counterweights(model, cycle.positions, sites,
                                                    rms ? mechanism::BalanceAim::rms : mechanism::BalanceAim::peak);
  const mechanism::Model with = balanced_model(in, model, balanced.weights);
  balanced.before = without_rounding(mechanism::shaking_over(model, cycle.positions, {}), cycle);
  balanced.after = without_rounding(mechanism::shaking_over(with, cycle.positions, {}), cycle);
  for (const mechanism::Position& at : cycle.positions) balanced.left.push_back(mechanism::shaking(with, at, {}));
  balanced.knows_moment = std::all_of(in.counterweights.begin(), in.counterweights.end(), has_place);
  return balanced;
}

void find(const Solved& solved, Findings& found) { found.add(balance_of(solved.in, solved.model, solved.cycle)); }

Output single(const Declaration& what, const std::string& name) {
  Output one = output(what, name);
  one.is_single = true;
  return one;
}

void add_weight(const planar::Counterweight& wanted, std::size_t index, std::vector<Output>& out) {
  for (const OfWeight& row : weight_rows) {
    out.push_back(single(row.what, text(wanted.name)));
    out.back().read_cycle = [wanted, index, read = row.read](const Solved& solved) {
      const auto& weights = solved.found.of<Balanced>().weights;
      if (weights.empty()) return Output::Values({none}, open_somewhere());
      return one(read(wanted, weights[index]), say("neither its mass nor its radius is given"));
    };
  }
}

void add_balance(const Mechanism::Input& in, const mechanism::Model&, std::vector<Output>& out) {
  if (in.counterweights.empty()) return;
  for (std::size_t n = 0; n < in.counterweights.size(); ++n) add_weight(in.counterweights[n], n, out);
  for (const Single& row : frame_rows) {
    out.push_back(single(row.what, ""));
    out.back().read_cycle = [read = row.read, needs_place = row.needs_place](const Solved& solved) {
      const auto& balanced = solved.found.of<Balanced>();
      if (balanced.weights.empty()) return Output::Values({none}, open_somewhere());
      if (needs_place && !balanced.knows_moment) return Output::Values({none}, no_radius());
      return Output::Values({read(balanced)});
    };
  }
  out.push_back(output(left_over, ""));
  out.back().read_cycle = [](const Solved& solved) {
    const auto& left = solved.found.of<Balanced>().left;
    std::vector<double> values(solved.cycle.positions.size(), none);
    for (std::size_t k = 0; k < left.size(); ++k) values[k] = mechanism::length(left[k].force);
    return Output::Values(std::move(values), left.empty() ? open_somewhere() : Message{});
  };
}

void list_balance(std::vector<ResultPattern>& patterns) {
  for (const OfWeight& row : weight_rows) patterns.push_back(row.what.pattern);
  for (const Single& row : frame_rows) patterns.push_back(row.what.pattern);
  patterns.push_back(left_over.pattern);
}

void show_balance(const Solved& solved, const Results&, std::vector<account::Block>& blocks) {
  const auto& balanced = solved.found.of<Balanced>();
  if (balanced.weights.empty()) return;
  blocks.emplace_back(weight_table(solved.in, balanced));
  blocks.emplace_back(shaking_table(solved.in, balanced));
}

}  // namespace

constinit const Aspect aspects::balance{.check_names = &check_names_of_balance,
                                        .list = &list_balance,
                                        .add_outputs = &add_balance,
                                        .find = &find,
                                        .show = &show_balance};

}  // namespace loadpath::planar
