#include "calculators/section/torsion/solid_torsion.hpp"

#include "lib/calculator/calculator_of.hpp"
#include "lib/numerics/prandtl.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace loadpath::section {

namespace {

using Input = SolidTorsion::Input;
using Result = SolidTorsion::Result;
using numerics::Contour;
using numerics::PlanePoint;

/// The contours as the solver takes them.
struct Contours {
  List<PlanePoint, most_sides> points;
  List<Contour, numerics::most_contours> loops;
};

std::size_t sides_of(const Polygon::Input& in) {
  std::size_t sides = in.points.size();
  for (const Polygon::Hole& hole : in.holes) sides += hole.points.size();
  return sides;
}

template <class Corners>
void add(Contours& contours, const Corners& corners) {
  const PlanePoint* const first = contours.points.data() + contours.points.size();
  for (const Polygon::Corner& c : corners) contours.points.push_back({in_si(c.y), in_si(c.z)});
  contours.loops.push_back({first, corners.size()});
}

/// Elements per side of the coarse mesh; the fine one has twice as many.
std::size_t elements_per_side(std::size_t sides) {
  constexpr std::size_t enough = 20;
  return std::clamp<std::size_t>(numerics::most_elements / sides / 2, 2, enough);
}

struct Meshes {
  numerics::TorsionFunction coarse, fine;
};

bool are_same(const Contours& one, const Contours& other) {
  const auto bits = [](const PlanePoint& p) {
    return std::pair{std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y)};
  };
  return std::ranges::equal(one.points, other.points, {}, bits, bits) &&
         std::ranges::equal(one.loops, other.loops, {}, &Contour::size, &Contour::size);
}

/// Kept from the last call while the section is the same: in a sweep of the load it is solved once.
Meshes meshes_of(const Input& in) {
  thread_local Contours last;
  thread_local Meshes meshes;
  Contours contours;
  add(contours, in.points);
  for (const Polygon::Hole& hole : in.holes) add(contours, hole.points);
  if (are_same(contours, last)) return meshes;
  const std::size_t per_side = elements_per_side(contours.points.size());
  meshes = {numerics::torsion_function({contours.loops.data(), contours.loops.size()}, per_side),
            numerics::torsion_function({contours.loops.data(), contours.loops.size()}, 2 * per_side)};
  last = contours;  // of the loops only the sizes are compared
  return meshes;
}

/// Direction of the contour at b: 1 to the left, -1 to the right, 0 where it goes straight on.
int turn(const Polygon::Corner& a, const Polygon::Corner& b, const Polygon::Corner& c) {
  constexpr double straight = 1e-6;  // rad
  const double x_1 = in_si(b.y - a.y), y_1 = in_si(b.z - a.z), x_2 = in_si(c.y - b.y), y_2 = in_si(c.z - b.z);
  const double angle = std::atan2(x_1 * y_2 - x_2 * y_1, x_1 * x_2 + y_1 * y_2);
  return angle > straight ? 1 : angle < -straight ? -1 : 0;
}

Length size_of(const Input& in) {
  const auto [left, right] =
      std::minmax_element(in.points.begin(), in.points.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  const auto [low, high] =
      std::minmax_element(in.points.begin(), in.points.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
  return max(right->y - left->y, high->z - low->z);
}

template <class Tracer>
void strength(const Input& in, const Meshes& meshes, Result& r, Tracer& trace) {
  r.tau_all = allowable_shear(in, unset<Stress>, trace);
  if (SolidTorsion::has_inner_corner(in)) return;
  const Length e_1 =
      trace.value("e_1", from_si<Length>(meshes.coarse.stress), "maximum stress over G theta, coarse mesh");
  const Length e_2 = trace.value("e_2", from_si<Length>(meshes.fine.stress), "the same, elements of half the size");
  STEP(e, e_2 + (e_2 - e_1) / 3.0, "extrapolated: the error falls with the square of the size");
  STEP_TO(r, e_W, abs(e - e_2) / e, "the fine mesh against it");
  STEP_TO(r, W_t, r.I_t / e, "torque over the maximum stress");
  r.y_t = from_si<Length>(meshes.fine.at.x), r.z_t = from_si<Length>(meshes.fine.at.y);
  STEP_TO(r, tau_max, in.K_A * abs(in.T) / W_t, "on the contour, [B19] (2)");
  const Stress tau_all = r.tau_all;
  STEP_TO(r, u_tau, tau_max / tau_all, "strength condition, [B19] (3)");
  r.cycle = {Stresses::shear, r.tau_max};
}

}  // namespace

bool SolidTorsion::sides_fit(const Input& in) { return sides_of(in) <= most_sides; }

bool SolidTorsion::has_inner_corner(const Input& in) {
  if (!in.holes.empty()) return true;
  const std::size_t n = in.points.size();
  std::size_t left = 0, right = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const int way = turn(in.points[i], in.points[(i + 1) % n], in.points[(i + 2) % n]);
    left += way > 0 ? 1 : 0;
    right += way < 0 ? 1 : 0;
  }
  return left > 0 && right > 0;
}

Applies SolidTorsion::loaded(const Input& in) { return where(in_si(in.T) != 0.0); }
Applies SolidTorsion::brittle(const Input& in) { return in.behaviour == Behaviour::brittle ? loaded(in) : Applies::no; }
Applies SolidTorsion::tough(const Input& in) { return in.behaviour == Behaviour::brittle ? Applies::no : loaded(in); }

template <class Tracer>
SolidTorsion::Result SolidTorsion::evaluate(const Input& in, Tracer& trace) {
  Result r;
  r.d_s = size_of(in);
  const Meshes meshes = meshes_of(in);
  const SecondMoment I_1 = trace.value("I_1", from_si<SecondMoment>(meshes.coarse.I_t), "coarse mesh, [Prandtl]");
  const SecondMoment I_2 =
      trace.value("I_2", from_si<SecondMoment>(meshes.fine.I_t), "elements of half the size, [Prandtl]");
  STEP_TO(r, I_t, I_2 + (I_2 - I_1) / 7.0, "extrapolated: the error falls with the third power of the size");
  STEP_TO(r, e_I, abs(I_t - I_2) / I_t, "the fine mesh against it");
  strength(in, meshes, r, trace);
  if (is_set(in.G)) {
    STEP_TO(r, theta, in.K_A * in.T / (in.G * I_t), "angle of twist per unit length");
    if (is_set(in.theta_adm)) {
      STEP_TO(r, u_theta, abs(theta) / in.theta_adm, "stiffness condition, [B19] (8)");
    }
  }
  return r;
}

template SolidTorsion::Result SolidTorsion::evaluate(const Input&, NoTrace&);
template SolidTorsion::Result SolidTorsion::evaluate(const Input&, Trace&);

}  // namespace loadpath::section

template const loadpath::Calculator& loadpath::erased<loadpath::section::SolidTorsion>();
