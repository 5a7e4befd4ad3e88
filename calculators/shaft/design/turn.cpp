#include "calculators/shaft/design/turn.hpp"

#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::shaft {

namespace {

using Input = Design::Input;

/// The first seat that tells the angle.
const Seat* angled(const Input& in) {
  const auto found = std::find_if(in.seats.begin(), in.seats.end(), [](const Seat& s) { return is_set(s.psi); });
  return found == in.seats.end() ? nullptr : &*found;
}

double wrapped(double angle) { return std::remainder(angle, 2.0 * pi); }

/// Whether the shaft is, after the last position, where it was at the first: the last step is no larger than others.
bool closes(const Varying<double>& psi) {
  const std::size_t n = psi.positions();
  double largest = 0.0;
  for (std::size_t i = 1; i < n; ++i) largest = std::max(largest, std::abs(wrapped(psi.at(i) - psi.at(i - 1))));
  return std::abs(wrapped(psi.at(0) - psi.at(n - 1))) <= 3.0 * largest;
}

bool are_one(const Axis* a, const Axis* b) {
  return a == b || (a != nullptr && b != nullptr && a->at == b->at && a->period == b->period);
}

/// What acts at a seat is known at all positions, and all of it over one turn.
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
               say("look at the step that it comes from: `loadpath why` tells what is wrong there")};
    else if (!tells_its_extremes(*load.series))
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
  const Seat* const told = angled(in);
  if (told == nullptr)
    return {"psi", say("the loads vary over a turn, and nothing says how far the shaft has turned"),
            say("load = \"=press.shafts.O\" brings psi along; psi = \"0 deg\": the shaft stands")};
  for (const Seat& seat : in.seats) {
    if (!is_set(seat.psi)) continue;
    for (std::size_t i = 0; i < positions_of(in); ++i) {
      if (std::abs(wrapped(seat.psi.at(i) - told->psi.at(i))) > same)
        return {"psi", say("what sits on one shaft turns with it, and these do not"), {}};
    }
  }
  if (!told->psi.is_series()) {
    if (is_set(speed_of(in)))
      return {"psi", say("one angle says that the shaft stands, and it has a speed"),
              say("give the angle at each position, or leave out the speed")};
    return {};
  }
  if (!closes(told->psi))
    return {"psi", say("at the end of the turn the shaft is not where it was at the beginning"),
            say("solve so many turns of the mechanism that the shaft makes whole ones")};
  return {};
}

/// Between its extremes; `r`: least over largest, where it starts and stops too.
template <class Quantity>
Swing<Quantity> between(Quantity least, Quantity most, double r = unset<double>) {
  if (is_set(r)) {
    const Quantity back = r * (abs(least) > abs(most) ? least : most);
    least = min(least, back), most = max(most, back);
  }
  return {(most - least) / 2.0, (most + least) / 2.0};
}

template <class Of>
std::pair<double, double> extremes(std::size_t positions, const Of& of) {
  std::pair<double, double> found{of(0), of(0)};
  for (std::size_t i = 1; i < positions; ++i) {
    const double value = of(i);
    found.first = std::min(found.first, value), found.second = std::max(found.second, value);
  }
  return found;
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
  const Seat* const told = angled(in);
  return told == nullptr ? 0.0 : told->psi.at(position);
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
      return {"T", say("a torque has no sign of its own"), say("way says whether it drives or is driven")};
  }
  if (!varies(in)) return {};
  const TurnFault fault = fault_of_series(in);
  return *fault.key != '\0' ? fault : fault_of_angle(in);
}

Turn::Turn(const Input& in, std::size_t nodes)
    : nodes_(nodes), positions_(positions_of(in)), varies_(shaft::varies(in)) {
  felt_.reserve(nodes_ * positions_);
  for (std::size_t i = 0; varies_ && i < positions_; ++i) psi_.push_back(psi_of(in, i));
}

void Turn::take(const Loaded& loaded) {
  for (std::size_t n = 0; n < nodes_; ++n) felt_.push_back(loaded.felt(n));
  const double M = loaded.largest_moment();
  if (numerics::exceeds(M, largest_)) largest_ = M, most_bent_ = felt_.size() / nodes_ - 1;
}

double Turn::moment(std::size_t node, std::size_t position, double theta) const {
  const Felt& f = felt(node, position);
  return f.M_x * std::cos(theta + psi_[position]) + f.M_y * std::sin(theta + psi_[position]);
}

Swings Turn::along(std::size_t node, double r_T) const {
  const auto N = extremes(positions_, [&](std::size_t i) { return felt(node, i).N; });
  const auto T = extremes(positions_, [&](std::size_t i) { return felt(node, i).T; });
  Swings all;
  all.N = between(from_si<Force>(N.first), from_si<Force>(N.second));
  all.T = between(from_si<Moment>(T.first), from_si<Moment>(T.second), r_T);
  return all;
}

std::vector<Swings> Turn::swings(std::size_t node, double r_T) const {
  constexpr int directions = 90;   // of half the circumference: the other half has the same, its mean turned round
  constexpr double finest = 1e-3;  // of amplitude and mean: what differs less is one
  std::vector<double> along_x, along_y;  // the moment in the axes of the shaft
  for (std::size_t i = 0; i < positions_; ++i) {
    along_x.push_back(moment(node, i, 0.0));
    along_y.push_back(moment(node, i, pi / 2.0));
  }
  std::vector<Swings> all(directions, along(node, r_T));
  for (int k = 0; k < directions; ++k) {
    Swings& swing = all[static_cast<std::size_t>(k)];
    swing.theta = pi * k / directions;
    const double c = std::cos(swing.theta), s = std::sin(swing.theta);
    const auto M = extremes(positions_, [&](std::size_t i) { return along_x[i] * c + along_y[i] * s; });
    swing.M = between(from_si<Moment>(M.first), from_si<Moment>(M.second));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Swings& a, const Swings& b) { return numerics::exceeds(in_si(a.M.a), in_si(b.M.a)); });
  std::vector<Swings> front;
  for (const Swings& s : all) {
    if (front.empty() || abs(s.M.m) > abs(front.back().M.m) + finest * (s.M.a + abs(s.M.m))) front.push_back(s);
  }
  return front;
}

}  // namespace loadpath::shaft
