#include "calculators/section/built_up.hpp"

#include "calculators/section/part.hpp"
#include "calculators/section/polygon_moments.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <cmath>
#include <string>

namespace loadpath::section {

namespace {

using Part = BuiltUp::Part;

std::string path_of(std::size_t i) { return "parts[" + std::to_string(i + 1) + "]"; }

double sign_of(const Part& part) { return part.as == BuiltUp::As::hole ? -1.0 : 1.0; }

/// Takes a point of a part's own sketch to its place.
class Turned {
 public:
  explicit Turned(const Part& part) : y_(part.y), z_(part.z), c_(std::cos(part.angle)), s_(std::sin(part.angle)) {}
  [[nodiscard]] Place operator()(Length y, Length z) const { return {y_ + c_ * y - s_ * z, z_ + s_ * y + c_ * z}; }

 private:
  Length y_, z_;
  double c_, s_;
};

/// The part turned and put to its place.
template <class Tracer>
BuiltUp::Placed place(const Part& part, const Turned& placed, const Properties& own, Tracer& trace) {
  const auto A_0 = trace.value("A_0", own.A, "area of the part");
  const auto I_y0 = trace.value("I_y0", own.I_y, "of the part about its own axes, before it is turned");
  const auto I_z0 = trace.value("I_z0", own.I_z, "of the part about its own axes, before it is turned");
  const auto I_yz0 = trace.value("I_yz0", own.I_yz, "of the part about its own axes, before it is turned");
  trace.angle("angle", part.angle, "turned counter-clockwise");
  const double sign = trace.value("sign", sign_of(part), "1 of material, -1 of a hole");
  STEP(A, sign * A_0, "counts negative where it is cut out");
  const auto [y_S, z_S] = placed(own.y_S, own.z_S);
  trace.value("y_S", y_S, "centroid of the part at its position");
  trace.value("z_S", z_S, "centroid of the part at its position");
  STEP(c, cos(part.angle), "of the turn");
  STEP(s, sin(part.angle), "of the turn");
  STEP(I_y, sign * (I_y0 * c * c + I_z0 * s * s + 2.0 * I_yz0 * s * c), "turned about its centroid, [ME102]");
  STEP(I_z, sign * (I_y0 * s * s + I_z0 * c * c - 2.0 * I_yz0 * s * c), "turned about its centroid, [ME102]");
  STEP(I_yz, sign * (I_yz0 * (c * c - s * s) + (I_z0 - I_y0) * s * c), "turned about its centroid, [ME102]");
  return {part.name, A, y_S, z_S, I_y, I_z, I_yz};
}

constexpr Place sketch_origin{from_si<Length>(0.0), from_si<Length>(0.0)};

Moments about_sketch(const BuiltUp::Placed& p) {
  return {p.A,
          p.A * p.z_S,
          p.A * p.y_S,
          p.I_y + p.A * p.z_S * p.z_S,
          p.I_z + p.A * p.y_S * p.y_S,
          p.I_yz + p.A * p.y_S * p.z_S};
}

Outline outline_at(const Turned& placed, const Outline& outline) {
  Outline turned;
  for (const Place& p : outline) turned.push_back(placed(p.y, p.z));
  return turned;
}

void add_extremes(Extremes& all, const Turned& placed, const Extremes& own) {
  for (const Extreme& e : own) {
    const auto [y, z] = placed(e.y, e.z);
    all.push_back({y, z, e.radius});
  }
}

}  // namespace

bool BuiltUp::parts_are_whole(const Input& in) {
  for (const Part& part : in.parts) {
    if (fault_of(part)) return false;
  }
  return true;
}

FieldFault BuiltUp::incomplete(const Input& in) {
  for (std::size_t i = 0; i < in.parts.size(); ++i) {
    if (auto fault = fault_of(in.parts[i])) {
      fault->path = path_of(i) + (fault->path.empty() ? "" : "." + fault->path);
      return *fault;
    }
  }
  return {};
}

bool BuiltUp::is_full(const Input& in) {
  if (!parts_are_whole(in)) return true;  // another rule says it
  NoTrace off;
  const Result r = evaluate(in, off);
  return r.A > from_si<Area>(0.0) && r.I_min > from_si<SecondMoment>(0.0);
}

template <class Tracer>
BuiltUp::Result BuiltUp::evaluate(const Input& in, Tracer& trace) {
  Result r;
  Moments sum;
  Extremes extremes;
  SecondMoment I_t = from_si<SecondMoment>(0.0);
  for (const Part& part : in.parts) {
    [[maybe_unused]] const auto in_part = trace.scope("parts", r.parts.size());
    const Shaped shaped = section::shaped(part);
    const Turned turned(part);
    const Placed placed = place(part, turned, shaped.own, trace);
    add(sum, about_sketch(placed), 1.0);
    const bool full = part.as == As::full;
    I_t += full ? shaped.own.I_t : unset<SecondMoment>;
    if (full) add_extremes(extremes, turned, shaped.extremes);
    r.parts.push_back(placed);
  }
  static_cast<Properties&>(r) = centroidal(sum, sketch_origin, trace);
  complete(r, extremes, trace);
  r.section = record_of(r);
  if (!is_set(I_t)) return r;
  r.I_t = trace.value("I_t", I_t, "sum of the parts' own: a lower bound");
  return r;
}

std::vector<figure::Figure> BuiltUp::figures(const Input& in, const Result& r) {
  Sketch sketch;
  for (const Part& part : in.parts) {
    const auto [outline, hole] = contours(part);
    const Turned turned(part);
    (part.as == As::full ? sketch.material : sketch.holes).push_back(outline_at(turned, outline));
    if (!hole.empty()) sketch.holes.push_back(outline_at(turned, hole));
  }
  return section::figures(sketch, r);
}

template BuiltUp::Result BuiltUp::evaluate(const Input&, NoTrace&);
template BuiltUp::Result BuiltUp::evaluate(const Input&, Trace&);

}  // namespace loadpath::section

template const loadpath::Calculator& loadpath::erased<loadpath::section::BuiltUp>();
