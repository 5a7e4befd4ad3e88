#include "calculators/vessel/torus.hpp"

#include "calculators/vessel/picture.hpp"
#include "lib/calculator/calculator_of.hpp"

namespace loadpath::vessel {

namespace {

using Input = Torus::Input;

class TorusShape {
 public:
  TorusShape(Length R_0, Length r_m) : R_0_(R_0), r_m_(r_m) {}
  [[nodiscard]] std::size_t places() const { return 1; }
  [[nodiscard]] double place(std::size_t) const { return 0.0; }  // the inside of the ring
  [[nodiscard]] Length sharpest() const { return r_m_; }

  /// t around the tube from the inside of the ring, 0, over the crown, 1/4, the outside and the bottom.
  template <class Tracer>
  Place at(double t, Tracer& trace) const {
    const Length R_0 = R_0_, r_m = r_m_;
    const double s_phi = -std::cos(2.0 * pi * t);  // sine of the angle between the normal and the axis
    Place place;
    place.r = R_0 + r_m * s_phi, place.z = r_m * std::sin(2.0 * pi * t);
    trace.value("s_phi", s_phi, "-1 at the inside of the ring, where the tube is pulled most");
    STEP(r_p, R_0 + r_m * s_phi, "distance of the position from the axis");
    STEP_TO(place, rho_o, r_p / s_phi, "second principal radius of curvature; negative at a saddle");
    STEP_TO(place, kappa_M, 1.0 / r_m, "around the tube");
    STEP_TO(place, q_M, r_m * (2.0 * R_0 + r_m * s_phi) / (2.0 * r_p),
            "balance of the part between crown and position, [Timoshenko]");
    trace.value("p_l", place.p_l, "no liquid");
    trace.value("n_M", place.n_M, "no liquid");
    return place;
  }

 private:
  Length R_0_, r_m_;
};

template <class Tracer>
Length tube_radius(Length r_t, Length e, Tracer& trace) {
  trace.value("r_t", r_t, "radius of the tube as given");
  return NAMED_STEP("r_m", r_t + e, "mid-surface radius");
}

}  // namespace

template <class Tracer>
Torus::Result Torus::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const auto make = [&](Length delta_c) { return TorusShape(in.R_0, in.r + offset(in, delta_c)); };
  const auto trace_radii = [&](Length e, auto& tracer) { r.r_m = tube_radius(in.r, e, tracer); };
  assess(in, r, in.r, make, trace_radii, trace);
  return r;
}

template Torus::Result Torus::evaluate(const Input&, NoTrace&);
template Torus::Result Torus::evaluate(const Input&, Trace&);

namespace {

Section section_of(const Input& in, const Torus::Result& r) {
  const double R_0 = in_si(in.R_0), tube = in_si(in.r), r_m = in_si(r.r_m);
  Section s;
  s.middle = meridian_of(TorusShape(in.R_0, r.r_m), 180);
  s.ring = true;
  s.radius = "r";
  s.within = {R_0, 0.0};
  auto& view = s.dimensioned;
  view.lengths.push_back({{0.0, -tube}, {R_0, 0.0}, {"R_0", R_0, "mm"}, figure::Drawing::Side::below});
  view.radii.push_back({{R_0, 0.0}, tube, 0.3 * pi, {"r", tube, "mm"}});
  for (const double x : {R_0, -R_0}) {
    for (const figure::Point e : {figure::Point{1.25 * tube, 0.0}, figure::Point{0.0, 1.25 * tube}})
      view.paths.push_back({{{x - e.x, -e.y}, {x + e.x, e.y}}, figure::Drawing::Line::centre});
  }
  s.governing = figure::Point{r_m - R_0, 0.0};
  return s;
}

}  // namespace

std::vector<figure::Figure> Torus::figures(const Input& in, const Result& r) {
  return pictures(samples(TorusShape(in.R_0, r.r_m), in, r), in, r, section_of(in, r));
}

}  // namespace loadpath::vessel

template const loadpath::Calculator& loadpath::erased<loadpath::vessel::Torus>();
