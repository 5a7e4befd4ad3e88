#include "calculators/mechanism/aspects/efficiency.hpp"

#include "lib/quantity/units.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::planar {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

using account::Cell;
using account::Quantity;

/// Means over the turn, W.
class Means {
 public:
  explicit Means(const account::Account& account) : account_(account) {}

  [[nodiscard]] const account::Account& account() const { return account_; }

  [[nodiscard]] const account::Entry* find(const std::string& path) const {
    for (const account::Entry& e : account_.results) {
      if (e.path == path) return &e;
    }
    return nullptr;
  }
  /// What is small against the largest value is what rounding has left of a zero.
  [[nodiscard]] double of(const std::string& path) const {
    const account::Entry* entry = find(path);
    if (entry == nullptr) return 0.0;
    const double average = mean(entry->value);
    return std::abs(average) < 1e-9 * std::abs(largest(entry->value).value) ? 0.0 : average;
  }

 private:
  const account::Account& account_;
};

Cell share(double part, double whole) { return Quantity{part / whole, "-", 4}; }

/// Useful work over the work of the drive; of a machine that is driven by its load, the other way round.
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

Efficiency efficiency_of(const Means& means) {
  const account::Entry* drive = means.find("drive.P");
  if (drive == nullptr || !drive->value.is_series() || !drive->value.signature.axis->cyclic())
    return undefined(say("the positions are no whole turn of the crank"));
  for (const account::Entry& e : means.account().results) {
    if (e.path.starts_with("cylinders.")) return undefined(say("several drives share the work"));
  }
  if (means.find("drive.P_useful") == nullptr) return undefined(say("no load is marked useful"));
  return efficiency(means.of("drive.P"), means.of("drive.P_useful"));
}

std::vector<std::string> results_read() { return {"drive.P", "drive.P_useful"}; }

constexpr ResultPattern forward_pattern{"drive.efficiency", "-", "useful work over the work of the drive, over a turn",
                                        "with a crank, and friction or useful loads"};
constexpr ResultPattern back_pattern{"drive.efficiency_back", "-",
                                     "driven by the load: work that the drive takes over the work of the useful loads",
                                     "with a crank, and friction or useful loads"};

}  // namespace

std::optional<account::Table> efficiency_table(const account::Account& account, const Axis* axis) {
  const Means means(account);
  const bool friction = means.find("drive.P_loss") != nullptr, use = means.find("drive.P_useful") != nullptr;
  if (axis == nullptr || !axis->cyclic() || (!friction && !use) || means.find("drive.P") == nullptr) return {};
  account::Table table{say("Power over the turn"), {say("quantity"), say("mean")}, {}};
  const double drive = means.of("drive.P"), lost = means.of("drive.P_loss"), useful = means.of("drive.P_useful");
  table.rows.push_back({say("power of the drive"), Quantity{drive, "W"}});
  if (friction) {
    for (const account::Entry& e : account.results) {
      if (e.path.starts_with("joints.") && e.path.ends_with(".P_loss"))
        table.rows.push_back({say("{1}", e.path), Quantity{means.of(e.path), "W"}});
    }
    table.rows.push_back({say("friction in all joints"), Quantity{lost, "W"}});
    if (drive > 0.0) table.rows.push_back({say("share of friction in the power of the drive"), share(lost, drive)});
  }
  if (use) {
    table.rows.push_back({say("power against the useful loads"), Quantity{useful, "W"}});
    const Efficiency found = efficiency_of(means);
    const bool back = !std::isnan(found.back);
    const Cell value = back                        ? Cell(Quantity{found.back, "-", 4})
                       : std::isnan(found.forward) ? Cell(say("not available: {1}", found.why_not_forward))
                                                   : Cell(Quantity{found.forward, "-", 4});
    table.rows.push_back(
        {back ? say("efficiency of the reversed flow, from the loads to the drive") : say("efficiency"), value});
  }
  return table;
}

void add_efficiency_outputs(const Mechanism::Input& in, const mechanism::Model& model, std::vector<Output>& out) {
  const bool friction =
      std::any_of(model.joints.begin(), model.joints.end(), [](const auto& j) { return j.friction.any(); });
  const bool use = std::any_of(in.loads.begin(), in.loads.end(),
                               [](const auto& load) { return load.useful == planar::Useful::yes; });
  if (in.crank.joint.empty() || (!friction && !use)) return;
  const auto add = [&](const ResultPattern& pattern, double Efficiency::*value, Message Efficiency::*reason) {
    const auto read = [value, reason](const account::Account& account) {
      const Efficiency found = efficiency_of(Means(account));
      return Output::Values({found.*value}, found.*reason);
    };
    out.push_back({pattern.path, pattern.doc, pattern.unit, ratio.dimension(), {}, {}, true, read, results_read()});
  };
  add(forward_pattern, &Efficiency::forward, &Efficiency::why_not_forward);
  add(back_pattern, &Efficiency::back, &Efficiency::why_not_back);
}

void list_efficiency_patterns(std::vector<ResultPattern>& patterns) {
  patterns.push_back(forward_pattern);
  patterns.push_back(back_pattern);
}

}  // namespace loadpath::planar
