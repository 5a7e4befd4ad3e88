#include "calculators/vessel/sphere.hpp"

#include "calculators/vessel/picture.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::vessel {

namespace {

using Input = Sphere::Input;

class SphereShape {
 public:
  static constexpr bool continuous = true;

  SphereShape(const Input& in, Length R_m) : in_(in), R_m_(R_m), wet_(has_liquid(in)) {
    if (wet_) look_at_places();
  }

  [[nodiscard]] std::size_t places() const { return places_.size(); }
  [[nodiscard]] double place(std::size_t i) const { return places_[i]; }
  [[nodiscard]] Length sharpest() const { return R_m_; }

  /// t from the top, 0, to the bottom, 1.
  template <class Tracer>
  Place at(double t, Tracer& trace) const {
    Place place;
    const Length R_m = R_m_;
    const double phi = t * pi;
    place.r = R_m * std::sin(phi), place.z = R_m * (1.0 + std::cos(phi));
    STEP_TO(place, rho_o, R_m, "the sphere is curved alike in all directions, [B24]");
    STEP_TO(place, kappa_M, 1.0 / R_m, "along the meridian too");
    STEP_TO(place, q_M, R_m / 2.0, "pressure on the cap over its circumference, [B24]");
    if (wet_) {
      trace.angle("phi", phi, "of the governing location, from the top");
      place.p_l = head(in_, place.z, trace);
      place.n_M = phi > in_.phi_s ? below(phi) : above(phi);
    } else {
      trace.value("p_l", place.p_l, "no liquid");
    }
    trace.value("n_M", place.n_M,
                wet_ ? "liquid on the cap beyond the section, by integration, [Timoshenko]" : "no liquid");
    return place;
  }

 private:
  static constexpr std::size_t even = 64;

  /// Gas presses alike everywhere. With a liquid: even places, its edge, and the ring from above and from below.
  void look_at_places() {
    const double ring = in_.phi_s / pi, edge = std::acos(std::clamp(in_si(in_.h_l / R_m_) - 1.0, -1.0, 1.0)) / pi;
    places_ = {ring * (1.0 - 1e-12), ring * (1.0 + 1e-12), edge};
    for (std::size_t i = 0; i < even; ++i) places_.push_back((static_cast<double>(i) + 1.0) / even);
    std::sort(places_.begin(), places_.end());
  }

  /// Force of the liquid on the lower cap, over its circumference; written so that the pole needs no exception.
  [[nodiscard]] Tension below(double phi) const {
    const Length h = in_.h_l, R = R_m_;
    const double surface = in_si((R - h) / R);  // cosine of the liquid's edge, from the bottom
    const double c = -std::cos(phi), c_wet = std::max(c, surface);
    const Tension wet =
        in_.rho * gravity * R * ((h - R) / 2.0 + R * (1.0 + c_wet + c_wet * c_wet) / (3.0 * (1.0 + c_wet)));
    return c >= surface ? wet : wet * ((1.0 - c_wet * c_wet) / (1.0 - c * c));
  }

  /// The same for the upper cap, which the liquid lifts.
  [[nodiscard]] Tension above(double phi) const {
    const Length h = in_.h_l, R = R_m_;
    const double c = std::cos(phi), edge = in_si((h - R) / R);
    if (c >= edge || c >= 1.0) return from_si<Tension>(0.0);
    const double s2 = 1.0 - c * c, s2_edge = 1.0 - edge * edge;
    const Length lifted = (h - R) * (s2 - s2_edge) / 2.0 - R * (edge * edge * edge - c * c * c) / 3.0;
    return in_.rho * gravity * R * lifted / s2;
  }

  const Input& in_;
  Length R_m_;
  bool wet_;
  List<double, even + 3> places_{0.5};
};

}  // namespace

Applies Sphere::compressed(const Input& in) {
  return where(has_liquid(in) && pressed(SphereShape(in, in.R), in.p).elsewhere);
}

template <class Tracer>
Sphere::Result Sphere::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const auto mean = [&](Length delta_c) { return in.R + offset(in, delta_c); };
  const auto make = [&](Length delta_c) { return SphereShape(in, mean(delta_c)); };
  const auto trace_radii = [&](Length e, auto& tracer) { r.R_m = mean_radius(in.R, e, tracer); };
  const double t = assess(in, r, in.R, make, trace_radii, trace);
  r.phi = has_liquid(in) ? t * pi : unset<double>;
  if (!has_liquid(in)) grow_sphere(in, r.R_m, r.sigma_o, r, trace);
  if (!has_liquid(in)) compare(ThickSphere{}, in, r, r.R_m, mean, trace);
  return r;
}

template Sphere::Result Sphere::evaluate(const Input&, NoTrace&);
template Sphere::Result Sphere::evaluate(const Input&, Trace&);

namespace {

/// From the lowest place, which heights count from.
Section section_of(const Input& in, const Sphere::Result& r) {
  const double R = in_si(in.R), R_m = in_si(r.R_m);
  Section s;
  constexpr int count = 180;
  for (int i = 0; i <= count; ++i) {
    const double phi = pi * i / count;
    s.middle.push_back({R_m * std::sin(phi), R_m * (1.0 + std::cos(phi))});
  }
  const figure::Point centre{0.0, R_m};
  s.within = centre;
  auto& view = s.dimensioned;
  view.radii.push_back({centre, R, 0.25 * pi, {"R", R, "mm"}});
  if (!has_liquid(in)) return s;
  const double h = in_si(in.h_l);
  if (h > 0.0) {
    s.surface = h;
    view.lengths.push_back({{0.0, 0.0}, {0.0, h}, {"h_l", h, "mm"}, figure::Drawing::Side::left});
  }
  view.angles.push_back({centre, 0.28 * R, 0.5 * pi, -in.phi_s, {"phi_s", in.phi_s, "deg"}, true});
  const double out = R_m + in_si(r.delta);
  view.names.push_back({{out * std::sin(in.phi_s), centre.y + out * std::cos(in.phi_s)}, say("ring").text()});
  if (is_set(r.phi)) s.governing = figure::Point{-R_m * std::sin(r.phi), centre.y + R_m * std::cos(r.phi)};
  return s;
}

}  // namespace

std::vector<figure::Figure> Sphere::figures(const Input& in, const Result& r) {
  return pictures(samples(SphereShape(in, r.R_m), in, r), in, r, section_of(in, r));
}

}  // namespace loadpath::vessel

template const loadpath::Calculator& loadpath::erased<loadpath::vessel::Sphere>();
