#include "calculators/belt/v/search.hpp"

#include <algorithm>

namespace loadpath::belt {

using Input = VSizingTypes::Input;
using Result = VSizingTypes::Result;
using Candidate = VSizingTypes::Candidate;
using Rank = VSizingTypes::Rank;

namespace {

/// Contribution of one result field of belt.v; a check that is not available counts as a limit.
template <class F>
void take(const F& field, const V::Result& r, bool grip_asked, Shortfall& shortfall) {
  if constexpr (requires { field.asked_by; }) {
    const double value = in_si(r.*field.at) / in_si(field.unit.one);
    const bool asked = field.asked_by[0] == '\0' || grip_asked;
    if (field.role == Role::check && asked) {
      shortfall.check = std::max(shortfall.check, value);
      if (std::isnan(value)) ++shortfall.limits;
    }
    if (field.role == Role::limit && !field.bounds.holds(value)) ++shortfall.limits;
  }
}

Shortfall shortfall_of(const V::Result& r, bool grip_asked) {
  Shortfall shortfall;
  loadpath::apply([&](const auto&... field) { (take(field, r, grip_asked, shortfall), ...); }, V::results);
  return shortfall;
}

/// The better drive by the rank; of equals the smaller pulleys, then the smaller shaft load.
bool before(const Candidate& a, const Candidate& b, Rank rank) {
  const double x = measure_of(a, rank), y = measure_of(b, rank);
  if (x != y) return x < y;
  return a.V != b.V ? a.V < b.V : a.R_new < b.R_new;
}

/// Puts a drive in its place; the list keeps the best.
void rank_in(VSizingTypes::Candidates& list, const Candidate& c, Rank rank) {
  const auto at =
      std::find_if(list.begin(), list.end(), [&](const Candidate& other) { return before(c, other, rank); });
  if (at == list.end() && list.size() == VSizingTypes::Candidates::capacity()) return;
  const auto index = at - list.begin();
  if (list.size() == VSizingTypes::Candidates::capacity()) list.pop_back();
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

/// The drive as it is bought where more belts are needed than are allowed.
V::Input with_most_belts(const Input& in, V::Input drive) {
  drive.z = in.z_max;
  return drive;
}

void keep_nearest(const V::Input& drive, const Input& in, Nearest& nearest) {
  NoTrace quiet;
  const Shortfall shortfall = shortfall_of(V::evaluate(drive, quiet), is_set(in.mu));
  if (shortfall.less_than(nearest.shortfall)) nearest = {drive, shortfall};
}

void try_pair(const VSection& section, const Input& in, V::Input& drive, Result& r, Nearest& nearest) {
  drive.L = nearest_belt(section, in, drive);
  if (!is_set(drive.L)) return;
  r.tried += 1.0;
  NoTrace quiet;
  const V::Result found = V::evaluate(drive, quiet);
  const bool too_weak = found.z == 0 || found.z > in.z_max;
  if (!too_weak && shortfall_of(found, is_set(in.mu)).none()) {
    r.drives += 1.0;
    return rank_in(r.candidates, candidate_of(drive, found), in.rank);
  }
  (too_weak ? r.too_weak : r.outside) += 1.0;
  keep_nearest(too_weak ? with_most_belts(in, drive) : drive, in, nearest);
}

bool fits_room(const Input& in, const V::Input& drive) {
  return !(drive.d_1 < in.d_1_min) && !(max(drive.d_1, drive.d_2) > in.d_max);
}

}  // namespace

V::Input drive_of(const Input& in) {
  V::Input drive;
  drive.basis = in.basis, drive.section = in.section, drive.belt_class = in.belt_class;
  drive.P = in.P, drive.K_A = in.K_A, drive.duty = in.duty, drive.motor = in.motor, drive.h_day = in.h_day;
  drive.n_1 = in.n_1, drive.epsilon = in.epsilon, drive.mu = in.mu, drive.v_rim_adm = in.v_rim_adm;
  return drive;
}

double measure_of(const Candidate& c, Rank rank) {
  if (rank == Rank::shaft_load) return in_si(c.R_new);
  return rank == Rank::width ? in_si(c.B) : in_si(c.V);
}

void try_section(const VSection& section, const Input& in, Result& r, Nearest& nearest) {
  V::Input drive = drive_of(in);
  drive.section = section.name;
  NoTrace quiet;
  const double wanted_i = wanted_ratio(in, quiet), wanted_n = in_si(in.n_1) / wanted_i;
  const double i_w = wanted_i * (1.0 - in.epsilon);  // d_2 over d_1
  const auto pulleys = v_pulleys(in.basis);
  for (const Length& small : pulleys) {
    if (small < section.row.d_least || small > section.row.d_high) continue;
    const Length wanted = small * max(i_w, 1.0 / i_w);
    for (const Length& large : pulleys) {
      const bool reduces = i_w >= 1.0;
      drive.d_1 = reduces ? small : large, drive.d_2 = reduces ? large : small;
      const double i = in_si(drive.d_2 / drive.d_1) / (1.0 - in.epsilon);
      if (large < small || large > 2.0 * wanted) continue;
      if (share_off(in_si(in.n_1) / i, wanted_n) > in.tol_n || !fits_room(in, drive)) continue;
      try_pair(section, in, drive, r, nearest);
    }
  }
}

}  // namespace loadpath::belt
