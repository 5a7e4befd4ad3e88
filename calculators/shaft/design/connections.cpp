#include "calculators/shaft/design/connections.hpp"

#include "calculators/shaft/design/model/places.hpp"
#include "calculators/shaft/design/model/positions.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::shaft {

namespace {

using Input = DesignInput;

/// Whether a torque, if any position has one, is more than what the others leave by rounding.
bool turns_something(const Input& in, std::size_t seat) {
  for (std::size_t i = 0; i < positions_of(in); ++i) {
    if (std::abs(in_si(torque_of(in, seat, i))) > 1e-9) return true;
  }
  return false;
}

}  // namespace

Length diameter_under(const Input& in, Length x) { return around(in, x).sides.thinner().d; }

bool has_rim(const Seat& seat) {
  const bool has_wall = is_set(seat.h_t) || (is_set(seat.t_c) && seat.t_c > 0.0 * mm);
  return is_set(seat.d_f) && has_wall && seat.integral == Integral::no;
}

bool needs_connection(const Input& in, std::size_t seat) {
  return in.seats[seat].integral == Integral::no && turns_something(in, seat);
}

template <class Tracer>
void judge_connections(const Input& in, DesignResult& r, Tracer& trace) {
  for (std::size_t i = 0; i < in.seats.size(); ++i) {
    const Seat& seat = in.seats[i];
    Seated& s = r.seats[i];
    [[maybe_unused]] const auto here = trace.scope("seats", i);
    if (is_set(seat.T_c) && needs_connection(in, i)) {
      const Moment T = s.T, T_c = trace.value("T_c", seat.T_c, "torque for which the connection is assessed");
      STEP_TO(s, x_c, abs(T) / T_c, "the connection is assessed for no less");
    }
    if (is_set(seat.T_peak) && needs_connection(in, i)) {
      const Moment T = s.T, T_peak = trace.value("T_peak", seat.T_peak, "of a start or a jam");
      STEP_TO(s, x_peak, in.k_max * abs(T) / T_peak, "a start or a jam loads the connection as well");
    }
    if (is_set(seat.n_c) && needs_connection(in, i) && is_set(speed_of(in))) {
      const AngularSpeed n = trace.value("n", speed_of(in), "of the shaft");
      const AngularSpeed n_c = trace.value("n_c", seat.n_c, "up to which the interference fit is assessed");
      STEP_TO(s, x_n, n / max(n_c, 1.0 * rpm), "the hub expands with speed: n of shaft.press_fit");
    }
    if (!has_rim(seat)) continue;
    const Length d = trace.value("d", diameter_under(in, seat), "of the shaft under the hub");
    const Length t_c = trace.value("t_c", is_set(seat.t_c) ? seat.t_c : 0.0 * mm, "depth of the keyway in the hub");
    const Length d_f = trace.value("d_f", seat.d_f, "root circle");
    if (t_c > 0.0 * mm) {
      STEP_TO(s, x_R, t_c / ((d_f - d) / 2.0 - t_c), "wall at least as thick as the keyway is deep");
    }
    if (!is_set(seat.h_t)) continue;
    const Length h_t = trace.value("h_t", seat.h_t, "tooth depth");
    STEP_TO(s, m_R, ((d_f - d) / 2.0 - t_c) / h_t, "rim thickness over tooth depth, as in gear.pair");
  }
}

template void judge_connections(const Input&, DesignResult&, NoTrace&);
template void judge_connections(const Input&, DesignResult&, Trace&);

}  // namespace loadpath::shaft
