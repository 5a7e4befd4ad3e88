#include "calculators/belt/v_sizing.hpp"

#include "calculators/belt/figures.hpp"
#include "calculators/belt/v_choices.hpp"
#include "lib/calculator/calculator_of.hpp"
#include "lib/table/table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::belt {

namespace {

using Input = VSizing::Input;
using Result = VSizing::Result;
using Candidate = VSizing::Candidate;
using Rank = VSizing::Rank;
using Merit = VSizing::Merit;

/// The input of belt.v that a drive of the list stands for; diameters, length and section are still open.
V::Input drive_of(const Input& in) {
  V::Input drive;
  drive.basis = in.basis, drive.section = in.section, drive.belt_class = in.belt_class;
  drive.P = in.P, drive.K_A = in.K_A, drive.duty = in.duty, drive.motor = in.motor, drive.h_day = in.h_day;
  drive.n_1 = in.n_1, drive.epsilon = in.epsilon, drive.mu = in.mu, drive.v_rim_adm = in.v_rim_adm;
  return drive;
}

/// For the rules of belt.v about what is not of the drive's geometry.
V::Input without_geometry(const Input& in) {
  V::Input drive = drive_of(in);
  const auto sections = v_sections();
  const auto any = std::find_if(sections.begin(), sections.end(), [&](const auto& s) { return s.basis == in.basis; });
  if (in.section.empty() && any != sections.end()) drive.section = any->name;
  return drive;
}

std::vector<Length> read_pulleys(Basis basis) {
  std::vector<Length> pulleys;
  if (const auto series = table::find_series(basis == Basis::iso ? "v_pulleys_gost" : "v_pulleys")) {
    for (const double d : table::members_in_si(**series)) pulleys.push_back(from_si<Length>(d));
  }
  return pulleys;
}

/// The pulleys that are made, ascending.
std::span<const Length> pulleys_of(Basis basis) {
  static const auto iso = read_pulleys(Basis::iso), optibelt = read_pulleys(Basis::optibelt);
  return basis == Basis::iso ? iso : optibelt;
}

/// How far a drive is from passing: the limits of belt.v that it leaves, and its largest check.
struct Lack {
  int limits = 0;
  double check = 0.0;

