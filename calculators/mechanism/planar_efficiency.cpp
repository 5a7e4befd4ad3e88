#include "calculators/mechanism/planar_efficiency.hpp"

#include <cmath>

namespace loadpath {

namespace {

using report::Cell;
using report::Quantity;

/// Means over the turn, W.
class Means {
 public:
  explicit Means(const project::Account& account) : account_(account) {}

  [[nodiscard]] const project::Entry* find(const std::string& path) const {
    for (const project::Entry& e : account_.results) {
      if (e.path == path) return &e;
    }
    return nullptr;
  }
  /// What is small against the largest value is what rounding has left of a zero.
  [[nodiscard]] double of(const std::string& path) const {
    const project::Entry* entry = find(path);
    if (entry == nullptr) return 0.0;
    const double average = mean(entry->value);
    return std::abs(average) < 1e-9 * std::abs(largest(entry->value).value) ? 0.0 : average;
  }

 private:
  const project::Account& account_;
};

Cell share(double part, double whole) { return Quantity{part / whole, "-", 4}; }

/// Useful work over the work of the drive; of a machine that is driven by its load, the other way round.
Cell efficiency(double drive, double useful) {
  if (std::isnan(drive) || std::isnan(useful)) return say("not available: some positions have no forces");
  if (drive == 0.0 || useful == 0.0) return say("not defined: no mean power");
  if (drive > 0.0 && useful > 0.0) return share(useful, drive);
  if (drive < 0.0 && useful < 0.0) return share(drive, useful);
  return say("not defined: drive and useful loads both take power");
}

}  // namespace

std::optional<report::Table> efficiency_table(const project::Account& account, const Axis* axis) {
  const Means means(account);
  const bool friction = means.find("drive.P_loss") != nullptr, use = means.find("drive.P_useful") != nullptr;
  if (axis == nullptr || !axis->cyclic() || (!friction && !use) || means.find("drive.P") == nullptr) return {};
  report::Table table{say("Power over the turn"), {say("quantity"), say("mean")}, {}};
  const double drive = means.of("drive.P"), lost = means.of("drive.P_loss"), useful = means.of("drive.P_useful");
  table.rows.push_back({say("power of the drive"), Quantity{drive, "W"}});
  if (friction) {
    for (const project::Entry& e : account.results) {
      if (e.path.starts_with("joints.") && e.path.ends_with(".P_loss"))
        table.rows.push_back({say("{1}", e.path), Quantity{means.of(e.path), "W"}});
    }
    table.rows.push_back({say("friction in all joints"), Quantity{lost, "W"}});
    if (drive > 0.0) table.rows.push_back({say("share of friction in the power of the drive"), share(lost, drive)});
  }
  if (use) {
    table.rows.push_back({say("power against the useful loads"), Quantity{useful, "W"}});
    const bool back = drive < 0.0 && useful < 0.0;
    table.rows.push_back(
        {back ? say("efficiency of the reversed flow, from the loads to the drive") : say("efficiency"),
         efficiency(drive, useful)});
  }
  return table;
}

}  // namespace loadpath
