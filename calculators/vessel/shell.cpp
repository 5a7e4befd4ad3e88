#include "calculators/vessel/shell.hpp"

#include "calculators/vessel/picture.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::vessel {

namespace {

using Input = Shell::Input;

Meridian meridian_of(const Input& in, Length delta_c) {
  Meridian points;
  for (const auto& p : in.points) {
    MeridianPoint at;
    at.r = in_si(p.r), at.z = in_si(p.z);
    points.push_back(at);
  }
  const bool wet = has_liquid(in);
  return meridian(points, in_si(offset(in, delta_c)), {in.start == Shell::Start::closed},
                  wet ? in_si(in.rho) * in_si(gravity) : 0.0, wet ? in_si(in.h_l) : 0.0);
}

class ShellShape {
 public:
  ShellShape(const Input& in, Length delta_c) : in_(in), points_(meridian_of(in, delta_c)) {}
  [[nodiscard]] std::size_t places() const { return points_.size(); }
  [[nodiscard]] double place(std::size_t i) const { return static_cast<double>(i); }
  [[nodiscard]] const Meridian& points() const { return points_; }

  [[nodiscard]] Length sharpest() const {
    double least = in_si(rho_of(points_.front()));
    for (const MeridianPoint& p : points_) {
      least = std::min(least, std::abs(in_si(rho_of(p))));
      if (p.kappa != 0.0) least = std::min(least, 1.0 / std::abs(p.kappa));
    }
    return from_si<Length>(least);
  }

  /// The point of number t.
  template <class Tracer>
  Place at(double t, Tracer& trace) const {
    const MeridianPoint& point = points_[static_cast<std::size_t>(t)];
    Place place;
    const bool pole = point.r == 0.0;
    const Length r = from_si<Length>(point.r), z = from_si<Length>(point.z);
    const auto kappa_M = from_si<Curvature>(point.kappa);
    place.r = r, place.z = z, place.kappa_M = kappa_M;
    if (has_liquid(in_)) {
      place.p_l = head(in_, z, trace);
    } else {
      trace.value("p_l", place.p_l, "no liquid");
    }
    trace.value("r", r, "distance of the governing location from the axis");
    trace.value("kappa_M", kappa_M, "curvature of the circle through the point and its neighbours");
    place.rho_o = rho_of(point);
    if (pole) {
      place.q_M = place.rho_o / 2.0;
      place.n_M = place.p_l * place.rho_o / 2.0;
    } else {
      place.q_M = from_si<Length>(point.gas / (point.r * point.sine));
      place.n_M = from_si<Tension>(point.liquid / (point.r * point.sine));
    }
    trace.value("rho_o", place.rho_o, "normal to the meridian, up to the axis");
    trace.value("q_M", place.q_M, "area before the position over the upright part of its circumference");
    trace.value("n_M", place.n_M, "axial force of the liquid on the part before the location");
    return place;
  }

  /// The widest radius over the largest of curvature across the meridian: of a flat place 0.
  [[nodiscard]] double least_slope() const {
    double widest = 0.0, least = std::numeric_limits<double>::infinity();
    for (const MeridianPoint& p : points_) widest = std::max(widest, p.r);
    for (const MeridianPoint& p : points_) {
      if (p.r > 0.0) least = std::min(least, widest * std::abs(p.sine) / p.r);
    }
    return least;
  }

  /// The largest change of the curvature between neighbours, over that across the meridian.
  [[nodiscard]] double largest_jump() const {
    double largest = 0.0;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      for (const MeridianPoint& p : {points_[i - 1], points_[i]}) {
        if (p.r > 0.0 && p.sine == 0.0) continue;  // flat: another limit says so
        const double jump = std::abs((points_[i].kappa - points_[i - 1].kappa) * in_si(rho_of(p)));
        largest = std::max(largest, jump);
      }
    }
    return largest;
  }

 private:
  /// At a pole both radii are one.
  static Length rho_of(const MeridianPoint& p) { return from_si<Length>(p.r == 0.0 ? 1.0 / p.kappa : p.r / p.sine); }

  const Input& in_;
  Meridian points_;
};

void tabulate(const ShellShape& shell, const Input& in, Shell::Result& r) {
  NoTrace off;
  for (std::size_t i = 0; i < shell.places(); ++i) {
    const Place place = shell.at(shell.place(i), off);
    const auto s = membrane(place, in.p, r.delta_c, strength_of(in, r.sigma_all), off);
    const Stress sigma_v = equivalent(s, in.hypothesis, off);
    const double kappa = in_si(place.kappa_M) * in_si(place.rho_o);
    const bool straight = std::abs(kappa) < 1e-9;
    r.along.push_back(
        {place.r, place.z, place.rho_o, straight ? unset<Length> : place.rho_o / kappa, s.o, s.M, sigma_v});
  }
}

