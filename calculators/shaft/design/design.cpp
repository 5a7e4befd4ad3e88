#include "calculators/shaft/design/design.hpp"

#include "calculators/shaft/design/bearing_seats.hpp"
#include "calculators/shaft/design/connections.hpp"
#include "calculators/shaft/design/model/bending.hpp"
#include "calculators/shaft/design/model/misalignment.hpp"
#include "calculators/shaft/design/model/positions.hpp"
#include "calculators/shaft/design/model/turn.hpp"
#include "calculators/shaft/design/sections.hpp"
#include "calculators/shaft/design/tapers.hpp"
#include "calculators/shaft/design/torsion.hpp"
#include "calculators/shaft/design/whirl.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::shaft {

namespace {

using Input = Design::Input;
using Result = Design::Result;

template <class Element>
double slope_over(double beta, const Element& element) {
  return is_set(element.beta_adm) ? beta / element.beta_adm : unset<double>;
}

/// Forces of a bearing over the turn, as that constant one under which it lasts as long: with 10/3 as exponent, of
/// roller bearings, it is never below that with 3, of balls.
constexpr double p_L = 10.0 / 3.0;
using OfBearings = List<double, most_supports>;

/// Where the shaft twists most; unset if it does not.
SecondMoment polar_moment(const Input& in, const Loaded& loaded) {
  if (!(loaded.flexible > 0.0)) return unset<SecondMoment>;
  return from_si<SecondMoment>(1.0 / (in_si(in.G) * loaded.flexible));
}

/// Bearing loads, and the places of the largest displacement, over all positions so far.
class Movement {
 public:
  Movement(const Input& in, const Elastic& elastic, Result& r)
      : in_(in), elastic_(elastic), r_(r), F_r_(in.supports.size(), 0.0), F_a_(in.supports.size(), 0.0) {
    const Moment none = 0.0 * N_m.one;
    r.M_max = r.T_max = none, r.v_max = 0.0 * mm, r.theta_max = 0.0 * deg_per_m.one, r.phi = 0.0;
    for (const Support& support : in.supports) {
      Carried c;
      c.name = support.name, c.x = support.x, c.s_p = support.s_p, c.holds = support.holds, c.n = r.n;
      const BearingSeat seat = bearing_seat(in, support);
      c.d_s = seat.d, c.l_s = seat.l, c.r_f = seat.r_f, c.d_f = seat.d_f;
      c.F_r0 = -1.0 * N.one, c.F_a0 = 0.0 * N.one, c.beta = 0.0;
      r.bearings.push_back(c);
    }
    for (std::size_t i = 0; i < in.seats.size(); ++i) {
      const bool turns = is_set(in.seats[i].T) || in.seats[i].way == Way::balances;
      r.seats.push_back({in.seats[i].name, in.seats[i].x, turns ? none : unset<Moment>, 0.0 * mm, 0.0, unset<double>,
                         unset<double>, unset<double>});
    }
  }

  /// `most`: the largest bending moment, N m.
  void take(const Loaded& loaded, std::size_t position, double most) {
    carry(loaded, share_of(in_, position));
    seat(loaded, position);
    extremes(loaded, most);
  }

  /// Behind the last position.
  void finish() {
    for (std::size_t i = 0; i < in_.supports.size(); ++i) {
      Carried& c = r_.bearings[i];
      c.F_r = varies(in_) ? from_si<Force>(std::pow(F_r_[i], 1.0 / p_L)) : c.F_r0;
      c.F_a = varies(in_) ? from_si<Force>(std::copysign(std::pow(F_a_[i], 1.0 / p_L), in_si(c.F_a0))) : c.F_a0;
      c.F_r0 *= in_.k_max, c.F_a0 *= in_.k_max;
      c.u_beta = slope_over(c.beta, in_.supports[i]);
    }
    for (std::size_t i = 0; i < in_.seats.size(); ++i) r_.seats[i].u_beta = slope_over(r_.seats[i].beta, in_.seats[i]);
  }

