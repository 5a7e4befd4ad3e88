// The moment, force and power of the drives.
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/rows.hpp"

#include <array>

namespace loadpath::planar {

namespace {

using mechanism::Position;

struct Driven {
  std::string name;
  std::size_t index;
  mechanism::Driver driver;

  static bool is_rotary(const Driven& d) { return d.driver.kind == mechanism::Driver::Kind::rotary; }
  static bool is_linear(const Driven& d) { return !is_rotary(d); }
  [[nodiscard]] double speed(const Position& p) const {
    const auto of = [&](int link) {
      return link == mechanism::ground ? mechanism::Pose{} : p.velocity[static_cast<std::size_t>(link)];
    };
    return of(driver.i).phi - of(driver.j).phi;
  }
};

constexpr std::array drive_rows{
    row<Driven>(
        "drive.M", "driving torque on the driven link, counter-clockwise positive", N_m,
        {.kind = Kind::drive_moment, .tabled = Tabled::always, .is_load = true, .loads_crank = true},
        [](const Driven& d, const Position& p) { return p.effort[d.index]; }, &Driven::is_rotary, "with a crank"),
    row<Driven>(
        "drive.P", "power of the drive", W, {.kind = Kind::drive_power, .tabled = Tabled::always, .loads_crank = true},
        [](const Driven& d, const Position& p) { return p.effort[d.index] * d.speed(p); }, &Driven::is_rotary,
        "with a crank"),
    row<Driven>(
        "cylinders.NAME.F",
        "force of the drive on the first link, along the guide; between two points: pushing them apart", N,
        {.kind = Kind::cylinder_force, .tabled = Tabled::always, .is_load = true},
        [](const Driven& d, const Position& p) { return p.effort[d.index]; }, &Driven::is_linear)};

void list_drives(std::vector<ResultPattern>& patterns) { list_patterns(drive_rows, patterns); }

void add_drives(const Mechanism::Input&, const mechanism::Model& model, std::vector<Output>& out) {
  for (std::size_t d = 0; d < model.drivers.size(); ++d)
    add_outputs(Driven{model.drivers[d].name, d, model.drivers[d]}, drive_rows, out);
}

}  // namespace

constinit const Aspect aspects::drives{.list = &list_drives, .add_outputs = &add_drives, .reads_forces_alone = true};

}  // namespace loadpath::planar
