#include "calculators/belt/v/sizing.hpp"

#include "calculators/belt/figures.hpp"
#include "calculators/belt/v/search.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>

namespace loadpath::belt {

namespace {

using Input = VSizing::Input;
using Result = VSizing::Result;
using Candidate = VSizing::Candidate;
using Merit = VSizing::Merit;

/// For the rules of belt.v about what is not of the drive's geometry.
V::Input without_geometry(const Input& in) {
  V::Input drive = drive_of(in);
  const auto sections = v_sections();
  const auto any = std::find_if(sections.begin(), sections.end(), [&](const auto& s) { return s.basis == in.basis; });
  if (in.section.empty() && any != sections.end()) drive.section = any->name;
  return drive;
}

Name name_of(SectionWord word) { return choices_of(SectionWord{})[static_cast<std::size_t>(word)].key; }

/// Advantage of a drive over the first in the list.
Merit merit_of(const Candidate& c, const Candidate& first, const Input& in) {
  NoTrace quiet;
  const double n = in_si(in.n_1) / wanted_ratio(in, quiet), a = in_si(in.a_set);
  if (c.V < 0.99 * first.V) return Merit::pulleys;
  if (c.R_new < 0.99 * first.R_new) return Merit::shaft_load;
  if (c.B < 0.99 * first.B) return Merit::width;
  if (share_off(in_si(c.n_2), n) < share_off(in_si(first.n_2), n) - 1e-9) return Merit::speed;
  return share_off(in_si(c.a), a) < share_off(in_si(first.a), a) - 1e-9 ? Merit::centre : Merit::none;
}

/// Says of each drive why it is not the first.
void compare(const Input& in, Result& r) {
  const Candidate first = r.candidates.front();
  for (Candidate& c : r.candidates) {
    c.excess = measure_of(c, in.rank) / measure_of(first, in.rank) - 1.0;
    c.merit = merit_of(c, first, in);
  }
  r.candidates.front().merit = Merit::best;
}

/// The belt.v input of a drive of the list.
V::Input drive_of(const Input& in, const Candidate& c) {
  V::Input drive = drive_of(in);
  drive.section = name_of(c.section), drive.d_1 = c.d_1, drive.d_2 = c.d_2, drive.L = c.L;
  return drive;
}

/// One drive in full: the first of the list, or the one that comes nearest.
template <class Tracer>
void check(const Input& in, const V::Input& drive, const char* which, Result& r, Tracer& trace) {
  r.d_1 = trace.value("d_1", drive.d_1, which);
  r.d_2 = trace.value("d_2", drive.d_2, which);
  r.L = trace.value("L", drive.L, which);
  const V::Result found = V::evaluate(drive, trace);
  r.section = word_of(drive.section), r.z = found.z;
  r.a = found.a, r.n_2 = found.n_2, r.n_k = found.n_k, r.L_h = found.L_h, r.F_0 = found.F_0, r.R_0 = found.R_0,
  r.R_new = found.R_new, r.R = found.R;
  r.B = found.B, r.u_P = found.u_P, r.u_grip = found.u_grip, r.u_rim = found.u_rim, r.u_B = found.u_B;
  r.best = {drive};
  r.best.z = r.z;
  r.i_w = wanted_ratio(in, trace);
  r.i = found.i;
  STEP_TO(r, dev_n, r.n_2 / (in.n_1 / r.i_w) - 1.0, "speed against the wanted one");
  STEP_TO(r, dev_a, r.a / in.a_set - 1.0, "centre distance against the wanted one");
}

}  // namespace

bool VSizing::section_is_known(const Input& in) { return V::section_is_known(without_geometry(in)); }
bool VSizing::class_fits(const Input& in) { return V::class_fits(without_geometry(in)); }
bool VSizing::service_is_given(const Input& in) { return V::service_is_given(without_geometry(in)); }
FieldFault VSizing::unknown_section(const Input& in) { return V::unknown_section(without_geometry(in)); }
FieldFault VSizing::wrong_class(const Input& in) { return V::wrong_class(without_geometry(in)); }

template <class Tracer>
VSizing::Result VSizing::evaluate(const Input& in, Tracer& trace) {
  Result r;
  r.rating = in.basis;
  Nearest nearest;
  for (const VSection& section : v_sections()) {
    if (section.basis == in.basis && (in.section.empty() || in.section == section.name))
      try_section(section, in, r, nearest);
  }
  trace.value("tried", r.tried, "pairs of standard pulleys that meet the speed, with the nearest standard belt");
  trace.value("drives", r.drives, "of them pass every check and limit of belt.v");
  if (!r.candidates.empty()) {
    compare(in, r);
    check(in, drive_of(in, r.candidates.front()), "first drive of the list", r, trace);
  } else if (r.tried > 0.0) {
    check(in, nearest.drive, "of the drive that comes nearest, with no more belts than are allowed: none passes", r,
          trace);
  }
  return r;
}

template VSizing::Result VSizing::evaluate(const Input&, NoTrace&);
template VSizing::Result VSizing::evaluate(const Input&, Trace&);

std::vector<figure::Figure> VSizing::figures(const Input&, const Result& r) {
  if (!is_set(r.d_1)) return {};
  TwoWheels w;
  w.d_1 = in_si(r.d_1), w.d_2 = in_si(r.d_2), w.a = in_si(r.a);
  return {drive_figure(w, {})};
}

}  // namespace loadpath::belt

template const loadpath::Calculator& loadpath::erased<loadpath::belt::VSizing>();
