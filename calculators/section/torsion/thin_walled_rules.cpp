// Rules of section.thin_walled beyond the bounds of its fields.
#include "calculators/section/contour_sides.hpp"
#include "calculators/section/torsion/cells.hpp"
#include "calculators/section/torsion/thin_walled.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace loadpath::section {

namespace {

using Input = ThinWalled::Input;
using Wall = ThinWalled::Wall;
using Cell = ThinWalled::Cell;
using Corners = ThinWalled::Corners;

bool has_size(const Wall& w) {
  return is_set(w.l) ? w.points.empty() : w.points.size() >= 2 && in_si(length_of(w)) > 0.0;
}
bool has_size(const Cell& c) {
  return is_set(c.A) ? c.points.empty() : c.points.size() >= 3 && in_si(area_of(c)) > 0.0;
}

bool is_known(const Input& in, const Wall& w) {
  const std::size_t outside = in.cells.size();
  const std::size_t cell = cell_of(in, w.cell), other = cell_of(in, w.beside);
  if (is_free(w)) return w.beside.empty();
  return cell != outside && (w.beside.empty() || (other != outside && other != cell));
}

/// Cells connected to the outside through walls; nothing else fixes their flow.
std::array<bool, most_cells + 1> reached_cells(const Input& in) {
  std::array<bool, most_cells + 1> reached{};
  reached[in.cells.size()] = true;
  for (std::size_t round = 0; round < in.cells.size(); ++round) {
    for (const Wall& w : in.walls) {
      const std::size_t a = cell_of(in, w.cell), b = cell_of(in, w.beside);
      if (!is_free(w) && (reached[a] || reached[b])) reached[a] = reached[b] = true;
    }
  }
  return reached;
}

/// The first cell that violates the condition; one past the last if none does.
template <class Holds>
std::size_t first_without(const Input& in, const Holds& holds) {
  std::size_t i = 0;
  while (i < in.cells.size() && holds(i)) ++i;
  return i;
}

bool sizes_and_names(const Input& in) {
  return ThinWalled::sizes_given(in) && ThinWalled::cells_once(in) && ThinWalled::cells_known(in);
}

Area largest_area(const Input& in, std::size_t cell) {
  const Length U = perimeter_of(in, cell);
  return U * U / (4.0 * pi);
}

bool area_fits(const Input& in, std::size_t cell) {
  constexpr double rounding = 5e-3;  // tolerance of printed sizes
  return area_of(in.cells[cell]) <= (1.0 + rounding) * largest_area(in, cell);
}

Length outline_of(const Cell& cell) {
  Wall around;
  around.points = cell.points;
  const auto &first = cell.points.front(), &last = cell.points.back();
  return length_of(around) + from_si<Length>(std::hypot(in_si(last.y - first.y), in_si(last.z - first.z)));
}

/// A side of one outline that meets another of it, or two outlines that have a place in common, but for a fiftieth of
/// their size; equal where there is no such.
std::pair<std::size_t, std::size_t> doubled(const Input& in) {
  for (std::size_t i = 0; i < in.cells.size(); ++i) {
    const Corners& own = in.cells[i].points;
    for (std::size_t k = 0; k < i; ++k) {
      const Corners& other = in.cells[k].points;
      if (own.empty() || other.empty()) continue;
      const double little = 0.02 * std::sqrt(in_si(min(area_of(in.cells[i]), area_of(in.cells[k]))));
      if (sides_cross(own, other, little) || reaches_into(own, other, little) || reaches_into(other, own, little))
        return {k, i};
    }
  }
  return {};
}

/// The first outline that crosses itself; that behind the last where none does.
std::size_t crossed(const Input& in) {
  return first_without(
      in, [&](std::size_t i) { return in.cells[i].points.empty() || !crossing_of(in.cells[i].points).found; });
}

}  // namespace

bool ThinWalled::outlines_apart(const Input& in) {
  if (!sizes_and_names(in)) return true;  // another rule says it
  const auto [first, second] = doubled(in);
  return first == second && crossed(in) == in.cells.size();
}

FieldFault ThinWalled::covered_twice(const Input& in) {
  const auto named = [&](std::size_t i) { return std::string(in.cells[i].name.view()); };
  const std::size_t own = crossed(in);
  if (own != in.cells.size())
    return {"cells[" + std::to_string(own + 1) + "].points", say("the outline of cell '{1}' meets itself", named(own)),
            say("give its corners in order around it")};
  const auto [first, second] = doubled(in);
  return {"cells[" + std::to_string(second + 1) + "].points",
          say("the cells '{1}' and '{2}' overlap", named(first), named(second)),
          say("give the corners of all cells in one system of axes, or their areas A")};
}

bool ThinWalled::sizes_given(const Input& in) {
  return std::all_of(in.walls.begin(), in.walls.end(), [](const Wall& w) { return has_size(w); }) &&
         std::all_of(in.cells.begin(), in.cells.end(), [](const Cell& c) { return has_size(c); });
}

bool ThinWalled::cells_once(const Input& in) {
  return first_without(in, [&](std::size_t i) {
           return !in.cells[i].name.empty() && cell_of(in, in.cells[i].name) == i;
         }) == in.cells.size();
}

bool ThinWalled::cells_known(const Input& in) {
  return std::all_of(in.walls.begin(), in.walls.end(), [&](const Wall& w) { return is_known(in, w); });
}

