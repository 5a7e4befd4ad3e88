// Whether the parts of a built-up section overlap, or are separate: rules of section.built_up.
//
// Every shape is rectangles and rings; fillets and roundings are left out.
#include "calculators/section/built_up.hpp"
#include "calculators/section/part.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace loadpath::section {

namespace {

using Part = BuiltUp::Part;
using Shape = BuiltUp::Shape;

/// A rectangle of half sides b and h, or a ring between the radii inner and outer, where outer is above zero.
struct Piece {
  double y = 0.0, z = 0.0, b = 0.0, h = 0.0, outer = 0.0, inner = 0.0;
  double c = 1.0, s = 0.0;  // how it is turned

  [[nodiscard]] bool is_ring() const { return outer > 0.0; }
  /// Its thinner side.
  [[nodiscard]] double thickness() const { return is_ring() ? outer - inner : 2.0 * std::min(b, h); }
};
using Pieces = std::vector<Piece>;

Piece rectangle_at(Length y, Length z, Length b, Length h) {
  return {in_si(y), in_si(z), 0.5 * in_si(b), 0.5 * in_si(h)};
}

/// In the axes of the part's own sketch.
Pieces pieces_of(const Part& p) {
  const Length none = from_si<Length>(0.0), web = p.h - 2.0 * p.t_f, edge = 0.5 * (p.h - p.t_f);
  switch (p.shape) {
    case Shape::circle:
    case Shape::ring:
      return {{0.0, 0.0, 0.0, 0.0, 0.5 * in_si(p.d), p.shape == Shape::ring ? 0.5 * in_si(p.d_i) : 0.0}};
    case Shape::rectangle:
      return {rectangle_at(none, none, p.b, p.h)};
    case Shape::I:
      return {rectangle_at(none, none, p.t_w, web), rectangle_at(none, edge, p.b, p.t_f),
              rectangle_at(none, -edge, p.b, p.t_f)};
    case Shape::channel:
      return {rectangle_at(0.5 * p.t_w, none, p.t_w, web), rectangle_at(0.5 * p.b, edge, p.b, p.t_f),
              rectangle_at(0.5 * p.b, -edge, p.b, p.t_f)};
    case Shape::angle:
      return {rectangle_at(0.5 * p.t, 0.5 * p.h, p.t, p.h), rectangle_at(0.5 * (p.b + p.t), 0.5 * p.t, p.b - p.t, p.t)};
    case Shape::T:
      return {rectangle_at(none, -0.5 * p.t_f, p.b, p.t_f),
              rectangle_at(none, -0.5 * (p.h + p.t_f), p.t_w, p.h - p.t_f)};
    case Shape::hollow:
      return {rectangle_at(none, 0.5 * (p.h - p.t), p.b, p.t), rectangle_at(none, -0.5 * (p.h - p.t), p.b, p.t),
              rectangle_at(0.5 * (p.b - p.t), none, p.t, p.h - 2.0 * p.t),
              rectangle_at(-0.5 * (p.b - p.t), none, p.t, p.h - 2.0 * p.t)};
    case Shape::table:
      break;
  }
  return {};
}

Pieces placed_pieces(const Part& part) {
  Pieces pieces = pieces_of(as_shape(part));
  const double c = std::cos(part.angle), s = std::sin(part.angle);
  for (Piece& p : pieces) {
    const double y = p.y, z = p.z;
    p.y = in_si(part.y) + c * y - s * z, p.z = in_si(part.z) + s * y + c * z;
    p.c = c, p.s = s;
  }
  return pieces;
}

/// Along the sides of the first: negative where both overlap there.
double gap_along(const Piece& p, const Piece& q) {
  const double y = q.y - p.y, z = q.z - p.z;
  const double c = std::abs(p.c * q.c + p.s * q.s), s = std::abs(p.c * q.s - p.s * q.c);
  return std::max(std::abs(y * p.c + z * p.s) - p.b - q.b * c - q.h * s,
                  std::abs(z * p.c - y * p.s) - p.h - q.b * s - q.h * c);
}

double gap_to_ring(const Piece& p, const Piece& ring) {
  const double y = ring.y - p.y, z = ring.z - p.z;
  const double along = std::abs(y * p.c + z * p.s), across = std::abs(z * p.c - y * p.s);
  const double nearest = std::hypot(std::max(along - p.b, 0.0), std::max(across - p.h, 0.0));
  return std::max(nearest - ring.outer, ring.inner - std::hypot(along + p.b, across + p.h));
}

/// Negative where the pieces overlap. For turned rectangles at most their distance.
double gap(const Piece& p, const Piece& q) {
  if (!p.is_ring()) return q.is_ring() ? gap_to_ring(p, q) : std::max(gap_along(p, q), gap_along(q, p));
  if (!q.is_ring()) return gap_to_ring(q, p);
  const double apart = std::hypot(q.y - p.y, q.z - p.z);
  return std::max({apart - p.outer - q.outer, p.inner - apart - q.outer, q.inner - apart - p.outer});
}

/// Whether a piece of each meets one of the other; what counts for nothing is a hundredth of the thinner one.
template <class Test>
bool any_pair(const Pieces& a, const Pieces& b, Test test) {
  return std::any_of(a.begin(), a.end(), [&](const Piece& p) {
    return std::any_of(b.begin(), b.end(),
                       [&](const Piece& q) { return test(gap(p, q), 0.01 * std::min(p.thickness(), q.thickness())); });
  });
}

bool overlap(const Pieces& a, const Pieces& b) {
  return any_pair(a, b, [](double gap, double little) { return gap < -little; });
}

bool touch(const Pieces& a, const Pieces& b) {
  return any_pair(a, b, [](double gap, double little) { return gap < little; });
}

std::vector<Pieces> pieces_of(const BuiltUp::Input& in) {
  std::vector<Pieces> all;
  for (const Part& part : in.parts) all.push_back(placed_pieces(part));
  return all;
}

/// Two parts of material that cover the same place, which no hole takes away again; equal where there are none.
std::pair<std::size_t, std::size_t> doubled(const BuiltUp::Input& in) {
  const auto all = pieces_of(in);
  const auto is_full = [&](std::size_t i) { return in.parts[i].as == BuiltUp::As::full; };
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!is_full(i) || !is_full(k) || !overlap(all[k], all[i])) continue;
      bool cut = false;
      for (std::size_t hole = 0; hole < all.size(); ++hole)
        cut = cut || (!is_full(hole) && overlap(all[hole], all[i]) && overlap(all[hole], all[k]));
      if (!cut) return {k, i};
    }
  }
  return {};
}

