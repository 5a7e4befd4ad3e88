// Balance of the drive power over a full revolution: friction, useful work, efficiency.
#include "calculators/mechanism/results/aspect.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::planar {

namespace {

using account::Cell;
using account::Quantity;

/// A value small against the largest is a rounded zero.
double mean_of(const account::Entry* entry) {
  if (entry == nullptr) return 0.0;
  const double average = mean(entry->value);
  return std::abs(average) < 1e-9 * std::abs(largest(entry->value).value) ? 0.0 : average;
}

Cell share(double part, double whole) { return Quantity{part / whole, "-", 4}; }

/// Useful work over the work of the drive; inverse for a machine driven by its load.
struct Efficiency {
  double forward = none, back = none;
  Message why_not_forward, why_not_back;
};

Efficiency undefined(const Message& reason) { return {none, none, reason, reason}; }

Efficiency efficiency(double drive, double useful) {
  if (std::isnan(drive) || std::isnan(useful)) return undefined(say("some positions have no forces"));
  if (drive == 0.0 || useful == 0.0) return undefined(say("no mean power"));
  if (drive > 0.0 && useful > 0.0)
    return {useful / drive, none, {}, say("the drive moves the load, see drive.efficiency")};
  if (drive < 0.0 && useful < 0.0)
    return {none, drive / useful, say("the load moves the drive, see drive.efficiency_back"), {}};
  return undefined(drive > 0.0 ? say("drive and useful loads both supply power")
                               : say("drive and useful loads both take power"));
}

Efficiency efficiency_of(const Results& results) {
  const account::Entry *const drive = results.find(Kind::drive_power), *const use = results.find(Kind::useful_power);
  if (drive == nullptr || !drive->value.is_series() || !drive->value.signature.axis->cyclic())
    return undefined(say("the positions do not cover a full revolution of the crank"));
  if (results.find(Kind::cylinder_force) != nullptr) return undefined(say("several drives share the work"));
  if (use == nullptr) return undefined(say("no load is marked useful"));
  return efficiency(mean_of(drive), mean_of(use));
}

constexpr const char* of_losses = "with a crank, and friction or useful loads";
constexpr Declaration forward = declare("drive.efficiency", "useful work over the work of the drive, over a turn",
                                        ratio, of_losses, {.kind = Kind::efficiency, .tabled = Tabled::always});
constexpr Declaration back =
    declare("drive.efficiency_back", "driven by the load: work that the drive takes over the work of the useful loads",
            ratio, of_losses, {.kind = Kind::efficiency_back, .tabled = Tabled::always});

/// For a mechanism with a crank and friction or useful loads. If it is not defined there is a reason.
void add_efficiency(const Mechanism::Input& in, const mechanism::Model& model, std::vector<Output>& out) {
  const bool friction =
      std::any_of(model.joints.begin(), model.joints.end(), [](const auto& j) { return j.friction.any(); });
  const bool use = std::any_of(in.loads.begin(), in.loads.end(),
                               [](const auto& load) { return load.useful == planar::Useful::yes; });
  if (in.crank.joint.empty() || (!friction && !use)) return;
  const auto add_one = [&](const Declaration& what, double Efficiency::*value, Message Efficiency::*reason) {
    out.push_back(output(what, ""));
    out.back().is_single = true;
    out.back().read_results = [value, reason](const Results& results) {
      const Efficiency found = efficiency_of(results);
      return Output::Values({found.*value}, found.*reason);
    };
    out.back().results_read = {Kind::drive_power, Kind::useful_power};
  };
  add_one(forward, &Efficiency::forward, &Efficiency::why_not_forward);
  add_one(back, &Efficiency::back, &Efficiency::why_not_back);
}

void list_efficiency(std::vector<ResultPattern>& patterns) {
  patterns.push_back(forward.pattern);
  patterns.push_back(back.pattern);
}

constexpr std::array cited{Citation{"Inventor",
                                    [](const auto& in, const auto&) {
                                      return std::any_of(in.joints.begin(), in.joints.end(), [](const auto& j) {
                                        return j.efficiency != 1.0 || is_set(j.efficiency_back);
                                      });
                                    }},
                           Citation{"NovaSolver", [](const auto& in, const auto&) {
                                      return std::any_of(in.joints.begin(), in.joints.end(),
                                                         [](const auto& j) { return is_set(j.efficiency_back); });
                                    }}};

void add_losses(const Results& results, account::Table& table) {
  for (const auto& line : results) {
    if (line.kind() != Kind::joint_loss) continue;
    table.rows.push_back({say("{1}", line.entry->path), Quantity{mean_of(line.entry), "W"}});
  }
}

/// None for a mechanism without friction and useful loads, or without a full revolution: a mean has no meaning then.
void show_efficiency(const Solved& solved, const Results& results, std::vector<account::Block>& blocks) {
  const account::Entry* const power = results.find(Kind::drive_power);
  const account::Entry* const friction = results.find(Kind::friction_power);
  const account::Entry* const use = results.find(Kind::useful_power);
  const bool turns = solved.axis != nullptr && solved.axis->cyclic();
  if (!turns || (friction == nullptr && use == nullptr) || power == nullptr) return;
  account::Table table{say("Power over the revolution"), {say("quantity"), say("mean")}, {}};
  const double drive = mean_of(power), lost = mean_of(friction);
  table.rows.push_back({say("power of the drive"), Quantity{drive, "W"}});
  if (friction != nullptr) {
    add_losses(results, table);
    table.rows.push_back({say("friction in all joints"), Quantity{lost, "W"}});
    if (drive > 0.0) table.rows.push_back({say("share of friction in the power of the drive"), share(lost, drive)});
  }
  if (use != nullptr) {
    table.rows.push_back({say("power against the useful loads"), Quantity{mean_of(use), "W"}});
    const Efficiency found = efficiency_of(results);
    const bool reversed = !std::isnan(found.back);
    const Cell value = reversed                    ? Cell(Quantity{found.back, "-", 4})
                       : std::isnan(found.forward) ? Cell(say("not available: {1}", found.why_not_forward))
                                                   : Cell(Quantity{found.forward, "-", 4});
    table.rows.push_back(
        {reversed ? say("efficiency of the reversed flow, from the loads to the drive") : say("efficiency"), value});
  }
  blocks.emplace_back(std::move(table));
}

}  // namespace

/// The table precedes the notes on rest, the results follow it.
constinit const Aspect aspects::power{.show = &show_efficiency};

constinit const Aspect aspects::efficiency{
    .list = &list_efficiency, .add_outputs = &add_efficiency, .citations = cited};

}  // namespace loadpath::planar
