#include "calculators/dynamics/path/path_work.hpp"

#include "calculators/motion/path_figures.hpp"
#include "calculators/motion/point_path.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/numerics/quadrature.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace loadpath::dynamics {

namespace {

using motion::PointPath;
using motion::PointState;
using Vector = std::array<double, 3>;

constexpr int path_samples = 257;
constexpr std::array force_keys{"F_x", "F_y", "F_z"};
constexpr double most_delta = 1e-6;  // beyond, the work is not available

PointPath curve_of(const PathWork::Input& in) { return {in.x, in.y, in.z}; }

Vector force_at(const PathWork::Input& in, const PointState& s, double t) {
  const std::array<double, motion_variables.size()> at{s.r[0], s.r[1], s.r[2], s.v[0], s.v[1], s.v[2], s.speed, t};
  const auto value = [&](const RelationText& text) {
    if (text.empty()) return 0.0;
    const Relation* const relation = text.read();
    return relation == nullptr ? std::nan("") : relation->at(at);
  };
  return {value(in.F_x), value(in.F_y), value(in.F_z)};
}

/// Power of each component.
Vector powers_at(const PathWork::Input& in, double t) {
  const PointState s = curve_of(in).at(t);
  const Vector F = force_at(in, s, t);
  return {F[0] * s.v[0], F[1] * s.v[1], F[2] * s.v[2]};
}

double sum_of(const Vector& v) { return v[0] + v[1] + v[2]; }

/// Works of the components over an interval, and the integral of the magnitude of the power.
struct Works {
  Vector A{};
  double magnitude = 0.0;
};

Works gauss(const PathWork::Input& in, double from, double to) {
  Works works;
  numerics::for_each_gauss_8(from, to, [&](double t, double weight) {
    const Vector P = powers_at(in, t);
    for (std::size_t i = 0; i < 3; ++i) works.A[i] += weight * P[i];
    works.magnitude += weight * (std::abs(P[0]) + std::abs(P[1]) + std::abs(P[2]));
  });
  return works;
}

class Integrated {
 public:
  explicit Integrated(const PathWork::Input& in) : in_(in) {
    constexpr int pieces = 64;
    const double from = in_si(in.t_1), step = (in_si(in.t_2) - from) / pieces;
    std::array<Works, pieces> coarse;
    for (int k = 0; k < pieces; ++k) {
      coarse[static_cast<std::size_t>(k)] = gauss(in, from + k * step, from + (k + 1) * step);
      scale_ += coarse[static_cast<std::size_t>(k)].magnitude;
    }
    for (int k = 0; k < pieces; ++k)
      halve(from + k * step, from + (k + 1) * step, coarse[static_cast<std::size_t>(k)], most_halvings);
  }

  [[nodiscard]] Vector works() const {
    Vector A = total_.A;
    for (double& work : A) work = motion::without_rounding(work, total_.magnitude);
    return A;
  }
  /// Relative to the integral of the magnitude of the power; 0 if both are 0.
  [[nodiscard]] double delta() const {
    const double error = sum_of(error_);
    return error == 0.0 ? 0.0 : error / total_.magnitude;
  }
  /// The component of the largest error.
  [[nodiscard]] std::size_t worst() const {
    return static_cast<std::size_t>(std::max_element(error_.begin(), error_.end()) - error_.begin());
  }

 private:
  static constexpr int most_halvings = 40;  // a step of the force is closed in on to the last digits
  static constexpr double rounding = 1e-14;

  void halve(double from, double to, const Works& whole, int left_over) {
    const double middle = 0.5 * (from + to);
    const Works left = gauss(in_, from, middle), right = gauss(in_, middle, to);
    Vector difference{};
    for (std::size_t i = 0; i < 3; ++i) difference[i] = std::abs(left.A[i] + right.A[i] - whole.A[i]);
    const bool agrees = sum_of(difference) <= rounding * scale_;
    if (!agrees && left_over > 0 && budget_-- > 0) {
      halve(from, middle, left, left_over - 1);
      halve(middle, to, right, left_over - 1);
      return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      total_.A[i] += left.A[i] + right.A[i];
      error_[i] += difference[i];
    }
    total_.magnitude += left.magnitude + right.magnitude;
  }

