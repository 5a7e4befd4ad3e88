#include "calculators/vessel/ellipsoid.hpp"

#include "calculators/vessel/picture.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::vessel {

namespace {

using Input = Ellipsoid::Input;

class EllipsoidShape {
 public:
  static constexpr bool continuous = true;

  EllipsoidShape(Length a_m, Length b_m) : a_m_(a_m), b_m_(b_m) {}
  [[nodiscard]] std::size_t places() const { return 33; }
  [[nodiscard]] double place(std::size_t i) const { return static_cast<double>(i) / 32.0; }
  [[nodiscard]] Length sharpest() const { return min(a_m_ * a_m_ / b_m_, b_m_ * b_m_ / a_m_); }

  /// t of the quarter ellipse, from the pole, 0, to the equator, 1.
  template <class Tracer>
  Place at(double t, Tracer& trace) const {
    const Length a_m = a_m_, b_m = b_m_;
    const bool equator = t == 1.0;  // exactly: the cosine of pi/2 is not quite zero
    Place place;
    place.r = equator ? a_m : a_m * std::sin(0.5 * pi * t);
    place.z = equator ? 0.0 * b_m : b_m * std::cos(0.5 * pi * t);
    const Length r = trace.value("r", place.r, "distance of the governing location from the axis");
    const Length z = trace.value("z", place.z, "height above the equator");
    STEP(w, sqrt(pow<2>(a_m * z / b_m) + pow<2>(b_m * r / a_m)), "auxiliary value of the radii of curvature");
    STEP_TO(place, rho_o, a_m / b_m * w, "second principal radius of curvature");
    STEP_TO(place, kappa_M, a_m * b_m / pow<3>(w), "curvature of the ellipse");
    STEP_TO(place, q_M, a_m / b_m * w / 2.0, "axial equilibrium of the part beyond this location");
    trace.value("p_l", place.p_l, "no liquid");
    trace.value("n_M", place.n_M, "no liquid");
    return place;
  }

 private:
  Length a_m_, b_m_;
};

template <class Tracer>
void mean_axes(const Input& in, Ellipsoid::Result& r, Length e, Tracer& trace) {
  STEP_TO(r, a_m, in.a + e, "mid-surface semi-axis, across");
  STEP_TO(r, b_m, in.b + e, "mid-surface semi-axis, along");
}

/// The stresses of pole and equator in their known form, and the bound of the hoop compression of flat heads.
template <class Tracer>
void ends(const Input& in, Ellipsoid::Result& r, Tracer& trace) {
  STEP_TO(r, sigma_pole, in.p * pow<2>(r.a_m) / (2.0 * r.b_m * r.delta_c), "pole, [Timoshenko]");
  STEP_TO(r, sigma_eq, in.p * r.a_m / r.delta_c * (1.0 - pow<2>(r.a_m / r.b_m) / 2.0),
          "hoop stress of the equator, [Timoshenko]");
  r.w_b = sigma_eq < 0.0 * MPa ? knuckle_slenderness(r.a_m * r.a_m / r.b_m, r.delta_c, trace) : 0.0;
}

}  // namespace

template <class Tracer>
Ellipsoid::Result Ellipsoid::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const auto make = [&](Length delta_c) {
    const Length e = offset(in, delta_c);
    return EllipsoidShape(in.a + e, in.b + e);
  };
  const auto trace_radii = [&](Length e, auto& tracer) { mean_axes(in, r, e, tracer); };
  const double t = assess(in, r, in.a, make, trace_radii, trace);
  NoTrace off;
  r.r = EllipsoidShape(r.a_m, r.b_m).at(t, off).r;
  ends(in, r, trace);
  const Length flattest = r.a_m * r.a_m / r.b_m;
  r.x_s = shallowness_of(r.a_m, flattest, r.delta_c, trace);
  return r;
}

template Ellipsoid::Result Ellipsoid::evaluate(const Input&, NoTrace&);
template Ellipsoid::Result Ellipsoid::evaluate(const Input&, Trace&);

namespace {

Section section_of(const Input& in, const Ellipsoid::Result& r) {
  const double a = in_si(in.a), b = in_si(in.b), a_m = in_si(r.a_m), b_m = in_si(r.b_m);
  Section s;
  s.middle = meridian_of(EllipsoidShape(r.a_m, r.b_m), 120);
  s.within = {0.0, 0.35 * b};
  s.radius = "a, b";
  auto& view = s.dimensioned;
  view.lengths.push_back({{0.0, 0.0}, {a, 0.0}, {"a", a, "mm"}, figure::Drawing::Side::below});
  view.lengths.push_back({{a, 0.0}, {0.0, b}, {"b", b, "mm"}, figure::Drawing::Side::right});
  const double place = in_si(r.r);
  s.governing = figure::Point{-place, b_m * std::sqrt(std::max(0.0, 1.0 - place * place / (a_m * a_m)))};
  return s;
}

}  // namespace

std::vector<figure::Figure> Ellipsoid::figures(const Input& in, const Result& r) {
  return pictures(samples(EllipsoidShape(r.a_m, r.b_m), in, r), in, r, section_of(in, r));
}

}  // namespace loadpath::vessel

template const loadpath::Calculator& loadpath::erased<loadpath::vessel::Ellipsoid>();
