#include "calculators/vessel/cone.hpp"

#include "calculators/vessel/picture.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::vessel {

namespace {

using Input = Cone::Input;

class ConeShape {
 public:
  static constexpr bool continuous = true;

  ConeShape(const Input& in, Length R_m) : in_(in), R_m_(R_m), wet_(has_liquid(in)) {
    if (wet_) look_at_places();
  }

  [[nodiscard]] std::size_t places() const { return places_.size(); }
  [[nodiscard]] double place(std::size_t i) const { return places_[i]; }
  [[nodiscard]] Length sharpest() const { return R_m_ / std::cos(in_.alpha); }

  /// t from the point, 0, to the large end, 1.
  template <class Tracer>
  Place at(double t, Tracer& trace) const {
    using std::cos;
    Place place;
    const Length r = t * R_m_;
    place.r = r, place.z = r / std::tan(in_.alpha);
    trace.value("r", r, "mean radius at the governing location");
    STEP_TO(place, rho_o, r / cos(in_.alpha), "second principal radius of curvature");
    place.kappa_M = trace.value("kappa_M", 0.0 / r, "the meridian is straight");
    STEP_TO(place, q_M, r / (2.0 * cos(in_.alpha)), "axial equilibrium of the part beyond this location");
    if (wet_) {
      place.p_l = head(in_, place.z, trace);
      hang(place, trace);
    } else {
      trace.value("p_l", place.p_l, "no liquid");
      trace.value("n_M", place.n_M, "no liquid");
    }
    return place;
  }

 private:
  static constexpr std::size_t even = 128;

  /// Gas loads the large end most. With a liquid: even places, and its edge.
  void look_at_places() {
    const double edge = in_si(in_.h_l * std::tan(in_.alpha) / R_m_);
    places_ = {};
    if (edge < 1.0 && edge > 0.0) places_.push_back(edge);
    for (std::size_t i = 0; i < even; ++i) places_.push_back((static_cast<double>(i) + 1.0) / even);
    std::sort(places_.begin(), places_.end());
  }

  /// The liquid suspended below the place: all above the section, and the point below it.
  template <class Tracer>
  void hang(Place& place, Tracer& trace) const {
    using std::cos, std::tan;
    const Acceleration g_n = gravity;
    const Length r = place.r;
    STEP(r_l, min(r, in_.h_l * tan(in_.alpha)), "radius up to which the liquid loads the wall below the position");
    STEP_TO(place, n_M,
            in_.rho * g_n * pow<2>(r_l) * (in_.h_l / 2.0 - r_l / (3.0 * tan(in_.alpha))) / (r * cos(in_.alpha)),
            "weight of the liquid below and above the section, [ExpertsMind-cone]");
  }

  const Input& in_;
  Length R_m_;
  bool wet_;
  List<double, even + 1> places_{1.0};
};

template <class Tracer>
Length mean_radius(const Input& in, Length e, Tracer& trace) {
  return NAMED_STEP("R_m", in.R + e * cos(in.alpha), "mid-surface radius at the large end");
}

}  // namespace

template <class Tracer>
Cone::Result Cone::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const auto make = [&](Length delta_c) { return ConeShape(in, in.R + offset(in, delta_c) * std::cos(in.alpha)); };
  const auto trace_radii = [&](Length e, auto& tracer) { r.R_m = mean_radius(in, e, tracer); };
  r.r = assess(in, r, in.R, make, trace_radii, trace) * r.R_m;
  r.x_s = shallowness_of(r.R_m, r.R_m / std::cos(in.alpha), r.delta_c, trace);
  return r;
}

template Cone::Result Cone::evaluate(const Input&, NoTrace&);
template Cone::Result Cone::evaluate(const Input&, Trace&);

namespace {

Section section_of(const Input& in, const Cone::Result& r) {
  const double R = in_si(in.R), R_m = in_si(r.R_m), high = R_m / std::tan(in.alpha);
  Section s;
  s.middle = {{0.0, 0.0}, {0.25 * R_m, 0.25 * high}, {0.5 * R_m, 0.5 * high}, {R_m, high}};
  s.within = {0.0, 0.8 * high};
  auto& view = s.dimensioned;
  view.lengths.push_back({{0.0, high}, {R, high}, {"R", R, "mm"}, figure::Drawing::Side::above});
  view.angles.push_back({{0.0, 0.0}, 0.45 * high, 0.5 * pi, -in.alpha, {"alpha", in.alpha, "deg"}});
  if (has_liquid(in) && in.h_l > 0.0 * mm) {
    const double h = in_si(in.h_l);
    s.surface = h;
    view.lengths.push_back({{0.0, 0.0}, {h * std::tan(in.alpha), h}, {"h_l", h, "mm"}, figure::Drawing::Side::right});
  }
  const double place = in_si(r.r);
  s.governing = figure::Point{-place, place / std::tan(in.alpha)};
  return s;
}

}  // namespace

std::vector<figure::Figure> Cone::figures(const Input& in, const Result& r) {
  return pictures(samples(ConeShape(in, r.R_m), in, r), in, r, section_of(in, r));
}

}  // namespace loadpath::vessel

template const loadpath::Calculator& loadpath::erased<loadpath::vessel::Cone>();
