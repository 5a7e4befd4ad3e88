#include "lib/numerics/prandtl.hpp"

#include "lib/numerics/magnitude.hpp"

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace loadpath::numerics {

namespace {

using std::numbers::pi;

struct Element {
  PlanePoint from, to;
  std::size_t contour;
  double length;
  PlanePoint along, out;  // unit vectors; out of the material
};
using Elements = boost::container::static_vector<Element, most_elements>;

constexpr std::size_t most_unknowns = most_elements + most_contours - 1;

/// Equations in the derivative on each element and the constant of each hole.
struct Equations {
  std::size_t size;
  std::array<std::array<double, most_unknowns>, most_unknowns> left;
  std::array<double, most_unknowns> right;
};

double twice_area(Contour c) {
  double sum = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const PlanePoint &a = c[i], &b = c[(i + 1) % c.size()];
    sum += (a.x - c[0].x) * (b.y - c[0].y) - (b.x - c[0].x) * (a.y - c[0].y);
  }
  return sum;
}

/// 0 to 1, with steps that grow from both ends with their distance from it.
double graded(double t) { return t * t / (t * t + (1.0 - t) * (1.0 - t)); }

Element element(PlanePoint from, PlanePoint to, std::size_t contour) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const PlanePoint along{(to.x - from.x) / length, (to.y - from.y) / length};
  return {from, to, contour, length, along, {along.y, -along.x}};
}

