// Whether holes are where there is material: the bodies are compared by their extents about and along the axis z. An
// extent that is not certain is taken so that a hole passes.
#include "calculators/dynamics/inertia/inertia.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace loadpath::dynamics {

namespace {

using Part = Inertia::Part;
using Shape = Inertia::Shape;

constexpr double without_end = std::numeric_limits<double>::infinity();
constexpr double above = 1.0 + 1e-9, below = 1.0 - 1e-9;  // rounding of sizes that are meant to be equal

double size_or(Length size, double missing) { return is_set(size) ? in_si(size) : missing; }
double distance(const Part& p) { return std::hypot(in_si(p.x), in_si(p.y)); }
bool is_of_known_size(const Part& p) { return p.shape != Shape::point && p.shape != Shape::other; }
double turn(const Part& p) { return is_set(p.beta) ? p.beta : 0.0; }
bool is_upright(const Part& p) { return turn(p) == 0.0; }

/// Distances from the axis between which a body lies, in m.
struct Ring {
  double inner = 0.0, outer = 0.0;
};

Ring ring_of(const Part& p) {
  const double e = distance(p), radius = size_or(p.D, 0.0) / 2.0;
  if (p.shape == Shape::cuboid) {
    const double a = in_si(p.a) / 2.0, b = in_si(p.b) / 2.0;
    const double outer = std::hypot(std::abs(in_si(p.x)) + a, std::abs(in_si(p.y)) + b);
    return {std::max(0.0, e - std::hypot(a, b)), outer};
  }
  const double along = p.shape == Shape::sphere ? 0.0 : size_or(p.h, 0.0) * std::abs(std::sin(turn(p)));
  const double reach = radius + (p.shape == Shape::cone ? 0.75 : 0.5) * along;  // a cone from h/4 above its base
  const bool is_round_about_axis = e == 0.0 && is_upright(p) && p.shape != Shape::sphere && p.shape != Shape::cone;
  return {is_round_about_axis ? size_or(p.d_i, 0.0) / 2.0 : std::max(0.0, e - reach), e + reach};
}

/// Radius that a hole surely has about its own centre.
double sure_radius(const Part& hole) {
  if (hole.shape == Shape::cuboid) return std::min(in_si(hole.a), in_si(hole.b)) / 2.0;
  return is_upright(hole) ? size_or(hole.D, 0.0) / 2.0 : 0.0;
}

/// Length that a hole surely has along z.
double sure_length(const Part& hole) {
  if (hole.shape == Shape::sphere) return in_si(hole.D);
  return size_or(hole.h, 0.0) * std::abs(std::cos(turn(hole)));
}

/// Half of the length of a solid part along z, on both sides of its centre; infinite if it is not known.
double half_length(const Part& p) {
  if (p.shape == Shape::sphere) return in_si(p.D) / 2.0;
  if (p.shape == Shape::cuboid) return size_or(p.h, without_end) / 2.0;
  const double along = (p.shape == Shape::cone ? 0.75 : 0.5) * size_or(p.h, without_end);
  return std::abs(std::cos(turn(p))) * along + std::abs(std::sin(turn(p))) * size_or(p.D, 0.0) / 2.0;
}

/// Length along z of the solid parts at the distance of a hole; negative if there are none.
double length_at(const Inertia::Input& in, const Part& hole) {
  const Ring place = ring_of(hole);
  double from = without_end, to = -without_end;
  for (const Part& p : in.parts) {
    if (p.as == Inertia::As::hole) continue;
    const Ring ring = ring_of(p);
    if (place.inner > ring.outer * above || place.outer < ring.inner * below) continue;
    from = std::min(from, in_si(p.z) - half_length(p)), to = std::max(to, in_si(p.z) + half_length(p));
  }
  return to - from;
}

double outer_reach(const Inertia::Input& in) {
  double reach = 0.0;
  for (const Part& p : in.parts) {
    if (p.as != Inertia::As::hole) reach = std::max(reach, ring_of(p).outer);
  }
  return reach;
}

std::string in_mm(double si) { return format_quantity(si, "mm"); }

FieldFault circle_fault(const Part& hole, const std::string& name) {
  const bool is_turned = !is_upright(hole) || hole.n < 2;
  const double size = 2.0 * sure_radius(hole), room = 2.0 * distance(hole) * std::sin(pi / hole.n);
  if (is_turned || size <= room * above) return {};
  return {"n",
          say("{1} holes '{2}' of {3} overlap: at {4} from the axis each has {5}", format_number(hole.n), name,
              in_mm(size), in_mm(distance(hole)), in_mm(room)),
          say("reduce n or the size of the holes, or increase their distance")};
}

FieldFault place_fault(const Inertia::Input& in, const Part& hole, const std::string& name) {
  const double reach = outer_reach(in), end = distance(hole) + sure_radius(hole), length = length_at(in, hole);
  if (end > reach * above)
    return {"x",
            say("the hole '{1}' reaches {2} from the axis, the solid parts only {3}", name, in_mm(end), in_mm(reach)),
            say("correct its position x, y, or its size")};
  if (length < 0.0)
    return {"x", say("the hole '{1}' meets no solid part at {2} from the axis", name, in_mm(distance(hole))),
            say("correct its position x, y, or its size")};
  if (sure_length(hole) > length * above)
    return {"h",
            say("the hole '{1}' is {2} long along the axis, the solid parts there only {3}", name,
                in_mm(sure_length(hole)), in_mm(length)),
            say("reduce its length; solid parts one behind the other need their z")};
  return {};
}

}  // namespace

bool Inertia::holes_lie_inside(const Input& in) { return misplaced_hole(in).message.empty(); }

FieldFault Inertia::misplaced_hole(const Input& in) {
  if (!parts_are_complete(in)) return {};  // another rule states it
  const auto has_size = [](const Part& p) { return p.as == As::hole || is_of_known_size(p); };
  const bool all_have_sizes = std::all_of(in.parts.begin(), in.parts.end(), has_size);
  for (std::size_t i = 0; i < in.parts.size(); ++i) {
    const Part& hole = in.parts[i];
    if (hole.as != As::hole || !is_of_known_size(hole)) continue;
    const std::string place = "parts[" + std::to_string(i + 1) + "]";
    const std::string name = hole.name.empty() ? place : std::string(hole.name.view());
    FieldFault fault = circle_fault(hole, name);
    if (fault.message.empty() && all_have_sizes) fault = place_fault(in, hole, name);
    if (fault.message.empty()) continue;
    fault.path = place + "." + fault.path;
    return fault;
  }
  return {};
}

}  // namespace loadpath::dynamics