 private:
  void carry(const Loaded& loaded, double share) {
    for (std::size_t i = 0; i < in_.supports.size(); ++i) {
      Carried& c = r_.bearings[i];
      const Force R_x = from_si<Force>(loaded.x.reactions[i]), R_y = from_si<Force>(loaded.y.reactions[i]);
      const Force F_r = sqrt(R_x * R_x + R_y * R_y);
      const Force F_a = from_si<Force>(in_.supports[i].holds == Holds::both ? loaded.thrust : 0.0);
      if (F_r > c.F_r0) c.R_x = R_x, c.R_y = R_y, c.F_r0 = F_r;
      if (abs(F_a) > abs(c.F_a0)) c.F_a0 = F_a;
      F_r_[i] += share * std::pow(in_si(F_r), p_L), F_a_[i] += share * std::pow(std::abs(in_si(F_a)), p_L);
      c.beta = std::max(c.beta, loaded.slope(loaded.stations.at(in_.supports[i].x)));
    }
  }

  void seat(const Loaded& loaded, std::size_t position) {
    for (std::size_t i = 0; i < in_.seats.size(); ++i) {
      const std::size_t node = loaded.stations.at(in_.seats[i].x);
      Seated& s = r_.seats[i];
      s.v = max(s.v, from_si<Length>(loaded.deflection(node)));
      s.beta = std::max(s.beta, loaded.slope(node));
      const Moment T = in_.K_A * torque_of(in_, i, position);
      if (is_set(s.T) && abs(T) > abs(s.T)) s.T = T;
      if (has_face(in_.seats[i])) misalign(misalignment_of(in_, elastic_, loaded, i, position), s);
    }
  }

  /// At the position with the largest misalignment.
  static void misalign(const Misalignment& m, Seated& s) {
    const Length f_sh = from_si<Length>(std::abs(m.bending + m.twist) + m.sag);
    if (f_sh <= s.f_sh) return;
    s.delta_b = from_si<Length>(m.bending), s.delta_t = from_si<Length>(m.twist), s.delta_s = from_si<Length>(m.sag);
    s.f_sh = f_sh;
  }

  /// Maxima over all sections.
  void extremes(const Loaded& loaded, double M) {
    double T = 0.0;
    for (const double there : loaded.T) T = std::max(T, std::abs(there));
    const auto [least, most] = std::minmax_element(loaded.phi.begin(), loaded.phi.end());
    r_.M_max = max(r_.M_max, from_si<Moment>(M)), r_.T_max = max(r_.T_max, from_si<Moment>(T));
    r_.v_max = max(r_.v_max, from_si<Length>(loaded.largest_deflection()));
    const Twist theta = from_si<Twist>(loaded.twist);
    if (theta > r_.theta_max)
      r_.theta_max = theta, r_.T_theta = from_si<Moment>(loaded.twisting), r_.I_theta = polar_moment(in_, loaded);
    r_.phi = std::max(r_.phi, *most - *least);
  }