void add_side(Elements& elements, PlanePoint a, PlanePoint b, std::size_t contour, std::size_t per_side) {
  const auto at = [&](std::size_t k) {
    const double s = graded(static_cast<double>(k) / static_cast<double>(per_side));
    return PlanePoint{a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
  };
  for (std::size_t k = 0; k < per_side; ++k) elements.push_back(element(at(k), at(k + 1), contour));
}

/// Position and size of the section, scaled into a unit square about the origin: its logarithmic capacity is never 1,
/// where the equations are singular.
struct Frame {
  PlanePoint middle{};
  double size = 0.0;

  explicit Frame(Contour outer) {
    PlanePoint low = outer[0], high = outer[0];
    for (const PlanePoint& p : outer) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    middle = {(low.x + high.x) / 2.0, (low.y + high.y) / 2.0};
    size = std::hypot(high.x - low.x, high.y - low.y);
  }
  [[nodiscard]] PlanePoint in(PlanePoint p) const { return {(p.x - middle.x) / size, (p.y - middle.y) / size}; }
  [[nodiscard]] PlanePoint out(PlanePoint p) const { return {p.x * size + middle.x, p.y * size + middle.y}; }
};

/// The outer contour to the left, holes to the right, so that the material lies on the left of every element.
Elements elements_of(std::span<const Contour> contours, const Frame& frame, std::size_t per_side) {
  Elements elements;
  for (std::size_t k = 0; k < contours.size(); ++k) {
    const Contour c = contours[k];
    const bool forward = (twice_area(c) > 0.0) == (k == 0);
    for (std::size_t i = 0; i < c.size(); ++i) {
      const PlanePoint a = frame.in(c[i]), b = frame.in(c[(i + 1) % c.size()]);
      add_side(elements, forward ? a : b, forward ? b : a, k, per_side);
    }
  }
  return elements;
}

PlanePoint middle_of(const Element& e) { return {(e.from.x + e.to.x) / 2.0, (e.from.y + e.to.y) / 2.0}; }

/// Integrals over an element, seen from a point: of G = -ln(r)/(2 pi), of its derivative across the element, and of
/// this times half the square of the distance from the origin.
struct Integrals {
  double single, double_layer, of_square;
};

Integrals integrals(const Element& e, PlanePoint p, bool own) {
  const double ax = e.from.x - p.x, ay = e.from.y - p.y;
  const double s_1 = ax * e.along.x + ay * e.along.y, s_2 = s_1 + e.length;
  const double d = own ? 0.0 : ax * e.out.x + ay * e.out.y;
  const double angle = d == 0.0 ? 0.0 : std::atan(s_2 / d) - std::atan(s_1 / d);
  const double log_1 = std::log(s_1 * s_1 + d * d) / 2.0, log_2 = std::log(s_2 * s_2 + d * d) / 2.0;
  const double foot_x = p.x + d * e.out.x, foot_y = p.y + d * e.out.y;
  const double square = (foot_x * foot_x + foot_y * foot_y) / 2.0;
  const double slope = foot_x * e.along.x + foot_y * e.along.y;
  const double rest = (d * e.length - d * d * angle) / 2.0;
  return {-(s_2 * log_2 - s_1 * log_1 - e.length + d * angle) / (2.0 * pi), -angle / (2.0 * pi),
          -(square * angle + slope * d * (log_2 - log_1) + rest) / (2.0 * pi)};
}

/// Green's third identity in the middle of an element; psi there is half the square of the distance, and on a hole its
/// constant more.
void meet(Equations& equations, const Elements& elements, std::size_t i) {
  const PlanePoint p = middle_of(elements[i]);
  auto& row = equations.left[i];
  double& right = equations.right[i];
  right = (p.x * p.x + p.y * p.y) / 4.0;
  if (elements[i].contour > 0) row[elements.size() + elements[i].contour - 1] -= 0.5;
  for (std::size_t j = 0; j < elements.size(); ++j) {
    const Integrals seen = integrals(elements[j], p, i == j);
    row[j] = seen.single;
    right += seen.of_square;
    if (elements[j].contour > 0) row[elements.size() + elements[j].contour - 1] -= seen.double_layer;
  }
}

/// No flux leaves a hole: psi has a conjugate there, the warping.
void close_holes(Equations& equations, const Elements& elements) {
  for (std::size_t j = 0; j < elements.size(); ++j) {
    if (elements[j].contour > 0) equations.left[elements.size() + elements[j].contour - 1][j] = elements[j].length;
  }
}

void solve(Equations& e) {
  for (std::size_t i = 0; i < e.size; ++i) {
    std::size_t pivot = i;
    for (std::size_t k = i + 1; k < e.size; ++k) {
      if (std::abs(e.left[k][i]) > std::abs(e.left[pivot][i])) pivot = k;
    }
    std::swap(e.left[i], e.left[pivot]);
    std::swap(e.right[i], e.right[pivot]);
    for (std::size_t k = i + 1; k < e.size; ++k) {
      const double factor = e.left[k][i] / e.left[i][i];
      for (std::size_t j = i; j < e.size; ++j) e.left[k][j] -= factor * e.left[i][j];
      e.right[k] -= factor * e.right[i];
    }
  }
  for (std::size_t i = e.size; i-- > 0;) {
    for (std::size_t j = i + 1; j < e.size; ++j) e.right[i] -= e.left[i][j] * e.right[j];
    e.right[i] /= e.left[i][i];
  }
}

/// The polar moment of the material between the elements, about the origin.
double polar_moment(const Elements& elements) {
  double sum = 0.0;
  for (const Element& e : elements) {
    const PlanePoint &a = e.from, &b = e.to;
    sum += (a.x * b.y - b.x * a.y) * (a.x * a.x + a.x * b.x + b.x * b.x + a.y * a.y + a.y * b.y + b.y * b.y);
  }
  return sum / 12.0;
}

double integral_of_square(const Element& e) {
  const PlanePoint &a = e.from, &b = e.to;
  return e.length * (a.x * a.x + a.x * b.x + b.x * b.x + a.y * a.y + a.y * b.y + b.y * b.y) / 3.0;
}

}  // namespace

TorsionFunction torsion_function(std::span<const Contour> contours, std::size_t per_side) {
  const Frame frame(contours[0]);
  const Elements elements = elements_of(contours, frame, per_side);
  Equations equations{elements.size() + contours.size() - 1, {}, {}};
  for (std::size_t i = 0; i < elements.size(); ++i) meet(equations, elements, i);
  close_holes(equations, elements);
  solve(equations);
  TorsionFunction found{polar_moment(elements), 0.0, {}};
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const Element& e = elements[i];
    found.I_t -= equations.right[i] * integral_of_square(e) / 2.0;
    const double stress = std::abs(equations.right[i] - e.from.x * e.out.x - e.from.y * e.out.y);
    if (exceeds(stress, found.stress)) found.at = frame.out(middle_of(e));
    found.stress = std::max(found.stress, stress);
  }
  found.stress *= frame.size;
  found.I_t *= frame.size * frame.size * frame.size * frame.size;
  return found;
}

}  // namespace loadpath::numerics