/// Where a hoop stress is a compression, the flattest place counts as the crown.
template <class Tracer>
void knuckle(Shell::Result& r, Tracer& trace) {
  Length flattest = 0.0 * mm;
  bool compressed = false;
  for (const auto& a : r.along) {
    if (std::isfinite(in_si(a.rho_o))) flattest = max(flattest, abs(a.rho_o));
    compressed = compressed || a.sigma_o < -1e-9 * r.sigma_all;
  }
  r.w_b = compressed ? knuckle_slenderness(flattest, r.delta_c, trace) : 0.0;
}

}  // namespace

Applies Shell::knuckle_compressed(const Input& in) { return where(pressed(ShellShape(in, 0.0 * mm), in.p).in_knuckle); }

Applies Shell::compressed(const Input& in) { return where(pressed(ShellShape(in, 0.0 * mm), in.p).elsewhere); }

bool Shell::long_enough(const Input& in) { return in.points.size() >= 3; }

bool Shell::apart(const Input& in) {
  for (std::size_t i = 1; i < in.points.size(); ++i) {
    if (in.points[i].r == in.points[i - 1].r && in.points[i].z == in.points[i - 1].z) return false;
  }
  return true;
}

bool Shell::is_loaded(const Input& in) {
  return in.p > 0.0 * MPa || !has_liquid(in) ||
         std::any_of(in.points.begin(), in.points.end(), [&](const Point& point) { return point.z < in.h_l; });
}

bool Shell::held_off_axis(const Input& in) {
  if (in.points.size() < 3) return true;  // another rule says so
  return in.points.back().z != in.points.front().z &&
         std::all_of(in.points.begin() + 1, in.points.end(), [](const Point& p) { return p.r > 0.0 * mm; });
}

template <class Tracer>
Shell::Result Shell::evaluate(const Input& in, Tracer& trace) {
  Result r;
  Length widest = 0.0 * mm;
  for (const auto& p : in.points) widest = max(widest, p.r);
  const auto make = [&](Length delta_c) { return ShellShape(in, delta_c); };
  const auto trace_radii = [](Length, auto&) {};
  const double t = assess(in, r, widest, make, trace_radii, trace);
  const ShellShape shell = make(r.delta_c);
  const MeridianPoint& governing = shell.points()[static_cast<std::size_t>(t)];
  r.r = from_si<Length>(governing.r), r.z = from_si<Length>(governing.z);
  double turn = 0.0;
  for (const MeridianPoint& p : shell.points()) turn = std::max(turn, p.turn);
  r.psi_max = trace.value("psi_max", turn, "sharpest turn of the meridian");
  r.s_min = trace.value("s_min", shell.least_slope(), "the widest radius over rho_o, where the shell is flattest");
  Length flattest = 0.0 * mm;
  for (std::size_t i = 0; i < shell.places(); ++i) {
    NoTrace off;
    flattest = max(flattest, abs(shell.at(shell.place(i), off).rho_o));
  }
  r.x_s = shallowness_of(widest, flattest, r.delta_c, trace);
  r.w_kappa =
      trace.value("w_kappa", shell.largest_jump(), "maximum change of kappa_M from one point to the next, times rho_o");
  tabulate(shell, in, r);
  knuckle(r, trace);
  return r;
}

template Shell::Result Shell::evaluate(const Input&, NoTrace&);
template Shell::Result Shell::evaluate(const Input&, Trace&);

namespace {

Section section_of(const Input& in, const Shell::Result& r) {
  Section s;
  for (const auto& a : r.along) s.middle.push_back({in_si(a.r), in_si(a.z)});
  s.radius = "r";
  const double end = in_si(in.points.back().z);
  s.within = {0.0, end};
  auto& view = s.dimensioned;
  const auto widest =
      std::max_element(in.points.begin(), in.points.end(), [](const auto& a, const auto& b) { return a.r < b.r; });
  const figure::Point at{in_si(widest->r), in_si(widest->z)};
  view.lengths.push_back({{0.0, at.y}, at, {"r", at.x, "mm"}, figure::Drawing::Side::below});
  if (has_liquid(in)) {
    const double h = in_si(in.h_l);
    s.surface = h;
    view.names.push_back({{0.0, h}, "", figure::Drawing::Value{"h_l", h, "mm"}});
  }
  s.governing = figure::Point{-in_si(r.r), in_si(r.z)};
  return s;
}

}  // namespace

std::vector<figure::Figure> Shell::figures(const Input& in, const Result& r) {
  std::vector<Sample> along;
  for (const Along& a : r.along) along.push_back({in_si(a.r), in_si(a.z), in_si(a.sigma_o), in_si(a.sigma_M)});
  return pictures(along, in, r, section_of(in, r));
}

}  // namespace loadpath::vessel

template const loadpath::Calculator& loadpath::erased<loadpath::vessel::Shell>();