  const Input& in_;
  const Elastic& elastic_;
  Result& r_;
  OfBearings F_r_, F_a_;  // sums of powers
};

template <class Tracer>
void stiffness(const Input& in, Result& r, Tracer& trace) {
  trace.value("v_max", r.v_max, "largest value along the shaft, with shear");
  if (r.theta_max > from_si<Twist>(0.0)) {
    const Moment T_theta =
        trace.value("T_theta", r.T_theta, "torque where the twist per unit length is largest, K_A included");
    const SecondMoment I_theta =
        trace.value("I_theta", r.I_theta, "polar second moment of area of the thinnest section there");
    STEP_TO(r, theta_max, T_theta / (in.G * I_theta), "largest angle of twist per unit length");
  }
  if (is_set(in.v_adm)) {
    STEP_TO(r, u_y, r.v_max / in.v_adm, "deflection");
  }
  if (is_set(in.theta_adm)) {
    STEP_TO(r, u_theta, r.theta_max / in.theta_adm, "stiffness in torsion");
  }
}

/// The bent and twisted axis under the teeth of each cylindrical gear.
template <class Tracer>
void misalign_teeth(Result& r, Tracer& trace) {
  for (std::size_t i = 0; i < r.seats.size(); ++i) {
    Seated& s = r.seats[i];
    if (!is_set(s.f_sh)) continue;
    [[maybe_unused]] const auto here = trace.scope("seats", i);
    const Length delta_b =
        trace.value("delta_b", s.delta_b, "elastic line, right less left end of the face, along the tooth force");
    const Length delta_t = trace.value(
        "delta_t", s.delta_t, "angle of twist across the face, of the gear body to d_f, times the base radius");
    const Length delta_s = trace.value("delta_s", s.delta_s, "middle of the face against its ends");
    STEP_TO(s, f_sh, abs(delta_b + delta_t) + delta_s,
            "separation of the flanks along the line of action, [AGMA927]; the sag added as in [ISO6336-1] 2006");
  }
}

/// Tapers only.
template <class Tracer>
double steepest(const Input& in, Tracer& trace) {
  double slope = 0.0;
  for (const Piece& piece : in.pieces) slope = std::max(slope, std::abs(slope_of(piece)));
  if (slope == 0.0) return unset<double>;
  return trace.value("s_max", slope, "of the tapers, half the difference of the diameters over the length");
}

template <class Tracer>
void critical_speed(const Input& in, const Elastic& elastic, Result& r, Tracer& trace) {
  if (!is_set(in.rho)) return;
  r.mass = trace.value("mass", mass_of(in), "of its pieces");
  if (std::any_of(in.seats.begin(), in.seats.end(), [](const Seat& s) { return !is_set(s.mass); })) return;
  const beam::Frequencies found = critical_speeds(in, elastic);
  r.n_D = trace.speed("n_D", from_si<AngularSpeed>(found.dunkerley), "Dunkerley: each mass by itself");
  r.n_c = trace.speed("n_c", from_si<AngularSpeed>(found.lowest), "of masses on the elastic line");
  r.n_R = trace.speed("n_R", from_si<AngularSpeed>(found.rayleigh), "Rayleigh: bent as by the weights");
  judge_whirl(in, elastic, r, trace);
  if (!is_set(r.n)) return;
  if (r.whirls.empty()) {
    STEP_TO(r, u_n, in.k_n * r.n / r.n_c, "below the first critical speed, with its margin");
  } else if (is_set(r.n_F)) {
    STEP_TO(r, u_n, in.k_n * r.n / r.n_F, "below the first critical speed of forward whirl, with its margin");
  }
}

}  // namespace

template <class Tracer>
Design::Result Design::evaluate(const Input& in, Tracer& trace) {
  Result r;
  r.d_max = 0.0 * mm;
  for (const Piece& piece : in.pieces) r.d_max = max(r.d_max, thickest(piece));
  r.d_s = is_set(in.d_h) ? in.d_h : r.d_max;
  const auto elastic = elastic_shaft(in, weakest_of_tapers(in));
  if (!elastic) return r;
  r.s_max = steepest(in, trace);
  r.l = length_of(in);
  r.n = speed_of(in);
  Movement movement(in, *elastic, r);
  Turn turn(in, elastic->stations.x.size());
  for (std::size_t i = 0; i < turn.positions(); ++i) {
    const Loaded loaded = loaded_at(in, *elastic, i);
    const double M = loaded.largest_moment();
    movement.take(loaded, i, M);
    turn.take(loaded, M);
  }
  movement.finish();
  r.psi = turn.psi(turn.most_bent());
  if (is_set(r.n)) trace.speed("n", r.n, "shaft speed");
  if (asks_fatigue(in) && in.group <= fatigue::Endurance::Group::cast_steel)
    compare_with_steel(in.E, r, "the group is one of steels", trace);
  judge_sections(in, elastic->stations, turn, r, trace);
  stiffness(in, r, trace);
  critical_speed(in, *elastic, r, trace);
  judge_torsion(in, r, trace);
  judge_connections(in, r, trace);
  misalign_teeth(r, trace);
  return r;
}

template Design::Result Design::evaluate(const Input&, NoTrace&);
template Design::Result Design::evaluate(const Input&, Trace&);

}  // namespace loadpath::shaft

template const loadpath::Calculator& loadpath::erased<loadpath::shaft::Design>();