/// The first part of material that nothing leads to from the first one, touch by touch; 0 where there is none.
std::size_t lone(const BuiltUp::Input& in) {
  const auto all = pieces_of(in);
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (in.parts[i].as == BuiltUp::As::full) open.push_back(i);
  }
  std::vector<std::size_t> reached;
  if (!open.empty()) reached.push_back(open.front()), open.erase(open.begin());
  for (std::size_t k = 0; k < reached.size(); ++k) {
    const auto apart =
        std::stable_partition(open.begin(), open.end(), [&](std::size_t i) { return !touch(all[reached[k]], all[i]); });
    reached.insert(reached.end(), apart, open.end());
    open.erase(apart, open.end());
  }
  return open.empty() ? 0 : open.front();
}

std::string name_of(const BuiltUp::Input& in, std::size_t i) {
  const Name& name = in.parts[i].name;
  return name.empty() ? std::to_string(i + 1) : "'" + std::string(name.view()) + "'";
}

std::string path_of(std::size_t i) { return "parts[" + std::to_string(i + 1) + "]"; }

}  // namespace

bool BuiltUp::none_overlap(const Input& in) {
  const auto [first, second] = parts_are_whole(in) ? doubled(in) : std::pair<std::size_t, std::size_t>{};
  return first == second;
}

FieldFault BuiltUp::overlapping(const Input& in) {
  const auto [first, second] = doubled(in);
  return {
      path_of(second),
      say("the parts {1} and {2} overlap: the common area would count twice", name_of(in, first), name_of(in, second)),
      say("move one of them, or cut the common area out once with a part of as = \"hole\"")};
}

bool BuiltUp::all_touch(const Input& in) { return !parts_are_whole(in) || lone(in) == 0; }

FieldFault BuiltUp::apart(const Input& in) {
  const std::size_t i = lone(in);
  return {path_of(i), say("part {1} is not connected to the first one", name_of(in, i)),
          say("the parts act as one bar where lacing or battens join them: check these, and the shear between the "
              "parts")};
}

}  // namespace loadpath::section
