#include "calculators/machine/motion/motion.hpp"
#include "calculators/machine/motion/run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace loadpath::machine {

namespace {

figure::Plot plot_over(figure::Scale across, figure::Scale up, std::vector<figure::Curve> curves) {
  figure::Plot plot(std::move(across), std::move(up));
  plot.curves = std::move(curves);
  return plot;
}

/// At most so many points of a curve, evenly.
figure::Curve thinned(const std::vector<RunPoint>& points, double end) {
  constexpr std::size_t most = 1500;
  figure::Curve curve{"n", {0.0}, {0.0}};
  const auto last = std::find_if(points.begin(), points.end(), [&](const RunPoint& p) { return p.t > end; });
  const auto count = static_cast<std::size_t>(last - points.begin());
  const std::size_t each = count / most + 1;
  for (std::size_t k = 0; k < count; k += each) {
    curve.x.push_back(points[k].t);
    curve.y.push_back(points[k].omega);
  }
  return curve;
}

}  // namespace

std::vector<figure::Figure> Motion::drawn(const Input& in, const DrivenMachine& machine) {
  const MachineRun run = run_up(machine, true);
  if (run.end != MachineRun::End::steady) return {};
  figure::Curve n{"n", {}, {}}, M{"M", {}, {}}, drive{"motor", {}, {}}, load{"load", {}, {}};
  const auto add = [](figure::Curve& curve, double x, double y) {
    curve.x.push_back(x);
    curve.y.push_back(y);
  };
  for (std::size_t k = 0; k < machine.cells.size(); ++k) {
    const PeriodCell& cell = machine.cells[k];
    for (const double u : {0.0, 1.0}) {
      const double phi = in.phi_0 + cell.from + u * cell.width;
      add(load, phi, cell.M.at(u));
      if (u > 0.0 && k + 1 < machine.cells.size()) continue;
      const double omega = speed_of(run.cycle[u > 0.0 ? k + 1 : k].E, cell.J.at(u));
      add(n, phi, omega);
      add(M, phi, machine.motor_at(omega));
      add(drive, phi, machine.drive(omega));
    }
  }
  const figure::Scale crank{"phi", "crank angle", "deg"}, speed{"n", "speed of the crank", "rpm"};
  std::vector<figure::Figure> figures;
  figures.push_back({"speed", "Speed of the crank in the steady cycle", plot_over(crank, speed, {std::move(n)})});
  figures.push_back({"torque", "Torque of the motor in the steady cycle",
                     plot_over(crank, {"M", "torque of the motor", "N*m"}, {std::move(M)})});
  figures.push_back({"moments", "Moments of motor and load at the crank",
                     plot_over(crank, {"M", "moment at the crank", "N*m"}, {std::move(drive), std::move(load)})});
  if (std::isfinite(run.t))
    figures.push_back(
        {"run-up", "Run-up from rest", plot_over({"t", "time", "s"}, speed, {thinned(run.start, 1.2 * run.t)})});
  return figures;
}

}  // namespace loadpath::machine
