#include "calculators/vessel/cylinder.hpp"

#include "calculators/vessel/picture.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::vessel {

namespace {

using Input = Cylinder::Input;
using Ends = Cylinder::Ends;

/// Liquid pressure at the lowest place.
Stress bottom_pressure(const Input& in) { return has_liquid(in) ? Stress(in.rho * gravity * in.h_l) : 0.0 * MPa; }

class CylinderShape {
 public:
  CylinderShape(const Input& in, Length R_m, Length delta_c, Length a_r)
      : in_(in), R_m_(R_m), delta_c_(delta_c), a_r_(a_r) {}
  [[nodiscard]] std::size_t places() const { return 1; }
  [[nodiscard]] double place(std::size_t) const { return 0.0; }  // the bottom, where the liquid presses most
  [[nodiscard]] Length sharpest() const { return R_m_; }
  /// Whether the required thickness is linear in the thickness that gives its radius: not next to rings.
  [[nodiscard]] bool is_straight() const { return in_.ends != Ends::ringed; }

  template <class Tracer>
  Place at(double t, Tracer& trace) const {
    Place place;
    const Length R_m = R_m_;
    place.r = R_m, place.z = t * height();
    if (has_liquid(in_)) {
      place.p_l = head(in_, place.z, trace);
    } else {
      trace.value("p_l", place.p_l, "no liquid");
    }
    STEP_TO(place, rho_o, R_m, "hoop: the radius of the cylinder");
    place.kappa_M = trace.value("kappa_M", 0.0 / R_m, "the meridian is straight");
    pull(place, trace);
    if (in_.ends == Ends::ringed) share(place, trace);
    return place;
  }

 private:
  [[nodiscard]] Length height() const { return has_liquid(in_) ? in_.h_l : 2.0 * R_m_; }

  template <class Tracer>
  void pull(Place& place, Tracer& trace) const {
    const bool closed = in_.ends != Ends::open;
    const Length R_m = R_m_;
    const Stress p_0 = bottom_pressure(in_);
    if (closed) {
      STEP_TO(place, q_M, R_m / 2.0, "pull of the ends over the circumference, [B24] (11)");
    } else {
      place.q_M = trace.value("q_M", 0.0 * R_m, "no ends, no pull, [B24] (10)");
    }
    if (closed && in_.support == Cylinder::Support::top) {
      trace.value("p_0", p_0, "pressure of the liquid on the bottom, which the wall holds");
      STEP_TO(place, n_M, p_0 * R_m / 2.0, "weight of the liquid over the circumference");
    } else {
      trace.value("n_M", place.n_M, "of the liquid: none");
    }
  }

  template <class Tracer>
  void share(Place& place, Tracer& trace) const {
    const Length delta_c = delta_c_, a_r = a_r_;
    STEP_TO(place, w_o, delta_c / (delta_c + a_r),
            "rings and wall stretch alike, so they share the hoop force by their sections");
  }