FieldFault ThinWalled::unknown_cell(const Input& in) {
  const auto wall = std::find_if(in.walls.begin(), in.walls.end(), [&](const Wall& w) { return !is_known(in, w); });
  if (wall == in.walls.end()) return {};
  const std::string path = "walls[" + std::to_string(wall - in.walls.begin() + 1) + "]";
  if (is_free(*wall)) return {path + ".beside", say("the wall has an adjacent cell, but bounds none"), {}};
  if (wall->beside == wall->cell) return {path + ".beside", say("the wall has one cell on both sides"), {}};
  const bool first = cell_of(in, wall->cell) == in.cells.size();
  return {path + (first ? ".cell" : ".beside"),
          say("unknown cell '{1}'", std::string((first ? wall->cell : wall->beside).view())),
          {}};
}

bool ThinWalled::cells_close(const Input& in) {
  if (!sizes_and_names(in)) return true;  // another rule says it
  const auto reached = reached_cells(in);
  return first_without(in, [&](std::size_t i) { return reached[i]; }) == in.cells.size();
}

FieldFault ThinWalled::open_cell(const Input& in) {
  const auto reached = reached_cells(in);
  const std::size_t i = first_without(in, [&](std::size_t k) { return reached[k]; });
  return {"cells[" + std::to_string(i + 1) + "]",
          say("cell '{1}' has no wall to the outside, nor has a cell that it is joined to",
              std::string(in.cells[i].name.view())),
          say("give all walls around a cell: cell = its name; 'beside' = the cell on the other side, if any")};
}

/// The one cell next to another along all of its walls; none if there is no such cell.
static std::size_t around(const Input& in, std::size_t i) {
  const std::size_t none = in.cells.size();
  std::size_t found = none;
  for (const Wall& w : in.walls) {
    const std::size_t a = cell_of(in, w.cell), b = cell_of(in, w.beside);
    if (is_free(w) || (a != i && b != i)) continue;
    const std::size_t other = a == i ? b : a;
    if (other == none || (found != none && found != other)) return none;
    found = other;
  }
  return found;
}

bool ThinWalled::no_islands(const Input& in) { return island(in).path.empty(); }

FieldFault ThinWalled::island(const Input& in) {
  if (!sizes_and_names(in)) return {};  // another rule says it
  const std::size_t i = first_without(in, [&](std::size_t k) { return around(in, k) == in.cells.size(); });
  if (i == in.cells.size()) return {};
  return {"cells[" + std::to_string(i + 1) + "]",
          say("cell '{1}' lies within cell '{2}'", std::string(in.cells[i].name.view()),
              std::string(in.cells[around(in, i)].name.view())),
          say("a tube within a tube is two sections side by side: give each its own step")};
}

bool ThinWalled::areas_fit(const Input& in) {
  if (!sizes_and_names(in)) return true;
  return first_without(in, [&](std::size_t i) { return area_fits(in, i); }) == in.cells.size();
}

FieldFault ThinWalled::too_much_area(const Input& in) {
  const std::size_t i = first_without(in, [&](std::size_t k) { return area_fits(in, k); });
  return {"cells[" + std::to_string(i + 1) + "]",
          say("the walls of cell '{1}' enclose at most {2}, and A is {3}", std::string(in.cells[i].name.view()),
              format_quantity(in_si(largest_area(in, i)), mm2.symbol),
              format_quantity(in_si(area_of(in.cells[i])), mm2.symbol)),
          say("give all of its walls, with 'beside' for those that another cell has named")};
}

bool ThinWalled::outlines_fit(const Input& in) {
  constexpr double apart = 0.02;
  if (!sizes_and_names(in)) return true;
  return first_without(in, [&](std::size_t i) {
           if (in.cells[i].points.empty()) return true;
           const Length U = perimeter_of(in, i);
           return abs(outline_of(in.cells[i]) - U) <= apart * U;
         }) == in.cells.size();
}

bool ThinWalled::one_strength(const Input& in) {
  return one_shear_strength(
      in, std::all_of(in.walls.begin(), in.walls.end(), [](const Wall& w) { return is_set(w.tau_adm); }));
}

bool ThinWalled::moduli_fit(const Input& in) {
  return std::all_of(in.walls.begin(), in.walls.end(),
                     [&](const Wall& w) { return !is_set(w.G) || (is_set(w.tau_adm) && is_set(in.G)); });
}

Applies ThinWalled::loaded(const Input& in) { return where(in_si(in.T) != 0.0); }
Applies ThinWalled::brittle(const Input& in) { return in.behaviour == Behaviour::brittle ? loaded(in) : Applies::no; }
Applies ThinWalled::tough(const Input& in) { return in.behaviour == Behaviour::brittle ? Applies::no : loaded(in); }

/// Unstiffened plates up to 72 sqrt(235 MPa/R_e)/1.2 thicknesses do not buckle in shear before they yield; without R_e
/// that of 500 MPa counts.
Applies ThinWalled::slender(const Input& in) {
  const double R_e = is_set(in.R_e) ? in.R_e / MPa : 500.0;
  const double bound = 72.0 / 1.2 * std::sqrt(235.0 / R_e);
  const bool any = std::any_of(in.walls.begin(), in.walls.end(),
                               [&](const Wall& w) { return !is_free(w) && reduced(longest_side(w) / w.t) > bound; });
  return any ? loaded(in) : Applies::no;
}

}  // namespace loadpath::section