  [[nodiscard]] bool none() const { return limits == 0 && check <= 1.0; }
  [[nodiscard]] bool less_than(const Lack& other) const {
    return limits != other.limits ? limits < other.limits : check < other.check;
  }
};

/// What one field of a result of belt.v adds to it; a check that is not available counts as a limit.
template <class F>
void take(const F& field, const V::Result& r, bool grip_asked, Lack& lack) {
  if constexpr (requires { field.asked_by; }) {
    const double value = in_si(r.*field.at) / in_si(field.unit.one);
    const bool asked = field.asked_by[0] == '\0' || grip_asked;
    if (field.role == Role::check && asked) {
      lack.check = std::max(lack.check, value);
      if (std::isnan(value)) ++lack.limits;
    }
    if (field.role == Role::limit && !field.bounds.holds(value)) ++lack.limits;
  }
}

Lack lack_of(const V::Result& r, bool grip_asked) {
  Lack lack;
  std::apply([&](const auto&... field) { (take(field, r, grip_asked, lack), ...); }, V::results);
  return lack;
}

/// The drive that lacks least, where none passes.
struct Nearest {
  V::Input drive;
  Lack lack{std::numeric_limits<int>::max(), 0.0};
};

double share_off(double value, double wanted) { return std::abs(value / wanted - 1.0); }

double measure_of(const Candidate& c, Rank rank) {
  if (rank == Rank::shaft_load) return in_si(c.R_new);
  return rank == Rank::width ? in_si(c.B) : in_si(c.V);
}

/// The better drive by the rank; of equals the smaller pulleys, then the smaller shaft load.
bool before(const Candidate& a, const Candidate& b, Rank rank) {
  const double x = measure_of(a, rank), y = measure_of(b, rank);
  if (x != y) return x < y;
  return a.V != b.V ? a.V < b.V : a.R_new < b.R_new;
}

/// Puts a drive in its place; the list keeps the best.
void rank_in(VSizing::Candidates& list, const Candidate& c, Rank rank) {
  const auto at =
      std::find_if(list.begin(), list.end(), [&](const Candidate& other) { return before(c, other, rank); });
  if (at == list.end() && list.size() == VSizing::Candidates::capacity()) return;
  const auto index = at - list.begin();
  if (list.size() == VSizing::Candidates::capacity()) list.pop_back();
  list.insert(list.begin() + index, c);
}

Candidate candidate_of(const V::Input& drive, const V::Result& r) {
  Candidate c;
  c.section = word_of(drive.section), c.d_1 = drive.d_1, c.d_2 = drive.d_2, c.L = r.L, c.z = r.z, c.a = r.a,
  c.n_2 = r.n_2;
  c.B = r.B, c.R_new = r.R_new, c.u_P = r.u_P;
  c.V = pi / 4.0 * r.B * (r.d_a1 * r.d_a1 + r.d_a2 * r.d_a2);
  return c;
}

/// The belt of the section that brings the centre distance nearest to the wanted one; NaN where none is near enough.
Length nearest_belt(const VSection& section, const Input& in, const V::Input& drive) {
  Length best = unset<Length>;
  double least = in.tol_a;
  const Length clear = (drive.d_1 + drive.d_2) / 2.0;
  for (const auto& length : section.lengths) {
    if (length.L < 2.0 * (1.0 - in.tol_a) * in.a_set) continue;  // a belt is longer than both spans
    const Length a = centre_of_length({drive.d_1, drive.d_2, unset<Length>, length.L});
    if (is_set(a) && a > (1.0 + in.tol_a) * in.a_set) break;
    const double off = share_off(in_si(a), in_si(in.a_set));
    if (a > clear && off <= least) best = length.L, least = off;
  }
  return best;
}

void try_pair(const VSection& section, const Input& in, V::Input& drive, Result& r, Nearest& nearest) {
  drive.L = nearest_belt(section, in, drive);
  if (!is_set(drive.L)) return;
  r.tried += 1.0;
  NoTrace quiet;
  const V::Result found = V::evaluate(drive, quiet);
  const bool too_weak = found.z == 0 || found.z > in.z_max;
  Lack lack = lack_of(found, is_set(in.mu));
  if (!too_weak && lack.none()) {
    r.drives += 1.0;
    rank_in(r.candidates, candidate_of(drive, found), in.rank);
    return;
  }
  (too_weak ? r.too_weak : r.outside) += 1.0;
  if (too_weak) ++lack.limits;
  if (lack.less_than(nearest.lack)) nearest = {drive, lack};
}

bool fits_room(const Input& in, const V::Input& drive) {
  return !(drive.d_1 < in.d_1_min) && !(max(drive.d_1, drive.d_2) > in.d_max);
}

/// Every pair of pulleys of a section that meets the speed.
void try_section(const VSection& section, const Input& in, Result& r, Nearest& nearest) {
  V::Input drive = drive_of(in);
  drive.section = section.name;
  const double i_w = in_si(in.n_1 / in.n_2_set) * (1.0 - in.epsilon);  // d_2 over d_1
  const auto pulleys = pulleys_of(in.basis);
  for (const Length& small : pulleys) {
    if (small < section.row.d_least || small > section.row.d_high) continue;
    const Length wanted = small * max(i_w, 1.0 / i_w);
    for (const Length& large : pulleys) {
      const bool reduces = i_w >= 1.0;
      drive.d_1 = reduces ? small : large, drive.d_2 = reduces ? large : small;
      const double i = in_si(drive.d_2 / drive.d_1) / (1.0 - in.epsilon);
      if (large < small || large > 2.0 * wanted) continue;
      if (share_off(in_si(in.n_1) / i, in_si(in.n_2_set)) > in.tol_n || !fits_room(in, drive)) continue;
      try_pair(section, in, drive, r, nearest);
    }
  }
}

Name name_of(SectionWord word) { return choices_of(SectionWord{})[static_cast<std::size_t>(word)].key; }

/// What a drive does better than the first, all the same.
Merit merit_of(const Candidate& c, const Candidate& first, const Input& in) {
  const double n = in_si(in.n_2_set), a = in_si(in.a_set);
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

/// One drive whole: the first of the list, or the one that comes nearest.
template <class Tracer>
void check(const Input& in, const V::Input& drive, const char* which, Result& r, Tracer& trace) {
  r.d_1 = drive.d_1, r.d_2 = drive.d_2, r.L = drive.L;
  trace.value("d_1", r.d_1, which);
  trace.value("d_2", r.d_2, which);
  trace.value("L", r.L, which);
  const V::Result found = V::evaluate(drive, trace);
  r.section = word_of(drive.section), r.z = found.z;
  r.a = found.a, r.n_2 = found.n_2, r.n_k = found.n_k, r.L_h = found.L_h, r.F_0 = found.F_0, r.R_0 = found.R_0,
  r.R_new = found.R_new, r.R = found.R;
  r.B = found.B, r.u_P = found.u_P, r.u_grip = found.u_grip, r.u_rim = found.u_rim, r.u_B = found.u_B;
  if (found.z > in.z_max) {
    r.z = in.z_max, r.u_P = found.u_P * found.z / in.z_max;
    trace.value("u_P", r.u_P, "as many belts as are allowed");
  }
  const auto n_2 = r.n_2, n_2_set = in.n_2_set;
  const auto a = r.a, a_set = in.a_set;
  STEP(dev_n, n_2 / n_2_set - 1.0, "speed against the wanted one");
  STEP(dev_a, a / a_set - 1.0, "centre distance against the wanted one");
  r.dev_n = dev_n, r.dev_a = dev_a;
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
  Nearest nearest;
  for (const VSection& section : v_sections()) {
    if (section.basis == in.basis && (in.section.empty() || in.section == section.name))
      try_section(section, in, r, nearest);
  }
  trace.value("tried", r.tried, "pairs of standard pulleys that meet the speed, with the nearest standard belt");
  trace.value("drives", r.drives, "of them pass every check and limit of belt.v");
  if (!r.candidates.empty()) {
    compare(in, r);
    check(in, drive_of(in, r.candidates.front()), "of the first drive of the list", r, trace);
  } else if (r.tried > 0.0) {
    check(in, nearest.drive, "of the drive that comes nearest: none passes", r, trace);
  }
  return r;
}

template VSizing::Result VSizing::evaluate(const Input&, NoTrace&);
template VSizing::Result VSizing::evaluate(const Input&, Trace&);

std::vector<draw::Figure> VSizing::figures(const Input&, const Result& r) {
  if (!is_set(r.d_1)) return {};
  return {drive_figure(r.d_1, r.d_2, r.a, Arrangement::open)};
}

}  // namespace loadpath::belt

template const loadpath::Calculator& loadpath::erased<loadpath::belt::VSizing>();