  const PathWork::Input& in_;
  Works total_;
  Vector error_{};
  double scale_ = 0.0;
  int budget_ = 20000;
};

/// The first place of the path at which a force has no value.
FieldFault missing_force(const PathWork::Input& in) {
  const double from = in_si(in.t_1), to = in_si(in.t_2);
  for (int k = 0; k < path_samples; ++k) {
    const double t = k + 1 == path_samples ? to : from + (to - from) * k / (path_samples - 1);
    const Vector F = force_at(in, curve_of(in).at(t), t);
    for (std::size_t i = 0; i < 3; ++i) {
      if (std::isfinite(F[i])) continue;
      return {force_keys[i], say("the force has no value at t = {1}", format_quantity(t, "s", 4)),
              say("it divides by zero there, or takes the root of a negative value: end the path before it")};
    }
  }
  return {};
}

void take_powers(const PathWork::Input& in, PathWork::Result& r) {
  const double from = in_si(in.t_1), to = in_si(in.t_2);
  double most = -std::numeric_limits<double>::infinity(), least = -most;
  for (int k = 0; k < path_samples; ++k) {
    const double P = sum_of(powers_at(in, k + 1 == path_samples ? to : from + (to - from) * k / (path_samples - 1)));
    most = std::max(most, P);
    least = std::min(least, P);
  }
  const double scale = std::max(std::abs(most), std::abs(least));
  r.P_max = motion::without_rounding(most, scale) * W;
  r.P_min = motion::without_rounding(least, scale) * W;
}

}  // namespace

bool PathWork::laws_read(const Input& in) { return law_fault(in).message.empty(); }

FieldFault PathWork::law_fault(const Input& in) {
  if (FieldFault fault = curve_of(in).reading_fault(); !fault.message.empty()) return fault;
  const auto fault_at = [](const char* key, const RelationText& text) -> FieldFault {
    if (const Fault* const fault = text.fault()) return {key, fault->message, fault->hint};
    return {};
  };
  for (FieldFault fault : {fault_at("F_x", in.F_x), fault_at("F_y", in.F_y), fault_at("F_z", in.F_z)}) {
    if (!fault.message.empty()) return fault;
  }
  return {};
}

bool PathWork::is_integrated(const Input& in) { return gap(in).message.empty(); }

FieldFault PathWork::gap(const Input& in) {
  if (!laws_read(in) || !(in.t_2 > in.t_1)) return {};  // other rules state it
  if (FieldFault fault = curve_of(in).gap_fault(in_si(in.t_1), in_si(in.t_2)); !fault.message.empty()) return fault;
  if (FieldFault fault = missing_force(in); !fault.message.empty()) return fault;
  const Integrated integrated(in);
  if (integrated.delta() <= most_delta) return {};
  return {force_keys[integrated.worst()], say("the force has a pole on the path, or changes too fast to be integrated"),
          say("shorten the path, or check the units of the force")};
}

template <class Tracer>
PathWork::Result PathWork::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const Integrated integrated(in);
  const Vector works = integrated.works();
  const auto A_x = r.A_x = trace.value("A_x", works[0] * J, "integral of F_x dx along the path, [B34]");
  const auto A_y = r.A_y = trace.value("A_y", works[1] * J, "integral of F_y dy along the path, [B34]");
  const auto A_z = r.A_z = trace.value("A_z", works[2] * J, "integral of F_z dz along the path, [B34]");
  STEP_TO(r, A, A_x + A_y + A_z, "work of the force, [B34]");
  r.delta =
      trace.value("delta", integrated.delta(), "differences of Gauss's rule on the intervals and on their halves");
  const Length L = r.L = trace.value("L", curve_of(in).length(in_si(in.t_1), in_si(in.t_2)) * m, "length of the path");
  if (L > 0.0 * m) {
    STEP_TO(r, F_m, A / L, "constant force along the path of the same work");
  }
  STEP_TO(r, P_m, A / (in.t_2 - in.t_1), "mean power, [B34]");
  take_powers(in, r);
  return r;
}

template PathWork::Result PathWork::evaluate(const Input&, NoTrace&);
template PathWork::Result PathWork::evaluate(const Input&, Trace&);

std::vector<figure::Figure> PathWork::figures(const Input& in, const Result& r) {
  if (!is_set(r.A)) return {};
  const double from = in_si(in.t_1), to = in_si(in.t_2);
  std::vector<figure::Figure> all{motion::path_figure(curve_of(in), to, from, to)};
  figure::Plot plot = motion::over_time("A", "work", "J");
  double work = 0.0, last = from;
  plot.curves.push_back(motion::curve_over(from, to, path_samples, "A", [&](double t) {
    work += sum_of(gauss(in, last, t).A);
    last = t;
    return work;
  }));
  all.push_back({"work", "Work up to the time t", std::move(plot)});
  return all;
}

}  // namespace loadpath::dynamics

template const loadpath::Calculator& loadpath::erased<loadpath::dynamics::PathWork>();