  const Input& in_;
  Length R_m_, delta_c_, a_r_;
};

/// The existing rings, or rings that could carry the full hoop force, as the textbook assumes.
template <class Tracer>
Length rings(const Input& in, Stress sigma_all, Tracer& trace) {
  if (in.ends != Ends::ringed) return 0.0 * mm;
  if (is_set(in.A_r)) return NAMED_STEP("a_r", in.A_r / in.l_r, "section of the rings per length");
  const Stress p_0 = trace.value("p_0", bottom_pressure(in), "pressure of the liquid at the lowest position");
  return NAMED_STEP("a_r", (in.p + p_0) * in.R / sigma_all,
                    "rings that could take the full hoop force, as [B24] assumes");
}

/// Where the hoop stress comes from: the forces on a small element of the wall, and the pull of the ends.
template <class Tracer>
void balance(const Input& in, const Cylinder::Result& r, Tracer& trace) {
  const bool rings_help = in.ends == Ends::ringed;
  if (rings_help || !(r.p_i > 0.0 * MPa) || !is_set(r.sigma_o)) return;
  const double theta_e = trace.angle("theta_e", pi / 180.0, "angle of a small element of the wall");
  const Length z_e = trace.value("z_e", 1.0 * mm, "length of the element along the axis");
  STEP(F_p, r.p_i * r.R_m * theta_e * z_e, "pressure on the element, outwards, [B24]");
  STEP(F_o, r.sigma_o * r.delta_c * z_e, "hoop force on each of its two sides");
  STEP(F_i, F_o * theta_e, "both inwards: each is inclined by half of the small angle, and the meridian is straight");
  STEP(x_F, F_i / F_p, "equilibrium of the element normal to the wall: p R theta_e z_e = sigma_o delta theta_e z_e");
  if (in.ends == Ends::open || has_liquid(in)) return;
  STEP(F_e, pi * pow<2>(r.R_m) * in.p, "pressure on an end, along the axis");
  STEP(F_M, 2.0 * pi * r.R_m * r.delta_c * r.sigma_M, "force of the wall: axial equilibrium of the end, [B24] (11)");
}

/// The thicknesses of the book: each stress by itself.
template <class Tracer>
void by_the_book(const Input& in, Cylinder::Result& r, Tracer& trace) {
  STEP_TO(r, delta_o, r.p_i * r.R_m / (in.z_l * r.sigma_all), "hoop stress only, [B24] (10)");
  STEP_TO(r, delta_M, r.sigma_M * r.delta_c / (in.z_c * r.sigma_all), "meridional stress only, [B24] (11)");
}

template <class Tracer>
void check_rings(const Input& in, Cylinder::Result& r, Tracer& trace) {
  if (!is_set(in.l_r)) return;
  STEP_TO(r, w_r, in.l_r / (1.56 * sqrt(r.R_m * r.delta_c)),
          "a ring helps over 0.78 sqrt(R delta) on either side, [Timoshenko]");
}

/// A round plate that rests on the wall: 3 (3 + nu)/8 = 1.24 for nu = 0.3 in its middle. A wall that is thin holds its
/// edge little, which is on the safe side.
template <class Tracer>
void flat_ends(const Input& in, Cylinder::Result& r, Tracer& trace) {
  if (!is_set(in.delta_e) || in.ends == Ends::open) return;
  STEP(delta_ec, in.delta_e * (1.0 - in.f_t) - in.c - in.c_t,
       "thickness of the ends less corrosion and mill tolerance");
  const Stress p_b = trace.value("p_b", in.p + bottom_pressure(in), "gas and liquid on the lower end");
  STEP_TO(r, sigma_e, 1.24 * p_b * pow<2>(r.R_m / delta_ec), "flat round plate that rests on its edge, [Timoshenko]");
  STEP_TO(r, u_e, sigma_e / r.sigma_all, "strength of flat ends");
}

/// The new wall, not yet corroded, at its test pressure.
template <class Tracer>
void hydrostatic_test(const Input& in, Cylinder::Result& r, Tracer& trace) {
  if (!is_set(in.p_t)) return;
  NoTrace off;
  const Stress p_w = test_requirements(in, true, r, trace);
  Input fresh = in;
  fresh.c = 0.0 * mm, fresh.rho = unset<Density>;  // the head of the test is in p_w
  const Length delta = trace.value("delta", r.delta, "nominal");
  STEP(delta_n, delta * (1.0 - in.f_t) - in.c_t, "wall of the new vessel");
  const Length R_n = trace.value("R_n", in.R + offset(fresh, delta, delta_n, off), "middle of the new wall");
  const Strength strength = strength_of(fresh, r.f_test);
  const CylinderShape shape(fresh, R_n, delta_n, 0.0 * mm);
  const Stress sigma_vt = trace.value(
      "sigma_vt", equivalent(membrane(shape.at(0.0, off), p_w, delta_n, strength, off), strength.hypothesis, off),
      "equivalent stress of the new wall in the test, as in service");
  STEP_TO(r, u_t, sigma_vt / r.f_test, "new wall in the test");
}

/// What its ends close.
ShellOfEnds closed_by_ends(const Input& in, const Cylinder::Result& r) {
  return {r.p_i, 2.0 * (r.R_m - 0.5 * r.delta_c - in.c), in.c};
}

/// The nominal wall from outside.
WallOutside from_outside(const Input& in, Length delta) {
  const double share = in.measured == Measured::inner ? 1.0 : in.measured == Measured::mean ? 0.5 : 0.0;
  return {2.0 * (in.R + share * delta), delta, in.c, in.c_t, in.f_t};
}

}  // namespace

