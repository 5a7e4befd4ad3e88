#include "calculators/dynamics/force.hpp"

#include "calculators/motion/path_figures.hpp"
#include "calculators/motion/point_path.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/quantity/expression/resolved.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

// The mass m hides the unit of its name where the formulas are.
#pragma GCC diagnostic ignored "-Wshadow"

namespace loadpath::dynamics {

namespace {

using motion::PointPath;
using motion::PointState;

constexpr int samples = 257;

PointPath path_of(const ForceOfMotion::Input& in) { return {in.x, in.y, in.z}; }

/// The missing force at a state, N.
double missing_at(const ForceOfMotion::Input& in, const PointState& s) {
  const double mass = in_si(in.mass);
  return std::hypot(mass * s.a[0] - in_si(in.F_x), mass * s.a[1] - in_si(in.F_y), mass * s.a[2] - in_si(in.F_z));
}

/// Even times, and those between them at which an acceleration rises or falls.
std::vector<double> times_of(const ForceOfMotion::Input& in) {
  constexpr double followed = 5e-3;  // share of the largest acceleration
  constexpr std::size_t even = 65;   // corners of a law that is followed without more
  std::vector<double> times;
  times.reserve(samples);
  for (int i = 0; i < samples; ++i)
    times.push_back(in_si(in.t_1 + (in.t_2 - in.t_1) * (static_cast<double>(i) / (samples - 1))));
  for (const LawText* text :
       {static_cast<const LawText*>(&in.x), static_cast<const LawText*>(&in.y), static_cast<const LawText*>(&in.z)}) {
    const Law* const law = text->empty() ? nullptr : text->law();
    if (law == nullptr || !(in.t_2 > in.t_1)) continue;
    const Resolved resolved = resolve(*law, in_si(in.t_1), in_si(in.t_2), followed, Followed::second);
    if (resolved.corners.size() <= even) continue;
    for (const auto& corner : resolved.corners) times.push_back(corner.first);
  }
  std::sort(times.begin(), times.end());
  return times;
}

void find_largest(const ForceOfMotion::Input& in, ForceOfMotion::Result& r) {
  const PointPath path = path_of(in);
  double most = -1.0;
  for (const double t : times_of(in)) {
    const double R = missing_at(in, path.at(t));
    if (!(R > most * (1.0 + 1e-12))) continue;  // the first of equal ones
    most = R;
    r.R_max = R * N;
    r.t_max = t * sec;
  }
}

template <class Tracer>
void take_resultant(const ForceOfMotion::Input& in, ForceOfMotion::Result& r, Tracer& trace) {
  const auto m = in.mass;
  STEP_TO(r, P_x, m * r.a_x, "fundamental law, [B32]");
  STEP_TO(r, P_y, m * r.a_y, "fundamental law, [B32]");
  STEP_TO(r, P_z, m * r.a_z, "fundamental law, [B32]");
  STEP_TO(r, P, sqrt(P_x * P_x + P_y * P_y + P_z * P_z), "magnitude");
  r.Phi_x = -P_x, r.Phi_y = -P_y, r.Phi_z = -P_z;
}

template <class Tracer>
void take_missing(const ForceOfMotion::Input& in, ForceOfMotion::Result& r, Tracer& trace) {
  STEP_TO(r, R_x, r.P_x - in.F_x, "force in addition to the known forces");
  STEP_TO(r, R_y, r.P_y - in.F_y, "force in addition to the known forces");
  STEP_TO(r, R_z, r.P_z - in.F_z, "force in addition to the known forces");
  STEP_TO(r, R, sqrt(R_x * R_x + R_y * R_y + R_z * R_z), "magnitude");
}

}  // namespace

bool ForceOfMotion::laws_read(const Input& in) { return law_fault(in).message.empty(); }
FieldFault ForceOfMotion::law_fault(const Input& in) { return path_of(in).reading_fault(); }
bool ForceOfMotion::laws_are_smooth(const Input& in) { return gap(in).message.empty(); }

FieldFault ForceOfMotion::gap(const Input& in) {
  FieldFault fault = path_of(in).gap_fault(in_si(in.t), in_si(in.t));
  if (fault.message.empty() && is_set(in.t_1) && is_set(in.t_2))
    fault = path_of(in).gap_fault(in_si(in.t_1), in_si(in.t_2));
  return fault;
}

template <class Tracer>
ForceOfMotion::Result ForceOfMotion::evaluate(const Input& in, Tracer& trace) {
  Result r;
  const PointState now = path_of(in).at(in_si(in.t));
  constexpr const char* second = "second derivative of the law of motion, [B32]";
  r.a_x = trace.value("a_x", now.a[0] * m_per_s2, second);
  r.a_y = trace.value("a_y", now.a[1] * m_per_s2, second);
  r.a_z = trace.value("a_z", now.a[2] * m_per_s2, second);
  take_resultant(in, r, trace);
  take_missing(in, r, trace);
  r.P_tau = in.mass * (now.a_tau * m_per_s2), r.P_n = in.mass * (now.a_n * m_per_s2);
  r.N_R = (in_si(r.R_x) * now.v[0] + in_si(r.R_y) * now.v[1] + in_si(r.R_z) * now.v[2]) * W;
  if (is_set(in.t_1)) find_largest(in, r);
  return r;
}

template ForceOfMotion::Result ForceOfMotion::evaluate(const Input&, NoTrace&);
template ForceOfMotion::Result ForceOfMotion::evaluate(const Input&, Trace&);

std::vector<figure::Figure> ForceOfMotion::figures(const Input& in, const Result& r) {
  if (!is_set(in.t_1)) return {};
  const PointPath path = path_of(in);
  std::vector<figure::Figure> all{motion::path_figure(path, in_si(in.t), in_si(in.t_1), in_si(in.t_2))};
  figure::Plot plot = motion::over_time("R", "missing force", "N");
  const auto missing = [&](double t) { return missing_at(in, path.at(t)); };
  plot.curves.push_back(motion::curve_over(in_si(in.t_1), in_si(in.t_2), samples, "R", missing));
  plot.marks.push_back({in_si(r.t_max), in_si(r.R_max), "largest"});
  all.push_back({"force", "Missing force over time", std::move(plot)});
  return all;
}

}  // namespace loadpath::dynamics

template const loadpath::Calculator& loadpath::erased<loadpath::dynamics::ForceOfMotion>();
