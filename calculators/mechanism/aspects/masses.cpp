// Masses of links reduced to points, by request of a project.
#include "calculators/mechanism/input/names.hpp"
#include "calculators/mechanism/input/point_masses.hpp"
#include "calculators/mechanism/results/aspect.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>

namespace loadpath::planar {

namespace {

using mechanism::PointMass;

/// Points that do not exist or are not requested.
void check_points(const planar::Link& link, NameFaults& faults) {
  const std::string path = path_of("links", link.name, "mass_points");
  const bool wanted = link.masses != Masses::as_given, given = !link.mass_points.first.empty();
  if (wanted && !given) {
    faults.add(path_of("links", link.name),
               say("the mass of '{1}' is reduced to points, and they are not named", link.name.view()),
               say("add mass_points = [\"A\", \"B\"]: two of its points, on a line with S"));
  }
  if (given && !wanted) {
    faults.add(path, say("'mass_points' has no effect: the mass of '{1}' is as given", link.name.view()),
               say("add masses = \"two_points\" or \"three_points\", or leave them out"));
  }
  if (!given) return;
  const int index = link_index(faults.input(), link.name);
  const bool first = faults.require_point(index, link.mass_points.first, path + ".first");
  const bool second = faults.require_point(index, link.mass_points.second, path + ".second");
  if (first && second && link.mass_points.first == link.mass_points.second)
    faults.add(path,
               say("a mass is reduced to two different points, and both are '{1}'", text(link.mass_points.first)));
}

void check_names_of_masses(NameFaults& faults) {
  for (const planar::Link& link : faults.input().links) check_points(link, faults);
}

/// Points that a mass cannot be reduced to.
void check_values(const Mechanism::Input& in, const mechanism::Model&, std::vector<FieldFault>& faults) {
  for (const planar::Link& l : in.links) {
    if (l.masses == Masses::as_given) continue;
    const mechanism::Link link = own_of(l);
    const std::string path = path_of("links", l.name, "mass_points"), a = text(l.mass_points.first),
                      b = text(l.mass_points.second), name = text(l.name);
    if (!(link.mass > 0.0)) {
      faults.push_back({path, say("the link '{1}' has no mass to reduce to points", name), say("give its mass")});
      continue;
    }
    const auto masses = masses_of(l, link);
    const bool outside = std::any_of(masses.begin(), masses.begin() + std::min<std::ptrdiff_t>(2, std::ssize(masses)),
                                     [](const PointMass& part) { return part.mass < 0.0; });
    if (!masses.empty() && !outside) continue;
    faults.push_back({path, say("the mass centre of '{1}' does not lie between '{2}' and '{3}'", name, a, b),
                      say("name two points with S on the line between them")});
  }
}

/// The point masses of all links that are reduced.
void show_input(const Mechanism::Input& in, std::vector<account::Block>& blocks) {
  using account::Cell;
  using account::Quantity;
  account::Table table{say("Masses reduced to points"),
                       {say("link"), say("replacement"), say("mass in the first point"), say("in the second"),
                        say("in S"), say("own moment of inertia"), say("of the points")},
                       {}};
  for (const planar::Link& l : in.links) {
    if (l.masses == Masses::as_given) continue;
    const mechanism::Link link = own_of(l);
    const auto masses = masses_of(l, link);
    const bool is_static = masses.size() == 2;
    const auto cell = [&](const Name& at, std::size_t k) {
      return Cell(text(at) + ": " + format_quantity(masses[k].mass, "kg", 5));
    };
    table.rows.push_back(
        {text(l.name), is_static ? say("static: the moment of inertia is not kept") : say("dynamic: it is kept"),
         cell(l.mass_points.first, 0), cell(l.mass_points.second, 1),
         is_static ? Cell(std::string("–")) : Cell(Quantity{masses[2].mass, "kg"}), Quantity{link.inertia, "kg*m^2"},
         Quantity{link.inertia - mechanism::missing_inertia(link, masses), "kg*m^2"}});
  }
  if (!table.rows.empty()) blocks.emplace_back(std::move(table));
}

}  // namespace

constinit const Aspect aspects::masses{
    .check_names = &check_names_of_masses, .check_values = &check_values, .show_input = &show_input};

}  // namespace loadpath::planar
