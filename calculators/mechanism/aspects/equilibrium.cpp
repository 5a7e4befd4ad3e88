// The positions of equilibrium: where they are, whether the mechanism returns to them, how stiffly.
#include "calculators/mechanism/cycle/equilibria.hpp"
#include "calculators/mechanism/results/aspect.hpp"

#include <algorithm>

namespace loadpath::planar {

namespace {

using account::Quantity;

constexpr const char* by_crank = "with analysis = \"equilibrium\", by a crank";
constexpr const char* by_cylinder = "with analysis = \"equilibrium\", by a cylinder";

/// Of a drive that turns, and of one that slides.
struct Named {
  Declaration place, stiffness, stable;
};
constexpr Named turning{
    declare("equilibrium.phi", "crank angle of the position of equilibrium", deg, by_crank),
    declare("equilibrium.k", "stiffness of the equilibrium: moment on the crank per angle; positive where stable",
            N_m_per_rad, by_crank, {.tabled = Tabled::always}),
    declare("equilibrium.stable", "crank angle of the stable position of equilibrium, of several the first", deg,
            by_crank, {.missing = "no position of equilibrium is stable"})};
constexpr Named sliding{
    declare("equilibrium.s", "position of the cylinder in equilibrium", mm, by_cylinder),
    declare("equilibrium.k", "stiffness of the equilibrium: force of the cylinder per length; positive where stable",
            N_per_mm, by_cylinder, {.tabled = Tabled::always}),
    declare("equilibrium.stable", "position of the cylinder in the stable equilibrium, of several the first", mm,
            by_cylinder, {.missing = "no position of equilibrium is stable"})};

bool is_rotary(const mechanism::Model& model) {
  return !model.drivers.empty() && model.drivers.front().kind == mechanism::Driver::Kind::rotary;
}

/// Where the axis counts it.
double place_at(const Solved& solved, std::size_t k) { return solved.axis == nullptr ? none : solved.axis->at[k]; }

Output::Values places(const Solved& solved) {
  std::vector<double> values;
  for (std::size_t k = 0; k < solved.cycle.positions.size(); ++k) values.push_back(place_at(solved, k));
  return values;
}

Output::Values stiffnesses(const Solved& solved) {
  std::vector<double> values(solved.cycle.positions.size(), none);
  const auto& found = solved.cycle.equilibria.found;
  for (std::size_t k = 0; k < std::min(found.size(), values.size()); ++k) values[k] = found[k].stiffness;
  return values;
}

Output::Values first_stable(const Solved& solved) {
  const auto& found = solved.cycle.equilibria.found;
  const auto stable =
      std::find_if(found.begin(), found.end(), [](const auto& e) { return e.stability == Stability::stable; });
  if (stable == found.end()) return {{none}, say("no position of equilibrium is stable")};
  return {{place_at(solved, static_cast<std::size_t>(stable - found.begin()))}};
}

void list_equilibrium(std::vector<ResultPattern>& patterns) {
  for (const Named& named : {turning, sliding}) {
    for (const Declaration& d : {named.place, named.stiffness, named.stable}) patterns.push_back(d.pattern);
  }
}

void add_equilibrium(const Mechanism::Input& in, const mechanism::Model& model, std::vector<Output>& out) {
  if (!stays_in_equilibrium(in)) return;
  const Named& named = is_rotary(model) ? turning : sliding;
  const auto add = [&](const Declaration& what, Output::Values (*read)(const Solved&)) {
    out.push_back(output(what, ""));
    out.back().read_cycle = read;
  };
  add(named.place, &places);
  add(named.stiffness, &stiffnesses);
  add(named.stable, &first_stable);
  out.back().is_single = true;
}

Message words_of(Stability stability) {
  switch (stability) {
    case Stability::stable:
      return say("stable");
    case Stability::unstable:
      return say("unstable");
    case Stability::one_sided:
      return say("unstable to one side");
    case Stability::neutral:
      return say("neutral");
  }
  return {};
}

void show_equilibrium(const Solved& solved, const Results&, std::vector<account::Block>& blocks) {
  if (!stays_in_equilibrium(solved.in) || solved.axis == nullptr) return;
  const Named& named = is_rotary(solved.model) ? turning : sliding;
  account::Table table{say("Positions of equilibrium"), {say("at"), say("equilibrium"), say("stiffness")}, {}};
  const auto& found = solved.cycle.equilibria.found;
  for (std::size_t k = 0; k < std::min(found.size(), solved.axis->at.size()); ++k) {
    table.rows.push_back({Quantity{solved.axis->at[k], solved.axis->unit}, words_of(found[k].stability),
                          Quantity{found[k].stiffness, named.stiffness.pattern.unit}});
  }
  blocks.emplace_back(std::move(table));
}

void check(const Mechanism::Input& in, const mechanism::Model& model, std::vector<FieldFault>& faults) {
  append(check_equilibrium(in, model), faults);
}

}  // namespace

constinit const Aspect aspects::equilibrium{
    .check_values = &check, .list = &list_equilibrium, .add_outputs = &add_equilibrium, .show = &show_equilibrium};

}  // namespace loadpath::planar
