#include "calculators/shaft/design/model/positions.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::shaft {

namespace {

using Input = DesignInput;

/// The first mounted component that gives the angle.
const Seat* angled(const Input& in) {
  const auto found = std::find_if(in.seats.begin(), in.seats.end(), [](const Seat& s) { return is_set(s.psi); });
  return found == in.seats.end() ? nullptr : &*found;
}

double wrapped(double angle) { return std::remainder(angle, 2.0 * pi); }

/// Whether the shaft returns to its first position after the last: the last step is not larger than others.
bool closes(const Varying<double>& psi) {
  const std::size_t n = psi.positions();
  double largest = 0.0;
  for (std::size_t i = 1; i < n; ++i) largest = std::max(largest, std::abs(wrapped(psi.at(i) - psi.at(i - 1))));
  return std::abs(wrapped(psi.at(0) - psi.at(n - 1))) <= 3.0 * largest;
}

bool are_one(const Axis* a, const Axis* b) {
  return a == b || (a != nullptr && b != nullptr && a->at == b->at && a->period == b->period);
}

/// Loads of a mounted component must be known at all positions, and all over one revolution.
TurnFault fault_of_series(const Input& in) {
  const Axis* const axis = any_series(in)->signature.axis;
  TurnFault fault;
  const auto look = [&](const char* key, const auto& load) {
    if (!load.is_series() || *fault.key != '\0') return;
    const auto& si = load.series->si;
    if (!are_one(load.series->signature.axis, axis))
      fault = {key, say("not all series are over the same positions"), say("take all from one mechanism")};
    else if (std::any_of(si.begin(), si.end(), [](double x) { return !std::isfinite(x); }))
      fault = {key, say("it is not known at all positions of the turn"),
               say("see the step that it comes from: `loadpath why`")};
    else if (!resolves_extremes(*load.series))
      fault = {key, say("between the positions of the turn its extremes may be more than 1 % of the range larger"),
               say("take more positions in the step that it comes from: 36 at least")};
  };
  for (const Seat& seat : in.seats) {
    look("psi", seat.psi);
    for_each_load(seat, look);
  }
  return fault;
}

TurnFault fault_of_angle(const Input& in) {
  constexpr double same = 1e-6;  // rad
  const Seat* const seat_with_angle = angled(in);
  if (seat_with_angle == nullptr)
    return {"psi", say("the loads vary over a revolution, but the angle of the shaft is missing"),
            say("load = \"=press.shafts.O\" includes psi; psi = \"0 deg\": the shaft is at rest")};
  for (const Seat& seat : in.seats) {
    if (!is_set(seat.psi)) continue;
    for (std::size_t i = 0; i < positions_of(in); ++i) {
      if (std::abs(wrapped(seat.psi.at(i) - seat_with_angle->psi.at(i))) > same)
        return {"psi", say("components of one shaft must have the same speed, and these do not"), {}};
    }
  }
  if (!seat_with_angle->psi.is_series()) {
    if (is_set(speed_of(in)))
      return {"psi", say("a single angle means a shaft at rest, but it has a speed"),
              say("give the angle at each position, or leave out the speed")};
    return {};
  }
  if (!closes(seat_with_angle->psi))
    return {"psi", say("at the end of the revolution the shaft is not at its initial angle"),
            say("solve as many revolutions of the mechanism as give full revolutions of the shaft")};
  return {};
}

}  // namespace

const Value* any_series(const Input& in) {
  const Value* found = nullptr;
  const auto look = [&](const char*, const auto& load) {
    if (load.is_series()) found = load.series.get();
  };
  for (const Seat& seat : in.seats) {
    look("psi", seat.psi);
    for_each_load(seat, look);
  }
  return found;
}

std::size_t positions_of(const Input& in) {
  const Value* const series = any_series(in);
  return series == nullptr ? 1 : series->si.size();
}

bool varies(const Input& in) { return any_series(in) != nullptr; }

bool torque_varies(const Input& in) {
  return std::any_of(in.seats.begin(), in.seats.end(), [](const Seat& s) { return s.T.is_series(); });
}

double share_of(const Input& in, std::size_t position) {
  const Value* const series = any_series(in);
  if (series == nullptr) return 1.0;
  const Axis* const axis = series->signature.axis;
  const bool known = axis != nullptr && axis->share.size() == series->si.size();
  return known ? axis->share[position] : 1.0 / static_cast<double>(series->si.size());
}

double psi_of(const Input& in, std::size_t position) {
  const Seat* const seat_with_angle = angled(in);
  return seat_with_angle == nullptr ? 0.0 : seat_with_angle->psi.at(position);
}

double turns_of(const Input& in) {
  const std::size_t n = positions_of(in);
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) sum += wrapped(psi_of(in, (i + 1) % n) - psi_of(in, i));
  return std::round(sum / (2.0 * pi));
}

TurnFault fault_of_turn(const Input& in) {
  for (const Seat& seat : in.seats) {
    if (!seat.T.is_series() && seat.T.one < 0.0 * N_m.one)
      return {"T", say("a torque has no sign of its own"), say("'way' states whether it drives or is driven")};
  }
  if (!varies(in)) return {};
  const TurnFault fault = fault_of_series(in);
  return *fault.key != '\0' ? fault : fault_of_angle(in);
}

AngularSpeed speed_of(const Input& in) {
  if (is_set(in.n)) return abs(in.n);
  const auto turning = std::find_if(in.seats.begin(), in.seats.end(), [](const Seat& s) { return is_set(s.n); });
  return turning == in.seats.end() ? unset<AngularSpeed> : abs(turning->n);
}

Moment torque_of(const Input& in, std::size_t seat, std::size_t position) {
  const auto given = [&](const Seat& s) {
    if (!is_set(s.T) || s.way == Way::balances) return 0.0 * N_m.one;
    return s.way == Way::drives ? s.T.at(position) : -s.T.at(position);
  };
  if (in.seats[seat].way != Way::balances) return given(in.seats[seat]);
  Moment sum = 0.0 * N_m.one;
  for (const Seat& s : in.seats) sum += given(s);
  return -sum;
}

}  // namespace loadpath::shaft