template <class Tracer>
Cylinder::Result Cylinder::evaluate(const Input& in, Tracer& trace) {
  NoTrace off;
  Result r;
  const Stress sigma_all = allowable(in, off);
  const Length a_r = rings(in, sigma_all, off);
  const auto mean = [&](Length delta_c) { return in.R + offset(in, delta_c); };
  const auto make = [&](Length delta_c) { return CylinderShape(in, mean(delta_c), delta_c, a_r); };
  const auto trace_radii = [&](Length e, auto& tracer) {
    r.R_m = mean_radius(in.R, e, tracer);
    if (in.ends == Ends::ringed) r.a_r = rings(in, sigma_all, tracer);
  };
  assess(in, r, in.R, make, trace_radii, trace);
  balance(in, r, trace);
  by_the_book(in, r, trace);
  if (in.ends != Ends::ringed && !has_liquid(in)) grow_cylinder(in, r.R_m, r.sigma_o, r.sigma_M, r, trace);
  check_rings(in, r, trace);
  flat_ends(in, r, trace);
  hydrostatic_test(in, r, trace);
  if (in.ends != Ends::open) r.shell = closed_by_ends(in, r);
  r.wall = from_outside(in, r.delta);
  if (in.ends != Ends::ringed) compare(ThickCylinder{in.ends == Ends::closed}, in, r, r.R_m, mean, trace);
  return r;
}

template Cylinder::Result Cylinder::evaluate(const Input&, NoTrace&);
template Cylinder::Result Cylinder::evaluate(const Input&, Trace&);

namespace {

/// Their form is not known: squares of their section.
void draw_rings(const Input& in, double outside, double height, figure::Drawing::View& view) {
  constexpr int most = 40;
  if (!is_set(in.l_r) || !is_set(in.A_r)) return;
  const double l_r = in_si(in.l_r), side = std::sqrt(in_si(in.A_r));
  int count = 0;
  for (double z = 0.5 * l_r; z < height && count < most; z += l_r, ++count) {
    for (const double x : {outside, -outside - side}) {
      view.areas.push_back(
          {{{x, z - 0.5 * side}, {x + side, z - 0.5 * side}, {x + side, z + 0.5 * side}, {x, z + 0.5 * side}},
           figure::Drawing::Kind::cut});
    }
  }
  if (count > 1) {
    view.lengths.push_back(
        {{-outside - side, 0.5 * l_r}, {-outside - side, 1.5 * l_r}, {"l_r", l_r, "mm"}, figure::Drawing::Side::left});
  }
}

/// A vessel whose length no input says is drawn as high as it is wide, or a little higher than its liquid.
Section section_of(const Input& in, const Cylinder::Result& r) {
  const double R_m = in_si(r.R_m), R = in_si(in.R), h = has_liquid(in) ? in_si(in.h_l) : 0.0;
  const double height = h > 0.0 ? 1.12 * h : 2.0 * R;
  Section s;
  s.middle = {{R_m, 0.0}, {R_m, 0.5 * height}, {R_m, height}};
  s.within = {0.0, h > 0.0 ? 0.5 * h : 0.5 * height};
  s.broken_start = !(h > 0.0), s.broken_end = true;
  if (h > 0.0) {
    s.surface = h;
    s.governing = figure::Point{R_m, 0.0};
    s.dimensioned.lengths.push_back({{R, 0.0}, {R, h}, {"h_l", h, "mm"}, figure::Drawing::Side::right});
  }
  s.dimensioned.lengths.push_back({{0.0, 0.0}, {R, 0.0}, {"R", R, "mm"}, figure::Drawing::Side::below});
  draw_rings(in, R + inside_of(in, in_si(r.delta)) + in_si(r.delta), height, s.dimensioned);
  return s;
}

}  // namespace

std::vector<figure::Figure> Cylinder::figures(const Input& in, const Result& r) {
  const Length a_r = is_set(r.a_r) ? r.a_r : 0.0 * mm;
  return pictures(samples(CylinderShape(in, r.R_m, r.delta_c, a_r), in, r), in, r, section_of(in, r));
}

}  // namespace loadpath::vessel

template const loadpath::Calculator& loadpath::erased<loadpath::vessel::Cylinder>();
