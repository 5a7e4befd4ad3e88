#include "calculators/dynamics/inertia/inertia.hpp"

#include "calculators/motion/laws.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <cmath>

// The masses m and moments J hide the units of their names where the formulas are.
#pragma GCC diagnostic ignored "-Wshadow"

namespace loadpath::dynamics {

namespace {

using Part = Inertia::Part;
using Shape = Inertia::Shape;
using Share = Inertia::Share;
using Volume = SectionModulus;

constexpr Length none = 0.0 * mm.one;

/// The sizes of a part, each a line of the calculation; those that its shape does not have stay unset.
struct Sizes {
  Length D = unset<Length>, d_i = unset<Length>, h = unset<Length>, a = unset<Length>, b = unset<Length>;
  double beta = 0.0;
};

bool is_round(const Part& p) { return p.shape == Shape::cylinder || p.shape == Shape::rod; }

template <class Tracer>
Sizes sizes_of(const Part& p, Tracer& trace) {
  Sizes s;
  const auto take = [&](const char* symbol, Length given, Length missing, const char* why) {
    const Length size = is_set(given) ? given : missing;
    return is_set(size) ? trace.value(symbol, size, why) : size;
  };
  const bool may_be_hollow = is_round(p) || p.shape == Shape::sphere;
  s.D = take("D", p.D, is_round(p) ? none : unset<Length>, "outer diameter, 0: slender");
  s.d_i = take("d_i", p.d_i, may_be_hollow ? none : unset<Length>, "inner diameter, 0: solid");
  s.h = take("h", p.h, is_round(p) ? none : unset<Length>, "length, 0: thin");
  s.a = take("a", p.a, unset<Length>, "side along x");
  s.b = take("b", p.b, unset<Length>, "side along y");
  s.beta = is_set(p.beta) ? trace.angle("beta", p.beta, "angle of its axis to z") : 0.0;
  return s;
}

template <class Tracer>
Volume volume_of(const Part& p, const Sizes& s, Tracer& trace) {
  if (p.shape == Shape::cuboid) return NAMED_STEP("V", s.a * s.b * s.h, "volume of a cuboid");
  if (p.shape == Shape::cone) return NAMED_STEP("V", pi / 12.0 * pow<2>(s.D) * s.h, "volume of a cone");
  if (p.shape == Shape::sphere)
    return NAMED_STEP("V", pi / 6.0 * (pow<3>(s.D) - pow<3>(s.d_i)), "volume of a sphere less its cavity");
  return NAMED_STEP("V", pi / 4.0 * (pow<2>(s.D) - pow<2>(s.d_i)) * s.h, "volume of a cylinder less its bore");
}

template <class Tracer>
Mass mass_of(const Inertia::Input& in, const Part& p, const Sizes& s, Tracer& trace) {
  if (is_set(p.mass)) return trace.value("m", p.mass, "mass of one part, given");
  const Volume V = volume_of(p, s, trace);
  const Density rho = trace.value("rho", is_set(p.rho) ? p.rho : in.rho, "density");
  return NAMED_STEP("m", rho * V, "mass of one part");
}

/// Of a body of revolution, from its moments about its own axis and across it.
template <class Tracer>
MassMoment inclined(const Sizes& s, MassMoment own, MassMoment across, Tracer& trace) {
  const MassMoment J_a = own, J_t = across;
  return NAMED_STEP("J_c", J_a * pow<2>(cos(s.beta)) + J_t * pow<2>(sin(s.beta)),
                    "about its own centroidal axis parallel to z: principal axes turned by beta");
}

template <class Tracer>
MassMoment of_cylinder(const Sizes& s, Mass mass, Tracer& trace) {
  const Mass& m = mass;
  STEP(J_a, m * (pow<2>(s.D) + pow<2>(s.d_i)) / 8.0, "about its own axis, [Wikibooks-Solids]");
  if (s.beta == 0.0) return trace.value("J_c", J_a, "its own axis is parallel to z");
  STEP(J_t, J_a / 2.0 + m * pow<2>(s.h) / 12.0, "across its axis, through its centre, [Wikibooks-Solids]");
  return inclined(s, J_a, J_t, trace);
}

template <class Tracer>
MassMoment of_cone(const Sizes& s, Mass mass, Tracer& trace) {
  const Mass& m = mass;
  STEP(J_a, 3.0 / 40.0 * m * pow<2>(s.D), "about its own axis, [Wikibooks-Solids]");
  if (s.beta == 0.0) return trace.value("J_c", J_a, "its own axis is parallel to z");
  STEP(J_t, 3.0 / 80.0 * m * (pow<2>(s.D) + pow<2>(s.h)), "across its axis, through its centre, [Wikibooks-Solids]");
  return inclined(s, J_a, J_t, trace);
}

/// A sphere less its cavity; the common factor D - d_i is divided out, so that a thin shell has a value too.
template <class Tracer>
MassMoment of_sphere(const Sizes& s, Mass mass, Tracer& trace) {
  const Mass& m = mass;
  STEP(q, s.d_i / s.D, "inner over outer diameter");
  return NAMED_STEP("J_c",
                    m * pow<2>(s.D) / 10.0 * (1.0 + q + pow<2>(q) + pow<3>(q) + pow<4>(q)) / (1.0 + q + pow<2>(q)),
                    "sphere less its cavity, 2/5 m R^2 of each, [Wikibooks-Solids]");
}

template <class Tracer>
MassMoment own_moment(const Part& p, const Sizes& s, Mass mass, Tracer& trace) {
  const Mass& m = mass;
  switch (p.shape) {
    case Shape::cylinder:
    case Shape::rod:
      return of_cylinder(s, m, trace);
    case Shape::cone:
      return of_cone(s, m, trace);
    case Shape::sphere:
      return of_sphere(s, m, trace);
    case Shape::cuboid:
      return NAMED_STEP("J_c", m * (pow<2>(s.a) + pow<2>(s.b)) / 12.0,
                        "about its own centroidal axis parallel to z, [Wikibooks-Solids]");
    case Shape::point:
      break;
    case Shape::other:
      return trace.value("J_c", p.J_c, "about its own centroidal axis parallel to z, given");
  }
  return trace.value("J_c", 0.0 * kg_m2, "its size is small");
}

double sign_of(const Part& p) { return p.as == Inertia::As::hole ? -1.0 : 1.0; }

template <class Tracer>
Share share_of(const Inertia::Input& in, const Part& p, Tracer& trace) {
  Share share;
  share.name = p.name;
  const Sizes sizes = sizes_of(p, trace);
  const Mass m = share.mass = mass_of(in, p, sizes, trace);
  const MassMoment J_c = share.J_c = own_moment(p, sizes, m, trace);
  const Length x = trace.value("x", p.x, "its centre of mass");
  const Length y = trace.value("y", p.y, "its centre of mass");
  const double count = trace.value("count", sign_of(p) * p.n, "number of these parts, negative for a hole");
  STEP_TO(share, e, sqrt(x * x + y * y), "distance of its centre of mass from the axis");
  STEP_TO(share, J_A, count * (J_c + m * e * e), "parallel-axis theorem");
  return share;
}

/// Sums over the parts: identical parts, equally spaced, have their common centre on the axis.
struct Sums {
  Mass m = 0.0 * kg;
  MassArm S_x = 0.0 * kg_mm, S_y = S_x, S_z = S_x;
};

void add(const Part& p, Mass one, Sums& sums) {
  const Mass all = sign_of(p) * p.n * one;
  sums.m += all;
  sums.S_z += all * p.z;
  if (p.n > 1) return;
  sums.S_x += all * p.x;
  sums.S_y += all * p.y;
}

/// About the parallel axis through the centre of mass; part by part, since a difference would lose digits far away.
MassMoment about_centre(const Inertia::Input& in, const Inertia::Result& r) {
  MassMoment sum = 0.0 * kg_m2, scale = sum;
  for (std::size_t k = 0; k < in.parts.size(); ++k) {
    const Part& p = in.parts[k];
    const Share& share = r.parts[k];
    const Length x = p.x - r.x_S, y = p.y - r.y_S;
    const auto square = p.n > 1 ? share.e * share.e + r.e_S * r.e_S : x * x + y * y;
    sum += sign_of(p) * p.n * (share.J_c + share.mass * square);
    scale += p.n * (share.J_c + share.mass * share.e * share.e);
  }
  return motion::without_rounding(in_si(sum), in_si(scale)) * kg_m2;
}

}  // namespace

bool Inertia::holes_fit(const Input& in) {
  if (!parts_are_complete(in)) return true;  // another rule states it
  NoTrace off;
  const Result r = evaluate(in, off);
  return in_si(r.mass) > 0.0 && in_si(r.J_S) >= 0.0;
}

template <class Tracer>
Inertia::Result Inertia::evaluate(const Input& in, Tracer& trace) {
  Result r;
  Sums sums;
  for (std::size_t k = 0; k < in.parts.size(); ++k) {
    [[maybe_unused]] const auto scope = trace.scope("parts", k);
    r.parts.push_back(share_of(in, in.parts[k], trace));
    add(in.parts[k], r.parts[k].mass, sums);
  }
  const Mass m = r.mass = trace.value("m", sums.m, "sum of the masses, holes negative");
  const MassArm S_x = trace.value("S_x", sums.S_x, "sum of m x; n equally spaced parts have none");
  const MassArm S_y = trace.value("S_y", sums.S_y, "sum of m y");
  const MassArm S_z = trace.value("S_z", sums.S_z, "sum of m z");
  STEP_TO(r, x_S, S_x / m, "centre of mass, [B35]");
  STEP_TO(r, y_S, S_y / m, "centre of mass, [B35]");
  STEP_TO(r, z_S, S_z / m, "centre of mass, [B35]");
  STEP_TO(r, e_S, sqrt(x_S * x_S + y_S * y_S), "distance of the centre of mass from the axis");
  const MassMoment J_S = r.J_S =
      trace.value("J_S", about_centre(in, r), "sum over the parts about the axis through the centre of mass, [B36]");
  r.J = NAMED_STEP("J", J_S + m * e_S * e_S, "parallel-axis theorem");
  const MassMoment J = r.J;
  STEP_TO(r, i, sqrt(J / m), "radius of gyration, J = m i^2");
  STEP_TO(r, i_S, sqrt(J_S / m), "radius of gyration, J_S = m i_S^2");
  return r;
}

template Inertia::Result Inertia::evaluate(const Input&, NoTrace&);
template Inertia::Result Inertia::evaluate(const Input&, Trace&);

}  // namespace loadpath::dynamics

template const loadpath::Calculator& loadpath::erased<loadpath::dynamics::Inertia>();
